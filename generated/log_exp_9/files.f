rtl/log_exp_9.v
