//! Materials as written.

use std::path::Path;
use std::sync::Arc;

use serde::Deserialize;
use toml::Spanned;

use super::Source;
use crate::lobe::MAX_SHININESS;
use crate::platform::error::Error;
use crate::scene::reflectance::{Measured, ReflectanceFields, Shading};
use crate::spec::{Colour, Material, Model, Shininess};

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MaterialFields {
    name: String,
    shininess: Option<f64>,
    roughness: Option<f64>,
    #[serde(alias = "k_a")]
    ambient: Option<f64>,
    #[serde(alias = "k_d")]
    diffuse: Option<f64>,
    #[serde(alias = "k_s")]
    specular: Option<f64>,
    colour: Option<Colour>,
    ambient_colour: Option<Colour>,
    specular_colour: Option<Colour>,
    shading: Option<Shading>,
    reflectance: Option<Spanned<ReflectanceFields>>,
}

/// What is measured of a material, if anything is.
type Reflectance = Option<Arc<Measured>>;

/// All of them, and the reflectance of each that is drawn by one; `shading` is the scene's own.
pub(super) fn all(
    source: &Source,
    list: Vec<Spanned<MaterialFields>>,
    shading: Option<Shading>,
    model: Model,
    directory: &Path,
) -> Result<(Vec<Material>, Vec<Reflectance>), Error> {
    let (mut materials, mut reflectances) =
        (Vec::<Material>::with_capacity(list.len()), Vec::with_capacity(list.len()));
    for (index, material) in list.into_iter().enumerate() {
        let span = material.span();
        let place = |error| source.at("", &span, error);
        let mut fields = material.into_inner();
        let reflectance = fields.reflectance.take();
        let own = reflectance.as_ref().and_then(|table| table.get_ref().shading).or(fields.shading);
        if reflectance.is_none() && own.is_some_and(|own| own != Shading::Classical) {
            return Err(place(Error::input(
                format!("material {} has a shading and no reflectance", fields.name),
                "give [material.reflectance] with a file or a model",
            )));
        }
        let shading = own.or(shading).unwrap_or(Shading::ImageBased);
        let measured = match reflectance {
            None => None,
            Some(table) => {
                let (span, what) = (table.span(), format!("material {}: reflectance: ", fields.name));
                let measured = table.into_inner().resolve(shading, directory);
                Some(measured.map_err(|error| source.at(&what, &span, error))?)
            }
        };
        let (fields, reflectance) = match measured {
            Some(measured) if shading == Shading::Classical => {
                fields.fit(&measured, model).map_err(place)?;
                (fields, None)
            }
            Some(measured) => (fields.without_highlight(), Some(Arc::new(measured))),
            None => (fields, None),
        };
        reflectances.push(reflectance);
        let material = fields.resolve(index).map_err(place)?;
        if materials.iter().any(|other| other.name == material.name) {
            let what = format!("there are two materials {}", material.name);
            return Err(place(Error::input(what, "each has a name of its own")));
        }
        materials.push(material);
    }
    Ok((materials, reflectances))
}

/// The diffuse and cos^n material, of one highlight and without ambient light, that is nearest to a reflectance.
///
/// # Errors
/// Sphere images, which have no reflectance.
pub(in crate::scene) fn fitted(name: &str, measured: &Measured, model: Model) -> Result<Material, Error> {
    let mut fields = MaterialFields { name: name.to_owned(), ..MaterialFields::default() };
    fields.fit(measured, model)?;
    fields.resolve(0)
}

impl MaterialFields {
    /// Fills in the diffuse part and the highlight that are nearest to a reflectance, where the file has none of its
    /// own.
    fn fit(&mut self, measured: &Measured, model: Model) -> Result<(), Error> {
        if self.shininess.is_some() || self.roughness.is_some() {
            return Ok(());
        }
        let fitted = measured.fitted(model, 1)?;
        let lobe = fitted.lobes.first().map_or(([0.0; 3], 1.0), |lobe| (lobe.ks, lobe.n));
        // A factor and a colour are at most 1, and so is what is seen.
        let parts = |rgb: Colour| {
            let most = rgb.into_iter().fold(0.0, f64::max);
            let colour = if most > 0.0 { rgb.map(|channel| channel / most) } else { [1.0; 3] };
            (most.min(1.0), colour)
        };
        let ((diffuse, colour), (specular, specular_colour)) = (parts(fitted.kd), parts(lobe.0));
        self.shininess = Some(lobe.1);
        self.ambient = self.ambient.or(Some(0.0));
        self.diffuse = self.diffuse.or(Some(diffuse));
        self.colour = self.colour.or(Some(colour));
        self.specular = self.specular.or(Some(specular));
        self.specular_colour = self.specular_colour.or(Some(specular_colour));
        Ok(())
    }

    /// The material as one that asks for no lobe: a reflectance draws it. What it gives back of the ambient light
    /// stays.
    fn without_highlight(self) -> Self {
        Self {
            shininess: Some(1.0),
            roughness: None,
            ambient: self.ambient.or(Some(0.0)),
            diffuse: Some(0.0),
            specular: Some(0.0),
            ..self
        }
    }

    /// The material with its surface; `index` is its place in the file, from 0.
    fn resolve(self, index: usize) -> Result<Material, Error> {
        let name = if self.name.is_empty() { format!("{}", index + 1) } else { self.name.clone() };
        let shininess = match (self.shininess, self.roughness) {
            (Some(shininess), None) => shininess,
            (None, Some(alpha)) => of_roughness(alpha).ok_or_else(|| {
                Error::input(
                    format!("material {name}: roughness = {alpha} is out of range"),
                    "a real number above 0.0014 and at most sqrt(2/3) = 0.8164: the shininess is 2 / roughness^2 - 2",
                )
            })?,
            (Some(_), Some(_)) => {
                let what = format!("material {name} has both shininess and roughness");
                return Err(Error::input(what, "give one of the two"));
            }
            (None, None) => {
                return Err(Error::input(format!("material {name} has no shininess"), "give shininess or roughness"));
            }
        };
        let material = Material {
            name: self.name,
            shininess,
            ambient: self.ambient,
            diffuse: self.diffuse,
            specular: self.specular,
            colour: self.colour,
            ambient_colour: self.ambient_colour,
            specular_colour: self.specular_colour,
        };
        Shininess::Materials(vec![material.clone()]).check()?;
        material.check_surface()?;
        Ok(material.with_surface())
    }
}

/// The shininess of a roughness: the exponent of the Phong distribution of half vectors that is about as wide as the
/// Beckmann distribution of width alpha, `n = 2 / alpha^2 - 2` (Walter, Marschner, Li and Torrance 2007, "Microfacet
/// Models for Refraction through Rough Surfaces", section 5.2), to 12 significant digits; none where that is below 1 or
/// beyond the greatest shininess.
fn of_roughness(alpha: f64) -> Option<f64> {
    let n = 2.0 / (alpha * alpha) - 2.0;
    // Without the last bits, which are of the computation: 0.4 gives 10.5.
    let n = format!("{n:.11e}").parse().unwrap_or(n);
    // The root of 2/3 itself is no f64.
    let n = if (1.0 - 1e-9..1.0).contains(&n) { 1.0 } else { n };
    (alpha > 0.0 && (1.0..=MAX_SHININESS).contains(&n)).then_some(n)
}
