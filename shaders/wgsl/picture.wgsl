// The buffers that a picture is rendered from and into. Their structures have only scalar fields, as in layout.wgsl.

// The fields of cpu::internals::layout::Placed<SphereRecord<T>> from which sphere_new computes the record.
struct PlacedSphere {
    center: PackedVec3,
    radius: real,
    order: u32,
    material: u32,
}

fn sphere_load(sphere: PlacedSphere) -> SphereRecord {
    return sphere_new(vec3_load(sphere.center), sphere.radius);
}

// The fields of cpu::internals::layout::Placed<CylinderRecord<T>> from which cylinder_with_unit_axis computes the
// record.
struct PlacedCylinder {
    center: PackedVec3,
    axis: PackedVec3,
    radius: real,
    half_height: real,
    order: u32,
    material: u32,
}

fn cylinder_load(cylinder: PlacedCylinder) -> CylinderRecord {
    let axis = vec3_load(cylinder.axis);
    return cylinder_with_unit_axis(vec3_load(cylinder.center), cylinder.radius, axis, cylinder.half_height);
}

// twin::picture::PackedMaterial<T>, which is made from cpu::Material. `unused` makes the size a multiple of 8
// bytes, as f64 needs it.
struct PackedMaterial {
    reflectance: PackedVec3,
    index: real,
    extent: real,
    kind: u32,
    unused: u32,
}

fn material_load(material: PackedMaterial) -> Material {
    return Material(vec3_load(material.reflectance), material.index, material.extent, material.kind);
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

// twin::Picture<T> without its lists, and the pixels, samples and depths of one run; twin::head
// packs it. Only trace.wgsl uses `pixel_count`, and only trace_samples.wgsl the four fields from `sample_count` on.
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
    // The number of samples of this run. The first of them is sample number `first_sample` of pixel `first_pixel`.
    sample_count: u32,
    first_sample: u32,
    samples_per_pixel: u32,
    // The convention of the scatter vectors: a constant of scatter_vectors.wgsl.
    convention: u32,
    unused: u32,
}

@group(0) @binding(0) var<storage, read> picture: Picture;
@group(0) @binding(1) var<storage, read> spheres: array<PlacedSphere>;
@group(0) @binding(2) var<storage, read> cylinders: array<PlacedCylinder>;
@group(0) @binding(3) var<storage, read> materials: array<PackedMaterial>;

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
