//! Any of the forms: what is stored of a reflectance, and what it gives for a light and a normal.

use std::fmt;
use std::str::FromStr;

use super::texels::{Samples, Scale, Texel, Texels};
use super::vector::{Light, Vector};
use super::{Reflectance, Rgb, bivariate, half, paper};
use crate::platform::error::{Error, refuse};

/// The greatest size of an image, a slice or an axis of nodes.
pub const LARGEST: usize = 4096;
/// The most images or slices.
pub const MOST_IMAGES: usize = 360;
/// The most texels together: half a gigabyte in memory.
const MOST_TEXELS: usize = 1 << 25;

/// Which form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormKind {
    /// Pictures of the sphere, turned and blended: the paper's.
    Paper,
    /// Slices about the half vector.
    Half,
    /// The average over φd.
    Bivariate,
    /// A single picture of the sphere for whatever light: one look-up, no turn.
    Matcap,
}

impl FormKind {
    /// The three that are made of a reflectance.
    pub const MADE: [Self; 3] = [Self::Paper, Self::Half, Self::Bivariate];

    /// The name in files and flags.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::Half => "half",
            Self::Bivariate => "bivariate",
            Self::Matcap => "matcap",
        }
    }

    /// Where the full scale of its codes comes from.
    #[must_use]
    pub fn scale(self) -> Scale {
        match self {
            Self::Paper | Self::Matcap => Scale::Unit,
            Self::Half => Scale::Layer,
            Self::Bivariate => Scale::Row,
        }
    }

    /// How texels are stored unless told otherwise.
    #[must_use]
    pub fn texel(self) -> Texel {
        match self {
            Self::Paper => Texel::Linear(8),
            Self::Half | Self::Bivariate => Texel::Sqrt(8, None),
            Self::Matcap => Texel::Float,
        }
    }

    /// The size unless told otherwise.
    #[must_use]
    pub fn size(self) -> usize {
        match self {
            Self::Paper | Self::Matcap => 512,
            Self::Half | Self::Bivariate => 32,
        }
    }

    /// The angles of so many images or slices: for 4 and 6 images the paper's sets, in general steps of 180/count
    /// degrees.
    #[must_use]
    pub fn angles(self, count: usize) -> Vec<f64> {
        match self {
            Self::Paper => (0..count).map(|i| 180.0 * i as f64 / count as f64).collect(),
            Self::Half => half::angles(count),
            Self::Bivariate | Self::Matcap => vec![0.0],
        }
    }

    /// How images of the sphere are looked up unless told otherwise: a matcap where x and y of a normal are, also of
    /// one that is turned away, as its rim's colours go on beside the sphere.
    #[must_use]
    pub fn options(self) -> paper::Options {
        match self {
            Self::Paper | Self::Half | Self::Bivariate => paper::Options::default(),
            Self::Matcap => paper::Options {
                border: paper::Border::Extend,
                behind: paper::Behind::Literal,
                ..paper::Options::default()
            },
        }
    }

    /// How many images or slices there are unless told otherwise.
    #[must_use]
    pub fn images(self) -> usize {
        match self {
            Self::Paper => 4,
            Self::Half => 16,
            Self::Bivariate | Self::Matcap => 1,
        }
    }
}

impl FromStr for FormKind {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let kinds = [Self::Paper, Self::Half, Self::Bivariate, Self::Matcap];
        kinds.into_iter().find(|kind| kind.name() == text).ok_or_else(|| format!("`{text}` is no form"))
    }
}

/// What is to be made of a reflectance.
#[derive(Clone, Debug, PartialEq)]
pub struct FormSpec {
    /// The form.
    pub kind: FormKind,
    /// The light's angles of the images or slices in degrees, ascending; one without a meaning for the others.
    pub angles: Vec<f64>,
    /// Texels along a side.
    pub size: usize,
    /// How they are stored.
    pub texel: Texel,
    /// How the paper's images and matcaps are looked up.
    pub options: paper::Options,
}

impl FormSpec {
    /// A form with its defaults.
    #[must_use]
    pub fn of(kind: FormKind) -> Self {
        Self {
            kind,
            angles: kind.angles(kind.images()),
            size: kind.size(),
            texel: kind.texel(),
            options: kind.options(),
        }
    }

    /// A form of so many images or slices of a size.
    #[must_use]
    pub fn sized(kind: FormKind, images: usize, size: usize, texel: Texel) -> Self {
        Self { angles: kind.angles(images), size, texel, ..Self::of(kind) }
    }

    /// Reads what `--images` says: a count, or angles with commas between.
    ///
    /// # Errors
    /// What is no number.
    pub fn set_images(&mut self, text: &str) -> Result<(), Error> {
        let allowed = || {
            format!(
                "a count from 1 to {MOST_IMAGES}, or ascending angles in degrees with commas between, as in 0,45,90,135"
            )
        };
        let wrong = || Error::input(format!("images `{text}`"), allowed());
        // A number without a point is a count, however large.
        self.angles = if !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit()) {
            let count = text.parse().ok().filter(|count| (1..=MOST_IMAGES).contains(count)).ok_or_else(wrong)?;
            self.kind.angles(count)
        } else {
            let parts = text.strip_suffix(',').unwrap_or(text).split(',');
            parts.map(|part| part.trim().parse().map_err(|_| wrong())).collect::<Result<_, _>>()?
        };
        Ok(())
    }

    /// Sets `images`, `size`, `texel`, `border` or `behind` as it is written in a flag or a file.
    ///
    /// # Errors
    /// Another key, or what is no such value.
    pub fn set(&mut self, key: &str, text: &str) -> Result<(), Error> {
        let wrong = |allowed: String| Error::input(format!("{key} = `{text}`"), allowed);
        match key {
            "images" => return self.set_images(text),
            "size" => {
                self.size = text.parse().map_err(|_| wrong(format!("2 to {LARGEST} texels along a side")))?;
            }
            "texel" => self.texel = text.parse().map_err(wrong)?,
            "border" => self.options.border = text.parse().map_err(wrong)?,
            "behind" => self.options.behind = text.parse().map_err(wrong)?,
            _ => {
                let allowed = "a form has images, size, texel, border and behind";
                return Err(Error::input(format!("a form has no key `{key}`"), allowed));
            }
        }
        Ok(())
    }

    /// Whether all of it can be made.
    ///
    /// # Errors
    /// Angles that do not ascend or are out of range, a size out of range, too many texels.
    pub fn check(&self) -> Result<(), Error> {
        let name = self.kind.name();
        let most = match self.kind {
            FormKind::Half => half::MOST,
            _ => 180.0,
        };
        let listed = || self.angles.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
        if self.angles.is_empty() || self.angles.len() > MOST_IMAGES {
            return Err(Error::input(format!("{} images", self.angles.len()), format!("1 to {MOST_IMAGES} of them")));
        }
        if let Some(angle) = self.angles.iter().find(|angle| !(0.0..=most).contains(*angle)) {
            return Err(Error::input(
                format!("the angle {angle}° is out of range"),
                format!("the angles of the light in the form `{name}` are from 0 to {most} degrees"),
            ));
        }
        refuse!(
            !self.angles.is_sorted_by(|a, b| a < b),
            format!("the angles {} do not ascend", listed()),
            "each angle is greater than the one before, as in 0,45,90,135"
        );
        refuse!(
            !(2..=LARGEST).contains(&self.size),
            format!("the size {} is out of range", self.size),
            format!("images have 2 to {LARGEST} texels along a side")
        );
        refuse!(
            self.angles.len() * self.size * self.size > MOST_TEXELS,
            format!("{} images of {}² texels are too many", self.angles.len(), self.size),
            format!("at most {MOST_TEXELS} texels together")
        );
        Ok(())
    }

    /// The samples of a reflectance before they are coded. They do not depend on how texels are stored.
    ///
    /// # Errors
    /// As [`FormSpec::check`]; a sample that does not fit 32 bits.
    pub fn samples(&self, reflectance: &dyn Reflectance, exposure: f64) -> Result<Samples, Error> {
        self.check()?;
        let samples = match self.kind {
            FormKind::Paper | FormKind::Matcap => {
                paper::samples(reflectance, &self.angles, self.size, self.options.border, exposure)
            }
            FormKind::Half => half::samples(reflectance, &self.angles, self.size, exposure),
            FormKind::Bivariate => bivariate::samples(reflectance, self.size, exposure),
        };
        if samples.data.iter().flatten().all(|sample| sample.is_finite()) {
            return Ok(samples);
        }
        Err(Error::input(
            format!("a texel is too large for 32 bits at the exposure {exposure}"),
            "give a smaller exposure with --exposure",
        ))
    }

    /// The form of samples.
    #[must_use]
    pub fn encode(&self, samples: &Samples, exposure: f64) -> Form {
        Form { spec: self.clone(), exposure, texels: Texels::encode(samples, self.texel, self.kind.scale()) }
    }

    /// The form of a reflectance.
    ///
    /// # Errors
    /// As [`FormSpec::samples`].
    pub fn build(&self, reflectance: &dyn Reflectance, exposure: f64) -> Result<Form, Error> {
        Ok(self.encode(&self.samples(reflectance, exposure)?, exposure))
    }
}

impl fmt::Display for FormSpec {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, angles, size, texel, .. } = self;
        match kind {
            FormKind::Bivariate | FormKind::Matcap => write!(f, "{} {size}² {texel}", kind.name()),
            _ => write!(f, "{} {}×{size}² {texel}", kind.name(), angles.len()),
        }
    }
}

/// What stands in place of a reflectance.
#[derive(Clone, Debug, PartialEq)]
pub struct Form {
    /// What was made.
    pub spec: FormSpec,
    /// The exposure E that its samples are multiplied by.
    pub exposure: f64,
    /// Its texels.
    pub texels: Texels,
}

/// What a light has ready for every normal, so that a look-up is as short as can be.
#[derive(Clone, Debug)]
pub struct Record(Ready);

#[derive(Clone, Debug)]
enum Ready {
    Paper(paper::Setup),
    Half(half::Blended),
    Bivariate(bivariate::Curve),
    Matcap,
}

impl Form {
    /// The radiance of a unit normal under a light of intensity 1: E f max(n·l, 0) as the form has it. Takes no memory.
    #[must_use]
    pub fn at(&self, light: Light, n: Vector) -> Rgb {
        let Self { spec: FormSpec { angles, options, .. }, texels, .. } = self;
        match self.spec.kind {
            FormKind::Paper => paper::at(texels, options, &paper::setup(angles, options, light), n),
            FormKind::Half => half::at(texels, &half::setup(angles, light), n),
            FormKind::Bivariate => bivariate::at(texels, &bivariate::setup(texels.width, light), n),
            FormKind::Matcap => texels.value(paper::looked_up(texels, options, 0, n)),
        }
    }

    /// The look-up of the paper's form taken apart; none of the other forms.
    #[must_use]
    pub fn steps(&self, light: Light, n: Vector) -> Option<paper::Steps> {
        let FormSpec { kind, angles, options, .. } = &self.spec;
        (*kind == FormKind::Paper).then(|| paper::setup(angles, options, light).steps(options, n))
    }

    /// A light made ready.
    #[must_use]
    pub fn record(&self, light: Light) -> Record {
        let Self { spec: FormSpec { angles, options, .. }, texels, .. } = self;
        Record(match self.spec.kind {
            FormKind::Paper => Ready::Paper(paper::setup(angles, options, light)),
            FormKind::Half => Ready::Half(half::blended(texels, &half::setup(angles, light))),
            FormKind::Bivariate => Ready::Bivariate(bivariate::curve(texels, &bivariate::setup(texels.width, light))),
            FormKind::Matcap => Ready::Matcap,
        })
    }

    /// Adds what a light of an intensity gives for many unit normals to what is there, in single precision; takes no
    /// memory. The results do not depend on how the normals are cut into calls.
    ///
    /// # Panics
    /// If there are not as many of each coordinate as results, or the record is another form's.
    pub fn add(&self, record: &Record, intensity: f32, normals: [&[f32]; 3], out: &mut [[f32; 3]]) {
        assert!(normals.iter().all(|axis| axis.len() == out.len()), "a normal for each result");
        match (&record.0, self.spec.kind) {
            (Ready::Paper(setup), FormKind::Paper) => {
                paper::add(&self.texels, &self.spec.options, setup, intensity, normals, out);
            }
            (Ready::Half(light), FormKind::Half) => half::add(light, intensity, normals, out),
            (Ready::Bivariate(curve), FormKind::Bivariate) => bivariate::add(curve, intensity, normals, out),
            (Ready::Matcap, FormKind::Matcap) => {
                for (i, out) in out.iter_mut().enumerate() {
                    let n = Vector::from(normals.map(|axis| f64::from(axis[i])));
                    let value = self.at(Light::new(0.0, 0.0), n);
                    (0..3).for_each(|c| out[c] += intensity * value[c] as f32);
                }
            }
            _ => panic!("a record of another form"),
        }
    }

    /// The memory that the texels take, in KiB.
    #[must_use]
    pub fn kib(&self) -> f64 {
        self.texels.kib()
    }
}
