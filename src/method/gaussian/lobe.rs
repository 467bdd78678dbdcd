//! The spherical Gaussian.

use crate::lobe::{Lobe, check_shininess};
use crate::platform::error::Error;

/// `e^(-n u)`; 0 at x = 0, where a surface faces away.
///
/// It is the limit of Lyon's `(1 - n u/k)^k`. As `ln x = -u - u^2/2 - ...`, it lies above x^n, by `n u^2/2 e^(-n u)` in
/// the main, which is largest at `u = 2/n`: `2 e^-2/n`, 0.27/n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaussian {
    /// The shininess.
    pub n: f64,
}

impl Gaussian {
    /// The lobe for the shininess `n`.
    ///
    /// # Errors
    /// See [`check_shininess`].
    pub fn new(n: f64) -> Result<Self, Error> {
        check_shininess(n)?;
        Ok(Self { n })
    }
}

impl Lobe for Gaussian {
    fn at(&self, u: f64) -> f64 {
        if u >= 1.0 { 0.0 } else { libm::exp(-self.n * u) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lobe::exact;

    #[test]
    fn it_is_off_from_the_power_by_less_than_two_over_e_squared_n() {
        for n in [10.0, 100.0, 1000.0, 65536.0] {
            let lobe = Gaussian::new(n).unwrap();
            let off = |u: f64| lobe.at(u) - exact(n, u);
            let most = (1..4000).map(|i| off(f64::from(i) / (100.0 * n)).abs()).fold(0.0, f64::max);
            let expected = 2.0 * libm::exp(-2.0) / n;
            assert!((0.97 * expected..1.2 * expected).contains(&most), "n = {n}: {most} where {expected} is expected");
        }
        assert!(Gaussian::new(0.5).is_err());
    }
}
