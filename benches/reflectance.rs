//! Samples per second of the exact reflectance, looked up in a table, and of the three forms: a sphere under one
//! directional light, on one thread and on all, all in one run. Then the frame of 1920×1080 samples under 1, 2, 4 and 8
//! lights, and a mesh drawn in it.
//!
//! `cargo bench --bench reflectance` prints the table. Run as a test (without `--bench`), it goes through everything
//! once and measures nothing.

use std::error::Error;
use std::hint::black_box;
use std::time::{Duration, Instant};

use brdfgen::reflectance::measure::{Sphere, exposure};
use brdfgen::reflectance::table::PHI_D;
use brdfgen::reflectance::{Form, FormKind, FormSpec, Light, Model, Record, Reflectance, Table};
use brdfgen::scene::reflectance::Seen;
use brdfgen::scene::{Scene, Tracer};
use rayon::prelude::*;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Samples that a thread takes at once.
const CHUNK: usize = 4096;
/// The light.
const LIGHT: (f64, f64) = (52.0, 33.0);

/// Shades all samples, on one thread or on all.
type Shade<'a> = Box<dyn Fn(bool, &mut [[f32; 3]]) + 'a>;

/// One of those compared.
struct Contender<'a> {
    name: String,
    run: Shade<'a>,
}

/// Cuts the samples for the threads, or not.
fn cut(all: bool, out: &mut [[f32; 3]], shade: impl Fn(usize, &mut [[f32; 3]]) + Sync) {
    if all {
        out.par_chunks_mut(CHUNK).enumerate().for_each(|(place, out)| shade(place * CHUNK, out));
    } else {
        out.chunks_mut(CHUNK).enumerate().for_each(|(place, out)| shade(place * CHUNK, out));
    }
}

fn exact<'a>(table: &'a Table, sphere: &'a Sphere, gain: f64) -> Contender<'a> {
    let light = Light::new(LIGHT.0, LIGHT.1);
    Contender {
        name: "exact: table, trilinear".to_owned(),
        run: Box::new(move |all, out| {
            cut(all, out, |start, out| {
                for (out, &n) in out.iter_mut().zip(&sphere.normals[start..]) {
                    let value = table.radiance(black_box(light), n, gain);
                    (0..3).for_each(|c| out[c] += value[c] as f32);
                }
            });
        }),
    }
}

fn add(form: &Form, records: &[Record], sphere: &Sphere, start: usize, out: &mut [[f32; 3]]) {
    let normals = sphere.coordinates().map(|axis| &axis[start..][..out.len()]);
    records.iter().for_each(|record| form.add(record, 1.0, normals, out));
}

fn through<'a>(form: &'a Form, sphere: &'a Sphere) -> Contender<'a> {
    let light = Light::new(LIGHT.0, LIGHT.1);
    Contender {
        name: format!("{} ({} KiB)", form.spec, form.kib()),
        // Making a light ready is part of the work.
        run: Box::new(move |all, out| {
            let record = [form.record(black_box(light))];
            cut(all, out, |start, out| add(form, &record, sphere, start, out));
        }),
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Nanoseconds a sample of each contender in each of the rounds, in which one follows the other.
fn measured(rounds: usize, all: bool, contenders: &[Contender], out: &mut [[f32; 3]]) -> Vec<Vec<f64>> {
    let mut time = |contender: &Contender| {
        let start = Instant::now();
        let mut calls = 0;
        while calls == 0 || rounds > 1 && start.elapsed() < Duration::from_millis(20) {
            (contender.run)(all, out);
            black_box(&mut *out);
            calls += 1;
        }
        start.elapsed().as_secs_f64() * 1e9 / (calls * out.len()) as f64
    };
    (0..rounds).map(|_| contenders.iter().map(&mut time).collect()).collect()
}

fn main() -> Result<()> {
    let rounds = if std::env::args().any(|argument| argument == "--bench") { 21 } else { 1 };
    let table = Table::sampled(&Model::named("ggx")?, PHI_D)?;
    let gain = exposure(&table);
    let sphere = Sphere::new(512);
    let specs = [
        FormSpec::sized(FormKind::Paper, 6, 512, "linear:8".parse()?),
        FormSpec::sized(FormKind::Half, 16, 32, "sqrt:8".parse()?),
        FormSpec::sized(FormKind::Half, 16, 64, "sqrt:8".parse()?),
        FormSpec::sized(FormKind::Bivariate, 1, 32, "sqrt:8".parse()?),
    ];
    let forms = specs.map(|spec| spec.build(&table, gain).expect("a form of a table"));
    let mut contenders = vec![exact(&table, &sphere, gain)];
    contenders.extend(forms.iter().map(|form| through(form, &sphere)));
    let mut out = vec![[0.0f32; 3]; sphere.normals.len()];
    println!(
        "| samples | one thread: million a second | times exact | {} threads: million a second |",
        rayon::current_num_threads()
    );
    println!("| --- | ---: | ---: | ---: |");
    let times = [false, true].map(|all| measured(rounds, all, &contenders, &mut out));
    for (place, contender) in contenders.iter().enumerate() {
        let rate = |times: &[Vec<f64>]| 1e3 / median(times.iter().map(|round| round[place]).collect());
        let ratio = median(times[0].iter().map(|round| round[0] / round[place]).collect());
        println!("| {} | {:.1} | {ratio:.1} | {:.1} |", contender.name, rate(&times[0]), rate(&times[1]));
    }

    // A frame: for every pixel the normal is made, then the lights' sum, then the code.
    println!(
        "\n| 1920×1080, all threads | 1 light: ms | 2 | 4 | 8 | 8 to 1 |\n| --- | ---: | ---: | ---: | ---: | ---: |"
    );
    let count = if rounds > 1 { 1920 * 1080 } else { 4096 };
    let frame: Vec<usize> = (0..count).map(|pixel| pixel % sphere.normals.len()).collect();
    let axes =
        [0, 1, 2].map(|axis| -> Vec<f32> { frame.iter().map(|&pixel| sphere.coordinates()[axis][pixel]).collect() });
    for form in &forms {
        let mut row = Vec::new();
        for lights in [1, 2, 4, 8] {
            let took = (0..rounds.min(7)).map(|_| {
                let start = Instant::now();
                let lights =
                    (0..lights).map(|light| Light::new(20.0 + 15.0 * f64::from(light), 40.0 * f64::from(light)));
                let records: Vec<Record> = lights.map(|light| form.record(light)).collect();
                let codes: Vec<[u8; 3]> = (0..count.div_ceil(CHUNK))
                    .into_par_iter()
                    .flat_map_iter(|place| {
                        let range = place * CHUNK..((place + 1) * CHUNK).min(count);
                        let normals = [&axes[0][range.clone()], &axes[1][range.clone()], &axes[2][range.clone()]];
                        let mut sum = vec![[0.0f32; 3]; range.len()];
                        records.iter().for_each(|record| form.add(record, 1.0, normals, &mut sum));
                        sum.into_iter().map(|pixel| pixel.map(|value| (255.0 * value.clamp(0.0, 1.0) + 0.5) as u8))
                    })
                    .collect();
                black_box(&codes);
                start.elapsed().as_secs_f64() * 1e3
            });
            row.push(median(took.collect()));
        }
        println!(
            "| {} | {:.1} | {:.1} | {:.1} | {:.1} | {:.2} |",
            form.spec,
            row[0],
            row[1],
            row[2],
            row[3],
            row[3] / row[0]
        );
    }
    drawn(&forms, rounds)
}

/// The bunny, drawn: rays and normals, lights made ready and codes on the one hand, look-ups on the other.
fn drawn(forms: &[Form], rounds: usize) -> Result<()> {
    println!(
        "\n| the bunny, 1920×1080, all threads | all but look-ups, 1 light: ms | 8 | 8 to 1 | look-ups, 1 light: ms | \
         8 | 8 to 1 |\n\
         | --- | ---: | ---: | ---: | ---: | ---: | ---: |"
    );
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/bunny.toml");
    let (width, height) = if rounds > 1 { (1920, 1080) } else { (32, 18) };
    let scene = Scene::read(path.as_ref())?.resized(width, height);
    let tracer = Tracer::new(&scene);
    for form in forms {
        let mut columns = Vec::new();
        for lights in [1, 8] {
            let once = || {
                let start = Instant::now();
                let light = |place: usize| Light::new(20.0 + 15.0 * place as f64, 40.0 * place as f64);
                let seen = Seen::of(&tracer, &scene);
                let records: Vec<Record> = (0..lights).map(|place| form.record(light(place))).collect();
                let before = start.elapsed().as_secs_f64();
                let sums = seen.through(form, &records);
                let between = start.elapsed().as_secs_f64();
                let codes: Vec<[u8; 3]> = sums
                    .par_iter()
                    .map(|pixel| pixel.map(|value| (255.0 * value.clamp(0.0, 1.0) + 0.5) as u8))
                    .collect();
                black_box(&codes);
                let all = start.elapsed().as_secs_f64();
                [all - between + before, between - before].map(|seconds| 1e3 * seconds)
            };
            let runs: Vec<[f64; 2]> = (0..rounds.min(7)).map(|_| once()).collect();
            columns.push([0, 1].map(|part| median(runs.iter().map(|run| run[part]).collect())));
        }
        let [one, eight] = [columns[0], columns[1]];
        let cells = [0, 1]
            .map(|part| format!("{:.1} | {:.1} | {:.2}", one[part], eight[part], eight[part] / one[part].max(1e-9)));
        println!("| {} | {} |", form.spec, cells.join(" | "));
    }
    Ok(())
}
