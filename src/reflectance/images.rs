//! Sphere images as picture files: PNG with 8 or 16 bits a channel, OpenEXR with 32-bit floating-point channels. +y is
//! at the top of a file.

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, ImageAttributes, IntegerBounds, Layer, LayerAttributes,
    ReadChannels as _, ReadLayers as _, Vec2, WritableImage as _,
};

use super::form::LARGEST;
use crate::platform::error::Error;

/// The largest picture file, in bytes.
pub const MAX_PICTURE: u64 = 512 << 20;

const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";
const EXR: &[u8] = b"\x76\x2f\x31\x01";

/// Whether a file begins like a picture of one of the two kinds.
#[must_use]
pub fn is_picture(start: &[u8]) -> bool {
    start.starts_with(PNG) || start.starts_with(EXR)
}

/// A PNG file's pixels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Pixels {
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Bits of a channel: 8 or 16.
    pub depth: u32,
    /// The exponent of the file's codes over linear light, where it tells: 1 for linear ones, 0.45 for a display's.
    pub gamma: Option<f64>,
    /// Red, green and blue codes of each pixel; full scale is `2^depth - 1`.
    pub codes: Vec<[u16; 3]>,
}

fn wrong(name: &str, what: impl std::fmt::Display) -> Error {
    Error::input(
        format!("{name}: {what}"),
        format!("a PNG or OpenEXR picture in colours, of at most {LARGEST} × {LARGEST} pixels"),
    )
}

fn check_size(width: usize, height: usize, name: &str) -> Result<(), Error> {
    if (1..=LARGEST).contains(&width) && (1..=LARGEST).contains(&height) {
        return Ok(());
    }
    Err(wrong(name, format_args!("the picture has {width} × {height} pixels")))
}

/// The PNG file of pixels: RGB without alpha. Same pixels, same bytes.
///
/// # Panics
/// If there are not as many codes as pixels.
#[must_use]
pub fn png(pixels: &Pixels) -> Vec<u8> {
    let Pixels { width, height, depth, gamma, codes } = pixels;
    encoded([*width as u32, *height as u32], *depth, *gamma, codes)
}

/// The PNG file of codes of 8 or 16 bits, row by row from the top: RGB without alpha. Same codes, same bytes.
///
/// # Panics
/// If there is not a code for each pixel, or no pixel.
#[must_use]
pub fn encoded([width, height]: [u32; 2], depth: u32, gamma: Option<f64>, codes: &[[u16; 3]]) -> Vec<u8> {
    assert_eq!(codes.len(), width as usize * height as usize, "a code for each pixel");
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    if let Some(gamma) = gamma {
        encoder.set_source_gamma(png::ScaledFloat::new(gamma as f32));
    }
    let channels = codes.as_flattened();
    let data: Vec<u8> = if depth == 8 {
        encoder.set_depth(png::BitDepth::Eight);
        channels.iter().map(|&code| code as u8).collect()
    } else {
        encoder.set_depth(png::BitDepth::Sixteen);
        channels.iter().flat_map(|code| code.to_be_bytes()).collect()
    };
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&data));
    written.expect("a picture that has pixels, in memory");
    bytes
}

/// Reads a PNG file; greys become colours, transparency is left out.
///
/// # Errors
/// What is no such file, or larger than an image may be.
pub fn read_png(bytes: &[u8], name: &str) -> Result<Pixels, Error> {
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: MAX_PICTURE as usize });
    decoder.set_transformations(png::Transformations::EXPAND);
    let failed = |error| wrong(name, format_args!("the picture cannot be read: {error}"));
    let mut reader = decoder.read_info().map_err(failed)?;
    let (width, height) = (reader.info().width as usize, reader.info().height as usize);
    check_size(width, height, name)?;
    let gamma = reader.info().gamma().map(|gamma| f64::from(gamma.into_value()));
    let size = reader.output_buffer_size().ok_or_else(|| wrong(name, "the picture is too large"))?;
    let mut data = vec![0; size];
    let info = reader.next_frame(&mut data).map_err(failed)?;
    let (depth, channels): (u32, Vec<u16>) = match info.bit_depth {
        png::BitDepth::Sixteen => (16, data.as_chunks::<2>().0.iter().map(|&pair| u16::from_be_bytes(pair)).collect()),
        _ => (8, data.iter().map(|&byte| byte.into()).collect()),
    };
    let samples = info.color_type.samples();
    let colour = |pixel: &[u16]| if samples < 3 { [pixel[0]; 3] } else { [pixel[0], pixel[1], pixel[2]] };
    let codes: Vec<[u16; 3]> = channels.chunks_exact(samples).take(width * height).map(colour).collect();
    if codes.len() < width * height {
        return Err(wrong(name, "the picture is cut short"));
    }
    Ok(Pixels { width, height, depth, gamma, codes })
}

/// The OpenEXR file of a square picture: channels R, G and B of 32-bit floating-point numbers, rows from the top.
///
/// # Errors
/// A picture that is too large for the format.
pub fn exr(width: usize, pixels: &[[f32; 3]]) -> Result<Vec<u8>, Error> {
    let size = Vec2(width, pixels.len() / width);
    let channels = [("B", 2), ("G", 1), ("R", 0)]
        .map(|(name, c)| AnyChannel::new(name, FlatSamples::F32(pixels.iter().map(|pixel| pixel[c]).collect())));
    let channels = AnyChannels::sort(channels.into_iter().collect());
    let layer = Layer::new(size, LayerAttributes::default(), Encoding::SMALL_LOSSLESS, channels);
    let image = Image::from_layers(ImageAttributes::new(IntegerBounds::from_dimensions(size)), vec![layer]);
    let mut bytes = Cursor::new(Vec::new());
    let written = image.write().non_parallel().to_buffered(&mut bytes);
    written
        .map_err(|error| Error::input(format!("the picture cannot be written as OpenEXR: {error}"), "a smaller one"))?;
    Ok(bytes.into_inner())
}

/// Reads an OpenEXR file: width, height, and the pixels row by row from the top.
///
/// # Errors
/// What is no such file with channels R, G and B, or larger than an image may be; a pixel that is no finite number.
pub fn read_exr(bytes: &[u8], name: &str) -> Result<(usize, usize, Vec<[f32; 3]>), Error> {
    let failed = |error| wrong(name, format_args!("the picture cannot be read: {error}"));
    // The size that a header asks for is looked at before memory is taken for it.
    let meta = exr::meta::MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(failed)?;
    for header in &meta.headers {
        check_size(header.layer_size.width(), header.layer_size.height(), name)?;
    }
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size: Vec2<usize>, _: &_| (size.width(), vec![[0.0f32; 3]; size.area()]),
            |(width, pixels): &mut (usize, Vec<[f32; 3]>), at: Vec2<usize>, (r, g, b): (f32, f32, f32)| {
                pixels[at.y() * *width + at.x()] = [r, g, b];
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))
        .map_err(failed)?;
    let (width, pixels) = image.layer_data.channel_data.pixels;
    if let Some(place) = pixels.iter().position(|pixel| !pixel.iter().all(|value| value.is_finite())) {
        let [r, g, b] = pixels[place];
        return Err(wrong(name, format_args!("the pixel {}, {} holds {r}, {g}, {b}", place % width, place / width)));
    }
    Ok((width, pixels.len() / width, pixels))
}

/// Reads a picture of either kind as linear light, rows from the bottom: a PNG file's codes by the exponent that it
/// tells, or as sRGB.
///
/// # Errors
/// As [`read_png`] and [`read_exr`].
pub fn read_linear(bytes: &[u8], name: &str) -> Result<(usize, usize, Vec<[f32; 3]>), Error> {
    let (width, height, mut data) = if bytes.starts_with(EXR) {
        let (width, height, pixels) = read_exr(bytes, name)?;
        (width, height, pixels.into_iter().map(|pixel| pixel.map(|value| value.max(0.0))).collect())
    } else {
        let Pixels { width, height, depth, gamma, codes } = read_png(bytes, name)?;
        let full = f64::from((1u32 << depth) - 1);
        let linear = |code: u16| {
            let part = f64::from(code) / full;
            (match gamma.filter(|gamma| (0.05..=20.0).contains(gamma)) {
                Some(gamma) => libm::pow(part, 1.0 / gamma),
                None if part <= 0.040_45 => part / 12.92,
                None => libm::pow((part + 0.055) / 1.055, 2.4),
            }) as f32
        };
        (width, height, codes.into_iter().map(|pixel| pixel.map(linear)).collect::<Vec<_>>())
    };
    flip(width, &mut data);
    Ok((width, height, data))
}

/// Turns the order of rows round.
pub fn flip<T>(width: usize, data: &mut [T]) {
    let height = data.len() / width;
    for row in 0..height / 2 {
        let (low, high) = data.split_at_mut((height - 1 - row) * width);
        low[row * width..][..width].swap_with_slice(&mut high[..width]);
    }
}
