//! The inner widths that the methods' formulas have in common, by their letters: the coefficients A, a and c, the
//! cosine x, the versine u, and v, that scaled or times n; what else one stands for in a method, its parameters say. A
//! width that one method alone has stands in its folder.

use crate::fixed::Width;

pub(crate) const BIG_A: Width = Width("A");
pub(crate) const SMALL_A: Width = Width("a");
pub(crate) const C: Width = Width("c");
pub(crate) const DEN: Width = Width("den");
pub(crate) const E: Width = Width("e");
pub(crate) const K: Width = Width("k");
pub(crate) const M: Width = Width("m");
pub(crate) const N: Width = Width("n");
pub(crate) const NUM: Width = Width("num");
pub(crate) const P: Width = Width("p");
pub(crate) const S: Width = Width("s");
pub(crate) const T: Width = Width("t");
pub(crate) const U: Width = Width("u");
pub(crate) const V: Width = Width("v");
pub(crate) const X: Width = Width("x");
pub(crate) const Z: Width = Width("z");
