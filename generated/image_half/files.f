rtl/image_half.v
