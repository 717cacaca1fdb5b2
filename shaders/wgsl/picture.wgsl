// The buffers that a picture is rendered from and into. Their structures have only scalar fields, as in layout.wgsl.

// cpu::internals::layout::Placed<SphereRecord<T>>
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

// cpu::internals::layout::Placed<CylinderRecord<T>>
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

// gpu_check::picture::PackedMaterial<T>, which is made from cpu::Material. `unused` makes the size a multiple of 8
// bytes, as f64 needs it.
struct PackedMaterial {
    reflectance: PackedVec3,
    index: real,
    kind: u32,
    unused: u32,
}

fn material_load(material: PackedMaterial) -> Material {
    return Material(vec3_load(material.reflectance), material.index, material.kind);
}

// cpu::internals::Camera<T>
struct PackedCamera {
    position: PackedVec3,
    origin: PackedVec3,
    delta_x: PackedVec3,
    delta_y: PackedVec3,
}

// cpu::internals::render::background::Background<T>
struct PackedBackground {
    dark: PackedVec3,
    light: PackedVec3,
}

// gpu_check::picture::Picture<T> without its lists, and the pixels and depths of one run; gpu_check::renderer packs it.
struct Picture {
    camera: PackedCamera,
    background: PackedBackground,
    // The offset from the middle of a pixel, and the scatter vector. They are 0 in deterministic mode, but are loaded:
    // a driver that knew the zeros would drop the additions. But -0 + 0 is 0, and without the addition it is -0.
    offset_x: real,
    offset_y: real,
    scatter_vector: PackedVec3,
    width: u32,
    first_pixel: u32,
    pixel_count: u32,
    sphere_count: u32,
    cylinder_count: u32,
    // This run traces the depths from `first_depth` to below `end_depth`. Long paths need several runs (trace.wgsl).
    first_depth: u32,
    end_depth: u32,
    unused: u32,
}

// The state of a path between two runs: its next ray, and the number of its attenuations so far. `ended` is 1 if the
// path has ended and the colour of its pixel has been written.
struct PackedPath {
    ray: PackedRay,
    attenuation_count: u32,
    ended: u32,
}

@group(0) @binding(0) var<storage, read> picture: Picture;
@group(0) @binding(1) var<storage, read> spheres: array<PlacedSphere>;
@group(0) @binding(2) var<storage, read> cylinders: array<PlacedCylinder>;
@group(0) @binding(3) var<storage, read> materials: array<PackedMaterial>;
// The materials that attenuate each invocation's path, from the first hit on. Each invocation has max_depth entries.
@group(0) @binding(4) var<storage, read_write> attenuations: array<u32>;
// The linear colour of each pixel.
@group(0) @binding(5) var<storage, read_write> pixels: array<PackedVec3>;
// The state of each invocation's path between two runs.
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
