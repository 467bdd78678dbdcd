//! A light's record in bits, as its ports tell it or as it is made of the vector towards the light; see
//! [`super::front_end`].

use super::front_end::{
    AZIMUTH, AZIMUTH_OPERAND, AZIMUTH_SHIFT, AZIMUTH_TABLE, AZIMUTH_WEIGHT, BANDS_TABLE, HALF_ROOT, POLAR_TABLE, UNIT,
};
use super::model::{Place, floor, split};
use super::{FrontEnd, ImageForm, ImageModel, LightRecord};
use crate::fixed::wide::{self, Wide};

impl ImageModel<'_> {
    /// The record of the light whose ports have these codes, in the formats of a core that is told it.
    #[must_use]
    pub fn record(&self, light: &[i64]) -> LightRecord {
        match self.image.front_end {
            FrontEnd::Record => self.told_record(light),
            FrontEnd::Vector => {
                let (direction, intensity) = light.split_first_chunk().expect("a vector");
                self.record_of_vector(*direction, intensity)
            }
        }
    }

    fn told_record(&self, light: &[i64]) -> LightRecord {
        let image = self.image;
        let (direction, rest) = light.split_at(if image.has_incidence() { 3 } else { 0 });
        let (frame, rest) = rest.split_at(image.frame().iter().map(|(_, axes)| axes.len()).sum());
        let ([band, blend], rest) = rest.split_first_chunk().expect("a band and a blend");
        let (turns, rest) = rest.split_at(if image.has_turns() { 3 } else { 0 });
        let (shift, gain) = rest.split_at(usize::from(self.widths.shift > 0));
        LightRecord {
            direction: direction.try_into().ok(),
            frame: frame.to_vec(),
            band: *band,
            blend: *blend,
            turns: turns.try_into().ok(),
            shift: shift.first().copied(),
            gain: gain.try_into().expect("a gain a channel"),
        }
    }

    /// A field at a place between two rows, rounded down.
    fn at(&self, table: usize, place: Place, field: usize, bits: i32) -> Wide {
        let [at, rise] = Self::between(&self.functions[table], place, field);
        floor(at + rise, bits)
    }

    fn record_of_vector(&self, direction: [i64; 3], intensity: &[i64]) -> LightRecord {
        let f = self.image.vector_fraction;
        let formats = self.image.front_end_formats();
        let number = |code: i64| wide::from_code(code.into(), f);
        let z = number(direction[2]);
        let versine = (Wide::ONE - z.abs()).clamp(Wide::ZERO, Wide::ONE - wide::from_code(1, f));
        let (column, weight) = Self::octave_column(versine, formats.polar, formats.polar_weight);
        let polar = (if z < 0 { formats.polar.size as usize } else { 0 } + column, weight);
        let code = |value: Wide| wide::to_code(value, f) as i64;
        let frame = match self.image.form {
            ImageForm::Bivariate { .. } => {
                let root = self.at(POLAR_TABLE, polar, 2, HALF_ROOT);
                let two = Wide::from_num(2) - wide::from_code(1, f);
                let sum = (z + Wide::ONE).clamp(Wide::ZERO, two);
                let of = |component: Wide| code((component * root).clamp(-Wide::ONE, Wide::ONE));
                vec![of(number(direction[0])), of(number(direction[1])), of(sum)]
            }
            ImageForm::Half { .. } | ImageForm::Paper { .. } | ImageForm::Matcap => {
                let [cosine, sine] = [2, 4].map(|field| self.at(POLAR_TABLE, polar, field, UNIT));
                let [x, y] = self.azimuth([direction[0], direction[1]]);
                vec![code(x * cosine), code(y * cosine), code(sine), code(-y), code(x)]
            }
        };
        let last = Wide::from_num(self.image.extents()[0] - 1);
        let place = self.at(POLAR_TABLE, polar, 0, formats.place as i32).min(last);
        let steps = wide::to_code(place, formats.place) as usize;
        let row = split(steps, formats.place - formats.step_bits);
        let gain = self.at(BANDS_TABLE, row, 2, self.widths.gain);
        let gain_bits = self.widths.gain as u32;
        let of_intensity = |&code: &i64| {
            let part = wide::from_code(code.into(), gain_bits).min(Wide::ONE);
            wide::to_code(gain * part, gain_bits) as i64
        };
        let gains: Vec<i64> = intensity.iter().map(of_intensity).collect();
        LightRecord {
            direction: Some(direction),
            frame,
            band: place.to_num(),
            blend: wide::to_code(self.at(BANDS_TABLE, row, 0, self.image.weight_bits as i32), self.image.weight_bits)
                as i64,
            turns: None,
            shift: (self.widths.shift > 0).then(|| self.functions[BANDS_TABLE].fields[4].codes[row.0] as i64),
            gain: gains.try_into().expect("an intensity a channel"),
        }
    }

    /// The cosine and the sine of the azimuth of a vector with these components.
    fn azimuth(&self, across: [i64; 2]) -> [Wide; 2] {
        let f = self.image.vector_fraction;
        let bits = (AZIMUTH_OPERAND as u32).min(2 * f);
        let sum = self.product(&across, &across, bits as i32).min(Wide::ONE - wide::from_code(1, bits));
        let columns = 1usize << AZIMUTH.octave_bits;
        let (column, weight) = Self::octave_column(sum, AZIMUTH, AZIMUTH_WEIGHT);
        if column < columns {
            return [Wide::ONE, Wide::ZERO];
        }
        let [root, fall] = Self::between(&self.functions[AZIMUTH_TABLE], (column % (2 * columns), weight), 0);
        let root = floor(root - fall, UNIT);
        let shift = AZIMUTH_SHIFT as usize - column / (2 * columns);
        across.map(|code| {
            let up = (wide::from_code(code.into(), f) << shift).clamp(-Wide::ONE, Wide::ONE);
            floor(up * root, UNIT).clamp(-Wide::ONE, Wide::ONE)
        })
    }
}
