use brdfgen::reflectance::images::*;

fn pixels(depth: u32, gamma: Option<f64>) -> Pixels {
    let full = (1u32 << depth) - 1;
    let codes = (0..5 * 3u32).map(|i| [0, 1, 2].map(|c| ((i * 7919 + c * 104_729) % (full + 1)) as u16)).collect();
    Pixels { width: 5, height: 3, depth, gamma, codes }
}

#[test]
fn pictures_are_read_again() {
    for (depth, gamma) in [(8, None), (8, Some(1.0)), (16, Some(0.5)), (16, None)] {
        let pixels = pixels(depth, gamma);
        assert_eq!(read_png(&png(&pixels), "p").unwrap(), pixels);
    }
    let data: Vec<[f32; 3]> = (0..12).map(|i| [i as f32, 1e-9 * i as f32, 1e6]).collect();
    assert_eq!(read_exr(&exr(4, &data).unwrap(), "e").unwrap(), (4, 3, data));
}

#[test]
fn matcaps_are_linear_light_from_the_bottom() {
    let mut picture = Pixels { width: 2, height: 2, depth: 8, gamma: None, codes: vec![[255, 188, 0]; 4] };
    picture.codes[0] = [0; 3];
    let read = |picture: &Pixels| read_linear(&png(picture), "p").unwrap().2;
    let srgb = read(&picture);
    // The code 188 of sRGB is half of the light; the first row of the file is the last here.
    assert_eq!(srgb[2], [0.0; 3]);
    assert!((srgb[0][1] - 0.5).abs() < 0.005 && srgb[0][0] == 1.0);
    picture.gamma = Some(1.0);
    assert!((read(&picture)[0][1] - 188.0 / 255.0).abs() < 1e-6);
    picture.gamma = Some(0.5);
    assert!((read(&picture)[0][1] - (188.0f32 / 255.0).powi(2)).abs() < 1e-5);
}

#[test]
fn what_is_no_picture_is_refused() {
    let file = png(&pixels(8, None));
    let exr_start = b"\x76\x2f\x31\x01";
    for bytes in [&b""[..], &file[..20], &file[..file.len() - 30], b"\x89PNG\r\n\x1a\nrubbish", exr_start] {
        let said =
            if bytes == exr_start { read_exr(bytes, "p").unwrap_err() } else { read_png(bytes, "p").unwrap_err() };
        assert!(said.to_string().starts_with("p: the picture"), "{said}");
    }
    // A header that asks for 2^31 pixels a row, with its check sum made anew by the writer.
    let mut bytes = Vec::new();
    png::Encoder::new(&mut bytes, 1 << 30, 1 << 20).write_header().map(drop).unwrap();
    assert!(read_png(&bytes, "p").is_err());
    let nan = exr(2, &[[f32::NAN; 3]; 4]).unwrap();
    assert!(read_exr(&nan, "p").unwrap_err().to_string().contains("the pixel 0, 0 holds NaN"));
}
