//! Texels of an image-based block in memories outside of the core, and in two sets that are written in turn.
//!
//! Needs iverilog, verilator, ghdl and yosys; `test.sh` installs them.

use brdfgen::core::{Design, Role};
use brdfgen::emit::package::Part;
use brdfgen::spec::Language;
use brdfgen::verify::cosim::{self, Sim};
use brdfgen::verify::formal::{self, ProofStatus};
use serde_json::Value;

use crate::common::Scratch;
use crate::common::core::{Generated, OnDisk, design, ecp5_cells};

const EXTERNAL: &str = "block = 'image'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\ntexels = 'external'\n\
                        axi_stream = true\nreflectance = { model = 'ggx' }\n";

/// What all simulators of a language say of a part of a core.
fn passes(core: &OnDisk, part: Part, sim: Sim) -> bool {
    match part {
        Part::Core => core.run(sim).passed(),
        _ => {
            let outcomes = cosim::around(sim, &core.job()).expect("it runs");
            assert!(!outcomes.is_empty(), "nothing around the core");
            outcomes.iter().all(cosim::Outcome::passed)
        }
    }
}

/// The core is that with the texels in it but for the time that they take: the same operations, vectors and results.
#[test]
fn texels_outside_make_the_same_core() {
    let inside = design(&EXTERNAL.replace("external", "rom"));
    for clocks in [1, 2, 32] {
        let outside = design(&format!("{EXTERNAL}texel_latency = {clocks}\n"));
        assert_eq!(outside.datapath_digest(), inside.datapath_digest());
        assert_eq!(outside.tables(), inside.tables());
        let own = |design: &Design| design.schedule.latency;
        // A register at the address, those of the memory and one at the word, where a block RAM has three behind it.
        assert_eq!(own(&outside), own(&design(EXTERNAL)) + clocks - 2);
        let ports = outside.ports();
        let of = |role: Role| ports.iter().filter(|port| port.role == role).count();
        assert_eq!((of(Role::Address), of(Role::Word), of(Role::Write)), (4, 4, 0));
    }
    assert_eq!(inside.read_ports(), Vec::new());
    let core = Generated::new(EXTERNAL).on_disk();
    assert_eq!(ecp5_cells(&core.rtl(Language::Verilog), "image_bivariate")("DP16KD"), 0);
}

/// A memory whose words come a clock early or late, or with a wrong word, fails every bench, and so does one that goes
/// on while the core is frozen.
#[test]
fn another_memory_fails_every_bench() {
    let generated = Generated::new(EXTERNAL);
    let whole = generated.on_disk();
    let parts = [Part::Core, Part::Lights];
    for (sim, language) in [(Sim::Icarus, Language::Verilog), (Sim::Ghdl, Language::Vhdl)] {
        let memory = format!("tb/image_bivariate_memory.{}", if language == Language::Verilog { "v" } else { "vhd" });
        assert!(parts.iter().all(|&part| passes(&whole, part, sim)));
        let late = format!("{EXTERNAL}texel_latency = 3\n");
        let faults: [(&str, &str, &str); 2] = match language {
            Language::Verilog => [
                ("if (ce)", "if (1'b1)", "it goes on while the core is frozen"),
                ("way_2[23:0],", "way_2[22:0], 1'b0,", "a bit is lost"),
            ],
            Language::Vhdl => [
                ("if ce = '1' then", "if true then", "it goes on while the core is frozen"),
                ("WORDS_2(to_integer(", "WORDS_1(to_integer(", "the words of another part"),
            ],
        };
        let text = generated.text(&memory);
        let broken = faults.map(|(from, to, what)| {
            assert!(text.contains(from), "{from}");
            (text.replace(from, to), what)
        });
        let others = [(Generated::new(&late).text(&memory), "words come a clock late")];
        for (text, what) in broken.into_iter().chain(others) {
            let core = generated.on_disk();
            std::fs::write(core.path().join(&memory), text).expect("written");
            assert!(parts.iter().all(|&part| !passes(&core, part, sim)), "{what}, in {language}");
        }
    }
}

/// Pictures through the compiled core and the memory beside it are the model's; both languages are proved the same.
#[test]
fn the_core_is_drawn_and_proved_with_its_memory() {
    let scratch = Scratch::new();
    scratch.write(
        "core.toml",
        EXTERNAL.replace("axi_stream = true", "name = 'own'").replace("'ggx'", "'ggx', exposure = 1.5"),
    );
    scratch.write(
        "scene.toml",
        "width = 24\nheight = 24\n[camera]\nposition = [0.5, 0.8, 4.0]\n[[material]]\nname = 'own'\n\
         reflectance = { model = 'ggx', exposure = 1.5 }\n\
         [[light]]\ndirection = [1.0, 1.0, 0.4]\n[[object]]\nkind = 'sphere'\nmaterial = 'own'\n",
    );
    scratch.run("generate core.toml --out own").succeeds();
    let [compiled, model] = ["verilator", "model"].map(|through| scratch.rendered("scene.toml --core own", through).0);
    assert_eq!(compiled, model);
    let run = scratch.run("formal own").succeeds().says(&["PROVED Verilog = VHDL"]);
    assert!(!run.stdout.contains("REFUTED") && !run.stdout.contains("OPEN"), "{}", run.stdout);
    let manifest: Value = serde_json::from_str(&scratch.text("own/manifest.json")).unwrap();
    assert_eq!(manifest["external"]["clocks"], 2);
    assert_eq!(manifest["external"]["memories"].as_array().map(Vec::len), Some(4));
    let sheet = scratch.text("own/README.md");
    assert!(sheet.contains("The texels lie in memories outside of the core") && sheet.contains("`tb/own_memory.v`"));
}

const SWAP: &str = "block = 'image'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\ntexels = 'writable'\n\
                    swap = true\nreflectance = { model = 'ggx' }\n";

/// Two sets of texels: the memories are twice as large, and nothing else is another core.
#[test]
fn two_sets_of_texels_make_the_same_core() {
    let [two, one] = [SWAP.to_owned(), SWAP.replace("swap = true", "")].map(|spec| design(&spec));
    assert_eq!(two.datapath_digest(), one.datapath_digest());
    assert_eq!((two.texel_sets(), one.texel_sets()), (2, 1));
    let address = |design: &Design| design.write_ports()[0].address.format.expect("bits").width();
    assert_eq!(address(&two), address(&one) + 1);
    let names = |design: &Design| design.whole_ports().into_iter().map(|port| port.name).collect::<Vec<_>>();
    assert!(["swap", "texel_set"].iter().all(|name| names(&two).iter().any(|port| port == name)));
    assert!(!names(&two).iter().any(|port| port == "in_set") && names(&two).len() == names(&one).len() + 2);
}

/// A set that is chosen too early or always the same, a write that goes to one set only, a swap that does not wait for
/// the end of its sample or does not last: the benches see it, and of the sequencer the proof.
#[test]
fn broken_sets_of_texels_are_found() {
    let generated = Generated::new(SWAP);
    let design = &generated.design;
    let whole = generated.on_disk();
    for (part, language, from, to) in [
        (Part::Core, Language::Verilog, "{sets[", "{sets[1] & sets["),
        (Part::Core, Language::Verilog, "wr_texels_1_even_odd_en) texels_1_even_odd[", "1'b0) texels_1_even_odd["),
        (Part::Core, Language::Vhdl, "& in_set;", "& (not in_set);"),
        (Part::Lights, Language::Verilog, "in_valid & in_last & swap", "in_valid & swap"),
        (Part::Lights, Language::Verilog, "in_set <= ~in_set", "in_set <= 1'b0"),
        (Part::Lights, Language::Vhdl, "in_last = '1' and swap = '1'", "swap = '1'"),
        (Part::Lights, Language::Vhdl, "in_set <= not in_set", "in_set <= '0'"),
    ] {
        let sim = if language == Language::Verilog { Sim::Icarus } else { Sim::Ghdl };
        assert!(passes(&whole, part, sim), "{part:?}");
        let core = generated.on_disk();
        let path = core.path().join(part.rtl_path(design, language));
        let text = std::fs::read_to_string(&path).expect("the text");
        assert!(text.contains(from), "{from}");
        std::fs::write(&path, text.replacen(from, to, 1)).expect("written");
        assert!(!passes(&core, part, sim), "{part:?} with {to}");
        if part == Part::Lights {
            let proofs = formal::around(design, &[Part::Lights], core.path(), &|_| {}).expect("it runs");
            let of = |proof: &&formal::Proof| proof.claim.contains(&format!("in {language} "));
            assert!(proofs.iter().any(|proof| of(&proof) && proof.verdict == ProofStatus::Refuted), "{to}: {proofs:?}");
        }
    }
}

#[test]
fn the_keys_of_texel_memories_are_checked() {
    for (keys, words) in [
        ("texels = 'external'\ntexel_latency = 0", "texel_latency = 0"),
        ("texels = 'external'\ntexel_latency = 33", "1 to 32"),
        ("texel_latency = 2", "texels in the core"),
        ("texels = 'writable'\ntexel_latency = 2", "texels = \"external\""),
        ("swap = true", "not written"),
        ("image_form = 'matcap'\ntexels = 'writable'\nswap = true", "no last light"),
        ("texels = 'external'\nswap = true", "texels = \"writable\""),
    ] {
        let scratch = Scratch::new();
        scratch.write("core.toml", format!("block = 'image'\n{keys}\nreflectance = {{ model = 'ggx' }}\n"));
        scratch.run("generate core.toml --out core").refuses(&[words]);
        assert!(!scratch.path("core").exists());
    }
}
