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
struct ReflectionCase {
    PackedVec3_ direction;
    PackedVec3_ normal;
};
typedef ReflectionCase type_3[1];
typedef PackedVec3_ type_4[1];
constant real SHORT_SQUARED = 0.0;
constant real SHORT_SCALE = 1.0;
constant real BELOW_ONE = 0.99999994;
constant real LEAST_SQUARED = 0.0;
constant real ERROR_UNDERFLOW = 0.0;
constant real ERROR_OVERFLOW = 300000000000000000000000000000000000000.0;
constant real SHORTEST_SQUARED = 0.0;
constant real LONGEST_SQUARED = 300000000000000000000000000000000000000.0;
constant real EXTENT_UNDERFLOW = 0.0;
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
    bool front_1 = _e3 < 0.0;
    return Hit {point, front_1 ? outward : -(outward), front_1};
}

metal::float3 scatter_matte(
    metal::float3 normal,
    metal::float3 vector
) {
    metal::float3 direction_5 = normal + vector;
    bool _e3 = vec3_is_negligible(direction_5);
    return _e3 ? normal : direction_5;
}

metal::float3 scatter_reflect(
    metal::float3 direction_1,
    metal::float3 normal_1
) {
    real _e2 = vec3_dot(direction_1, normal_1);
    return direction_1 - (normal_1 * (_e2 * 2.0));
}

metal::float3 scatter_mirror(
    metal::float3 direction_2,
    metal::float3 normal_2
) {
    metal::float3 _e2 = scatter_reflect(direction_2, normal_2);
    metal::float3 _e3 = vec3_unit(_e2);
    return _e3;
}

metal::float3 scatter_metal(
    metal::float3 direction_3,
    metal::float3 normal_3,
    metal::float3 vector_1
) {
    metal::float3 _e3 = scatter_mirror(direction_3, normal_3);
    return _e3 + vector_1;
}

real scatter_index_ratio(
    real index,
    bool front
) {
    return front ? (1.0 / index) : index;
}

metal::float3 scatter_refract(
    metal::float3 direction_4,
    metal::float3 normal_4,
    real ratio
) {
    metal::float3 _e4 = vec3_unit(direction_4);
    real _e5 = vec3_dot(_e4, normal_4);
    real product = -(_e5);
    real cos = (product < 1.0) ? product : 1.0;
    float sin = metal::sqrt(1.0 - (cos * cos));
    metal::float3 _e12 = scatter_reflect(_e4, normal_4);
    metal::float3 p = (_e4 + (normal_4 * cos)) * ratio;
    real _e16 = vec3_dot(p, p);
    metal::float3 refracted = p - (normal_4 * metal::sqrt(metal::abs(1.0 - _e16)));
    bool beyond = 1.0 < (ratio * sin);
    return beyond ? _e12 : refracted;
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

struct reflectionInput {
};
kernel void reflection(
  metal::uint3 id [[thread_position_in_grid]]
, device type_3 const& cases [[buffer(0)]]
, device type_4& results [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    if (id.x >= (1 + (_buffer_sizes.size0 - 0 - 24) / 24)) {
        return;
    }
    ReflectionCase this_case = cases[id.x];
    metal::float3 _e13 = vec3_load(this_case.direction);
    metal::float3 _e15 = vec3_load(this_case.normal);
    metal::float3 _e16 = scatter_reflect(_e13, _e15);
    PackedVec3_ _e17 = vec3_store(_e16);
    results[id.x] = _e17;
    return;
}
