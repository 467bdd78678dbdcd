//! Lights in sequence: the sequencers around image-based blocks and shaders pass their benches and are proved, broken
//! ones are found by both, linters are silent.
//!
//! Needs iverilog, verilator, ghdl, yosys and Yices; `test.sh` installs them.

use brdfgen::block::image::{LightRecord, Places, RealTexels};
use brdfgen::block::lights::Sums;
use brdfgen::core::{BlockDesign, Design, Direction};
use brdfgen::emit::package::Part;
use brdfgen::fixed::{Rng, exp2};
use brdfgen::reflectance::{Light, Reflectance, Vector};
use brdfgen::spec::{ImageSource, Language, SpecFields};
use brdfgen::verify::cosim::{self, Outcome, Sim};
use brdfgen::verify::formal::{self, ProofStatus};
use num_bigint::BigUint;
use proptest::prelude::*;
use rayon::prelude::*;

use crate::common::core::{Generated, OnDisk, design, resolved, silent};
use crate::common::{Scratch, all};

const SHADER: &str = "block = 'shader'\nmethod = 'schlick'\noutput_fraction = 10\ninput_fraction = 8\nmaterial = [{ \
                      name = 'a', shininess = 9 }, { name = 'b', shininess = 30 }]\n";

/// Both blocks; one light a clock and more; few lights and many; texels that are written; ports of bits; colours at
/// ports and in the ROM; behind AXI4-Stream.
fn specs() -> Vec<String> {
    vec![
        "block = 'image'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\naxi_stream = true\ntuser_bits = 3\n\
         reflectance = { model = 'ggx' }"
            .to_owned(),
        "block = 'image'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\ntexels = 'writable'\n\
         lights_a_clock = 2\nmost_lights = 1024\n\
         output_bits = 12\npipeline = 1\naxi_stream = true\nreflectance = { model = 'gold-paint' }"
            .to_owned(),
        "block = 'image'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\nmost_lights = 1\nvhdl_ports = \
         'std-logic'\nreflectance = { model = 'lambert' }"
            .to_owned(),
        "block = 'image'\nfront_end = 'vector'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\n\
         light_source = 'table'\naxi_stream = true\n\
         reflectance = { model = 'gold-paint' }"
            .to_owned(),
        format!("{SHADER}lights_a_clock = 1\npipeline = 2\naxi_stream = true\n"),
        "block = 'image'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\nlight_source = 'table'\n\
         axi_stream = true\nreflectance = { model = 'ggx' }"
            .to_owned(),
        "block = 'image'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\ntexels = 'writable'\n\
         swap = true\nlights_a_clock = 2\nmost_lights = 5\nlight_source = 'table'\nvhdl_ports = 'std-logic'\n\
         axi_stream = true\ntuser_bits = 40\nreflectance = { model = 'gold-paint' }"
            .to_owned(),
        format!("{SHADER}lights_a_clock = 1\nmost_lights = 1\nlight_source = 'table'\naxi_stream = true\n"),
        format!("{SHADER}lights_a_clock = 1\nlight_source = 'table'\npipeline = 1\n"),
        with_rom(&format!("{SHADER}lights_a_clock = 1\naxi_stream = true\ntuser_bits = 2\n"), 3),
        with_rom(&format!("{SHADER}lights_a_clock = 2\nvhdl_ports = 'std-logic'\n"), 3),
        with_rom(
            "block = 'image'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\ntexels = 'external'\n\
             lights_a_clock = 2\nvhdl_ports = 'std-logic'\naxi_stream = true\ntuser_bits = 64\n\
             reflectance = { model = 'gold-paint' }\n",
            5,
        ),
        format!(
            "{SHADER}lights_a_clock = 3\nmost_lights = 1\nvhdl_ports = 'std-logic'\n[shader]\nmodel = 'blinn'\n\
                 channel_bits = 12\nlight_colours = [[1, 0, 0], [0, 1, 0], [0.2, 0.1, 1]]"
        ),
    ]
}

/// The spec with so many lights in a ROM.
fn with_rom(spec: &str, lights: usize) -> String {
    let (design, mut rng) = (design(spec), Rng::new(7));
    let (ports, own) = (design.numbers(Direction::In).len(), design.light_ports().len());
    let first = ports - design.light_inputs().len();
    let records: Vec<Vec<i64>> = (0..lights).map(|_| design.varied(&mut rng)[first..first + own].to_vec()).collect();
    format!("{spec}light_source = 'rom'\nlight_records = {records:?}\n")
}

/// What is around the core, in a simulator.
fn around(core: &OnDisk, sim: Sim) -> Vec<Outcome> {
    cosim::around(sim, &core.job()).expect("it runs")
}

#[test]
fn every_sequencer_passes_its_bench_lints_clean_and_is_proved() {
    specs().par_iter().enumerate().for_each(|(place, spec)| {
        let generated = Generated::new(spec);
        let core = generated.on_disk();
        let count = core.golden.vectors().len() as u64;
        let (path, design) = (core.path(), &core.design);
        let [streams, has_table] = [design.spec.axi_stream.is_some(), design.light_table().is_some()];
        let parts = 1 + usize::from(streams) + usize::from(has_table);
        assert_eq!(design.sums().map(|_| Part::of(design).len()), Some(parts + 1), "{spec}");
        // GHDL interprets: it takes most of the time, and analyses the others below.
        let ghdl = (all() || place % 2 == 0).then_some(Sim::Ghdl);
        for sim in [Sim::Builtin, Sim::Icarus].into_iter().chain(ghdl) {
            assert!(core.run(sim).passed(), "{spec}");
            let outcomes = around(&core, sim);
            assert_eq!(outcomes.len(), if sim == Sim::Builtin { 0 } else { parts }, "{spec}");
            for outcome in outcomes {
                assert!(outcome.passed() && outcome.vectors == count, "{spec}\n{outcome:?}");
            }
        }
        let work = core.beside("work");
        std::fs::create_dir(&work).expect("a directory");
        let workdir = format!("--workdir={}", work.display());
        let out = work.join("out").display().to_string();
        let [verilog, vhdl] = [Language::Verilog, Language::Vhdl].map(|language| -> Vec<String> {
            Part::of(design).into_iter().map(|part| part.rtl_path(design, language)).collect()
        });
        let with = |before: &[&str], files: &[String]| -> Vec<String> {
            before.iter().map(|&word| word.to_owned()).chain(files.iter().cloned()).collect()
        };
        let tops: Vec<String> = Part::of(design)[1..].iter().map(|part| part.name(design)).collect();
        let quiet = |program: &str, words: Vec<String>| {
            silent(path, program, &words.iter().map(String::as_str).collect::<Vec<_>>(), spec);
        };
        for (part, top) in tops.iter().enumerate() {
            quiet("verilator", with(&["--lint-only", "-Wall", "--top-module", top], &verilog[..part + 2]));
        }
        quiet("iverilog", with(&["-Wall", "-g2005", "-o", &out], &verilog));
        quiet("ghdl", with(&["-a", "--std=08", &workdir], &vhdl));
        let benches: Vec<String> =
            tops.iter().flat_map(|top| [format!("tb/{top}_tb.v"), format!("tb/{top}_tb.vhd")]).collect();
        for file in verilog[1..].iter().chain(&vhdl[1..]).chain(&benches) {
            let text = generated.text(file);
            assert!(text.is_ascii() && text.ends_with('\n') && !text.contains(['\t', '\r']), "{file} of {spec}");
            // The names of memories in comments may be long, and so may lines of benches.
            let is_long = |line: &&str| line.len() > 100 && !line.trim_start().starts_with(['/', '-']);
            let wrong = text.lines().find(|line| line.ends_with(' ') || (is_long(line) && file.starts_with("rtl/")));
            assert_eq!(wrong, None, "{file} of {spec}");
        }
        // With many memories and multipliers that takes minutes, and what is proved is the same but for the ports.
        if design.tables().len() > 8 {
            return;
        }
        let proofs = formal::around(design, &Part::of(design), path, &|_| {}).expect("it runs");
        assert_eq!(proofs.len(), 2 * parts, "{spec}");
        assert!(proofs.iter().all(|proof| proof.verdict == ProofStatus::Proved), "{spec}\n{proofs:?}");
    });
}

/// A fault in a sequencer: what it is, in which language, what is changed to what.
type Fault = (&'static str, Language, &'static str, &'static str);

const FAULTS: [Fault; 10] = [
    ("the first lights are added to the last sample", Language::Verilog, "(ce & valid[", "(1'b0 & valid["),
    ("a sum beyond 1.0 wraps", Language::Verilog, "was_full_g | |sum_g[16:15]", "was_full_g | 1'b0 & |sum_g[16:15]"),
    ("the rounding", Language::Verilog, "so_far_b   <= 15'd64", "so_far_b   <= 15'd63"),
    ("full scale", Language::Verilog, "lit_r[15]) ? 8'hff", "lit_r[15]) ? 8'hfe"),
    ("the end a clock late", Language::Verilog, "(ce & valid[", "(ce & valid[1 +"),
    ("a reset in the middle of a sample", Language::Verilog, "if (rst | (ce & valid[", "if ((ce & valid["),
    (
        "lights that are none",
        Language::Vhdl,
        "elsif ce = '1' and sum_valid = '1' then\n                so_far",
        "elsif ce = '1' then\n                so_far",
    ),
    (
        "the enable",
        Language::Vhdl,
        "            if ce = '1' then\n                if full",
        "            if true then\n                if full",
    ),
    (
        "the ambient light",
        Language::Vhdl,
        "ambient_r <= unsigned(out_ambient_r)",
        "ambient_r <= not unsigned(out_ambient_r)",
    ),
    ("an end without lights", Language::Vhdl, "& (in_valid and in_last)", "& in_last"),
];

const TABLE_FAULTS: [Fault; 6] = [
    ("a word too few", Language::Verilog, "wire ends = word == until_word", "wire ends = word + 1'b1 == until_word"),
    ("the sample's inputs change", Language::Verilog, "read_in_nz <= now_in_nz", "read_in_nz <= in_nz"),
    ("a sample that is none", Language::Verilog, "busy <= in_valid", "busy <= 1'b1"),
    ("ready a clock late", Language::Vhdl, "free <= not busy or ends", "free <= not busy"),
    ("a word twice", Language::Vhdl, "word <= word + 1", "word <= word"),
    ("the reset", Language::Vhdl, "                busy  <= '0';\n", ""),
];

/// A core on disk with a fault in a part of it.
fn with_fault(generated: &Generated, part: Part, (what, language, from, to): Fault) -> OnDisk {
    let core = generated.on_disk();
    let file = part.rtl_path(&core.design, language);
    let text = generated.text(&file);
    assert!(text.contains(from), "{what}: `{from}` in\n{text}");
    std::fs::write(core.path().join(&file), text.replacen(from, to, 1)).expect("written");
    core
}

/// The bench of the outermost part finds the fault, and those of the others none.
fn found_by_bench(core: &OnDisk, language: Language, what: &str) {
    let sim = if language == Language::Verilog { Sim::Icarus } else { Sim::Ghdl };
    let outcomes = around(core, sim);
    let passed: Vec<bool> = outcomes.iter().map(Outcome::passed).collect();
    let (last, others) = passed.split_last().expect("there is something around the core");
    assert!(others.iter().all(|&passed| passed) && !last, "{what} goes unnoticed by the bench: {outcomes:?}");
    assert!(!outcomes[others.len()].first[0].contains("compile"), "{what}: {outcomes:?}");
}

/// So does the proof of the part that it is in; the others' do not look at its text.
fn found_by_proof(core: &OnDisk, part: Part, language: Language, what: &str) {
    let proofs = formal::around(&core.design, &[part], core.path(), &|_| {}).expect("it runs");
    let broken = format!("{} in {language} ", part.name(&core.design));
    for proof in &proofs {
        let expected = if proof.claim.starts_with(&broken) { ProofStatus::Refuted } else { ProofStatus::Proved };
        assert_eq!(proof.verdict, expected, "{what}: {proof:?}");
    }
}

#[test]
fn broken_tables_fail_their_bench_and_their_proof() {
    let generated = Generated::new(&format!("{SHADER}lights_a_clock = 1\nmost_lights = 16\nlight_source = 'table'\n"));
    TABLE_FAULTS.par_iter().for_each(|&fault| {
        let (what, language, ..) = fault;
        let core = with_fault(&generated, Part::Table, fault);
        found_by_bench(&core, language, what);
        found_by_proof(&core, Part::Table, language, what);
    });
    // What the memory holds is for the bench alone.
    for (language, from, to) in [
        (Language::Verilog, "records[lights_addr] <= lights_data", "records[lights_addr ^ 1'b1] <= lights_data"),
        (Language::Verilog, ".in_l1r    (record[", ".in_l1r    (~record["),
        (Language::Vhdl, "if lights_en = '1' then", "if lights_en = '1' and ce = '1' then"),
    ] {
        let core = with_fault(&generated, Part::Table, ("the memory", language, from, to));
        found_by_bench(&core, language, "the memory");
    }
}

const STREAM_FAULTS: [Fault; 13] = [
    ("tuser of a later sample", Language::Verilog, "in_ready ? s_axis_tuser : user[2:0]", "s_axis_tuser"),
    ("tlast of a later sample", Language::Verilog, "in_ready ? s_axis_tlast : last[1]", "s_axis_tlast"),
    ("tuser dropped by a stall", Language::Verilog, "if (ready) begin\n            last", "begin\n            last"),
    ("tready while words are read", Language::Verilog, "s_axis_tready = ready & in_ready", "s_axis_tready = ready"),
    ("tready while the sink waits", Language::Verilog, "s_axis_tready = ready & in_ready", "s_axis_tready = in_ready"),
    ("tready stuck at 1", Language::Verilog, "s_axis_tready = ready & in_ready", "s_axis_tready = 1'b1"),
    ("tready stuck at 0", Language::Verilog, "s_axis_tready = ready & in_ready", "s_axis_tready = 1'b0"),
    ("a bubble behind a beat", Language::Verilog, "= ready & in_ready", "= ready & in_ready & ~m_axis_tvalid"),
    ("a word from the wrong place", Language::Verilog, "(s_axis_tdata[7:4])", "(s_axis_tdata[8:5])"),
    ("tlast and tuser of a later sample", Language::Vhdl, "if in_ready = '1' then", "if true then"),
    ("tready while words are read", Language::Vhdl, "s_axis_tready <= ready and in_ready", "s_axis_tready <= ready"),
    ("tready while the sink waits", Language::Vhdl, "s_axis_tready <= ready and in_ready", "s_axis_tready <= in_ready"),
    ("tready stuck at 0", Language::Vhdl, "s_axis_tready <= ready and in_ready", "s_axis_tready <= '0'"),
];

#[test]
fn broken_streams_of_samples_fail_their_bench_and_their_proof() {
    // In a language each, so that nothing is run and proved for the other.
    let [verilog, vhdl] = ["verilog", "vhdl"].map(|language| {
        Generated::new(&format!(
            "{SHADER}lights_a_clock = 1\nmost_lights = 16\nlight_source = 'table'\naxi_stream = true\n\
             tuser_bits = 3\npipeline = 4\nlanguages = ['{language}']\n"
        ))
    });
    let of = |language: Language| if language == Language::Verilog { &verilog } else { &vhdl };
    STREAM_FAULTS.par_iter().for_each(|&fault| {
        let (what, language, ..) = fault;
        let core = with_fault(of(language), Part::Axis, fault);
        found_by_bench(&core, language, what);
        found_by_proof(&core, Part::Axis, language, what);
    });
    // What the memory holds is for the bench alone.
    for (language, from, to) in [
        (Language::Verilog, "(lights_addr)", "(~lights_addr)"),
        (Language::Vhdl, "lights_en   => lights_en", "lights_en   => ready"),
    ] {
        let core = with_fault(of(language), Part::Axis, ("the write port", language, from, to));
        found_by_bench(&core, language, "the write port");
    }
}

/// What a user is told of a stream of samples, and what stands beside the stream.
#[test]
fn a_stream_of_samples_says_what_a_beat_is() {
    let core = Generated::new(&format!(
        "{SHADER}lights_a_clock = 1\nmost_lights = 16\nlight_source = 'table'\naxi_stream = true\n"
    ));
    assert_eq!(core.text("files.f"), "rtl/shader.v\nrtl/shader_lights.v\nrtl/shader_table.v\nrtl/shader_axis.v\n");
    let sheet = core.text("README.md");
    for line in [
        "a beat of `s_axis` is a sample, with the first and the last word of its lights",
        "| `lights_en` | in | 1 | write enable of the table, whatever the stream does |",
        "| 3:0 | `in_begin`, UQ4.0 |",
        "| 7:4 | `in_end`, UQ4.0 |",
        "A sample of w words takes w clocks",
    ] {
        assert!(sheet.contains(line), "{line}\n{sheet}");
    }
    let manifest: serde_json::Value = serde_json::from_str(&core.text("manifest.json")).expect("JSON");
    let ports = manifest["axi_stream"]["ports"].as_array().expect("ports");
    let names: Vec<&str> = ports.iter().filter_map(|port| port["name"].as_str()).collect();
    assert_eq!(names[7..10], ["lights_en", "lights_addr", "lights_data"]);
    for path in ["rtl/shader_axis.v", "rtl/shader_axis.vhd"] {
        let text = core.text(path);
        assert!(text.contains("tlast and tuser stay with their sample."), "{text}");
        assert!(text.contains("the beat is taken; from registers"), "{text}");
    }
    let rom = Generated::new(&with_rom(&format!("{SHADER}lights_a_clock = 1\naxi_stream = true\n"), 3));
    assert!(!rom.text("rtl/shader_axis.v").contains("lights_"), "it has no write port");
}

/// A light of every word, in each language; and what samples come of.
#[test]
fn a_changed_rom_of_lights_fails_its_bench() {
    let generated = Generated::new(&with_rom(&format!("{SHADER}lights_a_clock = 1\n"), 3));
    for (language, sim, mark) in [(Language::Verilog, Sim::Icarus, "'h"), (Language::Vhdl, Sim::Ghdl, "x\"")] {
        let file = Part::Table.rtl_path(&generated.design, language);
        let text = generated.text(&file);
        assert!(!text.contains("lights_"), "it has no write port:\n{text}");
        let start = text.find("records").expect("the words");
        let literals: Vec<usize> = text[start..].match_indices(mark).map(|(at, _)| start + at + mark.len()).collect();
        for &at in &literals[..3] {
            // The blue of the light is in the leading bits; the bits below them are red's and the directions'.
            let digit = if &text[at + 1..at + 2] == "0" { "f" } else { "0" };
            let core = generated.on_disk();
            std::fs::write(core.path().join(&file), format!("{}{digit}{}", &text[..at + 1], &text[at + 2..]))
                .expect("written");
            let outcomes = around(&core, sim);
            assert!(outcomes[0].passed() && !outcomes[1].passed(), "{language} at {at}: {outcomes:?}");
        }
    }
    let core = generated.on_disk();
    let file = core.path().join("golden").join(format!("{}.vec", Part::Table.name(&core.design)));
    let text = std::fs::read_to_string(&file).expect("samples");
    let last = text.lines().rfind(|line| line.starts_with('v')).expect("a sample");
    let mut fields: Vec<&str> = last.split(' ').collect();
    let blue = fields.len() - 3;
    fields[blue] = if fields[blue] == "00" { "01" } else { "00" };
    let changed = fields.join(" ");
    std::fs::write(&file, text.replace(last, &changed)).expect("written");
    assert_eq!(around(&core, Sim::Icarus)[1].mismatches, 1, "{last}");
}

#[test]
fn broken_sequencers_fail_their_bench_and_their_proof() {
    let generated = Generated::new(&format!("{SHADER}lights_a_clock = 1\nmost_lights = 4\n"));
    FAULTS.par_iter().for_each(|&(what, language, from, to)| {
        let core = generated.on_disk();
        let file = Part::Lights.rtl_path(&core.design, language);
        let text = generated.text(&file);
        assert_eq!(text.matches(from).count(), 1, "{what}: `{from}` in\n{text}");
        std::fs::write(core.path().join(&file), text.replacen(from, to, 1)).expect("written");
        let sim = if language == Language::Verilog { Sim::Icarus } else { Sim::Ghdl };
        let outcome = &around(&core, sim)[0];
        assert!(!outcome.passed(), "{what} goes unnoticed by the bench: {outcome:?}");
        let proofs = formal::around(&core.design, &[Part::Lights], core.path(), &|_| {}).expect("it runs");
        let found = proofs.iter().any(|proof| proof.verdict == ProofStatus::Refuted);
        assert!(found, "{what} goes unnoticed by the proof: {proofs:?}");
    });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// A sum that is kept at 1.0 at every step, as in hardware, gives the codes of one that has no bound.
    #[test]
    fn a_sum_may_be_kept_at_one_at_every_step(
        clocks in proptest::collection::vec(proptest::collection::vec(0i64..=1 << 14, 3), 1..20),
        ambient in proptest::collection::vec(0i64..1 << 12, 3),
        small in any::<bool>(),
    ) {
        let sums = Sums { frac_bits: 14, ambient: Some(12), channel_bits: 8 };
        let clocks: Vec<Vec<i64>> = clocks
            .iter()
            .map(|lights| lights.iter().map(|&sum| if small { sum >> 4 } else { sum }).chain(ambient.clone()).collect())
            .collect();
        let kept = |channel: usize| {
            let total = clocks.iter().fold(ambient[channel] << 2, |sum, lights| (sum + lights[channel]).min(1 << 14));
            ((total + 32) >> 6).min(255)
        };
        prop_assert_eq!(sums.codes(clocks.iter().map(Vec::as_slice)), [0, 1, 2].map(kept));
    }
}

/// Samples of 64 lights, as a sky has them, each about a 64th as bright as full scale: the roundings of all of them
/// together stay below half a code, and the codes near the exact reflectance's.
#[test]
fn sixty_four_lights_are_as_exact_as_one() {
    for spec in ["image_form = 'bivariate'", "images = 16"] {
        let design = design(&format!("block = 'image'\n{spec}\nreflectance = {{ model = 'gold-paint' }}"));
        let BlockDesign::Image(image) = design.block() else { panic!("an image-based block") };
        let ImageSource::Model(model) = &image.of.source else { panic!("a model") };
        let lights: Vec<Light> = (0..64).map(|l| Light::new(2.0 * f64::from(l % 40), 137.5 * f64::from(l))).collect();
        let intensity = [1.0 / 64.0; 3];
        let full = image.of.image.full_scale() as f64;
        let mut worst: f64 = 0.0;
        let records: Vec<_> =
            lights.iter().map(|&light| image.block.record(light, intensity).expect("an intensity")).collect();
        let unit = exp2(-(image.of.image.vector_fraction as i32));
        for step in 0..50 {
            let (height, turn) = (1.0 - 0.9 * f64::from(step) / 50.0, 2.4 * f64::from(step));
            let across = (1.0 - height * height).sqrt();
            let n = Vector::new(across * turn.cos(), across * turn.sin(), height);
            let normal = image.vector(n);
            let of_light = |record: &LightRecord| design.evaluate(&[&normal[..], &record.codes()].concat());
            let codes = design.sample_of(&records.iter().map(of_light).collect::<Vec<_>>());
            let near = Vector::new(normal[0] as f64 * unit, normal[1] as f64 * unit, normal[2] as f64 * unit);
            let (mut exact, mut stored) = ([0.0; 3], [0.0; 3]);
            for (&light, record) in lights.iter().zip(&records) {
                let of = model.radiance(light, n, image.of.exposure);
                let real = image.block.light_of(record);
                let by_texels = image.block.real(near, &real, RealTexels::Stored, Places::Rounded);
                for channel in [0, 1, 2] {
                    exact[channel] += full * of[channel] / 64.0;
                    stored[channel] += full * by_texels[channel];
                }
            }
            for channel in [0, 1, 2] {
                let code = codes[channel] as f64;
                worst = worst.max((code - stored[channel].min(full)).abs());
                assert!((code - exact[channel].min(full)).abs() < 6.0, "{n:?}: {codes:?}");
            }
        }
        // Half a code is that of the output itself.
        assert!(worst < 1.0, "{worst}");
    }
}

/// The words for a host: each light's codes where the ports' places in `lights_data` are, two lights a word.
#[test]
fn words_of_the_table_hold_the_records() {
    let dir = Scratch::new();
    let core = "--block image --images 4 --image-size 8 --reflectance ggx --light-source table --lights-a-clock 2 \
                --most-lights 4 --out core";
    dir.run(&format!("generate {core}")).succeeds();
    let run = "image lights core --light 60,20 --light 10,0,1,0.5,0 --light 120,90 --mem lights.mem --json";
    let json = dir.run(run).succeeds().json();
    let manifest: serde_json::Value = serde_json::from_str(&dir.text("core/manifest.json")).expect("JSON");
    let table = &manifest["light_table"];
    let text = dir.text("lights.mem");
    let words: Vec<BigUint> =
        text.lines().map(|line| BigUint::parse_bytes(line.as_bytes(), 16).expect("hexadecimal")).collect();
    assert_eq!(words.len(), 2);
    assert_eq!(table["depth"], 2);
    for field in table["word"].as_array().expect("fields") {
        let name = field["name"].as_str().expect("a name");
        let (low, bits) = (field["low_bit"].as_u64().expect("a bit"), field["bits"].as_u64().expect("bits"));
        for (word, first) in words.iter().zip([0, 2]) {
            let code = (word >> low) & ((BigUint::from(1u8) << bits) - 1u8);
            let light = first + usize::from(name.contains('2'));
            let expected = json.get(light).map_or(0, |light| light["codes"][name.replace('2', "1")].as_i64().unwrap());
            let expected = BigUint::from((expected as u64) & ((1 << bits) - 1));
            assert_eq!(code, expected, "{name} of light {light}");
        }
    }
    let five = "image lights core --light 1,0 --light 2,0 --light 3,0 --light 4,0 --light 5,0 --mem lights.mem";
    dir.refused(five, &["5 lights are more than the 4 of the table"]);
}

#[test]
fn the_keys_of_lights_are_refused_where_there_is_no_sequencer() {
    let refused = |spec: &str, words: &str| {
        let error = SpecFields::parse(spec, "spec").and_then(SpecFields::resolve).unwrap_err().to_string();
        assert!(error.contains(words), "{spec}: {error}");
    };
    refused("method = 'quadratic'\nshininess = '1..=9'\nlights_a_clock = 1", "lights_a_clock is given");
    refused("method = 'quadratic'\nshininess = '1..=9'\nmost_lights = 1", "most_lights is given");
    refused(&format!("{SHADER}most_lights = 3"), "most_lights is given for a shader that takes all lights");
    refused(&format!("{SHADER}light_source = 'table'"), "light_source is given for a shader that takes all lights");
    refused(&format!("{SHADER}lights_a_clock = 1\nlight_source = 'rom'"), "given without lights");
    refused(&format!("{SHADER}lights_a_clock = 1\nlight_records = [[1]]"), "whose lights are not a ROM's");
    refused("method = 'quadratic'\nshininess = '1..=9'\nlight_records = [[1]]", "light_records is given");
    for (record, words) in [
        ("[[1, 2]]", "number 1 of light_records has 2 codes"),
        ("[[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 256]]", "number 2 of light_records has the code 256 for in_l1b"),
    ] {
        let spec = format!("{SHADER}lights_a_clock = 1\nlight_source = 'rom'\nlight_records = {record}");
        let error = Design::new(resolved(&spec)).expect_err("no core").to_string();
        assert!(error.contains(words), "{error}");
    }
    refused(&format!("{SHADER}lights_a_clock = 0"), "lights_a_clock = 0 is out of range");
    refused(&format!("{SHADER}lights_a_clock = 1\n[shader]\nlights = 1"), "both lights and lights_a_clock are given");
    for spec in [format!("{SHADER}lights_a_clock = 2\n"), with_rom(&format!("{SHADER}lights_a_clock = 2\n"), 3)] {
        let own = design(&spec).spec;
        assert_eq!(own.to_toml().parse::<brdfgen::Spec>().expect("core.toml"), own);
    }
    assert!(design(SHADER).sums().is_none());
    let ports = design(&format!("{SHADER}lights_a_clock = 2")).whole_ports();
    let outputs: Vec<&str> =
        ports.iter().filter(|port| port.carries(Direction::Out)).map(|port| port.name.as_str()).collect();
    assert_eq!(outputs, ["out_r", "out_g", "out_b"]);
}
