// The closest hit of a ray in a hierarchy of boxes. It stands in for closest_hit.wgsl in scenes of many objects, and
// gives the same bits. twin::hierarchy builds the hierarchy: a list of dominant objects, which every ray
// intersects, and a tree of boxes over all others. A box is enlarged for each ray, so that it contains every point that
// the formulas may report for this ray.
//
// The nodes of the tree are in depth-first order. Each knows where to go on if the ray misses its box, so the traversal
// needs no stack. A parent's child that is nearer to the camera comes first.

// twin::hierarchy::Node
struct HierarchyNode {
    low_x: f32,
    low_y: f32,
    low_z: f32,
    high_x: f32,
    high_y: f32,
    high_z: f32,
    // An object of the box may seem enlarged by at most `linear` times the distance, and by at most `bend` times the
    // square of the distance. twin::hierarchy::margins derives both.
    linear: f32,
    bend: f32,
    // The index of the first node that is not below this one.
    next: u32,
    // NO_OBJECT, or twice the index of a sphere, or twice the index of a cylinder plus one.
    object: u32,
}

const NO_OBJECT: u32 = 0xffffffffu;

struct Hierarchy {
    // A point is wrong by at most this factor of distances and coordinates.
    point: f32,
    // The largest coordinate of an origin for which boxes are tested. It is 0 in a scene of extreme magnitudes.
    largest: f32,
    // For each axis, the distance in scene units by which every plane is moved outwards for the planes' own rounding.
    step_x: f32,
    step_y: f32,
    step_z: f32,
    node_count: u32,
    // The first nodes are of objects much larger than all others. Their boxes are not tested.
    dominant_count: u32,
    nodes: array<HierarchyNode>,
}

@group(0) @binding(8) var<storage, read> hierarchy: Hierarchy;

// Let u = 2^-24. The distance of the plane at `p` is computed in f32 as `p r - o r`. WGSL allows a relative error of
// 5 u in the reciprocal `r`. Rounding the direction and the origin to f32, the products and the difference add at most
// 4 u of `|p r|` and 5 u of `|o r|`; one u of `|p r|` is the margin, which may vanish in the sum with the plane. So the
// computed distance is wrong by at most `(9 |p| + 10 |o|) u |r|`. It is moved outwards by 32 u of `(|p| + |o|) |r|`,
// where `p` is the farthest plane of the tree along the axis.
const STEP: f32 = 1.9073486e-6;
// The largest reciprocal. For a smaller component of the direction, LEAST_STEP of twin::hierarchy moves the planes
// by a lambda of 10^18, which is beyond every plane across the largest component.
const LARGEST_RECIPROCAL: f32 = 1e28;
// Largest number of visited nodes in all calls of a run. lavapipe ends loops silently after 65,535 iterations of all
// loops together, and the rest is for the other loops (gpu_check::ray_loop).
const MOST_VISITS: u32 = 60000u;
// Largest number of objects over which a ray may loop instead. So few objects have fewer nodes than MOST_VISITS, less
// their own number.
const MOST_OBJECTS: u32 = 20000u;

// The number of nodes that this invocation has visited so far.
var<private> hierarchy_visits: u32;

// Returns the reciprocal of a component of the direction, limited to LARGEST_RECIPROCAL.
fn hierarchy_reciprocal(component: f32) -> f32 {
    let magnitude = abs(component);
    var reciprocal = LARGEST_RECIPROCAL;
    if 1e-28 < magnitude {
        reciprocal = 1.0 / magnitude;
    }
    return select(reciprocal, -reciprocal, component < 0.0);
}

// A ray prepared for boxes. The distance of a plane along an axis is the plane times `reciprocal` minus `near_origin`
// or `far_origin`, so that no error can make a box smaller.
struct BoxRay {
    origin: vec3<f32>,
    farthest_origin: f32,
    reciprocal: vec3<f32>,
    near_origin: vec3<f32>,
    far_origin: vec3<f32>,
    is_backwards: vec3<bool>,
    // Whether boxes can be tested. A direction may be too short or too long for f32, and a ray may start far away.
    has_boxes: bool,
}

fn hierarchy_box_ray(ray: Ray) -> BoxRay {
    let direction = vec3<f32>(ray.direction);
    let origin = vec3<f32>(ray.origin);
    let x = hierarchy_reciprocal(direction.x);
    let y = hierarchy_reciprocal(direction.y);
    let z = hierarchy_reciprocal(direction.z);
    let reciprocal = vec3<f32>(x, y, z);
    let steps = (abs(origin) * STEP + vec3<f32>(hierarchy.step_x, hierarchy.step_y, hierarchy.step_z)) * abs(reciprocal);
    let longest = max(max(abs(direction.x), abs(direction.y)), abs(direction.z));
    let farthest = max(max(abs(origin.x), abs(origin.y)), abs(origin.z));
    let has_boxes = 1e-7 < longest && longest < 1e9 && farthest < hierarchy.largest;
    let near_origin = origin * reciprocal + steps;
    let far_origin = origin * reciprocal - steps;
    return BoxRay(origin, farthest, reciprocal, near_origin, far_origin, direction < vec3<f32>(), has_boxes);
}

// Returns the distance by which the box of `node` is enlarged for the ray.
fn hierarchy_margin(ray: BoxRay, node: HierarchyNode) -> f32 {
    let low = vec3<f32>(node.low_x, node.low_y, node.low_z);
    let high = vec3<f32>(node.high_x, node.high_y, node.high_z);
    let off = max(abs(low - ray.origin), abs(high - ray.origin));
    let square = off.x * off.x + off.y * off.y + off.z * off.z;
    let distance = sqrt(square);
    let enlarged = min(node.linear * distance, node.bend * square);
    return enlarged + hierarchy.point * (distance + distance + ray.farthest_origin);
}

// Whether the ray may hit an object of `node` up to the lambda `farthest`.
fn hierarchy_may_hit(ray: BoxRay, node: HierarchyNode, farthest: f32) -> bool {
    let margin = hierarchy_margin(ray, node);
    let low = vec3<f32>(node.low_x, node.low_y, node.low_z) - margin;
    let high = vec3<f32>(node.high_x, node.high_y, node.high_z) + margin;
    let near = select(low, high, ray.is_backwards) * ray.reciprocal - ray.near_origin;
    let far = select(high, low, ray.is_backwards) * ray.reciprocal - ray.far_origin;
    let enters = max(max(near.x, near.y), max(near.z, 0.0));
    let leaves = min(min(far.x, far.y), min(far.z, farthest));
    // The comparison fails for NaN, and then the box is not discarded.
    return !(leaves < enters);
}

// Whether a loop over all objects is faster than the hierarchy, because the ray can discard hardly any box: its margin
// is larger than the box around all objects in the tree. In f32 this happens to rays that start far from small objects.
fn hierarchy_is_useless(ray: BoxRay) -> bool {
    if MOST_OBJECTS < picture.sphere_count + picture.cylinder_count {
        return false;
    }
    if !ray.has_boxes || hierarchy.dominant_count == hierarchy.node_count {
        return true;
    }
    let root = hierarchy.nodes[hierarchy.dominant_count];
    let size = max(max(root.high_x - root.low_x, root.high_y - root.low_y), root.high_z - root.low_z);
    return size < hierarchy_margin(ray, root);
}

// Returns the surface at the closest hit of the ray, found by the hierarchy.
fn closest_hit(ray: Ray) -> SurfaceHit {
    var closest: ClosestHit;
    let box_ray = hierarchy_box_ray(ray);
    if hierarchy_is_useless(box_ray) {
        return surface_at(intersect_every_object(ray), ray);
    }
    // The closest lambda so far, rounded up.
    var farthest = 3e38f;
    var at = 0u;
    while at < hierarchy.node_count && hierarchy_visits < MOST_VISITS {
        hierarchy_visits++;
        let node = hierarchy.nodes[at];
        if hierarchy.dominant_count <= at && box_ray.has_boxes && !hierarchy_may_hit(box_ray, node, farthest) {
            at = node.next;
            continue;
        }
        at++;
        if node.object != NO_OBJECT {
            let index = node.object / 2u;
            if has_cylinders && node.object % 2u == 1u {
                closest = intersect_cylinder(closest, ray, index);
            }
            if has_spheres && node.object % 2u == 0u {
                closest = intersect_sphere(closest, ray, index);
            }
            if closest.some && closest.lambda < real(1e30) {
                farthest = f32(closest.lambda) * 1.0000002;
            }
        }
    }
    closest_hit_gave_up = closest_hit_gave_up || at < hierarchy.node_count;
    return surface_at(closest, ray);
}
