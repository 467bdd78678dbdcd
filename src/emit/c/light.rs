//! The function that makes the records of lights for an image-based core: [`ImageBlock::light_codes`] in C, bit for
//! bit, for a driver that has neither this library nor floating point.
//!
//! [`ImageBlock::light_codes`]: crate::block::image::ImageBlock::light_codes

use askama::Template;

use crate::block::CHANNELS;
use crate::block::image::{FrontEnd, Image, ImageForm, RecordTable};
use crate::core::{Direction, ImageDesign};
use crate::emit::render;
use crate::fixed::{Format, turn};
use crate::platform::error::Error;

/// The function for a core.
#[derive(Clone, Debug)]
pub struct LightFunction<'a> {
    /// The core's name.
    pub name: String,
    /// The lines of the header comment, without a comment marker.
    pub header: Vec<String>,
    upper: String,
    form: ImageForm,
    has_direction: bool,
    /// Whether the core makes the record, and is told the vector and the intensity alone.
    is_vector: bool,
    /// Fraction bits of a turn's code.
    angle_bits: u32,
    fields: Vec<RecordField>,
    table: &'a RecordTable,
    vector_fraction: u32,
    weight_bits: u32,
    /// Fraction bits of a gain's code, and the greatest.
    gain_bits: u32,
    gain_width: u32,
    most_gain: u64,
    most_shift: i32,
    // How sines are computed.
    sines: &'static [u64],
    fraction: u32,
    step_bits: u32,
    half_pi: u64,
    half_pi_bits: u32,
    reciprocal_bits: u32,
}

/// A field of the structure with a record's codes.
#[derive(Clone, Debug)]
struct RecordField {
    /// Its declarator.
    declared: String,
    /// The ports of the first light that take it.
    ports: String,
    format: String,
}

/// The fields of a record: those of [`ImageBlock::light_codes`] in their order.
///
/// [`ImageBlock::light_codes`]: crate::block::image::ImageBlock::light_codes
fn fields(image: ImageDesign<'_>) -> Vec<RecordField> {
    let of = &image.of.image;
    let frame = of.frame().iter().map(|(name, axes)| (*name, Some(axes.len())));
    let mut shape = Vec::new();
    shape.extend(of.has_incidence().then_some(("direction", Some(3))));
    if of.front_end == FrontEnd::Vector {
        shape.push(("intensity", Some(CHANNELS.len())));
    } else {
        shape.extend(frame);
        shape.extend([("band", None), ("blend", None)]);
        if of.has_turns() {
            shape.extend(["turn_even", "turn_odd", "alone"].map(|name| (name, None)));
        }
        shape.extend((image.block.widths().shift > 0).then_some(("shift", None)));
        shape.push(("gain", Some(CHANNELS.len())));
    }
    let numbers = image.numbers(Direction::In);
    let mut ports: &[(&str, Format)] = &numbers[3..];
    let field = |(name, count): (&str, Option<usize>)| {
        let (own, rest) = ports.split_at(count.unwrap_or(1));
        ports = rest;
        let names: Vec<&str> = own.iter().map(|(port, _)| *port).collect();
        RecordField {
            declared: name.to_owned() + &count.map_or(String::new(), |count| format!("[{count}]")),
            ports: names.join(", "),
            format: own[0].1.to_string(),
        }
    };
    shape.into_iter().map(field).collect()
}

impl<'a> LightFunction<'a> {
    /// The function for an image-based core, without a header; none of the form matcap, which is told of no lights.
    #[must_use]
    pub fn of(design: ImageDesign<'a>) -> Option<Self> {
        let (image, widths) = (&design.of.image, design.block.widths());
        image.has_lights().then(|| Self {
            name: design.spec.name.clone(),
            header: Vec::new(),
            upper: design.spec.name.to_ascii_uppercase(),
            form: image.form.clone(),
            has_direction: image.has_incidence(),
            is_vector: image.front_end == FrontEnd::Vector,
            angle_bits: Image::TURN_BITS,
            fields: fields(design),
            table: design.block.record_table(),
            vector_fraction: image.vector_fraction,
            weight_bits: image.weight_bits,
            gain_bits: widths.gain as u32,
            gain_width: widths.gain_format().width(),
            most_gain: widths.gain_format().max_code() as u64,
            most_shift: widths.shift,
            sines: &*turn::SINES,
            fraction: turn::FRACTION,
            step_bits: turn::STEP_BITS,
            half_pi: turn::HALF_PI,
            half_pi_bits: turn::HALF_PI_BITS,
            reciprocal_bits: RecordTable::RECIPROCAL_BITS,
        })
    }

    /// The paths of its files in the core's directory, the header first.
    #[must_use]
    pub fn paths(name: &str) -> [String; 2] {
        ["h", "c"].map(|extension| format!("model/{name}_light.{extension}"))
    }

    /// The texts of its files, the header first.
    ///
    /// # Errors
    /// If a template cannot be filled in.
    pub fn emit(&self) -> Result<[String; 2], Error> {
        Ok([render(&Header { c: self })?, render(&Source { c: self })?])
    }
}

#[derive(Template)]
#[template(path = "c/light.h", escape = "none")]
struct Header<'a> {
    c: &'a LightFunction<'a>,
}

#[derive(Template)]
#[template(path = "c/light.c", escape = "none")]
struct Source<'a> {
    c: &'a LightFunction<'a>,
}
