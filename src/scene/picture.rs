//! Pictures as files: PNG, and OpenEXR with the exact picture, the core's and their difference.

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, ImageAttributes, IntegerBounds, Layer, LayerAttributes,
    Vec2, WritableImage as _,
};

use super::Picture;
use crate::platform::error::Error;
use crate::reflectance::images;

/// Pixels of 8 or 16 bits a channel, as a PNG file has them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Bits of a channel: 8 or 16.
    pub depth: u32,
    /// Red, green and blue of each pixel, row by row from the top; full scale is `2^depth - 1`.
    pub codes: Vec<[u16; 3]>,
}

impl Pixels {
    /// Pixels of one colour.
    #[must_use]
    pub fn filled(width: u32, height: u32, depth: u32, colour: [u16; 3]) -> Self {
        Self { width, height, depth, codes: vec![colour; width as usize * height as usize] }
    }

    /// Puts other pixels of this depth at a place, each as a square of `zoom` by `zoom`; they lie within the whole.
    pub fn put(&mut self, (left, top): (u32, u32), zoom: u32, other: &Self) {
        let (stride, zoom) = (self.width as usize, zoom as usize);
        for (y, row) in other.codes.chunks_exact(other.width as usize).enumerate() {
            let start = (top as usize + y * zoom) * stride + left as usize;
            let end = start + zoom * row.len();
            for (to, &from) in self.codes[start..end].chunks_exact_mut(zoom).zip(row) {
                to.fill(from);
            }
            for line in 1..zoom {
                self.codes.copy_within(start..end, start + line * stride);
            }
        }
    }

    /// The PNG file: RGB without alpha. Same pixels, same bytes.
    #[must_use]
    pub fn png(&self) -> Vec<u8> {
        images::encoded([self.width, self.height], self.depth, None, &self.codes)
    }
}

impl Picture {
    /// The picture as pixels of 8 bits, or of 16 where its channels have more than 8: each code scaled to the full
    /// range and rounded to the nearest.
    #[must_use]
    pub fn pixels(&self) -> Pixels {
        let depth = if self.channel_bits > 8 { 16 } else { 8 };
        let (from, to) = ((1u32 << self.channel_bits) - 1, (1u32 << depth) - 1);
        let scaled = |code: u16| ((u32::from(code) * to + from / 2) / from) as u16;
        let codes = self.codes.iter().map(|pixel| pixel.map(scaled)).collect();
        Pixels { width: self.width, height: self.height, depth, codes }
    }
}

/// The OpenEXR file of a picture beside the exact one: the layers `exact` and `core` with the channels as parts of full
/// scale, and `difference`, core less exact, in output steps. Channels R, G and B of 32-bit floating-point numbers;
/// same pictures, same bytes.
///
/// # Errors
/// A picture that is too large for the format.
///
/// # Panics
/// On pictures of two sizes or depths.
pub fn exr(exact: &Picture, core: &Picture) -> Result<Vec<u8>, Error> {
    let same = |p: &Picture| (p.width, p.height, p.channel_bits);
    assert_eq!(same(exact), same(core), "pictures of one size");
    let size = Vec2(exact.width as usize, exact.height as usize);
    let full = ((1u32 << exact.channel_bits) - 1) as f32;
    let layer = |name: &str, value: &dyn Fn(usize, usize) -> f32| {
        // In the order of their names, as the format has them.
        let channels = [("B", 2), ("G", 1), ("R", 0)].map(|(name, channel)| {
            let samples = (0..exact.codes.len()).map(|pixel| value(pixel, channel)).collect();
            AnyChannel::new(name, FlatSamples::F32(samples))
        });
        let channels = AnyChannels::sort(channels.into_iter().collect());
        Layer::new(size, LayerAttributes::named(name), Encoding::SMALL_LOSSLESS, channels)
    };
    let code = |picture: &Picture, pixel: usize, channel: usize| f32::from(picture.codes[pixel][channel]);
    let layers = vec![
        layer("exact", &|pixel, channel| code(exact, pixel, channel) / full),
        layer("core", &|pixel, channel| code(core, pixel, channel) / full),
        layer("difference", &|pixel, channel| code(core, pixel, channel) - code(exact, pixel, channel)),
    ];
    let image = Image::from_layers(ImageAttributes::new(IntegerBounds::from_dimensions(size)), layers);
    let mut bytes = Cursor::new(Vec::new());
    image
        .write()
        .to_buffered(&mut bytes)
        .map_err(|error| Error::input(format!("the picture cannot be written as OpenEXR: {error}"), "a smaller one"))?;
    Ok(bytes.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let bytes = super::exr(&exact, &core).unwrap();
        assert_eq!(bytes, super::exr(&exact, &core).unwrap());
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
}
