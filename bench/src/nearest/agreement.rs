//! Compares our hits with Embree's.

use super::{NearestHit, Start};

/// The smallest share of rays for which both sides must hit the same object.
pub const LEAST_AGREEMENT: f64 = 0.9999;

/// How many rays of both sides hit the same object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Agreement {
    /// Number of rays that hit the same object, or none, on both sides.
    pub same: usize,
    /// Number of rays for which Embree hits the start object nearer than our hit. By rounding, Embree's ray then
    /// starts inside that object, or passes through its rim.
    pub self_hits: usize,
    /// Number of all rays.
    pub rays: usize,
}

impl Agreement {
    /// Compares the hits of the same rays on both sides.
    #[must_use]
    pub fn new(starts: &[Start], ours: &[NearestHit], embree: &[NearestHit]) -> Self {
        let pairs = || starts.iter().zip(ours.iter().zip(embree));
        let is_self_hit = |start: &Start, ours: &NearestHit, embree: &NearestHit| {
            ours.place != embree.place && embree.place == start.from && embree.lambda < ours.lambda
        };
        Self {
            same: pairs().filter(|(_, (ours, embree))| ours.place == embree.place).count(),
            self_hits: pairs().filter(|(start, (ours, embree))| is_self_hit(start, ours, embree)).count(),
            rays: starts.len(),
        }
    }

    /// Returns the share of rays that hit the same object, from 0 to 1. Embree's self-hits are left out.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.same as f64 / (self.rays - self.self_hits) as f64
    }

    /// Whether the share is at least [`LEAST_AGREEMENT`].
    #[must_use]
    pub fn is_enough(&self) -> bool {
        self.share() >= LEAST_AGREEMENT
    }
}

#[cfg(test)]
mod tests {
    use cpu::{Ray, Vec3};

    use super::*;
    use crate::nearest::NO_PLACE;

    #[test]
    fn self_hits_are_counted_apart() {
        let ray = Ray { origin: Vec3::ZERO, direction: Vec3::ZERO };
        let starts = [1, 1, 1, 1, NO_PLACE].map(|from| Start { ray, from });
        let hit = |place, lambda| NearestHit { place, lambda };
        let ours = [hit(2, 1.0), hit(2, 1.0), hit(2, 1.0), NearestHit::NOTHING, NearestHit::NOTHING];
        // The second ray misses what is nearer than the start object, so it is no self-hit.
        let embree = [hit(2, 1.1), hit(1, 1.1), hit(1, 0.9), hit(1, 5.0), NearestHit::NOTHING];
        let agreement = Agreement::new(&starts, &ours, &embree);
        assert_eq!(agreement, Agreement { same: 2, self_hits: 2, rays: 5 });
        assert!((agreement.share() - 2.0 / 3.0).abs() < 1e-15 && !agreement.is_enough());
        assert!(Agreement { same: 9_999, self_hits: 7, rays: 10_007 }.is_enough());
        assert!(!Agreement { same: 9_998, self_hits: 7, rays: 10_007 }.is_enough());
    }
}
