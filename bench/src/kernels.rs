//! Pieces of work by name, each on data that never change.

mod arithmetic;
mod files;
mod spans;

/// A piece of work that can be done again and again.
pub trait Work {
    /// What one turn works on, in its own unit: samples, rays, draws, pixels, lines, objects.
    fn units(&self) -> u64;
    /// Makes ready for a turn; not measured.
    fn prepare(&mut self) {}
    /// One turn.
    fn turn(&mut self);
}

/// A named piece of work.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Its name.
    pub name: &'static str,
    /// Makes the data and what works on them.
    pub new: fn() -> Box<dyn Work>,
}

/// All of them.
#[must_use]
pub fn all() -> Vec<Kernel> {
    [spans::KERNELS, arithmetic::KERNELS, files::KERNELS].concat()
}

/// Work without preparation: the number of its units, and a turn.
struct Plain<F>(u64, F);

impl<F: FnMut()> Work for Plain<F> {
    fn units(&self) -> u64 {
        self.0
    }
    fn turn(&mut self) {
        (self.1)();
    }
}

/// Puts work that needs no preparation where any work may be.
fn plain(units: usize, turn: impl FnMut() + 'static) -> Box<dyn Work> {
    Box::new(Plain(units as u64, turn))
}
