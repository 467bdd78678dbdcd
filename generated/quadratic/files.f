rtl/quadratic.v
