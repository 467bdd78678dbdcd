//! Materials of a scene through an image-based core.
//!
//! What is outside of the core is done here: each normal is turned into the frame in which the viewer is at +Z, that of
//! its pixel or that of the camera ([`Viewer`](super::reflectance::Viewer)), and the record of each light that shines
//! there is made in that frame. Of the core come codes of channels; ambient light is added to them behind it.

use rayon::prelude::*;

use super::frame::full_scale;
use super::reflectance::{Axes, Measured, Sight};
use super::{Scene, Tracer};
use crate::block::image::{ImageSamples, ImageSource, ImageSpec};
use crate::core::sample::{self, Sample};
use crate::core::{BlockDesign, Design, ImageDesign, ShaderDesign};
use crate::platform::error::{Error, refuse};
use crate::reflectance::{Light, Vector};
use crate::spec::Colour;

/// A pixel that shows a material which goes through a core.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    /// The pixel, counted row by row from the top.
    pub(crate) pixel: usize,
    normal: Vector,
    /// The lights that shine there.
    lights: Vec<(Light, Colour)>,
}

impl Point {
    /// The codes of the inputs for it, clock by clock, of an image-based core or of a shader that takes lights in
    /// sequence, whose only material it has.
    ///
    /// # Panics
    /// On another core.
    pub(crate) fn clocks(&self, design: &Design) -> Vec<Vec<i64>> {
        match design.block() {
            BlockDesign::Image(image) => image.block.clocks(self.normal, &self.lights),
            BlockDesign::Shader(shader) => {
                let unlit = [(Light::new(180.0, 0.0), [0.0; 3])];
                let lights = if self.lights.is_empty() { &unlit } else { self.lights.as_slice() };
                lights.chunks(shader.shader.lights as usize).map(|lights| self.shaded(shader, lights)).collect()
            }
            BlockDesign::Lobe(_) => panic!("a core that takes lights in sequence"),
        }
    }

    /// The codes of a shader's inputs for some of the lights.
    fn shaded(&self, shader: ShaderDesign<'_>, lights: &[(Light, Colour)]) -> Vec<i64> {
        let viewer = Vector::z();
        let missing = (Light::new(180.0, 0.0), [0.0; 3]);
        let all = lights.iter().copied().chain(std::iter::repeat(missing)).take(shader.shader.lights as usize);
        let light = |(light, colour): (Light, Colour)| {
            let direction = light.direction();
            let half = (direction + viewer).try_normalize(1e-12).unwrap_or(viewer);
            sample::Light { direction: direction.into(), half: half.into(), colour }
        };
        let lights = all.map(light).collect();
        let sample = Sample { material: 0, normal: self.normal.into(), viewer: viewer.into(), lights };
        sample.codes(shader.shader)
    }

    /// The codes of the channels by a core's bit-exact model and the sequencer's sums.
    ///
    /// # Panics
    /// As [`Point::clocks`].
    pub(crate) fn codes(&self, design: &Design) -> [u16; 3] {
        let sums: Vec<Vec<i64>> = self.clocks(design).iter().map(|inputs| design.evaluate(inputs)).collect();
        let codes = design.sample_of(&sums);
        [0, 1, 2].map(|channel| codes[channel] as u16)
    }
}

/// The points of a scene's picture that show some of its materials.
pub(crate) struct Points<'a> {
    scene: &'a Scene,
    tracer: &'a Tracer,
    axes: Axes,
    /// Places in [`Scene::materials`].
    materials: &'a [usize],
}

impl<'a> Points<'a> {
    pub(crate) fn of(scene: &'a Scene, tracer: &'a Tracer, materials: &'a [usize]) -> Self {
        Self { scene, tracer, axes: Axes::of(scene), materials }
    }

    /// Those of a row, from the left to the right.
    pub(crate) fn row(&self, row: u32) -> Vec<Point> {
        let first = row as usize * self.scene.width as usize;
        let hits = self.tracer.row(self.scene, row).into_iter().enumerate();
        let point = |(x, hit): (usize, Option<super::Hit>)| {
            let hit = hit.filter(|hit| self.materials.contains(&hit.material))?;
            let measured = self.scene.reflectance(hit.material)?;
            let (normal, lights) = Sight::of(self.tracer, self.scene, &hit).as_seen(&self.axes, measured.seen_by());
            Some(Point { pixel: first + x, normal, lights })
        };
        hits.filter_map(point).collect()
    }

    /// All of them, row by row; a row is traced when it is asked for.
    pub(crate) fn iter(&self) -> impl Iterator<Item = Point> + use<'_, 'a> {
        (0..self.scene.height).flat_map(|row| self.row(row))
    }

    /// The pixels with their codes by a core's bit-exact model. `done` is called once a row.
    pub(crate) fn through(&self, design: &Design, done: &(dyn Fn() + Sync)) -> Vec<(usize, [u16; 3])> {
        let of_row = |row: u32| -> Vec<(usize, [u16; 3])> {
            let codes = self.row(row).iter().map(|point| (point.pixel, point.codes(design))).collect();
            done();
            codes
        };
        let rows: Vec<_> = (0..self.scene.height).into_par_iter().map(of_row).collect();
        rows.concat()
    }
}

/// Channels in units of full scale with those of a core added to the pixels that it gives: of a pixel without ambient
/// light the core's codes themselves.
pub(crate) fn added(base: &[Colour], codes: &[(usize, [u16; 3])], channel_bits: u32) -> Vec<Colour> {
    let full = full_scale(channel_bits);
    let mut all = base.to_vec();
    for (pixel, codes) in codes {
        (0..3).for_each(|c| all[*pixel][c] += f64::from(codes[c]) / full);
    }
    all
}

/// Why a material is not the one that a core is made of, if it is not.
fn unlike(image: ImageDesign<'_>, measured: &Measured) -> Option<String> {
    let ImageSpec { image: asked, source, exposure } = image.of;
    let Some(reflectance) = measured.reflectance() else {
        let form = measured.form().ok()?;
        let samples = match measured.matcap() {
            Some(picture) => {
                let stored = ImageSamples::of_picture(asked, picture, measured.exposure, &measured.name);
                stored.ok().map(|stored| stored.samples().clone())
            }
            None => Some(form.texels.samples()),
        };
        return (samples.as_ref() != Some(image.block.samples())).then(|| "other images".to_owned());
    };
    if !asked.has_lights() {
        return Some("a reflectance, and the core is a matcap".to_owned());
    }
    let is_same = match (source.model(), measured.model()) {
        (Some(own), Some(model)) => own == model,
        _ => image.block.is_of(reflectance, *exposure),
    };
    match is_same {
        false => Some("another reflectance".to_owned()),
        true if measured.exposure == *exposure => None,
        true => Some(format!("its exposure is {}, and the core's {exposure}", measured.exposure)),
    }
}

/// The materials of a scene, by their places, that an image-based core is made of.
///
/// # Errors
/// None of them, or channels of other bits than the scene's.
pub(crate) fn materials(scene: &Scene, image: ImageDesign<'_>) -> Result<Vec<usize>, Error> {
    let (name, bits) = (&image.spec.name, image.of.image.channel_bits);
    let (mut fitting, mut others) = (Vec::new(), Vec::new());
    for place in scene.measured_places() {
        let Some(measured) = scene.reflectance(place) else { continue };
        match unlike(image, measured) {
            None => fitting.push(place),
            Some(why) => others.push(format!("{} ({}): {why}", scene.materials[place].name, measured.name)),
        }
    }
    if fitting.is_empty() {
        let of = match &image.of.source {
            ImageSource::Model(model) => model.to_string(),
            ImageSource::Samples(samples) => format!("a file's samples ({}…)", &samples.digest()[..12]),
        };
        return Err(Error::input(
            format!("the core {name} is made of {of}, and no material of the scene is: {}", others.join("; ")),
            "a core of a material of the scene with its exposure: generate one with the same [reflectance]",
        ));
    }
    refuse!(
        bits != scene.channel_bits,
        format!("the core {name} has {bits} bits a channel, and the scene {}", scene.channel_bits),
        format!("channel_bits = {bits} in the scene, or a core with output_bits = {}", scene.channel_bits)
    );
    Ok(fitting)
}
