//! C99 for programs that use a core: freestanding, without floating point.

mod light;

pub use light::LightFunction;
