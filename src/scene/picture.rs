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
