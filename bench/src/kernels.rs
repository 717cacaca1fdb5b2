//! The kernels of the benchmarks: named pieces of work, each with fixed data.

mod arithmetic;
mod cliffs;
mod files;
mod spans;

/// A piece of work that can be repeated.
pub trait Work {
    /// Returns the number of units in one turn: samples, rays, draws, pixels, lines or objects.
    fn units(&self) -> u64;
    /// Prepares the next turn. The time of this call is not measured.
    fn prepare(&mut self) {}
    /// Does the work once; this is one turn.
    fn turn(&mut self);
}

/// A named piece of work.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// The name of the kernel.
    pub name: &'static str,
    /// Creates the data, and the work on them.
    pub new: fn() -> Box<dyn Work>,
}

/// Returns all kernels.
#[must_use]
pub fn all() -> Vec<Kernel> {
    [spans::KERNELS, arithmetic::KERNELS, files::KERNELS, cliffs::KERNELS].concat()
}

/// Work that needs no preparation: the number of units of a turn, and the function that does one turn.
struct Plain<F>(u64, F);

impl<F: FnMut()> Work for Plain<F> {
    fn units(&self) -> u64 {
        self.0
    }
    fn turn(&mut self) {
        (self.1)();
    }
}

/// Returns work that needs no preparation, from the number of units of a turn and the function that does one turn.
fn plain(units: usize, turn: impl FnMut() + 'static) -> Box<dyn Work> {
    Box::new(Plain(units as u64, turn))
}
