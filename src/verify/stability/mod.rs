//! How cores hold up where forms degenerate: shininesses at and near 1, 2 and 3 and very large ones, cosines at the
//! ends, the cusp and the cut, every level Q, coarse and fine formats.
//!
//! - [`inspect`]: one core over every input: no register overflows (proved, and checked against wide registers), the
//!   ends are exact, nothing is above 1, how far the result falls where it should rise, the largest seam;
//! - [`conditioning`]: the bits that the printed forms need, against those of the forms that are built;
//! - [`quantisation`]: what the input's own rounding costs, and what the versine saves of it;
//! - [`sampled`]: a shader or an image-based block, part by part: no register overflows;
//! - [`study`]: the cores that are inspected;
//! - [`document`]: the chapter and the tables.

pub mod conditioning;
pub mod document;
pub mod inspect;
pub mod quantisation;
pub mod sampled;
pub mod study;

/// Shininesses at which forms degenerate, their neighbours, and very large ones. At 1 the coefficients are 0/0 in the
/// limit, at 2 and 3 the cubic is the power itself.
pub const EXTREMES: [f64; 13] =
    [1.0, 1.000_001, 1.001, 1.5, 1.999, 2.0, 2.001, 2.999, 3.0, 3.001, 1000.0, 4096.0, 65536.0];
