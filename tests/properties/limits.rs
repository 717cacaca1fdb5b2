//! Tests with surfaces at the least lambda: the camera looks at a target, and a surface is at a thousandth of the
//! target's distance, in round decimals.
//!
//! The specification, section 8.2, counts a hit whose exact lambda, rounded to f64, is at least the f64 `1e-3`. The
//! renderer and the reference with exact intersections could be wrong together. So pictures of one ray are also
//! compared with integer arithmetic.

use std::cell::Cell;

use cpu::{Image, Scatter};
use proptest::prelude::*;

use crate::runner::{agreed, check};

/// A surface that the camera's axis meets at `tenths / 10`.
#[derive(Clone, Debug)]
struct Case {
    /// The surface's distance, in tenths.
    tenths: u32,
    /// The size of the object, in tenths.
    size: u32,
    /// The kind of object: a sphere, a cylinder with a cap, a cylinder with a side.
    kind: usize,
    /// Whether the camera's axis leaves the object at the surface.
    from_inside: bool,
    /// The coordinate axis of the view.
    axis: usize,
    /// The direction of the view, 1 or -1.
    sign: i32,
}

fn case() -> impl Strategy<Value = Case> {
    (1..=60_u32, 1..=40_u32, 0..3_usize, any::<bool>(), 0..3_usize, prop_oneof![Just(1), Just(-1)])
        .prop_map(|(tenths, size, kind, from_inside, axis, sign)| Case { tenths, size, kind, from_inside, axis, sign })
}

/// Returns a number of tenths as a decimal.
fn decimal(tenths: i64) -> String {
    let sign = if tenths < 0 { "-" } else { "" };
    format!("{sign}{}.{}", tenths.abs() / 10, tenths.abs() % 10)
}

impl Case {
    fn vector(&self, along: i64) -> String {
        let mut parts = ["0".to_owned(), "0".to_owned(), "0".to_owned()];
        parts[self.axis] = decimal(along * i64::from(self.sign));
        parts.join(" ")
    }

    /// Returns the distance of the object's centre, in tenths. The surface is `size` from there.
    fn center(&self) -> i64 {
        let size = i64::from(self.size);
        i64::from(self.tenths) + if self.from_inside { -size } else { size }
    }

    fn config(&self, field_of_view: f64, more: &str) -> String {
        let north = ["0 1 0", "0 0 1", "1 0 0"][self.axis];
        format!(
            "aspect_ratio: 1 1\nfield_of_view: {field_of_view}\ncamera_position: 0 0 0\ncamera_target: {}\n\
             camera_north: {north}\nbackground_dark_color: 1 1 1\nbackground_light_color: 1 1 1\n{more}",
            self.vector(1000 * i64::from(self.tenths)),
        )
    }

    fn scene(&self) -> String {
        let (center, size) = (self.vector(self.center()), decimal(i64::from(self.size)));
        let object = match self.kind {
            0 => format!("sphere: {center} {size}"),
            1 => format!("cylinder: {center} 3.5 {}", self.vector(2 * i64::from(self.size))),
            _ => {
                let mut axis = ["0"; 3];
                axis[(self.axis + 1) % 3] = "5";
                format!("cylinder: {center} {size} {}", axis.join(" "))
            }
        };
        format!("matte: a .8 .2 .1\n{object} a\n")
    }

    /// Whether the surface's exact lambda is at least the limit, by integers in units of 2^-60. The surface's distance
    /// is the sum of two numbers of f64: the object's centre, and its radius or half of its height. Lambda is this
    /// distance divided by that of the target.
    fn counts(&self) -> bool {
        // A product with a power of two is exact, and all numbers are multiples of 2^-56.
        let units = |tenths: i64| (tenths as f64 / 10.0 * 2.0_f64.powi(60)) as i128;
        let (center, size) = (units(self.center()), units(self.size.into()));
        // The height of a cylinder is twice its size, and the product with 2 is exact in f64 and as a decimal.
        let surface = if self.from_inside { center + size } else { center - size };
        let target = units(1000 * i64::from(self.tenths));
        // The limit is the midpoint between 1e-3 and the f64 below it: (2 f - 1) / 2 units in the last place, 2^-62.
        let fraction = (1e-3 * 2.0_f64.powi(62)) as i128;
        assert!((1 << 52..1 << 53).contains(&fraction));
        // surface / target >= (2 f - 1) / 2^63. Both sides are positive, so the quotient may be rounded down.
        (surface << 63) / target >= 2 * fraction - 1
    }
}

#[test]
fn a_surface_at_a_thousandth_counts_by_its_exact_lambda() {
    let (hits, all) = (Cell::new(0), Cell::new(0));
    check(600, case(), |case| {
        let picture = agreed(&case.config(30.0, "image_width: 1\n"), &case.scene(), Scatter::Deterministic);
        let is_hit = picture.image.pixel(0) != cpu::Rgb { red: 255, green: 255, blue: 255 };
        // From outside, a ray that does not hit the near surface hits the far one.
        prop_assert_eq!(is_hit, !case.from_inside || case.counts(), "{}", case.scene());
        hits.set(hits.get() + u32::from(is_hit));
        all.set(all.get() + 1);
        Ok(())
    });
    let (hits, all) = (hits.get(), all.get());
    assert!(2 * hits > all && hits < all, "{hits} of {all}");
}

#[test]
fn pictures_of_surfaces_at_a_thousandth_are_the_references() {
    check(60, (case(), prop_oneof![Just(60.0), Just(1e-9), 1e-3..170.0]), |(case, field_of_view)| {
        agreed(
            &case.config(field_of_view, "image_width: 12\nsamples_per_pixel: 3\nmax_depth: 8\n"),
            &case.scene(),
            Scatter::Statement,
        );
        Ok(())
    });
}
