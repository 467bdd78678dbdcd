//! The stepped cores against the formulas in plain integers.

use std::collections::VecDeque;

use brdfgen::verify::kernel::*;

/// Xorshift, which is all the randomness these tests need.
struct Random(u64);

impl Random {
    fn bits(&mut self, width: usize) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> (64 - width)
    }

    /// True once in four on average.
    fn seldom(&mut self) -> bool {
        self.bits(2) == 0
    }

    /// A word with a random number of leading zeros, so that small values are as common.
    fn any_size(&mut self, width: usize) -> u64 {
        let shift = self.bits(32) % (width as u64 + 1);
        self.bits(width) >> shift
    }
}

fn ones(width: usize) -> u64 {
    (1 << width) - 1
}

/// `value` with `to` instead of `from` fraction bits, rounded down.
fn rescale(value: u64, from: usize, to: usize) -> u64 {
    if to < from { value >> (from - to) } else { value << (to - from) }
}

/// The limited cosine.
fn limited(in_cos: u64, f: usize) -> u64 {
    match in_cos >> (f + 1) {
        0 => in_cos.min(1 << f),
        _ => 0,
    }
}

/// `x - x p` with `t = x p` cut to `ft` fraction bits.
fn finish(x: u64, p: u64, fp: usize, xb: usize, ft: usize, g: usize) -> u64 {
    let common = xb.max(ft);
    let t = rescale(x * p, xb + fp, ft);
    rescale(rescale(x, xb, common) - rescale(t, ft, common), common, g)
}

fn quadratic_model(w: &QuadraticWidths, k: u64, a: u64, in_cos: u64) -> u64 {
    let x = limited(in_cos, w.f);
    let full = ((1 << w.f) - x) << k;
    if full >= 1 << (w.f + 1) {
        return 0;
    }
    let p = rescale(a * rescale(full, w.f, w.fv), w.ca + w.fv, w.fp);
    if p >= 1 << w.fp {
        return 0;
    }
    finish(rescale(x, w.f, w.xb), p, w.fp, w.xb, w.ft, w.g)
}

fn cubic_model(w: &CubicWidths, k: u64, a: u64, constant: u64, threshold: u64, in_cos: u64) -> u64 {
    let x = limited(in_cos, w.f);
    let u = (1 << w.f) - x;
    if u > threshold {
        return 0;
    }
    let v = rescale(u << k, w.f, w.fv) & ones(w.fv + w.iv);
    let r = rescale(a * v, w.cl + w.fv, w.fr);
    let common = w.ca.max(w.fr);
    let difference = rescale(constant, w.ca, common).wrapping_sub(rescale(r, w.fr, common));
    let q = rescale(difference, common, w.fq) & ones(w.wq);
    let p = rescale(v * q, w.fv + w.fq, w.fp);
    if p >= 1 << w.fp {
        return 0;
    }
    finish(rescale(x, w.f, w.xb), p, w.fp, w.xb, w.ft, w.g)
}

/// A core, its formula as a function of (in_n, in_cos), and the widths of its ports.
struct Case {
    name: String,
    kernel: Box<dyn Kernel>,
    model: Box<dyn Fn(u64, u64) -> u64>,
    n: usize,
    cos: usize,
}

fn quadratic_case(w: QuadraticWidths) -> Case {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let rows = 1 << w.n;
    let k: Vec<u64> = (0..rows).map(|_| random.bits(32) % (w.kmax as u64 + 1)).collect();
    let a: Vec<u64> = (0..rows).map(|_| random.any_size(w.ca)).collect();
    Case {
        name: format!("quadratic_{}_{}", w.f, w.n),
        kernel: quadratic(&w, QuadraticRom { k: &k, a: &a }).expect("an instance"),
        model: Box::new(move |n, cos| quadratic_model(&w, k[n as usize], a[n as usize], cos)),
        n: w.n,
        cos: w.f + 2,
    }
}

fn cubic_case(w: CubicWidths) -> Case {
    let mut random = Random(0xD1B5_4A32_D192_ED03);
    let rows = 1 << w.n;
    let mut field = |width| -> Vec<u64> { (0..rows).map(|_| random.any_size(width)).collect() };
    let (k, a, constant) = (field(w.kw), field(w.wl), field(w.wa));
    // Few of the inputs are to be beyond the threshold.
    let threshold: Vec<u64> = field(w.f).iter().map(|t| (1 << w.f) - t).collect();
    let rom = CubicRom { k: &k, a: &a, constant: &constant, threshold: &threshold };
    Case {
        name: format!("cubic_{}_{}", w.f, w.n),
        kernel: cubic(&w, rom).expect("an instance"),
        model: Box::new(move |n, cos| {
            let i = n as usize;
            cubic_model(&w, k[i], a[i], constant[i], threshold[i], cos)
        }),
        n: w.n,
        cos: w.f + 2,
    }
}

fn cases() -> Vec<Case> {
    let quadratics = QUADRATIC_SETS.iter().map(|&w| quadratic_case(w));
    let cubics = CUBIC_SETS.iter().map(|&w| cubic_case(w));
    quadratics.chain(cubics).collect()
}

struct Stimulus {
    rst: bool,
    ce: bool,
    in_valid: bool,
    in_n: u64,
    in_cos: u64,
}

/// Random stimuli with resets at the start and in the middle, one of these while `ce` is 0.
fn stimuli(case: &Case, count: usize) -> Vec<Stimulus> {
    let mut random = Random(0x0BAD_5EED_0BAD_5EED);
    let one = 1 << (case.cos - 2);
    let stimulus = |i| Stimulus {
        rst: i < 2 || i == count / 3 || i == count / 2,
        ce: i != count / 2 && !random.seldom(),
        in_valid: !random.seldom(),
        in_n: random.bits(case.n),
        in_cos: match random.bits(4) {
            0 => random.bits(case.cos),
            1 => one + random.bits(1),
            2 => 0,
            3 => 2 * one - random.bits(1),
            4 => ones(case.cos),
            _ => one - random.any_size(case.cos - 2),
        },
    };
    (0..count).map(stimulus).collect()
}

/// What the core must show after each clock: the result where it is valid.
fn expected(case: &Case, stimuli: &[Stimulus]) -> Vec<Option<u64>> {
    let levels = case.kernel.latency() as usize;
    let mut pipeline = VecDeque::from(vec![None; levels]);
    let mut after = Vec::new();
    for s in stimuli {
        if s.rst {
            pipeline = VecDeque::from(vec![None; levels]);
        } else if s.ce {
            pipeline.pop_front();
            pipeline.push_back(s.in_valid.then(|| (case.model)(s.in_n, s.in_cos)));
        }
        after.push(pipeline[0]);
    }
    after
}

#[test]
fn stepped_cores_follow_the_formulas() {
    for mut case in cases() {
        let stimuli = stimuli(&case, 100_000);
        let expected = expected(&case, &stimuli);
        for (i, (s, expected)) in stimuli.iter().zip(&expected).enumerate() {
            let (valid, spec) = case.kernel.clock(s.rst, s.ce, s.in_valid, s.in_n, s.in_cos);
            let got = valid.then_some(spec);
            assert_eq!(got, *expected, "{} after clock {i}", case.name);
        }
        let valid = expected.iter().flatten().count();
        let positive = expected.iter().flatten().filter(|&&y| y > 0).count();
        assert!(valid > 50_000, "{}: {valid} valid", case.name);
        assert!(positive > valid / 4, "{}: {positive} positive", case.name);
        assert!(positive < valid * 9 / 10, "{}: few zeros", case.name);
    }
}

#[test]
fn unlisted_widths_have_no_instance() {
    let widths = QuadraticWidths { f: 15, ..QUADRATIC_SETS[0] };
    assert!(quadratic(&widths, QuadraticRom { k: &[], a: &[] }).is_none());
}

#[test]
#[should_panic(expected = "rows of the table field k")]
fn a_short_table_is_refused() {
    quadratic(&QUADRATIC_SETS[0], QuadraticRom { k: &[0], a: &[0] });
}
