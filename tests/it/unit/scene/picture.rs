use std::io::Cursor;

use brdfgen::scene::Picture;
use brdfgen::scene::picture::*;

/// A picture in which every pixel is another.
fn picture(width: u32, height: u32, channel_bits: u32, salt: u32) -> Picture {
    let full = (1 << channel_bits) - 1;
    let code = |pixel: u32, channel: u32| ((pixel * 7919 + channel * 104_729 + salt * 31) % (full + 1)) as u16;
    let mut codes: Vec<_> = (0..width * height).map(|pixel| [0, 1, 2].map(|c| code(pixel, c))).collect();
    codes[0] = [0, full as u16, 1];
    Picture { width, height, channel_bits, codes }
}

fn read_png(bytes: &[u8]) -> Pixels {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let mut data = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut data).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb);
    let (depth, channels): (u32, Vec<u16>) = match info.bit_depth {
        png::BitDepth::Eight => (8, data.iter().map(|&byte| byte.into()).collect()),
        _ => (16, data.as_chunks::<2>().0.iter().map(|&pair| u16::from_be_bytes(pair)).collect()),
    };
    let codes = channels.as_chunks::<3>().0.to_vec();
    Pixels { width: info.width, height: info.height, depth, codes }
}

#[test]
fn png_holds_every_code() {
    for bits in [8, 10, 12] {
        let picture = picture(37, 23, bits, 0);
        let pixels = picture.pixels();
        assert_eq!(pixels.depth, if bits == 8 { 8 } else { 16 });
        let read = read_png(&pixels.png());
        assert_eq!(read, pixels);
        let (full, top) = (f64::from((1u32 << bits) - 1), f64::from((1u32 << read.depth) - 1));
        for (code, &stored) in picture.codes.iter().flatten().zip(read.codes.iter().flatten()) {
            // The nearest of 16 bits, and back.
            assert!((f64::from(stored) - f64::from(*code) * top / full).abs() <= 0.5);
            assert_eq!((f64::from(stored) * full / top).round(), f64::from(*code));
        }
        assert_eq!(read.codes[0][..2], [0, ((1u32 << read.depth) - 1) as u16]);
    }
}

#[test]
fn pixels_are_put_as_squares() {
    let small = picture(5, 4, 8, 1).pixels();
    for zoom in 1..4 {
        let grey = [77; 3];
        let mut all = Pixels::filled(30, 20, 8, grey);
        all.put((6, 3), zoom, &small);
        for (place, &pixel) in all.codes.iter().enumerate() {
            let (x, y) = (place as u32 % 30, place as u32 / 30);
            let inside = (6..6 + 5 * zoom).contains(&x) && (3..3 + 4 * zoom).contains(&y);
            let from = || small.codes[(((y - 3) / zoom) * 5 + (x - 6) / zoom) as usize];
            assert_eq!(pixel, if inside { from() } else { grey }, "zoom {zoom} at {x}, {y}");
        }
    }
}

#[test]
fn exr_holds_the_three_layers() {
    use exr::prelude::*;
    let (exact, core) = (picture(40, 30, 10, 0), picture(40, 30, 10, 1));
    let bytes = exr(&exact, &core).unwrap();
    assert_eq!(bytes, exr(&exact, &core).unwrap());
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .all_layers()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .unwrap();
    let names: Vec<_> =
        image.layer_data.iter().map(|layer| layer.attributes.layer_name.as_ref().unwrap().to_string()).collect();
    assert_eq!(names, ["exact", "core", "difference"]);
    for (layer, name) in image.layer_data.iter().zip(names) {
        assert_eq!(layer.size, Vec2(40, 30));
        for (channel, letter) in [(0, "R"), (1, "G"), (2, "B")] {
            let data = layer.channel_data.list.iter().find(|data| data.name.eq(letter)).unwrap();
            for (pixel, value) in data.sample_data.values_as_f32().enumerate() {
                let (e, c) = (f32::from(exact.codes[pixel][channel]), f32::from(core.codes[pixel][channel]));
                let wanted = match name.as_str() {
                    "exact" => e / 1023.0,
                    "core" => c / 1023.0,
                    _ => c - e,
                };
                assert_eq!(value, wanted);
            }
        }
    }
}
