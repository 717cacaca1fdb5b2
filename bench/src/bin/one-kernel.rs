//! `one-kernel [NAME]`: does a kernel's work once, inside a function that callgrind can be told to count; without a name,
//! prints all names. bench/instructions runs it.

use bench::kernels::{self, Work};

/// What is counted.
#[inline(never)]
fn counted_work(work: &mut dyn Work) {
    work.turn();
}

fn main() {
    let Some(name) = std::env::args().nth(1) else {
        kernels::all().iter().for_each(|kernel| println!("{}", kernel.name));
        return;
    };
    let kernel = kernels::all().into_iter().find(|kernel| kernel.name == name).expect("NAME is a kernel's name");
    let mut work = (kernel.new)();
    // The first turn finds out what the machine has, and makes room.
    work.prepare();
    work.turn();
    work.prepare();
    counted_work(std::hint::black_box(&mut *work));
}
