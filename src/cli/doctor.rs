//! `brdfgen doctor`.

use clap::Args;
use serde_json::json;

use super::{Verdict, say, say_json};
use crate::platform::error::Error;
use crate::platform::tool::TOOLS;
use crate::target::Family;

#[derive(Args)]
pub(super) struct Arguments {
    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let placers = Family::ALL.iter().filter_map(|family| family.description().placement.as_ref());
    let tools = TOOLS.iter().chain(placers.flat_map(|placement| placement.tools));
    let found: Vec<_> = tools.map(|tool| (tool, tool.version())).collect();
    if arguments.json {
        let list: Vec<_> = found
            .iter()
            .map(|(tool, version)| {
                json!({
                    "program": tool.program,
                    "version": version,
                    "debian_package": tool.package,
                    "pypi_package": tool.pypi,
                    "purpose": tool.purpose,
                })
            })
            .collect();
        say_json(&json!({ "tools": list, "builtin_kernel": cfg!(feature = "kernel") }));
        return Ok(Verdict::Done);
    }
    for (tool, version) in &found {
        match version {
            Some(version) => say(format!("found    {:<10} {version}", tool.program)),
            None => {
                let how = match (tool.package, tool.pypi) {
                    ("", "") => "no package: see its releases".to_owned(),
                    ("", package) => format!("pip install {package}"),
                    (package, _) => format!("apt-get install {package}"),
                };
                say(format!("missing  {:<10} {how} (for {})", tool.program, tool.purpose));
            }
        }
    }
    let kernel = if cfg!(feature = "kernel") { "with" } else { "without" };
    say(format!("built in {kernel} the rust-hdl kernels; generate and cosim --sim builtin need nothing else"));
    Ok(Verdict::Done)
}
