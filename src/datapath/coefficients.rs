//! The real coefficients of each row of the ROM, by method and kind.

use rayon::prelude::*;

use crate::platform::error::Error;
use crate::fit::{self, Fit, Power};
use crate::lobe::{Cubic, CubicRational, MinZero, Quadratic};
use crate::spec::{Coefficients, CoreSpec, Method};

/// One value a row, in order; the rows are computed in parallel.
fn each<T: Send>(spec: &CoreSpec, of: impl Fn(f64) -> Result<T, Error> + Sync + Send) -> Result<Vec<T>, Error> {
    spec.shininess.knots().into_par_iter().map(of).collect()
}

fn fitted<T>(fit: Result<Fit<T>, Error>) -> Result<T, Error> {
    fit.map(|fit| fit.coefficients)
}

/// a of the quadratic.
pub(super) fn quadratic(spec: &CoreSpec) -> Result<Vec<Quadratic>, Error> {
    each(spec, |n| match spec.coefficients {
        Coefficients::Paper => Quadratic::new(n),
        Coefficients::Minimax => fitted(fit::quadratic(n, &spec.objective)),
    })
}

/// A and a of the cubic and of the three-point cubic.
pub(super) fn cubic(spec: &CoreSpec) -> Result<Vec<Cubic>, Error> {
    each(spec, |n| match spec.coefficients {
        Coefficients::Paper if spec.method == Method::CubicThreePoint => Cubic::three_point(n, spec.q, spec.g),
        Coefficients::Paper => Cubic::new(n, spec.q),
        Coefficients::Minimax => fitted(fit::cubic(n, spec.tail, &spec.objective)),
    })
}

/// The cubic and its rational tail.
pub(super) fn cubic_rational(spec: &CoreSpec) -> Result<Vec<CubicRational>, Error> {
    each(spec, |n| match spec.coefficients {
        Coefficients::Paper => CubicRational::new(n, spec.q),
        Coefficients::Minimax => fitted(fit::cubic_rational(n, &spec.objective)),
    })
}

/// A and a of the inside `1 - u (A - a u)` of a method that ends in a power.
pub(super) fn inside(spec: &CoreSpec) -> Result<Vec<Power>, Error> {
    let linear = |big_a: f64| Power { big_a, a: 0.0 };
    each(spec, |n| match (spec.method, spec.method.power()) {
        (Method::CubicMinZero, _) if spec.coefficients == Coefficients::Paper => Ok(linear(MinZero::new(n, spec.q)?.k)),
        (Method::CubicMinZero, _) => fitted(fit::min_zero(n, &spec.objective)).map(linear),
        (Method::Lyon2 | Method::Lyon4 | Method::Lyon8, Some(k)) => Ok(linear(n / f64::from(k))),
        (_, k) => fitted(fit::power(n, k.unwrap_or(2), spec.inside, &spec.objective)),
    })
}
