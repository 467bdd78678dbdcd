//! The operations that make a light's record of the vector towards it; see [`super::front_end`].

use super::datapath::{Imaging, LightPorts, Place, bound};
use super::front_end::{
    AZIMUTH, AZIMUTH_OPERAND, AZIMUTH_SHIFT, AZIMUTH_TABLE, AZIMUTH_WEIGHT, BANDS_TABLE, HALF_ROOT, HALF_ROOT_INT,
    POLAR_TABLE, UNIT,
};
use super::{Image, ImageForm, StepJoints};
use crate::block::CHANNELS;
use crate::block::parts::{self, AXES};
use crate::datapath::builder::{Bound, HighBits};
use crate::datapath::graph::NodeId;
use crate::fixed::{Format, exp2};

/// Where a table is looked up: the row, and the weight of the next.
#[derive(Clone, Copy)]
struct Row {
    address: NodeId,
    weight: NodeId,
}

/// What the table of bands gives.
struct Blend {
    band: NodeId,
    odd: NodeId,
    shift: Option<NodeId>,
    gain: NodeId,
}

impl Imaging<'_, '_> {
    /// The record of a light that is told by a vector and an intensity.
    pub(super) fn computed_record(&mut self, l: usize) -> LightPorts {
        let direction = self.vector(&format!("l{l}"), &AXES);
        let intensity = CHANNELS.map(|c| self.b.port(self.widths.gain_format(), &format!("in_intensity{l}{c}")));
        let row = self.polar_row(direction[2], l);
        let frame = match self.image.form {
            ImageForm::Bivariate { .. } => vec![self.half_vector(&direction, row, l)],
            ImageForm::Half { .. } | ImageForm::Paper { .. } | ImageForm::Matcap => self.turn(&direction, row, l),
        };
        let Blend { band, odd, shift, gain } = self.bands(row, l);
        let most = self.widths.gain;
        let gains = [0, 1, 2].map(|channel| {
            let c = CHANNELS[channel];
            let part = self.b.at_most(intensity[channel], 0, &format!("intensity{l}_{c}"), "the intensity, at most 1");
            let product = self.b.mul(gain, part, &format!("gain{l}_{c}_exact"), "the gain of this intensity");
            self.b.floor(product, most, &format!("gain{l}_{c}"), "rounded down")
        });
        LightPorts {
            direction: Some([direction[0], direction[1], direction[2]]),
            frame,
            band,
            blend: odd,
            turns: None,
            shift,
            gain: gains,
            full_gain: Some(gain),
        }
    }

    /// A field at a row and its part of the way to the next, rounded down to the grid of its bounds, in which it lies
    /// because both rows' do.
    fn between(&mut self, [at, rise]: [NodeId; 2], row: Row, bounds: Bound, name: &str, what: &str) -> NodeId {
        let part = self.b.mul(rise, row.weight, &format!("{name}_part"), "its part of the rise");
        let sum = self.b.add(at, part, &format!("{name}_exact"), "between two rows");
        let value = self.b.floor(sum, bounds.grid, name, &format!("{what}, rounded down"));
        self.b.narrow(value, vec![bounds]);
        value
    }

    /// Says that these lie in their bounds because they do at each row.
    fn known_by_row(&mut self, Row { address, weight }: Row, to: Vec<NodeId>) {
        self.joints.steps.push(StepJoints { from: vec![address, weight], to, row: Some(1) });
    }

    /// The row of the polar angle.
    fn polar_row(&mut self, z: NodeId, l: usize) -> Row {
        let formats = self.image.front_end_formats();
        let none = self.b.constant(0, self.image.vector(), "none");
        let beyond = self.b.greater(none, z, &format!("beyond{l}"), "whether l.v < 0");
        let minus = self.b.sub(none, z, &format!("l{l}z_minus"), "-l.v");
        let magnitude = self.b.select(beyond, [minus, z], |_| None, &format!("l{l}z_magnitude"), "|l.v|");
        let one = self.b.constant(1, Format::unsigned(1, 0), "one");
        let versine = self.b.sub(one, magnitude, &format!("e{l}_exact"), "1 - |l.v|");
        let most = (1i128 << self.image.vector_fraction) - 1;
        let versine = self.b.clamp(versine, 0, most, &format!("e{l}_kept"), "1 - |l.v|, kept in [0, 1)");
        let Place { texel: column, weight, .. } =
            self.octave_column(versine, formats.polar, formats.polar_weight as i32, "e", &format!("{l}_polar"));
        let bits = formats.polar.size.ilog2() as i32;
        let first = format!("polar{l}_end");
        let first = self.b.scale(beyond, None, bits, &[bits], &first, "the first row of l.v >= 0, or of l.v < 0");
        let address = self.b.add(first, column, &format!("polar{l}_row"), "the row of the polar angle");
        self.joints.steps.push(StepJoints { from: vec![versine, beyond], to: vec![address, weight], row: None });
        Row { address, weight }
    }

    /// The half vector, from l + v and 1/√(2 + 2 l·v).
    fn half_vector(&mut self, direction: &[NodeId], row: Row, l: usize) -> Vec<NodeId> {
        let [_, _, root, rise] = self.fields(POLAR_TABLE, row.address, l);
        let name = format!("half_root_at{l}");
        let most = exp2(HALF_ROOT_INT) - exp2(-HALF_ROOT);
        let root = self.between([root, rise], row, bound(0.5, most, HALF_ROOT), &name, "1/sqrt(2 + 2 l.v)");
        self.known_by_row(row, vec![root]);
        let f = self.image.vector_fraction as i32;
        let one = self.b.constant(1, Format::unsigned(1, 0), "one");
        let sum = self.b.add(direction[2], one, &format!("lv{l}_exact"), "z of l + v");
        let sum = self.b.clamp(sum, 0, (2 << f) - 1, &format!("lv{l}"), "of unit vectors it is not negative, below 2");
        let most = 1i128 << f;
        [(direction[0], 'x'), (direction[1], 'y'), (sum, 'z')]
            .map(|(component, axis)| {
                let name = format!("h{l}{axis}");
                let product = self.b.mul(component, root, &format!("{name}_exact"), "a component of the half vector");
                let cut = self.b.floor(product, f, &format!("{name}_cut"), "rounded down");
                let least = if axis == 'z' { 0 } else { -most };
                self.b.clamp(cut, least, most, &name, "of a unit vector it is at most 1")
            })
            .to_vec()
    }

    /// The rows of the turn by -γ about z and -φ/2 about y.
    fn turn(&mut self, direction: &[NodeId], row: Row, l: usize) -> Vec<Vec<NodeId>> {
        let [_, _, cosine, cosine_rise, sine, sine_rise] = self.fields(POLAR_TABLE, row.address, l);
        let name = |what: &str| format!("half_{what}_at{l}");
        let unit = bound(0.0, 1.0, UNIT);
        let half_cosine = self.between([cosine, cosine_rise], row, unit, &name("cosine"), "cos(phi/2)");
        let unit = bound(-1.0, 0.0, UNIT);
        let half_sine = self.between([sine, sine_rise], row, unit, &name("sine"), "-sin(phi/2)");
        let found = vec![half_cosine, half_sine];
        self.known_by_row(row, found);
        let azimuth = self.azimuth([direction[0], direction[1]], l);
        let f = self.image.vector_fraction as i32;
        let [x, y] = [(azimuth[0], 'x'), (azimuth[1], 'y')].map(|(component, axis)| {
            let product = self.b.mul(component, half_cosine, &format!("u{l}{axis}_exact"), "times cos(phi/2)");
            self.b.floor(product, f, &format!("u{l}{axis}"), "rounded down")
        });
        let none = self.b.constant(0, self.image.vector(), "none");
        let minus = self.b.sub(none, azimuth[1], &format!("v{l}x_exact"), "-sin gamma");
        let [z, minus, plus] = [(half_sine, "uz"), (minus, "vx"), (azimuth[0], "vy")].map(|(component, port)| {
            let (vector, axis) = port.split_at(1);
            self.b.floor(component, f, &format!("{vector}{l}{axis}_cut"), "rounded down")
        });
        vec![vec![x, y, z], vec![minus, plus]]
    }

    /// The cosine and the sine of γ: l_x and l_y over the root of the sum of their squares; 1 and 0 where that is very
    /// small.
    fn azimuth(&mut self, across: [NodeId; 2], l: usize) -> [NodeId; 2] {
        let (bits, m) = (AZIMUTH_OPERAND.min(2 * self.image.vector_fraction as i32), AZIMUTH.octave_bits as i32);
        let sum = parts::dot(&mut self.b, &across, &across, Some(bits), &format!("across{l}"), "l_x^2 + l_y^2");
        let sum = self.b.clamp(sum, 0, (1 << bits) - 1, &format!("across{l}_kept"), "l_x^2 + l_y^2, below 1");
        let Place { texel: column, weight, .. } =
            self.octave_column(sum, AZIMUTH, AZIMUTH_WEIGHT as i32, "a", &format!("{l}_azimuth"));
        self.joints.steps.push(StepJoints { from: vec![sum], to: vec![column, weight], row: None });
        let has_azimuth = self.b.reaches(column, m, &format!("has_azimuth{l}"), "the exponent is not 0");
        let is_round = self.b.not(has_azimuth.expect("there are octaves"), &format!("round{l}"), "gamma is 0");
        let row = Format::unsigned(m + 1, 0);
        let row = self.b.cast(column, row, HighBits::Guarded, &format!("azimuth{l}_row"), "of either octave");
        let fields = self.fields(AZIMUTH_TABLE, row, l);
        let [root, fall] = fields;
        let part = self.b.mul(fall, weight, &format!("across_part{l}"), "its part");
        let root = self.b.sub(root, part, &format!("across_exact{l}"), "between two rows");
        let root = self.b.floor(root, UNIT, &format!("across_at{l}"), "rounded down");
        let high = Format::unsigned(AZIMUTH.size.ilog2() as i32, -m - 1);
        let high = self.b.cast(column, high, HighBits::Unused, &format!("azimuth{l}_high"), "two octaves each");
        let high = self.b.scale(high, None, -m - 1, &[-m - 1], &format!("azimuth{l}_pair"), "as a number");
        let most = self.b.constant(AZIMUTH_SHIFT.into(), Format::unsigned(3, 0), "most_shift");
        let shift = self.b.sub(most, high, &format!("azimuth{l}_shift"), "the exponent that is missing to 1/4");
        let f = self.image.vector_fraction as i32;
        let one = 1i128 << UNIT;
        let [cosine, sine] = [(across[0], "cosine"), (across[1], "sine")].map(|(component, what)| {
            let name = |part: &str| format!("gamma{l}_{what}_{part}");
            let up = self.b.scale(component, Some(shift), 0, &[AZIMUTH_SHIFT], &name("up"), "times two to it");
            let end = exp2(AZIMUTH_SHIFT + 1);
            self.b.assume(up, vec![bound(-end, end - exp2(-f), f)]);
            let up = self.b.clamp(up, -1 << f, 1 << f, &name("kept"), "of a unit vector it is at most 1");
            let product = self.b.mul(up, root, &name("exact"), "over the root");
            let product = self.b.floor(product, UNIT, &name("cut"), "rounded down");
            let frac_bits = self.b.format(product).frac_bits;
            let one = one >> (UNIT - frac_bits);
            self.b.clamp(product, -one, one, &name("whole"), "at most 1")
        });
        let one = self.b.constant(1, Format::unsigned(1, 0), "one");
        [
            self.b.select(is_round, [one, cosine], |_| None, &format!("gamma{l}_cosine"), "cos gamma"),
            self.b.zero_if(Some(is_round), sine, &format!("gamma{l}_sine"), "sin gamma"),
        ]
    }

    /// The place among the bands, and what is found there.
    fn bands(&mut self, row: Row, l: usize) -> Blend {
        let formats = self.image.front_end_formats();
        let (bands, bits, steps) = (formats.band as i32, formats.place as i32, formats.step_bits as i32);
        let [place, rise] = self.fields(POLAR_TABLE, row.address, l);
        // From 0 at l = v; at l = -v it is less than a band past the last one.
        let within = bound(0.0, exp2(bands) - exp2(-bits), bits);
        let found = self.between([place, rise], row, within, &format!("place_at{l}"), "the place among the bands");
        self.known_by_row(row, vec![found]);
        let last = (i128::from(self.image.extents()[0]) - 1) << bits;
        let place = self.b.clamp(found, 0, last, &format!("place_kept{l}"), "at most the last band");
        let whole = Format::unsigned(Image::place_bits(self.image.extents()[0]) as i32, 0);
        let band = self.b.cast(place, whole, HighBits::Unused, &format!("band_at{l}"), "the band at or below it");
        let address = Format::unsigned(bands, steps);
        let address = self.b.cast(place, address, HighBits::Unused, &format!("bands{l}_step"), "the step at it");
        let address = self.b.scale(address, None, steps, &[steps], &format!("bands{l}_row"), "its number");
        let past = Format::unsigned(-steps, bits);
        let past = self.b.cast(place, past, HighBits::Guarded, &format!("bands{l}_past"), "the place past it");
        let weight = self.b.scale(past, None, steps, &[steps], &format!("bands{l}_weight"), "as a part of a step");
        let has_shift = self.widths.shift > 0;
        let [odd, odd_rise, gain, gain_rise] = self.fields(BANDS_TABLE, address, l);
        let shift = has_shift.then(|| {
            let [_, _, _, _, shift] = self.fields(BANDS_TABLE, address, l);
            shift
        });
        let (row, format) = (Row { address, weight }, self.widths.gain_format());
        let within = bound(0.0, 1.0, self.image.weight_bits as i32);
        let what = "the weight of the odd band, with half of the last bit";
        let odd = self.between([odd, odd_rise], row, within, &format!("odd_at{l}"), what);
        let within = bound(0.0, format.value(format.max_code()), format.frac_bits);
        let gain = self.between([gain, gain_rise], row, within, &format!("gain_at{l}"), "the gain of intensity 1");
        let results = [band, odd, gain].into_iter().chain(shift).collect();
        let row = Some(1 << (bits - steps));
        self.joints.steps.push(StepJoints { from: vec![found], to: results, row });
        Blend { band, odd, shift, gain }
    }
}
