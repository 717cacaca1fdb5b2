// Ray against closed cylinder; twin of cpu/src/cylinder.rs, which has the equations.

// CylinderRecord: a cylinder with what its rays need computed once.
struct CylinderRecord {
    center: vec3<real>,
    axis: vec3<real>,
    top: vec3<real>,
    bottom: vec3<real>,
    radius: real,
    radius_squared: real,
    half_height: real,
}

// Part: the part of a cylinder that a ray meets.
const SIDE: u32 = 0u;
const TOP: u32 = 1u;
const BOTTOM: u32 = 2u;

// CylinderRecord::new: the cylinder whose `axis` is as long as it is high.
fn cylinder_new(center: vec3<real>, radius: real, axis: vec3<real>) -> CylinderRecord {
    let height = vec3_length(axis);
    let unit = axis / height;
    let half_height = height / real(2.0);
    let reach = unit * half_height;
    let top = center + reach;
    let bottom = center - reach;
    return CylinderRecord(center, unit, top, bottom, radius, radius * radius, half_height);
}

struct CylinderQuadratic {
    a: real,
    h: real,
    discriminant: real,
}

// CylinderRecord::quadratic: `a`, half of `b` and a quarter of the discriminant for the infinite cylinder.
fn cylinder_quadratic(cylinder: CylinderRecord, ray: Ray) -> CylinderQuadratic {
    let direction = vec3_perpendicular_to(ray.direction, cylinder.axis);
    let r_c = vec3_perpendicular_to(ray.origin - cylinder.center, cylinder.axis);
    let a = vec3_dot(direction, direction);
    let h = vec3_dot(r_c, direction);
    let c = vec3_dot(r_c, r_c) - cylinder.radius_squared;
    return CylinderQuadratic(a, h, h * h - a * c);
}

// CylinderRecord::within_height: whether the side's point at `lambda` lies between the bases.
fn cylinder_within_height(cylinder: CylinderRecord, ray: Ray, lambda: real) -> bool {
    return abs(vec3_dot(ray_at(ray, lambda) - cylinder.center, cylinder.axis)) <= cylinder.half_height;
}

struct PlaneMeeting {
    lambda: real,
    slope: real,
}

// CylinderRecord::plane: where the ray meets the plane through `base`, and the product of ray and axis.
fn cylinder_plane(cylinder: CylinderRecord, ray: Ray, base: vec3<real>) -> PlaneMeeting {
    let slope = vec3_dot(ray.direction, cylinder.axis);
    return PlaneMeeting(vec3_dot(base - ray.origin, cylinder.axis) / slope, slope);
}

// CylinderRecord::on_disc: whether the point at `lambda` lies on the disc around `base`.
fn cylinder_on_disc(cylinder: CylinderRecord, ray: Ray, base: vec3<real>, lambda: real) -> bool {
    return vec3_length(ray_at(ray, lambda) - base) <= cylinder.radius;
}

// CylinderRecord::outward: the normal at `point` that leaves `part`. The side's is as long as the radius.
fn cylinder_outward(cylinder: CylinderRecord, part: u32, point: vec3<real>) -> vec3<real> {
    switch part {
        case SIDE: {
            return vec3_perpendicular_to(point - cylinder.center, cylinder.axis);
        }
        case TOP: {
            return cylinder.axis;
        }
        default: {
            return -cylinder.axis;
        }
    }
}

// Option<(T, Part)>
struct CylinderRoot {
    some: bool,
    lambda: real,
    part: u32,
}

// CylinderRecord::intersect: the side, then the upper base, then the lower; of equals the later.
fn cylinder_intersect(cylinder: CylinderRecord, ray: Ray) -> CylinderRoot {
    let side = cylinder_side(cylinder, ray);
    var nearest = CylinderRoot(side.some, side.lambda, SIDE);
    let top = cylinder_base(cylinder, ray, cylinder.top);
    if top.some && (!nearest.some || top.lambda <= nearest.lambda) {
        nearest = CylinderRoot(true, top.lambda, TOP);
    }
    let bottom = cylinder_base(cylinder, ray, cylinder.bottom);
    if bottom.some && (!nearest.some || bottom.lambda <= nearest.lambda) {
        nearest = CylinderRoot(true, bottom.lambda, BOTTOM);
    }
    return nearest;
}

// CylinderRecord::side: the smaller root that is in range and between the bases, else the larger.
fn cylinder_side(cylinder: CylinderRecord, ray: Ray) -> Root {
    let quadratic = cylinder_quadratic(cylinder, ray);
    if quadratic.discriminant < real(0.0) {
        return root_none();
    }
    let root = sqrt(quadratic.discriminant);
    let near = (-quadratic.h - root) / quadratic.a;
    if in_range(near) && cylinder_within_height(cylinder, ray, near) {
        return Root(true, near);
    }
    let far = (-quadratic.h + root) / quadratic.a;
    return root_when(in_range(far) && cylinder_within_height(cylinder, ray, far), far);
}

// CylinderRecord::base: the disc around `base`; PARALLEL is 1e-8.
fn cylinder_base(cylinder: CylinderRecord, ray: Ray, base: vec3<real>) -> Root {
    let plane = cylinder_plane(cylinder, ray, base);
    if abs(plane.slope) < real(1e-8) {
        return root_none();
    }
    return root_when(in_range(plane.lambda) && cylinder_on_disc(cylinder, ray, base, plane.lambda), plane.lambda);
}
