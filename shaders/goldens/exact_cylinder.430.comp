#version 430 core
#extension GL_ARB_compute_shader : require
#extension GL_ARB_shader_storage_buffer_object : require
layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

struct ExactSum {
    float sum;
    float error;
};
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
struct UnitAndLength {
    vec3 direction;
    float length_;
};
struct CylinderRecord {
    vec3 center;
    vec3 axis;
    vec3 top;
    vec3 bottom;
    float radius;
    float radius_squared;
    float half_height;
};
struct CylinderView {
    vec3 r_c;
    float c;
};
struct CylinderQuadratic {
    float a;
    float h;
    float discriminant;
};
struct CylinderRoot {
    bool some;
    float lambda;
    uint part;
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
struct ExactHalves {
    float high;
    float low;
};
struct Decision {
    bool certain;
    bool some;
    float lambda;
    uint part;
};
struct Limits {
    float error;
    float share;
    float least;
    float most;
};
struct ErrorBound {
    Limits limits;
    float size;
    float error;
};
struct Outcome {
    float lambda;
    bool hits;
    bool fails;
};
struct ExactSide {
    ErrorBound bound;
    float length_squared;
    float a;
    float h;
    float discriminant;
    float along;
    float slope;
};
struct ExactCrossing {
    float lambda;
    bool hits;
    bool straight;
    bool behind;
    bool above;
    bool below;
};
struct DoubleDouble {
    float high;
    float low;
};
struct DoubleDouble3_ {
    DoubleDouble x;
    DoubleDouble y;
    DoubleDouble z;
};
struct PreciseDecision {
    bool certain;
    bool some;
    DoubleDouble lambda;
    uint part;
};
struct PreciseLimits {
    float error;
    float share;
    float lambda_error;
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
};
struct ExactReport {
    float step_;
    float some;
    float lambda;
    float part;
    float plain;
    float plain_lambda;
    float compensated;
    float compensated_lambda;
    float doubled;
    float doubled_high;
    float doubled_low;
};
struct ExactCylinderCase {
    PackedRay ray;
    PackedVec3_ center;
    float radius;
    PackedVec3_ axis;
    float one;
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
const uint SIDE = 0u;
const uint TOP = 1u;
const uint BOTTOM = 2u;

float exact_one = 0.0;

layout(std430, binding = 0) readonly buffer type_4_block_0Compute { ExactCylinderCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_5_block_1Compute { ExactReport _group_0_binding_1_cs[]; };


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

ExactSum exact_two_sum(float a_1, float b_1, float one) {
    float sum = ((a_1 * one) + b_1);
    float b_part = (sum - a_1);
    float a_part = (sum - b_part);
    return ExactSum(sum, ((a_1 - a_part) + (b_1 - b_part)));
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

UnitAndLength vec3_unit_and_length(vec3 v_4) {
    float _e1 = vec3_dot(v_4, v_4);
    if ((_e1 < SHORT_SQUARED)) {
        vec3 scaled = (v_4 * SHORT_SCALE);
        float _e6 = vec3_length(scaled);
        return UnitAndLength((scaled / vec3(_e6)), (_e6 * SHORT_SQUARED));
    }
    float _e12 = vec3_length(v_4);
    return UnitAndLength((v_4 / vec3(_e12)), _e12);
}

bool tie_later_cap_is_closer(float lambda_2, float closest) {
    return (lambda_2 < closest);
}

int tie_rank(uint order, bool on_cap) {
    return (on_cap ? (-1 - int(order)) : int(order));
}

bool tie_is_closer(float lambda_3, int rank, float closest_1, int closest_rank) {
    return ((lambda_3 < closest_1) || ((lambda_3 <= closest_1) && (rank >= closest_rank)));
}

CylinderRecord cylinder_with_unit_axis(vec3 center, float radius, vec3 axis_1, float half_height) {
    vec3 to_cap = (axis_1 * half_height);
    return CylinderRecord(center, axis_1, (center + to_cap), (center - to_cap), radius, (radius * radius), half_height);
}

CylinderRecord cylinder_new(vec3 center_1, float radius_1, vec3 axis_2) {
    UnitAndLength _e3 = vec3_unit_and_length(axis_2);
    CylinderRecord _e8 = cylinder_with_unit_axis(center_1, radius_1, _e3.direction, (_e3.length_ / 2.0));
    return _e8;
}

CylinderView cylinder_seen_from(CylinderRecord cylinder, vec3 origin) {
    vec3 _e5 = vec3_perpendicular_to((origin - cylinder.center), cylinder.axis);
    float _e6 = vec3_dot(_e5, _e5);
    return CylinderView(_e5, (_e6 - cylinder.radius_squared));
}

CylinderQuadratic cylinder_quadratic(CylinderRecord cylinder_1, CylinderView view, vec3 along) {
    vec3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    float _e5 = vec3_dot(_e4, _e4);
    float _e7 = vec3_dot(view.r_c, _e4);
    return CylinderQuadratic(_e5, _e7, ((_e7 * _e7) - (_e5 * view.c)));
}

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_1, float lambda_4) {
    vec3 _e3 = ray_at(ray_1, lambda_4);
    float _e7 = vec3_dot((_e3 - cylinder_2.center), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

Root cylinder_side(CylinderRecord cylinder_3, Ray ray_2, CylinderQuadratic quadratic) {
    float root_6 = sqrt(quadratic.discriminant);
    float near = ((-(quadratic.h) - root_6) / quadratic.a);
    float far = ((-(quadratic.h) + root_6) / quadratic.a);
    bool _e15 = in_range(near);
    bool _e16 = cylinder_within_height(cylinder_3, ray_2, near);
    bool near_counts = (_e15 && _e16);
    bool _e18 = in_range(far);
    bool _e19 = cylinder_within_height(cylinder_3, ray_2, far);
    bool far_counts = (_e18 && _e19);
    return Root((near_counts || far_counts), (near_counts ? near : far));
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_3, vec3 center_2) {
    float _e5 = vec3_dot(ray_3.direction, cylinder_4.axis);
    float _e9 = vec3_dot((center_2 - ray_3.origin), cylinder_4.axis);
    float lambda_10 = (_e9 / _e5);
    vec3 _e11 = ray_at(ray_3, lambda_10);
    float _e13 = vec3_length((_e11 - center_2));
    bool on_disc = (_e13 <= cylinder_4.radius);
    bool _e20 = in_range(lambda_10);
    return Root(((!((abs(_e5) < 1e-8)) && _e20) && on_disc), lambda_10);
}

vec3 cylinder_outward(CylinderRecord cylinder_5, uint part, vec3 point_1) {
    vec3 _e6 = vec3_perpendicular_to((point_1 - cylinder_5.center), cylinder_5.axis);
    vec3 cap = ((part == TOP) ? cylinder_5.axis : -(cylinder_5.axis));
    return ((part == SIDE) ? _e6 : cap);
}

CylinderRoot cylinder_closer(CylinderRoot closest_2, Root later, uint part_1) {
    bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = (later.some && (!(closest_2.some) || _e8));
    float lambda_11 = (replaces ? later.lambda : closest_2.lambda);
    return CylinderRoot((closest_2.some || later.some), lambda_11, (replaces ? part_1 : closest_2.part));
}

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_6, Ray ray_4, Root side) {
    Root _e4 = cylinder_cap(cylinder_6, ray_4, cylinder_6.top);
    Root _e6 = cylinder_cap(cylinder_6, ray_4, cylinder_6.bottom);
    CylinderRoot _e12 = cylinder_closer(CylinderRoot(side.some, side.lambda, SIDE), _e4, TOP);
    CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    return _e14;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_7, Ray ray_5) {
    CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_5.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_5.direction);
    Root _e6 = cylinder_side(cylinder_7, ray_5, _e5);
    bool some_1 = (!((_e5.discriminant < 0.0)) && _e6.some);
    CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_5, Root(some_1, _e6.lambda));
    return _e15;
}

vec3 vec3_load(PackedVec3_ v_5) {
    return vec3(v_5.x, v_5.y, v_5.z);
}

PackedVec3_ vec3_store(vec3 v_6) {
    return PackedVec3_(v_6.x, v_6.y, v_6.z);
}

Ray ray_load(PackedRay ray_6) {
    vec3 _e2 = vec3_load(ray_6.origin);
    vec3 _e4 = vec3_load(ray_6.direction);
    return Ray(_e2, _e4);
}

PackedRay ray_store(Ray ray_7) {
    PackedVec3_ _e2 = vec3_store(ray_7.origin);
    PackedVec3_ _e4 = vec3_store(ray_7.direction);
    return PackedRay(_e2, _e4);
}

ExactHalves exact_halves(float a_2) {
    float large = (a_2 * SPLITTER);
    float _e4 = exact_one;
    float high_2 = ((large * _e4) - (large - a_2));
    return ExactHalves(high_2, (a_2 - high_2));
}

ExactSum exact_two_product(float a_3, float b_2) {
    bool scales_a = (SPLIT_LIMIT < abs(a_3));
    bool scales_b = (SPLIT_LIMIT < abs(b_2));
    float x = (scales_a ? (a_3 * SPLIT_SCALE) : a_3);
    float y = (scales_b ? (b_2 * SPLIT_SCALE) : b_2);
    float product = (x * y);
    ExactHalves _e15 = exact_halves(x);
    ExactHalves _e16 = exact_halves(y);
    float error = (((((_e15.high * _e16.high) - product) + (_e15.high * _e16.low)) + (_e15.low * _e16.high)) + (_e15.low * _e16.low));
    float unscaled = (scales_a ? (error * SPLIT_UNSCALE) : error);
    return ExactSum((a_3 * b_2), (scales_b ? (unscaled * SPLIT_UNSCALE) : unscaled));
}

float exact_mul_add(float a_4, float b_3, float c) {
    bool local = false;
    bool local_1 = false;
    bool local_2 = false;
    bool local_3 = false;
    ExactSum _e3 = exact_two_product(a_4, b_3);
    float _e6 = exact_one;
    ExactSum _e7 = exact_two_sum(c, _e3.error, _e6);
    float _e11 = exact_one;
    ExactSum _e12 = exact_two_sum(_e3.sum, _e7.sum, _e11);
    float _e16 = exact_one;
    ExactSum _e17 = exact_two_sum(_e7.error, _e12.error, _e16);
    float _e21 = exact_one;
    ExactSum _e22 = exact_two_sum(_e12.sum, _e17.sum, _e21);
    float _e25 = exact_one;
    float neighbor = ((_e22.sum * _e25) + (_e22.error * 1.5));
    bool is_tie = ((_e22.error + _e22.error) == (neighbor - _e22.sum));
    if ((0.0 < _e22.error)) {
        local = (0.0 < _e17.error);
    } else {
        local = false;
    }
    bool _e45 = local;
    if (!(_e45)) {
        if ((_e22.error < 0.0)) {
            local_2 = (_e17.error < 0.0);
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
    return (_e63 ? neighbor : _e22.sum);
}

Decision decision_uncertain() {
    return Decision(false, false, 0.0, 0u);
}

Decision decision_miss() {
    return Decision(true, false, 0.0, 0u);
}

Decision decision_hit(float lambda_5, uint part_2) {
    return Decision(true, true, lambda_5, part_2);
}

bool exact_in_scale(float length_squared) {
    bool local_4 = false;
    if ((SHORTEST_SQUARED <= length_squared)) {
        local_4 = (length_squared <= LONGEST_SQUARED);
    } else {
        local_4 = false;
    }
    bool _e8 = local_4;
    return _e8;
}

ErrorBound error_bound_new(Limits limits, float length_squared_1, float squares) {
    float size = (length_squared_1 * squares);
    return ErrorBound(limits, size, ((size * limits.error) + ERROR_UNDERFLOW));
}

bool error_bound_misses(ErrorBound bound, float discriminant) {
    return (bound.error < -(discriminant));
}

bool error_bound_is_too_small(ErrorBound bound_1, float a_5, float numerator, float root) {
    return (bound_1.error < (((a_5 * bound_1.limits.least) - numerator) * root));
}

Outcome error_bound_root(ErrorBound bound_2, float a_6, float numerator_1, float root_1) {
    bool local_5 = false;
    bool local_6 = false;
    float lambda_12 = (numerator_1 / a_6);
    float share = bound_2.limits.share;
    float least = (((bound_2.size * share) + ERROR_UNDERFLOW) + ((numerator_1 * numerator_1) * (share * 4.0)));
    bool accurate = (least < (root_1 * numerator_1));
    bool finite = (bound_2.size < ERROR_OVERFLOW);
    if (accurate) {
        local_5 = finite;
    } else {
        local_5 = false;
    }
    bool _e24 = local_5;
    if (_e24) {
        local_6 = (bound_2.limits.most <= lambda_12);
    } else {
        local_6 = false;
    }
    bool hits = local_6;
    bool _e32 = error_bound_is_too_small(bound_2, a_6, numerator_1, root_1);
    return Outcome(lambda_12, hits, _e32);
}

Limits exact_cylinder_limits() {
    return Limits(2.1316282e-14, 1.5258789e-5, 0.001, 0.001);
}

float exact_magnitude(vec3 v_7) {
    return ((abs(v_7.x) + abs(v_7.y)) + abs(v_7.z));
}

float exact_cylinder_extent(CylinderRecord cylinder_8) {
    float _e2 = exact_magnitude(cylinder_8.center);
    return (((_e2 + cylinder_8.radius) + cylinder_8.half_height) + EXTENT_UNDERFLOW);
}

float exact_cylinder_margin(CylinderRecord cylinder_9, Ray ray_8, float lambda_6) {
    float _e4 = exact_magnitude(ray_8.direction);
    float along_1 = ((lambda_6 * _e4) * 3.7252903e-9);
    float _e8 = exact_cylinder_extent(cylinder_9);
    return (along_1 + (_e8 * 7.1054274e-15));
}

ExactSide exact_side_new(CylinderRecord cylinder_10, Ray ray_9) {
    vec3 from_center = (ray_9.origin - cylinder_10.center);
    CylinderView _e6 = cylinder_seen_from(cylinder_10, ray_9.origin);
    CylinderQuadratic _e8 = cylinder_quadratic(cylinder_10, _e6, ray_9.direction);
    float _e11 = vec3_dot(ray_9.direction, ray_9.direction);
    float _e12 = vec3_dot(from_center, from_center);
    float squares_2 = (_e12 + cylinder_10.radius_squared);
    Limits _e15 = exact_cylinder_limits();
    ErrorBound _e16 = error_bound_new(_e15, _e11, squares_2);
    float _e18 = vec3_dot(from_center, cylinder_10.axis);
    float _e21 = vec3_dot(ray_9.direction, cylinder_10.axis);
    return ExactSide(_e16, _e11, _e8.a, _e8.h, _e8.discriminant, _e18, _e21);
}

ExactCrossing exact_side_crossing(ExactSide side_1, CylinderRecord cylinder_11, Ray ray_10, float numerator_2, float root_2) {
    bool local_7 = false;
    bool local_8 = false;
    bool local_9 = false;
    bool local_10 = false;
    bool local_11 = false;
    bool local_12 = false;
    bool steep_enough = (side_1.length_squared <= (side_1.a * 274877900000.0));
    Outcome _e12 = error_bound_root(side_1.bound, side_1.a, numerator_2, root_2);
    float along_2 = (side_1.along + (_e12.lambda * side_1.slope));
    float _e19 = exact_cylinder_margin(cylinder_11, ray_10, _e12.lambda);
    if (steep_enough) {
        local_7 = _e12.hits;
    } else {
        local_7 = false;
    }
    bool accurate_1 = local_7;
    float within = (cylinder_11.half_height - _e19);
    float beyond = (cylinder_11.half_height + _e19);
    if (accurate_1) {
        local_8 = (abs(along_2) < within);
    } else {
        local_8 = false;
    }
    bool hits_1 = local_8;
    if (hits_1) {
        local_9 = (abs(side_1.along) < within);
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
        local_11 = (beyond < along_2);
    } else {
        local_11 = false;
    }
    bool _e52 = local_11;
    if (accurate_1) {
        local_12 = (beyond < -(along_2));
    } else {
        local_12 = false;
    }
    bool _e58 = local_12;
    return ExactCrossing(_e12.lambda, hits_1, straight, behind, _e52, _e58);
}

bool exact_crossing_fails(ExactCrossing crossing) {
    bool local_13 = false;
    bool local_14 = false;
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

bool exact_crossing_passes_by(ExactCrossing entry, ExactCrossing leaving) {
    bool local_15 = false;
    bool local_16 = false;
    bool local_17 = false;
    bool local_18 = false;
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

Decision exact_cap_filtered(CylinderRecord cylinder_12, Ray ray_11, vec3 center_3, uint part_3) {
    bool local_19 = false;
    bool local_20 = false;
    bool local_21 = false;
    bool local_22 = false;
    bool local_23 = false;
    bool local_24 = false;
    bool local_25 = false;
    vec3 to_center = (center_3 - ray_11.origin);
    float _e7 = vec3_dot(to_center, cylinder_12.axis);
    float _e10 = vec3_dot(ray_11.direction, cylinder_12.axis);
    float steepness = abs(_e10);
    float _e13 = exact_magnitude(ray_11.direction);
    float slope_error = (_e13 * 8.881784e-16);
    if (((steepness + slope_error) < 1e-8)) {
        Decision _e19 = decision_miss();
        return _e19;
    }
    bool steep = ((1e-8 + slope_error) < steepness);
    float distance_1 = ((_e10 < 0.0) ? -(_e7) : _e7);
    float _e27 = exact_cylinder_extent(cylinder_12);
    float _e28 = exact_magnitude(to_center);
    float size_1 = (_e27 + _e28);
    float distance_error = (size_1 * 1.7763568e-15);
    if (steep) {
        local_19 = ((distance_1 + distance_error) < ((steepness - slope_error) * 0.001));
    } else {
        local_19 = false;
    }
    bool _e40 = local_19;
    if (_e40) {
        Decision _e41 = decision_miss();
        return _e41;
    }
    float lambda_13 = (_e7 / _e10);
    if ((size_1 < (distance_1 * 262144.0))) {
        local_20 = (_e13 < (steepness * 524288.0));
    } else {
        local_20 = false;
    }
    bool accurate_2 = local_20;
    if (accurate_2) {
        Limits _e55 = exact_cylinder_limits();
        local_21 = (_e55.most <= lambda_13);
    } else {
        local_21 = false;
    }
    bool is_in_range = local_21;
    vec3 _e60 = ray_at(ray_11, lambda_13);
    float _e62 = vec3_length((_e60 - center_3));
    float _e63 = exact_cylinder_margin(cylinder_12, ray_11, lambda_13);
    if (steep) {
        local_22 = is_in_range;
    } else {
        local_22 = false;
    }
    bool _e67 = local_22;
    if (_e67) {
        local_23 = (_e62 < (cylinder_12.radius - _e63));
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
        local_25 = ((cylinder_12.radius + _e63) < _e62);
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

Decision exact_cylinder_filtered(CylinderRecord cylinder_13, Ray ray_12) {
    bool local_26 = false;
    bool local_27 = false;
    bool local_28 = false;
    bool local_29 = false;
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
    float root_7 = sqrt(_e2.discriminant);
    ExactCrossing _e16 = exact_side_crossing(_e2, cylinder_13, ray_12, (-(_e2.h) - root_7), root_7);
    ExactCrossing _e20 = exact_side_crossing(_e2, cylinder_13, ray_12, (-(_e2.h) + root_7), root_7);
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
    bool down = (_e2.slope < 0.0);
    float half_1 = (down ? -(cylinder_13.half_height) : cylinder_13.half_height);
    vec3 along_3 = (cylinder_13.axis * half_1);
    Decision _e64 = exact_cap_filtered(cylinder_13, ray_12, (cylinder_13.center - along_3), (down ? TOP : BOTTOM));
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
    Decision _e82 = exact_cap_filtered(cylinder_13, ray_12, (cylinder_13.center + along_3), (down ? BOTTOM : TOP));
    return _e82;
}

DoubleDouble dd_of(float high) {
    return DoubleDouble(high, 0.0);
}

DoubleDouble dd_constant(float high_1) {
    float _e2 = exact_one;
    DoubleDouble _e4 = dd_of((high_1 * _e2));
    return _e4;
}

DoubleDouble dd_fast_two_sum(float a_7, float b_4) {
    float _e3 = exact_one;
    float high_3 = ((a_7 * _e3) + b_4);
    return DoubleDouble(high_3, (b_4 - (high_3 - a_7)));
}

DoubleDouble dd_add(DoubleDouble a_8, DoubleDouble b_5) {
    float _e5 = exact_one;
    ExactSum _e6 = exact_two_sum(a_8.high, b_5.high, _e5);
    float _e10 = exact_one;
    ExactSum _e11 = exact_two_sum(a_8.low, b_5.low, _e10);
    DoubleDouble _e16 = dd_fast_two_sum(_e6.sum, (_e6.error + _e11.sum));
    DoubleDouble _e21 = dd_fast_two_sum(_e16.high, (_e16.low + _e11.error));
    return _e21;
}

DoubleDouble dd_neg(DoubleDouble a_9) {
    return DoubleDouble(-(a_9.high), -(a_9.low));
}

DoubleDouble dd_sub(DoubleDouble a_10, DoubleDouble b_6) {
    DoubleDouble _e2 = dd_neg(b_6);
    DoubleDouble _e3 = dd_add(a_10, _e2);
    return _e3;
}

DoubleDouble dd_mul(DoubleDouble a_11, DoubleDouble b_7) {
    ExactSum _e4 = exact_two_product(a_11.high, b_7.high);
    float _e12 = exact_mul_add(a_11.high, b_7.low, (a_11.low * b_7.low));
    float _e13 = exact_mul_add(a_11.low, b_7.high, _e12);
    DoubleDouble _e17 = dd_fast_two_sum(_e4.sum, (_e4.error + _e13));
    return _e17;
}

DoubleDouble dd_div(DoubleDouble a_12, DoubleDouble b_8) {
    float high_4 = (a_12.high / b_8.high);
    ExactSum _e6 = exact_two_product(b_8.high, high_4);
    float _e10 = exact_mul_add(b_8.low, high_4, _e6.error);
    DoubleDouble _e11 = dd_fast_two_sum(_e6.sum, _e10);
    float remainder = ((a_12.high - _e11.high) + (a_12.low - _e11.low));
    DoubleDouble _e21 = dd_fast_two_sum(high_4, (remainder / b_8.high));
    return _e21;
}

DoubleDouble dd_sqrt(DoubleDouble a_13) {
    if ((a_13.high == 0.0)) {
        return a_13;
    }
    float _e7 = exact_one;
    float high_5 = (sqrt(a_13.high) * _e7);
    float _e11 = exact_mul_add(-(high_5), high_5, a_13.high);
    float remainder_1 = (_e11 + a_13.low);
    DoubleDouble _e16 = dd_fast_two_sum(high_5, (remainder_1 / (high_5 + high_5)));
    return _e16;
}

DoubleDouble dd_abs(DoubleDouble a_14) {
    if ((a_14.high < 0.0)) {
        DoubleDouble _e4 = dd_neg(a_14);
        return _e4;
    }
    return a_14;
}

bool dd_less(DoubleDouble a_15, DoubleDouble b_9) {
    bool local_30 = false;
    bool local_31 = false;
    if (!((a_15.high < b_9.high))) {
        if ((a_15.high == b_9.high)) {
            local_31 = (a_15.low < b_9.low);
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

bool dd_less_equal(DoubleDouble a_16, DoubleDouble b_10) {
    bool local_32 = false;
    bool local_33 = false;
    if (!((a_16.high < b_10.high))) {
        if ((a_16.high == b_10.high)) {
            local_33 = (a_16.low <= b_10.low);
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

DoubleDouble3_ dd3_of(vec3 v_8) {
    DoubleDouble _e2 = dd_of(v_8.x);
    DoubleDouble _e4 = dd_of(v_8.y);
    DoubleDouble _e6 = dd_of(v_8.z);
    return DoubleDouble3_(_e2, _e4, _e6);
}

DoubleDouble3_ dd3_add(DoubleDouble3_ a_17, DoubleDouble3_ b_11) {
    DoubleDouble _e4 = dd_add(a_17.x, b_11.x);
    DoubleDouble _e7 = dd_add(a_17.y, b_11.y);
    DoubleDouble _e10 = dd_add(a_17.z, b_11.z);
    return DoubleDouble3_(_e4, _e7, _e10);
}

DoubleDouble3_ dd3_sub(DoubleDouble3_ a_18, DoubleDouble3_ b_12) {
    DoubleDouble _e4 = dd_sub(a_18.x, b_12.x);
    DoubleDouble _e7 = dd_sub(a_18.y, b_12.y);
    DoubleDouble _e10 = dd_sub(a_18.z, b_12.z);
    return DoubleDouble3_(_e4, _e7, _e10);
}

DoubleDouble3_ dd3_scaled(DoubleDouble3_ v_9, DoubleDouble factor) {
    DoubleDouble _e3 = dd_mul(v_9.x, factor);
    DoubleDouble _e5 = dd_mul(v_9.y, factor);
    DoubleDouble _e7 = dd_mul(v_9.z, factor);
    return DoubleDouble3_(_e3, _e5, _e7);
}

DoubleDouble3_ dd3_divided(DoubleDouble3_ v_10, DoubleDouble divisor) {
    DoubleDouble _e3 = dd_div(v_10.x, divisor);
    DoubleDouble _e5 = dd_div(v_10.y, divisor);
    DoubleDouble _e7 = dd_div(v_10.z, divisor);
    return DoubleDouble3_(_e3, _e5, _e7);
}

DoubleDouble dd3_dot(DoubleDouble3_ a_19, DoubleDouble3_ b_13) {
    DoubleDouble _e4 = dd_mul(a_19.x, b_13.x);
    DoubleDouble _e7 = dd_mul(a_19.y, b_13.y);
    DoubleDouble _e8 = dd_add(_e4, _e7);
    DoubleDouble _e11 = dd_mul(a_19.z, b_13.z);
    DoubleDouble _e12 = dd_add(_e8, _e11);
    return _e12;
}

DoubleDouble dd3_magnitude(DoubleDouble3_ v_11) {
    DoubleDouble _e2 = dd_abs(v_11.x);
    DoubleDouble _e4 = dd_abs(v_11.y);
    DoubleDouble _e5 = dd_add(_e2, _e4);
    DoubleDouble _e7 = dd_abs(v_11.z);
    DoubleDouble _e8 = dd_add(_e5, _e7);
    return _e8;
}

DoubleDouble3_ dd3_perpendicular_to(DoubleDouble3_ v_12, DoubleDouble3_ axis_3) {
    DoubleDouble _e2 = dd3_dot(v_12, axis_3);
    DoubleDouble3_ _e3 = dd3_scaled(axis_3, _e2);
    DoubleDouble3_ _e4 = dd3_sub(v_12, _e3);
    return _e4;
}

PreciseDecision precise_uncertain() {
    DoubleDouble _e3 = dd_constant(0.0);
    return PreciseDecision(false, false, _e3, SIDE);
}

PreciseDecision precise_miss() {
    DoubleDouble _e3 = dd_constant(0.0);
    return PreciseDecision(true, false, _e3, SIDE);
}

PreciseDecision precise_hit(DoubleDouble lambda_7, uint part_4) {
    return PreciseDecision(true, true, lambda_7, part_4);
}

PreciseBound precise_bound_new(PreciseLimits limits_1, DoubleDouble length_squared_2, DoubleDouble squares_1) {
    DoubleDouble _e3 = dd_mul(length_squared_2, squares_1);
    DoubleDouble _e5 = dd_constant(limits_1.error);
    DoubleDouble _e6 = dd_mul(_e3, _e5);
    DoubleDouble _e8 = dd_constant(ERROR_UNDERFLOW);
    DoubleDouble _e9 = dd_add(_e6, _e8);
    return PreciseBound(limits_1, _e3, _e9);
}

bool precise_bound_misses(PreciseBound bound_3, DoubleDouble discriminant_1) {
    DoubleDouble _e3 = dd_neg(discriminant_1);
    bool _e4 = dd_less(bound_3.error, _e3);
    return _e4;
}

bool precise_in_scale(DoubleDouble length_squared_3) {
    bool local_34 = false;
    DoubleDouble _e2 = dd_constant(SHORTEST_SQUARED);
    bool _e3 = dd_less_equal(_e2, length_squared_3);
    if (_e3) {
        DoubleDouble _e7 = dd_constant(LONGEST_SQUARED);
        bool _e8 = dd_less_equal(length_squared_3, _e7);
        local_34 = _e8;
    } else {
        local_34 = false;
    }
    bool _e10 = local_34;
    return _e10;
}

DoubleDouble precise_least_lambda() {
    float _e2 = exact_one;
    float _e6 = exact_one;
    return DoubleDouble((0.001 * _e2), (-1.0842022e-19 * _e6));
}

bool precise_in_range(PreciseLimits limits_2, DoubleDouble lambda_8) {
    DoubleDouble _e2 = precise_least_lambda();
    DoubleDouble _e4 = dd_constant(limits_2.lambda_error);
    DoubleDouble _e5 = dd_add(_e2, _e4);
    bool _e6 = dd_less_equal(_e5, lambda_8);
    return _e6;
}

bool precise_bound_is_too_small(PreciseBound bound_4, DoubleDouble a_20, DoubleDouble numerator_3, DoubleDouble root_3) {
    DoubleDouble _e4 = precise_least_lambda();
    DoubleDouble _e7 = dd_constant(bound_4.limits.lambda_error);
    DoubleDouble _e8 = dd_sub(_e4, _e7);
    DoubleDouble _e10 = dd_mul(a_20, _e8);
    DoubleDouble _e11 = dd_sub(_e10, numerator_3);
    DoubleDouble _e12 = dd_mul(_e11, root_3);
    bool _e13 = dd_less(bound_4.error, _e12);
    return _e13;
}

PreciseOutcome precise_bound_root(PreciseBound bound_5, DoubleDouble a_21, DoubleDouble numerator_4, DoubleDouble root_4) {
    bool local_35 = false;
    bool local_36 = false;
    DoubleDouble _e4 = dd_div(numerator_4, a_21);
    float share_1 = bound_5.limits.share;
    DoubleDouble _e8 = dd_constant(share_1);
    DoubleDouble _e9 = dd_mul(bound_5.size, _e8);
    DoubleDouble _e11 = dd_constant(ERROR_UNDERFLOW);
    DoubleDouble _e12 = dd_add(_e9, _e11);
    DoubleDouble _e13 = dd_mul(numerator_4, numerator_4);
    DoubleDouble _e16 = dd_constant((share_1 * 4.0));
    DoubleDouble _e17 = dd_mul(_e13, _e16);
    DoubleDouble _e18 = dd_add(_e12, _e17);
    DoubleDouble _e19 = dd_mul(root_4, numerator_4);
    bool _e20 = dd_less(_e18, _e19);
    DoubleDouble _e23 = dd_constant(ERROR_OVERFLOW);
    bool _e24 = dd_less(bound_5.size, _e23);
    if (_e20) {
        local_35 = _e24;
    } else {
        local_35 = false;
    }
    bool _e28 = local_35;
    if (_e28) {
        bool _e32 = precise_in_range(bound_5.limits, _e4);
        local_36 = _e32;
    } else {
        local_36 = false;
    }
    bool hits_2 = local_36;
    bool _e35 = precise_bound_is_too_small(bound_5, a_21, numerator_4, root_4);
    return PreciseOutcome(_e4, hits_2, _e35);
}

PreciseCylinder precise_cylinder_new(vec3 center_4, float radius_2, vec3 axis_4) {
    DoubleDouble3_ _e3 = dd3_of(axis_4);
    DoubleDouble _e4 = dd3_dot(_e3, _e3);
    DoubleDouble _e6 = dd_constant(SHORT_SQUARED);
    bool _e7 = dd_less(_e4, _e6);
    DoubleDouble _e11 = dd_constant((_e7 ? SHORT_SCALE : 1.0));
    DoubleDouble3_ _e12 = dd3_scaled(_e3, _e11);
    DoubleDouble _e13 = dd3_dot(_e12, _e12);
    DoubleDouble _e14 = dd_sqrt(_e13);
    DoubleDouble _e18 = dd_constant((_e7 ? SHORT_SQUARED : 1.0));
    DoubleDouble _e19 = dd_mul(_e14, _e18);
    DoubleDouble _e20 = dd_of(radius_2);
    DoubleDouble _e22 = dd_constant(2.0);
    DoubleDouble _e23 = dd_div(_e19, _e22);
    DoubleDouble3_ _e24 = dd3_of(center_4);
    DoubleDouble3_ _e25 = dd3_divided(_e12, _e14);
    DoubleDouble _e26 = dd_mul(_e20, _e20);
    return PreciseCylinder(_e24, _e25, _e20, _e26, _e23);
}

PreciseLimits precise_cylinder_limits() {
    return PreciseLimits(3.7865323e-29, 9.094947e-13, 5.5511154e-20);
}

DoubleDouble precise_cylinder_extent(PreciseCylinder cylinder_14) {
    DoubleDouble _e2 = dd3_magnitude(cylinder_14.center);
    DoubleDouble _e4 = dd_add(_e2, cylinder_14.radius);
    DoubleDouble _e6 = dd_add(_e4, cylinder_14.half_height);
    DoubleDouble _e8 = dd_constant(EXTENT_UNDERFLOW);
    DoubleDouble _e9 = dd_add(_e6, _e8);
    return _e9;
}

DoubleDouble precise_cylinder_margin(PreciseCylinder cylinder_15, DoubleDouble3_ direction_1, DoubleDouble lambda_9) {
    DoubleDouble _e3 = dd3_magnitude(direction_1);
    DoubleDouble _e4 = dd_mul(lambda_9, _e3);
    DoubleDouble _e6 = dd_constant(1.110223e-16);
    DoubleDouble _e7 = dd_mul(_e4, _e6);
    DoubleDouble _e8 = precise_cylinder_extent(cylinder_15);
    DoubleDouble _e10 = dd_constant(1.2621775e-29);
    DoubleDouble _e11 = dd_mul(_e8, _e10);
    DoubleDouble _e12 = dd_add(_e7, _e11);
    return _e12;
}

PreciseSide precise_side_new(PreciseCylinder cylinder_16, DoubleDouble3_ origin_1, DoubleDouble3_ direction_2) {
    DoubleDouble3_ _e4 = dd3_sub(origin_1, cylinder_16.center);
    DoubleDouble3_ _e6 = dd3_perpendicular_to(_e4, cylinder_16.axis);
    DoubleDouble _e7 = dd3_dot(_e6, _e6);
    DoubleDouble _e9 = dd_sub(_e7, cylinder_16.radius_squared);
    DoubleDouble3_ _e11 = dd3_perpendicular_to(direction_2, cylinder_16.axis);
    DoubleDouble _e12 = dd3_dot(_e11, _e11);
    DoubleDouble _e13 = dd3_dot(_e6, _e11);
    DoubleDouble _e14 = dd_mul(_e13, _e13);
    DoubleDouble _e15 = dd_mul(_e12, _e9);
    DoubleDouble _e16 = dd_sub(_e14, _e15);
    DoubleDouble _e17 = dd3_dot(direction_2, direction_2);
    DoubleDouble _e18 = dd3_dot(_e4, _e4);
    DoubleDouble _e20 = dd_add(_e18, cylinder_16.radius_squared);
    PreciseLimits _e21 = precise_cylinder_limits();
    PreciseBound _e22 = precise_bound_new(_e21, _e17, _e20);
    DoubleDouble _e24 = dd3_dot(_e4, cylinder_16.axis);
    DoubleDouble _e26 = dd3_dot(direction_2, cylinder_16.axis);
    return PreciseSide(_e22, _e17, _e12, _e13, _e16, _e24, _e26);
}

PreciseCrossing precise_side_crossing(PreciseSide side_2, PreciseCylinder cylinder_17, DoubleDouble3_ direction_3, DoubleDouble numerator_5, DoubleDouble root_5) {
    bool local_37 = false;
    bool local_38 = false;
    bool local_39 = false;
    bool local_40 = false;
    bool local_41 = false;
    bool local_42 = false;
    DoubleDouble _e8 = dd_constant(7.7371252e25);
    DoubleDouble _e9 = dd_mul(side_2.a, _e8);
    bool _e10 = dd_less_equal(side_2.length_squared, _e9);
    PreciseOutcome _e13 = precise_bound_root(side_2.bound, side_2.a, numerator_5, root_5);
    DoubleDouble _e17 = dd_mul(_e13.lambda, side_2.slope);
    DoubleDouble _e18 = dd_add(side_2.along, _e17);
    DoubleDouble _e20 = precise_cylinder_margin(cylinder_17, direction_3, _e13.lambda);
    if (_e10) {
        local_37 = _e13.hits;
    } else {
        local_37 = false;
    }
    bool accurate_3 = local_37;
    DoubleDouble _e27 = dd_sub(cylinder_17.half_height, _e20);
    DoubleDouble _e29 = dd_add(cylinder_17.half_height, _e20);
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
    return PreciseCrossing(_e13.lambda, hits_3, _e43, _e48, _e53, _e59);
}

bool precise_crossing_fails(PreciseCrossing crossing_1) {
    bool local_43 = false;
    bool local_44 = false;
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

bool precise_crossing_passes_by(PreciseCrossing entry_1, PreciseCrossing leaving_1) {
    bool local_45 = false;
    bool local_46 = false;
    bool local_47 = false;
    bool local_48 = false;
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

PreciseDecision precise_cap_filtered(PreciseCylinder cylinder_18, DoubleDouble3_ origin_2, DoubleDouble3_ direction_4, DoubleDouble3_ center_5, uint part_5) {
    DoubleDouble distance_ = DoubleDouble(0.0, 0.0);
    bool local_49 = false;
    bool local_50 = false;
    bool local_51 = false;
    bool local_52 = false;
    bool local_53 = false;
    bool local_54 = false;
    bool local_55 = false;
    DoubleDouble _e6 = dd_constant(1e-8);
    DoubleDouble3_ _e7 = dd3_sub(center_5, origin_2);
    DoubleDouble _e9 = dd3_dot(_e7, cylinder_18.axis);
    DoubleDouble _e11 = dd3_dot(direction_4, cylinder_18.axis);
    DoubleDouble _e12 = dd_abs(_e11);
    DoubleDouble _e13 = dd3_magnitude(direction_4);
    DoubleDouble _e15 = dd_constant(1.5777218e-30);
    DoubleDouble _e16 = dd_mul(_e13, _e15);
    DoubleDouble _e17 = dd_add(_e12, _e16);
    bool _e18 = dd_less(_e17, _e6);
    if (_e18) {
        PreciseDecision _e19 = precise_miss();
        return _e19;
    }
    DoubleDouble _e20 = dd_add(_e6, _e16);
    bool _e21 = dd_less(_e20, _e12);
    distance_ = _e9;
    DoubleDouble _e24 = dd_constant(0.0);
    bool _e25 = dd_less(_e11, _e24);
    if (_e25) {
        DoubleDouble _e26 = dd_neg(_e9);
        distance_ = _e26;
    }
    DoubleDouble _e27 = precise_cylinder_extent(cylinder_18);
    DoubleDouble _e28 = dd3_magnitude(_e7);
    DoubleDouble _e29 = dd_add(_e27, _e28);
    DoubleDouble _e30 = distance_;
    DoubleDouble _e32 = dd_constant(3.1554436e-30);
    DoubleDouble _e33 = dd_mul(_e29, _e32);
    DoubleDouble _e34 = dd_add(_e30, _e33);
    if (_e21) {
        DoubleDouble _e37 = dd_sub(_e12, _e16);
        DoubleDouble _e38 = precise_least_lambda();
        DoubleDouble _e39 = dd_mul(_e37, _e38);
        bool _e40 = dd_less(_e34, _e39);
        local_49 = _e40;
    } else {
        local_49 = false;
    }
    bool _e42 = local_49;
    if (_e42) {
        PreciseDecision _e43 = precise_miss();
        return _e43;
    }
    DoubleDouble _e44 = dd_div(_e9, _e11);
    DoubleDouble _e45 = distance_;
    DoubleDouble _e47 = dd_constant(4398046500000.0);
    DoubleDouble _e48 = dd_mul(_e45, _e47);
    bool _e49 = dd_less(_e29, _e48);
    if (_e49) {
        DoubleDouble _e53 = dd_constant(8796093000000.0);
        DoubleDouble _e54 = dd_mul(_e12, _e53);
        bool _e55 = dd_less(_e13, _e54);
        local_50 = _e55;
    } else {
        local_50 = false;
    }
    bool accurate_4 = local_50;
    if (accurate_4) {
        PreciseLimits _e60 = precise_cylinder_limits();
        bool _e61 = precise_in_range(_e60, _e44);
        local_51 = _e61;
    } else {
        local_51 = false;
    }
    bool is_in_range_1 = local_51;
    DoubleDouble3_ _e64 = dd3_scaled(direction_4, _e44);
    DoubleDouble3_ _e65 = dd3_add(origin_2, _e64);
    DoubleDouble3_ _e66 = dd3_sub(_e65, center_5);
    DoubleDouble _e67 = dd3_dot(_e66, _e66);
    DoubleDouble _e68 = dd_sqrt(_e67);
    DoubleDouble _e69 = precise_cylinder_margin(cylinder_18, direction_4, _e44);
    if (_e21) {
        local_52 = is_in_range_1;
    } else {
        local_52 = false;
    }
    bool _e73 = local_52;
    if (_e73) {
        DoubleDouble _e77 = dd_sub(cylinder_18.radius, _e69);
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
        DoubleDouble _e89 = dd_add(cylinder_18.radius, _e69);
        bool _e90 = dd_less(_e89, _e68);
        local_55 = _e90;
    } else {
        local_55 = false;
    }
    bool _e92 = local_55;
    if (_e92) {
        PreciseDecision _e93 = precise_miss();
        return _e93;
    }
    PreciseDecision _e94 = precise_uncertain();
    return _e94;
}

PreciseDecision precise_cylinder_filtered(vec3 center_6, float radius_3, vec3 axis_5, Ray ray_13) {
    bool local_56 = false;
    bool local_57 = false;
    bool local_58 = false;
    DoubleDouble half_ = DoubleDouble(0.0, 0.0);
    bool local_59 = false;
    PreciseCylinder _e4 = precise_cylinder_new(center_6, radius_3, axis_5);
    DoubleDouble3_ _e6 = dd3_of(ray_13.origin);
    DoubleDouble3_ _e8 = dd3_of(ray_13.direction);
    PreciseSide _e9 = precise_side_new(_e4, _e6, _e8);
    bool _e11 = precise_in_scale(_e9.length_squared);
    if (!(_e11)) {
        PreciseDecision _e13 = precise_uncertain();
        return _e13;
    }
    bool _e16 = precise_bound_misses(_e9.bound, _e9.discriminant);
    if (_e16) {
        PreciseDecision _e17 = precise_miss();
        return _e17;
    }
    DoubleDouble _e19 = dd_sqrt(_e9.discriminant);
    DoubleDouble _e21 = dd_neg(_e9.h);
    DoubleDouble _e22 = dd_sub(_e21, _e19);
    PreciseCrossing _e23 = precise_side_crossing(_e9, _e4, _e8, _e22, _e19);
    DoubleDouble _e25 = dd_neg(_e9.h);
    DoubleDouble _e26 = dd_add(_e25, _e19);
    PreciseCrossing _e27 = precise_side_crossing(_e9, _e4, _e8, _e26, _e19);
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
        PreciseDecision _e54 = precise_uncertain();
        return _e54;
    }
    bool _e55 = precise_crossing_passes_by(_e23, _e27);
    if (_e55) {
        PreciseDecision _e56 = precise_miss();
        return _e56;
    }
    DoubleDouble _e59 = dd_constant(0.0);
    bool _e60 = dd_less(_e9.slope, _e59);
    half_ = _e4.half_height;
    if (_e60) {
        DoubleDouble _e63 = half_;
        DoubleDouble _e64 = dd_neg(_e63);
        half_ = _e64;
    }
    DoubleDouble _e66 = half_;
    DoubleDouble3_ _e67 = dd3_scaled(_e4.axis, _e66);
    DoubleDouble3_ _e69 = dd3_sub(_e4.center, _e67);
    PreciseDecision _e73 = precise_cap_filtered(_e4, _e6, _e8, _e69, (_e60 ? TOP : BOTTOM));
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
    DoubleDouble3_ _e87 = dd3_add(_e4.center, _e67);
    PreciseDecision _e91 = precise_cap_filtered(_e4, _e6, _e8, _e87, (_e60 ? BOTTOM : TOP));
    return _e91;
}

float exact_code(bool certain, bool some, uint part_6) {
    if (!(certain)) {
        return 0.0;
    }
    return (some ? float((2u + part_6)) : 1.0);
}

ExactReport exact_report(Decision plain, Decision compensated, PreciseDecision doubled) {
    ExactReport report = ExactReport(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    Decision answer = Decision(false, false, 0.0, 0u);
    float _e8 = exact_code(plain.certain, plain.some, plain.part);
    report.plain = _e8;
    report.plain_lambda = plain.lambda;
    float _e15 = exact_code(compensated.certain, compensated.some, compensated.part);
    report.compensated = _e15;
    report.compensated_lambda = compensated.lambda;
    float _e22 = exact_code(doubled.certain, doubled.some, doubled.part);
    report.doubled = _e22;
    report.doubled_high = doubled.lambda.high;
    report.doubled_low = doubled.lambda.low;
    answer = plain;
    report.step_ = 1.0;
    if (!(plain.certain)) {
        answer = compensated;
        report.step_ = 2.0;
        if (!(compensated.certain)) {
            answer = Decision(doubled.certain, doubled.some, doubled.lambda.high, doubled.part);
            report.step_ = (doubled.certain ? 3.0 : 0.0);
        }
    }
    bool _e53 = answer.some;
    report.some = (_e53 ? 1.0 : 0.0);
    float _e57 = answer.lambda;
    report.lambda = _e57;
    uint _e60 = answer.part;
    report.part = float(_e60);
    ExactReport _e62 = report;
    return _e62;
}

void main() {
    uvec3 id = gl_GlobalInvocationID;
    if ((id.x >= uint(_group_0_binding_0_cs.length()))) {
        return;
    }
    float _e10 = _group_0_binding_0_cs[id.x].one;
    exact_one = _e10;
    PackedRay _e15 = _group_0_binding_0_cs[id.x].ray;
    Ray _e16 = ray_load(_e15);
    PackedVec3_ _e21 = _group_0_binding_0_cs[id.x].center;
    vec3 _e22 = vec3_load(_e21);
    PackedVec3_ _e27 = _group_0_binding_0_cs[id.x].axis;
    vec3 _e28 = vec3_load(_e27);
    float radius_4 = _group_0_binding_0_cs[id.x].radius;
    CylinderRecord _e34 = cylinder_new(_e22, radius_4, _e28);
    Decision _e35 = exact_cylinder_filtered(_e34, _e16);
    PreciseDecision _e36 = precise_cylinder_filtered(_e22, radius_4, _e28, _e16);
    Decision _e40 = decision_uncertain();
    ExactReport _e41 = exact_report(_e35, _e40, _e36);
    _group_0_binding_1_cs[id.x] = _e41;
    return;
}

