//! What a shader block has beyond its lobe: the cosine's front end, lights, colours.

use std::str::FromStr;

use clap::ValueEnum;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::block::lights::{DEFAULT_MOST_LIGHTS, MOST_LIGHTS, Sums};
use crate::method::keys::keys;
use crate::method::{Colour, Interface, Material, Shininess, within};
use crate::platform::error::{Error, refuse};

/// Bits of an output channel that are allowed.
pub const CHANNEL_BITS: [u32; 3] = [8, 10, 12];
/// Fraction bits of the vectors' components that are allowed.
pub const VECTOR_FRACTION: std::ops::RangeInclusive<u32> = 8..=20;
/// Numbers of lights that are allowed.
pub const LIGHTS: std::ops::RangeInclusive<u32> = 1..=8;

/// The reflection model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Model {
    /// The cosine between the mirrored light and the viewer.
    Phong,
    /// The cosine between the normal and the half vector.
    Blinn,
}

/// How the Blinn model gets at its half vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Front {
    /// It is given: the versine is |N - H|^2 / 2.
    Half,
    /// It is not: x = (N.L + N.V) / sqrt(2 + 2 L.V).
    Sqrt,
}

/// The cosine of the highlight, and what it is computed from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cosine {
    /// Phong: x = 2 (N.L)(N.V) - L.V.
    Mirror,
    /// Blinn with H given: u = |N - H|^2 / 2.
    Half,
    /// Blinn: x = (N.L + N.V) / sqrt(2 + 2 L.V).
    Sqrt,
}

/// Where the lights' colours come from.
#[derive(Clone, Debug, PartialEq)]
pub enum LightColours {
    /// From ports, a code of the channels' bits each.
    Ports,
    /// They are constants: one a light, multiplied into the ROM.
    Fixed(Vec<Colour>),
}

keys! {
    /// The keys of the table `[shader]`, as written.
    #[command(next_help_heading = "Shader")]
    ShaderFields:

    /// The reflection model of a shader [default: phong]
    model: Model,

    /// How blinn gets at its half vector [default: half]
    front: Front where "the model blinn",

    /// Lights, 1 to 8, all of a sample at once; for more, lights_a_clock [default: 1]
    lights: u32,

    /// Bits of an output channel: 8, 10 or 12 [default: 8]
    #[arg(value_name = "BITS")]
    channel_bits: u32,

    /// Fraction bits of the vectors' components, 8 to 20 [default: 16]
    #[arg(value_name = "F")]
    vector_fraction: u32,

    /// Colour of the ambient light, R,G,B in 0 to 1 [default: 0.2,0.2,0.2]
    #[arg(value_name = "R,G,B", value_delimiter = ',')]
    ambient_light: Vec<f64>,

    /// Colours of the lights, R,G,B;R,G,B;... or ports [default: white; ports with lights_a_clock]
    #[arg(value_name = "COLOURS|ports")]
    light_colours: LightColours,
}

/// A shader block, every default resolved and every value checked; its lobe and its materials are the core's.
#[derive(Clone, Debug, PartialEq)]
pub struct Shader {
    /// How the cosine of the highlight is computed.
    pub cosine: Cosine,
    /// The number of lights that are taken in a clock; all of a sample unless they come in sequence.
    pub lights: u32,
    /// Where they come in sequence, the lights of a sample that the roundings are sized for; more may come.
    pub most_lights: Option<u32>,
    /// The bits of an output channel.
    pub channel_bits: u32,
    /// The fraction bits of the vectors' components, which are signed Q1.f.
    pub vector_fraction: u32,
    /// The colour of the ambient light.
    pub ambient_light: Colour,
    /// The colours of the lights.
    pub light_colours: LightColours,
}

/// The inner widths of a shader around its lobe: fraction bits each.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct ShaderWidths {
    /// The scalar products, two bits finer than the lobe's input, and six where they are divided by a root that may be
    /// small.
    pub dot: i32,
    /// The lobe's input.
    pub x: i32,
    /// The cosine of the diffuse term.
    pub cos: i32,
    /// The colours in the ROM.
    pub k: i32,
    /// Each light's terms, so fine that all their roundings together stay below an eighth of an output step.
    pub term: i32,
    /// The reciprocal square root and its factor.
    pub root: i32,
}

/// What a material reflects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// k_a, times the colour of the ambient light that the material gives back.
    pub ambient: Colour,
    /// k_d, times the material's colour.
    pub diffuse: Colour,
    /// k_s, times the highlight's colour.
    pub specular: Colour,
}

impl Material {
    /// This material with the defaults for what is not written of its surface; the colour of the ambient light stays
    /// unwritten where it is that of the scattered light.
    #[must_use]
    pub fn with_surface(self) -> Self {
        Self {
            ambient: self.ambient.or(Some(0.1)),
            diffuse: self.diffuse.or(Some(0.6)),
            specular: self.specular.or(Some(0.3)),
            colour: self.colour.or(Some([1.0; 3])),
            specular_colour: self.specular_colour.or(Some([1.0; 3])),
            ..self
        }
    }

    /// Whether its surface is the default one.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        let bare = Self { name: self.name.clone(), shininess: self.shininess, ..Self::default() };
        *self == bare.with_surface()
    }

    /// What it reflects.
    #[must_use]
    pub fn surface(&self) -> Surface {
        let Self { ambient, diffuse, specular, colour, ambient_colour, specular_colour, .. } =
            self.clone().with_surface();
        let times = |factor: Option<f64>, colour: Option<Colour>| {
            colour.unwrap_or_default().map(|channel| channel * factor.unwrap_or_default())
        };
        Surface {
            ambient: times(ambient, ambient_colour.or(colour)),
            diffuse: times(diffuse, colour),
            specular: times(specular, specular_colour),
        }
    }

    /// Refuses a coefficient or a colour outside 0 to 1.
    pub(crate) fn check_surface(&self) -> Result<(), Error> {
        for (what, value) in [("ambient", self.ambient), ("diffuse", self.diffuse), ("specular", self.specular)] {
            unit(&format!("material {}: {what}", self.name), &value.into_iter().collect::<Vec<_>>())?;
        }
        let colours = [
            ("colour", self.colour),
            ("ambient_colour", self.ambient_colour),
            ("specular_colour", self.specular_colour),
        ];
        for (what, value) in colours {
            unit(&format!("material {}: {what}", self.name), value.as_ref().map_or(&[], <[f64; 3]>::as_slice))?;
        }
        Ok(())
    }

    /// Whether anything of its surface is written.
    pub(crate) fn has_surface(&self) -> bool {
        let factors = [self.ambient, self.diffuse, self.specular];
        let colours = [self.colour, self.ambient_colour, self.specular_colour];
        factors.iter().any(Option::is_some) || colours.iter().any(Option::is_some)
    }
}

/// Refuses a number outside 0 to 1; `what` names them.
pub(crate) fn unit(what: &str, values: &[f64]) -> Result<(), Error> {
    match values.iter().find(|value| !(0.0..=1.0).contains(*value)) {
        None => Ok(()),
        Some(value) => Err(Error::input(format!("{what} = {value} is out of range"), "a real number from 0 to 1")),
    }
}

impl ShaderFields {
    /// Whether none is given.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Fills in the defaults and checks every value. `lights_a_clock` and `most_lights` are of lights in sequence.
    ///
    /// # Errors
    /// Names the value that is wrong and what is allowed.
    pub fn resolve(self, lights_a_clock: Option<u32>, most_lights: Option<u32>) -> Result<Shader, Error> {
        let cosine = match (self.model.unwrap_or(Model::Phong), self.front) {
            (Model::Phong, None) => Cosine::Mirror,
            (Model::Phong, Some(_)) => {
                return Err(Error::input("the model phong has no front", "leave front out, or use --model blinn"));
            }
            (Model::Blinn, None | Some(Front::Half)) => Cosine::Half,
            (Model::Blinn, Some(Front::Sqrt)) => Cosine::Sqrt,
        };
        let (lights, most_lights) = match (lights_a_clock, self.lights) {
            (Some(_), Some(_)) => {
                return Err(Error::input(
                    "both lights and lights_a_clock are given",
                    "lights for all of a sample at once, or lights_a_clock for any number in sequence",
                ));
            }
            (Some(lights), None) => {
                let most = within("most_lights", most_lights.unwrap_or(DEFAULT_MOST_LIGHTS), MOST_LIGHTS)?;
                (within("lights_a_clock", lights, LIGHTS)?, Some(most))
            }
            (None, lights) => {
                refuse!(
                    most_lights.is_some(),
                    "most_lights is given for a shader that takes all lights of a sample at once",
                    "give lights_a_clock as well, or leave most_lights out"
                );
                (within("lights", lights.unwrap_or(1), LIGHTS)?, None)
            }
        };
        let channel_bits = self.channel_bits.unwrap_or(8);
        if !CHANNEL_BITS.contains(&channel_bits) {
            return Err(Error::input(format!("channel_bits = {channel_bits} is not offered"), "8, 10 or 12"));
        }
        let ambient = self.ambient_light.unwrap_or_else(|| vec![0.2; 3]);
        unit("ambient_light", &ambient)?;
        let ambient_light: Colour = ambient.try_into().map_err(|given: Vec<f64>| {
            Error::input(format!("ambient_light has {} numbers", given.len()), "red, green and blue, each from 0 to 1")
        })?;
        let light_colours = self.light_colours.unwrap_or_else(|| match most_lights {
            Some(_) => LightColours::Ports,
            None => LightColours::Fixed(vec![[1.0; 3]; lights as usize]),
        });
        if let LightColours::Fixed(colours) = &light_colours {
            if colours.len() != lights as usize {
                return Err(Error::input(
                    format!("{} light colours are given for {lights} lights", colours.len()),
                    "give one a light, or ports",
                ));
            }
            colours.iter().try_for_each(|colour| unit("light_colours", colour))?;
        }
        let vector_fraction = within("vector_fraction", self.vector_fraction.unwrap_or(16), VECTOR_FRACTION)?;
        Ok(Shader { cosine, lights, most_lights, channel_bits, vector_fraction, ambient_light, light_colours })
    }

    /// The fields of a resolved shader, all given.
    #[must_use]
    pub fn from_shader(shader: &Shader) -> Self {
        let (model, front) = match shader.cosine {
            Cosine::Mirror => (Model::Phong, None),
            Cosine::Half => (Model::Blinn, Some(Front::Half)),
            Cosine::Sqrt => (Model::Blinn, Some(Front::Sqrt)),
        };
        Self {
            model: Some(model),
            front,
            lights: Some(shader.lights).filter(|_| shader.most_lights.is_none()),
            channel_bits: Some(shader.channel_bits),
            vector_fraction: Some(shader.vector_fraction),
            ambient_light: Some(shader.ambient_light.to_vec()),
            light_colours: Some(shader.light_colours.clone()),
        }
    }
}

impl Shader {
    /// The inner widths around the lobe, by rule.
    #[must_use]
    pub fn widths(&self, interface: &Interface) -> ShaderWidths {
        let (f, bits) = (self.vector_fraction as i32, self.channel_bits as i32);
        let x = interface.input_fraction as i32;
        let finer = if self.cosine == Cosine::Sqrt { 6 } else { 2 };
        let dot = (x + finer).min(2 * f);
        let each = if self.light_colours == LightColours::Ports { 3 } else { 2u32 };
        let terms = each * self.lights.max(self.most_lights.unwrap_or_default());
        ShaderWidths {
            dot,
            x,
            cos: dot.min(bits + 4),
            k: bits + 4,
            term: Sums::term_bits(self.channel_bits, terms),
            root: x + 2,
        }
    }

    /// What comes out of the core where lights come in sequence, and is made codes of.
    #[must_use]
    pub fn sums(&self, interface: &Interface) -> Option<Sums> {
        let ShaderWidths { term, k, .. } = self.widths(interface);
        let channel_bits = self.channel_bits;
        self.most_lights.map(|_| Sums { frac_bits: term as u32, ambient: Some(k as u32), channel_bits })
    }

    /// The materials' surfaces, in the order of the set.
    #[must_use]
    pub fn surfaces(interface: &Interface) -> Vec<Surface> {
        match &interface.shininess {
            Shininess::Materials(materials) => materials.iter().map(Material::surface).collect(),
            _ => Vec::new(),
        }
    }

    /// The greatest code of a channel: full scale.
    #[must_use]
    pub fn full_scale(&self) -> i64 {
        (1 << self.channel_bits) - 1
    }
}

impl FromStr for LightColours {
    type Err = String;

    /// Reads `ports`, or `R,G,B` for each light with semicolons between.
    fn from_str(text: &str) -> Result<Self, String> {
        if text == "ports" {
            return Ok(Self::Ports);
        }
        let colour = |part: &str| -> Result<Colour, String> {
            let wrong = || format!("`{part}` is no colour; a colour is R,G,B, and there is a semicolon between two");
            let channels: Result<Vec<f64>, _> = part.split(',').map(|channel| channel.trim().parse()).collect();
            channels.map_err(|_| wrong())?.try_into().map_err(|_| wrong())
        };
        text.split(';').map(colour).collect::<Result<_, _>>().map(Self::Fixed)
    }
}

impl Serialize for LightColours {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Ports => serializer.serialize_str("ports"),
            Self::Fixed(colours) => colours.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for LightColours {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "the light colours are \"ports\" or a list of [red, green, blue]")]
        enum Written {
            Text(String),
            List(Vec<Colour>),
        }
        match Written::deserialize(deserializer)? {
            Written::Text(text) => text.parse().map_err(serde::de::Error::custom),
            Written::List(colours) => Ok(Self::Fixed(colours)),
        }
    }
}
