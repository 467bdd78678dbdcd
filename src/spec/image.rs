//! The keys of an image-based block: what they say, and back.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::image_size::PictureBudget;
use super::{Block, BlockKind, CoreSpec, ReflectanceFields, RomStyle, ShaderFields, SpecFields};
use crate::block::image::{FrontEnd, IMAGES, Image, ImageForm, ImageSource, ImageSpec, TEXEL_LATENCY, TexelMemory};
use crate::block::lights::DEFAULT_MOST_LIGHTS;
use crate::block::shader::{CHANNEL_BITS, VECTOR_FRACTION};
use crate::method::keys::Fields;
use crate::method::within;
use crate::platform::error::{Error, refuse};
use crate::reflectance::Model;
use crate::reflectance::form::FormKind;

/// What is stored of a reflectance, by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum ImageFormName {
    /// Slices about the half vector, one for each angle of the light.
    Half,
    /// The mean over the azimuth about the half vector: a row for each angle of the light.
    Bivariate,
    /// Pictures of the unit sphere, lit from a few angles.
    Paper,
    /// One picture of a sphere with its light in it: a matcap.
    Matcap,
}

/// Where its keys apply, as their table says it.
const APPLIES: &str = "image-based blocks";
/// Where the keys of lights in sequence apply.
const APPLIES_TO_LIGHTS: &str = "shaders and image-based blocks";
/// The keys that any core may have.
const OF_ALL: [&str; 9] = [
    "name",
    "block",
    "rom_formats",
    "pipeline",
    "languages",
    "vhdl_ports",
    "axi_stream",
    "tuser_bits",
    "golden_inputs",
];
/// When texels outside of the core come where nothing is said: as from a block RAM with a register at its output.
const DEFAULT_TEXEL_LATENCY: u32 = 2;
/// The bits before the point of a vector's component, its sign included.
const BEFORE_POINT: u32 = 2;

impl SpecFields {
    /// Refuses a key that its block has no use for.
    pub(super) fn check_block(&self) -> Result<(), Error> {
        let is_image = self.block == Some(BlockKind::Image);
        let has_lights = self.block.is_some_and(|block| block != BlockKind::Lobe);
        let given = self.values().into_iter().filter(|(_, value)| value.is_some()).map(|(key, _)| key);
        let misplaced = given.into_iter().find(|key| {
            if key.applies == APPLIES_TO_LIGHTS {
                return !has_lights;
            }
            let of_image = key.applies == APPLIES;
            if is_image { !of_image && !OF_ALL.contains(&key.name) } else { of_image }
        });
        match misplaced {
            None => Ok(()),
            Some(key) if key.name == "rom" => Err(Error::input(
                "rom is given for an image-based block",
                "its memories hold texels: texels = \"rom\", \"writable\" or \"external\"",
            )),
            Some(key) if is_image => Err(Error::input(
                format!("{} is given for an image-based block", key.flag().replace('-', "_")),
                "leave it out: the block has neither a lobe nor materials",
            )),
            Some(key) => Err(Error::input(
                format!("{} is given, which is for {}", key.flag().replace('-', "_"), key.applies),
                "use --block image, or leave it out",
            )),
        }
    }

    /// The block with a stand-in for what reflects, and no budget for its pictures.
    pub(super) fn image_of_stand_in(&self) -> Result<ImageSpec, Error> {
        let model = Model::named("lambert")?;
        Ok(ImageSpec { image: self.image()?, source: ImageSource::Model(model), exposure: 1.0 })
    }

    /// The image-based block: with `min_psnr` or `max_error` the smallest that keeps them.
    pub(super) fn resolved_image(&self) -> Result<ImageSpec, Error> {
        let budget = PictureBudget { min_psnr: self.min_psnr, max_error: self.max_error };
        let image = if budget.is_empty() { self.image()? } else { self.smallest_image(budget)? };
        let (source, exposure) = self.reflectance.resolve(&image)?;
        Ok(ImageSpec { image, source, exposure })
    }

    /// What the block is asked with.
    pub(super) fn image(&self) -> Result<Image, Error> {
        let form = self.resolved_form()?;
        let vector = BEFORE_POINT + VECTOR_FRACTION.start()..=BEFORE_POINT + VECTOR_FRACTION.end();
        let vector_bits = within("vector_bits", self.vector_bits.unwrap_or(18), vector)?;
        let channel_bits = self.output_bits.unwrap_or(8);
        refuse!(
            !CHANNEL_BITS.contains(&channel_bits),
            format!("output_bits = {channel_bits} is not offered"),
            "8, 10 or 12"
        );
        let default_weight_bits = match form {
            ImageForm::Paper { .. } => 6,
            ImageForm::Half { .. } | ImageForm::Bivariate { .. } | ImageForm::Matcap => 5,
        };
        let default_size = if form == ImageForm::Matcap { 64 } else { 32 };
        let [lights, most_lights] = match form {
            ImageForm::Matcap => [0; 2],
            _ => [self.lights_a_clock.unwrap_or(1), self.most_lights.unwrap_or(DEFAULT_MOST_LIGHTS)],
        };
        let image = Image {
            form,
            size: self.image_size.unwrap_or(default_size),
            texel_bits: self.texel_bits.unwrap_or(8),
            weight_bits: self.weight_bits.unwrap_or(default_weight_bits),
            vector_fraction: vector_bits - BEFORE_POINT,
            channel_bits,
            lights,
            most_lights,
            front_end: self.front_end.unwrap_or_default(),
            blend_multipliers: self.blend_multipliers,
        };
        image.check()?;
        Ok(image)
    }

    fn resolved_form(&self) -> Result<ImageForm, Error> {
        let name = self.image_form.unwrap_or(ImageFormName::Half);
        refuse!(
            self.octaves.is_some() && name != ImageFormName::Bivariate,
            format!(
                "octaves are given for {}",
                match name {
                    ImageFormName::Half => "slices",
                    ImageFormName::Matcap => "a matcap",
                    ImageFormName::Bivariate | ImageFormName::Paper => "sphere images",
                }
            ),
            "they are of --image-form bivariate"
        );
        refuse!(
            self.angles.is_some() && name != ImageFormName::Paper,
            "angles are given for a form whose angles are fixed",
            "leave them out, or use --image-form paper"
        );
        Ok(match name {
            ImageFormName::Half => ImageForm::Half { slices: self.images.unwrap_or(16) },
            ImageFormName::Matcap => {
                refuse!(self.images.is_some(), "images are given for a matcap", "leave it out: a matcap is one");
                self.check_no_lights()?;
                ImageForm::Matcap
            }
            ImageFormName::Bivariate => {
                refuse!(
                    self.images.is_some(),
                    "images are given for the form bivariate",
                    "it has as many rows as columns: give image_size, or use --image-form half"
                );
                ImageForm::Bivariate { octaves: self.octaves.unwrap_or(8) }
            }
            ImageFormName::Paper => {
                let angles = match (&self.angles, self.images) {
                    (Some(_), Some(_)) => {
                        return Err(Error::input(
                            "images and angles are given",
                            "give angles, or how many images there are",
                        ));
                    }
                    (Some(angles), None) => angles.clone(),
                    (None, images) => FormKind::Paper.angles(within("images", images.unwrap_or(6), IMAGES)? as usize),
                };
                ImageForm::Paper { angles }
            }
        })
    }

    /// Refuses keys of lights, for a form that has its light in its picture.
    fn check_no_lights(&self) -> Result<(), Error> {
        let keys = [
            ("lights_a_clock", self.lights_a_clock.is_some()),
            ("most_lights", self.most_lights.is_some()),
            ("light_source", self.light_source.is_some()),
            ("light_records", self.light_records.is_some()),
            ("front_end", self.front_end.is_some()),
        ];
        match keys.into_iter().find(|(_, given)| *given) {
            None => Ok(()),
            Some((key, _)) => Err(Error::input(
                format!("{key} is given for a matcap"),
                "leave it out: a matcap's light is in its picture, or use another --image-form",
            )),
        }
    }

    /// Where the words of the block's memories come from: the texels of an image-based block are never in the source.
    pub(super) fn resolved_rom(&self, block: &Block) -> RomStyle {
        match (block, self.texels) {
            (Block::Image(_), Some(TexelMemory::Writable)) => RomStyle::Writable,
            (Block::Image(_), _) => RomStyle::File,
            _ => self.rom.unwrap_or(RomStyle::Inline),
        }
    }

    /// When texels come that lie outside of the core.
    pub(super) fn resolved_texel_latency(&self) -> Result<Option<u32>, Error> {
        let is_external = self.texels == Some(TexelMemory::External);
        refuse!(
            self.texel_latency.is_some() && !is_external,
            "texel_latency is given for texels in the core",
            "give texels = \"external\" as well, or leave texel_latency out"
        );
        let clocks = self.texel_latency.unwrap_or(DEFAULT_TEXEL_LATENCY);
        is_external.then(|| within("texel_latency", clocks, TEXEL_LATENCY)).transpose()
    }

    /// Whether there are two sets of texels.
    pub(super) fn resolved_swap(&self) -> Result<bool, Error> {
        let swap = self.swap.unwrap_or(false);
        refuse!(
            swap && self.texels != Some(TexelMemory::Writable),
            "swap is given for texels that are not written",
            "give texels = \"writable\" as well, or leave swap out"
        );
        refuse!(
            swap && self.image_form == Some(ImageFormName::Matcap),
            "swap is given for a matcap, whose samples have no last light",
            "leave swap out: a matcap's texels may be written between two pictures"
        );
        Ok(swap)
    }

    /// With what an image-based block is given.
    pub(super) fn with_image(self, ImageSpec { image, source, exposure }: &ImageSpec, spec: &CoreSpec) -> Self {
        let mut octaves = None;
        let mut angles = None;
        let (form, images) = match &image.form {
            ImageForm::Half { slices } => (ImageFormName::Half, Some(*slices)),
            ImageForm::Bivariate { octaves: count } => {
                octaves = Some(*count);
                (ImageFormName::Bivariate, None)
            }
            ImageForm::Paper { angles: listed } => {
                let even = FormKind::Paper.angles(listed.len()) == *listed;
                angles = (!even).then(|| listed.clone());
                (ImageFormName::Paper, even.then_some(listed.len() as u32))
            }
            ImageForm::Matcap => (ImageFormName::Matcap, None),
        };
        Self {
            block: Some(BlockKind::Image),
            rom: None,
            shader: ShaderFields::default(),
            image_form: Some(form),
            images,
            angles,
            octaves,
            image_size: Some(image.size),
            texel_bits: Some(image.texel_bits),
            weight_bits: Some(image.weight_bits),
            blend_multipliers: image.blend_multipliers,
            vector_bits: Some(image.vector_fraction + BEFORE_POINT),
            output_bits: Some(image.channel_bits),
            lights_a_clock: image.has_lights().then_some(image.lights),
            most_lights: image.has_lights().then_some(image.most_lights),
            front_end: Some(image.front_end).filter(|&front_end| front_end != FrontEnd::default()),
            texels: Some(match (spec.texel_latency, spec.rom) {
                (Some(_), _) => TexelMemory::External,
                (None, RomStyle::Writable) => TexelMemory::Writable,
                (None, _) => TexelMemory::Rom,
            }),
            texel_latency: spec.texel_latency,
            swap: spec.swap.then_some(true),
            reflectance: ReflectanceFields::of(source, *exposure),
            ..self
        }
    }
}

/// What an image-based block is called whose spec has no name.
pub(super) fn default_name(image: &Image) -> String {
    let form = match image.form {
        ImageForm::Half { .. } => "half",
        ImageForm::Bivariate { .. } => "bivariate",
        ImageForm::Paper { .. } => "paper",
        ImageForm::Matcap => "matcap",
    };
    format!("image_{form}")
}
