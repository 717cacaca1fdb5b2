// Each invocation intersects one ray with one sphere, in the projected form.

struct ProjectedSphereCase {
    ray: PackedRay,
    center: PackedVec3,
    radius: real,
}

@group(0) @binding(0) var<storage, read> cases: array<ProjectedSphereCase>;
@group(0) @binding(1) var<storage, read_write> reports: array<HitReport>;

@compute @workgroup_size(64)
fn projected_sphere(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    let ray = ray_load(cases[id.x].ray);
    let record = sphere_new(vec3_load(cases[id.x].center), cases[id.x].radius);
    let root = projected_sphere_intersect(record, ray);
    if !root.some {
        reports[id.x] = hit_report_none();
        return;
    }
    let point = ray_at(ray, root.lambda);
    let hit = hit_facing(ray.direction, point, sphere_outward(record, point));
    reports[id.x] = hit_report(root.lambda, 0u, hit);
}
