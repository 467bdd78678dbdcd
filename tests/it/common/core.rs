//! Cores in memory and on disk.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicU64, Ordering};

use brdfgen::core::{Account, Design, LobeDesign};
use brdfgen::emit::package;
use brdfgen::fixed::exp2;
use brdfgen::spec::{CoreSpec, Language, SpecFields};
use brdfgen::verify::cosim::{self, Job, Outcome, Sim};
use brdfgen::verify::golden::{Golden, all_codes};
use rayon::prelude::*;
use tempfile::TempDir;

/// The spec of TOML text.
#[track_caller]
pub fn resolved(spec: &str) -> CoreSpec {
    SpecFields::parse(spec, "test").and_then(SpecFields::resolve).expect(spec)
}

/// The core of TOML text.
#[track_caller]
pub fn design(spec: &str) -> Design {
    Design::new(resolved(spec)).expect(spec)
}

/// A core with its golden vectors and files.
#[derive(Clone)]
pub struct Generated {
    pub design: Design,
    pub golden: Golden,
    pub files: Vec<package::File>,
}

impl Generated {
    #[track_caller]
    pub fn new(spec: &str) -> Self {
        let design = design(spec);
        let golden = Golden::of(&design);
        let files = package::files(&design, &Account::of(&design), &golden).expect("files");
        Self { design, golden, files }
    }

    pub fn text(&self, path: &str) -> String {
        let file = self.files.iter().find(|file| file.path == path).expect(path);
        String::from_utf8(file.bytes.clone()).expect("text")
    }

    /// On disk with a fault in its HDL: a text that stands there once, and what takes its place.
    #[track_caller]
    pub fn with_fault(&self, language: Language, (what, from, to): (&str, &str, &str)) -> OnDisk {
        let text = self.text(&package::rtl_path(&self.design, language));
        assert_eq!(text.matches(from).count(), 1, "{what}: `{from}` stands once in the core");
        let core = self.on_disk();
        std::fs::write(core.rtl(language), text.replace(from, to)).expect("written");
        core
    }

    pub fn on_disk(&self) -> OnDisk {
        let scratch = tempfile::tempdir().expect("a directory");
        let directory = scratch.path().join("core");
        package::write_directory(&directory, &self.files).expect("written");
        OnDisk { design: self.design.clone(), golden: self.golden.clone(), directory, scratch }
    }
}

/// A core in a directory of its own.
pub struct OnDisk {
    pub design: Design,
    pub golden: Golden,
    directory: PathBuf,
    scratch: TempDir,
}

impl OnDisk {
    #[track_caller]
    pub fn new(spec: &str) -> Self {
        Generated::new(spec).on_disk()
    }

    /// Its directory.
    pub fn path(&self) -> &Path {
        &self.directory
    }

    /// A path beside its directory, for what tools make.
    pub fn beside(&self, name: &str) -> PathBuf {
        self.scratch.path().join(name)
    }

    pub fn job(&self) -> Job<'_> {
        Job { design: &self.design, golden: &self.golden, directory: &self.directory }
    }

    pub fn run(&self, sim: Sim) -> Outcome {
        cosim::golden(sim, &self.job()).expect("it runs")
    }

    pub fn rtl(&self, language: Language) -> PathBuf {
        self.directory.join(package::rtl_path(&self.design, language))
    }

    /// Both languages as Verilog, for synthesis: the VHDL as GHDL's synthesis writes it.
    pub fn as_verilog(&self) -> [PathBuf; 2] {
        let synthesized = self.beside("from_vhdl.v");
        let ghdl = Command::new("ghdl")
            .current_dir(self.path())
            .args(["--synth", "--std=08", "--out=verilog"])
            .arg(self.rtl(Language::Vhdl))
            .args(["-e", &self.design.spec.name])
            .output()
            .expect("ghdl");
        std::fs::write(&synthesized, ghdl.stdout).expect("written");
        [self.rtl(Language::Verilog), synthesized]
    }
}

/// The files of a core pass a program that is to say nothing.
#[track_caller]
pub fn silent(directory: &Path, program: &str, arguments: &[&str], what: &str) {
    let output = Command::new(program).current_dir(directory).args(arguments).output().expect(program);
    let text = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success() && text.trim().is_empty(), "{program} on {what}:\n{text}");
}

/// How many cells of a kind Yosys makes of Verilog for ECP5; it runs in the directory above the source's, as a core's
/// is.
pub fn ecp5_cells(source: &Path, top: &str) -> impl Fn(&str) -> u32 {
    let script = format!("read_verilog {}; synth_ecp5 -top {top}; stat", source.display());
    let directory = source.parent().and_then(Path::parent).expect("a directory");
    let output = Command::new("yosys").current_dir(directory).args(["-p", &script]).output().expect("yosys");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let report = text.rsplit("Printing statistics").next().unwrap_or_default().to_owned();
    move |cell: &str| -> u32 {
        let line = report.lines().find(|line| line.split_ascii_whitespace().any(|word| word == cell));
        line.and_then(|line| line.split_ascii_whitespace().find_map(|word| word.parse().ok())).unwrap_or(0)
    }
}

/// Every code of a lobe's operand port for every `row_step`th shininess by the evaluator: `check` is given the row, the
/// code of `in_n`, that of the operand and the result, which at every `stride`th code is the model's.
pub fn every_input(lobe: LobeDesign<'_>, row_step: usize, stride: i64, check: impl Fn(usize, u32, i64, u32) + Sync) {
    let (first, count) = all_codes(lobe.operand_format());
    let (evaluator, model, set) = (lobe.evaluator(), lobe.model(), &lobe.interface.shininess);
    let compared = AtomicU64::new(0);
    let rows: Vec<usize> = (0..set.rows()).step_by(row_step).collect();
    rows.par_iter().for_each(|&row| {
        let index = set.index_of_row(row);
        let mut outputs = vec![0u32; count as usize];
        evaluator.evaluate(index, first, 1, &mut outputs);
        let mut own = 0;
        for (offset, &output) in outputs.iter().enumerate() {
            let operand = first + offset as i64;
            check(row, index, operand, output);
            if (operand + row as i64) % stride == 0 {
                let expected = model.evaluate(index, operand);
                assert_eq!(expected, output, "{}row {row}, operand {operand}", lobe.spec.to_toml());
                own += 1;
            }
        }
        compared.fetch_add(own, Ordering::Relaxed);
    });
    let expected = rows.len() as u64 * count / stride.unsigned_abs();
    assert!(compared.into_inner() >= expected / 2, "too few compared with the model:\n{}", lobe.spec.to_toml());
}

/// The same inputs: each result is within the proved bound of the real-valued method, which is below one output ulp.
#[track_caller]
pub fn assert_every_input(spec: &str, row_step: usize, stride: i64) {
    let design = design(spec);
    let lobe = design.lobe();
    let [low, high] = lobe.budget.proved_ulps;
    assert!(-1.0 < low && high < 1.0, "{spec}: proved {low}..{high}");
    let scale = exp2(lobe.interface.output_fraction as i32);
    every_input(lobe, row_step, stride, |row, _, operand, output| {
        // The method itself is computed in double precision here.
        let error = f64::from(output) - lobe.lobes[row].at(lobe.versine(operand)) * scale;
        assert!(
            low - 1e-6 <= error && error <= high + 1e-6 && f64::from(output) <= scale,
            "{spec}: row {row}, operand {operand}: {output}, error {error} outside {low}..{high}"
        );
    });
}
