rtl/image_half.v
rtl/image_half_lights.v
