rtl/cubic_rational.v
