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
struct Crossings {
    bool some;
    char _pad1[3];
    real near;
    real far;
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
struct ProjectedSphereCase {
    PackedRay ray;
    PackedVec3_ center;
    real radius;
};
typedef ProjectedSphereCase type_4[1];
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

SphereRecord sphere_new(
    metal::float3 center,
    real radius
) {
    return SphereRecord {center, radius, radius * radius};
}

SphereView sphere_seen_from(
    SphereRecord sphere,
    metal::float3 origin
) {
    metal::float3 r_c_1 = sphere.center - origin;
    real _e4 = vec3_dot(r_c_1, r_c_1);
    return SphereView {r_c_1, _e4 - sphere.radius_squared};
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
    real lambda_6 = _e8 ? near : far;
    bool _e10 = in_range(lambda_6);
    return Root {_e10, {}, lambda_6};
}

metal::float3 sphere_outward(
    SphereRecord sphere_1,
    metal::float3 point_1
) {
    return (point_1 - sphere_1.center) / metal::float3(sphere_1.radius);
}

Root sphere_intersect(
    SphereRecord sphere_2,
    Ray ray_1
) {
    real _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    SphereView _e6 = sphere_seen_from(sphere_2, ray_1.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
    Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    return Root {!((_e8.discriminant < 0.0)) & _e11.some, {}, _e11.lambda};
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
    metal::float3 center_1,
    real radius_1,
    metal::float3 axis_1,
    real half_height
) {
    metal::float3 to_cap = axis_1 * half_height;
    return CylinderRecord {center_1, axis_1, center_1 + to_cap, center_1 - to_cap, radius_1, radius_1 * radius_1, half_height};
}

CylinderRecord cylinder_new(
    metal::float3 center_2,
    real radius_2,
    metal::float3 axis_2
) {
    UnitAndLength _e3 = vec3_unit_and_length(axis_2);
    CylinderRecord _e8 = cylinder_with_unit_axis(center_2, radius_2, _e3.direction, _e3.length / 2.0);
    return _e8;
}

CylinderView cylinder_seen_from(
    CylinderRecord cylinder,
    metal::float3 origin_1
) {
    metal::float3 _e5 = vec3_perpendicular_to(origin_1 - cylinder.center, cylinder.axis);
    real _e6 = vec3_dot(_e5, _e5);
    return CylinderView {_e5, _e6 - cylinder.radius_squared};
}

CylinderQuadratic cylinder_quadratic(
    CylinderRecord cylinder_1,
    CylinderView view_1,
    metal::float3 along
) {
    metal::float3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    real _e5 = vec3_dot(_e4, _e4);
    real _e7 = vec3_dot(view_1.r_c, _e4);
    return CylinderQuadratic {_e5, _e7, (_e7 * _e7) - (_e5 * view_1.c)};
}

bool cylinder_within_height(
    CylinderRecord cylinder_2,
    Ray ray_2,
    real lambda_4
) {
    metal::float3 _e3 = ray_at(ray_2, lambda_4);
    real _e7 = vec3_dot(_e3 - cylinder_2.center, cylinder_2.axis);
    return metal::abs(_e7) <= cylinder_2.half_height;
}

Root cylinder_side(
    CylinderRecord cylinder_3,
    Ray ray_3,
    CylinderQuadratic quadratic
) {
    float root_1 = metal::sqrt(quadratic.discriminant);
    real near_1 = (-(quadratic.h) - root_1) / quadratic.a;
    real far_1 = (-(quadratic.h) + root_1) / quadratic.a;
    bool _e15 = in_range(near_1);
    bool _e16 = cylinder_within_height(cylinder_3, ray_3, near_1);
    bool near_counts = _e15 & _e16;
    bool _e18 = in_range(far_1);
    bool _e19 = cylinder_within_height(cylinder_3, ray_3, far_1);
    bool far_counts = _e18 & _e19;
    return Root {near_counts | far_counts, {}, near_counts ? near_1 : far_1};
}

Root cylinder_cap(
    CylinderRecord cylinder_4,
    Ray ray_4,
    metal::float3 center_3
) {
    real _e5 = vec3_dot(ray_4.direction, cylinder_4.axis);
    real _e9 = vec3_dot(center_3 - ray_4.origin, cylinder_4.axis);
    real lambda_7 = _e9 / _e5;
    metal::float3 _e11 = ray_at(ray_4, lambda_7);
    real _e13 = vec3_length(_e11 - center_3);
    bool on_disc = _e13 <= cylinder_4.radius;
    bool _e20 = in_range(lambda_7);
    return Root {(!((metal::abs(_e5) < 0.00000001)) & _e20) & on_disc, {}, lambda_7};
}

metal::float3 cylinder_outward(
    CylinderRecord cylinder_5,
    uint part,
    metal::float3 point_2
) {
    metal::float3 _e6 = vec3_perpendicular_to(point_2 - cylinder_5.center, cylinder_5.axis);
    metal::float3 cap = (part == TOP) ? cylinder_5.axis : -(cylinder_5.axis);
    return (part == SIDE) ? _e6 : cap;
}

CylinderRoot cylinder_closer(
    CylinderRoot closest_2,
    Root later,
    uint part_1
) {
    bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = later.some & (!(closest_2.some) | _e8);
    real lambda_8 = replaces ? later.lambda : closest_2.lambda;
    return CylinderRoot {closest_2.some | later.some, {}, lambda_8, replaces ? part_1 : closest_2.part};
}

CylinderRoot cylinder_with_caps(
    CylinderRecord cylinder_6,
    Ray ray_5,
    Root side
) {
    Root _e4 = cylinder_cap(cylinder_6, ray_5, cylinder_6.top);
    Root _e6 = cylinder_cap(cylinder_6, ray_5, cylinder_6.bottom);
    CylinderRoot _e12 = cylinder_closer(CylinderRoot {side.some, {}, side.lambda, SIDE}, _e4, TOP);
    CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    return _e14;
}

CylinderRoot cylinder_intersect(
    CylinderRecord cylinder_7,
    Ray ray_6
) {
    CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_6.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_6.direction);
    Root _e6 = cylinder_side(cylinder_7, ray_6, _e5);
    bool some = !((_e5.discriminant < 0.0)) & _e6.some;
    CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_6, Root {some, {}, _e6.lambda});
    return _e15;
}

Crossings projected_crossings(
    metal::float3 direction_2,
    metal::float3 r_c,
    real radius_squared
) {
    real _e3 = vec3_dot(direction_2, direction_2);
    real _e4 = vec3_dot(direction_2, r_c);
    real middle = _e4 / _e3;
    metal::float3 off_center = r_c - (direction_2 * middle);
    real _e8 = vec3_dot(off_center, off_center);
    real rest = radius_squared - _e8;
    if (rest < 0.0) {
        return Crossings {false, {}, 0.0, 0.0};
    }
    float half_ = metal::sqrt(rest / _e3);
    return Crossings {true, {}, middle - half_, middle + half_};
}

Root projected_sphere_intersect(
    SphereRecord sphere_3,
    Ray ray_7
) {
    bool local = {};
    Crossings _e7 = projected_crossings(ray_7.direction, sphere_3.center - ray_7.origin, sphere_3.radius_squared);
    bool _e11 = in_range(_e7.near);
    real lambda_9 = _e11 ? _e7.near : _e7.far;
    if (_e7.some) {
        bool _e16 = in_range(lambda_9);
        local = _e16;
    } else {
        local = false;
    }
    bool _e18 = local;
    return Root {_e18, {}, lambda_9};
}

CylinderRoot projected_cylinder_intersect(
    CylinderRecord cylinder_8,
    Ray ray_8
) {
    Root side_1 = {};
    bool local_1 = {};
    bool local_2 = {};
    bool local_3 = {};
    metal::float3 _e6 = vec3_perpendicular_to(cylinder_8.center - ray_8.origin, cylinder_8.axis);
    metal::float3 _e9 = vec3_perpendicular_to(ray_8.direction, cylinder_8.axis);
    Crossings _e11 = projected_crossings(_e9, _e6, cylinder_8.radius_squared);
    if (_e11.some) {
        bool _e15 = in_range(_e11.near);
        if (_e15) {
            bool _e19 = cylinder_within_height(cylinder_8, ray_8, _e11.near);
            local_1 = _e19;
        } else {
            local_1 = false;
        }
        bool near_counts_1 = local_1;
        bool _e23 = in_range(_e11.far);
        if (_e23) {
            bool _e27 = cylinder_within_height(cylinder_8, ray_8, _e11.far);
            local_2 = _e27;
        } else {
            local_2 = false;
        }
        bool far_counts_1 = local_2;
        real lambda_10 = near_counts_1 ? _e11.near : _e11.far;
        if (!(near_counts_1)) {
            local_3 = far_counts_1;
        } else {
            local_3 = true;
        }
        bool _e37 = local_3;
        side_1 = Root {_e37, {}, lambda_10};
    }
    Root _e39 = side_1;
    CylinderRoot _e40 = cylinder_with_caps(cylinder_8, ray_8, _e39);
    return _e40;
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
    PackedRay ray_9
) {
    metal::float3 _e2 = vec3_load(ray_9.origin);
    metal::float3 _e4 = vec3_load(ray_9.direction);
    return Ray {_e2, _e4};
}

PackedRay ray_store(
    Ray ray_10
) {
    PackedVec3_ _e2 = vec3_store(ray_10.origin);
    PackedVec3_ _e4 = vec3_store(ray_10.direction);
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

struct projected_sphereInput {
};
kernel void projected_sphere(
  metal::uint3 id [[thread_position_in_grid]]
, device type_4 const& cases [[buffer(0)]]
, device type_5& reports [[buffer(1)]]
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
    Root _e23 = projected_sphere_intersect(_e22, _e10);
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
