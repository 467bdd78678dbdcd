rtl/schlick.v
