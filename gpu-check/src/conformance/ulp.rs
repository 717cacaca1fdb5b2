//! Errors in units in the last place, as section 15.7.4 of the WGSL specification defines them.

use std::cmp::Ordering;

use super::reading::Allowed;

/// Factor for the error of a bound itself, because bounds are computed in `f64`. 2^-20 of a unit in the last place of
/// `f32` is far more than the error of `f64`, and far less than any error that matters.
const SLACK: f64 = 1.0 + 1.0 / (1 << 20) as f64;

/// Returns the distance between the two neighbours in `f32` that enclose `x`. At a power of two this is the smaller of
/// the two distances.
#[must_use]
pub fn ulp(x: f64) -> f64 {
    let magnitude = x.abs().min(f64::from(f32::MAX));
    let near = magnitude as f32;
    let below = if f64::from(near) < magnitude || near == 0.0 { near } else { near.next_down() };
    f64::from(below.next_up()) - f64::from(below)
}

/// Allows every result within `units` units in the last place of `exact`, which must be accurate to 2^-45.
#[must_use]
pub fn within(exact: f64, units: f64) -> Allowed {
    let error = units * ulp(exact) * SLACK;
    Allowed::Between(exact - error, exact + error)
}

/// Allows the two numbers of `f32` next to `exact`, of which a correctly rounded result is one. If `exact` is in `f32`,
/// only that number is allowed.
#[must_use]
pub fn neighbours(exact: f64) -> Allowed {
    let near = exact as f32;
    let other = match f64::from(near).total_cmp(&exact) {
        Ordering::Less => near.next_up(),
        Ordering::Equal => near,
        Ordering::Greater => near.next_down(),
    };
    Allowed::any_of([near, other])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_is_the_distance_of_the_neighbours() {
        let eps = f64::from(f32::EPSILON);
        assert_eq!([ulp(1.0), ulp(1.5), ulp(-1.25), ulp(2.0)], [eps / 2.0, eps, eps, eps]);
        assert_eq!(ulp(1.0 + 1e-12), eps);
        assert_eq!([ulp(0.0), ulp(1e-42)], [f64::from(f32::from_bits(1)); 2]);
        assert_eq!(ulp(1e300), f64::from(f32::MAX) - f64::from(f32::MAX.next_down()));
    }

    #[test]
    fn neighbours_enclose_the_number() {
        for number in [1.0 / 3.0, -1.0 / 3.0, 16_777_217.0] {
            let Allowed::OneOf(numbers) = neighbours(number) else { panic!("two numbers are allowed") };
            let [low, high] = [numbers[0].min(numbers[1]), numbers[0].max(numbers[1])];
            assert!(low < number && number < high && (low as f32).next_up() == high as f32);
        }
        assert_eq!(neighbours(0.5), Allowed::any_of([0.5; 2]));
    }
}
