//! The power itself, `2^(-n L(x))` with `L = -log2 x`: two small tables in place of a ROM row per shininess.
//!
//! After D. Harris, "An Exponentiation Unit for an OpenGL Lighting Engine" (IEEE Trans. Computers 53(3), 2004), with
//! the logarithm taken apart so that its relative accuracy is kept near x = 1, where a large shininess needs it. With
//! `x = 2^-e m`, m in [1/2, 1) or x = m = 1,
//!
//! `z = n L = n e + v κ(m)`, `v = n (1 - m)`, `κ(m) = -log2(m) / (1 - m)`, and `y = 2^-z = 2^-f 2^-i`, `z = i + f`.
//!
//! κ lies between `log2 e` and 2 and, like `2^-f`, comes from a table with linear interpolation (the module `chords`).
//!
//! # The proof
//!
//! The error depends on z far more than on n or x, so the cases of the analysis are ranges of the real z. What the
//! hardware has in place of κ is `κ (1 + ρ)`, ρ bounded over all entries. With `v' = v + δv` the product is off by
//! `κ' δv + v κ ρ`, and `v κ <= z`; so in a case `z' - z = δz` is in `κ' δv + [0, z] ρ` and the roundings. The second
//! table holds `2^-(f + c) + τ`, where c makes up for the mean of δz. So before the last rounding the result is off by
//! `2^-z (2^-(δz + c) - 1) + τ 2^-i + φ`, φ being what the shift by i drops, less than `1 - 2^-i` of the last bit. As
//! `z 2^-z` never exceeds `1/(e ln 2)`, ρ counts at most `1/e`, whatever n is.
//!
//! The result is forced to 0 in three places, and in each `z >= G + 1`, so that y is half an output ulp at most: where
//! the integer part of z does not fit its bits, where v does not (`z >= v log2 e`), and where x is so small that even
//! the least shininess brings it there.

use super::chords::{Chords, Rises, Slopes};
use super::{EXP_ADDRESS, LOG_ADDRESS};
use crate::datapath::builder::{Bound, Builder, Case, HighBits};
use crate::datapath::graph::NodeId;
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fixed::{Format, Interval, Table, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::exponent::{Exponent, error_of_exponent, power_less_one};
use crate::method::log_exp::{EXP_CURVATURE, LOG_RATIO_CURVATURE, log_ratio};
use crate::method::polynomial::datapath as polynomial;
use crate::method::{Interface, width};
use crate::platform::error::Error;

const LOG2_E: f64 = std::f64::consts::LOG2_E;

/// The memory of κ.
pub(in crate::method) const LOG_TABLE: &str = "log_table";
/// The memory of the exponential.
pub(in crate::method) const EXP_TABLE: &str = "exp_table";

/// `2^-f` for the fraction f of z, from its table.
pub(in crate::method) fn exp_chords<'f>(
    widths: &Widths,
    slopes: Slopes,
    function: &'f dyn Fn(f64) -> f64,
) -> Chords<'f> {
    Chords {
        name: EXP_TABLE,
        fields: ["exp_base", "exp_slope"],
        meanings: ["2^-f at the entry's start", "how steeply 2^-f falls"],
        function,
        curvature: EXP_CURVATURE,
        start: 0.0,
        domain: 0,
        address_bits: widths[EXP_ADDRESS],
        argument_bits: widths[width::Z],
        cut_bits: widths[width::Z],
        value_bits: widths[width::E],
        int_bits: 0,
        slopes,
        weight: None,
    }
}

/// `v = n u` below `2^int_bits`, and whether it is so large that it is not; `u` is called `versine` in the comments.
pub(in crate::method) fn times_versine(
    b: &mut Builder,
    widths: &Widths,
    [n, u]: [NodeId; 2],
    int_bits: i32,
    versine: &str,
) -> (NodeId, Option<NodeId>) {
    let nu = b.mul(n, u, "nu", &format!("n {versine}"));
    let beyond = b.reaches(nu, int_bits, "beyond", "so large that z is past what the result can show");
    let exact = b.format(nu);
    let v = Format::unsigned(exact.int_bits.min(int_bits), exact.frac_bits.min(widths[width::V]));
    (b.cast(nu, v, HighBits::Guarded, "v", &format!("v = n {versine}, rounded down")), beyond)
}

/// `x` where n is 1, else `y`.
pub(super) fn unless_one(b: &mut Builder, n: NodeId, y: NodeId, x: NodeId) -> NodeId {
    let one = b.constant(1 << b.format(n).frac_bits, b.format(n), "n_one");
    let above = b.greater(n, one, "above_one", "n > 1");
    b.select(above, [y, x], |_| None, "y_or_x", "x itself for n = 1")
}

/// `2^-z = 2^-f 2^-i`, `z = i + f`, the integer part having `whole_bits`: `exp` is the table of `2^-(f + lift)` and
/// lies in `memory`. Each case has the real z in its level.
pub(in crate::method) fn power_of_two(
    b: &mut Builder,
    exp: &Chords,
    memory: usize,
    z: NodeId,
    whole_bits: i32,
    lift: f64,
    levels: &[Interval],
) -> Option<NodeId> {
    let fraction = exp.look_up(b, memory, z, "power", "2^-f");
    let table = b.table(memory);
    let table_error = (0..table.rows()).map(|entry| exp.error(table, entry)).reduce(Interval::hull)?;
    let whole = whole_bits.min(b.format(z).int_bits);
    let whole = b.cast(z, Format::unsigned(whole, 0), HighBits::Guarded, "i", "the integer part of z");
    let shifted = b.shift_right(fraction, whole, "power_shifted", "2^-z = 2^-f 2^-i");
    let grid = b.format(shifted).frac_bits;
    let bound = |(level, z): (&Interval, &Bound)| {
        let off = z.error;
        let hardware = Interval::new((level.low + off.low).max(0.0), (level.high + off.high).max(0.0));
        let (least, most) = (hardware.low as i32, hardware.high as i32);
        let scale = Interval::new(exp2(-most), exp2(-least));
        let real = Interval::new(libm::exp2(-level.high), libm::exp2(-level.low));
        // What a shift by i drops of a multiple of 2^-e is below 2^-e by the weight of its own last bit.
        let lost = exp2(-exp.value_bits) * (1.0 - exp2(-most));
        let error =
            real * power_less_one(off + Interval::point(lift)) + table_error * scale + Interval::new(-lost, 0.0);
        Bound { range: Interval::UNIT, error, grid }
    };
    let bounds = levels.iter().zip(b.bounds(z)).map(bound).collect();
    b.assume(shifted, bounds);
    Some(shifted)
}

/// `2^-z` rounded to nearest with `g` fraction bits; 0 where one of the flags is set, as it is only where that is half
/// an ulp at most. Each case has the real z in its level.
pub(in crate::method) fn rounded_or_zero(
    b: &mut Builder,
    power: NodeId,
    g: i32,
    flags: &[Option<NodeId>],
    levels: &[Interval],
) -> NodeId {
    let y = b.add_half(power, g, "y_half");
    let y = b.cast(y, Format::unsigned(1, g), HighBits::Unused, "y_cut", "rounded to the output's bits");
    let zero = b.any(flags, "zero", "the result is 0");
    let y = b.zero_if(zero, y, "y", "y, 0 where it is below half an ulp");
    let forced = |(bound, level): (&Bound, &Interval)| {
        let gone = Interval::new(if level.high > f64::from(g) + 0.5 { -libm::exp2(-level.low) } else { 0.0 }, 0.0);
        Bound { error: bound.error.hull(gone), ..*bound }
    };
    let bounds = b.bounds(y).iter().zip(levels).map(forced).collect();
    b.assume(y, bounds);
    y
}

/// Bits of the integer part of z for an output of `g` fraction bits: the result is 0 from `2^this >= G + 1` on.
pub(in crate::method) fn whole_bits(g: i32) -> i32 {
    libm::ilogb(f64::from(g)) + 1
}

/// Integer bits of v: from `v = 2^this` on, z is at least `2^this log2 e >= G + 1`.
pub(in crate::method) fn versine_int_bits(g: i32) -> i32 {
    (0..).find(|&bits| exp2(bits) * LOG2_E >= f64::from(g + 1)).unwrap_or_default()
}

/// The ranges of the real z that the cases of the analysis are: fine where y is large. Past the last but one the result
/// is 0, or forced to it: what z is from `2^whole_bits` on does not matter, as v or the hardware's z does not fit
/// there.
pub(in crate::method) fn levels(g: i32) -> Vec<Interval> {
    let sixteenths = 16 * (g + 2);
    let edges: Vec<f64> = (0..=sixteenths).filter(|k| *k <= 48 || k % 4 == 0).map(|k| f64::from(k) / 16.0).collect();
    let mut levels: Vec<Interval> = edges.windows(2).map(|edge| Interval::new(edge[0], edge[1])).collect();
    levels.push(Interval::new(edges[edges.len() - 1], exp2(whole_bits(g)) + 1.0));
    levels
}

/// `2^(-n L(x))`.
#[derive(Debug)]
pub struct LogExp<'a> {
    interface: &'a Interface,
    n: Exponent<'a>,
}

impl<'a> LogExp<'a> {
    /// For an interface of this method.
    ///
    /// # Errors
    /// A shininess that the method refuses.
    pub fn new(interface: &'a Interface) -> Result<Self, Error> {
        Ok(Self { interface, n: Exponent::new(interface)? })
    }

    fn input_bits(&self) -> i32 {
        self.interface.input_fraction as i32
    }

    fn output_bits(&self) -> i32 {
        self.interface.output_fraction as i32
    }

    /// x below `2^-this` gives 0: there n L is at least G + 1 for the least shininess.
    fn depth(&self) -> i32 {
        (f64::from(self.output_bits() + 1) / self.n.least).ceil() as i32
    }

    /// How far x is shifted at most; one bit less than the depth, since m >= 1/2, or than x has.
    fn most_shift(&self) -> i32 {
        self.depth().min(self.input_bits()) - 1
    }

    fn log_chords(&self, widths: &Widths) -> Chords<'static> {
        Chords {
            name: LOG_TABLE,
            fields: ["log_base", "log_slope"],
            meanings: ["log ratio at the entry's start", "how steeply the log ratio falls"],
            function: &log_ratio,
            curvature: LOG_RATIO_CURVATURE,
            start: 0.5,
            domain: 1,
            address_bits: widths[LOG_ADDRESS],
            argument_bits: self.input_bits(),
            cut_bits: widths[width::K] + 1,
            value_bits: widths[width::K],
            int_bits: 1,
            slopes: Slopes::Matched,
            weight: None,
        }
    }

    /// Whether n = 1 gives x by a way of its own. An output with all the bits of x gets x anyhow: it is less than 1 ulp
    /// off.
    fn bypasses(&self) -> bool {
        self.n.least == 1.0 && self.input_bits() > self.output_bits()
    }

    /// `v κ(m)`, κ from its memory; each case has the real z in its level.
    fn times_ratio(
        &self,
        b: &mut Builder,
        widths: &Widths,
        memory: usize,
        [v, m]: [NodeId; 2],
        levels: &[Interval],
    ) -> Option<NodeId> {
        let log = self.log_chords(widths);
        let ratio = log.look_up(b, memory, m, "ratio", "k = -log2(m) / (1 - m)");
        let relative = (0..1usize << log.address_bits)
            .map(|entry| {
                let (error, least) = (log.error(b.table(memory), entry), log.least(entry));
                Interval::new(error.low.min(0.0) / least, error.high.max(0.0) / least)
            })
            .reduce(Interval::hull)?;
        let product = b.mul(v, ratio, "vk", "v k");
        let bounds = levels.iter().enumerate().map(|(case, level)| {
            let (v, ratio) = (b.bounds(v)[case], b.bounds(ratio)[case]);
            let error = ratio.range * v.error + Interval::new(0.0, level.high) * relative;
            Bound { error, ..b.bounds(product)[case] }
        });
        let bounds = bounds.collect();
        b.assume(product, bounds);
        Some(product)
    }

    /// `n e`: a sum over the steps that the normalisation took.
    fn times_steps(&self, b: &mut Builder, n: NodeId, steps: &[(i32, NodeId)]) -> Option<NodeId> {
        if steps.is_empty() {
            return None;
        }
        let n =
            b.at_most(n, whole_bits(self.output_bits()), "n_low", "n or more than the result can show, where x < 1/2");
        let count = b.cases().len();
        let terms = steps.iter().map(|&(shift, above)| {
            let power = libm::ilogb(f64::from(shift));
            let name = format!("n_{shift}");
            let scaled = b.scale(n, None, power, &vec![power; count], &name, &format!("{shift} n"));
            b.zero_if(Some(above), scaled, &format!("ne_{shift}"), "0 where this step was not taken")
        });
        let mut terms: Vec<NodeId> = terms.collect();
        let mut round = 0;
        while terms.len() > 1 {
            round += 1;
            terms = terms
                .chunks(2)
                .enumerate()
                .map(|(place, pair)| match *pair {
                    [a, c] => b.add(a, c, &format!("ne_sum_{round}_{place}"), "n e"),
                    _ => pair[0],
                })
                .collect();
        }
        terms.first().copied()
    }
}

impl Architecture for LogExp<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.input_bits(), self.output_bits());
        let n_bits = self.n.int_bits();
        let mut parameters = Vec::new();
        let mut n_fraction = self.interface.shininess.frac_bits() as i32;
        if let Some(n) = self.n.parameter(g) {
            n_fraction = *n.range.end();
            parameters.push(n);
        }
        let log = ((g - 5) / 2).max(1);
        let exp = ((g - 4) / 2).max(1);
        let u = Parameter::new(width::U, "versine of the normalised cosine", g + n_bits..=g + n_bits + 4).up_to(f);
        let v = Parameter::new(width::V, "v = n times that versine", g..=g + 4).up_to(n_fraction + u.range.end());
        parameters.extend([
            Parameter::new(LOG_ADDRESS, "table of the logarithm (bits of its address)", log..=log + 4).up_to(f - 2),
            Parameter::new(EXP_ADDRESS, "table of the exponential (bits of its address)", exp..=exp + 4),
            u,
            v,
            Parameter::new(width::K, "log ratio", g..=g + 4),
            Parameter::new(width::Z, "z = n L", g..=g + 4),
            Parameter::new(width::E, "2^-f", g + 1..=g + 5),
        ]);
        parameters
    }

    fn cost(&self, w: &Widths) -> f64 {
        let n_bits = self.n.int_bits() + self.n.frac_bits(w);
        let power = |f: f64| libm::exp2(-f);
        multiplier_cost(n_bits, w[width::U])
            + multiplier_cost(versine_int_bits(self.output_bits()) + w[width::V], w[width::K] + 1)
            + self.log_chords(w).cost()
            + exp_chords(w, Slopes::Matched, &power).cost()
            // The shifter has a multiplexer a bit and level.
            + f64::from(w[width::E] * whole_bits(self.output_bits()) + 2 * w[width::Z] + w[width::V])
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let mut tables: Vec<Table> = self.n.table(self.n.frac_bits(widths)).into_iter().collect();
        let lift = self.n.lift(self.input_bits(), widths);
        tables.push(self.log_chords(widths).table(Rises::Between));
        tables.push(exp_chords(widths, Slopes::Matched, &|f| libm::exp2(-f - lift)).table(Rises::Between));
        tables
    }

    fn description(&self, tables: &[Table]) -> Description {
        let entries = |name: &str| tables.iter().find(|table| table.name == name).map_or(0, Table::rows);
        let bypass = if self.bypasses() { " Shininess 1 gives x rounded to nearest." } else { "" };
        Description {
            formula: "y = x^n".to_owned(),
            evaluation: format!(
                "It is evaluated as 2^(-n L) with L = -log2 x. With x = 2^-e m, m in [1/2, 1), n L = n e + n (1 - m) \
                 k, where the log ratio\n\
                 k = -log2(m) / (1 - m) comes from a table of {} entries with linear interpolation, and so does 2^-f \
                 for the fraction f\n\
                 of n L, from {} entries; the integer part shifts. So n is a number that the core computes with, and \
                 the relative\n\
                 accuracy of L near x = 1 is that of the versine. The result is rounded to nearest.{bypass}",
                entries(LOG_TABLE),
                entries(EXP_TABLE),
            ),
        }
    }

    fn lobes(&self, _tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let lobe = |n: f64| Box::new(crate::method::log_exp::LogExp { n }) as Box<dyn Lobe>;
        self.interface.shininess.values().into_iter().map(lobe).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let (f, g) = (self.input_bits(), self.output_bits());
        let memory = |name: &str| tables.iter().position(|table| table.name == name);
        let (log_memory, exp_memory) = (memory(LOG_TABLE)?, memory(EXP_TABLE)?);
        let levels = levels(self.output_bits());
        let case = Case { active: Interval::UNIT, shininess: self.n.largest, rows: vec![None; tables.len()] };
        let mut b = Builder::new(&tables, vec![case; levels.len()]);

        let n = self.n.node(&mut b, &tables);
        let (x, versine) = b.operand(self.interface);
        let enough =
            b.reaches(x, -self.depth().min(f), "enough", "x is large enough for a result above half an ulp")?;
        let small = b.not(enough, "small", "x is so small that the result is 0");
        let normal = b.normalise(x, -1, self.most_shift(), "m");
        let mut u = versine;
        if !normal.steps.is_empty() {
            let unit = b.constant(1 << f, Format::unsigned(1, f), "unit");
            u = b.sub(unit, normal.value, "um", "1 - m, m = x 2^e in [1/2, 1] or x = 0");
        }
        let half = b.bounds(u).iter().map(|bound| Bound { range: Interval::new(0.0, 0.5), ..*bound }).collect();
        b.assume(u, half);
        let u = b.floor(u, widths[width::U], "u_cut", "1 - m, rounded down");
        let (v, beyond) = times_versine(&mut b, widths, [n, u], versine_int_bits(self.output_bits()), "(1 - m)");
        let product = self.times_ratio(&mut b, widths, log_memory, [v, normal.value], &levels)?;
        let mut z = b.floor(product, widths[width::Z], "vk_cut", "rounded down");
        if let Some(steps) = self.times_steps(&mut b, n, &normal.steps) {
            z = b.add(steps, z, "z_sum", "z = n e + v k");
            z = b.floor(z, widths[width::Z], "z", "z, rounded down");
        }
        let whole_bits = whole_bits(self.output_bits());
        let over = b.reaches(z, whole_bits, "over", "z is past what the result can show");

        let lift = self.n.lift(self.input_bits(), widths);
        // The places where the result is forced to 0 rest on this.
        if b.bounds(z).iter().any(|z| z.error.magnitude() > 0.25) {
            return None;
        }
        let power = |f: f64| libm::exp2(-f - lift);
        let exp = exp_chords(widths, Slopes::Matched, &power);
        let shifted = power_of_two(&mut b, &exp, exp_memory, z, whole_bits, lift, &levels)?;

        let mut y = rounded_or_zero(&mut b, shifted, g, &[Some(small), beyond, over], &levels);
        if self.bypasses() {
            let rounded = b.add_half(x, g, "x_half");
            let rounded =
                b.cast(rounded, Format::unsigned(1, g), HighBits::Unused, "x_rounded", "x, rounded to nearest");
            y = unless_one(&mut b, n, y, rounded);
        }

        let relative = self.n.relative_error(&tables);
        polynomial::finish(b, self.interface, &tables, y, |case| error_of_exponent(levels[case], relative))
    }
}
