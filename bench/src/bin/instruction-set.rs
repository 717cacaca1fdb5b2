//! `instruction-set`: prints the instruction set that the renderer uses on this machine. Scripts that measure run it,
//! so that a wrong name in `RENDER_INSTRUCTION_SET` is an error.

const USAGE: &str = "\
instruction-set
Prints the instruction set that RENDER_INSTRUCTION_SET names, or else the fastest one of this machine. The status is 2
if this machine has no set with that name.

Example:
  RENDER_INSTRUCTION_SET=avx2 cargo run --release -p bench --bin instruction-set";

fn main() {
    if std::env::args().any(|argument| argument == "--help") {
        println!("{USAGE}");
        return;
    }
    println!("{}", bench::instruction_set().name());
}
