//! The flags of `brdfgen reflectance`, and the material and the form that they say.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::platform::error::Error;
use crate::reflectance::paper::{Behind, Border};
use crate::reflectance::{FormKind, FormSpec, Lookup, Model, Reflectance, Source, Texel, measure};

/// What reflects.
#[derive(Args)]
pub(super) struct MaterialArguments {
    /// A MERL table (.binary), a directory of sphere images, or a matcap (PNG, OpenEXR)
    #[arg(value_name = "FILE", required_unless_present = "model")]
    pub(super) file: Option<PathBuf>,

    #[command(flatten)]
    pub(super) model: ModelArguments,
}

#[derive(Args)]
pub(super) struct ModelArguments {
    /// A reflectance model in place of a file: lambert, blinnphong, ward, cook-torrance, ggx, ashikhmin-shirley, or a
    /// preset: yellow-plastic, red-specular-plastic, orange-diffuse-paint, blue-acrylic, aluminium-bronze, gold-paint,
    /// colour-shifting-paint
    #[arg(long, value_name = "NAME")]
    pub(super) model: Option<String>,

    /// A parameter of the model, such as alpha=0.18 or kd=0.4,0.3,0.1
    #[arg(long, value_name = "KEY=VALUE", num_args = 1.., requires = "model")]
    pub(super) parameter: Vec<String>,

    /// How a table is looked up between the centres of its cells
    #[arg(long, value_enum, default_value = "trilinear")]
    pub(super) lookup: Lookup,

    /// The exposure E that radiance is multiplied by [default: 0.6 over the 90th percentile of the sphere lit from 45
    /// degrees]
    #[arg(long, value_name = "E", value_parser = positive)]
    pub(super) exposure: Option<f64>,
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| *number > 0.0 && number.is_finite());
    number.ok_or_else(|| "a number above 0".to_owned())
}

/// How a material is stored.
#[derive(Args)]
pub(super) struct FormArguments {
    /// The form: sphere images (paper), slices about the half vector (half), or the mean over the azimuth (bivariate)
    #[arg(long, value_enum)]
    pub(super) form: Option<FormName>,

    /// The light's angles of the images in degrees, as in 0,45,90,135, or how many [default: 4 images, 16 slices]
    ///
    /// So many images of the paper's form are 180/N degrees apart, so many slices of half even from 0 to 176; without a
    /// meaning for bivariate and exact
    #[arg(long, value_name = "ANGLES", allow_hyphen_values = true)]
    pub(super) images: Option<String>,

    /// Texels along a side, 2 to 4096 [default: 512 for paper, 32 for half and bivariate]
    #[arg(long)]
    pub(super) size: Option<usize>,

    /// How texels are stored: float, linear:BITS, sqrt:BITS, sqrt:BITS:CAP or 565 [default: linear:8 for paper, sqrt:8
    /// for half and bivariate]
    #[arg(long)]
    pub(super) texel: Option<Texel>,

    /// What keeps the black around a sphere out of the paper's form: shrink:FACTOR, extend or extend-x [default:
    /// shrink:0.995]
    #[arg(long)]
    pub(super) border: Option<Border>,

    /// What the paper's form looks up for a turned normal that points away: rim, literal or skip [default: rim]
    #[arg(long)]
    pub(super) behind: Option<Behind>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum FormName {
    /// Equations 1 to 4
    Paper,
    /// Slices about the half vector
    Half,
    /// The mean over the azimuth about the half vector
    Bivariate,
    /// No form: the material itself
    Exact,
}

impl FormArguments {
    /// The form that is asked for; none is the material itself.
    pub(super) fn spec(&self, form: FormName) -> Result<Option<FormSpec>, Error> {
        let kind = match form {
            FormName::Paper => FormKind::Paper,
            FormName::Half => FormKind::Half,
            FormName::Bivariate => FormKind::Bivariate,
            FormName::Exact => return Ok(None),
        };
        let mut spec = FormSpec::of(kind);
        if let Some(images) = self.images.as_ref().filter(|_| kind != FormKind::Bivariate) {
            spec.set_images(images)?;
        }
        spec.size = self.size.unwrap_or(spec.size);
        spec.texel = self.texel.unwrap_or(spec.texel);
        spec.options.border = self.border.unwrap_or(spec.options.border);
        spec.options.behind = self.behind.unwrap_or(spec.options.behind);
        spec.check()?;
        Ok(Some(spec))
    }

    /// Whether anything but the form's name is given.
    pub(super) fn is_given(&self) -> bool {
        self.images.is_some()
            || self.size.is_some()
            || self.texel.is_some()
            || self.border.is_some()
            || self.behind.is_some()
    }
}

#[derive(Args)]
pub(super) struct InfoArguments {
    #[command(flatten)]
    pub(super) material: MaterialArguments,

    /// Print the result as JSON
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct ConvertArguments {
    /// The table to read, unless a model is given, and the file to write, which ends in .binary
    #[arg(value_name = "IN OUT", required = true, num_args = 1..=2)]
    pub(super) files: Vec<PathBuf>,

    #[command(flatten)]
    pub(super) model: ModelArguments,

    /// Cells along the azimuth φd: 180, which makes the table reciprocal, or 360 [default: as many as IN has; 180 for a
    /// model]
    #[arg(long, value_name = "CELLS", value_parser = ["180", "360"])]
    pub(super) phi_d: Option<String>,

    /// Print the result as JSON
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct ImagesArguments {
    #[command(flatten)]
    pub(super) material: MaterialArguments,

    #[command(flatten)]
    pub(super) form: FormArguments,

    /// The directory: a new or empty one, or one of earlier sphere images
    #[arg(long, short, value_name = "DIR")]
    pub(super) out: PathBuf,

    /// Print the result as JSON
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct FitArguments {
    #[command(flatten)]
    pub(super) material: MaterialArguments,

    /// The cosine of the highlight [default: both]
    #[arg(long, value_enum)]
    pub(super) cosine: Option<CosineName>,

    /// How many highlights, 1 to 3
    #[arg(long, default_value_t = 1)]
    pub(super) lobes: usize,

    /// Print the result as JSON
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum CosineName {
    /// n·h
    Blinn,
    /// r·v
    Phong,
}

#[derive(Args)]
pub(super) struct EvalArguments {
    #[command(flatten)]
    pub(super) material: MaterialArguments,

    #[command(flatten)]
    pub(super) form: FormArguments,

    /// The points: a CSV file with the columns phi_deg, gamma_deg, nx, ny and nz
    #[arg(long, value_name = "IN.csv")]
    pub(super) points: PathBuf,

    /// The results: the columns of IN, then r, g and b; `-` is standard output [default: `-`, and nothing with --json]
    #[arg(long, value_name = "OUT.csv")]
    pub(super) csv: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct TradeArguments {
    #[command(flatten)]
    pub(super) material: MaterialArguments,

    /// Choose among those that take at most so much memory
    #[arg(long, value_name = "KIB", value_parser = positive)]
    pub(super) max_kib: Option<f64>,

    /// Choose the one that takes the least memory among those whose mean is at least so many dB
    #[arg(long, value_name = "DB", value_parser = positive)]
    pub(super) min_psnr: Option<f64>,

    /// Write all of them as CSV
    #[arg(long, value_name = "FILE.csv")]
    pub(super) csv: Option<PathBuf>,

    /// Draw them as a chart
    #[arg(long, value_name = "FILE.svg")]
    pub(super) svg: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct StabilityArguments {
    /// Write what was found as a chapter in Markdown
    #[arg(long, short, value_name = "FILE.md")]
    pub(super) out: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    pub(super) json: bool,
}

/// A material that is opened.
pub(super) struct Material {
    /// The file's path, or the model with its parameters.
    pub(super) name: String,
    pub(super) what: Source,
}

impl Material {
    /// As a reflectance, which images are not.
    pub(super) fn reflectance(&self) -> Result<&dyn Reflectance, Error> {
        self.what.needed(&self.name, "give a MERL table, or a model with --model")
    }
}

impl ModelArguments {
    pub(super) fn model(&self) -> Result<Option<Model>, Error> {
        let Some(name) = &self.model else { return Ok(None) };
        let mut model = Model::named(name)?;
        for parameter in &self.parameter {
            let Some((key, value)) = parameter.split_once('=') else {
                return Err(Error::input(format!("the parameter `{parameter}`"), "KEY=VALUE, as in alpha=0.18"));
            };
            model.set(key.trim(), value.trim())?;
        }
        Ok(Some(model))
    }

    pub(super) fn open(&self, file: Option<&Path>) -> Result<Material, Error> {
        match (self.model()?, file) {
            (Some(_), Some(file)) => {
                Err(Error::input(format!("both a model and the file {} are given", file.display()), "give one of them"))
            }
            (Some(model), None) => Ok(Material { name: model.to_string(), what: Source::Model(model) }),
            (None, None) => Err(Error::input("no material is given", "name a file, or a model with --model")),
            (None, Some(file)) => {
                Ok(Material { name: file.display().to_string(), what: Source::open(file, self.lookup)? })
            }
        }
    }

    pub(super) fn exposure(&self, reflectance: &dyn Reflectance) -> f64 {
        self.exposure.unwrap_or_else(|| measure::exposure(reflectance))
    }
}

impl MaterialArguments {
    pub(super) fn open(&self) -> Result<Material, Error> {
        self.model.open(self.file.as_deref())
    }
}
