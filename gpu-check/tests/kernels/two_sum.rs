//! Sums with their rounding errors.

use cpu::internals::math::real::Real;
use cpu::internals::sampling::uniform::Uniform;
use gpu_check::first_difference::twins::two_sum;
use gpu_check::reader::Reader;

use super::kernel::Formula;
use super::special::{self, NUMBERS, Row};

pub enum TwoSum {}

impl Formula for TwoSum {
    const MODULE: &'static str = "kernels/two_sum";
    const INPUTS: usize = 2;
    const OUTPUTS: &'static [&'static str] = &["sum", "error"];

    fn evaluate<T: Real<Mask = bool>>(mut case: Reader<'_, T>, result: &mut [T]) {
        let (sum, error) = two_sum(case.number(), case.number());
        result.copy_from_slice(&[sum, error]);
    }

    fn edges(rows: &mut Row) {
        for a in NUMBERS {
            for b in NUMBERS {
                rows.number(a).number(b);
            }
        }
    }

    fn random(draws: &mut Uniform, row: &mut Row) {
        for _ in 0..2 {
            row.number(special::of_any_size(draws, -12.0, 12.0));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_is_what_the_sum_lost() {
        assert_eq!(two_sum(1e16, 1.0), (1e16, 1.0));
        assert_eq!(two_sum(1.0, 2.0_f64.powi(-60)), (1.0, 2.0_f64.powi(-60)));
        assert_eq!(two_sum(1.0, 2.0), (3.0, 0.0));
    }
}
