//! Which inputs become vectors.

use rand_core::Rng;
use rand_pcg::Pcg64;

use super::Vector;
use crate::design::Design;
use crate::lobe::Lobe;
use crate::number::exp2;

/// Rows beyond which not every row has vectors of its own.
const MOST_ROWS: usize = 1024;
/// Random vectors of each of the two kinds.
const RANDOM: usize = 512;
/// The seed of everything random here: fixed, so that the vectors are the same on every machine.
const SEED: u128 = 0x6272_6466_6765_6e00;

struct Chooser<'a> {
    design: &'a Design,
    lobes: Vec<Box<dyn Lobe>>,
    random: Pcg64,
    one: i64,
}

/// The vectors of a design, in groups with a heading.
pub(super) fn vectors(design: &Design) -> Vec<(String, Vec<Vector>)> {
    let mut chooser = Chooser {
        design,
        lobes: design.spec.lobes(),
        random: Pcg64::new(SEED, 0),
        one: 1 << design.spec.input_fraction,
    };
    let mut groups = vec![
        ("corners of the port codes".to_owned(), chooser.port_corners()),
        ("corners of the lobe: 0, 1, the cusp, where it ends, each with its neighbours".to_owned(), chooser.corners()),
        ("codes of in_n, all or evenly spaced, at the cusp".to_owned(), chooser.indices()),
    ];
    for field in 0..design.table().fields.len() {
        let heading = format!("rows told from rows with the last bit of {} flipped", design.table().fields[field].name);
        groups.push((heading, chooser.sensitive(field)));
    }
    groups.push(("random, all codes".to_owned(), chooser.random_codes()));
    groups.push(("random, on the highlight".to_owned(), chooser.random_highlight()));
    groups
}

impl Chooser<'_> {
    fn below(&mut self, bound: u64) -> u64 {
        // The high product half: even to 2^-40 for the small bounds here.
        ((u128::from(self.random.next_u64()) * u128::from(bound)) >> 64) as u64
    }

    fn vector(&mut self, index: u32, operand: i64) -> Vector {
        let mut pause = |chance: u64| if self.below(chance) == 0 { 1 + self.below(3) as u32 } else { 0 };
        let (idle, stall) = (pause(12), pause(12));
        Vector { index, operand, output: self.design.model().evaluate(index, operand), idle, stall }
    }

    /// A few rows that matter: the first and last, small ones, powers of two and their neighbours.
    fn marked_rows(&self) -> Vec<usize> {
        let rows = self.design.table().rows();
        let mut marked: Vec<usize> = (0..rows.min(4)).chain(rows.saturating_sub(2)..rows).collect();
        for power in 2..17u32 {
            for near in [-1i64, 0, 1] {
                let row = (1i64 << power) + near - 1;
                marked.extend(usize::try_from(row).ok().filter(|&row| row < rows));
            }
        }
        marked.sort_unstable();
        marked.dedup();
        marked
    }

    fn port_corners(&mut self) -> Vec<Vector> {
        let design = self.design;
        let (first, count) = super::all_codes(design.operand_format());
        let last = first + count as i64 - 1;
        let mut operands = vec![first, first + 1, -2, -1, 0, 1, self.one - 1, self.one, self.one + 1, last - 1, last];
        operands.extend([first / 2, last / 2, -self.one, self.one / 2, -self.one / 2]);
        operands.retain(|code| (first..=last).contains(code));
        operands.sort_unstable();
        operands.dedup();
        let last_index = (1u64 << design.index_format().width()) as u32 - 1;
        let rows = design.table().rows();
        let set = &design.spec.shininess;
        let mut indices = vec![0, 1.min(last_index), set.index_of_row(0), set.index_of_row(rows / 2)];
        indices.extend([set.index_of_row(rows - 1), last_index]);
        indices.sort_unstable();
        indices.dedup();
        let pairs = indices.iter().flat_map(|&index| operands.iter().map(move |&operand| (index, operand)));
        pairs.collect::<Vec<_>>().into_iter().map(|(index, operand)| self.vector(index, operand)).collect()
    }

    /// Versine codes around a real versine, kept inside [0, 1].
    fn around(&self, u: f64) -> impl Iterator<Item = i64> + use<> {
        let (centre, one) = ((u * self.one as f64) as i64, self.one);
        (centre - 1..=centre + 2).filter(move |code| (0..=one).contains(code))
    }

    /// The first versine code at which the real lobe of a row is 0, by bisection: it never rises again from there.
    fn end(&self, row: usize) -> i64 {
        let lobe = &self.lobes[row];
        let (mut low, mut high) = (0, self.one);
        while high - low > 1 {
            let middle = (low + high) / 2;
            if lobe.at(middle as f64 / self.one as f64) > 0.0 { low = middle } else { high = middle }
        }
        high
    }

    fn corners(&mut self) -> Vec<Vector> {
        let mut result = Vec::new();
        for row in self.marked_rows() {
            let n = self.design.table().shininess[row];
            let cusp = -libm::expm1(-std::f64::consts::LN_2 / n);
            let mut codes: Vec<i64> = [0, 1, 2, self.one - 1, self.one].into();
            codes.extend(self.around(cusp));
            codes.extend(self.around(self.end(row) as f64 / self.one as f64));
            // The powers of two at which a scaled versine changes its leading bit.
            for shift in 1..=self.design.spec.input_fraction as i32 {
                codes.extend(self.around(exp2(-shift)).filter(|_| exp2(-shift) * n < 8.0 && exp2(-shift) * n > 0.5));
            }
            codes.sort_unstable();
            codes.dedup();
            let index = self.design.spec.shininess.index_of_row(row);
            for code in codes {
                result.push(self.vector(index, self.design.operand_of_versine(code)));
            }
        }
        result
    }

    /// Every code of `in_n`, those outside the set included (evenly spaced ones where there are many).
    fn indices(&mut self) -> Vec<Vector> {
        let design = self.design;
        let count = 1usize << design.index_format().width();
        let step = count.div_ceil(MOST_ROWS);
        let indices = (0..count).step_by(step).map(|index| index as u32);
        indices
            .map(|index| {
                let n = design.table().shininess[design.spec.shininess.row_of_index(index)];
                let cusp = -libm::expm1(-std::f64::consts::LN_2 / n);
                self.vector(index, design.operand_of_versine((cusp * self.one as f64) as i64))
            })
            .collect()
    }

    /// For each row an input at which flipping the last bit of a field changes the output, if a search finds one.
    fn sensitive(&mut self, field: usize) -> Vec<Vector> {
        let design = self.design;
        let mut flipped = design.table().clone();
        for code in &mut flipped.fields[field].codes {
            *code ^= 1;
        }
        let rows = design.table().rows();
        let mut result = Vec::new();
        for row in (0..rows).step_by(rows.div_ceil(MOST_ROWS)) {
            let index = design.spec.shininess.index_of_row(row);
            let end = self.end(row);
            // From the end of the lobe inwards, where a coefficient weighs most, then anywhere on it.
            let near = (0..24).map(|step| end + 1 - step);
            let mut anywhere: Vec<i64> = (0..104).map(|_| self.below(end as u64 + 1) as i64).collect();
            anywhere.splice(0..0, near);
            let changes = |code: &i64| {
                let operand = design.operand_of_versine(*code);
                design.model().evaluate(index, operand) != design.model_with(&flipped).evaluate(index, operand)
            };
            let inside = anywhere.into_iter().filter(|code| (0..=self.one).contains(code));
            if let Some(code) = inside.into_iter().find(changes) {
                result.push(self.vector(index, design.operand_of_versine(code)));
            }
        }
        result
    }

    fn random_codes(&mut self) -> Vec<Vector> {
        let (first, count) = super::all_codes(self.design.operand_format());
        let indices = 1u64 << self.design.index_format().width();
        (0..RANDOM)
            .map(|_| {
                let (index, operand) = (self.below(indices) as u32, first + self.below(count) as i64);
                self.vector(index, operand)
            })
            .collect()
    }

    fn random_highlight(&mut self) -> Vec<Vector> {
        let design = self.design;
        let rows = design.table().rows() as u64;
        (0..RANDOM)
            .map(|_| {
                let row = self.below(rows) as usize;
                let widest = (3.0 / design.table().shininess[row]).min(1.0) * self.one as f64;
                let code = self.below(widest as u64 + 1) as i64;
                self.vector(design.spec.shininess.index_of_row(row), design.operand_of_versine(code))
            })
            .collect()
    }
}
