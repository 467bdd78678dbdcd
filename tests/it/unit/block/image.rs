//! The image-based block: its operations against its model, and its pictures against the exact ones.

use brdfgen::block::image::{FixedLight, FrontEnd, Image, ImageBlock, ImageForm, LightRecord, OctaveAxis};
use brdfgen::datapath::Datapath;
use brdfgen::fixed::{Rng, exp2};
use brdfgen::platform::error::Error;
use brdfgen::reflectance::measure::{self, Judge, Sphere};
use brdfgen::reflectance::paper::{Border, Options};
use brdfgen::reflectance::{FormKind, FormSpec, Light, Model, Texel, Vector};

const SMALL: Image = Image {
    form: ImageForm::Bivariate { octaves: 8 },
    size: 32,
    texel_bits: 8,
    weight_bits: 5,
    vector_fraction: 16,
    channel_bits: 8,
    lights: 1,
    most_lights: 1,
    front_end: FrontEnd::Record,
    blend_multipliers: None,
};
const HALF: Image = Image { form: ImageForm::Half { slices: 16 }, weight_bits: 6, ..SMALL };

fn block(image: Image, model: &str) -> ImageBlock {
    let model = Model::named(model).unwrap();
    ImageBlock::new(image, &model, measure::exposure(&model)).unwrap()
}

fn by_graph(datapath: &Datapath, inputs: &[i64]) -> Vec<i64> {
    let codes: Vec<i128> = inputs.iter().copied().map(i128::from).collect();
    let values = datapath.graph.values(&datapath.tables, &codes);
    datapath.graph.outputs.iter().map(|&(_, id)| values[id] as i64).collect()
}

/// A unit vector's codes.
fn codes(v: [f64; 3], image: &Image) -> [i64; 3] {
    v.map(|value| (value * exp2(image.vector_fraction as i32)).round() as i64)
}

#[test]
fn an_axis_ascends_by_octaves() {
    for (size, octave_bits) in [(8, 1), (32, 2), (64, 2), (64, 3)] {
        let axis = OctaveAxis { size, octave_bits };
        let columns: Vec<f64> = (0..size).map(|column| axis.versine(column)).collect();
        assert!(columns.is_sorted_by(|a, b| a < b) && columns[0] == 0.0);
        assert_eq!(columns[size as usize - 1], 1.0 - exp2(-1 - octave_bits as i32));
        assert_eq!(axis.versine(size - (1 << octave_bits)), 0.5);
    }
}

/// A block of the form paper.
fn paper(angles: &[f64], size: u32) -> Image {
    Image { form: ImageForm::Paper { angles: angles.to_vec() }, size, ..HALF }
}

/// The paper's set of six images.
const SIX: [f64; 6] = [0.0, 30.0, 60.0, 90.0, 120.0, 150.0];

/// A block that is told of lights by vectors.
fn by_vector(image: Image) -> Image {
    Image { front_end: FrontEnd::Vector, ..image }
}

/// The codes of a light's ports.
fn light_codes(block: &ImageBlock, light: Light, intensity: [f64; 3]) -> Vec<i64> {
    block.light_codes(&FixedLight::new(light, intensity).unwrap())
}

/// Blocks at the ends of what is allowed.
fn blocks() -> Vec<(Image, &'static str)> {
    let bivariate = |octaves, size| Image { form: ImageForm::Bivariate { octaves }, size, ..SMALL };
    let half = |slices, size| Image { form: ImageForm::Half { slices }, size, ..HALF };
    vec![
        (SMALL, "ggx"),
        // All lights have the shift 0.
        (SMALL, "lambert"),
        (Image { texel_bits: 4, weight_bits: 3, vector_fraction: 8, ..bivariate(8, 8) }, "ggx"),
        (Image { vector_fraction: 8, ..SMALL }, "blinnphong"),
        (Image { texel_bits: 10, weight_bits: 8, vector_fraction: 20, channel_bits: 12, ..bivariate(16, 64) }, "ggx"),
        (Image { channel_bits: 10, ..bivariate(2, 128) }, "blinnphong"),
        (Image { lights: 8, most_lights: 1024, ..bivariate(4, 16) }, "ggx"),
        (HALF, "ggx"),
        (Image { texel_bits: 10, weight_bits: 8, lights: 2, ..half(4, 8) }, "ggx"),
        (Image { weight_bits: 3, vector_fraction: 8, ..half(8, 32) }, "lambert"),
        (half(64, 8), "blinnphong"),
        // All blends by the weights' bits, the widest codes among them, some by multipliers, and all.
        (Image { blend_multipliers: Some(0), texel_bits: 10, weight_bits: 8, ..half(4, 8) }, "ggx"),
        (Image { blend_multipliers: Some(8), lights: 2, ..half(4, 8) }, "ggx"),
        (Image { blend_multipliers: Some(9), ..SMALL }, "ggx"),
        (paper(&SIX, 64), "ggx"),
        // The last image is there twice.
        (
            Image { texel_bits: 10, weight_bits: 8, lights: 2, vector_fraction: 20, ..paper(&[45.0, 90.0, 135.0], 8) },
            "ggx",
        ),
        (Image { weight_bits: 3, vector_fraction: 8, ..paper(&[90.0], 16) }, "lambert"),
        (Image { channel_bits: 12, ..paper(&[0.0, 90.0, 180.0], 32) }, "blinnphong"),
        (by_vector(SMALL), "ggx"),
        (by_vector(HALF), "ggx"),
        // The coarsest and the finest vectors, few bands and many, all lights with the shift 0, two lights.
        (by_vector(Image { texel_bits: 4, weight_bits: 3, vector_fraction: 8, ..bivariate(8, 8) }), "blinnphong"),
        (by_vector(Image { weight_bits: 8, vector_fraction: 20, channel_bits: 12, ..bivariate(16, 128) }), "ggx"),
        (by_vector(Image { weight_bits: 3, vector_fraction: 8, lights: 2, ..half(4, 8) }), "gold-paint"),
        (by_vector(Image { weight_bits: 8, vector_fraction: 20, ..half(64, 8) }), "lambert"),
        (by_vector(Image { vector_fraction: 12, ..half(8, 16) }), "ggx"),
    ]
}

/// Any codes of the ports, and those that unit vectors and lights have: from before the first band to behind the
/// object, about any axis, with any intensity.
#[test]
fn the_operations_are_the_model() {
    for (image, reflectance) in blocks() {
        let block = block(image, reflectance);
        let (datapath, _) = block.datapath().expect("a datapath");
        let graph = &datapath.graph;
        let has_shift = block.widths().shift > 0 && block.image().front_end == FrontEnd::Record;
        assert_eq!(!has_shift, graph.nodes.iter().all(|node| node.name != "in_shift1"));
        let formats: Vec<_> = graph.inputs.iter().map(|&id| graph.nodes[id].format).collect();
        let mut rng = Rng::new(5);
        let (model, mut lit) = (block.model(), 0);
        for round in 0..3000 {
            let mut inputs: Vec<i64> =
                formats.iter().map(|format| format.min_code() as i64 + rng.below(1 << format.width()) as i64).collect();
            if round % 4 > 0 {
                let mut part = || rng.below(2001) as f64 / 1000.0 - 1.0;
                let normal = [part(), part(), part().abs() + 1e-3];
                let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
                inputs[..3].copy_from_slice(&codes(normal.map(|c| c / length), block.image()));
                let each = (inputs.len() - 3) / block.image().lights as usize;
                for light in 0..block.image().lights as usize {
                    let at = Light::new(90.0 * (part() + 1.0), 180.0 * part());
                    let intensity = [1.0, part().abs(), 0.1];
                    let record = light_codes(&block, at, intensity);
                    for (code, format) in record.iter().zip(&formats[3..]) {
                        assert_eq!(format.wrap((*code).into()), i128::from(*code), "{code} in {format} for {at:?}");
                    }
                    inputs[3 + light * each..][..each].copy_from_slice(&record);
                }
            }
            let expected = model.evaluate(&inputs);
            assert_eq!(by_graph(&datapath, &inputs), expected, "{:?} {inputs:?}", block.image());
            lit += usize::from(expected.iter().any(|&code| code > 0));
        }
        assert!(lit > 1000, "{lit}");
    }
}

/// The mean and the least ratio in dB over the angles of the light, of pictures by the model; each light stands at an
/// azimuth of its own.
fn quality(block: &ImageBlock, model: &str, size: usize) -> (f64, f64) {
    let reflectance = Model::named(model).unwrap();
    let exposure = measure::exposure(&reflectance);
    let sphere = Sphere::new(size);
    let full = block.image().full_scale() as f64;
    let ratio = |phi: f64| {
        let light = Light::new(phi, 3.0 * phi);
        let record = light_codes(block, light, [1.0; 3]);
        let exact = sphere.exact(&reflectance, light, exposure);
        let pixel = |n: &Vector| {
            let out = block.shown(&[&codes([n.x, n.y, n.z], block.image())[..], &record].concat());
            [0, 1, 2].map(|c| (out[c] as f64 / full) as f32)
        };
        measure::psnr(&exact, &sphere.normals.iter().map(pixel).collect::<Vec<_>>())
    };
    let ratios: Vec<f64> = measure::angles(5.0).into_iter().map(ratio).collect();
    (ratios.iter().sum::<f64>() / ratios.len() as f64, ratios.iter().copied().fold(f64::INFINITY, f64::min))
}

#[test]
fn pictures_are_as_good_as_they_should_be() {
    for (image, model, mean, worst) in
        [(SMALL, "ggx", 44.0, 34.5), (SMALL, "blinnphong", 59.0, 52.0), (HALF, "ggx", 49.0, 41.9)]
    {
        let (own_mean, own_worst) = quality(&block(image, model), model, 96);
        println!("{model}: mean {own_mean:.2}, least {own_worst:.2} dB");
        assert!(own_mean >= mean && own_worst >= worst, "{model}: {own_mean} {own_worst}");
    }
}

/// Records that the block makes itself cost next to nothing, also at the worst angle.
#[test]
fn computed_records_cost_little() {
    for image in [SMALL, Image { weight_bits: 5, ..HALF }] {
        let (told_mean, told_worst) = quality(&block(image.clone(), "ggx"), "ggx", 96);
        let (mean, worst) = quality(&block(by_vector(image), "ggx"), "ggx", 96);
        println!("told {told_mean:.2} {told_worst:.2}, computed {mean:.2} {worst:.2} dB");
        assert!(mean >= told_mean - 0.3 && worst >= told_worst - 1.0);
    }
}

/// A computed record is that of the light as its ports tell it, at the polar angle whose cosine l_z is, but for
/// roundings: at all angles, and about all azimuths.
#[test]
fn computed_records_are_the_exact_ones() {
    for (image, reflectance) in [(by_vector(SMALL), "ggx"), (by_vector(HALF), "ggx"), (by_vector(HALF), "gold-paint")] {
        let block = block(image, reflectance);
        let (image, model, widths) = (block.image(), block.model(), block.widths());
        let one = exp2(image.vector_fraction as i32);
        // Of the vectors, of h, of the place among the bands and of the gain: between the angles at which the azimuth
        // is in a few codes, and from 0 on.
        let mut worst = [[0.0f64; 4]; 2];
        for step in 0..=35_200 {
            let phi = f64::from(step) / 200.0;
            let codes = light_codes(&block, Light::new(phi, 137.508 * f64::from(step)), [1.0; 3]);
            let gamma = Light::towards(Vector::new(codes[0] as f64, codes[1] as f64, 0.0)).gamma;
            let told = Light::new((codes[2] as f64 / one).acos().to_degrees(), gamma);
            let (made, exact) = (model.record(&codes), block.record(told, [1.0; 3]).unwrap());
            assert_eq!(made.direction.map(Vec::from), Some(codes[..3].to_vec()));
            assert!(made.gain.iter().all(|&code| code <= widths.gain_format().max_code() as i64));
            let vectors = made.frame.iter().zip(&exact.frame).map(|(a, b)| (a - b).abs() as f64 / one);
            let half = |record: &LightRecord| {
                let part = |place: usize| record.frame[place] as f64 / one;
                let first = Vector::new(part(0), part(1), part(2));
                match image.form {
                    ImageForm::Half { .. } => first.cross(&Vector::new(part(3), part(4), 0.0)),
                    _ => first,
                }
            };
            let place = |record: &LightRecord| {
                let odd = record.blend as f64 * exp2(-(image.weight_bits as i32));
                record.band as f64 + if record.band % 2 == 0 { odd } else { 1.0 - odd }
            };
            let gain = |record: &LightRecord| record.gain[0] as f64 * exp2(record.shift.unwrap_or(0) as i32);
            let off = [
                vectors.fold(0.0, f64::max),
                (half(&made) - half(&exact)).norm(),
                (place(&made) - place(&exact)).abs(),
                (gain(&made) / gain(&exact) - 1.0).abs(),
            ];
            let at = usize::from(phi < 0.4);
            worst[at] = std::array::from_fn(|of| worst[at][of].max(off[of]));
        }
        println!("{image}: {worst:?}");
        let [[vectors, half, places, gains], [_, half_at_pole, places_at_pole, gains_at_pole]] = worst;
        let steps = exp2(-(image.weight_bits as i32));
        // A texel of 32 is 0.06 wide. Between bands of very different caps the gain is no line from row to row; where
        // the light is behind the object a code of l_z is a part of 0.003 of 1 + l_z.
        assert!(vectors < 3e-3 && half < 3e-3 && places < 2.5 * steps && gains < 1e-2);
        assert!(half_at_pole < 6e-3 && places_at_pole < 2.5 * steps && gains_at_pole < 4e-3);
    }
}

/// The form paper in bits is as good as in floating-point numbers of the same texels.
#[test]
fn the_form_paper_is_as_good_as_in_floating_point() {
    let model = Model::named("ggx").unwrap();
    let exposure = measure::exposure(&model);
    let options = Options { border: Border::ExtendX, ..Options::default() };
    let spec = FormSpec { options, ..FormSpec::sized(FormKind::Paper, 6, 64, Texel::Sqrt(8, None)) };
    let judge = Judge::new(&model, exposure, &measure::angles(5.0), 96);
    let float = judge.quality(&spec.build(&model, exposure).unwrap());
    let (mean, worst) = quality(&block(paper(&SIX, 64), "ggx"), "ggx", 96);
    println!("floating point {:.2} {:.2}, bits {mean:.2} {worst:.2} dB", float.mean, float.worst);
    assert!(mean > float.mean - 0.5 && worst > float.worst - 0.5);
}

#[test]
fn what_is_no_block_is_refused() {
    for (image, words) in [
        (Image { size: 48, ..SMALL }, "size = 48 is no power of two"),
        (Image { size: 4, ..SMALL }, "size = 4"),
        (Image { form: ImageForm::Bivariate { octaves: 1 }, ..SMALL }, "octaves = 1"),
        (Image { form: ImageForm::Bivariate { octaves: 16 }, size: 8, ..SMALL }, "16 octaves are more than the 8"),
        (Image { form: ImageForm::Bivariate { octaves: 16 }, vector_fraction: 8, ..SMALL }, "needed to 2^-21"),
        (Image { form: ImageForm::Half { slices: 2 }, ..SMALL }, "images = 2"),
        (Image { form: ImageForm::Half { slices: 64 }, size: 256, ..SMALL }, "4194304 texels are too many"),
        (paper(&[], 64), "images = 0"),
        (paper(&[0.0, 60.0, 30.0], 64), "do not ascend"),
        (paper(&[-1.0, 60.0], 64), "do not ascend"),
        (paper(&[0.0, 60.0, 60.05, 120.0], 64), "60 and 60.05"),
        (paper(&[0.0, 80.0], 64), "between 80 and 180 degrees"),
        (paper(&[95.0], 64), "between 0 and 95 degrees"),
        (Image { texel_bits: 11, ..SMALL }, "texel_bits = 11"),
        (Image { weight_bits: 2, ..SMALL }, "weight_bits = 2"),
        (Image { channel_bits: 9, ..SMALL }, "channel_bits = 9"),
        (Image { lights: 9, ..SMALL }, "lights_a_clock = 9"),
        (Image { most_lights: 1025, ..SMALL }, "most_lights = 1025"),
    ] {
        let Error::Input { what, allowed } = image.check().unwrap_err() else { panic!("{image:?}") };
        assert!(what.contains(words) && !allowed.is_empty(), "{what} | {allowed}");
    }
    let matcap = Image { form: ImageForm::Matcap, ..SMALL };
    for (image, words) in [(paper(&SIX, 64), "sphere images"), (matcap, "a matcap")] {
        let image = by_vector(image);
        let Error::Input { what, .. } = image.check().unwrap_err() else { panic!("{image:?}") };
        assert!(what.contains(&format!("front_end = vector is given for {words}")), "{what}");
    }
    for intensity in [[-0.1, 0.0, 0.0], [0.0, 1.01, 0.0], [0.0, 0.0, f64::NAN]] {
        assert!(block(SMALL, "lambert").record(Light::new(0.0, 0.0), intensity).is_err());
    }
}
