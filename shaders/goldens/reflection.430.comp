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
struct ReflectionCase {
    PackedVec3_ direction;
    PackedVec3_ normal;
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

layout(std430, binding = 0) readonly buffer type_3_block_0Compute { ReflectionCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_4_block_1Compute { PackedVec3_ _group_0_binding_1_cs[]; };


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
    bool front_1 = (_e3 < 0.0);
    return Hit(point, (front_1 ? outward : -(outward)), front_1);
}

vec3 scatter_matte(vec3 normal, vec3 vector) {
    vec3 direction_5 = (normal + vector);
    bool _e3 = vec3_is_negligible(direction_5);
    return (_e3 ? normal : direction_5);
}

vec3 scatter_reflect(vec3 direction_1, vec3 normal_1) {
    float _e2 = vec3_dot(direction_1, normal_1);
    return (direction_1 - (normal_1 * (_e2 * 2.0)));
}

vec3 scatter_mirror(vec3 direction_2, vec3 normal_2) {
    vec3 _e2 = scatter_reflect(direction_2, normal_2);
    vec3 _e3 = vec3_unit(_e2);
    return _e3;
}

vec3 scatter_metal(vec3 direction_3, vec3 normal_3, vec3 vector_1) {
    vec3 _e3 = scatter_mirror(direction_3, normal_3);
    return (_e3 + vector_1);
}

float scatter_index_ratio(float index, bool front) {
    return (front ? (1.0 / index) : index);
}

vec3 scatter_refract(vec3 direction_4, vec3 normal_4, float ratio) {
    vec3 _e4 = vec3_unit(direction_4);
    float _e5 = vec3_dot(_e4, normal_4);
    float product = -(_e5);
    float cos_ = ((product < 1.0) ? product : 1.0);
    float sin_ = sqrt((1.0 - (cos_ * cos_)));
    vec3 _e12 = scatter_reflect(_e4, normal_4);
    vec3 p = ((_e4 + (normal_4 * cos_)) * ratio);
    float _e16 = vec3_dot(p, p);
    vec3 refracted = (p - (normal_4 * sqrt(abs((1.0 - _e16)))));
    bool beyond = (1.0 < (ratio * sin_));
    return (beyond ? _e12 : refracted);
}

vec3 vec3_load(PackedVec3_ v_4) {
    return vec3(v_4.x, v_4.y, v_4.z);
}

PackedVec3_ vec3_store(vec3 v_5) {
    return PackedVec3_(v_5.x, v_5.y, v_5.z);
}

Ray ray_load(PackedRay ray_1) {
    vec3 _e2 = vec3_load(ray_1.origin);
    vec3 _e4 = vec3_load(ray_1.direction);
    return Ray(_e2, _e4);
}

PackedRay ray_store(Ray ray_2) {
    PackedVec3_ _e2 = vec3_store(ray_2.origin);
    PackedVec3_ _e4 = vec3_store(ray_2.direction);
    return PackedRay(_e2, _e4);
}

void main() {
    uvec3 id = gl_GlobalInvocationID;
    if ((id.x >= uint(_group_0_binding_0_cs.length()))) {
        return;
    }
    ReflectionCase this_case = _group_0_binding_0_cs[id.x];
    vec3 _e13 = vec3_load(this_case.direction);
    vec3 _e15 = vec3_load(this_case.normal);
    vec3 _e16 = scatter_reflect(_e13, _e15);
    PackedVec3_ _e17 = vec3_store(_e16);
    _group_0_binding_1_cs[id.x] = _e17;
    return;
}

