use brdfgen::reflectance::texels::*;

use super::samples::random;

fn samples(width: usize, height: usize, layers: usize, most: f64) -> Samples {
    let mut random = random(21);
    let data = (0..width * height * layers).map(|_| [(); 3].map(|()| (most * random() * random()) as f32)).collect();
    Samples { width, height, data }
}

#[test]
fn texels_are_named() {
    for text in ["float", "linear:8", "linear:1", "sqrt:16", "sqrt:6:8", "sqrt:8:0.5", "565"] {
        assert_eq!(text.parse::<Texel>().unwrap().to_string(), text);
    }
    assert_eq!("sqrt".parse::<Texel>().unwrap(), Texel::Sqrt(8, None));
    for text in ["", "linear:0", "linear:17", "sqrt:8:0", "sqrt:8:nan", "sqrt:8:inf", "555", "float:8", "linear:8:2"] {
        assert!(text.parse::<Texel>().unwrap_err().contains("`565`"), "{text}");
    }
}

#[test]
fn codes_are_within_half_a_step() {
    let samples = samples(5, 4, 3, 40.0);
    for (text, scale) in [
        ("float", Scale::Layer),
        ("linear:8", Scale::Layer),
        ("sqrt:8", Scale::Layer),
        ("sqrt:6", Scale::Row),
        ("sqrt:16:100", Scale::Layer),
        ("565", Scale::Row),
    ] {
        let texel: Texel = text.parse().unwrap();
        let texels = Texels::encode(&samples, texel, scale);
        assert_eq!((texels.layers(), texels.caps().len()), (3, if scale == Scale::Row { 12 } else { 3 }));
        let band = if scale == Scale::Row { 5 } else { 20 };
        for (place, sample) in samples.data.iter().enumerate() {
            for c in 0..3 {
                let cap = texels.caps()[place / band];
                let part = f64::from(sample[c]) / cap;
                let wanted = if texels.is_root() { part.sqrt() } else { part };
                let step = texel.full().map_or(1e-9, |full| 0.5000001 / f64::from(full[c]));
                assert!((f64::from(texels.codes()[place][c]) - wanted).abs() <= step + 1e-7, "{text}");
            }
        }
    }
    let unit = Texels::encode(&samples, Texel::Linear(8), Scale::Unit);
    assert!(unit.caps().iter().all(|&cap| cap == 1.0) && unit.codes().iter().flatten().all(|&code| code <= 1.0));
    assert_eq!(unit.kib(), 3.0 * 20.0 * 3.0 / 1024.0);
    assert!(!Texels::encode(&samples, Texel::Packed565, Scale::Unit).is_root());
    // Black bands have no full scale.
    let black = Samples { data: vec![[0.0; 3]; 60], ..samples };
    let black = Texels::encode(&black, Texel::Sqrt(8, None), Scale::Row);
    assert!(black.codes().iter().flatten().all(|&code| code == 0.0) && black.bilinear(2, 0.3, 0.8) == [0.0; 3]);
}

#[test]
fn centres_are_met_and_edges_stay() {
    let samples = samples(4, 2, 2, 1.0);
    let texels = Texels::encode(&samples, Texel::Float, Scale::Layer);
    for (layer, y, x) in [(0, 0, 0), (1, 1, 3), (1, 0, 2)] {
        let read = texels.bilinear(layer, (x as f64 + 0.5) / 4.0, (y as f64 + 0.5) / 2.0);
        let wanted = samples.data[layer * 8 + y * 4 + x].map(f64::from);
        assert!((0..3).all(|c| (read[c] - wanted[c]).abs() < 1e-12));
    }
    assert_eq!(texels.bilinear(0, -3.0, 0.1), texels.bilinear(0, 0.125, 0.1));
    assert_eq!(texels.bilinear(0, 3.0, 9.0), texels.bilinear(0, 0.875, 0.75));
    let middle = texels.bilinear(0, 0.25, 0.25)[1];
    assert!((middle - 0.5 * f64::from(samples.data[0][1] + samples.data[1][1])).abs() < 1e-7);
}
