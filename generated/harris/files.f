rtl/harris.v
