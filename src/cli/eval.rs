//! `brdfgen eval`.

use clap::Args;
use serde_json::json;

use super::source::Source;
use super::{Verdict, say, say_json};
use crate::platform::error::{Error, refuse};
use crate::spec::Operand;

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
    if spec.block.shader().is_some() {
        return Err(Error::input("eval evaluates a lobe, and this core is a shader", "leave --block shader out"));
    }
    let row = spec.interface.shininess.values().iter().position(|&n| n == arguments.n).ok_or_else(|| {
        Error::input(
            format!("the core has no shininess {}", arguments.n),
            format!(
                "it has {}",
                if spec.interface.shininess.rows() > 20 {
                    format!("{} of them", spec.interface.shininess.rows())
                } else {
                    spec.interface.shininess.to_string()
                }
            ),
        )
    })?;
    let index = spec.interface.shininess.index_of_row(row);
    let design = crate::core::Design::new(spec)?;
    let format = design.operand_format();
    let wanted = match design.spec.interface.operand {
        Operand::Cos => arguments.x,
        Operand::Versine => 1.0 - arguments.x,
    };
    let code = (wanted / format.lsb()).round();
    refuse!(
        !(format.min_code() as f64..=format.max_code() as f64).contains(&code),
        format!("{} = {wanted} does not fit {format}", design.operand_name()),
        format!("it holds {} to {}", format.value(format.min_code()), format.value(format.max_code()))
    );
    let operand = code as i64;
    let output = design.model().evaluate(index, operand);
    let u = design.versine(operand);
    let (exact, method) = (design.exact(row, operand), design.lobes()[row].at(u));
    let hardware = design.output_format().value(output.into());
    let ulp = design.output_format().lsb();
    if arguments.json {
        say_json(&json!({
            "n": arguments.n,
            "x": 1.0 - u,
            "in_n": index,
            design.operand_name(): operand,
            "exact": exact,
            "method": method,
            "model": hardware,
            "out_spec": output,
            "model_minus_method_ulps": (hardware - method) / ulp,
            "model_minus_exact": hardware - exact,
        }));
        return Ok(Verdict::Done);
    }
    say(format!("n = {}, x = {} (in_n = {index}, {} = {operand})", arguments.n, 1.0 - u, design.operand_name()));
    say(format!("exact   {exact:.9}"));
    say(format!("method  {method:.9}  {:+.3e} from exact", method - exact));
    say(format!(
        "model   {hardware:.9}  {:+.3e} from exact, {:+.3} ulp from the method (out_spec = {output})",
        hardware - exact,
        (hardware - method) / ulp
    ));
    Ok(Verdict::Done)
}
