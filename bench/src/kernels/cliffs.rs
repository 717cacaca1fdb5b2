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

/// Gives a room of mirrors the maximum depth 40. No ray leaves a room without other objects, so each sample of these
/// kernels has 40 hits: their time is that of 92,160 bounces, which no ray ends, and whose branches are predicted.
const DEPTH_40: f64 = 0.5637;

pub const KERNELS: &[Kernel] = &[
    Kernel { name: "disc-floor-1e3", new: || picture("disc-floor", [decade(3.0), 0.0, 0.0, 0.0]) },
    Kernel { name: "disc-floor-1e7", new: || picture("disc-floor", [decade(7.0), 0.0, 0.0, 0.0]) },
    Kernel { name: "sphere-floor-1e12", new: || picture("sphere-floor", [decade(12.0), 0.3, 0.3, 0.0]) },
    Kernel { name: "tube-along-its-axis", new: || picture("tube", [0.1, 0.5, 0.3, 0.0]) },
    Kernel { name: "one-giant-at-1e11", new: || picture("one-giant", [0.9, 0.75, 0.0, 0.0]) },
    Kernel { name: "bounces-sphere", new: || picture("mirror-room", [0.0, DEPTH_40, 0.0, 0.3]) },
    Kernel { name: "bounces-cylinder", new: || picture("mirror-room", [0.0, DEPTH_40, 0.0, 0.6]) },
    Kernel { name: "telescope-at-1e7", new: || picture("telescope", [0.86, 0.5, 0.5, 0.0]) },
];

/// Returns the work of rendering a picture of 32 by 18 pixels with four samples each.
fn picture(family: &str, point: Point) -> Box<dyn Work> {
    let family = FAMILIES.iter().find(|known| known.name == family).expect("there is such a family");
    let scene = (family.scene)(point);
    let config = Config::parse(scene.config(32, 4).as_bytes()).expect("it is valid");
    let scene = Scene::parse(scene.scene.as_bytes()).expect("it is valid");
    let prepared: Prepared<Aos> = Prepared::new(&config, &scene, Scatter::Statement).expect("it fits");
    let prepared: &Prepared<Aos> = Box::leak(Box::new(prepared));
    plain(32 * 18 * 4, || {
        std::hint::black_box(cpu::internals::render_with(prepared, InstructionSet::chosen()).expect("it fits"));
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_wide_floor_takes_at_most_half_as_many_instructions_more_as_a_narrow_one() {
        let count = |name: &str| -> f64 {
            let line = include_str!("../../instructions.txt").lines().find_map(|line| line.strip_prefix(name));
            line.and_then(|count| count.trim().parse().ok()).expect("it is in the list")
        };
        assert!(count("disc-floor-1e7 ") <= 1.5 * count("disc-floor-1e3 "));
    }
}
