//! Bytes that are counted together: those of all bodies, answers and pictures. What does not fit is refused at once.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A number of bytes that may be in use at a time. All clones count together.
#[derive(Clone, Debug)]
pub struct Budget {
    total: usize,
    taken: Arc<AtomicUsize>,
}

/// Bytes that have been taken from a [`Budget`]. They are given back when this value is dropped.
#[derive(Debug)]
pub struct Share {
    budget: Budget,
    bytes: usize,
}

/// The reason why a [`Share`] is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Full {
    /// Number of bytes that are needed.
    pub needed: usize,
    /// Number of bytes that are free.
    pub free: usize,
    /// Number of bytes that may be in use at a time.
    pub total: usize,
}

impl fmt::Display for Full {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { needed, free, total } = self;
        write!(out, "this takes {needed} bytes, and {free} of {total} bytes are free; ")?;
        out.write_str(if needed > total { "make it smaller" } else { "try again when other requests have ended" })
    }
}

impl Budget {
    /// Returns a budget of `total` bytes.
    #[must_use]
    pub fn new(total: usize) -> Self {
        Self { total, taken: Arc::default() }
    }

    /// Takes `bytes` bytes.
    ///
    /// # Errors
    /// [`Full`] if fewer bytes are free. Then nothing is taken.
    pub fn take(&self, bytes: usize) -> Result<Share, Full> {
        let add = |taken: usize| taken.checked_add(bytes).filter(|&sum| sum <= self.total);
        match self.taken.fetch_update(Ordering::SeqCst, Ordering::SeqCst, add) {
            Ok(_) => Ok(Share { budget: self.clone(), bytes }),
            Err(taken) => Err(Full { needed: bytes, free: self.total - taken, total: self.total }),
        }
    }

    /// Returns the number of bytes that are in use.
    #[must_use]
    pub fn taken(&self) -> usize {
        self.taken.load(Ordering::SeqCst)
    }
}

impl Share {
    /// Gives back all bytes but `bytes`. A larger number than before changes nothing.
    pub fn shrink(&mut self, bytes: usize) {
        let surplus = self.bytes.saturating_sub(bytes);
        self.bytes -= surplus;
        self.budget.taken.fetch_sub(surplus, Ordering::SeqCst);
    }
}

impl Drop for Share {
    fn drop(&mut self) {
        self.budget.taken.fetch_sub(self.bytes, Ordering::SeqCst);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_up_to_the_limit_are_given_and_one_byte_more_is_refused_with_the_numbers() {
        let budget = Budget::new(5);
        let mut first = budget.take(3).expect("it fits");
        assert_eq!(budget.take(3).expect_err("it is too much"), Full { needed: 3, free: 2, total: 5 });
        assert!(budget.take(usize::MAX).is_err());
        let second = budget.clone().take(2).expect("exactly the limit");
        assert_eq!(budget.taken(), 5);
        first.shrink(1);
        first.shrink(4);
        assert_eq!(budget.taken(), 3);
        drop((first, second));
        assert_eq!(budget.taken(), 0);
    }

    #[test]
    fn a_refusal_names_the_remedy() {
        let text = |needed| Full { needed, free: 2, total: 5 }.to_string();
        assert_eq!(text(3), "this takes 3 bytes, and 2 of 5 bytes are free; try again when other requests have ended");
        assert_eq!(text(6), "this takes 6 bytes, and 2 of 5 bytes are free; make it smaller");
    }
}
