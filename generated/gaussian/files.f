rtl/gaussian.v
