//! Tests trees of any number of boxes, also of equal boxes.

use crate::accel::bvh::{build::*, byte_boxes::ByteBoxes};
use crate::sampling::uniform::Uniform;

/// Checks that every object is in the tree once, inside all boxes above it. Two thirds of the objects are spheres.
/// Returns the depth of the tree.
fn check(tree: &Tree<ByteBoxes>, bounds: &[Bounds]) -> u32 {
    let mut seen = vec![false; bounds.len()];
    let mut deepest = 0;
    let everything = Bounds { low: [f32::MIN; 3], high: [f32::MAX; 3] };
    let mut pending = vec![(0_usize, vec![everything], 1)];
    while let Some((node, outer, depth)) = pending.pop() {
        deepest = deepest.max(depth);
        for (inner, child) in tree.nodes[node].children() {
            let within = |bounds: &Bounds| {
                for outer in outer.iter().chain([&inner]) {
                    for axis in 0..3 {
                        assert!(bounds.low[axis] >= outer.low[axis] && bounds.high[axis] <= outer.high[axis]);
                    }
                }
            };
            let number = child.number as usize;
            let id = match child.kind {
                Kind::Node => {
                    pending.push((number, outer.iter().copied().chain([inner]).collect(), depth + 1));
                    continue;
                }
                Kind::Sphere => tree.spheres[number],
                Kind::Cylinder => tree.cylinders[number - spheres(bounds.len())],
            };
            assert_eq!((id as usize) < spheres(bounds.len()), child.kind == Kind::Sphere);
            within(&bounds[id as usize]);
            assert!(!std::mem::replace(&mut seen[id as usize], true), "object {id} is there twice");
        }
    }
    assert!(seen.iter().all(|&seen| seen), "an object is lost");
    deepest
}

/// Returns the number of spheres among `count` objects.
const fn spheres(count: usize) -> usize {
    count * 2 / 3
}

fn random(count: usize, size: f64) -> Vec<Bounds> {
    let mut draws = Uniform::new(count as u64 + 1);
    let mut one = || {
        let low = [(); 3].map(|()| draws.draw(-10.0, 10.0) as f32);
        Bounds { low, high: low.map(|value| value + size as f32) }
    };
    (0..count).map(|_| one()).collect()
}

fn build_all(bounds: &[Bounds]) -> Tree<ByteBoxes> {
    build(bounds.len(), spheres(bounds.len()), bounds.iter().copied().zip(0..), Some(false)).expect("it fits")
}

#[test]
fn every_object_is_found_once_inside_its_boxes() {
    for count in [0, 1, 2, 15, 16, 17, 33, 100, 1000, 20_000] {
        let bounds = random(count, 0.1);
        let depth = check(&build_all(&bounds), &bounds);
        assert!(depth <= 6, "{count} objects, depth {depth}");
    }
}

#[test]
fn objects_at_one_place_are_split_all_the_same() {
    let bounds = vec![Bounds { low: [1.0; 3], high: [2.0; 3] }; 1000];
    assert!(check(&build_all(&bounds), &bounds) <= 4);
}

#[test]
fn objects_that_shrink_towards_a_point_keep_the_depth_bounded() {
    let at = |step: i32| 2.0_f32.powi(-step);
    let bounds: Vec<_> =
        (0..2000).map(|step| Bounds { low: [at(step % 100); 3], high: [at(step % 100) * 1.01; 3] }).collect();
    assert!(check(&build_all(&bounds), &bounds) <= 20);
}
