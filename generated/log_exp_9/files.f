rtl/log_exp_9.v
rtl/log_exp_9_axis.v
