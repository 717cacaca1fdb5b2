#version 430 core
#extension GL_ARB_compute_shader : require
#extension GL_ARB_shader_storage_buffer_object : require
layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

struct Ray {
    dvec3 origin;
    dvec3 direction;
};
struct Root {
    bool some;
    double lambda;
};
struct Hit {
    dvec3 point;
    dvec3 normal;
    bool front;
};
struct Camera {
    dvec3 position;
    dvec3 origin;
    dvec3 delta_x;
    dvec3 delta_y;
};
struct PackedVec3_ {
    double x;
    double y;
    double z;
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
    double row;
    double column;
    double offset_x;
    double offset_y;
};
const double SHORT_SQUARED = 2.409919865102884e-181LF;
const double SHORT_SCALE = 4.149515568880993e180LF;
const double BELOW_ONE = 0.9999999999999999LF;
const double LEAST_SQUARED = 1e-160LF;
const double ERROR_UNDERFLOW = 2.409919865102884e-181LF;
const double ERROR_OVERFLOW = 1.0715086071862673e301LF;
const double SHORTEST_SQUARED = 4.909093465297727e-91LF;
const double LONGEST_SQUARED = 2.037035976334486e90LF;
const double EXTENT_UNDERFLOW = 4.909093465297727e-91LF;
const double LEAST_SIZE = 4.3601508761683463e-106LF;
const double SPLITTER = 134217729.0LF;
const double SPLIT_LIMIT = 9.7453140114e288LF;
const double SPLIT_SCALE = 5.421010862427522e-20LF;
const double SPLIT_UNSCALE = 1.8446744073709552e19LF;
const double UNWRITTEN = -2.4983353906949635e-127LF;

layout(std430, binding = 0) readonly buffer type_4_block_0Compute { CameraCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_5_block_1Compute { PackedRay _group_0_binding_1_cs[]; };


double vec3_dot(dvec3 a, dvec3 b) {
    return (((a.x * b.x) + (a.y * b.y)) + (a.z * b.z));
}

double vec3_length(dvec3 v) {
    double _e1 = vec3_dot(v, v);
    return sqrt(_e1);
}

dvec3 vec3_unit(dvec3 v_1) {
    double _e1 = vec3_length(v_1);
    return (v_1 / dvec3(_e1));
}

dvec3 vec3_perpendicular_to(dvec3 v_2, dvec3 axis) {
    double _e2 = vec3_dot(v_2, axis);
    return (v_2 - (axis * _e2));
}

bool vec3_is_negligible(dvec3 v_3) {
    return (((abs(v_3.x) < 1e-8LF) && (abs(v_3.y) < 1e-8LF)) && (abs(v_3.z) < 1e-8LF));
}

dvec3 ray_at(Ray ray, double lambda) {
    return (ray.origin + (ray.direction * lambda));
}

bool in_range(double lambda_1) {
    return (0.001LF <= lambda_1);
}

Hit hit_facing(dvec3 direction, dvec3 point, dvec3 outward) {
    double _e3 = vec3_dot(direction, outward);
    bool front = (_e3 < 0.0LF);
    return Hit(point, (front ? outward : -(outward)), front);
}

Ray camera_ray(Camera camera_1, double row, double column, dvec2 offset) {
    double x = offset.x;
    double y = offset.y;
    dvec3 window_point = ((camera_1.origin + (camera_1.delta_x * (column + x))) + (camera_1.delta_y * (row + y)));
    return Ray(camera_1.position, (window_point - camera_1.position));
}

dvec3 vec3_load(PackedVec3_ v_4) {
    return dvec3(v_4.x, v_4.y, v_4.z);
}

PackedVec3_ vec3_store(dvec3 v_5) {
    return PackedVec3_(v_5.x, v_5.y, v_5.z);
}

Ray ray_load(PackedRay ray_1) {
    dvec3 _e2 = vec3_load(ray_1.origin);
    dvec3 _e4 = vec3_load(ray_1.direction);
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
    dvec3 _e10 = vec3_load(this_case.position);
    dvec3 _e12 = vec3_load(this_case.origin);
    dvec3 _e14 = vec3_load(this_case.delta_x);
    dvec3 _e16 = vec3_load(this_case.delta_y);
    Camera camera_2 = Camera(_e10, _e12, _e14, _e16);
    dvec2 offset_1 = dvec2(this_case.offset_x, this_case.offset_y);
    Ray _e26 = camera_ray(camera_2, this_case.row, this_case.column, offset_1);
    PackedRay _e27 = ray_store(_e26);
    _group_0_binding_1_cs[id.x] = _e27;
    return;
}

