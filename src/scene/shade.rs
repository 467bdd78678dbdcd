//! The whole shader of a scene: the lobe that it needs with the cosine in front of it and the colours behind it.

use rayon::prelude::*;

use super::trace::{Hit, Tracer};
use super::{Picture, Requirements, Scene};
use crate::design::Design;
use crate::design::sample::{self, Sample, Vector};
use crate::error::Error;
use crate::spec::{BlockKind, Front, LightColours, Material, Model, Shader, ShaderFields, Shininess, SpecFields};

/// The spec of the shader of a scene around a lobe.
///
/// `lobe` is the lobe's spec, chosen for the scene; `asked` says of the shader what the scene does not: the front end of Blinn's half
/// vector and the vectors' fraction bits. Every material that a picture shows has its row; the colours of the lights are constants. A
/// material without a highlight has the shininess of the first row: it is multiplied by 0.
///
/// # Errors
/// Keys that the scene itself says, or no material that is seen.
pub fn spec(
    scene: &Scene,
    requirements: &Requirements,
    lobe: &SpecFields,
    asked: &ShaderFields,
) -> Result<SpecFields, Error> {
    let of_scene = ShaderFields { front: None, vector_fraction: None, ..asked.clone() };
    if !of_scene.is_empty() {
        return Err(Error::input(
            "the scene says itself which model, lights, colours and channels its shader has",
            "of the shader's keys give only front and vector_fraction",
        ));
    }
    let first = requirements.rows.first().map_or(1.0, |row| row.shininess);
    let needed =
        scene.materials.iter().zip(&requirements.materials).filter(|(_, need)| need.base.and(&need.moved).samples > 0);
    let materials: Vec<Material> = needed
        .map(|(material, need)| {
            let shininess = if need.row.is_some() { material.shininess } else { first };
            Material { shininess, ..material.clone() }
        })
        .collect();
    if materials.is_empty() {
        return Err(Error::input("no object of the scene is seen", "turn the camera to the objects"));
    }
    let front = match scene.model {
        Model::Phong => asked.front,
        Model::Blinn => Some(asked.front.unwrap_or(Front::Half)),
    };
    let shader = ShaderFields {
        model: Some(scene.model),
        front,
        lights: Some(scene.lights.len() as u32),
        channel_bits: Some(scene.channel_bits),
        vector_fraction: asked.vector_fraction,
        ambient_light: Some(scene.ambient.to_vec()),
        light_colours: Some(LightColours::Fixed(scene.lights.iter().map(|light| light.colour).collect())),
    };
    Ok(SpecFields {
        block: Some(BlockKind::Shader),
        shininess: None,
        material: Some(materials),
        operand: None,
        input_range: None,
        shader,
        ..lobe.clone()
    })
}

/// A point of a surface as the shader is given it: the material's row, N, V, and of each light L and H. A light that does not shine on the
/// point, because it is in shadow or lies at the very point, is put behind the surface, where the shader finds no light.
fn sample(tracer: &Tracer, scene: &Scene, hit: &Hit, row: u32) -> Sample {
    let behind: Vector = hit.normal.map(|component| -component);
    let light = |light: usize| {
        let lit = tracer.light(scene, hit, light);
        let direction = if lit.visible { lit.direction } else { behind };
        sample::Light { direction, half: lit.half, colour: scene.lights[light].colour }
    };
    Sample {
        material: row,
        normal: hit.normal,
        viewer: hit.viewer,
        lights: (0..scene.lights.len()).map(light).collect(),
    }
}

/// The code of `in_material` of each material of the scene; none of a material that the shader does not have.
#[must_use]
pub fn rows(design: &Design, scene: &Scene) -> Vec<Option<u32>> {
    let Shininess::Materials(own) = &design.spec.shininess else { return vec![None; scene.materials.len()] };
    let place = |material: &Material| own.iter().position(|known| known.name == material.name).map(|row| row as u32);
    scene.materials.iter().map(place).collect()
}

/// A scene's picture by the bit-exact model of its shader, and the number of samples (pixels of objects, each with all its lights) that it
/// was given. `done` is called once a row.
///
/// # Errors
/// A pixel of a material that the shader does not have.
pub fn picture(
    design: &Design,
    shader: &Shader,
    scene: &Scene,
    tracer: &Tracer,
    done: &(dyn Fn() + Sync),
) -> Result<(Picture, u64), Error> {
    let (model, rows) = (design.shader_model(shader), rows(design, scene));
    let full = f64::from((1u32 << scene.channel_bits) - 1);
    let background = scene.background.map(|channel| libm::round(channel * full) as u16);
    let of_row = |y: u32| -> Result<(Vec<[u16; 3]>, u64), Error> {
        let (mut codes, mut samples) = (Vec::with_capacity(scene.width as usize), 0);
        for hit in tracer.row(scene, y) {
            let Some(hit) = hit else {
                codes.push(background);
                continue;
            };
            let row = rows[hit.material].ok_or_else(|| {
                let name = &scene.materials[hit.material].name;
                Error::input(format!("the shader has no material {name}"), "make it with a wider --margin")
            })?;
            let channels = model.evaluate(&sample(tracer, scene, &hit, row).codes(shader));
            codes.push([0, 1, 2].map(|channel| channels[channel] as u16));
            samples += 1;
        }
        done();
        Ok((codes, samples))
    };
    let parts: Vec<(Vec<[u16; 3]>, u64)> = (0..scene.height).into_par_iter().map(of_row).collect::<Result<_, _>>()?;
    let samples = parts.iter().map(|(_, samples)| samples).sum();
    let codes = parts.into_iter().flat_map(|(codes, _)| codes).collect();
    let Scene { width, height, channel_bits, .. } = *scene;
    Ok((Picture { width, height, channel_bits, codes }, samples))
}
