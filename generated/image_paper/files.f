rtl/image_paper.v
rtl/image_paper_lights.v
