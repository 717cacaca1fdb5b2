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
struct Camera {
    vec3 position;
    vec3 origin;
    vec3 delta_x;
    vec3 delta_y;
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
struct CameraCase {
    PackedVec3_ position;
    PackedVec3_ origin;
    PackedVec3_ delta_x;
    PackedVec3_ delta_y;
    float row;
    float column;
    float offset_x;
    float offset_y;
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
const float LEAST_SIZE = 0.0;
const float SPLITTER = 4097.0;
const float SPLIT_LIMIT = 1e33;
const float SPLIT_SCALE = 1.5258789e-5;
const float SPLIT_UNSCALE = 65536.0;
const float UNWRITTEN = -2.8735182e-16;

layout(std430, binding = 0) readonly buffer type_4_block_0Compute { CameraCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_5_block_1Compute { PackedRay _group_0_binding_1_cs[]; };


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

Ray camera_ray(Camera camera_1, float row, float column, vec2 offset) {
    float x = offset.x;
    float y = offset.y;
    vec3 window_point = ((camera_1.origin + (camera_1.delta_x * (column + x))) + (camera_1.delta_y * (row + y)));
    return Ray(camera_1.position, (window_point - camera_1.position));
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
    CameraCase this_case = _group_0_binding_0_cs[id.x];
    vec3 _e10 = vec3_load(this_case.position);
    vec3 _e12 = vec3_load(this_case.origin);
    vec3 _e14 = vec3_load(this_case.delta_x);
    vec3 _e16 = vec3_load(this_case.delta_y);
    Camera camera_2 = Camera(_e10, _e12, _e14, _e16);
    vec2 offset_1 = vec2(this_case.offset_x, this_case.offset_y);
    Ray _e26 = camera_ray(camera_2, this_case.row, this_case.column, offset_1);
    PackedRay _e27 = ray_store(_e26);
    _group_0_binding_1_cs[id.x] = _e27;
    return;
}

