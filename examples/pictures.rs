//! Draws the pictures of the README from the tool's own arithmetic: `cargo run --release --example pictures -- docs`.

use std::error::Error;
use std::path::Path;

use brdfgen::core::Design;
use brdfgen::emit::package;
use brdfgen::explore::Results;
use brdfgen::plot::COLOURS;
use brdfgen::report::{self, Palette};
use brdfgen::spec::SpecFields;
use plotters::prelude::*;

fn design(text: &str) -> Result<Design, brdfgen::platform::error::Error> {
    Design::new(SpecFields::parse(text, "picture")?.resolve()?)
}

/// The lobes as the 16-bit cores compute them, code by code, beside the power.
fn lobes(path: &Path) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::new(path, (960, 400)).into_drawing_area();
    root.fill(&WHITE)?;
    let (quadratic, cubic) =
        (design("method = 'quadratic'\nshininess = '1..=1000'")?, design("method = 'cubic'\nshininess = '1..=1000'")?);
    for (area, (n, widest)) in root.split_evenly((1, 2)).iter().zip([(10u32, 0.45), (200u32, 0.0225)]) {
        let mut chart = ChartBuilder::on(area)
            .caption(format!("n = {n}"), ("sans-serif", 20))
            .margin(10)
            .x_label_area_size(40)
            .y_label_area_size(45)
            .build_cartesian_2d(1.0 - widest..1.0, 0.0..1.05)?;
        chart.configure_mesh().x_desc("cosine x").y_desc("lobe").x_labels(6).light_line_style(WHITE).draw()?;
        // As many as the picture has columns to show.
        let codes = || (0..=400).map(|step| 65536 - (f64::from(step) * widest * 163.84) as i64);
        let exact = codes().map(|code| (code as f64 / 65536.0, (code as f64 / 65536.0).powi(n as i32)));
        chart
            .draw_series(LineSeries::new(exact, BLACK.stroke_width(1)))?
            .label(format!("x^{n}"))
            .legend(|(x, y)| PathElement::new([(x, y), (x + 20, y)], BLACK));
        for (design, colour) in [(&quadratic, COLOURS[0]), (&cubic, COLOURS[2])] {
            let model = design.lobe().model();
            let points = codes().map(|code| (code as f64 / 65536.0, f64::from(model.evaluate(n, code)) / 65536.0));
            chart
                .draw_series(LineSeries::new(points, colour.stroke_width(2)))?
                .label(format!("{} core", design.spec.name))
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], colour.stroke_width(2)));
        }
        let place = SeriesLabelPosition::UpperLeft;
        chart.configure_series_labels().position(place).border_style(BLACK).background_style(WHITE).draw()?;
    }
    root.present()?;
    Ok(())
}

/// Error against LUTs, of the largest group of the points that come with the program.
fn trade(path: &Path) -> Result<(), Box<dyn Error>> {
    let results = Results::built_in()?;
    let (groups, palette) = (report::groups(results.points(), None), Palette::of(results.points()));
    let group = groups.first().ok_or("no point that comes with the program has a cost")?;
    let charts = group.charts(&palette, None);
    let (_, chart) = charts.iter().find(|(what, _)| *what == "lut").ok_or("a group has a chart of LUTs")?;
    println!("{}: {} points; {}", group.title(), group.points.len(), group.tools_text());
    package::write_file(path, chart.svg().as_bytes())?;
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let directory = std::env::args().nth(1).ok_or("usage: pictures DIRECTORY")?;
    lobes(&Path::new(&directory).join("lobes.svg"))?;
    trade(&Path::new(&directory).join("trade.svg"))
}
