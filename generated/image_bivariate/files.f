rtl/image_bivariate.v
rtl/image_bivariate_lights.v
