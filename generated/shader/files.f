rtl/shader.v
