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
struct ExactSide {
    ErrorBound bound;
    real length_squared;
    real a;
    real h;
    real discriminant;
    real along;
    real slope;
};
struct ExactCrossing {
    real lambda;
    bool hits;
    bool straight;
    bool behind;
    bool above;
    bool below;
    char _pad6[3];
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
struct PreciseCylinder {
    DoubleDouble3_ center;
    DoubleDouble3_ axis;
    DoubleDouble radius;
    DoubleDouble radius_squared;
    DoubleDouble half_height;
};
struct PreciseSide {
    PreciseBound bound;
    DoubleDouble length_squared;
    DoubleDouble a;
    DoubleDouble h;
    DoubleDouble discriminant;
    DoubleDouble along;
    DoubleDouble slope;
};
struct PreciseCrossing {
    DoubleDouble lambda;
    bool hits;
    bool straight;
    bool behind;
    bool above;
    bool below;
    char _pad6[3];
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
struct ExactCylinderCase {
    PackedRay ray;
    PackedVec3_ center;
    real radius;
    PackedVec3_ axis;
    real one;
};
typedef ExactCylinderCase type_4[1];
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
    CylinderRecord cylinder,
    metal::float3 origin
) {
    metal::float3 _e5 = vec3_perpendicular_to(origin - cylinder.center, cylinder.axis);
    real _e6 = vec3_dot(_e5, _e5);
    return CylinderView {_e5, _e6 - cylinder.radius_squared};
}

CylinderQuadratic cylinder_quadratic(
    CylinderRecord cylinder_1,
    CylinderView view,
    metal::float3 along
) {
    metal::float3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    real _e5 = vec3_dot(_e4, _e4);
    real _e7 = vec3_dot(view.r_c, _e4);
    return CylinderQuadratic {_e5, _e7, (_e7 * _e7) - (_e5 * view.c)};
}

bool cylinder_within_height(
    CylinderRecord cylinder_2,
    Ray ray_1,
    real lambda_4
) {
    metal::float3 _e3 = ray_at(ray_1, lambda_4);
    real _e7 = vec3_dot(_e3 - cylinder_2.center, cylinder_2.axis);
    return metal::abs(_e7) <= cylinder_2.half_height;
}

Root cylinder_side(
    CylinderRecord cylinder_3,
    Ray ray_2,
    CylinderQuadratic quadratic
) {
    float root_6 = metal::sqrt(quadratic.discriminant);
    real near = (-(quadratic.h) - root_6) / quadratic.a;
    real far = (-(quadratic.h) + root_6) / quadratic.a;
    bool _e15 = in_range(near);
    bool _e16 = cylinder_within_height(cylinder_3, ray_2, near);
    bool near_counts = _e15 & _e16;
    bool _e18 = in_range(far);
    bool _e19 = cylinder_within_height(cylinder_3, ray_2, far);
    bool far_counts = _e18 & _e19;
    return Root {near_counts | far_counts, {}, near_counts ? near : far};
}

Root cylinder_cap(
    CylinderRecord cylinder_4,
    Ray ray_3,
    metal::float3 center_2
) {
    real _e5 = vec3_dot(ray_3.direction, cylinder_4.axis);
    real _e9 = vec3_dot(center_2 - ray_3.origin, cylinder_4.axis);
    real lambda_10 = _e9 / _e5;
    metal::float3 _e11 = ray_at(ray_3, lambda_10);
    real _e13 = vec3_length(_e11 - center_2);
    bool on_disc = _e13 <= cylinder_4.radius;
    bool _e20 = in_range(lambda_10);
    return Root {(!((metal::abs(_e5) < 0.00000001)) & _e20) & on_disc, {}, lambda_10};
}

metal::float3 cylinder_outward(
    CylinderRecord cylinder_5,
    uint part,
    metal::float3 point_1
) {
    metal::float3 _e6 = vec3_perpendicular_to(point_1 - cylinder_5.center, cylinder_5.axis);
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
    real lambda_11 = replaces ? later.lambda : closest_2.lambda;
    return CylinderRoot {closest_2.some | later.some, {}, lambda_11, replaces ? part_1 : closest_2.part};
}

CylinderRoot cylinder_with_caps(
    CylinderRecord cylinder_6,
    Ray ray_4,
    Root side
) {
    Root _e4 = cylinder_cap(cylinder_6, ray_4, cylinder_6.top);
    Root _e6 = cylinder_cap(cylinder_6, ray_4, cylinder_6.bottom);
    CylinderRoot _e12 = cylinder_closer(CylinderRoot {side.some, {}, side.lambda, SIDE}, _e4, TOP);
    CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    return _e14;
}

CylinderRoot cylinder_intersect(
    CylinderRecord cylinder_7,
    Ray ray_5
) {
    CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_5.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_5.direction);
    Root _e6 = cylinder_side(cylinder_7, ray_5, _e5);
    bool some_1 = !((_e5.discriminant < 0.0)) & _e6.some;
    CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_5, Root {some_1, {}, _e6.lambda});
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

ExactHalves exact_halves(
    real a_2,
    thread real& exact_one
) {
    real large = a_2 * SPLITTER;
    real _e4 = exact_one;
    real high_2 = (large * _e4) - (large - a_2);
    return ExactHalves {high_2, a_2 - high_2};
}

ExactSum exact_two_product(
    real a_3,
    real b_2,
    thread real& exact_one
) {
    bool scales_a = SPLIT_LIMIT < metal::abs(a_3);
    bool scales_b = SPLIT_LIMIT < metal::abs(b_2);
    real x = scales_a ? (a_3 * SPLIT_SCALE) : a_3;
    real y = scales_b ? (b_2 * SPLIT_SCALE) : b_2;
    real product = x * y;
    ExactHalves _e15 = exact_halves(x, exact_one);
    ExactHalves _e16 = exact_halves(y, exact_one);
    real error = ((((_e15.high * _e16.high) - product) + (_e15.high * _e16.low)) + (_e15.low * _e16.high)) + (_e15.low * _e16.low);
    real unscaled = scales_a ? (error * SPLIT_UNSCALE) : error;
    return ExactSum {a_3 * b_2, scales_b ? (unscaled * SPLIT_UNSCALE) : unscaled};
}

real exact_mul_add(
    real a_4,
    real b_3,
    real c,
    thread real& exact_one
) {
    bool local = {};
    bool local_1 = {};
    bool local_2 = {};
    bool local_3 = {};
    ExactSum _e3 = exact_two_product(a_4, b_3, exact_one);
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
    real discriminant
) {
    return bound.error < -(discriminant);
}

bool error_bound_is_too_small(
    ErrorBound bound_1,
    real a_5,
    real numerator,
    real root
) {
    return bound_1.error < (((a_5 * bound_1.limits.least) - numerator) * root);
}

Outcome error_bound_root(
    ErrorBound bound_2,
    real a_6,
    real numerator_1,
    real root_1
) {
    bool local_5 = {};
    bool local_6 = {};
    real lambda_12 = numerator_1 / a_6;
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
        local_6 = bound_2.limits.most <= lambda_12;
    } else {
        local_6 = false;
    }
    bool hits = local_6;
    bool _e32 = error_bound_is_too_small(bound_2, a_6, numerator_1, root_1);
    return Outcome {lambda_12, hits, _e32};
}

Limits exact_cylinder_limits(
) {
    return Limits {0.000000000000021316282, 0.000015258789, 0.001, 0.001};
}

real exact_magnitude(
    metal::float3 v_7
) {
    return (metal::abs(v_7.x) + metal::abs(v_7.y)) + metal::abs(v_7.z);
}

real exact_cylinder_extent(
    CylinderRecord cylinder_8
) {
    real _e2 = exact_magnitude(cylinder_8.center);
    return ((_e2 + cylinder_8.radius) + cylinder_8.half_height) + EXTENT_UNDERFLOW;
}

real exact_cylinder_margin(
    CylinderRecord cylinder_9,
    Ray ray_8,
    real lambda_6
) {
    real _e4 = exact_magnitude(ray_8.direction);
    float along_1 = (lambda_6 * _e4) * 0.0000000037252903;
    real _e8 = exact_cylinder_extent(cylinder_9);
    return along_1 + (_e8 * 0.0000000000000071054274);
}

ExactSide exact_side_new(
    CylinderRecord cylinder_10,
    Ray ray_9
) {
    metal::float3 from_center = ray_9.origin - cylinder_10.center;
    CylinderView _e6 = cylinder_seen_from(cylinder_10, ray_9.origin);
    CylinderQuadratic _e8 = cylinder_quadratic(cylinder_10, _e6, ray_9.direction);
    real _e11 = vec3_dot(ray_9.direction, ray_9.direction);
    real _e12 = vec3_dot(from_center, from_center);
    real squares_2 = _e12 + cylinder_10.radius_squared;
    Limits _e15 = exact_cylinder_limits();
    ErrorBound _e16 = error_bound_new(_e15, _e11, squares_2);
    real _e18 = vec3_dot(from_center, cylinder_10.axis);
    real _e21 = vec3_dot(ray_9.direction, cylinder_10.axis);
    return ExactSide {_e16, _e11, _e8.a, _e8.h, _e8.discriminant, _e18, _e21};
}

ExactCrossing exact_side_crossing(
    ExactSide side_1,
    CylinderRecord cylinder_11,
    Ray ray_10,
    real numerator_2,
    real root_2
) {
    bool local_7 = {};
    bool local_8 = {};
    bool local_9 = {};
    bool local_10 = {};
    bool local_11 = {};
    bool local_12 = {};
    bool steep_enough = side_1.length_squared <= (side_1.a * 274877900000.0);
    Outcome _e12 = error_bound_root(side_1.bound, side_1.a, numerator_2, root_2);
    real along_2 = side_1.along + (_e12.lambda * side_1.slope);
    real _e19 = exact_cylinder_margin(cylinder_11, ray_10, _e12.lambda);
    if (steep_enough) {
        local_7 = _e12.hits;
    } else {
        local_7 = false;
    }
    bool accurate_1 = local_7;
    real within = cylinder_11.half_height - _e19;
    real beyond = cylinder_11.half_height + _e19;
    if (accurate_1) {
        local_8 = metal::abs(along_2) < within;
    } else {
        local_8 = false;
    }
    bool hits_1 = local_8;
    if (hits_1) {
        local_9 = metal::abs(side_1.along) < within;
    } else {
        local_9 = false;
    }
    bool straight = local_9;
    if (steep_enough) {
        local_10 = _e12.fails;
    } else {
        local_10 = false;
    }
    bool behind = local_10;
    if (accurate_1) {
        local_11 = beyond < along_2;
    } else {
        local_11 = false;
    }
    bool _e52 = local_11;
    if (accurate_1) {
        local_12 = beyond < -(along_2);
    } else {
        local_12 = false;
    }
    bool _e58 = local_12;
    return ExactCrossing {_e12.lambda, hits_1, straight, behind, _e52, _e58};
}

bool exact_crossing_fails(
    ExactCrossing crossing
) {
    bool local_13 = {};
    bool local_14 = {};
    if (!(crossing.behind)) {
        local_13 = crossing.above;
    } else {
        local_13 = true;
    }
    bool _e7 = local_13;
    if (!(_e7)) {
        local_14 = crossing.below;
    } else {
        local_14 = true;
    }
    bool _e13 = local_14;
    return _e13;
}

bool exact_crossing_passes_by(
    ExactCrossing entry,
    ExactCrossing leaving
) {
    bool local_15 = {};
    bool local_16 = {};
    bool local_17 = {};
    bool local_18 = {};
    if (!(leaving.behind)) {
        if (entry.above) {
            local_16 = leaving.above;
        } else {
            local_16 = false;
        }
        bool _e11 = local_16;
        local_15 = _e11;
    } else {
        local_15 = true;
    }
    bool _e13 = local_15;
    if (!(_e13)) {
        if (entry.below) {
            local_18 = leaving.below;
        } else {
            local_18 = false;
        }
        bool _e22 = local_18;
        local_17 = _e22;
    } else {
        local_17 = true;
    }
    bool _e24 = local_17;
    return _e24;
}

Decision exact_cap_filtered(
    CylinderRecord cylinder_12,
    Ray ray_11,
    metal::float3 center_3,
    uint part_3
) {
    bool local_19 = {};
    bool local_20 = {};
    bool local_21 = {};
    bool local_22 = {};
    bool local_23 = {};
    bool local_24 = {};
    bool local_25 = {};
    metal::float3 to_center = center_3 - ray_11.origin;
    real _e7 = vec3_dot(to_center, cylinder_12.axis);
    real _e10 = vec3_dot(ray_11.direction, cylinder_12.axis);
    float steepness = metal::abs(_e10);
    real _e13 = exact_magnitude(ray_11.direction);
    float slope_error = _e13 * 0.0000000000000008881784;
    if ((steepness + slope_error) < 0.00000001) {
        Decision _e19 = decision_miss();
        return _e19;
    }
    bool steep = (0.00000001 + slope_error) < steepness;
    real distance_1 = (_e10 < 0.0) ? -(_e7) : _e7;
    real _e27 = exact_cylinder_extent(cylinder_12);
    real _e28 = exact_magnitude(to_center);
    real size_1 = _e27 + _e28;
    float distance_error = size_1 * 0.0000000000000017763568;
    if (steep) {
        local_19 = (distance_1 + distance_error) < ((steepness - slope_error) * 0.001);
    } else {
        local_19 = false;
    }
    bool _e40 = local_19;
    if (_e40) {
        Decision _e41 = decision_miss();
        return _e41;
    }
    real lambda_13 = _e7 / _e10;
    if (size_1 < (distance_1 * 262144.0)) {
        local_20 = _e13 < (steepness * 524288.0);
    } else {
        local_20 = false;
    }
    bool accurate_2 = local_20;
    if (accurate_2) {
        Limits _e55 = exact_cylinder_limits();
        local_21 = _e55.most <= lambda_13;
    } else {
        local_21 = false;
    }
    bool is_in_range = local_21;
    metal::float3 _e60 = ray_at(ray_11, lambda_13);
    real _e62 = vec3_length(_e60 - center_3);
    real _e63 = exact_cylinder_margin(cylinder_12, ray_11, lambda_13);
    if (steep) {
        local_22 = is_in_range;
    } else {
        local_22 = false;
    }
    bool _e67 = local_22;
    if (_e67) {
        local_23 = _e62 < (cylinder_12.radius - _e63);
    } else {
        local_23 = false;
    }
    bool _e74 = local_23;
    if (_e74) {
        Decision _e75 = decision_hit(lambda_13, part_3);
        return _e75;
    }
    if (steep) {
        local_24 = is_in_range;
    } else {
        local_24 = false;
    }
    bool _e79 = local_24;
    if (_e79) {
        local_25 = (cylinder_12.radius + _e63) < _e62;
    } else {
        local_25 = false;
    }
    bool _e86 = local_25;
    if (_e86) {
        Decision _e87 = decision_miss();
        return _e87;
    }
    Decision _e88 = decision_uncertain();
    return _e88;
}

Decision exact_cylinder_filtered(
    CylinderRecord cylinder_13,
    Ray ray_12
) {
    bool local_26 = {};
    bool local_27 = {};
    bool local_28 = {};
    bool local_29 = {};
    ExactSide _e2 = exact_side_new(cylinder_13, ray_12);
    bool _e4 = exact_in_scale(_e2.length_squared);
    if (!(_e4)) {
        Decision _e6 = decision_uncertain();
        return _e6;
    }
    bool _e9 = error_bound_misses(_e2.bound, _e2.discriminant);
    if (_e9) {
        Decision _e10 = decision_miss();
        return _e10;
    }
    float root_7 = metal::sqrt(_e2.discriminant);
    ExactCrossing _e16 = exact_side_crossing(_e2, cylinder_13, ray_12, -(_e2.h) - root_7, root_7);
    ExactCrossing _e20 = exact_side_crossing(_e2, cylinder_13, ray_12, -(_e2.h) + root_7, root_7);
    if (_e16.behind) {
        local_26 = _e20.straight;
    } else {
        local_26 = false;
    }
    bool _e26 = local_26;
    if (_e26) {
        Decision _e29 = decision_hit(_e20.lambda, SIDE);
        return _e29;
    }
    if (_e16.hits) {
        Decision _e33 = decision_hit(_e16.lambda, SIDE);
        return _e33;
    }
    bool _e34 = exact_crossing_fails(_e16);
    if (_e34) {
        if (!(_e20.hits)) {
            bool _e41 = exact_crossing_fails(_e20);
            local_28 = _e41;
        } else {
            local_28 = true;
        }
        bool _e43 = local_28;
        local_27 = _e43;
    } else {
        local_27 = false;
    }
    bool _e45 = local_27;
    if (!(_e45)) {
        Decision _e47 = decision_uncertain();
        return _e47;
    }
    bool _e48 = exact_crossing_passes_by(_e16, _e20);
    if (_e48) {
        Decision _e49 = decision_miss();
        return _e49;
    }
    bool down = _e2.slope < 0.0;
    real half_1 = down ? -(cylinder_13.half_height) : cylinder_13.half_height;
    metal::float3 along_3 = cylinder_13.axis * half_1;
    Decision _e64 = exact_cap_filtered(cylinder_13, ray_12, cylinder_13.center - along_3, down ? TOP : BOTTOM);
    if (!(!(_e64.certain))) {
        local_29 = _e64.some;
    } else {
        local_29 = true;
    }
    bool _e72 = local_29;
    if (_e72) {
        return _e64;
    }
    if (_e20.hits) {
        Decision _e76 = decision_hit(_e20.lambda, SIDE);
        return _e76;
    }
    Decision _e82 = exact_cap_filtered(cylinder_13, ray_12, cylinder_13.center + along_3, down ? BOTTOM : TOP);
    return _e82;
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
    real a_7,
    real b_4,
    thread real& exact_one
) {
    real _e3 = exact_one;
    real high_3 = (a_7 * _e3) + b_4;
    return DoubleDouble {high_3, b_4 - (high_3 - a_7)};
}

DoubleDouble dd_add(
    DoubleDouble a_8,
    DoubleDouble b_5,
    thread real& exact_one
) {
    real _e5 = exact_one;
    ExactSum _e6 = exact_two_sum(a_8.high, b_5.high, _e5);
    real _e10 = exact_one;
    ExactSum _e11 = exact_two_sum(a_8.low, b_5.low, _e10);
    DoubleDouble _e16 = dd_fast_two_sum(_e6.sum, _e6.error + _e11.sum, exact_one);
    DoubleDouble _e21 = dd_fast_two_sum(_e16.high, _e16.low + _e11.error, exact_one);
    return _e21;
}

DoubleDouble dd_neg(
    DoubleDouble a_9
) {
    return DoubleDouble {-(a_9.high), -(a_9.low)};
}

DoubleDouble dd_sub(
    DoubleDouble a_10,
    DoubleDouble b_6,
    thread real& exact_one
) {
    DoubleDouble _e2 = dd_neg(b_6);
    DoubleDouble _e3 = dd_add(a_10, _e2, exact_one);
    return _e3;
}

DoubleDouble dd_mul(
    DoubleDouble a_11,
    DoubleDouble b_7,
    thread real& exact_one
) {
    ExactSum _e4 = exact_two_product(a_11.high, b_7.high, exact_one);
    real _e12 = exact_mul_add(a_11.high, b_7.low, a_11.low * b_7.low, exact_one);
    real _e13 = exact_mul_add(a_11.low, b_7.high, _e12, exact_one);
    DoubleDouble _e17 = dd_fast_two_sum(_e4.sum, _e4.error + _e13, exact_one);
    return _e17;
}

DoubleDouble dd_div(
    DoubleDouble a_12,
    DoubleDouble b_8,
    thread real& exact_one
) {
    real high_4 = a_12.high / b_8.high;
    ExactSum _e6 = exact_two_product(b_8.high, high_4, exact_one);
    real _e10 = exact_mul_add(b_8.low, high_4, _e6.error, exact_one);
    DoubleDouble _e11 = dd_fast_two_sum(_e6.sum, _e10, exact_one);
    real remainder = (a_12.high - _e11.high) + (a_12.low - _e11.low);
    DoubleDouble _e21 = dd_fast_two_sum(high_4, remainder / b_8.high, exact_one);
    return _e21;
}

DoubleDouble dd_sqrt(
    DoubleDouble a_13,
    thread real& exact_one
) {
    if (a_13.high == 0.0) {
        return a_13;
    }
    real _e7 = exact_one;
    real high_5 = metal::sqrt(a_13.high) * _e7;
    real _e11 = exact_mul_add(-(high_5), high_5, a_13.high, exact_one);
    real remainder_1 = _e11 + a_13.low;
    DoubleDouble _e16 = dd_fast_two_sum(high_5, remainder_1 / (high_5 + high_5), exact_one);
    return _e16;
}

DoubleDouble dd_abs(
    DoubleDouble a_14
) {
    if (a_14.high < 0.0) {
        DoubleDouble _e4 = dd_neg(a_14);
        return _e4;
    }
    return a_14;
}

bool dd_less(
    DoubleDouble a_15,
    DoubleDouble b_9
) {
    bool local_30 = {};
    bool local_31 = {};
    if (!((a_15.high < b_9.high))) {
        if (a_15.high == b_9.high) {
            local_31 = a_15.low < b_9.low;
        } else {
            local_31 = false;
        }
        bool _e17 = local_31;
        local_30 = _e17;
    } else {
        local_30 = true;
    }
    bool _e19 = local_30;
    return _e19;
}

bool dd_less_equal(
    DoubleDouble a_16,
    DoubleDouble b_10
) {
    bool local_32 = {};
    bool local_33 = {};
    if (!((a_16.high < b_10.high))) {
        if (a_16.high == b_10.high) {
            local_33 = a_16.low <= b_10.low;
        } else {
            local_33 = false;
        }
        bool _e17 = local_33;
        local_32 = _e17;
    } else {
        local_32 = true;
    }
    bool _e19 = local_32;
    return _e19;
}

DoubleDouble3_ dd3_of(
    metal::float3 v_8
) {
    DoubleDouble _e2 = dd_of(v_8.x);
    DoubleDouble _e4 = dd_of(v_8.y);
    DoubleDouble _e6 = dd_of(v_8.z);
    return DoubleDouble3_ {_e2, _e4, _e6};
}

DoubleDouble3_ dd3_add(
    DoubleDouble3_ a_17,
    DoubleDouble3_ b_11,
    thread real& exact_one
) {
    DoubleDouble _e4 = dd_add(a_17.x, b_11.x, exact_one);
    DoubleDouble _e7 = dd_add(a_17.y, b_11.y, exact_one);
    DoubleDouble _e10 = dd_add(a_17.z, b_11.z, exact_one);
    return DoubleDouble3_ {_e4, _e7, _e10};
}

DoubleDouble3_ dd3_sub(
    DoubleDouble3_ a_18,
    DoubleDouble3_ b_12,
    thread real& exact_one
) {
    DoubleDouble _e4 = dd_sub(a_18.x, b_12.x, exact_one);
    DoubleDouble _e7 = dd_sub(a_18.y, b_12.y, exact_one);
    DoubleDouble _e10 = dd_sub(a_18.z, b_12.z, exact_one);
    return DoubleDouble3_ {_e4, _e7, _e10};
}

DoubleDouble3_ dd3_scaled(
    DoubleDouble3_ v_9,
    DoubleDouble factor,
    thread real& exact_one
) {
    DoubleDouble _e3 = dd_mul(v_9.x, factor, exact_one);
    DoubleDouble _e5 = dd_mul(v_9.y, factor, exact_one);
    DoubleDouble _e7 = dd_mul(v_9.z, factor, exact_one);
    return DoubleDouble3_ {_e3, _e5, _e7};
}

DoubleDouble3_ dd3_divided(
    DoubleDouble3_ v_10,
    DoubleDouble divisor,
    thread real& exact_one
) {
    DoubleDouble _e3 = dd_div(v_10.x, divisor, exact_one);
    DoubleDouble _e5 = dd_div(v_10.y, divisor, exact_one);
    DoubleDouble _e7 = dd_div(v_10.z, divisor, exact_one);
    return DoubleDouble3_ {_e3, _e5, _e7};
}

DoubleDouble dd3_dot(
    DoubleDouble3_ a_19,
    DoubleDouble3_ b_13,
    thread real& exact_one
) {
    DoubleDouble _e4 = dd_mul(a_19.x, b_13.x, exact_one);
    DoubleDouble _e7 = dd_mul(a_19.y, b_13.y, exact_one);
    DoubleDouble _e8 = dd_add(_e4, _e7, exact_one);
    DoubleDouble _e11 = dd_mul(a_19.z, b_13.z, exact_one);
    DoubleDouble _e12 = dd_add(_e8, _e11, exact_one);
    return _e12;
}

DoubleDouble dd3_magnitude(
    DoubleDouble3_ v_11,
    thread real& exact_one
) {
    DoubleDouble _e2 = dd_abs(v_11.x);
    DoubleDouble _e4 = dd_abs(v_11.y);
    DoubleDouble _e5 = dd_add(_e2, _e4, exact_one);
    DoubleDouble _e7 = dd_abs(v_11.z);
    DoubleDouble _e8 = dd_add(_e5, _e7, exact_one);
    return _e8;
}

DoubleDouble3_ dd3_perpendicular_to(
    DoubleDouble3_ v_12,
    DoubleDouble3_ axis_3,
    thread real& exact_one
) {
    DoubleDouble _e2 = dd3_dot(v_12, axis_3, exact_one);
    DoubleDouble3_ _e3 = dd3_scaled(axis_3, _e2, exact_one);
    DoubleDouble3_ _e4 = dd3_sub(v_12, _e3, exact_one);
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
    DoubleDouble lambda_7,
    uint part_4
) {
    return PreciseDecision {true, true, {}, lambda_7, part_4};
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
    DoubleDouble discriminant_1
) {
    DoubleDouble _e3 = dd_neg(discriminant_1);
    bool _e4 = dd_less(bound_3.error, _e3);
    return _e4;
}

bool precise_in_scale(
    DoubleDouble length_squared_3,
    thread real& exact_one
) {
    bool local_34 = {};
    DoubleDouble _e2 = dd_constant(SHORTEST_SQUARED, exact_one);
    bool _e3 = dd_less_equal(_e2, length_squared_3);
    if (_e3) {
        DoubleDouble _e7 = dd_constant(LONGEST_SQUARED, exact_one);
        bool _e8 = dd_less_equal(length_squared_3, _e7);
        local_34 = _e8;
    } else {
        local_34 = false;
    }
    bool _e10 = local_34;
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
    DoubleDouble lambda_8,
    thread real& exact_one
) {
    DoubleDouble _e2 = precise_least_lambda(exact_one);
    DoubleDouble _e4 = dd_constant(limits_2.lambda_error, exact_one);
    DoubleDouble _e5 = dd_add(_e2, _e4, exact_one);
    bool _e6 = dd_less_equal(_e5, lambda_8);
    return _e6;
}

bool precise_bound_is_too_small(
    PreciseBound bound_4,
    DoubleDouble a_20,
    DoubleDouble numerator_3,
    DoubleDouble root_3,
    thread real& exact_one
) {
    DoubleDouble _e4 = precise_least_lambda(exact_one);
    DoubleDouble _e7 = dd_constant(bound_4.limits.lambda_error, exact_one);
    DoubleDouble _e8 = dd_sub(_e4, _e7, exact_one);
    DoubleDouble _e10 = dd_mul(a_20, _e8, exact_one);
    DoubleDouble _e11 = dd_sub(_e10, numerator_3, exact_one);
    DoubleDouble _e12 = dd_mul(_e11, root_3, exact_one);
    bool _e13 = dd_less(bound_4.error, _e12);
    return _e13;
}

PreciseOutcome precise_bound_root(
    PreciseBound bound_5,
    DoubleDouble a_21,
    DoubleDouble numerator_4,
    DoubleDouble root_4,
    thread real& exact_one
) {
    bool local_35 = {};
    bool local_36 = {};
    DoubleDouble _e4 = dd_div(numerator_4, a_21, exact_one);
    real share_1 = bound_5.limits.share;
    DoubleDouble _e8 = dd_constant(share_1, exact_one);
    DoubleDouble _e9 = dd_mul(bound_5.size, _e8, exact_one);
    DoubleDouble _e11 = dd_constant(ERROR_UNDERFLOW, exact_one);
    DoubleDouble _e12 = dd_add(_e9, _e11, exact_one);
    DoubleDouble _e13 = dd_mul(numerator_4, numerator_4, exact_one);
    DoubleDouble _e16 = dd_constant(share_1 * 4.0, exact_one);
    DoubleDouble _e17 = dd_mul(_e13, _e16, exact_one);
    DoubleDouble _e18 = dd_add(_e12, _e17, exact_one);
    DoubleDouble _e19 = dd_mul(root_4, numerator_4, exact_one);
    bool _e20 = dd_less(_e18, _e19);
    DoubleDouble _e23 = dd_constant(ERROR_OVERFLOW, exact_one);
    bool _e24 = dd_less(bound_5.size, _e23);
    if (_e20) {
        local_35 = _e24;
    } else {
        local_35 = false;
    }
    bool _e28 = local_35;
    if (_e28) {
        bool _e32 = precise_in_range(bound_5.limits, _e4, exact_one);
        local_36 = _e32;
    } else {
        local_36 = false;
    }
    bool hits_2 = local_36;
    bool _e35 = precise_bound_is_too_small(bound_5, a_21, numerator_4, root_4, exact_one);
    return PreciseOutcome {_e4, hits_2, _e35};
}

PreciseCylinder precise_cylinder_new(
    metal::float3 center_4,
    real radius_2,
    metal::float3 axis_4,
    thread real& exact_one
) {
    DoubleDouble3_ _e3 = dd3_of(axis_4);
    DoubleDouble _e4 = dd3_dot(_e3, _e3, exact_one);
    DoubleDouble _e6 = dd_constant(SHORT_SQUARED, exact_one);
    bool _e7 = dd_less(_e4, _e6);
    DoubleDouble _e11 = dd_constant(_e7 ? SHORT_SCALE : 1.0, exact_one);
    DoubleDouble3_ _e12 = dd3_scaled(_e3, _e11, exact_one);
    DoubleDouble _e13 = dd3_dot(_e12, _e12, exact_one);
    DoubleDouble _e14 = dd_sqrt(_e13, exact_one);
    DoubleDouble _e18 = dd_constant(_e7 ? SHORT_SQUARED : 1.0, exact_one);
    DoubleDouble _e19 = dd_mul(_e14, _e18, exact_one);
    DoubleDouble _e20 = dd_of(radius_2);
    DoubleDouble _e22 = dd_constant(2.0, exact_one);
    DoubleDouble _e23 = dd_div(_e19, _e22, exact_one);
    DoubleDouble3_ _e24 = dd3_of(center_4);
    DoubleDouble3_ _e25 = dd3_divided(_e12, _e14, exact_one);
    DoubleDouble _e26 = dd_mul(_e20, _e20, exact_one);
    return PreciseCylinder {_e24, _e25, _e20, _e26, _e23};
}

PreciseLimits precise_cylinder_limits(
) {
    return PreciseLimits {0.000000000000000000000000000037865323, 0.0000000000009094947, 0.000000000000000000055511154};
}

DoubleDouble precise_cylinder_extent(
    PreciseCylinder cylinder_14,
    thread real& exact_one
) {
    DoubleDouble _e2 = dd3_magnitude(cylinder_14.center, exact_one);
    DoubleDouble _e4 = dd_add(_e2, cylinder_14.radius, exact_one);
    DoubleDouble _e6 = dd_add(_e4, cylinder_14.half_height, exact_one);
    DoubleDouble _e8 = dd_constant(EXTENT_UNDERFLOW, exact_one);
    DoubleDouble _e9 = dd_add(_e6, _e8, exact_one);
    return _e9;
}

DoubleDouble precise_cylinder_margin(
    PreciseCylinder cylinder_15,
    DoubleDouble3_ direction_1,
    DoubleDouble lambda_9,
    thread real& exact_one
) {
    DoubleDouble _e3 = dd3_magnitude(direction_1, exact_one);
    DoubleDouble _e4 = dd_mul(lambda_9, _e3, exact_one);
    DoubleDouble _e6 = dd_constant(0.0000000000000001110223, exact_one);
    DoubleDouble _e7 = dd_mul(_e4, _e6, exact_one);
    DoubleDouble _e8 = precise_cylinder_extent(cylinder_15, exact_one);
    DoubleDouble _e10 = dd_constant(0.000000000000000000000000000012621775, exact_one);
    DoubleDouble _e11 = dd_mul(_e8, _e10, exact_one);
    DoubleDouble _e12 = dd_add(_e7, _e11, exact_one);
    return _e12;
}

PreciseSide precise_side_new(
    PreciseCylinder cylinder_16,
    DoubleDouble3_ origin_1,
    DoubleDouble3_ direction_2,
    thread real& exact_one
) {
    DoubleDouble3_ _e4 = dd3_sub(origin_1, cylinder_16.center, exact_one);
    DoubleDouble3_ _e6 = dd3_perpendicular_to(_e4, cylinder_16.axis, exact_one);
    DoubleDouble _e7 = dd3_dot(_e6, _e6, exact_one);
    DoubleDouble _e9 = dd_sub(_e7, cylinder_16.radius_squared, exact_one);
    DoubleDouble3_ _e11 = dd3_perpendicular_to(direction_2, cylinder_16.axis, exact_one);
    DoubleDouble _e12 = dd3_dot(_e11, _e11, exact_one);
    DoubleDouble _e13 = dd3_dot(_e6, _e11, exact_one);
    DoubleDouble _e14 = dd_mul(_e13, _e13, exact_one);
    DoubleDouble _e15 = dd_mul(_e12, _e9, exact_one);
    DoubleDouble _e16 = dd_sub(_e14, _e15, exact_one);
    DoubleDouble _e17 = dd3_dot(direction_2, direction_2, exact_one);
    DoubleDouble _e18 = dd3_dot(_e4, _e4, exact_one);
    DoubleDouble _e20 = dd_add(_e18, cylinder_16.radius_squared, exact_one);
    PreciseLimits _e21 = precise_cylinder_limits();
    PreciseBound _e22 = precise_bound_new(_e21, _e17, _e20, exact_one);
    DoubleDouble _e24 = dd3_dot(_e4, cylinder_16.axis, exact_one);
    DoubleDouble _e26 = dd3_dot(direction_2, cylinder_16.axis, exact_one);
    return PreciseSide {_e22, _e17, _e12, _e13, _e16, _e24, _e26};
}

PreciseCrossing precise_side_crossing(
    PreciseSide side_2,
    PreciseCylinder cylinder_17,
    DoubleDouble3_ direction_3,
    DoubleDouble numerator_5,
    DoubleDouble root_5,
    thread real& exact_one
) {
    bool local_37 = {};
    bool local_38 = {};
    bool local_39 = {};
    bool local_40 = {};
    bool local_41 = {};
    bool local_42 = {};
    DoubleDouble _e8 = dd_constant(77371252000000000000000000.0, exact_one);
    DoubleDouble _e9 = dd_mul(side_2.a, _e8, exact_one);
    bool _e10 = dd_less_equal(side_2.length_squared, _e9);
    PreciseOutcome _e13 = precise_bound_root(side_2.bound, side_2.a, numerator_5, root_5, exact_one);
    DoubleDouble _e17 = dd_mul(_e13.lambda, side_2.slope, exact_one);
    DoubleDouble _e18 = dd_add(side_2.along, _e17, exact_one);
    DoubleDouble _e20 = precise_cylinder_margin(cylinder_17, direction_3, _e13.lambda, exact_one);
    if (_e10) {
        local_37 = _e13.hits;
    } else {
        local_37 = false;
    }
    bool accurate_3 = local_37;
    DoubleDouble _e27 = dd_sub(cylinder_17.half_height, _e20, exact_one);
    DoubleDouble _e29 = dd_add(cylinder_17.half_height, _e20, exact_one);
    if (accurate_3) {
        DoubleDouble _e32 = dd_abs(_e18);
        bool _e33 = dd_less(_e32, _e27);
        local_38 = _e33;
    } else {
        local_38 = false;
    }
    bool hits_3 = local_38;
    if (hits_3) {
        DoubleDouble _e40 = dd_abs(side_2.along);
        bool _e41 = dd_less(_e40, _e27);
        local_39 = _e41;
    } else {
        local_39 = false;
    }
    bool _e43 = local_39;
    if (_e10) {
        local_40 = _e13.fails;
    } else {
        local_40 = false;
    }
    bool _e48 = local_40;
    if (accurate_3) {
        bool _e51 = dd_less(_e29, _e18);
        local_41 = _e51;
    } else {
        local_41 = false;
    }
    bool _e53 = local_41;
    if (accurate_3) {
        DoubleDouble _e56 = dd_neg(_e18);
        bool _e57 = dd_less(_e29, _e56);
        local_42 = _e57;
    } else {
        local_42 = false;
    }
    bool _e59 = local_42;
    return PreciseCrossing {_e13.lambda, hits_3, _e43, _e48, _e53, _e59};
}

bool precise_crossing_fails(
    PreciseCrossing crossing_1
) {
    bool local_43 = {};
    bool local_44 = {};
    if (!(crossing_1.behind)) {
        local_43 = crossing_1.above;
    } else {
        local_43 = true;
    }
    bool _e7 = local_43;
    if (!(_e7)) {
        local_44 = crossing_1.below;
    } else {
        local_44 = true;
    }
    bool _e13 = local_44;
    return _e13;
}

bool precise_crossing_passes_by(
    PreciseCrossing entry_1,
    PreciseCrossing leaving_1
) {
    bool local_45 = {};
    bool local_46 = {};
    bool local_47 = {};
    bool local_48 = {};
    if (!(leaving_1.behind)) {
        if (entry_1.above) {
            local_46 = leaving_1.above;
        } else {
            local_46 = false;
        }
        bool _e11 = local_46;
        local_45 = _e11;
    } else {
        local_45 = true;
    }
    bool _e13 = local_45;
    if (!(_e13)) {
        if (entry_1.below) {
            local_48 = leaving_1.below;
        } else {
            local_48 = false;
        }
        bool _e22 = local_48;
        local_47 = _e22;
    } else {
        local_47 = true;
    }
    bool _e24 = local_47;
    return _e24;
}

PreciseDecision precise_cap_filtered(
    PreciseCylinder cylinder_18,
    DoubleDouble3_ origin_2,
    DoubleDouble3_ direction_4,
    DoubleDouble3_ center_5,
    uint part_5,
    thread real& exact_one
) {
    DoubleDouble distance = {};
    bool local_49 = {};
    bool local_50 = {};
    bool local_51 = {};
    bool local_52 = {};
    bool local_53 = {};
    bool local_54 = {};
    bool local_55 = {};
    DoubleDouble _e6 = dd_constant(0.00000001, exact_one);
    DoubleDouble3_ _e7 = dd3_sub(center_5, origin_2, exact_one);
    DoubleDouble _e9 = dd3_dot(_e7, cylinder_18.axis, exact_one);
    DoubleDouble _e11 = dd3_dot(direction_4, cylinder_18.axis, exact_one);
    DoubleDouble _e12 = dd_abs(_e11);
    DoubleDouble _e13 = dd3_magnitude(direction_4, exact_one);
    DoubleDouble _e15 = dd_constant(0.0000000000000000000000000000015777218, exact_one);
    DoubleDouble _e16 = dd_mul(_e13, _e15, exact_one);
    DoubleDouble _e17 = dd_add(_e12, _e16, exact_one);
    bool _e18 = dd_less(_e17, _e6);
    if (_e18) {
        PreciseDecision _e19 = precise_miss(exact_one);
        return _e19;
    }
    DoubleDouble _e20 = dd_add(_e6, _e16, exact_one);
    bool _e21 = dd_less(_e20, _e12);
    distance = _e9;
    DoubleDouble _e24 = dd_constant(0.0, exact_one);
    bool _e25 = dd_less(_e11, _e24);
    if (_e25) {
        DoubleDouble _e26 = dd_neg(_e9);
        distance = _e26;
    }
    DoubleDouble _e27 = precise_cylinder_extent(cylinder_18, exact_one);
    DoubleDouble _e28 = dd3_magnitude(_e7, exact_one);
    DoubleDouble _e29 = dd_add(_e27, _e28, exact_one);
    DoubleDouble _e30 = distance;
    DoubleDouble _e32 = dd_constant(0.0000000000000000000000000000031554436, exact_one);
    DoubleDouble _e33 = dd_mul(_e29, _e32, exact_one);
    DoubleDouble _e34 = dd_add(_e30, _e33, exact_one);
    if (_e21) {
        DoubleDouble _e37 = dd_sub(_e12, _e16, exact_one);
        DoubleDouble _e38 = precise_least_lambda(exact_one);
        DoubleDouble _e39 = dd_mul(_e37, _e38, exact_one);
        bool _e40 = dd_less(_e34, _e39);
        local_49 = _e40;
    } else {
        local_49 = false;
    }
    bool _e42 = local_49;
    if (_e42) {
        PreciseDecision _e43 = precise_miss(exact_one);
        return _e43;
    }
    DoubleDouble _e44 = dd_div(_e9, _e11, exact_one);
    DoubleDouble _e45 = distance;
    DoubleDouble _e47 = dd_constant(4398046500000.0, exact_one);
    DoubleDouble _e48 = dd_mul(_e45, _e47, exact_one);
    bool _e49 = dd_less(_e29, _e48);
    if (_e49) {
        DoubleDouble _e53 = dd_constant(8796093000000.0, exact_one);
        DoubleDouble _e54 = dd_mul(_e12, _e53, exact_one);
        bool _e55 = dd_less(_e13, _e54);
        local_50 = _e55;
    } else {
        local_50 = false;
    }
    bool accurate_4 = local_50;
    if (accurate_4) {
        PreciseLimits _e60 = precise_cylinder_limits();
        bool _e61 = precise_in_range(_e60, _e44, exact_one);
        local_51 = _e61;
    } else {
        local_51 = false;
    }
    bool is_in_range_1 = local_51;
    DoubleDouble3_ _e64 = dd3_scaled(direction_4, _e44, exact_one);
    DoubleDouble3_ _e65 = dd3_add(origin_2, _e64, exact_one);
    DoubleDouble3_ _e66 = dd3_sub(_e65, center_5, exact_one);
    DoubleDouble _e67 = dd3_dot(_e66, _e66, exact_one);
    DoubleDouble _e68 = dd_sqrt(_e67, exact_one);
    DoubleDouble _e69 = precise_cylinder_margin(cylinder_18, direction_4, _e44, exact_one);
    if (_e21) {
        local_52 = is_in_range_1;
    } else {
        local_52 = false;
    }
    bool _e73 = local_52;
    if (_e73) {
        DoubleDouble _e77 = dd_sub(cylinder_18.radius, _e69, exact_one);
        bool _e78 = dd_less(_e68, _e77);
        local_53 = _e78;
    } else {
        local_53 = false;
    }
    bool _e80 = local_53;
    if (_e80) {
        PreciseDecision _e81 = precise_hit(_e44, part_5);
        return _e81;
    }
    if (_e21) {
        local_54 = is_in_range_1;
    } else {
        local_54 = false;
    }
    bool _e85 = local_54;
    if (_e85) {
        DoubleDouble _e89 = dd_add(cylinder_18.radius, _e69, exact_one);
        bool _e90 = dd_less(_e89, _e68);
        local_55 = _e90;
    } else {
        local_55 = false;
    }
    bool _e92 = local_55;
    if (_e92) {
        PreciseDecision _e93 = precise_miss(exact_one);
        return _e93;
    }
    PreciseDecision _e94 = precise_uncertain(exact_one);
    return _e94;
}

PreciseDecision precise_cylinder_filtered(
    metal::float3 center_6,
    real radius_3,
    metal::float3 axis_5,
    Ray ray_13,
    thread real& exact_one
) {
    bool local_56 = {};
    bool local_57 = {};
    bool local_58 = {};
    DoubleDouble half_ = {};
    bool local_59 = {};
    PreciseCylinder _e4 = precise_cylinder_new(center_6, radius_3, axis_5, exact_one);
    DoubleDouble3_ _e6 = dd3_of(ray_13.origin);
    DoubleDouble3_ _e8 = dd3_of(ray_13.direction);
    PreciseSide _e9 = precise_side_new(_e4, _e6, _e8, exact_one);
    bool _e11 = precise_in_scale(_e9.length_squared, exact_one);
    if (!(_e11)) {
        PreciseDecision _e13 = precise_uncertain(exact_one);
        return _e13;
    }
    bool _e16 = precise_bound_misses(_e9.bound, _e9.discriminant);
    if (_e16) {
        PreciseDecision _e17 = precise_miss(exact_one);
        return _e17;
    }
    DoubleDouble _e19 = dd_sqrt(_e9.discriminant, exact_one);
    DoubleDouble _e21 = dd_neg(_e9.h);
    DoubleDouble _e22 = dd_sub(_e21, _e19, exact_one);
    PreciseCrossing _e23 = precise_side_crossing(_e9, _e4, _e8, _e22, _e19, exact_one);
    DoubleDouble _e25 = dd_neg(_e9.h);
    DoubleDouble _e26 = dd_add(_e25, _e19, exact_one);
    PreciseCrossing _e27 = precise_side_crossing(_e9, _e4, _e8, _e26, _e19, exact_one);
    if (_e23.behind) {
        local_56 = _e27.straight;
    } else {
        local_56 = false;
    }
    bool _e33 = local_56;
    if (_e33) {
        PreciseDecision _e36 = precise_hit(_e27.lambda, SIDE);
        return _e36;
    }
    if (_e23.hits) {
        PreciseDecision _e40 = precise_hit(_e23.lambda, SIDE);
        return _e40;
    }
    bool _e41 = precise_crossing_fails(_e23);
    if (_e41) {
        if (!(_e27.hits)) {
            bool _e48 = precise_crossing_fails(_e27);
            local_58 = _e48;
        } else {
            local_58 = true;
        }
        bool _e50 = local_58;
        local_57 = _e50;
    } else {
        local_57 = false;
    }
    bool _e52 = local_57;
    if (!(_e52)) {
        PreciseDecision _e54 = precise_uncertain(exact_one);
        return _e54;
    }
    bool _e55 = precise_crossing_passes_by(_e23, _e27);
    if (_e55) {
        PreciseDecision _e56 = precise_miss(exact_one);
        return _e56;
    }
    DoubleDouble _e59 = dd_constant(0.0, exact_one);
    bool _e60 = dd_less(_e9.slope, _e59);
    half_ = _e4.half_height;
    if (_e60) {
        DoubleDouble _e63 = half_;
        DoubleDouble _e64 = dd_neg(_e63);
        half_ = _e64;
    }
    DoubleDouble _e66 = half_;
    DoubleDouble3_ _e67 = dd3_scaled(_e4.axis, _e66, exact_one);
    DoubleDouble3_ _e69 = dd3_sub(_e4.center, _e67, exact_one);
    PreciseDecision _e73 = precise_cap_filtered(_e4, _e6, _e8, _e69, _e60 ? TOP : BOTTOM, exact_one);
    if (!(!(_e73.certain))) {
        local_59 = _e73.some;
    } else {
        local_59 = true;
    }
    bool _e81 = local_59;
    if (_e81) {
        return _e73;
    }
    if (_e27.hits) {
        PreciseDecision _e85 = precise_hit(_e27.lambda, SIDE);
        return _e85;
    }
    DoubleDouble3_ _e87 = dd3_add(_e4.center, _e67, exact_one);
    PreciseDecision _e91 = precise_cap_filtered(_e4, _e6, _e8, _e87, _e60 ? BOTTOM : TOP, exact_one);
    return _e91;
}

real exact_code(
    bool certain,
    bool some,
    uint part_6
) {
    if (!(certain)) {
        return 0.0;
    }
    return some ? static_cast<float>(2u + part_6) : 1.0;
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

struct exact_cylinderInput {
};
kernel void exact_cylinder(
  metal::uint3 id [[thread_position_in_grid]]
, device type_4 const& cases [[buffer(0)]]
, device type_5& reports [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    real exact_one = {};
    if (id.x >= (1 + (_buffer_sizes.size1 - 0 - 56) / 56)) {
        return;
    }
    real _e10 = cases[id.x].one;
    exact_one = _e10;
    PackedRay _e15 = cases[id.x].ray;
    Ray _e16 = ray_load(_e15);
    PackedVec3_ _e21 = cases[id.x].center;
    metal::float3 _e22 = vec3_load(_e21);
    PackedVec3_ _e27 = cases[id.x].axis;
    metal::float3 _e28 = vec3_load(_e27);
    real radius_4 = cases[id.x].radius;
    CylinderRecord _e34 = cylinder_new(_e22, radius_4, _e28);
    Decision _e35 = exact_cylinder_filtered(_e34, _e16);
    PreciseDecision _e36 = precise_cylinder_filtered(_e22, radius_4, _e28, _e16, exact_one);
    Decision _e40 = decision_uncertain();
    ExactReport _e41 = exact_report(_e35, _e40, _e36);
    reports[id.x] = _e41;
    return;
}
