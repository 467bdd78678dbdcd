//! The ports of a lobe in its graph: what is known of their codes, and how they are clamped to the domain.

use super::{InputRange, Interface, Operand, Shininess};
use crate::datapath::builder::{Bound, Builder, HighBits};
use crate::datapath::graph::{NodeId, Op};
use crate::fixed::{Format, Interval};

impl Builder<'_> {
    /// The operand's port, clamped to the domain: the cosine x and the versine u, both `UQ1.F`, u in each case's active
    /// interval. Returns `(x, u)`. The port `in_n` comes before it: see [`Builder::address`].
    pub fn operand(&mut self, interface: &Interface) -> (NodeId, NodeId) {
        let f = interface.input_fraction as i32;
        let one = 1i128 << f;
        let unit = Format::unsigned(1, f);
        let exact = |range: Interval| Bound { range, error: Interval::ZERO, grid: f };
        let versine: Vec<Bound> = self.cases.iter().map(|case| exact(case.active)).collect();
        let cosine: Vec<Bound> =
            self.cases.iter().map(|c| exact(Interval::new(1.0 - c.active.high, 1.0 - c.active.low))).collect();
        let (name, signed, ranges) = match interface.operand {
            Operand::Cos => ("in_cos", interface.input_range == InputRange::Any, &cosine),
            Operand::Versine => ("in_ver", false, &versine),
        };
        let port = self.push(Op::Input, &[], Format { signed, ..unit }, name, String::new(), ranges.clone());
        self.inputs.push(port);
        let clamp = Op::Clamp { low: 0, high: one };
        match (interface.operand, interface.input_range) {
            (Operand::Cos, InputRange::Any) => {
                let comment = "x = in_cos taken into [0, 1]: back-facing gives x = 0".to_owned();
                let x = self.push(clamp, &[port], unit, "x", comment, cosine);
                let one = self.constant(one, unit, "one");
                let u = self.push(Op::Sub, &[one, x], unit, "u", "u = 1 - x, the versine".to_owned(), versine);
                (x, u)
            }
            (Operand::Versine, InputRange::Any) => {
                let comment = "u = in_ver taken into [0, 1]: back-facing gives u = 1".to_owned();
                let u = self.push(clamp, &[port], unit, "u", comment, versine);
                let one = self.constant(one, unit, "one");
                let x = self.push(Op::Sub, &[one, u], unit, "x", "x = 1 - u, the cosine".to_owned(), cosine);
                (x, u)
            }
            (Operand::Cos, InputRange::Unit) => {
                let [x, u] = self.within_unit(port, ["x", "u"], [cosine, versine]);
                (x, u)
            }
            (Operand::Versine, InputRange::Unit) => {
                let [u, x] = self.within_unit(port, ["u", "x"], [versine, cosine]);
                (x, u)
            }
        }
    }

    /// A port of `UQ1.F` whose codes are meant to lie in [0, 1], and 1 minus it. Both stay in [0, 1] for every code:
    /// where the fraction is not 0 the whole bit does not count. That takes no comparison, and only the results' own
    /// whole bits any logic.
    fn within_unit(
        &mut self,
        port: NodeId,
        [name, complement]: [&str; 2],
        [own, rest]: [Vec<Bound>; 2],
    ) -> [NodeId; 2] {
        let unit = self.format(port);
        let fraction_bits = Format::unsigned(0, unit.frac_bits);
        let part = |b: &mut Self, of: NodeId, format: Format, what: &str, comment: &str| {
            let bound = Bound { range: Interval::UNIT, error: Interval::ZERO, grid: unit.frac_bits };
            let bounds = vec![bound; b.cases.len()];
            b.push(Op::Cast, &[of], format, what, comment.to_owned(), bounds)
        };
        let whole = part(self, port, Format::FLAG, &format!("{name}_whole"), "1, unless there is a fraction");
        let fraction = part(self, port, fraction_bits, &format!("{name}_fraction"), "without the whole bit");
        let some = self.flag(Op::NonZero, &[fraction], &format!("{name}_some"), "there is a fraction");
        let below = part(self, fraction, unit, &format!("{name}_below_1"), "with a whole bit of 0");
        let own = self.push(Op::Select, &[some, below, port], unit, name, format!("{name}, 0 to 1"), own);

        let one = self.constant(1 << unit.frac_bits, unit, "one");
        let above = format!("{complement}_above_0");
        let comment = format!("1 minus the fraction: {complement}, where {name} is not 1");
        let above = self.push(Op::Sub, &[one, fraction], unit, &above, comment, rest.clone());
        let fraction = part(self, above, fraction_bits, &format!("{complement}_fraction"), "without the whole bit");
        let below = part(self, fraction, unit, &format!("{complement}_below_1"), "with a whole bit of 0");
        let comment = format!("{complement} = 1 - {name}");
        let rest = self.push(Op::Select, &[whole, below, above], unit, complement, comment, rest);
        [own, rest]
    }

    /// The port `in_n` and the address that it is for the memory `memory`, whose rows are those of the set.
    pub fn address(&mut self, set: &Shininess, memory: usize) -> NodeId {
        let port = self.index(set);
        if self.tables[memory].first_index == 0 {
            return port;
        }
        let clamped = self.clamped_index(set, port);
        self.offset_from_first(clamped, memory)
    }

    /// The port `in_n` of a fixed-point range, clamped to it, as the address of the memory `memory`, whose rows are the
    /// range's integers, and the fraction.
    pub fn split_index(&mut self, set: &Shininess, frac_bits: i32, memory: usize) -> (NodeId, NodeId) {
        let port = self.index(set);
        let n = self.clamped_index(set, port);
        let most = self.format(n).int_bits;
        let whole = self.cast(n, Format::unsigned(most, 0), HighBits::Unused, "n_whole", "the integer below n");
        let address = self.offset_from_first(whole, memory);
        let fraction = self.cast(
            n,
            Format::unsigned(0, frac_bits),
            HighBits::Guarded,
            "n_fraction",
            "what n has beyond that integer",
        );
        let rows = self.tables[memory].rows();
        let last = self.cases.iter().map(|case| case.rows[memory] == Some(rows - 1)).collect::<Vec<_>>();
        let most = 1.0 - crate::fixed::exp2(-frac_bits);
        self.assume(
            fraction,
            last.into_iter()
                .map(|last| Bound {
                    range: Interval::new(0.0, if last { 0.0 } else { most }),
                    error: Interval::ZERO,
                    grid: frac_bits,
                })
                .collect(),
        );
        (address, fraction)
    }

    /// The port `in_n`.
    pub fn index(&mut self, set: &Shininess) -> NodeId {
        let bound = Self::codes(set);
        let frac_bits = set.frac_bits() as i32;
        self.input(Format::unsigned(set.index_bits() as i32 - frac_bits, frac_bits), "in_n", |_| bound)
    }

    /// What is known of `in_n` where it lies in the set.
    fn codes(set: &Shininess) -> Bound {
        let Bound { range, error, .. } = Self::whole(set.index_of_row(0), set.index_of_row(set.rows() - 1));
        let frac_bits = set.frac_bits() as i32;
        Bound { range: range.scale(-frac_bits), error, grid: frac_bits }
    }

    /// The port `in_n`, clamped to the set.
    pub fn clamped_index(&mut self, set: &Shininess, port: NodeId) -> NodeId {
        let (first, last) = (set.index_of_row(0), set.index_of_row(set.rows() - 1));
        let bounds = vec![Self::codes(set); self.cases.len()];
        let clamp = Op::Clamp { low: first.into(), high: last.into() };
        let format = self.format(port);
        self.push(clamp, &[port], format, "n", "in_n taken into the range".to_owned(), bounds)
    }
}
