//! The coverage-guided fuzzer of the readers, libFuzzer; `BRDFGEN_FUZZ` names what is fuzzed. See docs/fuzzing.md.
#![no_main]

mod targets;

use std::sync::OnceLock;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    static CHOSEN: OnceLock<fn(&[u8])> = OnceLock::new();
    let chosen = CHOSEN.get_or_init(|| {
        let name = std::env::var("BRDFGEN_FUZZ").unwrap_or_default();
        let names = targets::TARGETS.map(|(name, _)| name).join(", ");
        let target = targets::TARGETS.into_iter().find(|(target, _)| *target == name);
        target.unwrap_or_else(|| panic!("BRDFGEN_FUZZ is one of {names}")).1
    });
    chosen(bytes);
});
