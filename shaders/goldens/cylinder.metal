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
struct UnitAndLength {
    metal::packed_float3 direction;
    real length;
};
struct CylinderRecord {
    metal::float3 center;
    metal::float3 axis;
    metal::float3 top;
    metal::packed_float3 bottom;
    real radius;
    real radius_squared;
    real half_height;
    char _pad7[8];
};
struct CylinderView {
    metal::packed_float3 r_c;
    real c;
};
struct CylinderQuadratic {
    real a;
    real h;
    real discriminant;
};
struct CylinderRoot {
    bool some;
    char _pad1[3];
    real lambda;
    uint part;
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
struct CylinderCase {
    PackedRay ray;
    PackedVec3_ center;
    real radius;
    PackedVec3_ axis;
};
typedef CylinderCase type_4[1];
typedef HitReport type_5[1];
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
constant uint SIDE = 0u;
constant uint TOP = 1u;
constant uint BOTTOM = 2u;

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

UnitAndLength vec3_unit_and_length(
    metal::float3 v_4
) {
    real _e1 = vec3_dot(v_4, v_4);
    if (_e1 < SHORT_SQUARED) {
        metal::float3 scaled = v_4 * SHORT_SCALE;
        real _e6 = vec3_length(scaled);
        return UnitAndLength {scaled / metal::float3(_e6), _e6 * SHORT_SQUARED};
    }
    real _e12 = vec3_length(v_4);
    return UnitAndLength {v_4 / metal::float3(_e12), _e12};
}

bool tie_later_cap_is_closer(
    real lambda_2,
    real closest
) {
    return lambda_2 < closest;
}

int tie_rank(
    uint order,
    bool on_cap
) {
    return on_cap ? as_type<int>(as_type<uint>(-1) - as_type<uint>(static_cast<int>(order))) : static_cast<int>(order);
}

bool tie_is_closer(
    real lambda_3,
    int rank,
    real closest_1,
    int closest_rank
) {
    return (lambda_3 < closest_1) | ((lambda_3 <= closest_1) & (rank >= closest_rank));
}

CylinderRecord cylinder_with_unit_axis(
    metal::float3 center,
    real radius,
    metal::float3 axis_1,
    real half_height
) {
    metal::float3 to_cap = axis_1 * half_height;
    return CylinderRecord {center, axis_1, center + to_cap, center - to_cap, radius, radius * radius, half_height};
}

CylinderRecord cylinder_new(
    metal::float3 center_1,
    real radius_1,
    metal::float3 axis_2
) {
    UnitAndLength _e3 = vec3_unit_and_length(axis_2);
    CylinderRecord _e8 = cylinder_with_unit_axis(center_1, radius_1, _e3.direction, _e3.length / 2.0);
    return _e8;
}

CylinderView cylinder_seen_from(
    CylinderRecord cylinder_1,
    metal::float3 origin
) {
    metal::float3 _e5 = vec3_perpendicular_to(origin - cylinder_1.center, cylinder_1.axis);
    real _e6 = vec3_dot(_e5, _e5);
    return CylinderView {_e5, _e6 - cylinder_1.radius_squared};
}

CylinderQuadratic cylinder_quadratic(
    CylinderRecord cylinder_2,
    CylinderView view,
    metal::float3 along
) {
    metal::float3 _e4 = vec3_perpendicular_to(along, cylinder_2.axis);
    real _e5 = vec3_dot(_e4, _e4);
    real _e7 = vec3_dot(view.r_c, _e4);
    return CylinderQuadratic {_e5, _e7, (_e7 * _e7) - (_e5 * view.c)};
}

bool cylinder_within_height(
    CylinderRecord cylinder_3,
    Ray ray_1,
    real lambda_4
) {
    metal::float3 _e3 = ray_at(ray_1, lambda_4);
    real _e7 = vec3_dot(_e3 - cylinder_3.center, cylinder_3.axis);
    return metal::abs(_e7) <= cylinder_3.half_height;
}

Root cylinder_side(
    CylinderRecord cylinder_4,
    Ray ray_2,
    CylinderQuadratic quadratic
) {
    float root = metal::sqrt(quadratic.discriminant);
    real near = (-(quadratic.h) - root) / quadratic.a;
    real far = (-(quadratic.h) + root) / quadratic.a;
    bool _e15 = in_range(near);
    bool _e16 = cylinder_within_height(cylinder_4, ray_2, near);
    bool near_counts = _e15 & _e16;
    bool _e18 = in_range(far);
    bool _e19 = cylinder_within_height(cylinder_4, ray_2, far);
    bool far_counts = _e18 & _e19;
    return Root {near_counts | far_counts, {}, near_counts ? near : far};
}

Root cylinder_cap(
    CylinderRecord cylinder_5,
    Ray ray_3,
    metal::float3 center_2
) {
    real _e5 = vec3_dot(ray_3.direction, cylinder_5.axis);
    real _e9 = vec3_dot(center_2 - ray_3.origin, cylinder_5.axis);
    real lambda_6 = _e9 / _e5;
    metal::float3 _e11 = ray_at(ray_3, lambda_6);
    real _e13 = vec3_length(_e11 - center_2);
    bool on_disc = _e13 <= cylinder_5.radius;
    bool _e20 = in_range(lambda_6);
    return Root {(!((metal::abs(_e5) < 0.00000001)) & _e20) & on_disc, {}, lambda_6};
}

metal::float3 cylinder_outward(
    CylinderRecord cylinder_6,
    uint part,
    metal::float3 point_1
) {
    metal::float3 _e6 = vec3_perpendicular_to(point_1 - cylinder_6.center, cylinder_6.axis);
    metal::float3 cap = (part == TOP) ? cylinder_6.axis : -(cylinder_6.axis);
    return (part == SIDE) ? _e6 : cap;
}

CylinderRoot cylinder_closer(
    CylinderRoot closest_2,
    Root later,
    uint part_1
) {
    bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = later.some & (!(closest_2.some) | _e8);
    real lambda_7 = replaces ? later.lambda : closest_2.lambda;
    return CylinderRoot {closest_2.some | later.some, {}, lambda_7, replaces ? part_1 : closest_2.part};
}

CylinderRoot cylinder_with_caps(
    CylinderRecord cylinder_7,
    Ray ray_4,
    Root side
) {
    Root _e4 = cylinder_cap(cylinder_7, ray_4, cylinder_7.top);
    Root _e6 = cylinder_cap(cylinder_7, ray_4, cylinder_7.bottom);
    CylinderRoot _e12 = cylinder_closer(CylinderRoot {side.some, {}, side.lambda, SIDE}, _e4, TOP);
    CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    return _e14;
}

CylinderRoot cylinder_intersect(
    CylinderRecord cylinder_8,
    Ray ray_5
) {
    CylinderView _e3 = cylinder_seen_from(cylinder_8, ray_5.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_8, _e3, ray_5.direction);
    Root _e6 = cylinder_side(cylinder_8, ray_5, _e5);
    bool some = !((_e5.discriminant < 0.0)) & _e6.some;
    CylinderRoot _e15 = cylinder_with_caps(cylinder_8, ray_5, Root {some, {}, _e6.lambda});
    return _e15;
}

metal::float3 vec3_load(
    PackedVec3_ v_5
) {
    return metal::float3(v_5.x, v_5.y, v_5.z);
}

PackedVec3_ vec3_store(
    metal::float3 v_6
) {
    return PackedVec3_ {v_6.x, v_6.y, v_6.z};
}

Ray ray_load(
    PackedRay ray_6
) {
    metal::float3 _e2 = vec3_load(ray_6.origin);
    metal::float3 _e4 = vec3_load(ray_6.direction);
    return Ray {_e2, _e4};
}

PackedRay ray_store(
    Ray ray_7
) {
    PackedVec3_ _e2 = vec3_store(ray_7.origin);
    PackedVec3_ _e4 = vec3_store(ray_7.direction);
    return PackedRay {_e2, _e4};
}

HitReport hit_report_none(
) {
    PackedVec3_ _e1 = vec3_store(metal::float3 {});
    return HitReport {0.0, 0.0, 0.0, 0.0, _e1, _e1};
}

HitReport hit_report(
    real lambda_5,
    uint part_2,
    Hit hit
) {
    float front_1 = hit.front ? 1.0 : 0.0;
    PackedVec3_ _e10 = vec3_store(hit.point);
    PackedVec3_ _e12 = vec3_store(hit.normal);
    return HitReport {1.0, lambda_5, static_cast<float>(part_2), front_1, _e10, _e12};
}

struct cylinderInput {
};
kernel void cylinder(
  metal::uint3 id [[thread_position_in_grid]]
, device type_4 const& cases [[buffer(0)]]
, device type_5& reports [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    if (id.x >= (1 + (_buffer_sizes.size0 - 0 - 52) / 52)) {
        return;
    }
    PackedRay _e9 = cases[id.x].ray;
    Ray _e10 = ray_load(_e9);
    PackedVec3_ _e15 = cases[id.x].center;
    metal::float3 _e16 = vec3_load(_e15);
    real _e21 = cases[id.x].radius;
    PackedVec3_ _e26 = cases[id.x].axis;
    metal::float3 _e27 = vec3_load(_e26);
    CylinderRecord _e28 = cylinder_new(_e16, _e21, _e27);
    CylinderRoot _e29 = cylinder_intersect(_e28, _e10);
    if (!(_e29.some)) {
        HitReport _e35 = hit_report_none();
        reports[id.x] = _e35;
        return;
    }
    metal::float3 _e37 = ray_at(_e10, _e29.lambda);
    metal::float3 _e40 = cylinder_outward(_e28, _e29.part, _e37);
    Hit _e41 = hit_facing(_e10.direction, _e37, _e40);
    HitReport _e47 = hit_report(_e29.lambda, _e29.part, _e41);
    reports[id.x] = _e47;
    return;
}
