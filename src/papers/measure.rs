//! Largest values and errors over an interval of versines.

use super::method::Pieces;
use crate::lobe::exact;

/// Grid points for each smooth piece.
const POINTS: usize = 256;
/// Golden-section steps: they shrink two grid steps below the width at which a smooth maximum is flat to rounding.
const STEPS: usize = 40;

/// The versine where x^n has the value `level`, in (0, 1].
pub fn versine_at(n: f64, level: f64) -> f64 {
    -libm::expm1(libm::log(level) / n)
}

/// The largest value of `f` for versines in `from..=to`; `f` is smooth but for a step or bend after `break_at`.
///
/// The grid is even in `ln(1 + n u)`: as `s = n u` where the lobe lives, coarser and coarser in its tail. Each grid
/// point that its neighbours do not exceed is refined by a golden section if it is near the largest; ends count as they
/// are.
pub fn largest(n: f64, (from, to): (f64, f64), break_at: Option<f64>, f: impl Fn(f64) -> f64) -> f64 {
    match break_at {
        Some(at) if from <= at && at < to => piece(n, from, at, &f).max(piece(n, at.next_up(), to, &f)),
        _ => piece(n, from, to, &f),
    }
}

/// The grid of [`largest`] from `from` to `to`, both included.
pub fn grid(n: f64, from: f64, to: f64) -> Vec<f64> {
    let (first, last) = (libm::log1p(n * from), libm::log1p(n * to));
    let inner = |i: usize| libm::expm1(first + (last - first) * (i as f64 / (POINTS - 1) as f64)) / n;
    (0..POINTS)
        .map(|i| {
            if i == 0 {
                from
            } else if i == POINTS - 1 {
                to
            } else {
                inner(i).clamp(from, to)
            }
        })
        .collect()
}

fn piece(n: f64, from: f64, to: f64, f: &impl Fn(f64) -> f64) -> f64 {
    let grid = grid(n, from, to);
    let values: Vec<f64> = grid.iter().map(|&u| f(u)).collect();
    let mut best = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let near = best - 0.1 * best.abs();
    for i in 1..POINTS - 1 {
        if values[i] >= near && values[i] >= values[i - 1] && values[i] >= values[i + 1] {
            best = best.max(golden_section(grid[i - 1], grid[i + 1], f));
        }
    }
    best
}

fn golden_section(mut low: f64, mut high: f64, f: &impl Fn(f64) -> f64) -> f64 {
    // (sqrt 5 - 1) / 2.
    const RATIO: f64 = 0.618_033_988_749_894_8;
    let (mut left, mut right) = (high - RATIO * (high - low), low + RATIO * (high - low));
    let (mut at_left, mut at_right) = (f(left), f(right));
    for _ in 0..STEPS {
        if at_left < at_right {
            (low, left, at_left) = (left, right, at_right);
            right = low + RATIO * (high - low);
            at_right = f(right);
        } else {
            (high, right, at_right) = (right, left, at_left);
            left = high - RATIO * (high - low);
            at_left = f(left);
        }
    }
    at_left.max(at_right)
}

impl Pieces {
    /// The largest absolute error where x^n lies between two levels, the higher one first.
    #[must_use]
    pub fn absolute(&self, high: f64, low: f64) -> f64 {
        largest(self.n, self.versines(high, low), self.break_at, |u| (self.lobe.at(u) - exact(self.n, u)).abs())
    }

    /// The largest error relative to x^n where x^n lies between two levels, the higher one first; the lower is above 0.
    #[must_use]
    pub fn relative(&self, high: f64, low: f64) -> f64 {
        largest(self.n, self.versines(high, low), self.break_at, |u| (self.lobe.at(u) / exact(self.n, u) - 1.0).abs())
    }

    fn versines(&self, high: f64, low: f64) -> (f64, f64) {
        (versine_at(self.n, high), if low > 0.0 { versine_at(self.n, low) } else { 1.0 })
    }
}

/// Whether `f` rises with the versine anywhere in `from..=to`, by more than rounding.
pub fn rises(n: f64, (from, to): (f64, f64), f: impl Fn(f64) -> f64) -> bool {
    let values: Vec<f64> = grid(n, from, to).into_iter().map(f).collect();
    values.windows(2).any(|pair| pair[1] - pair[0] > 1e-12 * pair[0].abs().max(1.0))
}

#[cfg(test)]
mod tests {
    use super::super::method::PaperMethod;
    use super::*;

    /// Every extreme against a grid two hundred times as dense, over levels that hold steps, bends and ends.
    #[test]
    fn extremes_are_those_of_a_dense_grid() {
        for method in PaperMethod::ALL {
            for n in [1.0, 2.0, 5.0, 25.0, 256.0, 1000.0] {
                let pieces = method.lobe(n).unwrap();
                for (high, low) in [(1.0, 0.5), (1.0, 0.0), (0.5, 0.0), (0.42, 0.37)] {
                    let (from, to) = pieces.versines(high, low);
                    let steps = 50_000;
                    let dense = (0..=steps)
                        .map(|i| from + (to - from) * libm::pow(f64::from(i) / f64::from(steps), 2.0))
                        .map(|u| (pieces.lobe.at(u) - exact(n, u)).abs())
                        .fold(0.0, f64::max);
                    let got = pieces.absolute(high, low);
                    let context = format!("{} n = {n} from {high} to {low}: {got} for {dense}", method.name());
                    // The dense grid misses the step at a cut by up to its own step.
                    assert!(got >= dense * (1.0 - 1e-12) - 1e-15, "{context}");
                    assert!(got <= dense * (1.0 + 2e-3) + 1e-12, "{context}");
                }
            }
        }
    }

    #[test]
    fn extremes_at_known_places() {
        // x^n against 0: the largest value is the level itself, at an end.
        assert!((largest(10.0, (versine_at(10.0, 0.3), 1.0), None, |u| exact(10.0, u)) - 0.3).abs() < 1e-15);
        // s e^-s has its maximum 1/e inside, at s = 1.
        let got = largest(1000.0, (0.0, 1.0), None, |u| 1000.0 * u * libm::exp(-1000.0 * u));
        assert!((got - libm::exp(-1.0)).abs() < 1e-15, "{got}");
        // A step: the value just after it counts.
        let step = |u: f64| if u <= 0.25 { 0.0 } else { 1.0 - u };
        assert_eq!(largest(1.0, (0.0, 1.0), Some(0.25), step), 1.0 - 0.25f64.next_up());
        assert!(rises(1.0, (0.0, 1.0), step) && !rises(1.0, (0.0, 0.25), step));
    }
}
