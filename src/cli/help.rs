//! The help in order: a command's own flags first and under its name, a core's flags in the long help, examples below.

use std::collections::BTreeSet;

use clap::builder::Resettable;
use clap::{Arg, Args, Command};

use crate::spec::SpecFields;

/// Examples, one a line, in the order in which they are shown.
const EXAMPLES: &str = include_str!("examples.txt");
/// How many of them a command shows.
const SHOWN: usize = 3;
/// The heading of the flags of `explore` that `synth` has too, which are for its long help.
pub(super) const COSTS: &str = "Costs";
/// The commands that show a core's flags in their short help too.
const OF_CORES: [&str; 2] = ["generate", "choose"];

/// The built command line with its help put in order.
pub(super) fn arranged(mut program: Command) -> Command {
    program.build();
    let of_core = SpecFields::augment_args(Command::new(""));
    let of_core = of_core.get_arguments().filter_map(Arg::get_help_heading).collect();
    program.mut_subcommands(|command| arrange(command, &["brdfgen"], &of_core))
}

/// Arranges a command and those below it; `of_core` are the headings of a core's flags.
fn arrange(command: Command, above: &[&str], of_core: &BTreeSet<&str>) -> Command {
    let name = command.get_name().to_owned();
    let path: Vec<&str> = above.iter().copied().chain([name.as_str()]).collect();
    let under = |arg: &Arg, is: &dyn Fn(&str) -> bool| arg.get_help_heading().is_some_and(is);
    let is_of_core = |arg: &Arg| !OF_CORES.contains(&&*name) && under(arg, &|heading| of_core.contains(heading));
    let hides_core = command.get_arguments().any(is_of_core);
    // Clap keeps names for as long as the program runs.
    let own: &'static str = format!("Options of {name}").leak();
    let general = |arg: &Arg| arg.is_global_set() || ["help", "version"].contains(&arg.get_id().as_str());
    let command = command.mut_args(|arg| match arg {
        arg if arg.is_positional() => arg.help_heading(Resettable::Reset),
        arg if hides_core && arg.get_id() == "help" => {
            arg.help_heading("General").help("Print help; a core's flags are in --help")
        }
        arg if general(&arg) => arg.help_heading("General"),
        arg if is_of_core(&arg) || under(&arg, &|heading| heading == COSTS) => arg.hide_short_help(true),
        arg if arg.get_help_heading().is_none() => arg.help_heading(own),
        arg => arg,
    });
    let command = command.mut_subcommands(|command| arrange(command, &path, of_core));
    match examples(&path).as_slice() {
        [] => command,
        lines => command.after_help(format!("Examples:\n  {}", lines.join("\n  "))),
    }
}

/// The examples of a command or of those below it.
fn examples(path: &[&str]) -> Vec<&'static str> {
    let of_command = |line: &&str| line.split(' ').zip(path).all(|(word, own)| word == *own);
    EXAMPLES.lines().filter(of_command).take(SHOWN).collect()
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;
    use crate::cli::Cli;

    /// The most lines of a short help, but that of `generate`.
    const LINES: usize = 45;

    fn check(command: &mut Command, above: &str) {
        let path = format!("{above} {}", command.get_name());
        let short = command.render_help().to_string();
        let lines = short.lines().count();
        assert!(lines <= LINES || path == "brdfgen generate", "{path} -h has {lines} lines");
        let examples =
            short.lines().filter(|line| EXAMPLES.lines().any(|example| example == line.trim_start())).count();
        assert_eq!(examples, SHOWN, "{short}");
        let own = format!("Options of {}", command.get_name());
        let flags: Vec<_> = command.get_arguments().filter(|arg| !arg.is_positional()).collect();
        if let Some(json) = flags.iter().find(|arg| arg.get_id() == "json") {
            assert_eq!([json, &flags[0]].map(|arg| arg.get_help_heading()), [Some(own.as_str()); 2], "{path}");
        }
        of_program(command).for_each(|command| check(command, &path));
    }

    fn of_program(command: &mut Command) -> impl Iterator<Item = &mut Command> {
        command.get_subcommands_mut().filter(|command| command.get_name() != "help")
    }

    #[test]
    fn own_flags_come_first_and_three_examples_parse() {
        let mut program = arranged(Cli::command().term_width(100));
        of_program(&mut program).for_each(|command| check(command, "brdfgen"));
        for line in EXAMPLES.lines() {
            let parsed = program.clone().try_get_matches_from(line.split(' '));
            parsed.unwrap_or_else(|error| panic!("{line}: {error}"));
        }
    }
}
