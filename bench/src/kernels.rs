//! The kernels: named pieces of work, each on fixed data.

mod arithmetic;
mod files;
mod spans;

/// A piece of work that can be done again and again.
pub trait Work {
    /// Number of units that one turn works on: samples, rays, draws, pixels, lines or objects.
    fn units(&self) -> u64;
    /// Prepares for a turn. This is not measured.
    fn prepare(&mut self) {}
    /// Does the work once.
    fn turn(&mut self);
}

/// A named piece of work.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    /// Its name.
    pub name: &'static str,
    /// Makes the data, and the work on them.
    pub new: fn() -> Box<dyn Work>,
}

/// All kernels.
#[must_use]
pub fn all() -> Vec<Kernel> {
    [spans::KERNELS, arithmetic::KERNELS, files::KERNELS].concat()
}

/// Work without preparation: the number of its units, and the function that does one turn.
struct Plain<F>(u64, F);

impl<F: FnMut()> Work for Plain<F> {
    fn units(&self) -> u64 {
        self.0
    }
    fn turn(&mut self) {
        (self.1)();
    }
}

/// Makes work without preparation from the number of its units and the function that does one turn.
fn plain(units: usize, turn: impl FnMut() + 'static) -> Box<dyn Work> {
    Box::new(Plain(units as u64, turn))
}
