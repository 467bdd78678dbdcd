//! The descent to the least largest error.
//!
//! At the coefficients p, the largest error is the maximum of the error's local extrema. Each is a smooth function of
//! p, so in a box around p the best step is a linear program in D + 1 unknowns (the step and the largest error), with a
//! few constraints, one for each extremum. The step is taken if it does good, and the box adapts to how well the linear
//! model foretold the outcome. Where D + 1 extrema are equal at the optimum, this is Newton's method on the levelled
//! system.

use super::target::{Sample, Target};

/// The most pieces that a shape falls into.
const MAX_PIECES: usize = 3;

/// What a shape is on a stretch of the versine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Piece {
    /// The shape's formula.
    Formula,
    /// One value throughout.
    Constant(f64),
}

/// The smooth pieces of a shape over the versine, from 0 on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pieces {
    /// Each piece and the versine where it ends; the last one has no end.
    list: [(Piece, f64); MAX_PIECES],
    count: usize,
}

impl Pieces {
    /// One piece everywhere.
    pub fn one(piece: Piece) -> Self {
        Self { list: [(piece, f64::INFINITY); MAX_PIECES], count: 1 }
    }

    /// Ends the last piece at `u` and goes on with another.
    pub fn then(mut self, u: f64, piece: Piece) -> Self {
        self.list[self.count - 1].1 = u;
        self.list[self.count] = (piece, f64::INFINITY);
        self.count += 1;
        self
    }

    fn piece_at(&self, u: f64) -> Piece {
        let index = self.list[..self.count - 1].iter().position(|&(_, end)| u <= end);
        self.list[index.unwrap_or(self.count - 1)].0
    }
}

/// A lobe with D coefficients to be found, scaled so that a change by 1 is a large change of the lobe.
pub(super) trait Shape<const D: usize> {
    /// Where the lobe follows which rule.
    fn pieces(&self, p: &[f64; D]) -> Pieces;
    /// The value of [`Piece::Formula`].
    fn formula(&self, p: &[f64; D], u: f64) -> f64;

    /// The value of a piece.
    fn value(&self, p: &[f64; D], piece: Piece, u: f64) -> f64 {
        match piece {
            Piece::Formula => self.formula(p, u),
            Piece::Constant(value) => value,
        }
    }
}

/// Coefficients and the largest weighted error that they have.
pub(super) struct Best<const D: usize> {
    pub p: [f64; D],
    pub error: f64,
}

/// The largest weighted error of a shape, by its local extrema.
pub(super) fn largest_error<const D: usize>(shape: &impl Shape<D>, target: &Target, p: &[f64; D]) -> f64 {
    Curve::of(shape, target, p).largest
}

/// Descends from the best few of the starts; the best end wins.
pub(super) fn minimise<const D: usize>(
    shape: &impl Shape<D>,
    target: &Target,
    starts: impl Iterator<Item = [f64; D]>,
    descents: usize,
) -> Best<D> {
    let mut ranked: Vec<(f64, [f64; D])> = starts.map(|p| (rough_error(shape, target, &p), p)).collect();
    ranked.sort_by(|left, right| left.0.total_cmp(&right.0));
    let ends = ranked[..descents.min(ranked.len())].iter().map(|&(_, p)| descend(shape, target, p));
    ends.min_by(|left, right| left.error.total_cmp(&right.error)).expect("there is a start")
}

/// The largest weighted error at every fourth sample and at the breaks: good enough to rank starts.
fn rough_error<const D: usize>(shape: &impl Shape<D>, target: &Target, p: &[f64; D]) -> f64 {
    let pieces = shape.pieces(p);
    let mut largest = 0.0_f64;
    for sample in target.samples.iter().step_by(4).chain(target.samples.last()) {
        largest = largest.max(weighted(shape.value(p, pieces.piece_at(sample.u), sample.u), sample).abs());
    }
    let (low, high) = target.ends();
    for pair in pieces.list[..pieces.count].windows(2) {
        let at = pair[0].1;
        if low < at && at < high {
            let sample = target.at(at);
            for (piece, _) in pair {
                largest = largest.max(weighted(shape.value(p, *piece, at), &sample).abs());
            }
        }
    }
    largest
}

fn weighted(value: f64, sample: &Sample) -> f64 {
    (value - sample.exact) * sample.weight
}

/// Half the distance of the two points of a difference quotient: both its errors, of the order h² and 2^-53 / h, stay
/// below 1e-9.
const DIFFERENCE: f64 = 1e-6;

fn descend<const D: usize>(shape: &impl Shape<D>, target: &Target, start: [f64; D]) -> Best<D> {
    let mut p = start;
    let mut curve = Curve::of(shape, target, &p);
    let mut extrema = curve.extrema(shape, target, &p);
    let mut radius = 0.1;
    for _ in 0..80 {
        // Below this, an error is rounding noise of the exact lobe.
        if curve.largest < 1e-14 {
            break;
        }
        let (step, foretold) = linear_minimax(&extrema, curve.largest, radius);
        let hoped = curve.largest - foretold;
        let length = step.iter().fold(0.0_f64, |longest, part| longest.max(part.abs()));
        if hoped <= 1e-9 * curve.largest || length < 1e-14 {
            break;
        }
        let mut trial = p;
        for (coefficient, part) in trial.iter_mut().zip(step) {
            *coefficient += part;
        }
        let there = Curve::of(shape, target, &trial);
        let gain = (curve.largest - there.largest) / hoped;
        if gain < 0.25 {
            radius = 0.25 * length;
        } else if gain > 0.75 {
            radius = radius.max(2.0 * length);
        }
        if gain > 0.0 {
            (p, curve) = (trial, there);
            extrema = curve.extrema(shape, target, &p);
        }
    }
    Best { p, error: curve.largest }
}

/// A local extremum of the weighted error as a function of the coefficients.
struct Extremum<const D: usize> {
    /// Its size.
    error: f64,
    /// How its size changes with each coefficient.
    slope: [f64; D],
}

/// The weighted error over the versine: its local extrema, and all ends of its pieces.
struct Curve {
    pieces: Pieces,
    tops: Vec<(Point, Place)>,
    largest: f64,
}

/// A point of the error curve within one piece.
#[derive(Clone, Copy)]
struct Point {
    u: f64,
    error: f64,
}

/// Where an extremum lies.
#[derive(Clone, Copy)]
enum Place {
    /// At a versine that does not move with the coefficients, or at which the error curve is level.
    At(f64),
    /// Where the piece number `end` ends, on the side of the given piece, which is that one or the next.
    Break { end: usize, piece: usize },
}

impl Curve {
    fn of<const D: usize>(shape: &impl Shape<D>, target: &Target, p: &[f64; D]) -> Self {
        let pieces = shape.pieces(p);
        let (low, high) = target.ends();
        let mut tops: Vec<(Point, Place)> = Vec::with_capacity(16);
        let mut curve: Vec<Point> = Vec::with_capacity(target.samples.len() + 2);
        let mut samples = target.samples.iter().peekable();
        let mut from = Place::At(low);
        for (index, &(piece, end)) in pieces.list[..pieces.count].iter().enumerate() {
            if end <= low {
                continue;
            }
            let point =
                |sample: &Sample| Point { u: sample.u, error: weighted(shape.value(p, piece, sample.u), sample) };
            let breaks = end < high;
            let to = if breaks { Place::Break { end: index, piece: index } } else { Place::At(high) };
            curve.clear();
            // A top may lie between a break and the nearest sample: two more points in each such gap show it.
            if let Place::Break { end: start, .. } = from {
                let start = pieces.list[start].1;
                let gap = samples.peek().map_or(high, |sample| sample.u).min(end) - start;
                curve.extend([0.0, 0.02, 0.5].map(|part| point(&target.at(start + part * gap))));
            }
            while let Some(sample) = samples.next_if(|sample| sample.u <= end) {
                curve.push(point(sample));
            }
            if breaks {
                let gap = end - curve.last().map_or(low, |last| last.u);
                curve.extend([0.5, 0.02, 0.0].map(|part| point(&target.at(end - part * gap))));
            }
            tops.push((curve[0], from));
            tops.push((curve[curve.len() - 1], to));
            for three in curve.windows(3) {
                let sign = 1.0_f64.copysign(three[1].error);
                let [left, middle, right] = [sign * three[0].error, sign * three[1].error, sign * three[2].error];
                if left <= middle && right <= middle && middle > 0.0 {
                    let top = refine([three[0], three[1], three[2]], sign, |u| point(&target.at(u)));
                    tops.push((top, Place::At(top.u)));
                }
            }
            if !breaks {
                break;
            }
            from = Place::Break { end: index, piece: index + 1 };
        }
        let largest = tops.iter().fold(0.0_f64, |largest, (point, _)| largest.max(point.error.abs()));
        Self { pieces, tops, largest }
    }

    /// The extrema with their slopes: differences between neighbours of p, in which a break may lie elsewhere.
    fn extrema<const D: usize>(&self, shape: &impl Shape<D>, target: &Target, p: &[f64; D]) -> Vec<Extremum<D>> {
        let (low, high) = target.ends();
        let neighbours: [[([f64; D], Pieces); 2]; D] = std::array::from_fn(|i| {
            [DIFFERENCE, -DIFFERENCE].map(|shift| {
                let mut beside = *p;
                beside[i] += shift;
                (beside, shape.pieces(&beside))
            })
        });
        let value = |point: &Point, place: Place, (beside, around): &([f64; D], Pieces)| match place {
            Place::Break { end, piece } if around.count == self.pieces.count => {
                let at = around.list[end].1.clamp(low, high);
                weighted(shape.value(beside, around.list[piece].0, at), &target.at(at))
            }
            Place::Break { piece, .. } => {
                weighted(shape.value(beside, self.pieces.list[piece].0, point.u), &target.at(point.u))
            }
            Place::At(u) => weighted(shape.value(beside, around.piece_at(u), u), &target.at(u)),
        };
        let extremum = |&(point, place): &(Point, Place)| {
            let sign = 1.0_f64.copysign(point.error);
            let slope = neighbours.each_ref().map(|[ahead, behind]| {
                sign * (value(&point, place, ahead) - value(&point, place, behind)) / (2.0 * DIFFERENCE)
            });
            Extremum { error: point.error.abs(), slope }
        };
        self.tops.iter().map(extremum).collect()
    }
}

/// The top of a hill of `sign * error` between the outer two of three points, by parabolas through the best three.
fn refine(mut three: [Point; 3], sign: f64, curve: impl Fn(f64) -> Point) -> Point {
    for _ in 0..10 {
        let [left, middle, right] = three;
        let (before, after) = (middle.u - left.u, right.u - middle.u);
        let rise = sign * (middle.error - left.error) * after;
        let fall = sign * (middle.error - right.error) * before;
        // The vertex, from the middle; both differences are at least 0.
        let shift = 0.5 * (rise * after - fall * before) / (rise + fall);
        if shift.is_nan() || shift.abs() <= 1e-9 * (before + after) {
            break;
        }
        let top = curve((middle.u + shift).clamp(left.u, right.u));
        let gain = sign * (top.error - middle.error);
        three = match (shift > 0.0, gain > 0.0) {
            (true, true) => [middle, top, right],
            (true, false) => [left, middle, top],
            (false, true) => [left, top, middle],
            (false, false) => [top, middle, right],
        };
        if gain.abs() < 1e-8 * middle.error.abs() {
            break;
        }
    }
    three[1]
}

/// The step within a box that makes the largest of linear functions least, and that least value.
///
/// It is the linear program: minimise t with `error_j + slope_j · step <= t` and `|step_i| <= radius`. Its dual has D +
/// 1 equations: multipliers `λ_j >= 0` of the extrema add up to 1, and `Σ λ_j slope_j` is balanced by the multipliers
/// of the box. The simplex method on the dual starts from the largest extremum alone, which is always admissible, and
/// takes in the most violated constraint each time: Stiefel's exchange. All errors are divided by `unit` first.
fn linear_minimax<const D: usize>(extrema: &[Extremum<D>], unit: f64, radius: f64) -> ([f64; D], f64) {
    // Columns: the extrema, then for each coefficient the two walls of the box.
    let column = |j: usize| -> (Vector, f64) {
        let mut entries = [0.0; ROWS];
        if j < extrema.len() {
            for (entry, slope) in entries.iter_mut().zip(extrema[j].slope) {
                *entry = slope / unit;
            }
            entries[D] = 1.0;
            (entries, extrema[j].error / unit)
        } else {
            let wall = j - extrema.len();
            entries[wall / 2] = if wall.is_multiple_of(2) { 1.0 } else { -1.0 };
            (entries, -radius)
        }
    };
    let columns: Vec<(Vector, f64)> = (0..extrema.len() + 2 * D).map(column).collect();
    let largest = (0..extrema.len())
        .max_by(|&left, &right| extrema[left].error.total_cmp(&extrema[right].error))
        .expect("an error curve has extrema");
    let mut basis = [0; ROWS];
    for (i, slot) in basis[..D].iter_mut().enumerate() {
        *slot = extrema.len() + 2 * i + usize::from(extrema[largest].slope[i] > 0.0);
    }
    basis[D] = largest;
    let mut answer = ([0.0; D], unit);
    let mut right_side = [0.0; ROWS];
    right_side[D] = 1.0;
    for _ in 0..100 {
        let matrix: [Vector; ROWS] = std::array::from_fn(|k| columns[basis[k]].0);
        let costs: Vector = std::array::from_fn(|k| columns[basis[k]].1);
        // `matrix` holds the basic columns as rows: it is the transpose of the basis matrix.
        let Some(y) = solve(matrix, costs, D + 1) else { break };
        answer = (std::array::from_fn(|i| (-y[i]).clamp(-radius, radius)), y[D] * unit);
        let violation = |(entries, cost): &(Vector, f64)| {
            cost - entries[..=D].iter().zip(&y).map(|(entry, y)| entry * y).sum::<f64>()
        };
        let (entering, worst) = columns
            .iter()
            .map(violation)
            .enumerate()
            .max_by(|left, right| left.1.total_cmp(&right.1))
            .expect("there are columns");
        if worst <= 1e-12 {
            break;
        }
        let transposed: [Vector; ROWS] = std::array::from_fn(|row| std::array::from_fn(|k| matrix[k][row]));
        let (Some(level), Some(change)) =
            (solve(transposed, right_side, D + 1), solve(transposed, columns[entering].0, D + 1))
        else {
            break;
        };
        let leaving = (0..=D)
            .filter(|&k| change[k] > 1e-13)
            .min_by(|&left, &right| (level[left] / change[left]).total_cmp(&(level[right] / change[right])));
        let Some(leaving) = leaving else { break };
        basis[leaving] = entering;
    }
    answer
}

/// The most equations of the dual: three coefficients and the sum of the multipliers.
const ROWS: usize = 4;
type Vector = [f64; ROWS];

/// Solves `size` equations by elimination with row exchange; none if they are singular.
fn solve(mut matrix: [Vector; ROWS], mut right: Vector, size: usize) -> Option<Vector> {
    for k in 0..size {
        let pivot = (k..size).max_by(|&i, &j| matrix[i][k].abs().total_cmp(&matrix[j][k].abs()))?;
        if matrix[pivot][k].abs() < 1e-200 {
            return None;
        }
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        let row = matrix[k];
        for i in k + 1..size {
            let factor = matrix[i][k] / row[k];
            for (entry, above) in matrix[i].iter_mut().zip(row) {
                *entry -= factor * above;
            }
            right[i] -= factor * right[k];
        }
    }
    for k in (0..size).rev() {
        for j in k + 1..size {
            right[k] -= matrix[k][j] * right[j];
        }
        right[k] /= matrix[k][k];
    }
    Some(right)
}
