// Each invocation intersects one ray with one sphere, in every step of the exact intersection.

struct ExactSphereCase {
    ray: PackedRay,
    center: PackedVec3,
    radius: real,
}

@group(0) @binding(0) var<storage, read> cases: array<ExactSphereCase>;
@group(0) @binding(1) var<storage, read_write> reports: array<ExactReport>;

@compute @workgroup_size(64)
fn exact_sphere(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let ray = ray_load(cases[id.x].ray);
    let record = sphere_new(vec3_load(cases[id.x].center), cases[id.x].radius);
    reports[id.x] = exact_report(exact_sphere_filtered(record, ray), exact_sphere_compensated(record, ray));
}
