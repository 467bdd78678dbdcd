//! `brdfgen eval`.

use clap::Args;
use serde_json::json;

use super::source::Source;
use super::{Verdict, say, say_json};
use crate::core::{Design, Evaluation};
use crate::platform::error::{Error, refuse};
use crate::spec::BlockKind;

#[derive(Args)]
pub(super) struct Arguments {
    /// The shininess: one of the core's
    #[arg(long, short)]
    n: f64,

    /// The cosine, from -2 up to 2; the core is given its nearest code
    #[arg(long, short, allow_hyphen_values = true)]
    x: f64,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    source: Source,
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    let spec = arguments.source.spec()?;
    let kind = spec.block.kind();
    refuse!(
        kind != BlockKind::Lobe,
        format!("eval evaluates a lobe, and this core is {}", kind.noun()),
        "give a core without a `block`"
    );
    let row = spec.row_of(arguments.n)?;
    let design = Design::new(spec)?;
    let Evaluation { index, operand, output, cosine, value, method, exact } = design.lobe().at(row, arguments.x)?;
    let ulp = design.lobe().output_format().lsb();
    if arguments.json {
        say_json(&json!({
            "n": arguments.n,
            "x": cosine,
            "in_n": index,
            design.lobe().operand_name(): operand,
            "exact": exact,
            "method": method,
            "model": value,
            "out_spec": output,
            "model_minus_method_ulps": (value - method) / ulp,
            "model_minus_exact": value - exact,
        }));
        return Ok(Verdict::Done);
    }
    say(format!("n = {}, x = {cosine} (in_n = {index}, {} = {operand})", arguments.n, design.lobe().operand_name()));
    say(format!("exact   {exact:.9}"));
    say(format!("method  {method:.9}  {:+.3e} from exact", method - exact));
    say(format!(
        "model   {value:.9}  {:+.3e} from exact, {:+.3} ulp from the method (out_spec = {output})",
        value - exact,
        (value - method) / ulp
    ));
    Ok(Verdict::Done)
}
