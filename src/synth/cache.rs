//! Results on disk, by the digest of all that they depend on.

use std::path::PathBuf;

use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};

use crate::emit::package;
use crate::platform::error::Error;
use crate::spec::hex;

/// A folder of results. A file is the digest of its second line, and that line: a JSON text.
pub(super) struct Cache {
    folder: Option<PathBuf>,
}

/// The digest of parts, in order; each with its length, so that nothing moves from one to the next unseen.
pub(super) fn key(parts: &[&[u8]]) -> String {
    let mut digest = Sha256::new();
    for part in parts {
        digest.update((part.len() as u64).to_le_bytes());
        digest.update(part);
    }
    hex(&digest.finalize())
}

impl Cache {
    /// The folder, or none: then nothing is kept or found.
    pub(super) fn new(folder: Option<PathBuf>) -> Self {
        Self { folder }
    }

    fn path(&self, key: &str) -> Option<PathBuf> {
        // Two characters make a folder: a large exploration keeps tens of thousands of files.
        Some(self.folder.as_ref()?.join(&key[..2]).join(key).with_extension("json"))
    }

    /// A kept result. One that cannot be read, or is not whole, is as one that is not there.
    pub(super) fn get<T: DeserializeOwned>(&self, key: &str) -> Option<T> {
        let text = std::fs::read_to_string(self.path(key)?).ok()?;
        let (digest, body) = text.split_once('\n')?;
        let body = body.strip_suffix('\n')?;
        (digest == hex(&Sha256::digest(body))).then(|| serde_json::from_str(body).ok())?
    }

    /// Keeps a result. Errors: if the system refuses.
    pub(super) fn put(&self, key: &str, value: &impl Serialize) -> Result<(), Error> {
        let Some(path) = self.path(key) else { return Ok(()) };
        let body = serde_json::to_string(value).expect("JSON of plain values");
        let text = format!("{}\n{body}\n", hex(&Sha256::digest(&body)));
        package::write_file(&path, text.as_bytes())
    }
}
