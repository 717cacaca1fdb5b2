//! Finds large errors of lambda by hill climbing. They are larger than the errors of random rays.
//!
//! A climb begins with a random case of a regime and changes some of its numbers slightly. It keeps a change unless the
//! error of lambda falls. The largest error found is a lower bound of the true maximum, so it must be below the bound
//! that docs/accuracy.md proves.

use cpu::internals::input::scene::Shape;

use crate::case::Case;
use crate::measure::lambda_error;
use crate::oracle;
use crate::random::Random;
use crate::regimes::Regime;

/// Returns the relative error of lambda. It is 0 if dyadic arithmetic decides, whose error is negligible, and `None` if
/// a decision in f64 is wrong.
fn error(case: &Case) -> Option<f64> {
    let (record, ray) = case.of();
    if record.needs_dyadic(&ray) {
        return Some(0.0);
    }
    lambda_error(&oracle::judge(case), record.exact(&ray), f64::EPSILON / 2.0)
}

/// Returns the case with about a third of its numbers changed. The relative change is from 10^-16 to 10^-1.
fn changed(case: &Case, random: &mut Random) -> Case {
    let mut case = *case;
    let mut change = |number: &mut f64| {
        if random.below(3) == 0 {
            *number *= 1.0 + random.sign() * random.decades(-16.0, -1.0);
        }
    };
    let (center, radius) = match &mut case.shape {
        Shape::Sphere(sphere) => (&mut sphere.center, &mut sphere.radius),
        Shape::Cylinder(cylinder) => {
            [&mut cylinder.axis.x, &mut cylinder.axis.y, &mut cylinder.axis.z].into_iter().for_each(&mut change);
            (&mut cylinder.center, &mut cylinder.radius)
        }
    };
    change(radius);
    for vector in [center, &mut case.ray.origin, &mut case.ray.direction] {
        [&mut vector.x, &mut vector.y, &mut vector.z].into_iter().for_each(&mut change);
    }
    case
}

/// Returns the largest relative error of lambda that `climbs` climbs find. Each climb has `steps` steps and begins with
/// a case of `regime`.
///
/// # Errors
/// The first case for which a decision is wrong.
pub fn largest_error(regime: &Regime, seed: u64, climbs: usize, steps: usize) -> Result<f64, Box<Case>> {
    let mut random = Random::new(seed);
    let mut largest = 0.0_f64;
    for start in regime.cases(seed, climbs) {
        let mut best = (error(&start).ok_or(Box::new(start))?, start);
        for _ in 0..steps {
            let next = changed(&best.1, &mut random);
            let reached = error(&next).ok_or(Box::new(next))?;
            if reached >= best.0 {
                best = (reached, next);
            }
        }
        largest = largest.max(best.0);
    }
    Ok(largest)
}
