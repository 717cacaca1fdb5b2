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
struct SphereRecord {
    metal::packed_float3 center;
    real radius;
    real radius_squared;
    char _pad3[12];
};
struct SphereView {
    metal::packed_float3 r_c;
    real c;
};
struct SphereQuadratic {
    real h;
    real discriminant;
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
struct HitReport {
    real some;
    real lambda;
    real part;
    real front;
    PackedVec3_ point;
    PackedVec3_ normal;
};
struct SphereCase {
    PackedRay ray;
    PackedVec3_ center;
    real radius;
};
typedef SphereCase type_3[1];
typedef HitReport type_4[1];
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
    bool front = _e3 < 0.0;
    return Hit {point, front ? outward : -(outward), front};
}

SphereRecord sphere_new(
    metal::float3 center,
    real radius
) {
    return SphereRecord {center, radius, radius * radius};
}

SphereView sphere_seen_from(
    SphereRecord sphere_1,
    metal::float3 origin
) {
    metal::float3 r_c = sphere_1.center - origin;
    real _e4 = vec3_dot(r_c, r_c);
    return SphereView {r_c, _e4 - sphere_1.radius_squared};
}

SphereQuadratic sphere_quadratic(
    SphereView view,
    metal::float3 direction_1,
    real a_1
) {
    real _e4 = vec3_dot(direction_1, view.r_c);
    return SphereQuadratic {_e4, (_e4 * _e4) - (a_1 * view.c)};
}

Root sphere_first_root(
    real a_2,
    real h,
    real discriminant
) {
    float root = metal::sqrt(discriminant);
    real near = (h - root) / a_2;
    real far = (h + root) / a_2;
    bool _e8 = in_range(near);
    real lambda_3 = _e8 ? near : far;
    bool _e10 = in_range(lambda_3);
    return Root {_e10, {}, lambda_3};
}

metal::float3 sphere_outward(
    SphereRecord sphere_2,
    metal::float3 point_1
) {
    return (point_1 - sphere_2.center) / metal::float3(sphere_2.radius);
}

Root sphere_intersect(
    SphereRecord sphere_3,
    Ray ray_1
) {
    real _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    SphereView _e6 = sphere_seen_from(sphere_3, ray_1.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
    Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    return Root {!((_e8.discriminant < 0.0)) & _e11.some, {}, _e11.lambda};
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
    PackedRay ray_2
) {
    metal::float3 _e2 = vec3_load(ray_2.origin);
    metal::float3 _e4 = vec3_load(ray_2.direction);
    return Ray {_e2, _e4};
}

PackedRay ray_store(
    Ray ray_3
) {
    PackedVec3_ _e2 = vec3_store(ray_3.origin);
    PackedVec3_ _e4 = vec3_store(ray_3.direction);
    return PackedRay {_e2, _e4};
}

HitReport hit_report_none(
) {
    PackedVec3_ _e1 = vec3_store(metal::float3 {});
    return HitReport {0.0, 0.0, 0.0, 0.0, _e1, _e1};
}

HitReport hit_report(
    real lambda_2,
    uint part,
    Hit hit
) {
    float front_1 = hit.front ? 1.0 : 0.0;
    PackedVec3_ _e10 = vec3_store(hit.point);
    PackedVec3_ _e12 = vec3_store(hit.normal);
    return HitReport {1.0, lambda_2, static_cast<float>(part), front_1, _e10, _e12};
}

struct sphereInput {
};
kernel void sphere(
  metal::uint3 id [[thread_position_in_grid]]
, device type_3 const& cases [[buffer(0)]]
, device type_4& reports [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    if (id.x >= (1 + (_buffer_sizes.size0 - 0 - 40) / 40)) {
        return;
    }
    PackedRay _e9 = cases[id.x].ray;
    Ray _e10 = ray_load(_e9);
    PackedVec3_ _e15 = cases[id.x].center;
    metal::float3 _e16 = vec3_load(_e15);
    real _e21 = cases[id.x].radius;
    SphereRecord _e22 = sphere_new(_e16, _e21);
    Root _e23 = sphere_intersect(_e22, _e10);
    if (!(_e23.some)) {
        HitReport _e29 = hit_report_none();
        reports[id.x] = _e29;
        return;
    }
    metal::float3 _e31 = ray_at(_e10, _e23.lambda);
    metal::float3 _e33 = sphere_outward(_e22, _e31);
    Hit _e34 = hit_facing(_e10.direction, _e31, _e33);
    HitReport _e40 = hit_report(_e23.lambda, 0u, _e34);
    reports[id.x] = _e40;
    return;
}
