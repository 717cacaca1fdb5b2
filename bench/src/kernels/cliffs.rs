//! Kernels of small pictures of [families](crate::families) whose rays need more than the plain formulas. Their counts
//! show when such a scene becomes slower.

use cpu::internals::{InstructionSet, Prepared};
use cpu::{Aos, Config, Scatter, Scene};

use super::{Kernel, Work, plain};
use crate::families::{FAMILIES, Point};

/// Returns the number that gives a floor this radius: the radii are from 10 to 10^12.
const fn decade(exponent: f64) -> f64 {
    (exponent - 1.0) / 11.0
}

/// The number that gives a room of mirrors the maximum depth 40. No ray leaves the room. So each of the 2,304 samples
/// of a picture has 40 hits, and the kernel has 92,160 bounces. The same branches are taken at each of them, so the
/// processor predicts them.
const DEPTH_40: f64 = 0.5637;
const IN_SPHERE: Point = [0.0, DEPTH_40, 0.0, 0.3];
const IN_CYLINDER: Point = [0.0, DEPTH_40, 0.0, 0.6];

pub const KERNELS: &[Kernel] = &[
    Kernel { name: "disc-floor-1e3", new: || picture("disc-floor", [decade(3.0), 0.0, 0.0, 0.0]) },
    Kernel { name: "disc-floor-1e7", new: || picture("disc-floor", [decade(7.0), 0.0, 0.0, 0.0]) },
    Kernel { name: "sphere-floor-1e12", new: || picture("sphere-floor", [decade(12.0), 0.3, 0.3, 0.0]) },
    Kernel { name: "tube-along-its-axis", new: || picture("tube", [0.1, 0.5, 0.3, 0.0]) },
    Kernel { name: "one-giant-at-1e11", new: || picture("one-giant", [0.9, 0.75, 0.0, 0.0]) },
    Kernel { name: "bounces-sphere", new: || picture("mirror-room", IN_SPHERE) },
    Kernel { name: "bounces-cylinder", new: || picture("mirror-room", IN_CYLINDER) },
    Kernel { name: "telescope-at-1e7", new: || picture("telescope", [0.86, 0.5, 0.5, 0.0]) },
];

/// Returns the scene at a point of a family, with a configuration of 32 by 18 pixels and four samples for each.
fn inputs(family: &str, point: Point) -> (Config, Scene) {
    let family = FAMILIES.iter().find(|known| known.name == family).expect("there is such a family");
    let scene = (family.scene)(point);
    let config = Config::parse(scene.config(32, 4).as_bytes()).expect("it is valid");
    (config, Scene::parse(scene.scene.as_bytes()).expect("it is valid"))
}

/// Returns the work of rendering the picture of [`inputs`].
fn picture(family: &str, point: Point) -> Box<dyn Work> {
    let (config, scene) = inputs(family, point);
    let prepared: Prepared<Aos> = Prepared::new(&config, &scene, Scatter::Statement).expect("it fits");
    let prepared: &Prepared<Aos> = Box::leak(Box::new(prepared));
    plain(32 * 18 * 4, || {
        std::hint::black_box(cpu::internals::render_with(prepared, InstructionSet::chosen()).expect("it fits"));
    })
}

#[cfg(test)]
mod tests {
    use cpu::reference::{Plain, render_linear};

    use super::*;

    #[test]
    fn each_sample_in_a_room_of_mirrors_has_forty_hits() {
        for point in [IN_SPHERE, IN_CYLINDER] {
            let (config, scene) = inputs("mirror-room", point);
            let counts = render_linear::<Plain>(&config, &scene, Scatter::Statement, |_, _| ()).expect("it fits");
            assert_eq!((counts.rays, counts.hits), (92_160, 92_160));
        }
    }

    #[test]
    fn a_wide_floor_takes_at_most_half_as_many_instructions_more_as_a_narrow_one() {
        let count = |name: &str| -> f64 {
            let line = include_str!("../../instructions.txt").lines().find_map(|line| line.strip_prefix(name));
            line.and_then(|count| count.trim().parse().ok()).expect("it is in the list")
        };
        assert!(count("disc-floor-1e7 ") <= 1.5 * count("disc-floor-1e3 "));
    }
}
