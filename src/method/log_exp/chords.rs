//! A function table with linear interpolation, fitted to its quantised words.

use crate::datapath::builder::{Bound, Builder, HighBits};
use crate::datapath::graph::NodeId;
use crate::fixed::{Format, Interval, Table, exp2};
use crate::method::polynomial::datapath::{field, nearest_code};

/// Entries with no more arguments than this are analysed at each of them.
const FEW: i64 = 16;
/// With more, at this many pieces, and the curvature bounds what lies between.
const PIECES: i64 = 8;

/// Codes on either side of the balanced base that are tried.
const AROUND: i128 = 4;

/// A slope of no more bits than this times a distance is a sum of shifts; with more it is a multiplication.
const FEW_SLOPE_BITS: i32 = 5;

/// How finely the slopes are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::method) enum Slopes {
    /// As finely as the value's bits ask for.
    Matched,
    /// Unsigned, with these integer and fraction bits; steeper entries have the steepest that fits.
    Bits {
        /// Integer bits; negative where the leading fraction bits are idle.
        int: i32,
        /// Fraction bits.
        frac: i32,
    },
    /// None: every entry is a constant.
    None,
}

/// Where the hardware's value of a falling function may rise with the argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::method) enum Rises {
    /// From an entry to the next.
    Between,
    /// Nowhere.
    Nowhere,
    /// Nowhere, nor is its last value less than half of the first: where the function goes on with half of itself, the
    /// value does not rise there either.
    NowhereAtOctaves,
}

/// Words of an entry that may be chosen.
#[derive(Clone, Copy, Debug)]
struct Words {
    slope: i128,
    base: i128,
    /// The value's code at the entry's last argument.
    last: i128,
    /// The largest weighted error over the entry.
    error: f64,
}

/// A convex falling function over `[start, start + 2^-domain)` as `base - slope d` in `2^address_bits` equal entries, d
/// being the distance from the entry's start.
pub(in crate::method) struct Chords<'f> {
    /// The memory's name.
    pub name: &'static str,
    /// The names of its fields.
    pub fields: [&'static str; 2],
    /// What they hold.
    pub meanings: [&'static str; 2],
    /// The function.
    pub function: &'f dyn Fn(f64) -> f64,
    /// A bound of its second derivative.
    pub curvature: f64,
    /// The first argument.
    pub start: f64,
    /// The arguments span `2^-domain`.
    pub domain: i32,
    /// The number of entries is `2^address_bits`.
    pub address_bits: i32,
    /// Fraction bits of the argument.
    pub argument_bits: i32,
    /// Fraction bits of the argument that enter the product.
    pub cut_bits: i32,
    /// Fraction bits of the value, to which the product is rounded down.
    pub value_bits: i32,
    /// Every base is below `2^int_bits`.
    pub int_bits: i32,
    /// How finely the slopes are kept.
    pub slopes: Slopes,
    /// How much an error counts at an argument; `None`: everywhere the same. With a weight the function is gone through
    /// argument by argument, so that its curvature need not be bounded.
    pub weight: Option<&'f dyn Fn(f64) -> f64>,
}

impl Chords<'_> {
    /// An entry spans `2^-this`.
    fn step_bits(&self) -> i32 {
        self.domain + self.address_bits
    }

    /// How finely the slopes are kept. Where no bit of the argument is left behind those that select the entry, the
    /// distance from the entry's start is always 0, and there are none.
    fn slopes(&self) -> Slopes {
        if self.cut_bits() > self.step_bits() { self.slopes } else { Slopes::None }
    }

    /// An error of the slope counts `2^-step_bits` times at most.
    fn slope_bits(&self) -> i32 {
        match self.slopes() {
            Slopes::Matched => self.value_bits - self.step_bits() + 1,
            Slopes::Bits { frac, .. } => frac,
            Slopes::None => 0,
        }
    }

    /// The steepest slope's code.
    fn steepest(&self) -> i128 {
        match self.slopes() {
            Slopes::Matched => i128::MAX,
            Slopes::Bits { int, frac } => (1 << (int + frac)) - 1,
            Slopes::None => 0,
        }
    }

    fn cut_bits(&self) -> i32 {
        self.cut_bits.min(self.argument_bits)
    }

    fn first(&self, entry: usize) -> f64 {
        self.start + entry as f64 * exp2(-self.step_bits())
    }

    /// The arguments of an entry; of more entries than arguments, some serve none.
    fn arguments(&self) -> i64 {
        1 << (self.argument_bits - self.step_bits()).max(0)
    }

    /// From an entry's first argument to its last; 0 where it has only one, or none.
    fn span(&self) -> f64 {
        (exp2(-self.step_bits()) - exp2(-self.argument_bits)).max(0.0)
    }

    /// `slope d` rounded down to the value's bits, at an argument of an entry.
    fn product(&self, slope_code: i128, code: i64) -> i128 {
        let product = slope_code * i128::from(code >> (self.argument_bits - self.cut_bits()));
        let dropped = self.slope_bits() + self.cut_bits() - self.value_bits;
        if dropped > 0 { product >> dropped } else { product << -dropped }
    }

    /// The greatest code of a base.
    fn most(&self) -> i128 {
        (1 << (self.int_bits + self.value_bits)) - 1
    }

    /// The slope of an entry's chord, as a code and as it is.
    fn chord(&self, entry: usize) -> (i128, f64) {
        let (first, span) = (self.first(entry), self.span());
        let rise = (self.function)(first) - (self.function)(first + span);
        let slope = if span > 0.0 { rise / span } else { 0.0 };
        (nearest_code(slope, self.slope_bits()).min(self.steepest()), slope)
    }

    /// The arguments of an entry with `-slope d`, as the hardware computes it, minus the function: every `stride`th
    /// from the first, and the last.
    fn differences(&self, entry: usize, slope_code: i128, stride: i64) -> impl Iterator<Item = (f64, f64)> + '_ {
        let first = self.first(entry);
        let count = self.arguments();
        let last = ((count - 1) % stride != 0).then_some(count - 1);
        (0..count).step_by(stride as usize).chain(last).map(move |code| {
            let product = self.product(slope_code, code);
            // Of 64 bits the processor itself makes a float.
            let product = i64::try_from(product).map_or(product as f64, |product| product as f64);
            let argument = first + code as f64 * exp2(-self.argument_bits);
            (argument, -product * exp2(-self.value_bits) - (self.function)(argument))
        })
    }

    /// The error of the hardware's value at every argument where the function is finite, in the order of the arguments.
    pub fn errors(&self, table: &Table) -> Vec<(f64, f64)> {
        let base = table.field(self.fields[0]);
        let slope = table.find(self.fields[1]);
        let of_entry = |entry: usize| {
            let value = base.value(entry);
            let slope_code = slope.map_or(0, |slope| slope.codes[entry]);
            self.differences(entry, slope_code, 1).map(move |(argument, difference)| (argument, value + difference))
        };
        (0..table.rows()).flat_map(of_entry).filter(|(_, error)| error.is_finite()).collect()
    }

    /// What `-slope d` may be for the hardware's value to be the function's, with what each counts: samples of an
    /// entry.
    fn sampled(&self, entry: usize, slope_code: i128, weight: &dyn Fn(f64) -> f64) -> Vec<(f64, f64)> {
        // To choose by, samples do; what is proved of the choice goes over all arguments.
        let stride = (self.arguments() / 32).max(1);
        let chosen = self.differences(entry, slope_code, stride);
        let weighed = chosen.map(|(argument, difference)| (weight(argument), -difference));
        weighed.filter(|(_, value)| value.is_finite()).collect()
    }

    /// The slopes that are tried where errors have weights.
    fn slopes_tried(&self, entry: usize, weight: &dyn Fn(f64) -> f64) -> Vec<i128> {
        let flat = self.sampled(entry, 0, weight);
        let (Some(&first), Some(&last)) = (flat.first(), flat.last()) else { return Vec::new() };
        let chord = if self.span() > 0.0 { (first.1 - last.1) / self.span() } else { 0.0 };
        let steepest = nearest_code(chord, self.slope_bits()).min(self.steepest());
        // Where the weight falls towards one end, a slope gentler than the chord's may serve better.
        let mut slopes: Vec<i128> = (0..=4).map(|quarter| (steepest * quarter + 2) / 4).collect();
        slopes.extend([steepest - 1, steepest + 1]);
        slopes.retain(|slope| (0..=self.steepest()).contains(slope));
        slopes.sort_unstable();
        slopes.dedup();
        slopes
    }

    /// The least largest weighted error of samples, and the base that has it.
    fn balanced(samples: &[(f64, f64)]) -> (f64, f64) {
        let ends = samples.iter().map(|&(_, value)| Interval::point(value)).reduce(Interval::hull);
        let Interval { low: mut least, high: mut most } = ends.unwrap_or(Interval::ZERO);
        let mut worst = f64::INFINITY;
        let mut base = least;
        for _ in 0..24 {
            base = 0.5 * (least + most);
            let side = |above: bool| {
                let parts = samples.iter().filter(|(_, value)| (*value > base) == above);
                parts.map(|(weight, value)| weight * (value - base).abs()).fold(0.0, f64::max)
            };
            let (above, below) = (side(true), side(false));
            worst = above.max(below);
            if above > below { least = base } else { most = base }
        }
        (worst, base)
    }

    /// The slope's code and the base with the least largest weighted error over an entry.
    fn weighed(&self, entry: usize, weight: &dyn Fn(f64) -> f64) -> (i128, f64) {
        let slopes = self.slopes_tried(entry, weight).into_iter();
        let tried = slopes.map(|slope| (slope, Self::balanced(&self.sampled(entry, slope, weight))));
        let best = tried.min_by(|a, b| a.1.0.total_cmp(&b.1.0));
        best.map_or((0, 0.0), |(slope, (_, base))| (slope, base))
    }

    /// How far the value's code falls over an entry.
    fn fall(&self, slope_code: i128) -> i128 {
        self.product(slope_code, self.arguments() - 1)
    }

    /// The words of an entry that may be chosen: slopes about the best, each with bases about the one that balances
    /// its error.
    fn choices(&self, entry: usize) -> Vec<Words> {
        let value = exp2(-self.value_bits);
        let about = |slope: i128, base: f64, error: &dyn Fn(f64) -> f64| -> Vec<Words> {
            let nearest = nearest_code(base, self.value_bits).clamp(0, self.most());
            let bases = (nearest - AROUND..=nearest + AROUND).filter(|base| (0..=self.most()).contains(base));
            let words =
                |base: i128| Words { slope, base, last: base - self.fall(slope), error: error(base as f64 * value) };
            bases.map(words).collect()
        };
        if let Some(weight) = self.weight {
            let slopes = self.slopes_tried(entry, weight).into_iter();
            return slopes
                .flat_map(|slope| {
                    let samples = self.sampled(entry, slope, weight);
                    let error = |base: f64| {
                        samples.iter().map(|(weight, value)| weight * (value - base).abs()).fold(0.0, f64::max)
                    };
                    about(slope, Self::balanced(&samples).1, &error)
                })
                .collect();
        }
        let (chord, _) = self.chord(entry);
        let slopes = (chord - 1..=chord + 1).filter(|slope| (0..=self.steepest()).contains(slope));
        slopes
            .flat_map(|slope| {
                let shape = self.shape(entry, slope);
                let error = |base: f64| (shape.low + base).abs().max((shape.high + base).abs());
                about(slope, -0.5 * (shape.low + shape.high), &error)
            })
            .collect()
    }

    /// Words of all entries with which the value nowhere rises, and errors that grow little by that: the sum of the
    /// eighth powers of the growths is least, which is nearly the largest growth, but leaves none larger than need be.
    /// Entries that serve no argument have none.
    fn falling(&self, rises: Rises) -> Vec<Option<Words>> {
        let mut choices: Vec<Vec<Words>> = (0..1usize << self.address_bits).map(|entry| self.choices(entry)).collect();
        let least = |words: &[Words]| words.iter().copied().min_by(|a, b| a.error.total_cmp(&b.error));
        let mut errors: Vec<f64> = choices.iter().filter_map(|words| Some(least(words)?.error)).collect();
        errors.sort_by(f64::total_cmp);
        let median = errors.get(errors.len() / 2).copied().unwrap_or_default();
        // What an entry's error is measured by: its own least, but for entries where nearly anything does.
        let scale = |words: &[Words]| least(words).map_or(0.0, |words| words.error).max(median).max(f64::MIN_POSITIVE);
        let served: Vec<usize> = (0..choices.len()).filter(|&entry| !choices[entry].is_empty()).collect();
        if let (Rises::NowhereAtOctaves, [first, .., last]) = (rises, &served[..])
            && let Some(best) = least(&choices[*first])
        {
            choices[*first].retain(|words| words.base <= best.base);
            choices[*last].retain(|words| 2 * words.last >= best.base);
        }
        // For each entry the choices, the lowest last value first; each with the least sum that leads to it, and the
        // place of the choice before.
        let mut chain: Vec<Vec<(Words, f64, usize)>> = Vec::new();
        for &entry in &served {
            let mut reached: Vec<(Words, f64, usize)> = Vec::new();
            // From the highest last value down, the cheapest so far.
            let before: Option<Vec<(i128, f64, usize)>> = chain.last().map(|before| {
                let mut best = (f64::INFINITY, 0);
                let places = before.iter().enumerate().rev();
                let mut sums: Vec<(i128, f64, usize)> = places
                    .map(|(place, &(words, sum, _))| {
                        if sum < best.0 {
                            best = (sum, place);
                        }
                        (words.last, best.0, best.1)
                    })
                    .collect();
                sums.reverse();
                sums
            });
            let scale = scale(&choices[entry]);
            for &words in &choices[entry] {
                let own = libm::pow(words.error / scale, 8.0);
                match &before {
                    None => reached.push((words, own, 0)),
                    Some(sums) => {
                        let place = sums.partition_point(|&(last, ..)| last < words.base);
                        if let Some(&(_, sum, from)) = sums.get(place) {
                            reached.push((words, sum + own, from));
                        }
                    }
                }
            }
            if reached.is_empty() {
                return Vec::new();
            }
            reached.sort_by_key(|(words, ..)| words.last);
            chain.push(reached);
        }
        let mut chosen = vec![None; choices.len()];
        let Some(last) = chain.last() else { return chosen };
        let cheapest = last.iter().enumerate().min_by(|(_, a), (_, b)| a.1.total_cmp(&b.1));
        let mut place = cheapest.map_or(0, |(place, _)| place);
        for (reached, &entry) in chain.iter().zip(&served).rev() {
            let (words, _, before) = reached[place];
            chosen[entry] = Some(words);
            place = before;
        }
        chosen
    }

    /// The range of `-slope d`, as the hardware computes it, minus the function over an entry.
    fn shape(&self, entry: usize, slope_code: i128) -> Interval {
        let first = self.first(entry);
        let slope = slope_code as f64 * exp2(-self.slope_bits());
        let hull = |values: &mut dyn Iterator<Item = f64>| {
            values.map(Interval::point).reduce(Interval::hull).unwrap_or(Interval::ZERO)
        };
        if self.arguments() <= FEW {
            return hull(&mut self.differences(entry, slope_code, 1).map(|(_, difference)| difference));
        }
        let piece = self.span() / PIECES as f64;
        let value = |step: i64| -slope * (step as f64 * piece) - (self.function)(first + step as f64 * piece);
        // It is concave, so that it is least at an end, and between two samples above neither by more than this.
        let bulge = self.curvature * piece * piece / 8.0;
        let cut = slope * (exp2(-self.cut_bits()) - exp2(-self.argument_bits));
        let floor = (exp2(-self.value_bits) - exp2(-self.slope_bits() - self.cut_bits())).max(0.0);
        hull(&mut (0..=PIECES).map(value)) + Interval::new(0.0, bulge + cut + floor)
    }

    /// The table: the slope of the chord, and the base that balances the error; where the value is to rise nowhere,
    /// words near these.
    pub fn table(&self, rises: Rises) -> Table {
        let entries = 1usize << self.address_bits;
        let (mut bases, mut slopes) = ((Vec::new(), Vec::new()), (Vec::new(), Vec::new()));
        let falling = if rises == Rises::Between { Vec::new() } else { self.falling(rises) };
        for entry in 0..entries {
            let (slope_code, slope, base_code, base);
            if let Some(words) = falling.get(entry) {
                let words = words.unwrap_or(Words { slope: 0, base: 0, last: 0, error: 0.0 });
                (slope_code, base_code) = (words.slope, words.base);
                (slope, base) =
                    (slope_code as f64 * exp2(-self.slope_bits()), base_code as f64 * exp2(-self.value_bits));
            } else {
                if let Some(weight) = self.weight {
                    (slope_code, base) = self.weighed(entry, weight);
                    slope = slope_code as f64 * exp2(-self.slope_bits());
                } else {
                    (slope_code, slope) = self.chord(entry);
                    let shape = self.shape(entry, slope_code);
                    base = -0.5 * (shape.low + shape.high);
                }
                base_code = nearest_code(base, self.value_bits).min(self.most());
            }
            slopes.0.push(slope_code);
            slopes.1.push(slope);
            bases.0.push(base_code);
            bases.1.push(base);
        }
        let mut fields = vec![field(self.fields[0], self.meanings[0], self.value_bits, bases.0, bases.1)];
        if self.slopes() != Slopes::None {
            fields.push(field(self.fields[1], self.meanings[1], self.slope_bits(), slopes.0, slopes.1));
        }
        Table::listed(self.name, "entry", (0..entries).map(|entry| entry as f64).collect(), fields)
    }

    /// The range of the hardware's value minus the function's over an entry, with the words that the table has.
    pub fn error(&self, table: &Table, entry: usize) -> Interval {
        let base = table.field(self.fields[0]);
        let slope_code = table.find(self.fields[1]).map_or(0, |slope| slope.codes[entry]);
        self.shape(entry, slope_code) + Interval::point(base.value(entry))
    }

    /// The least value of the function over an entry.
    pub fn least(&self, entry: usize) -> f64 {
        (self.function)(self.first(entry) + self.span())
    }

    /// The value at `argument`, whose bits of the weights below `2^-domain` say where in the table it lies.
    pub fn look_up(&self, b: &mut Builder, memory: usize, argument: NodeId, value: &str, formula: &str) -> NodeId {
        let name = |part: &str| format!("{value}_{part}");
        let count = b.cases().len();
        let entry = Format::unsigned(-self.domain, self.step_bits());
        let entry = b.cast(argument, entry, HighBits::Guarded, &name("high"), "the bits that select the entry");
        let shift = self.step_bits();
        let address = b.scale(entry, None, shift, &vec![shift; count], &name("entry"), "the address in the table");
        let base = b.field(memory, address, self.fields[0]);
        if self.slopes() == Slopes::None {
            return base;
        }
        let slope = b.field(memory, address, self.fields[1]);
        let d = Format::unsigned(-self.step_bits(), self.cut_bits());
        let d = b.cast(argument, d, HighBits::Guarded, &name("d"), "the distance from the entry's start");
        let whole = Bound {
            range: Interval::new(0.0, b.format(d).value(b.format(d).max_code())),
            error: Interval::ZERO,
            grid: self.cut_bits(),
        };
        b.assume(d, vec![whole; count]);
        let product = if self.multiplies() {
            b.mul(slope, d, &name("fall"), "how far the value has fallen from the entry's start")
        } else {
            b.mul_by_bits(slope, d, &name("fall"), "how far the value has fallen from the entry's start")
        };
        let product = b.floor(product, self.value_bits, &name("step"), "rounded down");
        b.sub(base, product, value, formula)
    }

    /// Whether the slope meets the distance in a multiplier.
    pub fn multiplies(&self) -> bool {
        match self.slopes() {
            Slopes::Matched => true,
            Slopes::Bits { int, frac } => int + frac > FEW_SLOPE_BITS,
            Slopes::None => false,
        }
    }

    /// Bits of a slope.
    fn slope_width(&self) -> i32 {
        match self.slopes() {
            Slopes::Matched => self.value_bits - self.address_bits,
            Slopes::Bits { int, frac } => int + frac,
            Slopes::None => 0,
        }
    }

    /// An estimate of a word's bits.
    pub fn word_bits(&self) -> i32 {
        self.value_bits + self.int_bits + self.slope_width()
    }

    /// An estimate of its size in LUTs, for ranking.
    pub fn cost(&self) -> f64 {
        f64::from(self.word_bits()) * exp2(self.address_bits) / 16.0 + self.interpolation_cost()
    }

    /// The same without the memory.
    pub fn interpolation_cost(&self) -> f64 {
        let slope = self.slope_width();
        let distance = self.cut_bits() - self.step_bits();
        if slope == 0 {
            0.0
        } else if self.multiplies() {
            crate::datapath::multiplier_cost(slope, distance) + f64::from(self.value_bits)
        } else {
            // A gate a bit and partial product, and the sums.
            f64::from(slope * distance + (slope - 1) * (distance + 1) + self.value_bits)
        }
    }
}
