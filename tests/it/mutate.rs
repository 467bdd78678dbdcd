//! Mutants: the run finds what the golden vectors miss, and claims of none what is not so.
//!
//! Needs iverilog, ghdl, verilator and yosys; `test.sh` installs them.

use brdfgen::core::{Account, Design};
use brdfgen::datapath::fault::{Change, Defect, Fault};
use brdfgen::datapath::graph::Op;
use brdfgen::datapath::simulate::{Inputs, Simulation};
use brdfgen::emit::package;
use brdfgen::spec::{Language, SpecFields};
use brdfgen::verify::cosim::{self, Job, Sim, Vectors};
use brdfgen::verify::faults::simulation::{Block, FaultSimulation};
use brdfgen::verify::faults::{Mutant, Outcome, Tally, decide, mutants, outcomes};
use brdfgen::verify::formal::netlist;
use brdfgen::verify::golden::Golden;

use crate::common::Scratch;
use crate::common::core::design;

const SMALL: &str = "method = \"quadratic\"\nshininess = \"1..=15\"\ninput_fraction = 8\noutput_fraction = 8\n";

fn outcomes_of(design: &Design, golden: &Golden, mutants: &[Mutant]) -> Vec<Outcome> {
    let vectors = Vectors::of(design, golden);
    outcomes(design, mutants, &golden.vectors(), &|defect| vectors.detect(defect))
}

/// Without most vectors: the corners of the ports' codes only.
fn thinned(golden: &Golden) -> Golden {
    Golden { groups: golden.groups[..1].to_vec(), ..golden.clone() }
}

#[test]
fn all_vectors_kill_what_few_do_not() {
    let design = design(SMALL);
    let golden = Golden::of(&design);
    let mutants = mutants(&design, 0);
    assert!(mutants.len() >= 200, "{}", mutants.len());
    let outcomes = outcomes_of(&design, &golden, &mutants);
    let tally = Tally::of(&outcomes);
    assert_eq!((tally.mutants, tally.survivors, tally.undecided), (mutants.len(), 0, 0), "{outcomes:?}");
    assert!(tally.detected > 9 * tally.equivalent / 2, "{tally:?}");

    let few = outcomes_of(&design, &thinned(&golden), &mutants);
    let survivors = Tally::of(&few).survivors;
    assert!(survivors > 20, "{survivors}");
    for (all, few) in outcomes.iter().zip(&few) {
        // What the one run proves equivalent the other does not let survive.
        assert!(!matches!(
            (all, few),
            (Outcome::Equivalent { .. }, Outcome::Survived { .. } | Outcome::Detected { .. })
        ));
    }
}

/// A core of one stage has no register in which a reset could show but the one of its `out_valid`.
#[test]
fn a_reset_shows_in_a_core_of_one_stage() {
    for method in ["quadratic", "cubic", "segmented-4", "schlick", "log-exp", "harris", "table"] {
        let spec = format!(
            "method = '{method}'\nshininess = '1..=4'\ninput_fraction = 6\noutput_fraction = 4\npipeline = 1\n"
        );
        let design = design(&spec);
        let golden = Golden::of(&design);
        let mutants: Vec<_> =
            mutants(&design, 0).into_iter().filter(|mutant| matches!(mutant.defect, Defect::Timing(_))).collect();
        let resets = mutants.iter().filter(|mutant| mutant.what.starts_with("rst ")).count();
        assert_eq!(resets, 2, "{method}");
        let outcomes = outcomes_of(&design, &golden, &mutants);
        for (mutant, outcome) in mutants.iter().zip(&outcomes) {
            let is_killed = matches!(outcome, Outcome::Detected { .. });
            assert!(
                is_killed || matches!(outcome, Outcome::Equivalent { .. }),
                "{method}: {}: {outcome:?}",
                mutant.what
            );
            assert!(is_killed || !mutant.what.starts_with("rst "), "{method}: {}: {outcome:?}", mutant.what);
        }
    }
}

/// Every word of a table is told by a vector, those that only codes outside the set read too, or is read by no input.
#[test]
fn no_word_of_a_table_survives() {
    for (spec, words) in [
        ("shininess = [3, 40, 9]\ntable_bits = 5\ninput_fraction = 8\noutput_fraction = 10", 60),
        ("shininess = '1..=300'\ntable_bits = 7\ninput_fraction = 12\noutput_fraction = 8", 80),
        ("shininess = '600..=700'\ntable_bits = 4\ninput_fraction = 14\noutput_fraction = 12", 80),
    ] {
        let design = design(&format!("method = 'table'\n{spec}\n"));
        let golden = Golden::of(&design);
        let of_words =
            |seed| mutants(&design, seed).into_iter().filter(|mutant| mutant.what.contains(" of the word at "));
        let mutants: Vec<_> = (0..8).flat_map(of_words).collect();
        let outcomes = outcomes_of(&design, &golden, &mutants);
        let tally = Tally::of(&outcomes);
        assert_eq!((tally.survivors, tally.undecided), (0, 0), "{spec}: {tally:?}");
        assert!(tally.detected > words, "{spec}: {tally:?}");
    }
}

#[test]
fn the_command_ends_with_1_when_a_mutant_survives() {
    let scratch = Scratch::new();
    let design = design(SMALL);
    let golden = Golden::of(&design);
    let files = package::files(&design, &Account::of(&design), &golden).expect("files");
    package::write_directory(&scratch.path("core"), &files).expect("written");
    scratch.write("few.vec", thinned(&golden).to_text(&design));
    scratch.run("mutate core").succeeds().says(&[" 0 survivors", " 0 not decided"]);
    let few = "mutate core --golden few.vec";
    let said = scratch.run(few).ends_with(1).says(&["SURVIVES; shown by in_n "]);
    assert!(!said.stdout.contains(" 0 survivors"), "{}", said.stdout);
    let json = format!("{few} --json --seed 7");
    assert_eq!(scratch.run(&json).stdout, scratch.run(&json).ends_with(1).stdout, "the same seed, the same answer");
}

/// What a spec asks for is in its golden vectors, behind the others, which stay as they are; a golden file without it
/// is not the core's.
#[test]
fn golden_inputs_of_a_spec_are_in_its_vectors() {
    let scratch = Scratch::new();
    let plain = Golden::of(&design(SMALL));
    let with = format!("{SMALL}golden_inputs = [[3, 250], [15, -7]]\n");
    let design = design(&with);
    let golden = Golden::of(&design);
    let (group, others) = golden.groups.split_last().expect("groups");
    assert_eq!(others, plain.groups);
    assert!(group.0.starts_with("inputs of the spec"), "{}", group.0);
    let vectors: Vec<_> = group.1.iter().map(|vector| (vector.inputs.clone(), vector.idle, vector.stall)).collect();
    let (one, other) = (vec![3, 250], vec![15, -7]);
    assert_eq!(vectors, [(one.clone(), 0, 0), (other.clone(), 0, 0), (one, 0, 1), (other, 0, 1)]);
    assert_eq!(group.1[0].outputs, design.evaluate(&[3, 250]));
    assert_ne!(golden.spec_digest, plain.spec_digest);

    scratch.write("core.toml", &with);
    scratch.run("generate core.toml --out core").succeeds();
    scratch.run("generate core --check --out core").succeeds().says(&[" files are as they should be"]);
    scratch.run("golden core --check core/golden/quadratic.vec").succeeds();
    scratch.refused("golden core --golden-inputs 3,251;15,-7 --check core/golden/quadratic.vec", &["spec"]);
    scratch.write("plain.toml", SMALL);
    scratch.run("generate plain.toml --golden-inputs 3,250;15,-7 --out flags").succeeds();
    assert_eq!(scratch.read("flags/golden/quadratic.vec"), scratch.read("core/golden/quadratic.vec"));
}

#[test]
fn golden_inputs_that_the_ports_do_not_take_are_refused() {
    let scratch = Scratch::new();
    scratch.write("plain.toml", SMALL);
    for (inputs, words) in [
        ("3,250;4", ["number 2 of golden_inputs has 1 codes", "each of the 2 ports in_n, in_cos"]),
        ("3,250,1", ["number 1 of golden_inputs has 3 codes", "in_n, in_cos"]),
        ("16,250", ["number 1 of golden_inputs has the code 16 for in_n", "the codes of in_n are 0 to 15"]),
        ("3,512", ["has the code 512 for in_cos", "the codes of in_cos are -512 to 511"]),
        ("3,-513", ["has the code -513 for in_cos", "-512 to 511"]),
        ("3;x", ["`x` is no code", "CODE,CODE;CODE,CODE"]),
    ] {
        scratch.refused(&format!("generate plain.toml --golden-inputs {inputs} --out core"), &words);
    }
    let shader = "block = 'shader'\nmethod = 'quadratic'\nmaterial = [{ name = 'a', shininess = 9 }]\n";
    let spec = SpecFields::parse(&format!("golden_inputs = [[0, 1]]\n{shader}"), "test").and_then(SpecFields::resolve);
    let said = spec.and_then(Design::new).expect_err("two codes").to_string();
    assert!(said.contains("number 1 of golden_inputs has 2 codes"), "{said}");
}

#[test]
fn a_seed_says_which_words_are_wrong() {
    let design = design(SMALL);
    let what = |seed: u32| -> Vec<String> { mutants(&design, seed).into_iter().map(|m| m.what).collect() };
    assert_eq!(what(3), what(3));
    assert_ne!(what(3), what(4));
}

#[test]
fn equivalent_mutants_are_told_from_others() {
    let design = design(SMALL);
    let graph = design.graph();
    let sum = graph.nodes.iter().position(|node| matches!(node.op, Op::Add | Op::Sub)).expect("a sum");
    let args = &graph.nodes[sum].args;
    let instead = |op, args| Defect::Value(Fault { node: sum, change: Change::Instead { op, args } });
    let same = instead(graph.nodes[sum].op, args.clone());
    let swapped = instead(Op::Sub, vec![args[1], args[0]]);
    let off = Defect::Value(Fault { node: graph.output(), change: Change::Offset(1) });
    let decided = decide(&design, &[&same, &swapped, &off]);
    assert!(matches!(decided[0], Outcome::Equivalent { .. }), "{decided:?}");
    assert!(matches!(decided[1], Outcome::Survived { .. }), "{decided:?}");
    assert!(matches!(decided[2], Outcome::Survived { .. }), "{decided:?}");
}

/// The fault simulation and the pipeline have every kind of fault of their own.
#[test]
fn the_fault_simulation_shows_what_the_pipeline_does() {
    for spec in [
        SMALL,
        "method = \"schlick\"\nshininess = \"1..=15\"\ninput_fraction = 8\noutput_fraction = 8\n",
        "method = \"cubic\"\nform = \"paper\"\nshininess = \"1..=40\"\ninput_fraction = 12\noutput_fraction = 12\n",
        "method = \"log-exp\"\nshininess = \"1..=15\"\ninput_fraction = 8\noutput_fraction = 8\n",
    ] {
        let design = design(spec);
        let mut block = Block::new(2);
        let golden = Golden::of(&design);
        let vectors = golden.vectors();
        for vector in vectors.iter().step_by(vectors.len() / 60).take(Block::LANES) {
            block.push(&vector.inputs);
        }
        let faults: Vec<Fault> = mutants(&design, 1).iter().filter_map(|m| m.defect.fault().cloned()).collect();
        let mut shown = vec![0; faults.len()];
        let mut next = Some(&block);
        FaultSimulation::new(design.graph(), design.tables()).run(
            &faults.iter().collect::<Vec<_>>(),
            &mut |to| next.take().map(|block| *to = block.clone()).is_some(),
            &mut |place, lanes, _| {
                shown[place] = lanes;
                true
            },
        );

        let outputs = |defect: Option<&Defect>| -> Vec<Vec<i128>> {
            let core = Simulation::new(design.graph(), &design.schedule, design.tables());
            let mut core = if let Some(defect) = defect { core.with(defect) } else { core };
            let latency = design.schedule.latency as usize;
            let clocks = (0..block.count + latency).map(|clock| {
                let codes = block.inputs(clock.min(block.count - 1)).into_iter().map(i128::from).collect();
                core.clock(&Inputs { rst: false, ce: true, in_valid: true, codes }).codes
            });
            clocks.skip(latency - 1).take(block.count).collect()
        };
        let right = outputs(None);
        let mut differing = 0;
        for (fault, lanes) in faults.into_iter().zip(shown) {
            let defect = Defect::Value(fault);
            let wrong = outputs(Some(&defect));
            for (lane, (wrong, right)) in wrong.iter().zip(&right).enumerate() {
                assert_eq!(lanes >> lane & 1 == 1, wrong != right, "{defect:?} at {:?}", block.inputs(lane));
                differing += usize::from(wrong != right);
            }
        }
        assert!(differing > 1000, "{differing}");
    }
}

/// The same mistake in the HDL: the generated benches fail.
#[test]
fn mutants_in_the_hdl_fail_in_the_simulators() {
    let design = design(SMALL);
    let golden = Golden::of(&design);
    let account = Account::of(&design);
    let mutants = mutants(&design, 0);
    let outcomes = outcomes_of(&design, &golden, &mutants);
    let mut written = 0;
    for (mutant, outcome) in mutants.iter().zip(&outcomes) {
        let Defect::Value(Fault { node, change: Change::Instead { op, args } }) = &mutant.defect else { continue };
        // A bench's verdict is over all vectors, as that of the simulation in process is.
        let mut wrong = design.clone();
        wrong.datapath.graph.nodes[*node].op = *op;
        wrong.datapath.graph.nodes[*node].args = args.clone();
        // Arguments from earlier stages have to be kept for longer: only those that are there already.
        if args.iter().any(|&arg| design.schedule.last_use[arg] < design.schedule.stage[*node]) {
            continue;
        }
        // VHDL has no product with a flag.
        if *op == Op::Mul && args.iter().any(|&arg| design.graph().nodes[arg].format.width() == 1) {
            continue;
        }
        written += 1;
        if written % 2 != 0 {
            continue;
        }
        let scratch = tempfile::tempdir().expect("a directory");
        let path = scratch.path().join("core");
        package::write_directory(&path, &package::files(&wrong, &account, &golden).expect("files")).expect("written");
        let job = Job { design: &wrong, golden: &golden, directory: &path };
        for sim in [Sim::Icarus, Sim::Ghdl] {
            let ran = cosim::golden(sim, &job).expect("it runs");
            assert!(ran.vectors > 0, "{}: {ran:?}", mutant.what);
            assert_eq!(ran.passed(), !matches!(outcome, Outcome::Detected { .. }), "{}: {ran:?}", mutant.what);
        }
    }
    assert!(written > 6, "{written}");
}

#[test]
fn mutants_of_the_netlist_are_killed_by_all_vectors_and_not_by_few() {
    let design = design(SMALL);
    let golden = Golden::of(&design);
    let files = package::files(&design, &Account::of(&design), &golden).expect("files");
    let path = package::rtl_path(&design, Language::Verilog);
    let verilog = &files.iter().find(|file| file.path == path).expect("its Verilog").bytes;
    let tally = |design: &Design, golden: &Golden| {
        let mutants = netlist::outcomes(design, verilog, golden, 100, 0).expect("it runs");
        (Tally::of(mutants.iter().map(|mutant| &mutant.outcome)), mutants)
    };
    let (all, mutants) = tally(&design, &golden);
    assert_eq!((all.mutants, all.survivors, all.undecided), (100, 0, 0), "{mutants:?}");
    assert!(all.detected > 80 && all.equivalent > 0, "{all:?}");

    // With few vectors, most is left for the proofs, which must not go through.
    let (few, left) = tally(&design, &thinned(&golden));
    assert!(few.survivors > 10, "{few:?}");
    assert_eq!((few.equivalent, few.undecided), (all.equivalent, 0), "{left:?}");
    // What shows the survivors finds all of them once it is in the spec.
    let shown = |mutant: &netlist::NetlistMutant| match &mutant.outcome {
        Outcome::Survived { input } => {
            Some(input.replace("in_n ", "[").replace(", in_cos", ",").replace(", then", "],"))
        }
        _ => None,
    };
    let inputs: Vec<String> = left.iter().filter_map(shown).collect();
    let with = self::design(&format!("{SMALL}golden_inputs = [{}]]\n", inputs.join("], ")));
    let mut asked = Golden::of(&with);
    let from_spec = asked.groups.pop().expect("the inputs of the spec");
    asked.groups.truncate(1);
    asked.groups.push(from_spec);
    let (killed, mutants) = tally(&with, &asked);
    assert_eq!((killed.detected, killed.survivors), (all.detected, 0), "{mutants:?}");
}

/// What is wrong with the write port of a memory shows only once something is written.
#[test]
fn mutants_of_a_write_port_are_killed() {
    let design = design(&format!("{SMALL}rom = \"writable\"\n"));
    let golden = Golden::of(&design);
    let files = package::files(&design, &Account::of(&design), &golden).expect("files");
    let path = package::rtl_path(&design, Language::Verilog);
    let verilog = &files.iter().find(|file| file.path == path).expect("its Verilog").bytes;
    let mutants = netlist::outcomes(&design, verilog, &golden, 100, 0).expect("it runs");
    let tally = Tally::of(mutants.iter().map(|mutant| &mutant.outcome));
    assert_eq!((tally.mutants, tally.survivors, tally.undecided), (100, 0, 0), "{mutants:?}");
    let of_port =
        |mutant: &&netlist::NetlistMutant| mutant.what.contains("wire wr_") || mutant.what.contains("port WR_");
    let killed = |mutant: &netlist::NetlistMutant| matches!(mutant.outcome, Outcome::Detected { .. });
    assert!(mutants.iter().filter(of_port).count() > 3, "{mutants:?}");
    assert!(mutants.iter().filter(of_port).all(killed), "{mutants:?}");
}
