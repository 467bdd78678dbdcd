//! What reflects, as a spec of an image-based block writes it.

use std::collections::BTreeMap;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::method::keys::keys;
use crate::platform::error::{Error, refuse};
use crate::reflectance::{Model, measure};

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

    /// The exposure E that radiance is multiplied by [default: 0.6 over the 90th percentile of the sphere lit from 45
    /// degrees]
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

    /// The model with its parameters, and the exposure.
    pub(super) fn resolve(&self) -> Result<(Model, f64), Error> {
        let Some(name) = &self.model else {
            return Err(Error::input(
                "no reflectance is given",
                "give --reflectance ggx or another model, or a table [reflectance] with its `model` in a spec file",
            ));
        };
        let mut model = Model::named(name)?;
        for (key, value) in self.parameters.iter().flat_map(|parameters| &parameters.0) {
            model.set(key, value)?;
        }
        let exposure = self.exposure.unwrap_or_else(|| measure::exposure(&model));
        refuse!(
            !(exposure > 0.0 && exposure.is_finite()),
            format!("exposure = {exposure} is out of range"),
            "a number above 0"
        );
        Ok((model, exposure))
    }

    /// The fields of a resolved reflectance, all given.
    pub(super) fn of(model: &Model, exposure: f64) -> Self {
        Self {
            model: Some(model.family().name().to_owned()),
            exposure: Some(exposure),
            parameters: Some(Parameters(model.parameters().into_iter().collect())),
        }
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

/// A parameter as TOML has it.
#[derive(Serialize, Deserialize)]
#[serde(untagged, expecting = "a parameter is a number, a list of three, or a word")]
enum Written {
    Whole(i64),
    Number(f64),
    Colour(Vec<f64>),
    Word(String),
}

impl Written {
    fn of(text: &str) -> Self {
        let numbers: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
        match numbers {
            Err(_) => Self::Word(text.to_owned()),
            Ok(numbers) if numbers.len() == 1 => Self::Number(numbers[0]),
            Ok(numbers) => Self::Colour(numbers),
        }
    }

    fn text(self) -> String {
        match self {
            Self::Whole(number) => number.to_string(),
            Self::Number(number) => number.to_string(),
            Self::Colour(numbers) => numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(","),
            Self::Word(word) => word,
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
