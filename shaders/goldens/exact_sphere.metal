// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size1;
    uint size2;
};

typedef float real;
struct ExactSum {
    real sum;
    real error;
};
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
struct ExactHalves {
    real high;
    real low;
};
struct Decision {
    bool certain;
    bool some;
    char _pad2[2];
    real lambda;
    uint part;
};
struct Limits {
    real error;
    real share;
    real least;
    real most;
};
struct ErrorBound {
    Limits limits;
    real size;
    real error;
};
struct Outcome {
    real lambda;
    bool hits;
    bool fails;
    char _pad3[2];
};
struct SquareTerms {
    real difference;
    real sum;
};
struct DoubleDouble {
    real high;
    real low;
};
struct DoubleDouble3_ {
    DoubleDouble x;
    DoubleDouble y;
    DoubleDouble z;
};
struct PreciseDecision {
    bool certain;
    bool some;
    char _pad2[2];
    DoubleDouble lambda;
    uint part;
};
struct PreciseLimits {
    real error;
    real share;
    real lambda_error;
};
struct PreciseBound {
    PreciseLimits limits;
    DoubleDouble size;
    DoubleDouble error;
};
struct PreciseOutcome {
    DoubleDouble lambda;
    bool hits;
    bool fails;
    char _pad3[2];
};
struct ExactReport {
    real step;
    real some;
    real lambda;
    real part;
    real plain;
    real plain_lambda;
    real compensated;
    real compensated_lambda;
    real doubled;
    real doubled_high;
    real doubled_low;
};
struct ExactSphereCase {
    PackedRay ray;
    PackedVec3_ center;
    real radius;
    real one;
};
typedef ExactSphereCase type_4[1];
typedef ExactReport type_5[1];
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

ExactSum exact_two_sum(
    real a_1,
    real b_1,
    real one
) {
    real sum = (a_1 * one) + b_1;
    real b_part = sum - a_1;
    real a_part = sum - b_part;
    return ExactSum {sum, (a_1 - a_part) + (b_1 - b_part)};
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
    real a_2
) {
    real _e4 = vec3_dot(direction_1, view.r_c);
    return SphereQuadratic {_e4, (_e4 * _e4) - (a_2 * view.c)};
}

Root sphere_first_root(
    real a_3,
    real h,
    real discriminant
) {
    float root_4 = metal::sqrt(discriminant);
    real near = (h - root_4) / a_3;
    real far = (h + root_4) / a_3;
    bool _e8 = in_range(near);
    real lambda_8 = _e8 ? near : far;
    bool _e10 = in_range(lambda_8);
    return Root {_e10, {}, lambda_8};
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
    float root_5 = metal::sqrt(quadratic.discriminant);
    real near_1 = (-(quadratic.h) - root_5) / quadratic.a;
    real far_1 = (-(quadratic.h) + root_5) / quadratic.a;
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
    real lambda_9 = _e9 / _e5;
    metal::float3 _e11 = ray_at(ray_4, lambda_9);
    real _e13 = vec3_length(_e11 - center_3);
    bool on_disc = _e13 <= cylinder_4.radius;
    bool _e20 = in_range(lambda_9);
    return Root {(!((metal::abs(_e5) < 0.00000001)) & _e20) & on_disc, {}, lambda_9};
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
    real lambda_10 = replaces ? later.lambda : closest_2.lambda;
    return CylinderRoot {closest_2.some | later.some, {}, lambda_10, replaces ? part_1 : closest_2.part};
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
    bool some_1 = !((_e5.discriminant < 0.0)) & _e6.some;
    CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_6, Root {some_1, {}, _e6.lambda});
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
    PackedRay ray_7
) {
    metal::float3 _e2 = vec3_load(ray_7.origin);
    metal::float3 _e4 = vec3_load(ray_7.direction);
    return Ray {_e2, _e4};
}

PackedRay ray_store(
    Ray ray_8
) {
    PackedVec3_ _e2 = vec3_store(ray_8.origin);
    PackedVec3_ _e4 = vec3_store(ray_8.direction);
    return PackedRay {_e2, _e4};
}

ExactHalves exact_halves(
    real a_4,
    thread real& exact_one
) {
    real large = a_4 * SPLITTER;
    real _e4 = exact_one;
    real high_2 = (large * _e4) - (large - a_4);
    return ExactHalves {high_2, a_4 - high_2};
}

ExactSum exact_two_product(
    real a_5,
    real b_2,
    thread real& exact_one
) {
    bool scales_a = SPLIT_LIMIT < metal::abs(a_5);
    bool scales_b = SPLIT_LIMIT < metal::abs(b_2);
    real x = scales_a ? (a_5 * SPLIT_SCALE) : a_5;
    real y = scales_b ? (b_2 * SPLIT_SCALE) : b_2;
    real product = x * y;
    ExactHalves _e15 = exact_halves(x, exact_one);
    ExactHalves _e16 = exact_halves(y, exact_one);
    real error = ((((_e15.high * _e16.high) - product) + (_e15.high * _e16.low)) + (_e15.low * _e16.high)) + (_e15.low * _e16.low);
    real unscaled = scales_a ? (error * SPLIT_UNSCALE) : error;
    return ExactSum {a_5 * b_2, scales_b ? (unscaled * SPLIT_UNSCALE) : unscaled};
}

real exact_mul_add(
    real a_6,
    real b_3,
    real c,
    thread real& exact_one
) {
    bool local = {};
    bool local_1 = {};
    bool local_2 = {};
    bool local_3 = {};
    ExactSum _e3 = exact_two_product(a_6, b_3, exact_one);
    real _e6 = exact_one;
    ExactSum _e7 = exact_two_sum(c, _e3.error, _e6);
    real _e11 = exact_one;
    ExactSum _e12 = exact_two_sum(_e3.sum, _e7.sum, _e11);
    real _e16 = exact_one;
    ExactSum _e17 = exact_two_sum(_e7.error, _e12.error, _e16);
    real _e21 = exact_one;
    ExactSum _e22 = exact_two_sum(_e12.sum, _e17.sum, _e21);
    real _e25 = exact_one;
    real neighbor = (_e22.sum * _e25) + (_e22.error * 1.5);
    bool is_tie = (_e22.error + _e22.error) == (neighbor - _e22.sum);
    if (0.0 < _e22.error) {
        local = 0.0 < _e17.error;
    } else {
        local = false;
    }
    bool _e45 = local;
    if (!(_e45)) {
        if (_e22.error < 0.0) {
            local_2 = _e17.error < 0.0;
        } else {
            local_2 = false;
        }
        bool _e56 = local_2;
        local_1 = _e56;
    } else {
        local_1 = true;
    }
    bool same_side = local_1;
    if (is_tie) {
        local_3 = same_side;
    } else {
        local_3 = false;
    }
    bool _e63 = local_3;
    return _e63 ? neighbor : _e22.sum;
}

Decision decision_uncertain(
) {
    return Decision {false, false, {}, 0.0, 0u};
}

Decision decision_miss(
) {
    return Decision {true, false, {}, 0.0, 0u};
}

Decision decision_hit(
    real lambda_5,
    uint part_2
) {
    return Decision {true, true, {}, lambda_5, part_2};
}

bool exact_in_scale(
    real length_squared
) {
    bool local_4 = {};
    if (SHORTEST_SQUARED <= length_squared) {
        local_4 = length_squared <= LONGEST_SQUARED;
    } else {
        local_4 = false;
    }
    bool _e8 = local_4;
    return _e8;
}

ErrorBound error_bound_new(
    Limits limits,
    real length_squared_1,
    real squares
) {
    real size = length_squared_1 * squares;
    return ErrorBound {limits, size, (size * limits.error) + ERROR_UNDERFLOW};
}

bool error_bound_misses(
    ErrorBound bound,
    real discriminant_1
) {
    return bound.error < -(discriminant_1);
}

bool error_bound_is_too_small(
    ErrorBound bound_1,
    real a_7,
    real numerator,
    real root
) {
    return bound_1.error < (((a_7 * bound_1.limits.least) - numerator) * root);
}

Outcome error_bound_root(
    ErrorBound bound_2,
    real a_8,
    real numerator_1,
    real root_1
) {
    bool local_5 = {};
    bool local_6 = {};
    real lambda_11 = numerator_1 / a_8;
    real share = bound_2.limits.share;
    real least = ((bound_2.size * share) + ERROR_UNDERFLOW) + ((numerator_1 * numerator_1) * (share * 4.0));
    bool accurate = least < (root_1 * numerator_1);
    bool finite = bound_2.size < ERROR_OVERFLOW;
    if (accurate) {
        local_5 = finite;
    } else {
        local_5 = false;
    }
    bool _e24 = local_5;
    if (_e24) {
        local_6 = bound_2.limits.most <= lambda_11;
    } else {
        local_6 = false;
    }
    bool hits = local_6;
    bool _e32 = error_bound_is_too_small(bound_2, a_8, numerator_1, root_1);
    return Outcome {lambda_11, hits, _e32};
}

Limits exact_sphere_limits(
) {
    return Limits {0.0000000000000035527137, 0.00008138021, 0.001, 0.001};
}

real exact_sphere_squares(
    SphereRecord sphere_3,
    metal::float3 r_c
) {
    real _e2 = vec3_dot(r_c, r_c);
    return _e2 + sphere_3.radius_squared;
}

Decision exact_sphere_filtered(
    SphereRecord sphere_4,
    Ray ray_9
) {
    bool local_7 = {};
    bool local_8 = {};
    real _e4 = vec3_dot(ray_9.direction, ray_9.direction);
    SphereView _e6 = sphere_seen_from(sphere_4, ray_9.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_9.direction, _e4);
    Limits _e9 = exact_sphere_limits();
    real _e11 = exact_sphere_squares(sphere_4, _e6.r_c);
    ErrorBound _e12 = error_bound_new(_e9, _e4, _e11);
    bool _e13 = exact_in_scale(_e4);
    if (!(_e13)) {
        Decision _e15 = decision_uncertain();
        return _e15;
    }
    bool _e17 = error_bound_misses(_e12, _e8.discriminant);
    if (_e17) {
        Decision _e18 = decision_miss();
        return _e18;
    }
    float root_6 = metal::sqrt(_e8.discriminant);
    Outcome _e23 = error_bound_root(_e12, _e4, _e8.h - root_6, root_6);
    if (!(_e23.fails)) {
        local_7 = _e23.hits;
    } else {
        local_7 = false;
    }
    bool _e30 = local_7;
    if (_e30) {
        Decision _e33 = decision_hit(_e23.lambda, SIDE);
        return _e33;
    }
    Outcome _e36 = error_bound_root(_e12, _e4, _e8.h + root_6, root_6);
    if (_e23.fails) {
        local_8 = _e36.hits;
    } else {
        local_8 = false;
    }
    bool _e42 = local_8;
    if (_e42) {
        Decision _e45 = decision_hit(_e36.lambda, SIDE);
        return _e45;
    }
    if (_e36.fails) {
        Decision _e47 = decision_miss();
        return _e47;
    }
    Decision _e48 = decision_uncertain();
    return _e48;
}

SquareTerms exact_square_terms(
    SphereRecord sphere_5,
    metal::float3 origin_2,
    thread real& exact_one
) {
    real _e7 = exact_one;
    ExactSum _e8 = exact_two_sum(sphere_5.center[0], -(origin_2.x), _e7);
    real _e14 = exact_one;
    ExactSum _e15 = exact_two_sum(sphere_5.center[1], -(origin_2.y), _e14);
    real _e21 = exact_one;
    ExactSum _e22 = exact_two_sum(sphere_5.center[2], -(origin_2.z), _e21);
    ExactSum _e25 = exact_two_product(_e8.sum, _e8.sum, exact_one);
    ExactSum _e28 = exact_two_product(_e15.sum, _e15.sum, exact_one);
    ExactSum _e31 = exact_two_product(_e22.sum, _e22.sum, exact_one);
    ExactSum _e34 = exact_two_product(sphere_5.radius, sphere_5.radius, exact_one);
    real _e38 = exact_one;
    ExactSum _e39 = exact_two_sum(_e25.sum, _e28.sum, _e38);
    real _e43 = exact_one;
    ExactSum _e44 = exact_two_sum(_e39.sum, _e31.sum, _e43);
    real _e49 = exact_one;
    ExactSum _e50 = exact_two_sum(_e44.sum, -(_e34.sum), _e49);
    real _e58 = exact_mul_add(_e15.sum, _e15.error, _e22.sum * _e22.error, exact_one);
    real _e59 = exact_mul_add(_e8.sum, _e8.error, _e58, exact_one);
    real sums = (_e39.error + _e44.error) + _e50.error;
    real products = (_e25.error + _e28.error) + (_e31.error - _e34.error);
    return SquareTerms {_e50.sum + ((sums + products) + (_e59 + _e59)), _e44.sum + _e34.sum};
}

Decision exact_sphere_compensated(
    SphereRecord sphere_6,
    Ray ray_10,
    thread real& exact_one
) {
    bool local_9 = {};
    bool local_10 = {};
    bool local_11 = {};
    bool local_12 = {};
    bool local_13 = {};
    real _e4 = vec3_dot(ray_10.direction, ray_10.direction);
    SphereView _e6 = sphere_seen_from(sphere_6, ray_10.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_10.direction, _e4);
    float root_7 = metal::sqrt(_e8.discriminant);
    SquareTerms _e12 = exact_square_terms(sphere_6, ray_10.origin, exact_one);
    float denominator = metal::abs(_e8.h) + root_7;
    float lambda_12 = metal::abs(_e12.difference) / denominator;
    real size_1 = _e4 * _e12.sum;
    if ((size_1 + ERROR_UNDERFLOW) < ((root_7 * denominator) * 4096.0)) {
        local_9 = size_1 < ERROR_OVERFLOW;
    } else {
        local_9 = false;
    }
    bool accurate_1 = local_9;
    bool c_is_large = ((_e12.sum * 0.0000000000000071054274) + ERROR_UNDERFLOW) < metal::abs(_e12.difference);
    bool ahead = 0.0 < (_e8.h * _e12.difference);
    bool _e46 = exact_in_scale(_e4);
    if (_e46) {
        local_10 = accurate_1;
    } else {
        local_10 = false;
    }
    bool _e50 = local_10;
    if (_e50) {
        local_11 = c_is_large;
    } else {
        local_11 = false;
    }
    bool _e54 = local_11;
    if (_e54) {
        local_12 = ahead;
    } else {
        local_12 = false;
    }
    bool _e58 = local_12;
    if (_e58) {
        Limits _e61 = exact_sphere_limits();
        local_13 = _e61.most <= lambda_12;
    } else {
        local_13 = false;
    }
    bool _e65 = local_13;
    if (_e65) {
        Decision _e67 = decision_hit(lambda_12, SIDE);
        return _e67;
    }
    Decision _e68 = decision_uncertain();
    return _e68;
}

DoubleDouble dd_of(
    real high
) {
    return DoubleDouble {high, 0.0};
}

DoubleDouble dd_constant(
    real high_1,
    thread real& exact_one
) {
    real _e2 = exact_one;
    DoubleDouble _e4 = dd_of(high_1 * _e2);
    return _e4;
}

DoubleDouble dd_fast_two_sum(
    real a_9,
    real b_4,
    thread real& exact_one
) {
    real _e3 = exact_one;
    real high_3 = (a_9 * _e3) + b_4;
    return DoubleDouble {high_3, b_4 - (high_3 - a_9)};
}

DoubleDouble dd_add(
    DoubleDouble a_10,
    DoubleDouble b_5,
    thread real& exact_one
) {
    real _e5 = exact_one;
    ExactSum _e6 = exact_two_sum(a_10.high, b_5.high, _e5);
    real _e10 = exact_one;
    ExactSum _e11 = exact_two_sum(a_10.low, b_5.low, _e10);
    DoubleDouble _e16 = dd_fast_two_sum(_e6.sum, _e6.error + _e11.sum, exact_one);
    DoubleDouble _e21 = dd_fast_two_sum(_e16.high, _e16.low + _e11.error, exact_one);
    return _e21;
}

DoubleDouble dd_neg(
    DoubleDouble a_11
) {
    return DoubleDouble {-(a_11.high), -(a_11.low)};
}

DoubleDouble dd_sub(
    DoubleDouble a_12,
    DoubleDouble b_6,
    thread real& exact_one
) {
    DoubleDouble _e2 = dd_neg(b_6);
    DoubleDouble _e3 = dd_add(a_12, _e2, exact_one);
    return _e3;
}

DoubleDouble dd_mul(
    DoubleDouble a_13,
    DoubleDouble b_7,
    thread real& exact_one
) {
    ExactSum _e4 = exact_two_product(a_13.high, b_7.high, exact_one);
    real _e12 = exact_mul_add(a_13.high, b_7.low, a_13.low * b_7.low, exact_one);
    real _e13 = exact_mul_add(a_13.low, b_7.high, _e12, exact_one);
    DoubleDouble _e17 = dd_fast_two_sum(_e4.sum, _e4.error + _e13, exact_one);
    return _e17;
}

DoubleDouble dd_div(
    DoubleDouble a_14,
    DoubleDouble b_8,
    thread real& exact_one
) {
    real high_4 = a_14.high / b_8.high;
    ExactSum _e6 = exact_two_product(b_8.high, high_4, exact_one);
    real _e10 = exact_mul_add(b_8.low, high_4, _e6.error, exact_one);
    DoubleDouble _e11 = dd_fast_two_sum(_e6.sum, _e10, exact_one);
    real remainder = (a_14.high - _e11.high) + (a_14.low - _e11.low);
    DoubleDouble _e21 = dd_fast_two_sum(high_4, remainder / b_8.high, exact_one);
    return _e21;
}

DoubleDouble dd_sqrt(
    DoubleDouble a_15,
    thread real& exact_one
) {
    if (a_15.high == 0.0) {
        return a_15;
    }
    real _e7 = exact_one;
    real high_5 = metal::sqrt(a_15.high) * _e7;
    real _e11 = exact_mul_add(-(high_5), high_5, a_15.high, exact_one);
    real remainder_1 = _e11 + a_15.low;
    DoubleDouble _e16 = dd_fast_two_sum(high_5, remainder_1 / (high_5 + high_5), exact_one);
    return _e16;
}

DoubleDouble dd_abs(
    DoubleDouble a_16
) {
    if (a_16.high < 0.0) {
        DoubleDouble _e4 = dd_neg(a_16);
        return _e4;
    }
    return a_16;
}

bool dd_less(
    DoubleDouble a_17,
    DoubleDouble b_9
) {
    bool local_14 = {};
    bool local_15 = {};
    if (!((a_17.high < b_9.high))) {
        if (a_17.high == b_9.high) {
            local_15 = a_17.low < b_9.low;
        } else {
            local_15 = false;
        }
        bool _e17 = local_15;
        local_14 = _e17;
    } else {
        local_14 = true;
    }
    bool _e19 = local_14;
    return _e19;
}

bool dd_less_equal(
    DoubleDouble a_18,
    DoubleDouble b_10
) {
    bool local_16 = {};
    bool local_17 = {};
    if (!((a_18.high < b_10.high))) {
        if (a_18.high == b_10.high) {
            local_17 = a_18.low <= b_10.low;
        } else {
            local_17 = false;
        }
        bool _e17 = local_17;
        local_16 = _e17;
    } else {
        local_16 = true;
    }
    bool _e19 = local_16;
    return _e19;
}

DoubleDouble3_ dd3_of(
    metal::float3 v_7
) {
    DoubleDouble _e2 = dd_of(v_7.x);
    DoubleDouble _e4 = dd_of(v_7.y);
    DoubleDouble _e6 = dd_of(v_7.z);
    return DoubleDouble3_ {_e2, _e4, _e6};
}

DoubleDouble3_ dd3_add(
    DoubleDouble3_ a_19,
    DoubleDouble3_ b_11,
    thread real& exact_one
) {
    DoubleDouble _e4 = dd_add(a_19.x, b_11.x, exact_one);
    DoubleDouble _e7 = dd_add(a_19.y, b_11.y, exact_one);
    DoubleDouble _e10 = dd_add(a_19.z, b_11.z, exact_one);
    return DoubleDouble3_ {_e4, _e7, _e10};
}

DoubleDouble3_ dd3_sub(
    DoubleDouble3_ a_20,
    DoubleDouble3_ b_12,
    thread real& exact_one
) {
    DoubleDouble _e4 = dd_sub(a_20.x, b_12.x, exact_one);
    DoubleDouble _e7 = dd_sub(a_20.y, b_12.y, exact_one);
    DoubleDouble _e10 = dd_sub(a_20.z, b_12.z, exact_one);
    return DoubleDouble3_ {_e4, _e7, _e10};
}

DoubleDouble3_ dd3_scaled(
    DoubleDouble3_ v_8,
    DoubleDouble factor,
    thread real& exact_one
) {
    DoubleDouble _e3 = dd_mul(v_8.x, factor, exact_one);
    DoubleDouble _e5 = dd_mul(v_8.y, factor, exact_one);
    DoubleDouble _e7 = dd_mul(v_8.z, factor, exact_one);
    return DoubleDouble3_ {_e3, _e5, _e7};
}

DoubleDouble3_ dd3_divided(
    DoubleDouble3_ v_9,
    DoubleDouble divisor,
    thread real& exact_one
) {
    DoubleDouble _e3 = dd_div(v_9.x, divisor, exact_one);
    DoubleDouble _e5 = dd_div(v_9.y, divisor, exact_one);
    DoubleDouble _e7 = dd_div(v_9.z, divisor, exact_one);
    return DoubleDouble3_ {_e3, _e5, _e7};
}

DoubleDouble dd3_dot(
    DoubleDouble3_ a_21,
    DoubleDouble3_ b_13,
    thread real& exact_one
) {
    DoubleDouble _e4 = dd_mul(a_21.x, b_13.x, exact_one);
    DoubleDouble _e7 = dd_mul(a_21.y, b_13.y, exact_one);
    DoubleDouble _e8 = dd_add(_e4, _e7, exact_one);
    DoubleDouble _e11 = dd_mul(a_21.z, b_13.z, exact_one);
    DoubleDouble _e12 = dd_add(_e8, _e11, exact_one);
    return _e12;
}

DoubleDouble dd3_magnitude(
    DoubleDouble3_ v_10,
    thread real& exact_one
) {
    DoubleDouble _e2 = dd_abs(v_10.x);
    DoubleDouble _e4 = dd_abs(v_10.y);
    DoubleDouble _e5 = dd_add(_e2, _e4, exact_one);
    DoubleDouble _e7 = dd_abs(v_10.z);
    DoubleDouble _e8 = dd_add(_e5, _e7, exact_one);
    return _e8;
}

DoubleDouble3_ dd3_perpendicular_to(
    DoubleDouble3_ v_11,
    DoubleDouble3_ axis_3,
    thread real& exact_one
) {
    DoubleDouble _e2 = dd3_dot(v_11, axis_3, exact_one);
    DoubleDouble3_ _e3 = dd3_scaled(axis_3, _e2, exact_one);
    DoubleDouble3_ _e4 = dd3_sub(v_11, _e3, exact_one);
    return _e4;
}

PreciseDecision precise_uncertain(
    thread real& exact_one
) {
    DoubleDouble _e3 = dd_constant(0.0, exact_one);
    return PreciseDecision {false, false, {}, _e3, SIDE};
}

PreciseDecision precise_miss(
    thread real& exact_one
) {
    DoubleDouble _e3 = dd_constant(0.0, exact_one);
    return PreciseDecision {true, false, {}, _e3, SIDE};
}

PreciseDecision precise_hit(
    DoubleDouble lambda_6,
    uint part_3
) {
    return PreciseDecision {true, true, {}, lambda_6, part_3};
}

PreciseBound precise_bound_new(
    PreciseLimits limits_1,
    DoubleDouble length_squared_2,
    DoubleDouble squares_1,
    thread real& exact_one
) {
    DoubleDouble _e3 = dd_mul(length_squared_2, squares_1, exact_one);
    DoubleDouble _e5 = dd_constant(limits_1.error, exact_one);
    DoubleDouble _e6 = dd_mul(_e3, _e5, exact_one);
    DoubleDouble _e8 = dd_constant(ERROR_UNDERFLOW, exact_one);
    DoubleDouble _e9 = dd_add(_e6, _e8, exact_one);
    return PreciseBound {limits_1, _e3, _e9};
}

bool precise_bound_misses(
    PreciseBound bound_3,
    DoubleDouble discriminant_2
) {
    DoubleDouble _e3 = dd_neg(discriminant_2);
    bool _e4 = dd_less(bound_3.error, _e3);
    return _e4;
}

bool precise_in_scale(
    DoubleDouble length_squared_3,
    thread real& exact_one
) {
    bool local_18 = {};
    DoubleDouble _e2 = dd_constant(SHORTEST_SQUARED, exact_one);
    bool _e3 = dd_less_equal(_e2, length_squared_3);
    if (_e3) {
        DoubleDouble _e7 = dd_constant(LONGEST_SQUARED, exact_one);
        bool _e8 = dd_less_equal(length_squared_3, _e7);
        local_18 = _e8;
    } else {
        local_18 = false;
    }
    bool _e10 = local_18;
    return _e10;
}

DoubleDouble precise_least_lambda(
    thread real& exact_one
) {
    real _e2 = exact_one;
    real _e6 = exact_one;
    return DoubleDouble {0.001 * _e2, -0.00000000000000000010842022 * _e6};
}

bool precise_in_range(
    PreciseLimits limits_2,
    DoubleDouble lambda_7,
    thread real& exact_one
) {
    DoubleDouble _e2 = precise_least_lambda(exact_one);
    DoubleDouble _e4 = dd_constant(limits_2.lambda_error, exact_one);
    DoubleDouble _e5 = dd_add(_e2, _e4, exact_one);
    bool _e6 = dd_less_equal(_e5, lambda_7);
    return _e6;
}

bool precise_bound_is_too_small(
    PreciseBound bound_4,
    DoubleDouble a_22,
    DoubleDouble numerator_2,
    DoubleDouble root_2,
    thread real& exact_one
) {
    DoubleDouble _e4 = precise_least_lambda(exact_one);
    DoubleDouble _e7 = dd_constant(bound_4.limits.lambda_error, exact_one);
    DoubleDouble _e8 = dd_sub(_e4, _e7, exact_one);
    DoubleDouble _e10 = dd_mul(a_22, _e8, exact_one);
    DoubleDouble _e11 = dd_sub(_e10, numerator_2, exact_one);
    DoubleDouble _e12 = dd_mul(_e11, root_2, exact_one);
    bool _e13 = dd_less(bound_4.error, _e12);
    return _e13;
}

PreciseOutcome precise_bound_root(
    PreciseBound bound_5,
    DoubleDouble a_23,
    DoubleDouble numerator_3,
    DoubleDouble root_3,
    thread real& exact_one
) {
    bool local_19 = {};
    bool local_20 = {};
    DoubleDouble _e4 = dd_div(numerator_3, a_23, exact_one);
    real share_1 = bound_5.limits.share;
    DoubleDouble _e8 = dd_constant(share_1, exact_one);
    DoubleDouble _e9 = dd_mul(bound_5.size, _e8, exact_one);
    DoubleDouble _e11 = dd_constant(ERROR_UNDERFLOW, exact_one);
    DoubleDouble _e12 = dd_add(_e9, _e11, exact_one);
    DoubleDouble _e13 = dd_mul(numerator_3, numerator_3, exact_one);
    DoubleDouble _e16 = dd_constant(share_1 * 4.0, exact_one);
    DoubleDouble _e17 = dd_mul(_e13, _e16, exact_one);
    DoubleDouble _e18 = dd_add(_e12, _e17, exact_one);
    DoubleDouble _e19 = dd_mul(root_3, numerator_3, exact_one);
    bool _e20 = dd_less(_e18, _e19);
    DoubleDouble _e23 = dd_constant(ERROR_OVERFLOW, exact_one);
    bool _e24 = dd_less(bound_5.size, _e23);
    if (_e20) {
        local_19 = _e24;
    } else {
        local_19 = false;
    }
    bool _e28 = local_19;
    if (_e28) {
        bool _e32 = precise_in_range(bound_5.limits, _e4, exact_one);
        local_20 = _e32;
    } else {
        local_20 = false;
    }
    bool hits_1 = local_20;
    bool _e35 = precise_bound_is_too_small(bound_5, a_23, numerator_3, root_3, exact_one);
    return PreciseOutcome {_e4, hits_1, _e35};
}

PreciseLimits precise_sphere_limits(
) {
    return PreciseLimits {0.0000000000000000000000000000063108872, 0.0000000000048506386, 0.000000000000000000010408341};
}

PreciseDecision precise_sphere_filtered(
    metal::float3 center_4,
    real radius_3,
    Ray ray_11,
    thread real& exact_one
) {
    bool local_21 = {};
    bool local_22 = {};
    DoubleDouble3_ _e4 = dd3_of(ray_11.direction);
    DoubleDouble _e5 = dd3_dot(_e4, _e4, exact_one);
    DoubleDouble _e6 = dd_of(radius_3);
    DoubleDouble _e7 = dd_of(radius_3);
    DoubleDouble _e8 = dd_mul(_e6, _e7, exact_one);
    DoubleDouble3_ _e9 = dd3_of(center_4);
    DoubleDouble3_ _e11 = dd3_of(ray_11.origin);
    DoubleDouble3_ _e12 = dd3_sub(_e9, _e11, exact_one);
    DoubleDouble _e13 = dd3_dot(_e12, _e12, exact_one);
    DoubleDouble _e14 = dd_sub(_e13, _e8, exact_one);
    DoubleDouble _e15 = dd3_dot(_e4, _e12, exact_one);
    DoubleDouble _e16 = dd_mul(_e15, _e15, exact_one);
    DoubleDouble _e17 = dd_mul(_e5, _e14, exact_one);
    DoubleDouble _e18 = dd_sub(_e16, _e17, exact_one);
    PreciseLimits _e19 = precise_sphere_limits();
    DoubleDouble _e20 = dd_add(_e13, _e8, exact_one);
    PreciseBound _e21 = precise_bound_new(_e19, _e5, _e20, exact_one);
    bool _e22 = precise_in_scale(_e5, exact_one);
    if (!(_e22)) {
        PreciseDecision _e24 = precise_uncertain(exact_one);
        return _e24;
    }
    bool _e25 = precise_bound_misses(_e21, _e18);
    if (_e25) {
        PreciseDecision _e26 = precise_miss(exact_one);
        return _e26;
    }
    DoubleDouble _e27 = dd_sqrt(_e18, exact_one);
    DoubleDouble _e28 = dd_sub(_e15, _e27, exact_one);
    PreciseOutcome _e29 = precise_bound_root(_e21, _e5, _e28, _e27, exact_one);
    if (!(_e29.fails)) {
        local_21 = _e29.hits;
    } else {
        local_21 = false;
    }
    bool _e36 = local_21;
    if (_e36) {
        PreciseDecision _e39 = precise_hit(_e29.lambda, SIDE);
        return _e39;
    }
    DoubleDouble _e40 = dd_add(_e15, _e27, exact_one);
    PreciseOutcome _e41 = precise_bound_root(_e21, _e5, _e40, _e27, exact_one);
    if (_e29.fails) {
        local_22 = _e41.hits;
    } else {
        local_22 = false;
    }
    bool _e47 = local_22;
    if (_e47) {
        PreciseDecision _e50 = precise_hit(_e41.lambda, SIDE);
        return _e50;
    }
    if (_e41.fails) {
        PreciseDecision _e52 = precise_miss(exact_one);
        return _e52;
    }
    PreciseDecision _e53 = precise_uncertain(exact_one);
    return _e53;
}

real exact_code(
    bool certain,
    bool some,
    uint part_4
) {
    if (!(certain)) {
        return 0.0;
    }
    return some ? static_cast<float>(2u + part_4) : 1.0;
}

ExactReport exact_report(
    Decision plain,
    Decision compensated,
    PreciseDecision doubled
) {
    ExactReport report = {};
    Decision answer = {};
    real _e8 = exact_code(plain.certain, plain.some, plain.part);
    report.plain = _e8;
    report.plain_lambda = plain.lambda;
    real _e15 = exact_code(compensated.certain, compensated.some, compensated.part);
    report.compensated = _e15;
    report.compensated_lambda = compensated.lambda;
    real _e22 = exact_code(doubled.certain, doubled.some, doubled.part);
    report.doubled = _e22;
    report.doubled_high = doubled.lambda.high;
    report.doubled_low = doubled.lambda.low;
    answer = plain;
    report.step = 1.0;
    if (!(plain.certain)) {
        answer = compensated;
        report.step = 2.0;
        if (!(compensated.certain)) {
            answer = Decision {doubled.certain, doubled.some, {}, doubled.lambda.high, doubled.part};
            report.step = doubled.certain ? 3.0 : 0.0;
        }
    }
    bool _e53 = answer.some;
    report.some = _e53 ? 1.0 : 0.0;
    real _e57 = answer.lambda;
    report.lambda = _e57;
    uint _e60 = answer.part;
    report.part = static_cast<float>(_e60);
    ExactReport _e62 = report;
    return _e62;
}

struct exact_sphereInput {
};
kernel void exact_sphere(
  metal::uint3 id [[thread_position_in_grid]]
, device type_4 const& cases [[buffer(0)]]
, device type_5& reports [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    real exact_one = {};
    if (id.x >= (1 + (_buffer_sizes.size1 - 0 - 44) / 44)) {
        return;
    }
    real _e10 = cases[id.x].one;
    exact_one = _e10;
    PackedRay _e15 = cases[id.x].ray;
    Ray _e16 = ray_load(_e15);
    PackedVec3_ _e21 = cases[id.x].center;
    metal::float3 _e22 = vec3_load(_e21);
    real radius_4 = cases[id.x].radius;
    SphereRecord _e28 = sphere_new(_e22, radius_4);
    Decision _e29 = exact_sphere_filtered(_e28, _e16);
    Decision _e30 = exact_sphere_compensated(_e28, _e16, exact_one);
    PreciseDecision _e34 = precise_sphere_filtered(_e22, radius_4, _e16, exact_one);
    ExactReport _e35 = exact_report(_e29, _e30, _e34);
    reports[id.x] = _e35;
    return;
}
