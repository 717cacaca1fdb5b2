// Each invocation intersects one ray with one cylinder, in the projected form.

struct ProjectedCylinderCase {
    ray: PackedRay,
    center: PackedVec3,
    radius: real,
    axis: PackedVec3,
}

@group(0) @binding(0) var<storage, read> cases: array<ProjectedCylinderCase>;
@group(0) @binding(1) var<storage, read_write> reports: array<HitReport>;

@compute @workgroup_size(64)
fn projected_cylinder(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let ray = ray_load(cases[id.x].ray);
    let record = cylinder_new(vec3_load(cases[id.x].center), cases[id.x].radius, vec3_load(cases[id.x].axis));
    let root = projected_cylinder_intersect(record, ray);
    if !root.some {
        reports[id.x] = hit_report_none();
        return;
    }
    let point = ray_at(ray, root.lambda);
    let hit = hit_facing(ray.direction, point, cylinder_outward(record, root.part, point));
    reports[id.x] = hit_report(root.lambda, root.part, hit);
}
