rtl/image_bivariate.v
