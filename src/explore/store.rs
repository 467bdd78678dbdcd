//! The results of a run on disk, in SQLite: each finished point is committed at once.
//!
//! A results file holds figures of one kind and one set of tools: what made them is written in it, and a run of another
//! kind is refused.

use std::collections::BTreeMap;
use std::fs::{File, TryLockError};
use std::path::{Path, PathBuf};
use std::time::Duration;

use rusqlite::{Connection, OpenFlags, OptionalExtension, params};
use serde::{Deserialize, Serialize};

use super::{Point, Results};
use crate::platform::error::{Error, refuse};
use crate::platform::transient::Folder;
use crate::synth::Tools;

/// What made the figures of a results file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Provenance {
    /// The version of this program.
    pub program: String,
    /// How costs were found.
    pub costing: String,
    /// The tools by family.
    pub tools: BTreeMap<String, Tools>,
}

/// A results file that is open.
#[derive(Debug)]
pub struct Store {
    connection: Connection,
    path: PathBuf,
    /// Held while a run works with the file; closed after the connection, as closing any handle of a file ends SQLite's
    /// locks on it.
    lock: Option<File>,
}

/// Marks the file as one of ours: `brdf`.
const APPLICATION: i32 = 0x6272_6466;

const SCHEMA: &str = "
CREATE TABLE provenance (document TEXT NOT NULL);
CREATE TABLE point (id TEXT PRIMARY KEY, failed INTEGER NOT NULL, document TEXT NOT NULL) WITHOUT ROWID;
CREATE VIEW trade AS SELECT
    id, document ->> 'name' AS name, document ->> 'family' AS family, document ->> 'method' AS method,
    document ->> 'coefficients' AS coefficients, document ->> 'variant' AS variant, document ->> 'shininess' AS \
    shininess,
    document ->> 'input_fraction' AS input_fraction, document ->> 'output_fraction' AS output_fraction,
    document ->> 'max_abs' AS max_abs, document ->> 'max_rel' AS max_rel, document ->> 'rms' AS rms,
    document ->> 'rom_bits' AS rom_bits, document ->> 'latency' AS latency,
    coalesce(document ->> '$.synthesis.resources.lut_total', document ->> '$.estimate.lut') AS lut,
    coalesce(document ->> '$.synthesis.resources.ff', document ->> '$.estimate.ff') AS ff,
    coalesce(document ->> '$.synthesis.resources.dsp', document ->> '$.estimate.dsp') AS dsp,
    coalesce(document ->> '$.synthesis.resources.bram', document ->> '$.estimate.bram') AS bram,
    document ->> '$.synthesis.timing.median_mhz' AS median_mhz, document ->> 'failure' AS failure
    FROM point;
";

impl Provenance {
    /// Where two differ, or both as one: the families of both.
    fn with(&self, other: &Self) -> Result<Self, String> {
        if self.program != other.program {
            return Err(format!("of brdfgen {} and of brdfgen {}", self.program, other.program));
        }
        if self.costing != other.costing {
            return Err(format!("of {} and of {}", self.costing, other.costing));
        }
        let text = |tools: &Tools| match &tools.nextpnr {
            Some(nextpnr) => format!("{} with {nextpnr}", tools.yosys),
            None => tools.yosys.clone(),
        };
        for (family, tools) in &self.tools {
            // A Yosys is one for all families.
            for (other_family, others) in &other.tools {
                if tools.yosys != others.yosys || (family == other_family && tools != others) {
                    return Err(format!("of {} and of {}", text(tools), text(others)));
                }
            }
        }
        let mut all = self.clone();
        all.tools.extend(other.tools.clone());
        Ok(all)
    }
}

/// What becomes of the points that a results file holds already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Earlier {
    /// They stay.
    Kept,
    /// The file is started anew.
    Deleted,
}

impl Store {
    /// Opens a results file, or makes it, for figures that are made like this.
    ///
    /// # Errors
    /// A file that is no results file, that holds figures made otherwise, or that cannot be written.
    pub fn open(path: &Path, provenance: &Provenance, earlier: Earlier) -> Result<Self, Error> {
        let mut store = Self::connect(path, OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE)?;
        store.lock(earlier)?;
        let mut refused = None;
        store.write(|transaction| {
            if earlier == Earlier::Deleted {
                transaction.execute_batch("DELETE FROM point; DELETE FROM provenance;")?;
            }
            let held: Option<String> =
                transaction.query_row("SELECT document FROM provenance", [], |row| row.get(0)).optional()?;
            let held = match held.map(|text| serde_json::from_str::<Provenance>(&text)).transpose() {
                Ok(held) => held,
                Err(error) => {
                    refused = Some(damaged(path, &error));
                    return Ok(());
                }
            };
            match held.map_or_else(|| Ok(provenance.clone()), |held| held.with(provenance)) {
                Ok(joined) => {
                    let text = serde_json::to_string(&joined).expect("JSON of plain values");
                    transaction.execute("DELETE FROM provenance", [])?;
                    transaction.execute("INSERT INTO provenance VALUES (?1)", [text])?;
                }
                Err(what) => {
                    refused = Some(Error::input(
                        format!("{}: the results would hold figures {what}", path.display()),
                        "give another file, or --fresh to start this one anew: figures that are made differently \
                         cannot be compared",
                    ));
                }
            }
            Ok(())
        })?;
        refused.map_or(Ok(store), Err)
    }

    /// Opens a results file to read it.
    ///
    /// # Errors
    /// A file that is not there or is no results file.
    pub fn open_to_read(path: &Path) -> Result<Self, Error> {
        // Write access, as a run that was killed may have left a journal to be rolled back.
        Self::connect(path, OpenFlags::SQLITE_OPEN_READ_WRITE)
    }

    fn connect(path: &Path, flags: OpenFlags) -> Result<Self, Error> {
        let creates = flags.contains(OpenFlags::SQLITE_OPEN_CREATE);
        match std::fs::metadata(path) {
            Ok(there) if there.is_dir() => return Err(not_ours(path)),
            Err(error) if !creates => return Err(Error::io("cannot read", path, error)),
            _ => {}
        }
        let refused = |error: rusqlite::Error| refusal(path, &error);
        let connection = Connection::open_with_flags(path, flags | OpenFlags::SQLITE_OPEN_NO_MUTEX).map_err(refused)?;
        connection.busy_timeout(Duration::from_secs(60)).map_err(refused)?;
        // A commit is on the disk when it returns, so that no crash of the machine takes a finished point back either.
        connection.pragma_update(None, "synchronous", "FULL").map_err(refused)?;
        let mut store = Self { connection, path: path.to_owned(), lock: None };
        let pragma = |name: &str| store.connection.pragma_query_value(None, name, |row| row.get::<_, i32>(0));
        let (application, version) =
            (pragma("application_id").map_err(refused)?, pragma("schema_version").map_err(refused)?);
        if application != APPLICATION {
            if version != 0 || !creates {
                return Err(refusal(path, &rusqlite::Error::InvalidQuery));
            }
            store.write(|transaction| {
                // Another run may have been faster.
                let application: i32 = transaction.pragma_query_value(None, "application_id", |row| row.get(0))?;
                if application == APPLICATION {
                    return Ok(());
                }
                transaction.execute_batch(SCHEMA)?;
                transaction.pragma_update(None, "application_id", APPLICATION)
            })?;
        }
        Ok(store)
    }

    /// Says to other runs that this one works with the file, as several may, or that it starts the file anew, as one
    /// alone may.
    fn lock(&mut self, earlier: Earlier) -> Result<(), Error> {
        // Beside SQLite's own locks, which are of another kind and last for a transaction.
        let file = File::open(&self.path).map_err(|error| Error::io("cannot read", &self.path, error))?;
        let locked = match earlier {
            Earlier::Kept => file.try_lock_shared(),
            Earlier::Deleted => file.try_lock(),
        };
        match locked {
            Err(TryLockError::WouldBlock) => {
                return Err(Error::input(
                    format!("another run of explore works with {}", self.path.display()),
                    "runs share a results file, but one that starts it anew with --fresh must be alone: wait, or give \
                     another file",
                ));
            }
            // A file system without locks.
            Err(TryLockError::Error(_)) | Ok(()) => {}
        }
        self.lock = Some(file);
        Ok(())
    }

    fn refused(&self) -> impl Fn(rusqlite::Error) -> Error + '_ {
        |error| refusal(&self.path, &error)
    }

    /// Runs statements as one transaction.
    fn write(&mut self, run: impl FnOnce(&rusqlite::Transaction) -> rusqlite::Result<()>) -> Result<(), Error> {
        let path = self.path.clone();
        let result = (|| {
            let transaction = self.connection.transaction_with_behavior(rusqlite::TransactionBehavior::Immediate)?;
            run(&transaction)?;
            transaction.commit()
        })();
        result.map_err(|error| refusal(&path, &error))
    }

    /// What made the figures; nothing of a new file.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn provenance(&self) -> Result<Option<Provenance>, Error> {
        let query = self.connection.query_row("SELECT document FROM provenance", [], |row| row.get::<_, String>(0));
        let text = query.optional().map_err(self.refused())?;
        text.map(|text| serde_json::from_str(&text).map_err(|error| damaged(&self.path, &error))).transpose()
    }

    /// The ids of the points that are there, each with whether it failed and may be tried again.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn known(&self) -> Result<BTreeMap<String, bool>, Error> {
        let rows = || -> rusqlite::Result<BTreeMap<String, bool>> {
            let mut query = self.connection.prepare("SELECT id, failed FROM point")?;
            query.query_map([], |row| Ok((row.get(0)?, row.get(1)?)))?.collect()
        };
        rows().map_err(self.refused())
    }

    /// Adds a point, or puts it in the place of the one with its id. It is on the disk when this returns.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn put(&mut self, point: &Point) -> Result<(), Error> {
        let text = serde_json::to_string(point).expect("JSON of plain values");
        self.write(|transaction| {
            let values = params![point.id, point.is_to_retry(), text];
            transaction.execute("INSERT OR REPLACE INTO point VALUES (?1, ?2, ?3)", values).map(|_| ())
        })
    }

    /// All points.
    ///
    /// # Errors
    /// A file that cannot be read, or a figure that cannot be one.
    pub fn results(&self) -> Result<Results, Error> {
        let rows = || -> rusqlite::Result<Vec<String>> {
            let mut query = self.connection.prepare("SELECT document FROM point")?;
            query.query_map([], |row| row.get(0))?.collect()
        };
        let texts = rows().map_err(self.refused())?;
        let points: Result<Vec<Point>, _> = texts.iter().map(|text| serde_json::from_str(text)).collect();
        let points = points.map_err(|error| damaged(&self.path, &error))?;
        Results::checked(points, |_| self.path.display().to_string())
    }

    /// Writes the points of several results files into a new one. Where files have the same point, one that did not
    /// fail wins.
    ///
    /// # Errors
    /// Files of different kinds or tools, a point that two files tell differently, or a target that is there already.
    pub fn merge(parts: &[PathBuf], out: &Path) -> Result<usize, Error> {
        refuse!(out.exists(), format!("{} is there already", out.display()), "give --out a new file");
        let mut points: BTreeMap<String, (Point, &Path)> = BTreeMap::new();
        let mut joined: Option<Provenance> = None;
        for path in parts {
            let part = Self::open_to_read(path)?;
            let Some(own) = part.provenance()? else { continue };
            joined = Some(match joined {
                None => own,
                Some(held) => held.with(&own).map_err(|what| {
                    Error::input(
                        format!("{}: the merged results would hold figures {what}", path.display()),
                        "merge results of one version of the tools: figures that are made differently cannot be \
                         compared",
                    )
                })?,
            });
            for point in part.results()?.points() {
                match points.get(&point.id) {
                    Some((held, from)) if held.failure.is_none() && point.failure.is_none() && held != point => {
                        return Err(Error::input(
                            format!(
                                "{} and {} tell the point {} differently",
                                from.display(),
                                path.display(),
                                point.id
                            ),
                            "the same core has the same figures: one of the files is of another state of the program",
                        ));
                    }
                    Some((held, _)) if held.failure.is_none() || point.failure.is_some() => {}
                    _ => {
                        points.insert(point.id.clone(), (point.clone(), path));
                    }
                }
            }
        }
        let Some(provenance) = joined else {
            return Err(Error::input("there is nothing to merge", "give results files of explore"));
        };
        // Under another name until it is whole.
        let directory = out.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let scratch = Folder::new_in(directory).map_err(|error| Error::io("cannot write in", directory, error))?;
        let whole = scratch.path().join("merged.db");
        let mut store = Self::open(&whole, &provenance, Earlier::Kept)?;
        let count = points.len();
        store.write(|transaction| {
            let mut insert = transaction.prepare("INSERT INTO point VALUES (?1, ?2, ?3)")?;
            for (point, _) in points.values() {
                let text = serde_json::to_string(point).expect("JSON of plain values");
                insert.execute(params![point.id, point.is_to_retry(), text])?;
            }
            Ok(())
        })?;
        drop(store);
        std::fs::rename(&whole, out).map_err(|error| Error::io("cannot write", out, error))?;
        Ok(count)
    }
}

fn refusal(path: &Path, error: &rusqlite::Error) -> Error {
    let name = path.display();
    match error.sqlite_error_code() {
        Some(rusqlite::ErrorCode::CannotOpen) => {
            Error::input(format!("cannot open {name}"), "the results file must be in a directory that can be written")
        }
        Some(rusqlite::ErrorCode::NotADatabase) => not_ours(path),
        None if matches!(error, rusqlite::Error::InvalidQuery) => not_ours(path),
        _ => Error::input(
            format!("{name}: {error}"),
            "a results file of `brdfgen explore`, on a disk that can be written",
        ),
    }
}

fn not_ours(path: &Path) -> Error {
    Error::input(
        format!("{} is no results file of brdfgen", path.display()),
        "give a file that `brdfgen explore` wrote, or a new one",
    )
}

fn damaged(path: &Path, error: &serde_json::Error) -> Error {
    Error::input(format!("{}: {error}", path.display()), "the results are of another version of brdfgen: explore anew")
}
