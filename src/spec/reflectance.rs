//! What reflects, as a spec of an image-based block writes it.

use std::collections::BTreeMap;
use std::path::Path;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::block::image::{Image, ImageFile, ImageForm, ImageSamples, ImageSource, PICTURE, no_picture};
use crate::method::keys::keys;
use crate::platform::error::{Error, refuse};
use crate::reflectance::{Lookup, Model, Source, measure};

/// The directory of a core that holds the samples of its reflectance, where they came from a file.
pub const DIRECTORY: &str = "reflectance";

/// Parameters of a reflectance model: their names, each with its value as [`Model::set`] reads it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Parameters(pub BTreeMap<String, String>);

keys! {
    /// The keys of the table `[reflectance]`, as written.
    #[command(next_help_heading = "Image-based block")]
    ReflectanceFields:

    /// What reflects: lambert, blinnphong, ward, cook-torrance, ggx, ashikhmin-shirley, or a preset such as gold-paint
    #[arg(id = "reflectance", long = "reflectance", value_name = "MODEL")]
    model: String where "image-based blocks" => "reflectance",

    /// A file in place of a model: a MERL table, or a directory of sphere images that fits the block; a picture, PNG or
    /// OpenEXR, for the form matcap. In a spec file its path starts from there
    #[arg(id = "reflectance_file", long = "reflectance-file", value_name = "PATH")]
    file: String where "image-based blocks" => "reflectance_file",

    /// How a table is looked up [default: trilinear]
    lookup: Lookup where "image-based blocks",

    /// The digest that the samples of a file must have, as a core's own spec says it
    #[arg(id = "reflectance_digest", long = "reflectance-digest", value_name = "DIGEST")]
    digest: String where "image-based blocks" => "reflectance_digest",

    /// The exposure E that radiance is multiplied by [default: that of images their own, 1 of a matcap, or 0.6 over the
    /// 90th percentile of the sphere lit from 45 degrees]
    #[arg(value_name = "E")]
    exposure: f64 where "image-based blocks",

    /// Parameters of the model, KEY=VALUE;KEY=VALUE [default: the model's]
    #[arg(value_name = "PARAMETERS")]
    parameters: Parameters where "image-based blocks",
}

impl ReflectanceFields {
    /// Whether none is given.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// What a block is made of, and the exposure.
    pub(super) fn resolve(&self, image: &Image) -> Result<(ImageSource, f64), Error> {
        let named = Named::of(self.file.as_deref(), self.model.as_deref(), self.parameters.as_ref())?;
        check_exposure(self.exposure)?;
        match named {
            None => Err(Self::missing(image.form == ImageForm::Matcap)),
            Some(Named::Model(model)) if image.form == ImageForm::Matcap => Err(no_picture(&text_of(&model))),
            Some(Named::Model(model)) => {
                let of_file = [("lookup", self.lookup.is_some()), ("digest", self.digest.is_some())];
                if let Some((key, _)) = of_file.into_iter().find(|(_, given)| *given) {
                    return Err(Error::input(format!("{key} is given for a model"), "leave it out: it is for a file"));
                }
                let exposure = self.exposure.unwrap_or_else(|| measure::exposure(&model));
                Ok((ImageSource::Model(model), exposure))
            }
            Some(Named::File(file)) => {
                let (lookup, exposure, digest) = (self.lookup, self.exposure, self.digest.as_deref());
                let file = ImageFile { path: Path::new(file), lookup, exposure, digest };
                let (samples, exposure) = ImageSamples::open(image, &file)?;
                Ok((ImageSource::Samples(samples), exposure))
            }
        }
    }

    /// The reflectance itself and its exposure; of a matcap its picture.
    ///
    /// # Errors
    /// As [`ReflectanceFields::resolve`]; a directory of images, which is none.
    pub(super) fn source(&self, of_matcap: bool) -> Result<(Source, f64), Error> {
        let named = Named::of(self.file.as_deref(), self.model.as_deref(), self.parameters.as_ref())?;
        check_exposure(self.exposure)?;
        let source = match named {
            Some(Named::Model(model)) if of_matcap => return Err(no_picture(&text_of(&model))),
            Some(Named::Model(model)) => Source::Model(model),
            Some(Named::File(file)) => Source::open(Path::new(file), self.lookup.unwrap_or_default())?,
            None => return Err(Self::missing(of_matcap)),
        };
        match (&source, &self.file) {
            (Source::Images(_), Some(file)) if of_matcap && !Path::new(file).is_dir() => {
                return Ok((source, self.exposure.unwrap_or(1.0)));
            }
            (Source::Table(_), Some(file)) if of_matcap => return Err(no_picture(file)),
            _ => {}
        }
        let Some(reflectance) = source.reflectance() else {
            return Err(Error::input(
                "min_psnr or max_error is given for images, whose form and size are theirs",
                "leave it out, or give the table or the model that they were made of",
            ));
        };
        let exposure = self.exposure.unwrap_or_else(|| measure::exposure(reflectance));
        Ok((source, exposure))
    }

    fn missing(of_matcap: bool) -> Error {
        if of_matcap {
            let allowed = format!("--reflectance-file with {PICTURE}, or `file` in the table [reflectance]");
            return Error::input("a matcap is asked for without a picture", allowed);
        }
        Error::input(
            "no reflectance is given",
            "give --reflectance ggx or another model, --reflectance-file with a table or images, or a table \
             [reflectance] with its `model` or `file` in a spec file",
        )
    }

    /// The fields of a model with an exposure, all given.
    pub(crate) fn of_model(model: &Model, exposure: f64) -> Self {
        Self {
            model: Some(model.family().name().to_owned()),
            parameters: Some(Parameters(model.parameters().into_iter().collect())),
            exposure: Some(exposure),
            ..Self::default()
        }
    }

    /// The fields of a resolved reflectance, all given: a file is the core's own.
    pub(super) fn of(source: &ImageSource, exposure: f64) -> Self {
        match source {
            ImageSource::Model(model) => Self::of_model(model, exposure),
            ImageSource::Samples(samples) => Self {
                file: Some(DIRECTORY.to_owned()),
                digest: Some(samples.digest().to_owned()),
                exposure: Some(exposure),
                ..Self::default()
            },
        }
    }

    /// Whether these fields name a reflectance of which the other's say nothing: a file, or a model in place of one.
    pub(super) fn replaces(&self, other: &Self) -> bool {
        self.file.is_some() || self.model.is_some() && other.file.is_some()
    }

    /// With a file's path from where `directory` is.
    pub(crate) fn within(self, directory: &Path) -> Result<Self, Error> {
        let Some(file) = self.file else { return Ok(self) };
        let path = directory.join(file).into_os_string().into_string().map_err(|path| {
            Error::input(format!("the path {} is no UTF-8", Path::new(&path).display()), "a path of Unicode characters")
        })?;
        Ok(Self { file: Some(path), ..self })
    }
}

/// A model by its name.
fn text_of(model: &Model) -> String {
    format!("the model {}", model.family().name())
}

/// What a table `[reflectance]` names.
pub(crate) enum Named<'a> {
    /// A file's path.
    File(&'a str),
    /// A model with its parameters.
    Model(Model),
}

impl<'a> Named<'a> {
    /// What these keys name, if anything.
    ///
    /// # Errors
    /// A file and a model, a file with parameters, an unknown model or parameter.
    pub(crate) fn of(
        file: Option<&'a str>,
        model: Option<&str>,
        parameters: Option<&Parameters>,
    ) -> Result<Option<Self>, Error> {
        match (file, model) {
            (Some(_), Some(_)) => Err(Error::input("both file and model are given", "give one of the two")),
            (None, None) => Ok(None),
            (Some(file), None) => {
                refuse!(parameters.is_some(), "a file has no parameters", "they are a model's");
                Ok(Some(Self::File(file)))
            }
            (None, Some(name)) => {
                let mut model = Model::named(name)?;
                for (key, value) in parameters.iter().flat_map(|parameters| &parameters.0) {
                    model.set(key, value)?;
                }
                Ok(Some(Self::Model(model)))
            }
        }
    }
}

/// Refuses an exposure that is none.
pub(crate) fn check_exposure(exposure: Option<f64>) -> Result<(), Error> {
    match exposure.filter(|exposure| !(*exposure > 0.0 && exposure.is_finite())) {
        Some(exposure) => Err(Error::input(format!("exposure = {exposure} is out of range"), "a number above 0")),
        None => Ok(()),
    }
}

impl FromStr for Parameters {
    type Err = String;

    /// Reads `KEY=VALUE`, with semicolons between them.
    fn from_str(text: &str) -> Result<Self, String> {
        let pair = |part: &str| -> Result<(String, String), String> {
            let (key, value) = part.split_once('=').ok_or_else(|| format!("`{part}` is not KEY=VALUE"))?;
            Ok((key.trim().to_owned(), value.trim().to_owned()))
        };
        let mut parameters = BTreeMap::new();
        for part in text.split(';') {
            let (key, value) = pair(part)?;
            if parameters.insert(key.clone(), value).is_some() {
                return Err(format!("`{key}` is given twice"));
            }
        }
        Ok(Self(parameters))
    }
}

/// A value in TOML that is read as it is written elsewhere, as a parameter or as in `images = 6` or
/// `images = [0, 45, 90]`.
#[derive(Serialize, Deserialize)]
#[serde(untagged, expecting = "a number, a text, or a list of numbers")]
pub(crate) enum Written {
    Whole(i64),
    Number(f64),
    List(Vec<f64>),
    Text(String),
}

impl Written {
    fn of(text: &str) -> Self {
        let numbers: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
        match numbers {
            Err(_) => Self::Text(text.to_owned()),
            Ok(numbers) if numbers.len() == 1 => Self::Number(numbers[0]),
            Ok(numbers) => Self::List(numbers),
        }
    }

    /// The value as a flag has it.
    pub(crate) fn text(&self) -> String {
        match self {
            Self::Whole(number) => number.to_string(),
            Self::Number(number) => number.to_string(),
            Self::Text(text) => text.clone(),
            // One angle alone is no count.
            Self::List(list) if list.len() == 1 => format!("{},", list[0]),
            Self::List(list) => list.iter().map(f64::to_string).collect::<Vec<_>>().join(","),
        }
    }
}

impl Serialize for Parameters {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, Written::of(value))))
    }
}

impl<'de> Deserialize<'de> for Parameters {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let written = BTreeMap::<String, Written>::deserialize(deserializer)?;
        Ok(Self(written.into_iter().map(|(key, value)| (key, value.text())).collect()))
    }
}
