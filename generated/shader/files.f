rtl/shader.v
rtl/shader_axis.v
