#version 430 core
#extension GL_ARB_compute_shader : require
#extension GL_ARB_shader_storage_buffer_object : require
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
struct UnitAndLength {
    vec3 direction;
    float length_;
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
struct TracedSample {
    PackedVec3_ color;
    uint words;
    uint unused;
};
struct HitReport {
    float some;
    float lambda;
    float part;
    float front;
    PackedVec3_ point;
    PackedVec3_ normal;
};
struct CylinderCase {
    PackedRay ray;
    PackedVec3_ center;
    float radius;
    PackedVec3_ axis;
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

layout(std430, binding = 0) readonly buffer type_4_block_0Compute { CylinderCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_5_block_1Compute { HitReport _group_0_binding_1_cs[]; };


float vec3_dot(vec3 a, vec3 b) {
    return (((a.x * b.x) + (a.y * b.y)) + (a.z * b.z));
}

float vec3_length(vec3 v) {
    float _e1 = vec3_dot(v, v);
    return sqrt(_e1);
}

vec3 vec3_unit(vec3 v_1) {
    float _e1 = vec3_length(v_1);
    return (v_1 / vec3(_e1));
}

vec3 vec3_perpendicular_to(vec3 v_2, vec3 axis) {
    float _e2 = vec3_dot(v_2, axis);
    return (v_2 - (axis * _e2));
}

bool vec3_is_negligible(vec3 v_3) {
    return (((abs(v_3.x) < 1e-8) && (abs(v_3.y) < 1e-8)) && (abs(v_3.z) < 1e-8));
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

UnitAndLength vec3_unit_and_length(vec3 v_4) {
    float _e1 = vec3_dot(v_4, v_4);
    if ((_e1 < SHORT_SQUARED)) {
        vec3 scaled = (v_4 * SHORT_SCALE);
        float _e6 = vec3_length(scaled);
        return UnitAndLength((scaled / vec3(_e6)), (_e6 * SHORT_SQUARED));
    }
    float _e12 = vec3_length(v_4);
    return UnitAndLength((v_4 / vec3(_e12)), _e12);
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

CylinderRecord cylinder_with_unit_axis(vec3 center, float radius, vec3 axis_1, float half_height) {
    vec3 to_cap = (axis_1 * half_height);
    return CylinderRecord(center, axis_1, (center + to_cap), (center - to_cap), radius, (radius * radius), half_height);
}

CylinderRecord cylinder_new(vec3 center_1, float radius_1, vec3 axis_2) {
    UnitAndLength _e3 = vec3_unit_and_length(axis_2);
    CylinderRecord _e8 = cylinder_with_unit_axis(center_1, radius_1, _e3.direction, (_e3.length_ / 2.0));
    return _e8;
}

CylinderView cylinder_seen_from(CylinderRecord cylinder_1, vec3 origin) {
    vec3 _e5 = vec3_perpendicular_to((origin - cylinder_1.center), cylinder_1.axis);
    float _e6 = vec3_dot(_e5, _e5);
    return CylinderView(_e5, (_e6 - cylinder_1.radius_squared));
}

CylinderQuadratic cylinder_quadratic(CylinderRecord cylinder_2, CylinderView view, vec3 along) {
    vec3 _e4 = vec3_perpendicular_to(along, cylinder_2.axis);
    float _e5 = vec3_dot(_e4, _e4);
    float _e7 = vec3_dot(view.r_c, _e4);
    return CylinderQuadratic(_e5, _e7, ((_e7 * _e7) - (_e5 * view.c)));
}

bool cylinder_within_height(CylinderRecord cylinder_3, Ray ray_1, float lambda_4) {
    vec3 _e3 = ray_at(ray_1, lambda_4);
    float _e7 = vec3_dot((_e3 - cylinder_3.center), cylinder_3.axis);
    return (abs(_e7) <= cylinder_3.half_height);
}

Root cylinder_side(CylinderRecord cylinder_4, Ray ray_2, CylinderQuadratic quadratic) {
    float root = sqrt(quadratic.discriminant);
    float near = ((-(quadratic.h) - root) / quadratic.a);
    float far = ((-(quadratic.h) + root) / quadratic.a);
    bool _e15 = in_range(near);
    bool _e16 = cylinder_within_height(cylinder_4, ray_2, near);
    bool near_counts = (_e15 && _e16);
    bool _e18 = in_range(far);
    bool _e19 = cylinder_within_height(cylinder_4, ray_2, far);
    bool far_counts = (_e18 && _e19);
    return Root((near_counts || far_counts), (near_counts ? near : far));
}

Root cylinder_cap(CylinderRecord cylinder_5, Ray ray_3, vec3 center_2) {
    float _e5 = vec3_dot(ray_3.direction, cylinder_5.axis);
    float _e9 = vec3_dot((center_2 - ray_3.origin), cylinder_5.axis);
    float lambda_6 = (_e9 / _e5);
    vec3 _e11 = ray_at(ray_3, lambda_6);
    float _e13 = vec3_length((_e11 - center_2));
    bool on_disc = (_e13 <= cylinder_5.radius);
    bool _e20 = in_range(lambda_6);
    return Root(((!((abs(_e5) < 1e-8)) && _e20) && on_disc), lambda_6);
}

vec3 cylinder_outward(CylinderRecord cylinder_6, uint part, vec3 point_1) {
    vec3 _e6 = vec3_perpendicular_to((point_1 - cylinder_6.center), cylinder_6.axis);
    vec3 cap = ((part == TOP) ? cylinder_6.axis : -(cylinder_6.axis));
    return ((part == SIDE) ? _e6 : cap);
}

CylinderRoot cylinder_closer(CylinderRoot closest_2, Root later, uint part_1) {
    bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = (later.some && (!(closest_2.some) || _e8));
    float lambda_7 = (replaces ? later.lambda : closest_2.lambda);
    return CylinderRoot((closest_2.some || later.some), lambda_7, (replaces ? part_1 : closest_2.part));
}

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_7, Ray ray_4, Root side) {
    Root _e4 = cylinder_cap(cylinder_7, ray_4, cylinder_7.top);
    Root _e6 = cylinder_cap(cylinder_7, ray_4, cylinder_7.bottom);
    CylinderRoot _e12 = cylinder_closer(CylinderRoot(side.some, side.lambda, SIDE), _e4, TOP);
    CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    return _e14;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_8, Ray ray_5) {
    CylinderView _e3 = cylinder_seen_from(cylinder_8, ray_5.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_8, _e3, ray_5.direction);
    Root _e6 = cylinder_side(cylinder_8, ray_5, _e5);
    bool some = (!((_e5.discriminant < 0.0)) && _e6.some);
    CylinderRoot _e15 = cylinder_with_caps(cylinder_8, ray_5, Root(some, _e6.lambda));
    return _e15;
}

vec3 vec3_load(PackedVec3_ v_5) {
    return vec3(v_5.x, v_5.y, v_5.z);
}

PackedVec3_ vec3_store(vec3 v_6) {
    return PackedVec3_(v_6.x, v_6.y, v_6.z);
}

Ray ray_load(PackedRay ray_6) {
    vec3 _e2 = vec3_load(ray_6.origin);
    vec3 _e4 = vec3_load(ray_6.direction);
    return Ray(_e2, _e4);
}

PackedRay ray_store(Ray ray_7) {
    PackedVec3_ _e2 = vec3_store(ray_7.origin);
    PackedVec3_ _e4 = vec3_store(ray_7.direction);
    return PackedRay(_e2, _e4);
}

HitReport hit_report_none() {
    PackedVec3_ _e1 = vec3_store(vec3(0.0));
    return HitReport(0.0, 0.0, 0.0, 0.0, _e1, _e1);
}

HitReport hit_report(float lambda_5, uint part_2, Hit hit) {
    float front_1 = (hit.front ? 1.0 : 0.0);
    PackedVec3_ _e10 = vec3_store(hit.point);
    PackedVec3_ _e12 = vec3_store(hit.normal);
    return HitReport(1.0, lambda_5, float(part_2), front_1, _e10, _e12);
}

void main() {
    uvec3 id = gl_GlobalInvocationID;
    if ((id.x >= uint(_group_0_binding_0_cs.length()))) {
        return;
    }
    PackedRay _e9 = _group_0_binding_0_cs[id.x].ray;
    Ray _e10 = ray_load(_e9);
    PackedVec3_ _e15 = _group_0_binding_0_cs[id.x].center;
    vec3 _e16 = vec3_load(_e15);
    float _e21 = _group_0_binding_0_cs[id.x].radius;
    PackedVec3_ _e26 = _group_0_binding_0_cs[id.x].axis;
    vec3 _e27 = vec3_load(_e26);
    CylinderRecord _e28 = cylinder_new(_e16, _e21, _e27);
    CylinderRoot _e29 = cylinder_intersect(_e28, _e10);
    if (!(_e29.some)) {
        HitReport _e35 = hit_report_none();
        _group_0_binding_1_cs[id.x] = _e35;
        return;
    }
    vec3 _e37 = ray_at(_e10, _e29.lambda);
    vec3 _e40 = cylinder_outward(_e28, _e29.part, _e37);
    Hit _e41 = hit_facing(_e10.direction, _e37, _e40);
    HitReport _e47 = hit_report(_e29.lambda, _e29.part, _e41);
    _group_0_binding_1_cs[id.x] = _e47;
    return;
}

