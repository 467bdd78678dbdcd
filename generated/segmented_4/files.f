rtl/segmented_4.v
