// The rule for two hits at the same lambda: the later one counts; twin of cpu/src/geometry/tie.rs. Objects are in the
// order of the scene file. The parts of a cylinder are in the order side, top cap, bottom cap.

// later_is_closer: returns whether a hit at `lambda`, of a later object or part, replaces the hit at `closest`.
fn tie_later_is_closer(lambda: real, closest: real) -> bool {
    return lambda <= closest;
}

// is_closer: returns whether the hit at `lambda` replaces the closest hit so far, which is at `closest`. Each order is
// the object's place in the scene file. The objects may come in any order.
fn tie_is_closer(lambda: real, order: u32, closest: real, closest_order: u32) -> bool {
    return tie_later_is_closer(lambda, closest) & ((lambda < closest) | (order >= closest_order));
}
