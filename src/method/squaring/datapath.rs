//! `x^n` by repeated squaring, for shininesses that are powers of two: `x, x^2, x^4, ...`, of which n selects one.
//!
//! # The widths
//!
//! An error of `x^j` counts `n/j x^(n-j)` times in `x^n`, which is up to `n/j` near the highlight. So with `s` fraction
//! bits for the last power each one before it has a bit more than the one behind it, and all squarings count the same.

use crate::datapath::builder::{Builder, Case, HighBits};
use crate::datapath::graph::NodeId;
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fixed::{Format, Interval, Table, Widths};
use crate::lobe::{self, Lobe};
use crate::method::polynomial::datapath::{self as polynomial, field};
use crate::method::{Interface, width};
use crate::platform::error::Error;

/// The ROM's fields: the bits of the number of the power that a shininess takes, the least significant first. There are
/// 21 powers of two among the shininesses.
const TAP_BITS: [&str; 5] = ["tap_0", "tap_1", "tap_2", "tap_3", "tap_4"];

/// A chain of squarings, and a multiplexer behind it where the set has more than one shininess.
#[derive(Debug)]
pub struct Squaring<'a> {
    interface: &'a Interface,
    /// log2 n of each shininess of the set.
    logs: Vec<i32>,
    /// The different ones of these, in order: the powers that are selected from.
    taps: Vec<i32>,
}

impl<'a> Squaring<'a> {
    /// For an interface of this method.
    ///
    /// # Errors
    /// A shininess that is out of range or no power of two.
    pub fn new(interface: &'a Interface) -> Result<Self, Error> {
        let log = |n: f64| {
            lobe::check_shininess(n)?;
            let log = libm::ilogb(n);
            if crate::fixed::exp2(log) == n {
                return Ok(log);
            }
            Err(Error::input(
                format!("shininess {n} is not a power of two"),
                "the method squaring serves powers of two only: give a list of them, as 1,2,4,8,16",
            ))
        };
        let logs = interface.shininess.values().into_iter().map(log).collect::<Result<Vec<_>, _>>()?;
        let mut taps = logs.clone();
        taps.sort_unstable();
        taps.dedup();
        Ok(Self { interface, logs, taps })
    }

    /// The number of squarings.
    fn last(&self) -> i32 {
        self.taps[self.taps.len() - 1]
    }

    /// Fraction bits of `x^(2^level)`.
    fn bits(&self, widths: &Widths, level: i32) -> i32 {
        widths[width::S] + self.last() - level
    }

    /// The place of each shininess among the taps.
    fn places(&self) -> Vec<i128> {
        self.logs.iter().map(|log| self.taps.iter().take_while(|&tap| tap < log).count() as i128).collect()
    }

    /// The tap that the ROM's field selects: a tree of multiplexers, one level a bit.
    fn select(&self, b: &mut Builder, address: NodeId, mut taps: Vec<NodeId>) -> NodeId {
        let places = self.places();
        for (bit, name) in TAP_BITS.into_iter().enumerate() {
            if taps.len() == 1 {
                break;
            }
            let flag = b.field(0, address, name);
            let mut half = Vec::new();
            for (pair, both) in taps.chunks(2).enumerate() {
                half.push(match *both {
                    [low, high] => {
                        let chosen = |case: usize| Some(places[case] >> bit & 1 == 1);
                        let name = format!("power_{bit}_{pair}");
                        b.select(flag, [high, low], chosen, &name, "one of two powers of x")
                    }
                    _ => both[0],
                });
            }
            taps = half;
        }
        taps[0]
    }
}

impl Architecture for Squaring<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let g = self.interface.output_fraction as i32;
        let more = libm::ilogb(f64::from(self.last().max(1))) + 1;
        let meaning = "the last power, and a bit more for each squaring before it";
        vec![Parameter::new(width::S, meaning, g + 1..=g + 2 + more)]
    }

    fn cost(&self, w: &Widths) -> f64 {
        let square = |level: i32| {
            let bits = self.bits(w, level).min((self.interface.input_fraction as i32) << level.min(6));
            multiplier_cost(bits + 1, bits + 1)
        };
        (0..self.last()).map(square).sum()
    }

    fn tables(&self, _widths: &Widths) -> Vec<Table> {
        if self.taps.len() == 1 {
            return Vec::new();
        }
        let places = self.places();
        let bits = (usize::BITS - (self.taps.len() - 1).leading_zeros()) as usize;
        let of_bit = |(bit, name): (usize, &&'static str)| {
            let codes: Vec<i128> = places.iter().map(|place| place >> bit & 1).collect();
            let reals = codes.iter().map(|&code| code as f64).collect();
            field(name, "a bit of the number of the power that is taken", 0, codes, reals)
        };
        // The most significant first, as in the word.
        let fields = TAP_BITS.iter().enumerate().take(bits).map(of_bit).rev().collect();
        vec![self.interface.shininess.rom(fields, 0)]
    }

    fn description(&self, _tables: &[Table]) -> Description {
        let powers: Vec<String> = self.taps.iter().map(|&log| crate::fixed::exp2(log).to_string()).collect();
        Description {
            formula: "y = x^n, n a power of two".to_owned(),
            evaluation: format!(
                "x is squared {} times in a chain; of its powers those with the exponents {} are selected from. Each \
                 power has a bit\n\
                 more than the one behind it, since its error counts twice as much. The result is rounded to nearest.",
                self.last(),
                powers.join(", "),
            ),
        }
    }

    fn lobes(&self, _tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let lobe = |n: f64| Box::new(crate::method::log_exp::LogExp { n }) as Box<dyn Lobe>;
        self.interface.shininess.values().into_iter().map(lobe).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let g = self.interface.output_fraction as i32;
        let case = |(row, &log): (usize, &i32)| Case {
            active: Interval::UNIT,
            shininess: crate::fixed::exp2(log),
            rows: vec![Some(row); tables.len()],
        };
        let mut b = Builder::new(&tables, self.logs.iter().enumerate().map(case).collect());
        let address = if tables.is_empty() {
            // The port is there even where it selects nothing.
            b.index(&self.interface.shininess)
        } else {
            b.address(&self.interface.shininess, 0)
        };
        let (x, _) = b.operand(self.interface);
        let mut power = x;
        let mut taps = Vec::new();
        for level in 0..=self.last() {
            let name = format!("x{}", 1i64 << level);
            let text = format!("x^{}", 1i64 << level);
            if level > 0 {
                power = b.mul(power, power, &format!("{name}_exact"), &text);
                // A square of what is at most 1 is at most 1.
                let unit = Format::unsigned(1, b.format(power).frac_bits.min(self.bits(widths, level)));
                power = b.cast(power, unit, HighBits::Guarded, &name, &format!("{text}, rounded down"));
            }
            if self.taps.contains(&level) {
                taps.push(b.floor(power, widths[width::S], &format!("{name}_cut"), &format!("{text} with fewer bits")));
            }
        }
        let y = self.select(&mut b, address, taps);
        let y = b.add_half(y, g, "y_half");
        let y = b.cast(y, Format::unsigned(1, g), HighBits::Unused, "y", "rounded down to the output's bits");
        polynomial::finish(b, self.interface, &tables, y, |_| Interval::ZERO)
    }
}
