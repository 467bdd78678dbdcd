//! Evaluations per second of the bit-exact arithmetic beside an f64 `powf` loop, on the same inputs in the same run:
//! 4096 cosines for each of 16 shininesses, spread over 1..=1000.

use std::hint::black_box;

use brdfgen::core::Design;
use brdfgen::datapath::simulate::{Inputs, Simulation};
use brdfgen::spec::SpecFields;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const COSINES: usize = 4096;

fn shininesses() -> impl Iterator<Item = u32> {
    (0..16).map(|step| 1 + step * 66)
}

/// The cosines from 15/16 up: the highlight, where a power has no short cut.
const FIRST: i64 = (1 << 16) - COSINES as i64 + 1;

fn evaluate(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("lobe");
    group.throughput(Throughput::Elements(16 * COSINES as u64));
    group.sample_size(20);

    let cosines: Vec<f64> = (0..COSINES).map(|i| (FIRST + i as i64) as f64 / 65536.0).collect();
    group.bench_function("f64 powf", |bench| {
        let mut out = vec![0.0; COSINES];
        bench.iter(|| {
            for n in shininesses() {
                let n = f64::from(black_box(n));
                for (out, x) in out.iter_mut().zip(&cosines) {
                    *out = x.powf(n);
                }
                black_box(&out);
            }
        });
    });

    for (method, form) in [("quadratic", "stable"), ("quadratic", "paper"), ("cubic", "stable"), ("cubic", "paper")] {
        let text = format!("method = '{method}'\nform = '{form}'\nshininess = '1..=1000'");
        let spec = SpecFields::parse(&text, "bench").and_then(SpecFields::resolve).expect("a spec");
        let design = Design::new(spec).expect("a design");
        let evaluator = design.evaluator();
        group.bench_function(format!("{method} {form}: evaluator"), |bench| {
            let mut out = vec![0; COSINES];
            bench.iter(|| {
                for n in shininesses() {
                    evaluator.evaluate(black_box(n), FIRST, 1, &mut out);
                    black_box(&out);
                }
            });
        });
        let model = design.lobe().model();
        group.bench_function(format!("{method} {form}: model"), |bench| {
            bench.iter(|| {
                for n in shininesses() {
                    for x in 0..COSINES as i64 {
                        black_box(model.evaluate(black_box(n), FIRST + x));
                    }
                }
            });
        });
    }
    group.finish();
}

fn simulate(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("clock");
    group.throughput(Throughput::Elements(1000));
    group.sample_size(10);
    for method in ["quadratic", "cubic"] {
        let text = format!("method = '{method}'\nshininess = '1..=1000'");
        let spec = SpecFields::parse(&text, "bench").and_then(SpecFields::resolve).expect("a spec");
        let design = Design::new(spec).expect("a design");
        let mut simulation = Simulation::new(design.graph(), &design.schedule, design.tables());
        group.bench_function(format!("{method}: datapath pipeline"), |bench| {
            bench.iter(|| {
                for n in 0..1000 {
                    let inputs = Inputs { rst: false, ce: true, in_valid: true, codes: vec![n, 65000] };
                    black_box(simulation.clock(&inputs));
                }
            });
        });
        #[cfg(feature = "kernel")]
        {
            let mut kernel = brdfgen::verify::kernel::of_design(&design).expect("a kernel");
            group.bench_function(format!("{method}: rust-hdl kernel"), |bench| {
                bench.iter(|| {
                    for n in 0..1000 {
                        black_box(kernel.clock(false, true, true, n, 65000));
                    }
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, evaluate, simulate);
criterion_main!(benches);
