// The report of a kernel about one ray and one object. All fields are numbers, so that each row of the output is a row
// of reals.

struct HitReport {
    // 1 for a hit. For a miss all fields are 0. Before the kernel writes an output, the output holds the bytes 0xA5, so
    // a missing report differs from a miss.
    some: real,
    lambda: real,
    // The number of the CylinderPart; 0 for a sphere.
    part: real,
    front: real,
    point: PackedVec3,
    normal: PackedVec3,
}

fn hit_report_none() -> HitReport {
    let zero = vec3_store(vec3<real>());
    return HitReport(real(0.0), real(0.0), real(0.0), real(0.0), zero, zero);
}

fn hit_report(lambda: real, part: u32, hit: Hit) -> HitReport {
    let front = select(real(0.0), real(1.0), hit.front);
    return HitReport(real(1.0), lambda, real(part), front, vec3_store(hit.point), vec3_store(hit.normal));
}
