// Each invocation intersects one ray with one cylinder, in every step of the exact intersection.

struct ExactCylinderCase {
    ray: PackedRay,
    center: PackedVec3,
    radius: real,
    axis: PackedVec3,
}

@group(0) @binding(0) var<storage, read> cases: array<ExactCylinderCase>;
@group(0) @binding(1) var<storage, read_write> reports: array<ExactReport>;

@compute @workgroup_size(64)
fn exact_cylinder(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let ray = ray_load(cases[id.x].ray);
    let axis = vec3_load(cases[id.x].axis);
    let record = cylinder_new(vec3_load(cases[id.x].center), cases[id.x].radius, axis);
    let plain = exact_cylinder_filtered(record, ray);
    reports[id.x] = exact_report(plain, exact_cylinder_compensated(record, axis, ray));
}
