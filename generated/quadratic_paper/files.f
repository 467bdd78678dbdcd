rtl/quadratic_paper.v
