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
struct SphereCase {
    PackedRay ray;
    PackedVec3_ center;
    float radius;
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

layout(std430, binding = 0) readonly buffer type_3_block_0Compute { SphereCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_4_block_1Compute { HitReport _group_0_binding_1_cs[]; };


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

SphereRecord sphere_new(vec3 center, float radius) {
    return SphereRecord(center, radius, (radius * radius));
}

SphereView sphere_seen_from(SphereRecord sphere_1, vec3 origin) {
    vec3 r_c = (sphere_1.center - origin);
    float _e4 = vec3_dot(r_c, r_c);
    return SphereView(r_c, (_e4 - sphere_1.radius_squared));
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
    float lambda_3 = (_e8 ? near : far);
    bool _e10 = in_range(lambda_3);
    return Root(_e10, lambda_3);
}

vec3 sphere_outward(SphereRecord sphere_2, vec3 point_1) {
    return ((point_1 - sphere_2.center) / vec3(sphere_2.radius));
}

Root sphere_intersect(SphereRecord sphere_3, Ray ray_1) {
    float _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    SphereView _e6 = sphere_seen_from(sphere_3, ray_1.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
    Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    return Root((!((_e8.discriminant < 0.0)) && _e11.some), _e11.lambda);
}

vec3 vec3_load(PackedVec3_ v_4) {
    return vec3(v_4.x, v_4.y, v_4.z);
}

PackedVec3_ vec3_store(vec3 v_5) {
    return PackedVec3_(v_5.x, v_5.y, v_5.z);
}

Ray ray_load(PackedRay ray_2) {
    vec3 _e2 = vec3_load(ray_2.origin);
    vec3 _e4 = vec3_load(ray_2.direction);
    return Ray(_e2, _e4);
}

PackedRay ray_store(Ray ray_3) {
    PackedVec3_ _e2 = vec3_store(ray_3.origin);
    PackedVec3_ _e4 = vec3_store(ray_3.direction);
    return PackedRay(_e2, _e4);
}

HitReport hit_report_none() {
    PackedVec3_ _e1 = vec3_store(vec3(0.0));
    return HitReport(0.0, 0.0, 0.0, 0.0, _e1, _e1);
}

HitReport hit_report(float lambda_2, uint part, Hit hit) {
    float front_1 = (hit.front ? 1.0 : 0.0);
    PackedVec3_ _e10 = vec3_store(hit.point);
    PackedVec3_ _e12 = vec3_store(hit.normal);
    return HitReport(1.0, lambda_2, float(part), front_1, _e10, _e12);
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
    SphereRecord _e22 = sphere_new(_e16, _e21);
    Root _e23 = sphere_intersect(_e22, _e10);
    if (!(_e23.some)) {
        HitReport _e29 = hit_report_none();
        _group_0_binding_1_cs[id.x] = _e29;
        return;
    }
    vec3 _e31 = ray_at(_e10, _e23.lambda);
    vec3 _e33 = sphere_outward(_e22, _e31);
    Hit _e34 = hit_facing(_e10.direction, _e31, _e33);
    HitReport _e40 = hit_report(_e23.lambda, 0u, _e34);
    _group_0_binding_1_cs[id.x] = _e40;
    return;
}

