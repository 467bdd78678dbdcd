//! The samples of a reflectance that came from a file: what a block is made of where no model is given, and what its
//! core keeps, so that it can be made again without the file.

use std::path::Path;
use std::sync::Arc;

use sha2::{Digest, Sha256};

use super::{Image, ImageForm, SIZE, SLICES, texels};
use crate::platform::error::{Error, refuse};
use crate::reflectance::paper::{Border, Options};
use crate::reflectance::texels::Samples;
use crate::reflectance::{
    Form, FormKind, FormSpec, Lookup, Reflectance, Source, Texel, directory, half, matcap, measure,
};

/// What a matcap is read from, in words.
pub(crate) const PICTURE: &str = "a picture of a sphere that touches its sides, as PNG or OpenEXR";

/// Says of a model or a table that no matcap is made of it.
pub(crate) fn no_picture(name: &str) -> Error {
    Error::input(
        format!("{name} is a reflectance, and a matcap is made of a picture, which has its light in it"),
        format!("give --reflectance-file with {PICTURE}, or use another --image-form"),
    )
}

/// A file that is to be made a block of.
#[derive(Clone, Copy, Debug)]
pub struct ImageFile<'a> {
    /// A MERL table, a directory of sphere images, or for the form matcap a picture.
    pub path: &'a Path,
    /// How a table is looked up.
    pub lookup: Option<Lookup>,
    /// The exposure, above 0; otherwise a table's as [`measure::exposure`] has it, that of images their own, and 1 of a
    /// picture.
    pub exposure: Option<f64>,
    /// The digest that the file's samples are to have.
    pub digest: Option<&'a str>,
}

/// Samples of a reflectance times an exposure, in 32 bits each, where a block's texels lie.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageSamples {
    samples: Samples,
    digest: String,
}

impl ImageSamples {
    /// The samples for a block, and their exposure.
    ///
    /// # Errors
    /// A file that cannot be read or is none of these, or not what the block's form is made of; images that do not fit
    /// the block, with those that would; samples of another digest than is asked for, or too large for 32 bits.
    pub fn open(image: &Image, file: &ImageFile<'_>) -> Result<(Arc<Self>, f64), Error> {
        let name = file.path.display().to_string();
        refuse!(
            !file.path.exists(),
            format!("there is no file or directory {name}"),
            "a MERL table, a directory of sphere images, or a picture for the form matcap; in a spec file its path \
             starts from there, and what a core is made of lies beside its core.toml"
        );
        let (stored, exposure) = if file.path.is_dir() {
            let (form, octaves) = directory::read_with_octaves(file.path)?;
            refuse!(
                file.lookup.is_some(),
                format!("lookup is given, and {name} holds images"),
                "leave it out: it is for tables"
            );
            check_fit(image, &form, octaves, &name)?;
            (Self::new(image, form.texels.samples(), form.exposure)?, form.exposure)
        } else {
            match Source::open(file.path, file.lookup.unwrap_or_default())? {
                Source::Images(form) => {
                    refuse!(
                        file.lookup.is_some(),
                        format!("lookup is given, and {name} is a picture"),
                        "leave it out: it is for tables"
                    );
                    let exposure = file.exposure.unwrap_or(1.0);
                    (Self::of_picture(image, &form, exposure, &name)?, exposure)
                }
                Source::Table(_) if image.form == ImageForm::Matcap => return Err(no_picture(&name)),
                Source::Table(table) => {
                    let exposure = file.exposure.unwrap_or_else(|| measure::exposure(&table));
                    (Self::new(image, texels::samples(image, &table, exposure), exposure)?, exposure)
                }
                Source::Model(_) => unreachable!("a file holds no model"),
            }
        };
        if let Some(digest) = file.digest.filter(|digest| *digest != stored.digest) {
            return Err(Error::input(
                format!("the samples of {name} have the digest {}, and not {digest}", stored.digest),
                "the files were changed since the core was made: restore them, or leave `digest` out to make another",
            ));
        }
        match file.exposure.filter(|asked| *asked != exposure) {
            None => Ok((Arc::new(stored), exposure)),
            Some(asked) => {
                let mut samples = stored.samples;
                let factor = asked / exposure;
                samples.data.iter_mut().flatten().for_each(|value| *value = (f64::from(*value) * factor) as f32);
                Ok((Arc::new(Self::new(image, samples, asked)?), asked))
            }
        }
    }

    /// The samples of a matcap's picture for a block of that form, times an exposure: its means over the texels. `name`
    /// is the picture's, for messages.
    ///
    /// # Errors
    /// A block of another form or with more texels along a side than the picture has pixels; samples that are too large
    /// for 32 bits.
    pub fn of_picture(image: &Image, form: &Form, exposure: f64, name: &str) -> Result<Self, Error> {
        refuse!(
            image.form != ImageForm::Matcap,
            format!(
                "{name} is a picture, a matcap, and the form {} is made of a reflectance",
                form_spec(image).kind.name()
            ),
            "use --image-form matcap, or give a MERL table, or a directory as `brdfgen reflectance images` writes it"
        );
        let (size, pixels) = (image.size as usize, form.spec.size);
        refuse!(
            size > pixels,
            format!("image_size = {size} is more than the {pixels} × {pixels} pixels of {name}"),
            match 1 << pixels.ilog2() {
                fits if SIZE.contains(&fits) => format!("at most {fits} for this picture"),
                _ => format!("a picture of at least {0} × {0} pixels", SIZE.start()),
            }
        );
        Self::new(image, matcap::samples(form, size, exposure), exposure)
    }

    /// The samples of a reflectance for a block, times an exposure.
    ///
    /// # Errors
    /// Samples that are too large for 32 bits.
    pub fn of(image: &Image, reflectance: &dyn Reflectance, exposure: f64) -> Result<Arc<Self>, Error> {
        Self::new(image, texels::samples(image, reflectance, exposure), exposure).map(Arc::new)
    }

    fn new(image: &Image, mut samples: Samples, exposure: f64) -> Result<Self, Error> {
        refuse!(
            !samples.data.iter().flatten().all(|value| value.is_finite()),
            format!("a sample is too large for 32 bits at the exposure {exposure}"),
            "a smaller exposure"
        );
        // No reflectance is negative, but a picture may be; and no zero has a sign, so that equal samples have one
        // digest.
        let plain = |value: &mut f32| *value = if *value > 0.0 { *value } else { 0.0 };
        samples.data.iter_mut().flatten().for_each(plain);
        let FormSpec { kind, angles, size, .. } = form_spec(image);
        let header = format!("{} {angles:?} {size} {:?} {exposure:?}", kind.name(), octaves(image));
        let mut hash = Sha256::new_with_prefix(header);
        samples.data.iter().flatten().for_each(|value| hash.update(value.to_le_bytes()));
        let digest = hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(Self { samples, digest })
    }

    /// The samples: a layer for each band of slices, or one whose rows are the bands.
    #[must_use]
    pub fn samples(&self) -> &Samples {
        &self.samples
    }

    /// The SHA-256 of the samples, what they are of and their exposure, in hexadecimal digits.
    #[must_use]
    pub fn digest(&self) -> &str {
        &self.digest
    }

    /// The files of a directory from which [`ImageSamples::open`] reads the same samples: images with 32 bits a channel
    /// and their index.
    ///
    /// # Errors
    /// As [`directory::images`].
    pub fn files(&self, image: &Image, exposure: f64) -> Result<Vec<(String, Vec<u8>)>, Error> {
        directory::images(&form_spec(image).encode(&self.samples, exposure), octaves(image))
    }
}

impl std::fmt::Display for Image {
    /// The form with its images, size and bits of a texel's channel.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let FormSpec { kind, angles, size, .. } = form_spec(self);
        let images = if angles.len() > 1 { format!("{}×", angles.len()) } else { String::new() };
        write!(f, "{} {images}{size}², {} bits", kind.name(), self.texel_bits)
    }
}

/// The octaves that columns lie along.
fn octaves(image: &Image) -> Option<u32> {
    match image.form {
        ImageForm::Bivariate { octaves } => Some(octaves),
        ImageForm::Half { .. } | ImageForm::Paper { .. } | ImageForm::Matcap => None,
    }
}

/// What a block's samples are as a form.
fn form_spec(image: &Image) -> FormSpec {
    let (kind, images) = match image.form {
        ImageForm::Bivariate { .. } => (FormKind::Bivariate, 1),
        ImageForm::Half { slices } => (FormKind::Half, slices as usize),
        ImageForm::Paper { .. } => (FormKind::Paper, 1),
        ImageForm::Matcap => (FormKind::Matcap, 1),
    };
    let spec = FormSpec::sized(kind, images, image.size as usize, Texel::Float);
    match &image.form {
        ImageForm::Paper { angles } => {
            let options = Options { border: Border::ExtendX, ..Options::default() };
            FormSpec { angles: angles.clone(), options, ..spec }
        }
        _ => spec,
    }
}

/// Whether angles are the same in degrees.
fn are_near(one: &[f64], other: &[f64]) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-6)
}

/// Refuses images that are not where a block's texels lie.
fn check_fit(image: &Image, form: &Form, there: Option<u32>, name: &str) -> Result<(), Error> {
    let (needed, own) = (form_spec(image), &form.spec);
    let has_border = own.kind != FormKind::Paper || own.options.border == needed.options.border;
    let fits =
        own.kind == needed.kind && own.size == needed.size && are_near(&own.angles, &needed.angles) && has_border;
    if fits && there == octaves(image) {
        return Ok(());
    }
    let what = format!("{name} holds {}", described(own, there));
    let remedy = match (flags(image, own, there), &image.form) {
        (Some(flags), _) => format!("give {flags} for what is there"),
        (None, ImageForm::Half { slices }) => format!(
            "make them with `brdfgen reflectance images TABLE --form half --images {slices} --size {} --texel float`",
            image.size
        ),
        (None, ImageForm::Paper { angles }) => format!(
            "make them with `brdfgen reflectance images TABLE --form paper --angles {} --size {} --border {} --texel \
             float`",
            listed(angles, ","),
            image.size,
            needed.options.border
        ),
        (None, ImageForm::Bivariate { .. }) => "give the table that they were made of".to_owned(),
        (None, ImageForm::Matcap) => format!("give {PICTURE}"),
    };
    Err(Error::input(what, format!("this block takes {}: {remedy}", described(&needed, octaves(image)))))
}

/// Angles in degrees, to a thousandth.
fn listed(angles: &[f64], between: &str) -> String {
    angles.iter().map(|angle| ((angle * 1e3).round() / 1e3).to_string()).collect::<Vec<_>>().join(between)
}

/// What images are, in words.
fn described(spec: &FormSpec, octaves: Option<u32>) -> String {
    let FormSpec { kind, angles, size, .. } = spec;
    let count = angles.len();
    match (kind, octaves) {
        (FormKind::Half, _) if are_near(angles, &half::angles(count)) => {
            format!("{count} slices of {size} × {size} texels, evenly from 0 to {} degrees", half::LAST)
        }
        (FormKind::Half, _) => {
            format!("{count} slices of {size} × {size} texels at {} degrees", listed(angles, ", "))
        }
        (FormKind::Bivariate, Some(octaves)) => {
            format!("{size} × {size} texels of the form bivariate, their columns along {octaves} octaves of 1 - n.h")
        }
        (FormKind::Bivariate, None) => {
            format!("{size} × {size} texels of the form bivariate, their columns along the root of θh")
        }
        (FormKind::Paper, _) => format!(
            "{count} sphere images of {size} × {size} texels lit from {} degrees, with the border {}",
            listed(angles, ", "),
            spec.options.border
        ),
        (FormKind::Matcap, _) => format!("a matcap of {size} × {size} texels"),
    }
}

/// The flags of a block that images would fit, if there is one.
fn flags(image: &Image, spec: &FormSpec, octaves: Option<u32>) -> Option<String> {
    let FormSpec { kind, angles, size, .. } = spec;
    let count = u32::try_from(angles.len()).ok()?;
    let size = u32::try_from(*size).ok().filter(|size| SIZE.contains(size) && size.is_power_of_two())?;
    match (kind, octaves) {
        (FormKind::Half, _) => {
            let is_even = are_near(angles, &half::angles(angles.len()));
            let fits = is_even && SLICES.contains(&count) && count.is_power_of_two();
            fits.then(|| format!("--image-form half --images {count} --image-size {size}"))
        }
        (FormKind::Paper, _) => {
            let image = Image { form: ImageForm::Paper { angles: angles.clone() }, size, ..image.clone() };
            let fits = spec.options.border == Border::ExtendX && image.check().is_ok();
            fits.then(|| format!("--image-form paper --angles {} --image-size {size}", listed(angles, ",")))
        }
        (FormKind::Bivariate, Some(octaves)) => {
            Some(format!("--image-form bivariate --octaves {octaves} --image-size {size}"))
        }
        (FormKind::Matcap, _) => Some(format!("--image-form matcap --image-size {size}")),
        _ => None,
    }
}
