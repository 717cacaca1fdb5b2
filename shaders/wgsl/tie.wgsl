// The rule for two hits at the same lambda: the last sphere or side counts, and a cap only if it comes first and all
// are caps; twin of cpu/src/geometry/tie.rs. Objects are in the order of the scene file. The parts of a cylinder are in
// the order side, top cap, bottom cap.

// later_cap_is_closer: returns whether a hit at `lambda`, on a later cap, replaces the hit at `closest`.
fn tie_later_cap_is_closer(lambda: real, closest: real) -> bool {
    return lambda < closest;
}

// rank: returns the rank of a hit among the hits at the same lambda. The hit with the highest rank counts. `order` is
// the object's place in the scene file.
fn tie_rank(order: u32, on_cap: bool) -> i32 {
    return select(i32(order), -1 - i32(order), on_cap);
}

// is_closer: returns whether the hit at `lambda` replaces the closest hit so far, which is at `closest`. The objects
// may come in any order.
fn tie_is_closer(lambda: real, rank: i32, closest: real, closest_rank: i32) -> bool {
    return (lambda < closest) | ((lambda <= closest) & (rank >= closest_rank));
}
