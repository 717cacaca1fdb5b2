// What a kernel reports of a ray and a surface: all numbers, so that a row of the output is a row of reals.

struct HitReport {
    // One for a hit; a miss leaves zeros, which no kernel's output holds before it is written.
    some: real,
    lambda: real,
    // cpu::cylinder::Part; zero for a sphere.
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
