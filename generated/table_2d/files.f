rtl/table_2d.v
