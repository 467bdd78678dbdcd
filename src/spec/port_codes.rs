//! Lists of codes for ports: inputs that a core's golden vectors always hold, and records of lights.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::fixed::Format;
use crate::platform::error::Error;

/// The most lists that a spec may give.
const MOST: usize = 4096;

/// Lists of codes: each the codes of some ports, in the ports' order, as numbers (negative for negative cosines).
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct PortCodes(pub Vec<Vec<i64>>);

impl PortCodes {
    /// Refuses what is not a code for each of these ports; `key` is the spec's.
    ///
    /// # Errors
    /// Names the input that is wrong, and what is allowed.
    pub fn check(&self, key: &str, ports: &[(&str, Format)]) -> Result<(), Error> {
        if self.0.len() > MOST {
            return Err(Error::input(format!("{} {key} are given", self.0.len()), format!("at most {MOST} may be")));
        }
        for (place, codes) in self.0.iter().enumerate() {
            let number = place + 1;
            if codes.len() != ports.len() {
                let names: Vec<&str> = ports.iter().map(|(name, _)| *name).collect();
                return Err(Error::input(
                    format!("number {number} of {key} has {} codes", codes.len()),
                    format!("give one for each of the {} ports {}", ports.len(), names.join(", ")),
                ));
            }
            for ((name, format), &code) in ports.iter().zip(codes) {
                let (least, most) = (format.min_code(), format.max_code());
                if !(least..=most).contains(&i128::from(code)) {
                    return Err(Error::input(
                        format!("number {number} of {key} has the code {code} for {name}"),
                        format!("the codes of {name} are {least} to {most}"),
                    ));
                }
            }
        }
        Ok(())
    }
}

impl FromStr for PortCodes {
    type Err = String;

    /// Reads `CODE,CODE;CODE,CODE`: a comma between the codes of a list, a semicolon between lists.
    fn from_str(text: &str) -> Result<Self, String> {
        let code = |code: &str| {
            let code = code.trim();
            code.parse().map_err(|_| format!("`{code}` is no code; they are written CODE,CODE;CODE,CODE"))
        };
        let list = |list: &str| list.split(',').map(code).collect();
        text.split(';').map(list).collect::<Result<_, _>>().map(Self)
    }
}
