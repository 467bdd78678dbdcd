//! SVG text as a PNG picture, on machines without fonts too.

use std::sync::{Arc, OnceLock};

use resvg::{tiny_skia, usvg};

/// Pixels of the picture for each of the SVG's.
const SCALE: f32 = 2.0;

/// The one font that pictures are drawn with, DejaVu Sans, from the program itself: the same picture on every machine.
fn fonts() -> Arc<usvg::fontdb::Database> {
    static FONTS: OnceLock<Arc<usvg::fontdb::Database>> = OnceLock::new();
    let load = || {
        let mut fonts = usvg::fontdb::Database::new();
        fonts.load_font_data(dejavu::sans::regular().to_vec());
        fonts.set_sans_serif_family("DejaVu Sans");
        Arc::new(fonts)
    };
    Arc::clone(FONTS.get_or_init(load))
}

fn tree(svg: &str) -> usvg::Tree {
    let options = usvg::Options { fontdb: fonts(), font_family: "DejaVu Sans".to_owned(), ..usvg::Options::default() };
    usvg::Tree::from_str(svg, &options).expect("the text of a chart")
}

/// SVG text as pixels, `scale` of them for each of the SVG's.
///
/// # Panics
/// On text that is no SVG with a size.
#[must_use]
pub(crate) fn draw(svg: &str, scale: f32) -> tiny_skia::Pixmap {
    let tree = tree(svg);
    let (width, height) = ((tree.size().width() * scale) as u32, (tree.size().height() * scale) as u32);
    let mut picture = tiny_skia::Pixmap::new(width, height).expect("a chart has a size");
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut picture.as_mut());
    picture
}

/// How wide a line of text is drawn, in units of the SVG; blanks at its ends do not count.
#[must_use]
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    let svg = format!(
        "<svg width=\"1\" height=\"1\" xmlns=\"http://www.w3.org/2000/svg\">\
         <text font-family=\"sans-serif\" font-size=\"{size}\">{}</text></svg>",
        super::escaped(text)
    );
    tree(&svg).root().abs_bounding_box().right().max(0.0).into()
}

/// A chart's SVG text as a PNG file of twice its size in pixels.
///
/// # Panics
/// On text that is no SVG with a size; [`super::Chart::svg`] always is.
#[must_use]
pub fn png(svg: &str) -> Vec<u8> {
    draw(svg, SCALE).encode_png().expect("a picture in memory")
}
