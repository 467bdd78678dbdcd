rtl/power_4.v
