//! What an image-based block is asked with, and the widths that follow.

use super::Banks;
use crate::fixed::{Format, exp2};
use crate::reflectance::half;

/// What is stored of the reflectance, and how a light finds it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageForm {
    /// Over θh and θd: a row of texels for each θd, the columns along 1 - n·h.
    Bivariate {
        /// The columns of an octave of 1 - n·h, as a power of two; see [`super::OctaveAxis`].
        octave_bits: u32,
    },
    /// Slices about the half vector, one for each angle of the light.
    Half {
        /// How many: a power of two from 2 to 64.
        slices: u32,
    },
}

/// An image-based block.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// What is stored.
    pub form: ImageForm,
    /// Texels along either side: a power of two from 8 to 512.
    pub size: u32,
    /// Bits of a texel's channel, 4 to 10.
    pub texel_bits: u32,
    /// Fraction bits of the weights that texels are blended with, 3 to 8.
    pub weight_bits: u32,
    /// Fraction bits of the vectors' components, which are signed Q1.f.
    pub vector_fraction: u32,
    /// Bits of an output channel.
    pub channel_bits: u32,
    /// Lights, all of a sample at once.
    pub lights: u32,
}

/// The widths of an image-based block: fraction bits each, unless said otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ImageWidths {
    /// The greatest shift of a light: its gain is a fraction times two to the power of its shift.
    pub shift: i32,
    /// Integer bits of n·l 2^shift.
    pub lit_int: i32,
    /// Of n·l 2^shift, and of its product with the gain.
    pub lit: i32,
    /// Of a light's gain, which is below 1.
    pub gain: i32,
    /// 1 - n·h, as fine as the least octave's weights need.
    pub versine: i32,
    /// The blended code.
    pub code: i32,
    /// Its square.
    pub square: i32,
    /// What a light gives to a channel.
    pub term: i32,
}

/// The bits of a multiplier's operand in most families.
const OPERAND: i32 = 18;

impl ImageWidths {
    /// Bits of a light's shift.
    #[must_use]
    pub fn shift_bits(&self) -> i32 {
        (0..).find(|&bits| self.shift < 1 << bits).unwrap_or_default()
    }
}

impl Image {
    /// The greatest code of a channel: full scale.
    #[must_use]
    pub fn full_scale(&self) -> i64 {
        (1 << self.channel_bits) - 1
    }

    /// How many rows of texels, or slices, a light chooses two of, and the angles of the light in degrees that they are
    /// of.
    #[must_use]
    pub fn bands(&self) -> Vec<f64> {
        match self.form {
            ImageForm::Bivariate { .. } => crate::reflectance::bivariate::angles(self.size as usize),
            ImageForm::Half { slices } => half::angles(slices as usize),
        }
    }

    /// Along what texels lie, the outermost first: how many there are, each a power of two.
    #[must_use]
    pub fn extents(&self) -> Vec<u32> {
        match self.form {
            ImageForm::Bivariate { .. } => vec![self.size; 2],
            ImageForm::Half { slices } => vec![slices, self.size, self.size],
        }
    }

    /// The ports of a light beside its direction, number of the band, blend and gain: the names of vectors and of their
    /// components.
    #[must_use]
    pub fn frame(&self) -> &'static [(&'static str, &'static [char])] {
        match self.form {
            ImageForm::Bivariate { .. } => &[("h", &['x', 'y', 'z'])],
            ImageForm::Half { .. } => &[("u", &['x', 'y', 'z']), ("v", &['x', 'y'])],
        }
    }

    /// The format of a vector's component.
    #[must_use]
    pub fn vector(&self) -> Format {
        Format::signed(1, self.vector_fraction as i32)
    }

    /// The widths for these texels: operands of 18 bits wherever these do.
    ///
    /// Where light and viewer are on opposite sides a reflectance is in the thousands, and n·l of what both see as
    /// small; so a light's gain has an exponent, which n·l is shifted by.
    #[must_use]
    pub fn widths(&self, banks: &Banks) -> ImageWidths {
        let (weight, channel) = (self.weight_bits as i32, self.channel_bits as i32);
        let (mut shift, mut lit) = (0, 1.0f64);
        for phi in (0..720).map(|step| 0.25 * f64::from(step)) {
            let of_light = super::record::shift(super::record::gain(self, banks, phi));
            // n·l of a normal that light and viewer see.
            let incidence = if phi > 90.0 { libm::sin(phi.to_radians()) } else { 1.0 };
            (shift, lit) = (shift.max(of_light), lit.max(incidence * exp2(of_light)));
        }
        let lit_int = (0..).find(|&bits| lit <= exp2(bits)).unwrap_or_default();
        let blends = self.extents().len() as i32;
        let versine = match self.form {
            ImageForm::Bivariate { octave_bits } => (self.size >> octave_bits) as i32 - 1 + octave_bits as i32 + weight,
            ImageForm::Half { .. } => 0,
        };
        ImageWidths {
            shift,
            lit_int,
            lit: (OPERAND - lit_int).max(channel + 3),
            gain: OPERAND,
            versine,
            code: (self.texel_bits as i32 + blends * weight).min(OPERAND),
            square: OPERAND,
            term: channel + 3 + libm::ilogb(f64::from(2 * self.lights - 1)),
        }
    }
}
