use brdfgen::plot::*;
use resvg::tiny_skia;

fn ink(svg: &str) -> usize {
    let picture = tiny_skia::Pixmap::decode_png(&png(svg)).unwrap();
    assert_eq!((picture.width(), picture.height()), (200, 80));
    picture.pixels().iter().filter(|pixel| pixel.red() < 128).count()
}

#[test]
fn text_shows() {
    let drawn = |text: &str| {
        ink(&format!(
            "<svg width=\"100\" height=\"40\" xmlns=\"http://www.w3.org/2000/svg\">\
             <rect width=\"100\" height=\"40\" fill=\"#FFFFFF\"/>\
             <text x=\"5\" y=\"25\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#000000\">{text}</text></svg>"
        ))
    };
    assert_eq!(drawn(""), 0);
    assert!(drawn("2⁻¹²") > 50 && drawn("≥ µ") > 50);
    // A missing letter would be drawn as the same box.
    assert_ne!(png_of("⁻"), png_of("\u{e000}"));
}

fn png_of(text: &str) -> Vec<u8> {
    png(&format!(
        "<svg width=\"40\" height=\"40\" xmlns=\"http://www.w3.org/2000/svg\">\
         <text x=\"5\" y=\"25\" font-family=\"sans-serif\" font-size=\"14\">{text}</text></svg>"
    ))
}
