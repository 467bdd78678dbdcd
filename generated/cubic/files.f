rtl/cubic.v
