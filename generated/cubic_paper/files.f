rtl/cubic_paper.v
