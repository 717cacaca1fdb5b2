//! Tests trees of any number of boxes, also of equal boxes.

use crate::accel::bvh::build::*;
use crate::sampling::uniform::Uniform;

/// Checks that every object is in the tree once, inside all boxes above it. Returns the depth of the tree.
fn check(nodes: &[Node], bounds: &[Bounds]) -> u32 {
    let mut seen = vec![false; bounds.len()];
    let mut deepest = 0;
    let mut pending = vec![(0_usize, Bounds { low: [f32::MIN; 3], high: [f32::MAX; 3] }, 1)];
    while let Some((node, outer, depth)) = pending.pop() {
        deepest = deepest.max(depth);
        for (inner, child) in nodes[node].children() {
            for axis in 0..3 {
                assert!(inner.low[axis] >= outer.low[axis] && inner.high[axis] <= outer.high[axis]);
            }
            match child.as_object() {
                Some(id) => {
                    assert_eq!(inner, bounds[id as usize]);
                    assert!(!std::mem::replace(&mut seen[id as usize], true), "object {id} is there twice");
                }
                None => pending.push((child.index() as usize, inner, depth + 1)),
            }
        }
    }
    assert!(seen.iter().all(|&seen| seen), "an object is lost");
    deepest
}

fn random(count: usize, size: f64) -> Vec<Bounds> {
    let mut draws = Uniform::new(count as u64 + 1);
    let mut one = || {
        let low = [(); 3].map(|()| draws.draw(-10.0, 10.0) as f32);
        Bounds { low, high: low.map(|value| value + size as f32) }
    };
    (0..count).map(|_| one()).collect()
}

fn build_all(bounds: &[Bounds]) -> Vec<Node> {
    build(bounds.len(), bounds.iter().copied().zip(0..)).expect("it fits")
}

#[test]
fn every_object_is_found_once_inside_its_boxes() {
    for count in [1, 2, 15, 16, 17, 33, 100, 1000, 20_000] {
        let bounds = random(count, 0.1);
        let depth = check(&build_all(&bounds), &bounds);
        assert!(depth <= 6, "{count} objects, depth {depth}");
    }
    assert!(build_all(&[]).is_empty());
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

#[test]
fn a_hierarchy_takes_less_than_a_hundred_bytes_an_object() {
    for count in [257, 1000, 1025, 4097, 20_000] {
        let nodes = build_all(&random(count, 0.01));
        let bytes = nodes.len() * size_of::<Node>();
        assert!(bytes < 100 * count, "{bytes} bytes for {count} objects");
    }
}
