rtl/squaring.v
