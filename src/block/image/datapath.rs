//! The operations of the image-based block.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::joints::{Joints, LightJoints, PlaceJoints};
use super::texels::{banks, fields, parities};
use super::{BLENDED, FrontEnd, Image, ImageBlock, ImageForm, ImageWidths, OctaveAxis, functions, turn};
use crate::block::CHANNELS;
use crate::block::parts::{self, AXES};
use crate::datapath::Datapath;
use crate::datapath::builder::{Bound, Builder, Case, HighBits};
use crate::datapath::graph::{NodeId, Op};
use crate::fixed::{Format, Interval, exp2};

/// The widest codes that are blended by the weights' bits: a DSP block is worth it for wider ones.
const BLENDED_BY_BITS: u32 = 14;

/// What a light's record is: at its ports, or as it is computed.
pub(super) struct LightPorts {
    /// None where the texels hold n·l.
    pub(super) direction: Option<[NodeId; 3]>,
    /// The vectors of [`Image::frame`].
    pub(super) frame: Vec<Vec<NodeId>>,
    pub(super) band: NodeId,
    pub(super) blend: NodeId,
    /// Of the form paper.
    pub(super) turns: Option<TurnPorts>,
    /// None where all lights have one.
    pub(super) shift: Option<NodeId>,
    pub(super) gain: [NodeId; 3],
    /// What the intensities are multiplied by, where these are told.
    pub(super) full_gain: Option<NodeId>,
}

/// The ports of a light that turn the normal.
pub(super) struct TurnPorts {
    /// Half of the way to the image with an even number and to that with an odd one.
    pub(super) halves: [NodeId; 2],
    /// Whether a single image is looked up.
    pub(super) alone: NodeId,
}

/// The graph under construction.
pub(super) struct Imaging<'a, 'b> {
    pub(super) b: Builder<'b>,
    pub(super) image: &'a Image,
    pub(super) widths: ImageWidths,
    pub(super) normal: [NodeId; 3],
    /// Whether the normal is turned away from the viewer.
    hidden: NodeId,
    /// The number of the first memory that holds a function and not texels.
    functions: usize,
    /// How many of these a light has.
    functions_a_light: usize,
    /// The bits of the weights so far.
    weights: BTreeMap<NodeId, Rc<[NodeId]>>,
    pub(super) joints: Joints,
}

/// Both addresses of a place in a direction whose texels lie in two memories by their parity, and the weight of the odd
/// one.
#[derive(Clone, Copy)]
pub(super) struct Pair {
    /// In the memory of the even and of the odd ones.
    addresses: [NodeId; 2],
    odd: NodeId,
    /// Of what it was made, if it was: whether the one at or below the place is the odd one, and the weight of the
    /// next.
    of: Option<[NodeId; 2]>,
}

/// Where the texels lie that are blended.
pub(super) struct LookUp {
    /// In each direction, the outermost first, in a band with an even number and in one with an odd number.
    pairs: Vec<[Pair; 2]>,
    /// Of the memories.
    parities: Vec<Vec<usize>>,
    /// In each memory.
    addresses: Vec<NodeId>,
    /// The light, from 0, whose memories these are.
    light: usize,
}

/// A place among the texels in a direction: as it was found, the texel at or below it, and the weight of the next.
#[derive(Clone, Copy)]
pub(super) struct Place {
    place: NodeId,
    pub(super) texel: NodeId,
    pub(super) weight: NodeId,
}

pub(super) fn bound(low: f64, high: f64, grid: i32) -> Bound {
    Bound { range: Interval::new(low, high), error: Interval::ZERO, grid }
}

impl Imaging<'_, '_> {
    /// The ports of a vector, signed Q1.f.
    pub(super) fn vector(&mut self, name: &str, axes: &[char]) -> Vec<NodeId> {
        axes.iter().map(|axis| self.b.port(self.image.vector(), &format!("in_{name}{axis}"))).collect()
    }

    /// The fields of a light's function table of this number.
    pub(super) fn fields<const N: usize>(&mut self, number: usize, address: NodeId, l: usize) -> [NodeId; N] {
        let memory = self.functions + self.functions_a_light * (l - 1) + number;
        let names: Vec<&'static str> = self.b.table(memory).fields.iter().map(|field| field.name).collect();
        std::array::from_fn(|field| self.b.field(memory, address, names[field]))
    }

    fn light_ports(&mut self, l: usize) -> LightPorts {
        if self.image.front_end == FrontEnd::Vector {
            return self.computed_record(l);
        }
        let shift_bits = self.widths.shift_bits();
        let direction = self.image.has_incidence().then(|| {
            let direction = self.vector(&format!("l{l}"), &AXES);
            [direction[0], direction[1], direction[2]]
        });
        let frame = self.image.frame().iter().map(|(name, axes)| self.vector(&format!("{name}{l}"), axes)).collect();
        let band_bits = Image::place_bits(self.image.extents()[0]) as i32;
        LightPorts {
            direction,
            frame,
            band: self.b.port(Format::unsigned(band_bits, 0), &format!("in_band{l}")),
            blend: self.b.port(Format::unsigned(1, self.image.weight_bits as i32), &format!("in_blend{l}")),
            turns: self.image.has_turns().then(|| TurnPorts {
                halves: ["even", "odd"].map(|parity| self.b.port(turn::HALF_TURN, &format!("in_turn{l}_{parity}"))),
                alone: self.b.port(Format::unsigned(1, 0), &format!("in_alone{l}")),
            }),
            shift: (shift_bits > 0).then(|| self.b.port(Format::unsigned(shift_bits, 0), &format!("in_shift{l}"))),
            gain: CHANNELS.map(|c| self.b.port(self.widths.gain_format(), &format!("in_gain{l}{c}"))),
            full_gain: None,
        }
    }

    /// Whether the normal is turned away from the viewer.
    fn hidden(&mut self) -> NodeId {
        let towards = self.b.at_least_zero(self.normal[2], "nz_kept", "n.v, not below 0");
        let seen = self.b.reaches(towards, -(self.image.vector_fraction as i32), "seen", "n.v > 0");
        self.b.not(seen.expect("n.v has bits"), "hidden", "the normal is turned away from the viewer")
    }

    /// The exponent of a light's gain, kept at the greatest.
    fn shift(&mut self, port: Option<NodeId>, l: usize) -> Option<NodeId> {
        let most = i128::from(self.widths.shift);
        port.map(|shift| {
            if self.b.bounds(shift)[0].range.high > f64::from(self.widths.shift) {
                self.b.clamp(shift, 0, most, &format!("shift{l}"), "at most the greatest")
            } else {
                shift
            }
        })
    }

    /// A factor below 1, with so many fraction bits, times 2^shift: bit by bit with a register between, as at once it
    /// takes more than twice the tables, and n.l has time.
    fn shifted_up(&mut self, factor: NodeId, bits: i32, shift: NodeId, name: &str) -> NodeId {
        let most_shift = self.widths.shift;
        let top = self.b.format(shift).int_bits - 1;
        if top == 0 {
            return self.b.scale(factor, Some(shift), 0, &[most_shift], &format!("{name}_up"), "times 2^shift");
        }
        let is_set = |b: &mut Builder, bit| b.bit(shift, bit, &format!("{name}_by_{}", 1 << bit), "a bit of the shift");
        let mut up = factor;
        // What is shifted by the first bits of the shift.
        let mut ups = vec![factor];
        for bit in 0..top {
            let by = 1 << bit;
            let is_set = is_set(&mut self.b, bit);
            let amount = Format::unsigned(bit + 1, 0);
            let amount = self.b.cast(is_set, amount, HighBits::Unused, &format!("{name}_amount_{by}"), "its weight");
            up = self.b.scale(up, Some(amount), 0, &[by], &format!("{name}_up_{by}"), &format!("times 2^{by} if so"));
            self.b.assume(up, vec![bound(0.0, exp2(2 * by - 1) - exp2(2 * by - 1 - bits), bits)]);
            ups.push(up);
        }
        // Not all of the others can be set beside the last one.
        let by = 1 << top;
        let beside = (most_shift - by).checked_ilog2().map_or(0, |last| last as usize + 1);
        let all = self.b.scale(ups[beside], None, by, &[by], &format!("{name}_all"), &format!("times 2^{by}"));
        let is_set = is_set(&mut self.b, top);
        self.b.select(is_set, [all, up], |_| None, &format!("{name}_up"), "times 2^shift")
    }

    /// A factor below 1, with so many fraction bits, times 2^shift, rounded down and kept in the format of n·l.
    fn shifted(&mut self, factor: NodeId, bits: i32, shift: Option<NodeId>, name: &str) -> NodeId {
        let ImageWidths { lit_int, lit, .. } = self.widths;
        let Some(shift) = shift else { return factor };
        let up = self.shifted_up(factor, bits, shift, name);
        let cut = self.b.floor(up, lit, &format!("{name}_up_cut"), "rounded down");
        let most = (1i128 << (lit_int + self.b.format(cut).frac_bits)) - 1;
        self.b.clamp(cut, 0, most, &format!("{name}_within"), "kept in its format")
    }

    /// n·l from 0 times 2^shift, rounded down and kept in its format; 0 where the normal is turned away from the
    /// viewer.
    fn incidence(&mut self, direction: [NodeId; 3], shift: Option<NodeId>, l: usize) -> NodeId {
        let ImageWidths { lit, shift: most_shift, .. } = self.widths;
        let bits = Some(self.widths.dot);
        let dot = parts::dot(&mut self.b, &self.normal, &direction, bits, &format!("nl{l}"), "n.l");
        let dot = self.b.floor(dot, lit + most_shift, &format!("nl{l}_cut"), "rounded down");
        let most = (1i128 << self.b.format(dot).frac_bits) - 1;
        let dot = self.b.clamp(dot, 0, most, &format!("nl{l}_kept"), "n.l, kept in [0, 1)");
        let dot = self.shifted(dot, lit + most_shift, shift, &format!("nl{l}"));
        self.b.zero_if(Some(self.hidden), dot, &format!("nl{l}"), "n.l, 0 for a normal that is turned away")
    }

    /// u = |n - h|²/2, rounded down, at most that of the last column.
    fn versine(&mut self, half: &[NodeId], octaves: u32, l: usize) -> NodeId {
        let most = 1i128 << (self.image.vector_fraction + 1);
        let apart = [0, 1, 2].map(|axis| {
            let name = format!("d{l}_{}", AXES[axis]);
            let d = self.b.sub(self.normal[axis], half[axis], &format!("{name}_exact"), "a component of n - h");
            self.b.clamp(d, -most, most - 1, &name, "of unit vectors it is below 2")
        });
        let bits = Some(self.widths.place);
        let sum = parts::dot(&mut self.b, &apart, &apart, bits, &format!("dd{l}"), "|n - h|^2");
        let u = self.b.scale(sum, None, -1, &[-1], &format!("u{l}_exact"), "|n - h|^2 / 2");
        let bits = self.image.versine_bits(octaves) as i32;
        let u = self.b.floor(u, bits, &format!("u{l}_cut"), "rounded down");
        let most = (1i128 << bits) - (1 << (bits - self.image.octave_bits(octaves) as i32 - 1));
        self.b.clamp(u, 0, most, &format!("u{l}"), "the versine u = |n - h|^2 / 2, at most the last column's")
    }

    /// The number of the column at or below u and the weight of the next, of w bits: u, of which names begin with
    /// `of`, as a floating-point number.
    pub(super) fn octave_column(&mut self, u: NodeId, axis: OctaveAxis, w: i32, of: &str, l: &str) -> Place {
        let (octaves, m) = (axis.size >> axis.octave_bits, axis.octave_bits as i32);
        let mut y = u;
        let mut exponent: Option<NodeId> = None;
        let mut flags = Vec::new();
        for amount in (0..octaves.ilog2()).rev().map(|bit| 1i32 << bit) {
            let name = |what: &str| format!("{what}{l}_{amount}");
            let frac_bits = self.b.format(y).frac_bits;
            let high = self.b.reaches(y, -amount, &name("high"), &format!("the first {amount} bits of {of}"));
            let high = high.expect("u has these bits");
            let low = Format::unsigned(-amount, frac_bits);
            let low = self.b.cast(y, low, HighBits::Guarded, &name(&format!("{of}_low")), "without them");
            let up =
                self.b.scale(low, None, amount, &[amount], &name(&format!("{of}_up")), &format!("{of} 2^{amount}"));
            let what = format!("{of}, times 2^{amount} if it is so small");
            y = self.b.select(high, [y, up], |_| None, &name(of), &what);
            // Where a single bit is looked at it keeps its weight.
            let bit = amount.ilog2() as i32 + self.b.format(high).frac_bits;
            let place = self.b.scale(high, None, bit, &[bit], &name("place"), "a bit of the exponent");
            exponent = Some(match exponent {
                None => place,
                Some(before) => self.b.add(before, place, &name("exponent"), "the exponent's bits so far"),
            });
            flags.push(Some(high));
        }
        let normal = self.b.any(&flags, &format!("normal{l}"), "the exponent is not 0").expect("there are octaves");
        let twice = self.b.scale(y, None, 1, &[1], &format!("{of}{l}_twice"), &format!("2 {of}"));
        let frac_bits = self.b.format(twice).frac_bits;
        let rest = Format::unsigned(0, frac_bits);
        let rest = self.b.cast(twice, rest, HighBits::Guarded, &format!("{of}{l}_rest"), &format!("2 {of} - 1"));
        let rest = self.b.select(normal, [rest, y], |_| None, &format!("rest{l}"), "the place in the octave");
        let rest = self.b.floor(rest, m + w, &format!("rest{l}_cut"), "rounded down to the weights' last bit");
        let within = self.b.cast(
            rest,
            Format::unsigned(0, m),
            HighBits::Unused,
            &format!("step{l}"),
            "the column in the octave",
        );
        let within = self.b.scale(within, None, m, &[m], &format!("step{l}_number"), "its number");
        let exponent = exponent.expect("there are octaves");
        let exponent = self.b.scale(exponent, None, m, &[m], &format!("octave{l}"), "the octave's first column");
        let column = self.b.add(exponent, within, &format!("column{l}"), &format!("the column at or below {of}"));
        let weight = self.b.cast(
            rest,
            Format::unsigned(-m, m + w),
            HighBits::Guarded,
            &format!("part{l}"),
            &format!("{of} past it"),
        );
        let weight = self.b.scale(weight, None, m, &[m], &format!("weight{l}"), "the weight of the next column");
        Place { place: u, texel: column, weight }
    }

    /// A product with the normal.
    pub(super) fn across(&mut self, axis: &[NodeId], name: &str, l: usize) -> NodeId {
        let (normal, kept) = (&self.normal[..axis.len()], Some(self.widths.place));
        parts::dot(&mut self.b, normal, axis, kept, &format!("{name}{l}"), "the turned normal")
    }

    /// Where a component of the turned normal lies among the texels of a side, whose centres are at (i + 1/2)/size of
    /// -1 to 1, from the first: to the nearest weight and between the outermost centres.
    pub(super) fn along(&mut self, component: NodeId, name: &str) -> NodeId {
        let w = self.image.weight_bits as i32;
        let (bits, size) = (self.image.size.ilog2() as i32, i128::from(self.image.size));
        let by = bits - 1;
        let scaled = self.b.scale(component, None, by, &[by], &format!("{name}_scaled"), "in texels from the middle");
        let middle = ((size - 1) << w) + 1;
        let format = Format::unsigned(bits, w + 1);
        let middle = self.b.constant(middle, format, &format!("middle_{w}"));
        let place =
            self.b.add(scaled, middle, &format!("{name}_place"), "from the first, plus half a weight's last bit");
        let place = self.b.floor(place, w, &format!("{name}_cut"), "rounded to the nearest weight");
        self.b.clamp(place, 0, (size - 1) << w, &format!("{name}_kept"), "between the outermost centres")
    }

    /// A place along a side: the texel at or below it and the weight of the next.
    pub(super) fn split(&mut self, place: NodeId, name: &str) -> Place {
        let bits = self.image.size.ilog2() as i32;
        let whole = Format::unsigned(bits, 0);
        let texel = self.b.cast(place, whole, HighBits::Unused, &format!("{name}_texel"), "the texel at or below it");
        let part = Format::unsigned(0, self.image.weight_bits as i32);
        let weight = self.b.cast(place, part, HighBits::Guarded, &format!("{name}_weight"), "the weight of the next");
        Place { place, texel, weight }
    }

    /// The texels of a side that a component of the turned normal leads to.
    pub(super) fn side(&mut self, component: NodeId, name: &str) -> Pair {
        let place = self.along(component, name);
        let place = self.split(place, name);
        self.pair(place, self.image.size, name)
    }

    /// The addresses of a place among so many and the next in the memories of the even and of the odd ones.
    fn addresses(&mut self, place: NodeId, extent: u32, name: &str) -> [NodeId; 2] {
        let bits = Image::place_bits(extent) as i32;
        let one = self.b.constant(1, Format::unsigned(1, 0), "one");
        let next = self.b.add(place, one, &format!("{name}_next_exact"), "the next");
        // Beside the last one, which is odd, stands the even one before it.
        let next = self.b.clamp(next, 0, i128::from(extent) - 1, &format!("{name}_next"), "at most the last");
        [(next, "even"), (place, "odd")].map(|(of, parity)| {
            let high = Format::unsigned(bits, -1);
            let high = self.b.cast(of, high, HighBits::Unused, &format!("{name}_{parity}_high"), "its leading bits");
            self.b.scale(high, None, -1, &[-1], &format!("{name}_{parity}"), &format!("the {parity} one of both"))
        })
    }

    /// Where the texel of a place and the next lie, and the weight of the odd one.
    pub(super) fn pair(&mut self, Place { place, texel, weight }: Place, extent: u32, name: &str) -> Pair {
        let addresses = self.addresses(texel, extent, name);
        let bits = self.image.weight_bits as i32;
        let one = self.b.constant(1 << bits, Format::unsigned(1, bits), "whole");
        let other = self.b.sub(one, weight, &format!("{name}_other"), "the weight of the place itself");
        self.b.narrow(other, vec![bound(exp2(-bits), 1.0, bits)]);
        let last = Format::unsigned(1, 0);
        let is_odd = self.b.cast(texel, last, HighBits::Guarded, &format!("{name}_is_odd"), "its last bit");
        let odd = self.b.select(is_odd, [other, weight], |_| None, &format!("{name}_odd"), "the weight of the odd one");
        let weight = [is_odd, weight];
        self.joints.places.push(PlaceJoints { place, addresses, weight });
        Pair { addresses, odd, of: Some(weight) }
    }

    /// Where the texels of a light and a normal lie in each direction, the outermost first, in the band with an even
    /// number and in that with an odd one.
    fn pairs(&mut self, ports: &LightPorts, l: usize) -> Vec<[Pair; 2]> {
        let extents = self.image.extents();
        let odd = match self.b.bounds(ports.blend)[0].range.high {
            // A table gives no more.
            ..=1.0 => ports.blend,
            _ => self.b.at_most(ports.blend, 0, &format!("blend{l}"), "the weight of the odd band, at most 1"),
        };
        let band = if extents[0].is_power_of_two() {
            ports.band
        } else {
            let last = i128::from(extents[0]) - 1;
            self.b.clamp(ports.band, 0, last, &format!("band{l}_kept"), "at most the last")
        };
        let addresses = self.addresses(band, extents[0], &format!("band{l}"));
        let mut pairs = vec![[Pair { addresses, odd, of: None }; 2]];
        match self.image.form {
            ImageForm::Bivariate { octaves } => {
                let u = self.versine(&ports.frame[0], octaves, l);
                let axis = OctaveAxis { size: self.image.size, octave_bits: self.image.octave_bits(octaves) };
                let column = self.octave_column(u, axis, self.image.weight_bits as i32, "u", &l.to_string());
                pairs.push([self.pair(column, extents[1], &format!("column{l}")); 2]);
            }
            ImageForm::Half { .. } => {
                for (place, name) in [(1, "v"), (0, "u")] {
                    let component = self.across(&ports.frame[place], name, l);
                    pairs.push([self.side(component, &format!("{name}{l}")); 2]);
                }
            }
            ImageForm::Paper { .. } => {
                let y = self.across(&ports.frame[1], "v", l);
                pairs.push([self.side(y, &format!("v{l}")); 2]);
                pairs.push(self.turned(ports, y, l));
            }
            ImageForm::Matcap => unreachable!("a form without lights"),
        }
        pairs
    }

    /// The blend of an even and an odd one, exact but for what [`BLENDED`] says; `rank` is how many blends a multiplier
    /// is worth more for, if it is told how many there are.
    fn blend(&mut self, [a, c]: [NodeId; 2], pair: &Pair, rank: u32, name: &str, what: &str) -> NodeId {
        let [a, c] = [a, c].map(|code| {
            let cut = format!("{}_cut", self.b.name(code));
            self.b.floor(code, BLENDED, &cut, "rounded down to a multiplier's operand")
        });
        let by_multiplier = match self.image.blend_multipliers {
            Some(multipliers) => rank < multipliers,
            None => self.b.format(a).width() > BLENDED_BY_BITS,
        };
        let sum = if by_multiplier {
            let apart = self.b.sub(c, a, &format!("{name}_apart"), "the difference");
            let part = self.b.mul(apart, pair.odd, &format!("{name}_part"), "its part");
            self.b.add(a, part, name, what)
        } else {
            let bits = self.bits(pair);
            self.b.blend_by_bits([a, c], &bits, name, what)
        };
        // Between both.
        let most = 1.0 - exp2(-(self.image.texel_bits as i32));
        let grid = self.b.format(sum).frac_bits;
        self.b.narrow(sum, vec![bound(0.0, most, grid)]);
        sum
    }

    /// The weight of the odd one, from 0 to 1, as [`Builder::blend_by_bits`] takes it: of a weight w of the next the
    /// bits of w or, where the next is the even one, of 1 - w less the last bit's weight.
    fn bits(&mut self, &Pair { odd, of, .. }: &Pair) -> Rc<[NodeId]> {
        if let Some(known) = self.weights.get(&odd) {
            return Rc::clone(known);
        }
        let weight = of.map_or(odd, |[_, weight]| weight);
        let name = self.b.name(weight).to_owned();
        let parts = self.b.format(weight).frac_bits;
        let mut bit = |place: i32, name: &str| self.b.bit(weight, place - parts, name, "a bit of the weight");
        let first = of.map_or_else(|| bit(parts, &format!("{name}_whole")), |[is_odd, _]| is_odd);
        let places: Vec<NodeId> = (0..parts).map(|place| bit(place, &format!("{name}_bit_{place}"))).collect();
        let of_place = |(place, &bit): (usize, &NodeId)| {
            let name = format!("{name}_of_{place}");
            if of.is_none() {
                return self.b.flag(Op::Or, &[bit, first], &name, "1 where the weight is 1");
            }
            let up = parts - place as i32;
            let bit = self.b.scale(bit, None, up, &[up], &format!("{name}_flag"), "as a flag");
            let inverse = self.b.not(bit, &format!("{name}_not"), "it is 0");
            self.b.select(first, [inverse, bit], |_| None, &name, "whether it counts for the odd one")
        };
        let bits: Rc<[NodeId]> = std::iter::once(first).chain(places.iter().enumerate().map(of_place)).collect();
        self.weights.insert(odd, Rc::clone(&bits));
        bits
    }

    /// The address of the texel of these parities of its places.
    fn address(&mut self, pairs: &[[Pair; 2]], parities: &[usize], l: usize) -> NodeId {
        let extents = self.image.extents();
        let mut address = None;
        for ((pair, &parity), (extent, place)) in pairs.iter().zip(parities).zip(extents.iter().zip(1..)) {
            let own = pair[parities[0]].addresses[parity];
            address = Some(match address {
                None => own,
                Some(before) => {
                    let bits = Image::place_bits(*extent) as i32 - 1;
                    let known: String = parities[..place].iter().map(usize::to_string).collect();
                    let first = format!("texels{l}_{known}");
                    let first = self.b.scale(before, None, bits, &[bits], &first, "the first of them");
                    self.b.add(first, own, &format!("texel{l}_{known}"), "side by side")
                }
            });
        }
        address.expect("there are directions")
    }

    /// The blend of texels in all directions, the innermost first; `texels` are in the order of [`parities`], of the
    /// look-up of this number among those of all lights and channels.
    fn blended(&mut self, texels: Vec<NodeId>, pairs: &[[Pair; 2]], look_up: u32, name: &str) -> NodeId {
        let look_ups = 3 * self.image.look_ups() as u32;
        let mut left = texels;
        let of_bands = self.image.has_lights();
        for (pair, place) in pairs.iter().rev().zip(1..) {
            let what = if left.len() == 2 && of_bands { "two bands" } else { "two neighbours" };
            let (of_odd, count) = (left.len() / 4, left.len() as u32 / 2);
            let two = |(number, two): (usize, &[NodeId])| {
                // The texels of the odd band are the second half.
                let pair = &pair[usize::from(of_odd > 0 && number >= of_odd)];
                // The outermost blend the widest codes.
                let rank = (count - 1 + number as u32) * look_ups + look_up;
                self.blend([two[0], two[1]], pair, rank, &format!("{name}_{place}_{number}"), what)
            };
            left = left.chunks(2).enumerate().map(two).collect();
        }
        left[0]
    }

    /// What is blended of the texels at these places.
    pub(super) fn looked_up(&mut self, pairs: Vec<[Pair; 2]>, light: usize) -> LookUp {
        let parities = parities(pairs.len());
        let addresses = parities.iter().map(|parities| self.address(&pairs, parities, light + 1)).collect();
        LookUp { pairs, parities, addresses, light }
    }

    /// The blended code of a channel.
    pub(super) fn root(&mut self, LookUp { pairs, parities, addresses, light }: &LookUp, channel: usize) -> NodeId {
        let (l, c) = (light + 1, CHANNELS[channel]);
        let first = light * parities.len();
        let texel = |(number, parities): (usize, &Vec<usize>)| {
            self.b.field(first + number, addresses[number], fields(*light, parities)[channel])
        };
        let texels = parities.iter().enumerate().map(texel).collect();
        let look_up = (3 * light + channel) as u32;
        let root = self.blended(texels, pairs, look_up, &format!("blend{l}_{c}"));
        self.b.floor(root, self.widths.code, &format!("root{l}_{c}"), "the blended code")
    }

    /// What a light gives to the channels.
    fn light(&mut self, light: usize, ports: &LightPorts) -> [NodeId; 3] {
        let l = light + 1;
        let shift = self.shift(ports.shift, l);
        let incidence = ports.direction.map(|direction| self.incidence(direction, shift, l));
        let pairs = self.pairs(ports, l);
        let texels = self.looked_up(pairs, light);
        let ImageWidths { lit, square, term, .. } = self.widths;
        let mut squares = [0; 3];
        let terms = [0, 1, 2].map(|channel| {
            let c = CHANNELS[channel];
            let root = self.root(&texels, channel);
            let squared = self.b.mul(root, root, &format!("square{l}_{c}_exact"), "its square");
            let squared = self.b.floor(squared, square, &format!("square{l}_{c}"), "rounded down");
            // The gain last: what is rounded down before it is the less the dimmer the light, so that the roundings of
            // many dim lights are those of one that is as bright as all of them.
            let factor = if let Some(nl) = incidence {
                squares[channel] = squared;
                let factor = self.b.mul(nl, squared, &format!("lit{l}_{c}_exact"), "n.l times the square");
                self.b.floor(factor, lit, &format!("lit{l}_{c}"), "rounded down")
            } else {
                let name = format!("square{l}_{c}");
                let seen = self.b.zero_if(
                    Some(self.hidden),
                    squared,
                    &format!("{name}_seen"),
                    "0 for a normal that is turned away",
                );
                squares[channel] = self.shifted(seen, square, shift, &name);
                squares[channel]
            };
            let product = self.b.mul(factor, ports.gain[channel], &format!("light{l}_{c}_exact"), "times the gain");
            self.b.floor(product, term, &format!("light{l}_{c}"), "rounded down")
        });
        self.joints.lights.push(LightJoints { incidence, squares, full_gain: ports.full_gain });
        terms
    }
}

impl ImageBlock {
    /// The operations with their joints, or `None` if a value would be too wide for this crate.
    ///
    /// The inputs are n, and for each light its direction, the vectors of [`Image::frame`], the band, the blend, the
    /// shift where lights differ in it, and a gain a channel, or with [`FrontEnd::Vector`] its direction and an
    /// intensity a channel; the outputs are the sums of the three channels. In the form matcap the inputs are x and y
    /// of n, and the outputs are codes of the channels.
    #[must_use]
    pub fn datapath(&self) -> Option<(Datapath, Joints)> {
        let Self { image, widths, texels, .. } = self;
        let lights = image.lights as usize;
        let mut tables = banks(image, texels);
        let first = tables.len();
        tables.extend((0..lights).flat_map(|light| functions(image, texels, light)));
        // None of the form matcap, which has no lights.
        let functions_a_light = (tables.len() - first).checked_div(lights).unwrap_or_default();
        let case = Case { active: Interval::UNIT, shininess: 1.0, rows: vec![None; tables.len()] };
        let b = Builder::new(&tables, vec![case]);
        let joints = Joints::default();
        let (weights, widths) = (BTreeMap::new(), *widths);
        let mut imaging = Imaging {
            b,
            image,
            widths,
            normal: [0; 3],
            hidden: 0,
            functions: first,
            functions_a_light,
            weights,
            joints,
        };
        if !image.has_lights() {
            let outputs = imaging.matcap();
            let mut joints = imaging.joints;
            let graph = imaging.b.finish(&outputs, joints.nodes())?;
            return Some((Datapath { graph, tables, errors: Vec::new(), constants: Vec::new() }, joints));
        }
        let normal = imaging.vector("n", &AXES);
        imaging.normal = [normal[0], normal[1], normal[2]];
        let ports: Vec<LightPorts> = (1..=lights).map(|l| imaging.light_ports(l)).collect();
        imaging.hidden = imaging.hidden();
        let mut sums: Option<[NodeId; 3]> = None;
        for (light, ports) in ports.iter().enumerate() {
            let terms = imaging.light(light, ports);
            sums = Some(match sums {
                None => terms,
                Some(before) => [0, 1, 2].map(|channel| {
                    let name = format!("lights{}_{}", light + 1, CHANNELS[channel]);
                    imaging.b.add(before[channel], terms[channel], &name, "the lights so far")
                }),
            });
        }
        let sums = sums?;
        let outputs: Vec<(&str, NodeId)> =
            (0..3).map(|c| (parts::SUMS[c], parts::channel_sum(&mut imaging.b, sums[c], c, widths.term))).collect();
        let mut joints = imaging.joints;
        let graph = imaging.b.finish(&outputs, joints.nodes())?;
        Some((Datapath { graph, tables, errors: Vec::new(), constants: Vec::new() }, joints))
    }
}
