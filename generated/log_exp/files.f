rtl/log_exp.v
