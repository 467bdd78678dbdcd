//! The front door: a core with all that goes with it, as `brdfgen generate` makes it.

use std::path::Path;

use crate::core::{Account, Design, Direction, Evaluation};
use crate::emit::package::{self, File, Stale};
use crate::emit::rom::RomFormat;
use crate::fixed::Format;
use crate::platform::error::{Error, refuse};
use crate::spec::{CoreSpec, InputRange};
use crate::verify::cosim::{self, Job, Outcome, Sim};
use crate::verify::golden::Golden;

/// A core with all that goes with it.
///
/// ```
/// use brdfgen::core::Account;
/// use brdfgen::emit::rom::RomFormat;
/// use brdfgen::{Core, Spec};
///
/// let spec: Spec = "name = 'lobe'\nmethod = 'quadratic'\nshininess = '1..=16'\ninput_fraction = 8".parse()?;
/// let core = Core::generate(&spec)?;
///
/// // The error against the real-valued method in units of the last place of `out_spec`: proved for every input, and
/// // measured over all cosines from 0 to 1.
/// let [low, high] = core.design.lobe().budget.proved_ulps;
/// assert!(-1.0 < low && high < 1.0);
/// let Account::Lobe { measured, .. } = &core.account else { unreachable!("the spec asks for no shader") };
/// assert!(measured.sweep.exhaustive && low <= measured.ulps[0] && measured.ulps[1] <= high);
/// println!("{} clocks, off x^n by {:.4} at most", core.design.schedule.latency, measured.max_abs);
///
/// // The bit-exact model: by codes, here n = 5 and the cosine 250/256; and by numbers, with what the result should be.
/// let codes = core.evaluate(&[5, 250])?;
/// let result = core.at(5.0, 250.0 / 256.0)?;
/// assert_eq!(codes, [i64::from(result.output)]);
/// assert!((result.value - result.exact).abs() <= measured.max_abs);
///
/// // The coefficient memory in a format that the spec does not ask for, and the golden vectors.
/// assert_eq!(core.rom(RomFormat::Coe)[0].path, "rom/lobe.coe");
/// let first = core.golden.vectors()[0];
/// assert_eq!(core.evaluate(&first.inputs)?, first.outputs);
///
/// // The golden vectors through the pipeline, in this process; then the directory.
/// assert!(core.simulate()?.passed());
/// let directory = tempfile::tempdir()?;
/// core.write(directory.path())?;
/// assert!(core.check(directory.path()).is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Core {
    /// The core itself: its spec, operations, memories, ports and pipeline, and what is proved of its error.
    pub design: Design,
    /// Its measured error.
    pub account: Account,
    /// Its golden vectors.
    pub golden: Golden,
    /// The files of its directory, `manifest.json` last.
    pub files: Vec<File>,
}

impl Core {
    /// Builds a core, measures its error, chooses its golden vectors and makes its files. That takes some seconds for a
    /// thousand shininesses at 16 bits, and up to minutes where coefficients are fitted; for the bit-exact model and
    /// the memories alone [`Design::new`] is enough.
    ///
    /// # Errors
    /// A spec that no core can be built for (see [`Design::new`]), or a name that the core's text uses for something
    /// else.
    pub fn generate(spec: &CoreSpec) -> Result<Self, Error> {
        Self::of(Design::new(spec.clone())?, Vec::new())
    }

    /// The same of a core that is built, with more files in its directory.
    ///
    /// # Errors
    /// A name that the core's text uses for something else, or files that cannot be made ([`package::files_with`]).
    pub fn of(design: Design, others: Vec<File>) -> Result<Self, Error> {
        package::check_names(&design)?;
        let account = Account::of(&design);
        let golden = Golden::of(&design);
        let files = package::files_with(&design, &account, &golden, others)?;
        Ok(Self { design, account, golden, files })
    }

    /// The codes at the output ports for codes at the input ports, by the bit-exact model; both in the order of
    /// [`Design::numbers`]. Of a lobe `in_n` and the operand in, `out_spec` out.
    ///
    /// # Errors
    /// Another number of codes than there are ports, or a code that its port does not hold.
    pub fn evaluate(&self, inputs: &[i64]) -> Result<Vec<i64>, Error> {
        let ports = self.design.numbers(Direction::In);
        let fits = |(&code, (_, format)): (&i64, &(&str, Format))| {
            (format.min_code()..=format.max_code()).contains(&i128::from(code))
        };
        if inputs.len() == ports.len() && inputs.iter().zip(&ports).all(fits) {
            return Ok(self.design.evaluate(inputs));
        }
        let port = |(name, format): &(&str, Format)| format!("{name} {} to {}", format.min_code(), format.max_code());
        Err(Error::input(
            format!("{inputs:?} are no codes of the inputs of {}", self.design.spec.name),
            format!("give one for each: {}", ports.iter().map(port).collect::<Vec<_>>().join(", ")),
        ))
    }

    /// The result of a lobe for the shininess `n` and the code nearest to a cosine, with what it should be.
    ///
    /// # Errors
    /// A shader, a shininess that the core does not have, a cosine that its port does not hold or, with an
    /// `input_range` of `unit`, one outside [0, 1].
    pub fn at(&self, n: f64, cosine: f64) -> Result<Evaluation, Error> {
        let is_unit = self.design.lobe().interface.input_range == InputRange::Unit;
        refuse!(
            is_unit && !(0.0..=1.0).contains(&cosine),
            format!("the core takes no cosine of {cosine}"),
            "it takes those in [0, 1]"
        );
        self.design.lobe().at(self.design.spec.row_of(n)?, cosine)
    }

    /// The files of all memories in a format, whether the spec asks for it or not.
    #[must_use]
    pub fn rom(&self, format: RomFormat) -> Vec<File> {
        self.design.tables().iter().map(|table| package::rom_file(&self.design, table, format)).collect()
    }

    /// The core in the directory that it is written to, for [`cosim::golden`] and what else runs tools.
    #[must_use]
    pub fn job<'a>(&'a self, directory: &'a Path) -> Job<'a> {
        Job { design: &self.design, golden: &self.golden, directory }
    }

    /// Runs the golden vectors through the core in this process.
    ///
    /// # Errors
    /// As [`cosim::golden`]; a core that fails is an [`Outcome`].
    pub fn simulate(&self) -> Result<Outcome, Error> {
        cosim::golden(Sim::Builtin, &self.job(Path::new("")))
    }

    /// Writes the directory as [`package::write_directory`] does: whole, or over an earlier core.
    ///
    /// # Errors
    /// A directory with something else in it, or one that the system refuses to write.
    pub fn write(&self, directory: &Path) -> Result<(), Error> {
        package::write_directory(directory, &self.files)
    }

    /// The files that are not in a directory as they should be, with what is wrong.
    #[must_use]
    pub fn check(&self, directory: &Path) -> Vec<(&str, Stale)> {
        package::stale(directory, &self.files)
    }
}
