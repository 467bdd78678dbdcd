//! Writes the reference page of a spec's keys: `cargo run --example spec` writes docs/spec.md.

fn main() -> std::io::Result<()> {
    std::fs::write("docs/spec.md", brdfgen::spec::reference())
}
