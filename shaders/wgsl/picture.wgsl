// What a picture is made from, as the CPU prepares it; structures as in layout.wgsl.

// cpu::sphere::SphereRecord<T>, then `order` and `material` of cpu::layout::Placed
struct PlacedSphere {
    center: PackedVec3,
    radius: real,
    radius_squared: real,
    order: u32,
    material: u32,
}

fn sphere_load(sphere: PlacedSphere) -> SphereRecord {
    return SphereRecord(vec3_load(sphere.center), sphere.radius, sphere.radius_squared);
}

// cpu::cylinder::CylinderRecord<T>, then `order` and `material` of cpu::layout::Placed
struct PlacedCylinder {
    center: PackedVec3,
    axis: PackedVec3,
    top: PackedVec3,
    bottom: PackedVec3,
    radius: real,
    radius_squared: real,
    half_height: real,
    order: u32,
    material: u32,
}

fn cylinder_load(cylinder: PlacedCylinder) -> CylinderRecord {
    return CylinderRecord(
        vec3_load(cylinder.center),
        vec3_load(cylinder.axis),
        vec3_load(cylinder.top),
        vec3_load(cylinder.bottom),
        cylinder.radius,
        cylinder.radius_squared,
        cylinder.half_height,
    );
}

// cpu::Material: gpu_check::picture::PackedMaterial<T>
struct PackedMaterial {
    reflectance: PackedVec3,
    index: real,
    kind: u32,
    unused: u32,
}

fn material_load(material: PackedMaterial) -> Material {
    return Material(vec3_load(material.reflectance), material.index, material.kind);
}

// cpu::Camera<T>
struct PackedCamera {
    position: PackedVec3,
    origin: PackedVec3,
    delta_x: PackedVec3,
    delta_y: PackedVec3,
}

// cpu::background::Background<T>
struct PackedBackground {
    dark: PackedVec3,
    light: PackedVec3,
}

// gpu_check::picture::Picture<T>
struct Picture {
    camera: PackedCamera,
    background: PackedBackground,
    // Null in deterministic mode, yet loaded: a driver that knew the zero would drop the sum, and with it the sign of
    // a zero component.
    offset_x: real,
    offset_y: real,
    scatter_vector: PackedVec3,
    width: u32,
    first_pixel: u32,
    pixel_count: u32,
    sphere_count: u32,
    cylinder_count: u32,
    // The surfaces that this run may meet, of all that a ray may: from `first_depth` up to `end_depth`.
    first_depth: u32,
    end_depth: u32,
    unused: u32,
}

// Where a ray is when a run ends before its way does.
struct PackedPath {
    ray: PackedRay,
    attenuation_count: u32,
    ended: u32,
}

@group(0) @binding(0) var<storage, read> picture: Picture;
@group(0) @binding(1) var<storage, read> spheres: array<PlacedSphere>;
@group(0) @binding(2) var<storage, read> cylinders: array<PlacedCylinder>;
@group(0) @binding(3) var<storage, read> materials: array<PackedMaterial>;
// The materials that attenuate each invocation's path, first hit first: max_depth places for each invocation.
@group(0) @binding(4) var<storage, read_write> attenuations: array<u32>;
// A pixel's linear colour.
@group(0) @binding(5) var<storage, read_write> pixels: array<PackedVec3>;
// Each invocation's ray between two runs.
@group(0) @binding(6) var<storage, read_write> paths: array<PackedPath>;

fn picture_camera() -> Camera {
    return Camera(
        vec3_load(picture.camera.position),
        vec3_load(picture.camera.origin),
        vec3_load(picture.camera.delta_x),
        vec3_load(picture.camera.delta_y),
    );
}

fn picture_background() -> Background {
    return Background(vec3_load(picture.background.dark), vec3_load(picture.background.light));
}
