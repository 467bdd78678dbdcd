//! What is computed for each row of the ROM.

use rayon::prelude::*;

use super::Interface;
use crate::platform::error::Error;

/// One value a row, in order; the rows are computed in parallel.
pub(super) fn each<T: Send>(
    interface: &Interface,
    of: impl Fn(f64) -> Result<T, Error> + Sync + Send,
) -> Result<Vec<T>, Error> {
    interface.shininess.knots().into_par_iter().map(of).collect()
}
