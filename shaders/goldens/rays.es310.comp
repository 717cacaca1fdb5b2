#version 310 es

precision highp float;
precision highp int;

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

struct Ray {
    vec3 origin;
    vec3 direction;
};
struct Root {
    bool some;
    float lambda;
};
struct Hit {
    vec3 point;
    vec3 normal;
    bool front;
};
struct SphereRecord {
    vec3 center;
    float radius;
    float radius_squared;
};
struct SphereView {
    vec3 r_c;
    float c;
};
struct SphereQuadratic {
    float h;
    float discriminant;
};
struct CylinderRecord {
    vec3 center;
    vec3 axis;
    vec3 top;
    vec3 bottom;
    float radius;
    float radius_squared;
    float half_height;
};
struct CylinderView {
    vec3 r_c;
    float c;
};
struct CylinderQuadratic {
    float a;
    float h;
    float discriminant;
};
struct CylinderRoot {
    bool some;
    float lambda;
    uint part;
};
struct PackedVec3_ {
    float x;
    float y;
    float z;
};
struct PackedRay {
    PackedVec3_ origin;
    PackedVec3_ direction;
};
struct PlacedSphere {
    PackedVec3_ center;
    float radius;
    uint order;
    uint material;
};
struct PlacedCylinder {
    PackedVec3_ center;
    PackedVec3_ axis;
    float radius;
    float half_height;
    uint order;
    uint material;
};
struct PackedCamera {
    PackedVec3_ position;
    PackedVec3_ origin;
    PackedVec3_ delta_x;
    PackedVec3_ delta_y;
};
struct PackedBackground {
    PackedVec3_ dark;
    PackedVec3_ light;
};
struct Picture {
    PackedCamera camera;
    PackedBackground background;
    float offset_x;
    float offset_y;
    PackedVec3_ scatter_vector;
    uint width;
    uint first_pixel;
    uint pixel_count;
    uint sphere_count;
    uint cylinder_count;
    uint first_depth;
    uint end_depth;
    uint sample_count;
    uint first_sample;
    uint samples_per_pixel;
    uint convention;
    uint unused;
};
struct ClosestHit {
    bool some;
    float lambda;
    uint order;
    bool is_cylinder;
    uint index;
    uint part;
};
struct SurfaceHit {
    bool some;
    Hit hit;
    uint material;
    float lambda;
    uint order;
    uint part;
};
struct PackedPath {
    PackedRay ray;
    uint attenuation_count;
    uint ended;
};
const float SHORT_SQUARED = 0.0;
const float SHORT_SCALE = 1.0;
const float BELOW_ONE = 0.99999994;
const float LEAST_SQUARED = 0.0;
const float ERROR_UNDERFLOW = 0.0;
const float ERROR_OVERFLOW = 3e38;
const float SHORTEST_SQUARED = 0.0;
const float LONGEST_SQUARED = 3e38;
const float EXTENT_UNDERFLOW = 0.0;
const float SPLITTER = 4097.0;
const float SPLIT_LIMIT = 1e33;
const float SPLIT_SCALE = 1.5258789e-5;
const float SPLIT_UNSCALE = 65536.0;
const float UNWRITTEN = -2.8735182e-16;
const uint SIDE = 0u;
const uint TOP = 1u;
const uint BOTTOM = 2u;
const uint MATTE = 0u;
const uint METAL = 1u;
const uint REFRACTIVE = 2u;
const bool has_spheres = true;
const bool has_cylinders = true;

layout(std430, binding = 0) readonly buffer Picture_block_0Compute { Picture _group_0_binding_0_cs; };

layout(std430, binding = 1) readonly buffer type_4_block_1Compute { PlacedSphere _group_0_binding_1_cs[]; };

layout(std430, binding = 2) readonly buffer type_5_block_2Compute { PlacedCylinder _group_0_binding_2_cs[]; };

bool closest_hit_gave_up = false;

layout(std430, binding = 5) buffer type_6_block_3Compute { PackedVec3_ _group_0_binding_5_cs[]; };

layout(std430, binding = 6) buffer type_7_block_4Compute { PackedPath _group_0_binding_6_cs[]; };


float vec3_dot(vec3 a, vec3 b) {
    return (((a.x * b.x) + (a.y * b.y)) + (a.z * b.z));
}

float vec3_length(vec3 v) {
    float _e1 = vec3_dot(v, v);
    return sqrt(_e1);
}

vec3 vec3_perpendicular_to(vec3 v_1, vec3 axis) {
    float _e2 = vec3_dot(v_1, axis);
    return (v_1 - (axis * _e2));
}

vec3 ray_at(Ray ray, float lambda) {
    return (ray.origin + (ray.direction * lambda));
}

bool in_range(float lambda_1) {
    return (0.001 <= lambda_1);
}

Hit hit_facing(vec3 direction, vec3 point, vec3 outward) {
    float _e3 = vec3_dot(direction, outward);
    bool front = (_e3 < 0.0);
    return Hit(point, (front ? outward : -(outward)), front);
}

SphereRecord sphere_new(vec3 center, float radius) {
    return SphereRecord(center, radius, (radius * radius));
}

SphereView sphere_seen_from(SphereRecord sphere, vec3 origin) {
    vec3 r_c = (sphere.center - origin);
    float _e4 = vec3_dot(r_c, r_c);
    return SphereView(r_c, (_e4 - sphere.radius_squared));
}

SphereQuadratic sphere_quadratic(SphereView view, vec3 direction_1, float a_1) {
    float _e4 = vec3_dot(direction_1, view.r_c);
    return SphereQuadratic(_e4, ((_e4 * _e4) - (a_1 * view.c)));
}

Root sphere_first_root(float a_2, float h, float discriminant) {
    float root = sqrt(discriminant);
    float near = ((h - root) / a_2);
    float far = ((h + root) / a_2);
    bool _e8 = in_range(near);
    float lambda_6 = (_e8 ? near : far);
    bool _e10 = in_range(lambda_6);
    return Root(_e10, lambda_6);
}

vec3 sphere_outward(SphereRecord sphere_1, vec3 point_1) {
    return ((point_1 - sphere_1.center) / vec3(sphere_1.radius));
}

Root sphere_intersect(SphereRecord sphere_2, Ray ray_1) {
    float _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    SphereView _e6 = sphere_seen_from(sphere_2, ray_1.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
    Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    return Root((!((_e8.discriminant < 0.0)) && _e11.some), _e11.lambda);
}

bool tie_later_cap_is_closer(float lambda_2, float closest) {
    return (lambda_2 < closest);
}

int tie_rank(uint order, bool on_cap) {
    return (on_cap ? (-1 - int(order)) : int(order));
}

bool tie_is_closer(float lambda_3, int rank, float closest_1, int closest_rank) {
    return ((lambda_3 < closest_1) || ((lambda_3 <= closest_1) && (rank >= closest_rank)));
}

CylinderRecord cylinder_with_unit_axis(vec3 center_1, float radius_1, vec3 axis_1, float half_height) {
    vec3 to_cap = (axis_1 * half_height);
    return CylinderRecord(center_1, axis_1, (center_1 + to_cap), (center_1 - to_cap), radius_1, (radius_1 * radius_1), half_height);
}

CylinderView cylinder_seen_from(CylinderRecord cylinder, vec3 origin_1) {
    vec3 _e5 = vec3_perpendicular_to((origin_1 - cylinder.center), cylinder.axis);
    float _e6 = vec3_dot(_e5, _e5);
    return CylinderView(_e5, (_e6 - cylinder.radius_squared));
}

CylinderQuadratic cylinder_quadratic(CylinderRecord cylinder_1, CylinderView view_1, vec3 along) {
    vec3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    float _e5 = vec3_dot(_e4, _e4);
    float _e7 = vec3_dot(view_1.r_c, _e4);
    return CylinderQuadratic(_e5, _e7, ((_e7 * _e7) - (_e5 * view_1.c)));
}

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_2, float lambda_4) {
    vec3 _e3 = ray_at(ray_2, lambda_4);
    float _e7 = vec3_dot((_e3 - cylinder_2.center), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

Root cylinder_side(CylinderRecord cylinder_3, Ray ray_3, CylinderQuadratic quadratic) {
    float root_1 = sqrt(quadratic.discriminant);
    float near_1 = ((-(quadratic.h) - root_1) / quadratic.a);
    float far_1 = ((-(quadratic.h) + root_1) / quadratic.a);
    bool _e15 = in_range(near_1);
    bool _e16 = cylinder_within_height(cylinder_3, ray_3, near_1);
    bool near_counts = (_e15 && _e16);
    bool _e18 = in_range(far_1);
    bool _e19 = cylinder_within_height(cylinder_3, ray_3, far_1);
    bool far_counts = (_e18 && _e19);
    return Root((near_counts || far_counts), (near_counts ? near_1 : far_1));
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_4, vec3 center_2) {
    float _e5 = vec3_dot(ray_4.direction, cylinder_4.axis);
    float _e9 = vec3_dot((center_2 - ray_4.origin), cylinder_4.axis);
    float lambda_7 = (_e9 / _e5);
    vec3 _e11 = ray_at(ray_4, lambda_7);
    float _e13 = vec3_length((_e11 - center_2));
    bool on_disc = (_e13 <= cylinder_4.radius);
    bool _e20 = in_range(lambda_7);
    return Root(((!((abs(_e5) < 1e-8)) && _e20) && on_disc), lambda_7);
}

vec3 cylinder_outward(CylinderRecord cylinder_5, uint part, vec3 point_2) {
    vec3 _e6 = vec3_perpendicular_to((point_2 - cylinder_5.center), cylinder_5.axis);
    vec3 cap = ((part == TOP) ? cylinder_5.axis : -(cylinder_5.axis));
    return ((part == SIDE) ? _e6 : cap);
}

CylinderRoot cylinder_closer(CylinderRoot closest_2, Root later, uint part_1) {
    bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = (later.some && (!(closest_2.some) || _e8));
    float lambda_8 = (replaces ? later.lambda : closest_2.lambda);
    return CylinderRoot((closest_2.some || later.some), lambda_8, (replaces ? part_1 : closest_2.part));
}

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_6, Ray ray_5, Root side) {
    Root _e4 = cylinder_cap(cylinder_6, ray_5, cylinder_6.top);
    Root _e6 = cylinder_cap(cylinder_6, ray_5, cylinder_6.bottom);
    CylinderRoot _e12 = cylinder_closer(CylinderRoot(side.some, side.lambda, SIDE), _e4, TOP);
    CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    return _e14;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_7, Ray ray_6) {
    CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_6.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_6.direction);
    Root _e6 = cylinder_side(cylinder_7, ray_6, _e5);
    bool some = (!((_e5.discriminant < 0.0)) && _e6.some);
    CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_6, Root(some, _e6.lambda));
    return _e15;
}

vec3 vec3_load(PackedVec3_ v_2) {
    return vec3(v_2.x, v_2.y, v_2.z);
}

PackedVec3_ vec3_store(vec3 v_3) {
    return PackedVec3_(v_3.x, v_3.y, v_3.z);
}

Ray ray_load(PackedRay ray_7) {
    vec3 _e2 = vec3_load(ray_7.origin);
    vec3 _e4 = vec3_load(ray_7.direction);
    return Ray(_e2, _e4);
}

SphereRecord sphere_load(PlacedSphere sphere_3) {
    vec3 _e2 = vec3_load(sphere_3.center);
    SphereRecord _e4 = sphere_new(_e2, sphere_3.radius);
    return _e4;
}

CylinderRecord cylinder_load(PlacedCylinder cylinder_8) {
    vec3 _e2 = vec3_load(cylinder_8.axis);
    vec3 _e4 = vec3_load(cylinder_8.center);
    CylinderRecord _e7 = cylinder_with_unit_axis(_e4, cylinder_8.radius, _e2, cylinder_8.half_height);
    return _e7;
}

bool is_closer(ClosestHit closest_3, float lambda_5, uint order_1, uint part_2) {
    int _e8 = tie_rank(closest_3.order, (closest_3.part != SIDE));
    int _e11 = tie_rank(order_1, (part_2 != SIDE));
    bool _e15 = tie_is_closer(lambda_5, _e11, closest_3.lambda, _e8);
    return (!(closest_3.some) || _e15);
}

ClosestHit intersect_sphere(ClosestHit closest_4, Ray ray_8, uint index) {
    ClosestHit result = ClosestHit(false, 0.0, 0u, false, 0u, 0u);
    PlacedSphere placed = _group_0_binding_1_cs[index];
    SphereRecord _e6 = sphere_load(placed);
    Root _e7 = sphere_intersect(_e6, ray_8);
    uint order_2 = placed.order;
    result = closest_4;
    bool _e13 = is_closer(closest_4, _e7.lambda, order_2, SIDE);
    if ((_e7.some && _e13)) {
        result = ClosestHit(true, _e7.lambda, order_2, false, index, SIDE);
    }
    ClosestHit _e20 = result;
    return _e20;
}

ClosestHit intersect_cylinder(ClosestHit closest_5, Ray ray_9, uint index_1) {
    ClosestHit result_1 = ClosestHit(false, 0.0, 0u, false, 0u, 0u);
    PlacedCylinder placed_1 = _group_0_binding_2_cs[index_1];
    CylinderRecord _e6 = cylinder_load(placed_1);
    CylinderRoot _e7 = cylinder_intersect(_e6, ray_9);
    uint order_3 = placed_1.order;
    result_1 = closest_5;
    bool _e13 = is_closer(closest_5, _e7.lambda, order_3, _e7.part);
    if ((_e7.some && _e13)) {
        result_1 = ClosestHit(true, _e7.lambda, order_3, true, index_1, _e7.part);
    }
    ClosestHit _e20 = result_1;
    return _e20;
}

SurfaceHit surface_at(ClosestHit closest_6, Ray ray_10) {
    vec3 outward_1 = vec3(0.0);
    uint material = 0u;
    bool local = false;
    bool local_1 = false;
    vec3 _e3 = ray_at(ray_10, closest_6.lambda);
    if (has_spheres) {
        local = !(closest_6.is_cylinder);
    } else {
        local = false;
    }
    bool _e12 = local;
    if (_e12) {
        PlacedSphere _e16 = _group_0_binding_1_cs[closest_6.index];
        SphereRecord _e17 = sphere_load(_e16);
        vec3 _e18 = sphere_outward(_e17, _e3);
        outward_1 = _e18;
        uint _e23 = _group_0_binding_1_cs[closest_6.index].material;
        material = _e23;
    }
    if (has_cylinders) {
        local_1 = closest_6.is_cylinder;
    } else {
        local_1 = false;
    }
    bool _e29 = local_1;
    if (_e29) {
        PlacedCylinder _e33 = _group_0_binding_2_cs[closest_6.index];
        CylinderRecord _e34 = cylinder_load(_e33);
        vec3 _e36 = cylinder_outward(_e34, closest_6.part, _e3);
        outward_1 = _e36;
        uint _e41 = _group_0_binding_2_cs[closest_6.index].material;
        material = _e41;
    }
    vec3 _e43 = outward_1;
    Hit _e44 = hit_facing(ray_10.direction, _e3, _e43);
    uint _e46 = material;
    return SurfaceHit(closest_6.some, _e44, _e46, closest_6.lambda, closest_6.order, closest_6.part);
}

ClosestHit intersect_every_object(Ray ray_11) {
    ClosestHit closest_7 = ClosestHit(false, 0.0, 0u, false, 0u, 0u);
    uint index_2 = 0u;
    uint index_3 = 0u;
    if (has_spheres) {
        bool loop_init = true;
        while(true) {
            if (!loop_init) {
                uint _e14 = index_2;
                index_2 = (_e14 + 1u);
            }
            loop_init = false;
            uint _e5 = index_2;
            uint _e8 = _group_0_binding_0_cs.sphere_count;
            if ((_e5 < _e8)) {
            } else {
                break;
            }
            {
                ClosestHit _e10 = closest_7;
                uint _e11 = index_2;
                ClosestHit _e12 = intersect_sphere(_e10, ray_11, _e11);
                closest_7 = _e12;
            }
        }
    }
    if (has_cylinders) {
        bool loop_init_1 = true;
        while(true) {
            if (!loop_init_1) {
                uint _e28 = index_3;
                index_3 = (_e28 + 1u);
            }
            loop_init_1 = false;
            uint _e19 = index_3;
            uint _e22 = _group_0_binding_0_cs.cylinder_count;
            if ((_e19 < _e22)) {
            } else {
                break;
            }
            {
                ClosestHit _e24 = closest_7;
                uint _e25 = index_3;
                ClosestHit _e26 = intersect_cylinder(_e24, ray_11, _e25);
                closest_7 = _e26;
            }
        }
    }
    ClosestHit _e30 = closest_7;
    return _e30;
}

SurfaceHit closest_hit(Ray ray_12) {
    ClosestHit _e1 = intersect_every_object(ray_12);
    SurfaceHit _e2 = surface_at(_e1, ray_12);
    return _e2;
}

void main() {
    uvec3 id = gl_GlobalInvocationID;
    vec3 report = vec3(-1.0);
    uint _e4 = _group_0_binding_0_cs.pixel_count;
    if ((id.x >= _e4)) {
        return;
    }
    PackedRay _e10 = _group_0_binding_6_cs[id.x].ray;
    Ray _e11 = ray_load(_e10);
    SurfaceHit _e12 = closest_hit(_e11);
    if (_e12.some) {
        report = vec3(_e12.lambda, float(_e12.order), float(_e12.part));
    }
    bool _e24 = closest_hit_gave_up;
    if (_e24) {
        report = vec3(-2.8735182e-16);
    }
    vec3 _e30 = report;
    PackedVec3_ _e31 = vec3_store(_e30);
    _group_0_binding_5_cs[id.x] = _e31;
    return;
}

