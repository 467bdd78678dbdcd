//! What is computed for each row of the ROM.

use rayon::prelude::*;

use super::{Interface, Source};
use crate::fit::{Fit, Objective};
use crate::platform::error::Error;

/// One value a row, in order; the rows are computed in parallel.
pub(super) fn each<T: Send>(
    interface: &Interface,
    of: impl Fn(f64) -> Result<T, Error> + Sync + Send,
) -> Result<Vec<T>, Error> {
    interface.shininess.knots().into_par_iter().map(of).collect()
}

impl Source {
    /// The lobe of each row, by the papers' closed form or by a fit.
    pub(super) fn rows<T: Send>(
        self,
        interface: &Interface,
        paper: impl Fn(f64) -> Result<T, Error> + Sync + Send,
        fitted: impl Fn(f64, &Objective) -> Result<Fit<T>, Error> + Sync + Send,
    ) -> Result<Vec<T>, Error> {
        each(interface, |n| match self {
            Self::Paper => paper(n),
            Self::Fitted(objective) => fitted(n, &objective).map(|fit| fit.coefficients),
        })
    }
}
