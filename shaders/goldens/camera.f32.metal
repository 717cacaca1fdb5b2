// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size0;
    uint size1;
};

typedef float real;
struct Ray {
    metal::float3 origin;
    metal::float3 direction;
};
struct Root {
    bool some;
    char _pad1[3];
    real lambda;
};
struct Hit {
    metal::float3 point;
    metal::packed_float3 normal;
    bool front;
    char _pad3[3];
};
struct Camera {
    metal::float3 position;
    metal::float3 origin;
    metal::float3 delta_x;
    metal::float3 delta_y;
};
struct PackedVec3_ {
    real x;
    real y;
    real z;
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
    real row;
    real column;
    real offset_x;
    real offset_y;
};
typedef CameraCase type_4[1];
typedef PackedRay type_5[1];
constant real SHORT_SQUARED = 0.0;
constant real SHORT_SCALE = 1.0;
constant real BELOW_ONE = 0.99999994;
constant real LEAST_SQUARED = 0.0;
constant real ERROR_UNDERFLOW = 0.0;
constant real ERROR_OVERFLOW = 300000000000000000000000000000000000000.0;
constant real SHORTEST_SQUARED = 0.0;
constant real LONGEST_SQUARED = 300000000000000000000000000000000000000.0;
constant real EXTENT_UNDERFLOW = 0.0;
constant real LEAST_SIZE = 0.0;
constant real SPLITTER = 4097.0;
constant real SPLIT_LIMIT = 1000000000000000000000000000000000.0;
constant real SPLIT_SCALE = 0.000015258789;
constant real SPLIT_UNSCALE = 65536.0;
constant real UNWRITTEN = -0.00000000000000028735182;

real vec3_dot(
    metal::float3 a,
    metal::float3 b
) {
    return ((a.x * b.x) + (a.y * b.y)) + (a.z * b.z);
}

real vec3_length(
    metal::float3 v
) {
    real _e1 = vec3_dot(v, v);
    return metal::sqrt(_e1);
}

metal::float3 vec3_unit(
    metal::float3 v_1
) {
    real _e1 = vec3_length(v_1);
    return v_1 / metal::float3(_e1);
}

metal::float3 vec3_perpendicular_to(
    metal::float3 v_2,
    metal::float3 axis
) {
    real _e2 = vec3_dot(v_2, axis);
    return v_2 - (axis * _e2);
}

bool vec3_is_negligible(
    metal::float3 v_3
) {
    return ((metal::abs(v_3.x) < 0.00000001) & (metal::abs(v_3.y) < 0.00000001)) & (metal::abs(v_3.z) < 0.00000001);
}

metal::float3 ray_at(
    Ray ray,
    real lambda
) {
    return ray.origin + (ray.direction * lambda);
}

bool in_range(
    real lambda_1
) {
    return 0.001 <= lambda_1;
}

Hit hit_facing(
    metal::float3 direction,
    metal::float3 point,
    metal::float3 outward
) {
    real _e3 = vec3_dot(direction, outward);
    bool front = _e3 < 0.0;
    return Hit {point, front ? outward : -(outward), front};
}

Ray camera_ray(
    Camera camera_1,
    real row,
    real column,
    metal::float2 offset
) {
    float x = offset.x;
    float y = offset.y;
    metal::float3 window_point = (camera_1.origin + (camera_1.delta_x * (column + x))) + (camera_1.delta_y * (row + y));
    return Ray {camera_1.position, window_point - camera_1.position};
}

metal::float3 vec3_load(
    PackedVec3_ v_4
) {
    return metal::float3(v_4.x, v_4.y, v_4.z);
}

PackedVec3_ vec3_store(
    metal::float3 v_5
) {
    return PackedVec3_ {v_5.x, v_5.y, v_5.z};
}

Ray ray_load(
    PackedRay ray_1
) {
    metal::float3 _e2 = vec3_load(ray_1.origin);
    metal::float3 _e4 = vec3_load(ray_1.direction);
    return Ray {_e2, _e4};
}

PackedRay ray_store(
    Ray ray_2
) {
    PackedVec3_ _e2 = vec3_store(ray_2.origin);
    PackedVec3_ _e4 = vec3_store(ray_2.direction);
    return PackedRay {_e2, _e4};
}

struct cameraInput {
};
kernel void camera(
  metal::uint3 id [[thread_position_in_grid]]
, device type_4 const& cases [[buffer(0)]]
, device type_5& results [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    if (id.x >= (1 + (_buffer_sizes.size0 - 0 - 64) / 64)) {
        return;
    }
    CameraCase this_case = cases[id.x];
    metal::float3 _e10 = vec3_load(this_case.position);
    metal::float3 _e12 = vec3_load(this_case.origin);
    metal::float3 _e14 = vec3_load(this_case.delta_x);
    metal::float3 _e16 = vec3_load(this_case.delta_y);
    Camera camera_2 = Camera {_e10, _e12, _e14, _e16};
    metal::float2 offset_1 = metal::float2(this_case.offset_x, this_case.offset_y);
    Ray _e26 = camera_ray(camera_2, this_case.row, this_case.column, offset_1);
    PackedRay _e27 = ray_store(_e26);
    results[id.x] = _e27;
    return;
}
