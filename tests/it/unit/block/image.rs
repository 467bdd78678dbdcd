//! The image-based block: its operations against its model, and its pictures against the exact ones.

use brdfgen::block::image::{Banks, Image, ImageForm, ImageModel, ImageWidths, LightRecord, OctaveAxis, datapath};
use brdfgen::datapath::Datapath;
use brdfgen::fixed::{Rng, exp2};
use brdfgen::reflectance::measure::{self, Sphere};
use brdfgen::reflectance::{Light, Model};

const SMALL: Image = Image {
    form: ImageForm::Bivariate { octave_bits: 2 },
    size: 32,
    texel_bits: 8,
    weight_bits: 5,
    vector_fraction: 16,
    channel_bits: 8,
    lights: 1,
};
const HALF: Image = Image { form: ImageForm::Half { slices: 16 }, weight_bits: 6, ..SMALL };

struct Made {
    image: Image,
    widths: ImageWidths,
    banks: Banks,
    datapath: Datapath,
}

fn made(image: Image, model: &str) -> Made {
    let model = Model::named(model).unwrap();
    let banks = Banks::of(&image, &model, measure::exposure(&model));
    let widths = image.widths(&banks);
    let datapath = datapath::build(&image, widths, &banks).expect("a datapath");
    Made { image, widths, banks, datapath }
}

impl Made {
    fn by_graph(&self, inputs: &[i64]) -> Vec<i64> {
        let codes: Vec<i128> = inputs.iter().copied().map(i128::from).collect();
        let values = self.datapath.graph.values(&self.datapath.tables, &codes);
        self.datapath.graph.outputs.iter().map(|&(_, id)| values[id] as i64).collect()
    }

    fn model(&self) -> ImageModel<'_> {
        ImageModel::new(&self.image, self.widths, &self.banks.texels)
    }
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

/// Any codes of the ports, and those that unit vectors and lights have.
#[test]
fn the_operations_are_the_model() {
    for image in [
        SMALL,
        Image {
            form: ImageForm::Bivariate { octave_bits: 1 },
            size: 8,
            texel_bits: 4,
            weight_bits: 3,
            vector_fraction: 8,
            ..SMALL
        },
        Image { size: 64, texel_bits: 10, weight_bits: 8, vector_fraction: 20, channel_bits: 12, ..SMALL },
        Image { form: ImageForm::Bivariate { octave_bits: 1 }, size: 16, lights: 3, ..SMALL },
        HALF,
        Image { form: ImageForm::Half { slices: 2 }, size: 8, texel_bits: 10, weight_bits: 8, lights: 2, ..SMALL },
        Image { form: ImageForm::Half { slices: 8 }, weight_bits: 3, vector_fraction: 8, ..SMALL },
    ] {
        let made = made(image, "ggx");
        let graph = &made.datapath.graph;
        let formats: Vec<_> = graph.inputs.iter().map(|&id| graph.nodes[id].format).collect();
        let mut rng = Rng::new(5);
        let (model, mut lit) = (made.model(), 0);
        for round in 0..4000 {
            let mut inputs: Vec<i64> =
                formats.iter().map(|format| format.min_code() as i64 + rng.below(1 << format.width()) as i64).collect();
            if round % 4 > 0 {
                let mut part = || rng.below(2001) as f64 / 1000.0 - 1.0;
                let normal = [part(), part(), part().abs() + 1e-3];
                let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
                inputs[..3].copy_from_slice(&codes(normal.map(|c| c / length), &made.image));
                let each = (inputs.len() - 3) / made.image.lights as usize;
                for light in 0..made.image.lights as usize {
                    let light_at = Light::new(90.0 * (part() + 1.0), 180.0 * part());
                    let record = LightRecord::new(&made.image, &made.widths, &made.banks, light_at, [1.0, 0.5, 0.1]);
                    inputs[3 + light * each..][..each].copy_from_slice(&record.codes());
                }
            }
            let expected = model.evaluate(&inputs);
            assert_eq!(made.by_graph(&inputs), expected, "{:?} {inputs:?}", made.image);
            lit += usize::from(expected.iter().any(|&code| code > 0));
        }
        assert!(lit > 1500, "{lit}");
    }
}

/// The mean and the least ratio in dB over the angles of the light, of pictures by the model.
fn quality(made: &Made, model: &str, size: usize) -> (f64, f64) {
    let reflectance = Model::named(model).unwrap();
    let exposure = measure::exposure(&reflectance);
    let sphere = Sphere::new(size);
    let bits = made.model();
    let full = made.image.full_scale() as f64;
    let ratios: Vec<f64> = measure::angles(5.0)
        .into_iter()
        .map(|phi| {
            let light = Light::new(phi, 0.0);
            let record = LightRecord::new(&made.image, &made.widths, &made.banks, light, [1.0; 3]).codes();
            let exact = sphere.exact(&reflectance, light, exposure);
            let own: Vec<[f32; 3]> = sphere
                .normals
                .iter()
                .map(|n| {
                    let inputs = [&codes([n.x, n.y, n.z], &made.image)[..], &record].concat();
                    let out = bits.evaluate(&inputs);
                    [0, 1, 2].map(|c| (out[c] as f64 / full) as f32)
                })
                .collect();
            measure::psnr(&exact, &own)
        })
        .collect();
    (ratios.iter().sum::<f64>() / ratios.len() as f64, ratios.iter().copied().fold(f64::INFINITY, f64::min))
}

#[test]
fn pictures_are_as_good_as_they_should_be() {
    for (image, model, mean, worst) in
        [(SMALL, "ggx", 44.0, 34.5), (SMALL, "blinnphong", 59.0, 52.5), (HALF, "ggx", 49.0, 42.0)]
    {
        let made = made(image, model);
        let (own_mean, own_worst) = quality(&made, model, 96);
        println!("{model}: mean {own_mean:.2}, least {own_worst:.2} dB");
        assert!(own_mean >= mean && own_worst >= worst, "{model}: {own_mean} {own_worst}");
    }
}
