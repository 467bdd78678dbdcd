//! The image-based block: texels of a reflectance, looked up for every light of a sample and multiplied by n·l.
//!
//! What is stored are codes of `√(f/cap)`: over θh and θd, a row of texels and a cap for each θd
//! ([`ImageForm::Bivariate`]), or slices about the half vector, one for each angle of the light
//! ([`ImageForm::Half`]); or the same of the radiance of the unit sphere, lit from a few angles
//! ([`ImageForm::Paper`]), which holds n·l.
//! A matcap ([`ImageForm::Matcap`]) is the picture of a sphere with its light in it: codes of `√f`, f from 0 to 1, are
//! looked up where x and y of the normal say, blended and squared, and no light is told of.
//! A directional light has one θd for all normals, so that a light record names one of these *bands*, its blend with
//! the next, and a gain a channel: the light's intensity, both caps and the exposure, with an exponent. Of a sample are
//! left a scalar product, an address, the blend of neighbouring texels, its square and two products; in the form paper
//! a turn to each of both images in place of n·l. Texels lie in memories by the parities of their places, and all that
//! are blended are read in one clock.

mod datapath;
mod front_end;
mod joints;
mod matcap;
mod model;
mod options;
pub mod quality;
mod real;
mod record;
mod stored;
mod texels;
mod turn;
mod turned;
mod vector_light;
mod vector_model;

pub use front_end::FrontEndRows;
pub use joints::{Joints, LightJoints, PlaceJoints, StepJoints};
pub use model::ImageModel;
use options::{BLENDED, GAIN, GAIN_INT};
pub use options::{
    FrontEnd, IMAGES, Image, ImageForm, ImageSource, ImageSpec, ImageWidths, OCTAVES, SIZE, SLICES, TEXEL_BITS,
    TEXEL_LATENCY, TexelMemory, WEIGHT_BITS,
};
pub use real::{Places, RealLight, RealTexels};
pub use record::{FixedLight, LightRecord, RecordBand, RecordTable};
pub use stored::{ImageFile, ImageSamples};
pub(crate) use stored::{PICTURE, no_picture};
pub use texels::OctaveAxis;

use crate::block::lights::Sums;
use crate::fixed::{Table, exp2};
use crate::platform::error::{Error, refuse};
use crate::reflectance::texels::{Samples, Texels};
use crate::reflectance::{Form, Reflectance};

/// The most that a light may be shifted by.
const MOST_SHIFT: i32 = 32;

/// An image-based block of a reflectance: its texels, and the widths that follow.
#[derive(Clone, Debug)]
pub struct ImageBlock {
    image: Image,
    widths: ImageWidths,
    /// What the texels are of, times the exposure.
    samples: Samples,
    texels: Texels,
    /// The tables of functions of a light, in the order in which its datapath has them; see [`functions`].
    functions: Vec<Table>,
    records: RecordTable,
}

impl ImageBlock {
    /// The block of a reflectance times an exposure.
    ///
    /// # Errors
    /// What [`Image::check`] refuses, and an exposure with which a light would need a gain of more than 2^32.
    pub fn new(image: Image, reflectance: &dyn Reflectance, exposure: f64) -> Result<Self, Error> {
        image.check()?;
        let samples = texels::samples(&image, reflectance, exposure);
        Self::of_samples(image, samples, exposure)
    }

    /// The block of a matcap's picture times an exposure.
    ///
    /// # Errors
    /// As [`ImageBlock::new`], and what [`ImageSamples::of_picture`] refuses.
    pub fn of_picture(image: Image, picture: &Form, exposure: f64) -> Result<Self, Error> {
        image.check()?;
        let stored = ImageSamples::of_picture(&image, picture, exposure, "the picture")?;
        Self::of_samples(image, stored.samples().clone(), exposure)
    }

    /// The block that a spec asks for.
    ///
    /// # Errors
    /// As [`ImageBlock::new`].
    pub fn of(ImageSpec { image, source, exposure }: &ImageSpec) -> Result<Self, Error> {
        match source {
            ImageSource::Model(model) => Self::new(image.clone(), model, *exposure),
            ImageSource::Samples(stored) => {
                image.check()?;
                Self::of_samples(image.clone(), stored.samples().clone(), *exposure)
            }
        }
    }

    fn of_samples(image: Image, samples: Samples, exposure: f64) -> Result<Self, Error> {
        let samples = texels::of_all_bands(&image, samples);
        let texels = texels::encoded(&image, &samples);
        let gain = |band: usize| record::gain(&image, texels.weight(band));
        refuse!(
            !(0..texels.caps().len()).all(|band| gain(band) < exp2(MOST_SHIFT)),
            format!("exposure = {exposure} is too great: a light would need a gain of more than 2^{MOST_SHIFT}"),
            "a smaller exposure; by default it is 0.6 over the 90th percentile of a lit sphere"
        );
        let functions = functions(&image, &texels, 0);
        let widths = ImageWidths::new(&image, &texels);
        let records = RecordTable::new(&image, &widths, &texels);
        Ok(Self { image, widths, samples, texels, functions, records })
    }

    /// What was asked for.
    #[must_use]
    pub fn image(&self) -> &Image {
        &self.image
    }

    /// Its widths.
    #[must_use]
    pub fn widths(&self) -> &ImageWidths {
        &self.widths
    }

    /// Its texels: bands, each with its cap.
    #[must_use]
    pub fn texels(&self) -> &Texels {
        &self.texels
    }

    /// What its texels are of, times the exposure: before they are coded.
    #[must_use]
    pub fn samples(&self) -> &Samples {
        &self.samples
    }

    /// Whether it is the block of a reflectance times an exposure: its texels are of the same samples.
    #[must_use]
    pub fn is_of(&self, reflectance: &dyn Reflectance, exposure: f64) -> bool {
        texels::samples(&self.image, reflectance, exposure) == self.samples
    }

    /// What comes out of its core, and is made codes of; none of the form matcap, of whose core come codes.
    #[must_use]
    pub fn sums(&self) -> Option<Sums> {
        let frac_bits = self.widths.term as u32;
        self.image.has_lights().then_some(Sums { frac_bits, ambient: None, channel_bits: self.image.channel_bits })
    }

    /// The keys of the rows of the tables that a normal is turned by in the form paper: 1 - y², of reciprocal roots,
    /// and angles in right angles, of sines.
    #[must_use]
    pub fn turn_rows(&self) -> Option<[&[f64]; 2]> {
        let [roots, sines, ..] = &self.functions[..] else { return None };
        self.image.has_turns().then_some([&roots.keys, &sines.keys])
    }

    /// Where the rows of the tables of the front end lie, of a block that has one.
    #[must_use]
    pub fn front_end_rows(&self) -> Option<FrontEndRows> {
        (self.image.front_end == FrontEnd::Vector).then(|| front_end::rows(&self.functions))
    }

    /// The bit-exact reference.
    #[must_use]
    pub fn model(&self) -> ImageModel<'_> {
        ImageModel::new(&self.image, self.widths, &self.texels, &self.functions)
    }
}

/// The tables of functions of a light, counted from 0: in the form paper of its turns, and of what a record is computed
/// by.
fn functions(image: &Image, texels: &Texels, light: usize) -> Vec<Table> {
    match image.front_end {
        FrontEnd::Vector => front_end::tables(image, texels, light),
        FrontEnd::Record if image.has_turns() => turn::tables(light),
        FrontEnd::Record => Vec::new(),
    }
}
