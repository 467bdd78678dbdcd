//! Pages of pictures with what is to be said of them: exact, core and difference side by side, and contact sheets of
//! several cores.
//!
//! The text is drawn as SVG; the pictures are put in as they are, each pixel as a square of whole pixels.

use std::fmt::Write as _;

use serde::Serialize;

use super::frame::BACKGROUND;
use super::{Difference, Frame, Picture, Pixels};
use crate::plot;

type Rgb = [u8; 3];

/// A heat map's colour where there is no object: neutral.
pub const NO_OBJECT: Rgb = [0x40, 0x40, 0x40];
/// A heat map's colour of a pixel that is not off.
pub const EQUAL: Rgb = [0x0a, 0x0c, 0x10];
/// A heat map's colours of pixels that are off by 1, 2, 3 to 4, 5 to 8, and so on to 33 to 64 and more than 64 steps:
/// the upper part of the map plasma of Smith and van der Walt (matplotlib, CC0), whose lightness rises evenly for
/// people who see red and green alike too.
pub const HEAT: [Rgb; 8] = [
    [0x72, 0x01, 0xa8],
    [0x9c, 0x17, 0x9e],
    [0xbd, 0x37, 0x86],
    [0xd8, 0x57, 0x6b],
    [0xed, 0x79, 0x53],
    [0xfb, 0x9f, 0x3a],
    [0xfd, 0xca, 0x26],
    [0xf0, 0xf9, 0x21],
];

const PAPER: Rgb = [0xff; 3];
const INK: &str = "#1b1f24";
const GREY: &str = "#59636e";

/// A page: pixels, and where in them the pictures are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sheet {
    /// The page.
    pub pixels: Pixels,
    /// The pictures on it.
    pub panels: Vec<Panel>,
}

/// A picture's place on a page.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Panel {
    /// What it shows.
    pub shows: Shows,
    /// The cell of a contact sheet that it belongs to, from 0, row by row; 0 on other pages.
    pub cell: usize,
    /// The page's pixel at its left.
    pub left: u32,
    /// The page's pixel at its top.
    pub top: u32,
    /// The side of the square that each of its pixels is.
    pub zoom: u32,
}

/// What a picture on a page shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shows {
    /// The exact picture.
    Exact,
    /// The core's.
    Core,
    /// How far the core's is off, as a heat map.
    Difference,
}

/// A core's picture on a contact sheet.
#[derive(Clone, Debug)]
pub struct Cell {
    /// The core's name.
    pub name: String,
    /// Its picture.
    pub picture: Picture,
    /// How that differs from the exact one.
    pub difference: Difference,
    /// What is to be said of it before its error, such as its cost; a line each.
    pub lines: Vec<String>,
    /// What is to be said of its error.
    pub verdict: String,
}

/// The place in the heat map's scale of a pixel that is off by so many steps: 0 if it is not off, else 1 and the place
/// in [`HEAT`].
#[must_use]
pub fn class(steps: u16) -> usize {
    // Powers of two are the last of their class.
    steps.checked_sub(1).map_or(0, |above| ((u16::BITS - above.leading_zeros()) as usize + 1).min(HEAT.len()))
}

/// The colour of a class.
fn colour(class: usize) -> Rgb {
    class.checked_sub(1).map_or(EQUAL, |place| HEAT[place])
}

/// The steps of a class.
fn label(class: usize) -> String {
    match class {
        0..=2 => class.to_string(),
        last if last == HEAT.len() => format!("> {}", 1 << (last - 2)),
        _ => format!("{}–{}", (1 << (class - 2)) + 1, 1 << (class - 1)),
    }
}

/// The heat map of a difference.
#[must_use]
pub fn heat_map(frame: &Frame, difference: &Difference, depth: u32) -> Pixels {
    let of = |(&material, &steps): (&u16, &u16)| {
        deep(if material == BACKGROUND && steps == 0 { NO_OBJECT } else { colour(class(steps)) }, depth)
    };
    let codes = frame.material.iter().zip(&difference.steps).map(of).collect();
    Pixels { width: frame.width, height: frame.height, depth, codes }
}

fn deep(colour: Rgb, depth: u32) -> [u16; 3] {
    colour.map(|channel| u16::from(channel) * if depth == 16 { 257 } else { 1 })
}

/// A count with a blank at each thousand.
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    text
}

/// A part of a whole in percent.
fn percent(part: u64, whole: u64) -> String {
    let percent = 100.0 * part as f64 / whole as f64;
    match part {
        0 => "0 %".to_owned(),
        part if part == whole => "100 %".to_owned(),
        _ if percent < 0.01 => "< 0.01 %".to_owned(),
        _ if percent < 10.0 => format!("{percent:.2} %"),
        _ => format!("{:.1} %", percent.min(99.9)),
    }
}

fn steps(count: u16) -> String {
    format!("{count} {}", if count == 1 { "step" } else { "steps" })
}

/// A difference in words: the largest, the mean, the signal-to-noise ratio and the share of pixels that are off.
#[must_use]
pub fn figures(difference: &Difference) -> [String; 4] {
    let all: u64 = difference.pixels.iter().sum();
    let psnr = difference.psnr.map_or_else(|| "the same picture".to_owned(), |psnr| format!("PSNR {psnr:.1} dB"));
    let mean = match difference.mean_steps {
        mean if mean > 0.0 && mean < 0.0001 => "mean below 0.0001".to_owned(),
        mean => format!("mean {mean:.4}"),
    };
    let off = all - difference.pixels[0];
    [format!("at most {} off", steps(difference.max_steps)), mean, psnr, format!("{} of pixels off", percent(off, all))]
}

/// A page in the making.
struct Page<'a> {
    svg: String,
    pictures: Vec<(Panel, &'a Pixels)>,
    /// The size of the text in pixels.
    unit: f64,
}

impl<'a> Page<'a> {
    fn new(unit: f64) -> Self {
        Self { svg: String::new(), pictures: Vec::new(), unit }
    }

    /// So many units in whole pixels.
    fn units(&self, count: f64) -> u32 {
        libm::round(count * self.unit) as u32
    }

    /// A line of text, its top left at a place.
    fn text(&mut self, (left, top): (u32, u32), size: f64, colour: &str, text: &str) {
        let size = size * self.unit;
        let _ = writeln!(
            self.svg,
            "<text x=\"{left}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{size}\" fill=\"{colour}\">{}</text>",
            f64::from(top) + 0.95 * size,
            plot::escaped(text),
        );
    }

    /// The title and the lines below it, from the upper margin on; where they end.
    fn heading(&mut self, (margin, width): (u32, u32), title: &str, lines: &[String]) -> u32 {
        let below = self.paragraph((margin, margin), width, 1.6, INK, title) + self.units(0.2);
        lines.iter().fold(below, |y, line| self.paragraph((margin, y), width, 1.0, GREY, line))
    }

    /// Text in as many lines as the width needs; returns the first pixel below it.
    fn paragraph(&mut self, (left, top): (u32, u32), width: u32, size: f64, colour: &str, text: &str) -> u32 {
        let mut below = top;
        for line in self.lines(width, size, text) {
            self.text((left, below), size, colour, &line);
            below += self.units(1.35 * size);
        }
        below
    }

    /// Text in lines that are no wider than this, where its words allow it.
    fn lines(&self, width: u32, size: f64, text: &str) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        for word in text.split(' ') {
            let longer = lines.last().map(|line| format!("{line} {word}"));
            match longer.filter(|longer| plot::text_width(longer, size * self.unit) <= f64::from(width)) {
                Some(longer) => *lines.last_mut().expect("the line that is longer") = longer,
                None => lines.push(word.to_owned()),
            }
        }
        lines
    }

    fn picture(&mut self, panel: Panel, pixels: &'a Pixels) {
        self.pictures.push((panel, pixels));
    }

    /// The scale of the heat map up to a class, with a second line to each colour, in as many rows as the width needs;
    /// returns the first pixel below it.
    fn legend(&mut self, (left, top): (u32, u32), width: u32, entries: &[Entry]) -> u32 {
        let two_lines = entries.iter().any(|entry| !entry.note.is_empty());
        let row = self.units(if two_lines { 2.6 } else { 1.5 });
        let swatch = self.units(1.5);
        let (mut x, mut y) = (left, top);
        for Entry { colour, label, note } in entries {
            let text = |text: &str, size: f64| plot::text_width(text, size * self.unit);
            let wide = swatch + self.units(1.2) + libm::ceil(text(label, 1.0).max(text(note, 0.8))) as u32;
            if x > left && x + wide > left + width {
                (x, y) = (left, y + row);
            }
            let [r, g, b] = *colour;
            let _ = writeln!(
                self.svg,
                "<rect x=\"{x}\" y=\"{y}\" width=\"{swatch}\" height=\"{}\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>",
                self.units(1.1),
            );
            let beside = x + swatch + self.units(0.4);
            self.text((beside, y), 1.0, INK, label);
            self.text((beside, y + self.units(1.3)), 0.8, GREY, note);
            x += wide;
        }
        y + row
    }

    /// The page, with text and pictures.
    fn finish(self, width: u32, height: u32, depth: u32) -> Sheet {
        let svg = format!(
            "<svg width=\"{width}\" height=\"{height}\" xmlns=\"http://www.w3.org/2000/svg\">\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{}</svg>\n",
            self.svg
        );
        let mut pixels = Pixels::filled(width, height, depth, deep(PAPER, depth));
        for (to, from) in pixels.codes.iter_mut().zip(plot::draw(&svg, 1.0).pixels()) {
            *to = deep([from.red(), from.green(), from.blue()], depth);
        }
        for (panel, picture) in &self.pictures {
            pixels.put((panel.left, panel.top), panel.zoom, picture);
        }
        Sheet { pixels, panels: self.pictures.into_iter().map(|(panel, _)| panel).collect() }
    }
}

/// A colour of a legend with what it means.
struct Entry {
    colour: Rgb,
    label: String,
    note: String,
}

/// The scale of the heat map up to the class of `max_steps`.
fn entries(max_steps: u16, note: impl Fn(usize) -> String, no_object: String) -> Vec<Entry> {
    let entry = |class| {
        let label = if class == 0 { "0 steps".to_owned() } else { label(class) };
        Entry { colour: colour(class), label, note: note(class) }
    };
    let background = Entry { colour: NO_OBJECT, label: "no object".to_owned(), note: no_object };
    (0..=class(max_steps)).map(entry).chain([background]).collect()
}

/// The least width of a page, in pixels: text needs room too.
const LEAST_WIDTH: u32 = 720;
/// The side up to which small pictures are enlarged, in pixels.
const SMALL: u32 = 360;

fn zoom(frame: &Frame, side: u32) -> u32 {
    (side / frame.width.max(frame.height)).max(1)
}

/// The size of the text on a page of this width, in pixels: readable where the page is shown as wide as a column of
/// text.
fn unit(width: u32) -> f64 {
    libm::round(f64::from(width) / 90.0).max(13.0)
}

/// Exact, the core's (or `what` else it is) and difference side by side, or one above the other where they are wide;
/// `title` and `lines` stand above them, `verdict` below.
#[must_use]
pub fn triptych(
    frame: &Frame,
    [exact, core]: [&Picture; 2],
    what: &str,
    difference: &Difference,
    title: &str,
    lines: &[String],
    verdict: &str,
) -> Sheet {
    let pictures = [exact.pixels(), core.pixels()];
    let depth = pictures[0].depth;
    let heat = heat_map(frame, difference, depth);
    let zoom = zoom(frame, SMALL);
    let (wide, high) = (frame.width * zoom, frame.height * zoom);
    let stacked = f64::from(wide) > 2.4 * f64::from(high);
    let columns = if stacked { 1 } else { 3 };
    let unit = unit((columns * wide).max(LEAST_WIDTH));
    let mut page = Page::new(unit);
    let (margin, gap) = (page.units(1.5), page.units(0.8));
    let inner = (columns * wide + (columns - 1) * gap).max(LEAST_WIDTH);

    let mut y = page.heading((margin, inner), title, lines) + page.units(0.8);
    let heads = ["exact", what, "difference in output steps"];
    let kinds = [Shows::Exact, Shows::Core, Shows::Difference];
    let mut below = y;
    for (place, (head, shows)) in heads.into_iter().zip(kinds).enumerate() {
        let left = margin + if stacked { 0 } else { place as u32 * (wide + gap) };
        let top = if stacked { below } else { y };
        let room = if stacked { inner } else { wide };
        // One line each, so that the pictures stand side by side: what does not fit is the same in fewer words.
        let fits = plot::text_width(head, 1.1 * unit) <= f64::from(room);
        page.text((left, top), 1.1, INK, if fits { head } else { head.split(' ').next().unwrap_or(head) });
        let top = top + page.units(1.6);
        let pixels = pictures.get(place).unwrap_or(&heat);
        page.picture(Panel { shows, cell: 0, left, top, zoom }, pixels);
        below = top + high + page.units(0.9);
    }

    let all: u64 = difference.pixels.iter().sum();
    let empty = frame.material.iter().filter(|&&material| material == BACKGROUND).count() as u64;
    let in_class = |wanted: usize| -> u64 {
        let of = |(steps, count): (usize, &u64)| if class(steps as u16) == wanted { *count } else { 0 };
        let count: u64 = difference.pixels.iter().enumerate().map(of).sum();
        if wanted == 0 { count - empty } else { count }
    };
    let note = |count: u64| format!("{} px, {}", grouped(count), percent(count, all));
    let legend = entries(difference.max_steps, |class| note(in_class(class)), note(empty));
    y = page.paragraph((margin, below), inner, 1.1, INK, &figures(difference).join("  ·  "));
    y = page.paragraph((margin, y), inner, 1.0, GREY, verdict) + page.units(0.7);
    y = page.legend((margin, y), inner, &legend);
    let (width, height) = (inner + 2 * margin, y + margin - page.units(0.4));
    page.finish(width, height, depth)
}

/// A contact sheet: the exact picture, then each core's with its heat map, name, error and what else is to be said of
/// it.
#[must_use]
pub fn contact(frame: &Frame, exact: &Picture, cells: &[Cell], title: &str, lines: &[String]) -> Sheet {
    let exact = exact.pixels();
    let depth = exact.depth;
    let pictures: Vec<Pixels> = cells.iter().map(|cell| cell.picture.pixels()).collect();
    let heats: Vec<Pixels> = cells.iter().map(|cell| heat_map(frame, &cell.difference, depth)).collect();
    let zoom = zoom(frame, SMALL);
    let (wide, high) = (frame.width * zoom, frame.height * zoom);
    // A cell is no narrower than its text.
    let room = wide.max(240);
    let count = cells.len() as u32 + 1;
    // About as wide as a page, with few cells left empty.
    let shape = |columns: &u32| {
        let rows = count.div_ceil(*columns);
        let ratio = f64::from(columns * room) / f64::from(rows * (2 * high + 110));
        libm::fabs(libm::log(ratio / 1.4)) + 2.0 * f64::from(columns * rows - count) / f64::from(count)
    };
    let columns = (1..=count).min_by(|a, b| shape(a).total_cmp(&shape(b))).unwrap_or(1);
    let mut page = Page::new(unit((columns * room).max(LEAST_WIDTH)));
    let (margin, gap) = (page.units(1.5), page.units(1.2));
    let inner = (columns * room + (columns - 1) * gap).max(LEAST_WIDTH);

    let mut y = page.heading((margin, inner), title, lines) + page.units(1.0);
    let max_steps = cells.iter().map(|cell| cell.difference.max_steps).max().unwrap_or(0);
    let mut below = y;
    for cell in 0..count as usize {
        if cell % columns as usize == 0 {
            y = below + if cell > 0 { page.units(1.0) } else { 0 };
        }
        let left = margin + (cell as u32 % columns) * (room + gap);
        let mut down = y;
        let name = cell.checked_sub(1).map_or("exact", |core| &cells[core].name);
        // As many lines as the row's longest name has.
        let row = cell / columns as usize * columns as usize;
        let names = (row..(row + columns as usize).min(count as usize)).map(|cell| match cell {
            0 => 1,
            core => page.lines(room, 1.1, &cells[core - 1].name).len(),
        });
        let name_lines = names.max().unwrap_or(1) as f64;
        page.paragraph((left, down), room, 1.1, INK, name);
        down += page.units(1.35 * 1.1) * name_lines as u32 + page.units(0.15);
        let shows = if cell == 0 { Shows::Exact } else { Shows::Core };
        let pixels = cell.checked_sub(1).map_or(&exact, |core| &pictures[core]);
        page.picture(Panel { shows, cell, left, top: down, zoom }, pixels);
        down += high + page.units(0.3);
        match cell.checked_sub(1) {
            None => {
                down += page.units(0.6);
                let what = "Below each picture: how far it is off, in output steps";
                down = page.paragraph((left, down), room, 1.0, GREY, what) + page.units(0.5);
                down = page.legend((left, down), room, &entries(max_steps, |_| String::new(), String::new()));
            }
            Some(core) => {
                page.picture(Panel { shows: Shows::Difference, cell, left, top: down, zoom }, &heats[core]);
                down += high + page.units(0.5);
                let [most, _, psnr, off] = figures(&cells[core].difference);
                for line in &cells[core].lines {
                    down = page.paragraph((left, down), room, 0.95, GREY, line);
                }
                down = page.paragraph((left, down), room, 0.95, INK, &format!("{psnr} · {most}"));
                down = page.paragraph((left, down), room, 0.95, INK, &off);
                down = page.paragraph((left, down), room, 0.95, GREY, &cells[core].verdict);
            }
        }
        below = below.max(down);
    }
    let (width, height) = (inner + 2 * margin, below + margin);
    page.finish(width, height, depth)
}
