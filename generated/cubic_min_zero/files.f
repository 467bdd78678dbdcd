rtl/cubic_min_zero.v
