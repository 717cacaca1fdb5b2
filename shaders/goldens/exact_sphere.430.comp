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
struct SphereRecord {
    vec3 center;
    float radius;
    float radius_squared;
};
struct SphereView {
    vec3 r_c;
    float c;
};
struct SphereQuadratic {
    float h;
    float discriminant;
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
struct SquareTerms {
    float difference;
    float sum;
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
struct ExactSphereCase {
    PackedRay ray;
    PackedVec3_ center;
    float radius;
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

layout(std430, binding = 0) readonly buffer type_4_block_0Compute { ExactSphereCase _group_0_binding_0_cs[]; };

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

SphereRecord sphere_new(vec3 center, float radius) {
    return SphereRecord(center, radius, (radius * radius));
}

SphereView sphere_seen_from(SphereRecord sphere, vec3 origin) {
    vec3 r_c_1 = (sphere.center - origin);
    float _e4 = vec3_dot(r_c_1, r_c_1);
    return SphereView(r_c_1, (_e4 - sphere.radius_squared));
}

SphereQuadratic sphere_quadratic(SphereView view, vec3 direction_1, float a_2) {
    float _e4 = vec3_dot(direction_1, view.r_c);
    return SphereQuadratic(_e4, ((_e4 * _e4) - (a_2 * view.c)));
}

Root sphere_first_root(float a_3, float h, float discriminant) {
    float root_4 = sqrt(discriminant);
    float near = ((h - root_4) / a_3);
    float far = ((h + root_4) / a_3);
    bool _e8 = in_range(near);
    float lambda_8 = (_e8 ? near : far);
    bool _e10 = in_range(lambda_8);
    return Root(_e10, lambda_8);
}

vec3 sphere_outward(SphereRecord sphere_1, vec3 point_1) {
    return ((point_1 - sphere_1.center) / vec3(sphere_1.radius));
}

Root sphere_intersect(SphereRecord sphere_2, Ray ray_1) {
    float _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    SphereView _e6 = sphere_seen_from(sphere_2, ray_1.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
    Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    return Root((!((_e8.discriminant < 0.0)) && _e11.some), _e11.lambda);
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

CylinderRecord cylinder_with_unit_axis(vec3 center_1, float radius_1, vec3 axis_1, float half_height) {
    vec3 to_cap = (axis_1 * half_height);
    return CylinderRecord(center_1, axis_1, (center_1 + to_cap), (center_1 - to_cap), radius_1, (radius_1 * radius_1), half_height);
}

CylinderRecord cylinder_new(vec3 center_2, float radius_2, vec3 axis_2) {
    UnitAndLength _e3 = vec3_unit_and_length(axis_2);
    CylinderRecord _e8 = cylinder_with_unit_axis(center_2, radius_2, _e3.direction, (_e3.length_ / 2.0));
    return _e8;
}

CylinderView cylinder_seen_from(CylinderRecord cylinder, vec3 origin_1) {
    vec3 _e5 = vec3_perpendicular_to((origin_1 - cylinder.center), cylinder.axis);
    float _e6 = vec3_dot(_e5, _e5);
    return CylinderView(_e5, (_e6 - cylinder.radius_squared));
}

CylinderQuadratic cylinder_quadratic(CylinderRecord cylinder_1, CylinderView view_1, vec3 along) {
    vec3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    float _e5 = vec3_dot(_e4, _e4);
    float _e7 = vec3_dot(view_1.r_c, _e4);
    return CylinderQuadratic(_e5, _e7, ((_e7 * _e7) - (_e5 * view_1.c)));
}

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_2, float lambda_4) {
    vec3 _e3 = ray_at(ray_2, lambda_4);
    float _e7 = vec3_dot((_e3 - cylinder_2.center), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

Root cylinder_side(CylinderRecord cylinder_3, Ray ray_3, CylinderQuadratic quadratic) {
    float root_5 = sqrt(quadratic.discriminant);
    float near_1 = ((-(quadratic.h) - root_5) / quadratic.a);
    float far_1 = ((-(quadratic.h) + root_5) / quadratic.a);
    bool _e15 = in_range(near_1);
    bool _e16 = cylinder_within_height(cylinder_3, ray_3, near_1);
    bool near_counts = (_e15 && _e16);
    bool _e18 = in_range(far_1);
    bool _e19 = cylinder_within_height(cylinder_3, ray_3, far_1);
    bool far_counts = (_e18 && _e19);
    return Root((near_counts || far_counts), (near_counts ? near_1 : far_1));
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_4, vec3 center_3) {
    float _e5 = vec3_dot(ray_4.direction, cylinder_4.axis);
    float _e9 = vec3_dot((center_3 - ray_4.origin), cylinder_4.axis);
    float lambda_9 = (_e9 / _e5);
    vec3 _e11 = ray_at(ray_4, lambda_9);
    float _e13 = vec3_length((_e11 - center_3));
    bool on_disc = (_e13 <= cylinder_4.radius);
    bool _e20 = in_range(lambda_9);
    return Root(((!((abs(_e5) < 1e-8)) && _e20) && on_disc), lambda_9);
}

vec3 cylinder_outward(CylinderRecord cylinder_5, uint part, vec3 point_2) {
    vec3 _e6 = vec3_perpendicular_to((point_2 - cylinder_5.center), cylinder_5.axis);
    vec3 cap = ((part == TOP) ? cylinder_5.axis : -(cylinder_5.axis));
    return ((part == SIDE) ? _e6 : cap);
}

CylinderRoot cylinder_closer(CylinderRoot closest_2, Root later, uint part_1) {
    bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = (later.some && (!(closest_2.some) || _e8));
    float lambda_10 = (replaces ? later.lambda : closest_2.lambda);
    return CylinderRoot((closest_2.some || later.some), lambda_10, (replaces ? part_1 : closest_2.part));
}

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_6, Ray ray_5, Root side) {
    Root _e4 = cylinder_cap(cylinder_6, ray_5, cylinder_6.top);
    Root _e6 = cylinder_cap(cylinder_6, ray_5, cylinder_6.bottom);
    CylinderRoot _e12 = cylinder_closer(CylinderRoot(side.some, side.lambda, SIDE), _e4, TOP);
    CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    return _e14;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_7, Ray ray_6) {
    CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_6.origin);
    CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_6.direction);
    Root _e6 = cylinder_side(cylinder_7, ray_6, _e5);
    bool some_1 = (!((_e5.discriminant < 0.0)) && _e6.some);
    CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_6, Root(some_1, _e6.lambda));
    return _e15;
}

vec3 vec3_load(PackedVec3_ v_5) {
    return vec3(v_5.x, v_5.y, v_5.z);
}

PackedVec3_ vec3_store(vec3 v_6) {
    return PackedVec3_(v_6.x, v_6.y, v_6.z);
}

Ray ray_load(PackedRay ray_7) {
    vec3 _e2 = vec3_load(ray_7.origin);
    vec3 _e4 = vec3_load(ray_7.direction);
    return Ray(_e2, _e4);
}

PackedRay ray_store(Ray ray_8) {
    PackedVec3_ _e2 = vec3_store(ray_8.origin);
    PackedVec3_ _e4 = vec3_store(ray_8.direction);
    return PackedRay(_e2, _e4);
}

ExactHalves exact_halves(float a_4) {
    float large = (a_4 * SPLITTER);
    float _e4 = exact_one;
    float high_2 = ((large * _e4) - (large - a_4));
    return ExactHalves(high_2, (a_4 - high_2));
}

ExactSum exact_two_product(float a_5, float b_2) {
    bool scales_a = (SPLIT_LIMIT < abs(a_5));
    bool scales_b = (SPLIT_LIMIT < abs(b_2));
    float x = (scales_a ? (a_5 * SPLIT_SCALE) : a_5);
    float y = (scales_b ? (b_2 * SPLIT_SCALE) : b_2);
    float product = (x * y);
    ExactHalves _e15 = exact_halves(x);
    ExactHalves _e16 = exact_halves(y);
    float error = (((((_e15.high * _e16.high) - product) + (_e15.high * _e16.low)) + (_e15.low * _e16.high)) + (_e15.low * _e16.low));
    float unscaled = (scales_a ? (error * SPLIT_UNSCALE) : error);
    return ExactSum((a_5 * b_2), (scales_b ? (unscaled * SPLIT_UNSCALE) : unscaled));
}

float exact_mul_add(float a_6, float b_3, float c) {
    bool local = false;
    bool local_1 = false;
    bool local_2 = false;
    bool local_3 = false;
    ExactSum _e3 = exact_two_product(a_6, b_3);
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

bool error_bound_misses(ErrorBound bound, float discriminant_1) {
    return (bound.error < -(discriminant_1));
}

bool error_bound_is_too_small(ErrorBound bound_1, float a_7, float numerator, float root) {
    return (bound_1.error < (((a_7 * bound_1.limits.least) - numerator) * root));
}

Outcome error_bound_root(ErrorBound bound_2, float a_8, float numerator_1, float root_1) {
    bool local_5 = false;
    bool local_6 = false;
    float lambda_11 = (numerator_1 / a_8);
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
        local_6 = (bound_2.limits.most <= lambda_11);
    } else {
        local_6 = false;
    }
    bool hits = local_6;
    bool _e32 = error_bound_is_too_small(bound_2, a_8, numerator_1, root_1);
    return Outcome(lambda_11, hits, _e32);
}

Limits exact_sphere_limits() {
    return Limits(3.5527137e-15, 8.138021e-5, 0.001, 0.001);
}

float exact_sphere_squares(SphereRecord sphere_3, vec3 r_c) {
    float _e2 = vec3_dot(r_c, r_c);
    return (_e2 + sphere_3.radius_squared);
}

Decision exact_sphere_filtered(SphereRecord sphere_4, Ray ray_9) {
    bool local_7 = false;
    bool local_8 = false;
    float _e4 = vec3_dot(ray_9.direction, ray_9.direction);
    SphereView _e6 = sphere_seen_from(sphere_4, ray_9.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_9.direction, _e4);
    Limits _e9 = exact_sphere_limits();
    float _e11 = exact_sphere_squares(sphere_4, _e6.r_c);
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
    float root_6 = sqrt(_e8.discriminant);
    Outcome _e23 = error_bound_root(_e12, _e4, (_e8.h - root_6), root_6);
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
    Outcome _e36 = error_bound_root(_e12, _e4, (_e8.h + root_6), root_6);
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

SquareTerms exact_square_terms(SphereRecord sphere_5, vec3 origin_2) {
    float _e7 = exact_one;
    ExactSum _e8 = exact_two_sum(sphere_5.center.x, -(origin_2.x), _e7);
    float _e14 = exact_one;
    ExactSum _e15 = exact_two_sum(sphere_5.center.y, -(origin_2.y), _e14);
    float _e21 = exact_one;
    ExactSum _e22 = exact_two_sum(sphere_5.center.z, -(origin_2.z), _e21);
    ExactSum _e25 = exact_two_product(_e8.sum, _e8.sum);
    ExactSum _e28 = exact_two_product(_e15.sum, _e15.sum);
    ExactSum _e31 = exact_two_product(_e22.sum, _e22.sum);
    ExactSum _e34 = exact_two_product(sphere_5.radius, sphere_5.radius);
    float _e38 = exact_one;
    ExactSum _e39 = exact_two_sum(_e25.sum, _e28.sum, _e38);
    float _e43 = exact_one;
    ExactSum _e44 = exact_two_sum(_e39.sum, _e31.sum, _e43);
    float _e49 = exact_one;
    ExactSum _e50 = exact_two_sum(_e44.sum, -(_e34.sum), _e49);
    float _e58 = exact_mul_add(_e15.sum, _e15.error, (_e22.sum * _e22.error));
    float _e59 = exact_mul_add(_e8.sum, _e8.error, _e58);
    float sums = ((_e39.error + _e44.error) + _e50.error);
    float products = ((_e25.error + _e28.error) + (_e31.error - _e34.error));
    return SquareTerms((_e50.sum + ((sums + products) + (_e59 + _e59))), (_e44.sum + _e34.sum));
}

Decision exact_sphere_compensated(SphereRecord sphere_6, Ray ray_10) {
    bool local_9 = false;
    bool local_10 = false;
    bool local_11 = false;
    bool local_12 = false;
    bool local_13 = false;
    float _e4 = vec3_dot(ray_10.direction, ray_10.direction);
    SphereView _e6 = sphere_seen_from(sphere_6, ray_10.origin);
    SphereQuadratic _e8 = sphere_quadratic(_e6, ray_10.direction, _e4);
    float root_7 = sqrt(_e8.discriminant);
    SquareTerms _e12 = exact_square_terms(sphere_6, ray_10.origin);
    float denominator = (abs(_e8.h) + root_7);
    float lambda_12 = (abs(_e12.difference) / denominator);
    float size_1 = (_e4 * _e12.sum);
    if (((size_1 + ERROR_UNDERFLOW) < ((root_7 * denominator) * 4096.0))) {
        local_9 = (size_1 < ERROR_OVERFLOW);
    } else {
        local_9 = false;
    }
    bool accurate_1 = local_9;
    bool c_is_large = (((_e12.sum * 7.1054274e-15) + ERROR_UNDERFLOW) < abs(_e12.difference));
    bool ahead = (0.0 < (_e8.h * _e12.difference));
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
        local_13 = (_e61.most <= lambda_12);
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

DoubleDouble dd_of(float high) {
    return DoubleDouble(high, 0.0);
}

DoubleDouble dd_constant(float high_1) {
    float _e2 = exact_one;
    DoubleDouble _e4 = dd_of((high_1 * _e2));
    return _e4;
}

DoubleDouble dd_fast_two_sum(float a_9, float b_4) {
    float _e3 = exact_one;
    float high_3 = ((a_9 * _e3) + b_4);
    return DoubleDouble(high_3, (b_4 - (high_3 - a_9)));
}

DoubleDouble dd_add(DoubleDouble a_10, DoubleDouble b_5) {
    float _e5 = exact_one;
    ExactSum _e6 = exact_two_sum(a_10.high, b_5.high, _e5);
    float _e10 = exact_one;
    ExactSum _e11 = exact_two_sum(a_10.low, b_5.low, _e10);
    DoubleDouble _e16 = dd_fast_two_sum(_e6.sum, (_e6.error + _e11.sum));
    DoubleDouble _e21 = dd_fast_two_sum(_e16.high, (_e16.low + _e11.error));
    return _e21;
}

DoubleDouble dd_neg(DoubleDouble a_11) {
    return DoubleDouble(-(a_11.high), -(a_11.low));
}

DoubleDouble dd_sub(DoubleDouble a_12, DoubleDouble b_6) {
    DoubleDouble _e2 = dd_neg(b_6);
    DoubleDouble _e3 = dd_add(a_12, _e2);
    return _e3;
}

DoubleDouble dd_mul(DoubleDouble a_13, DoubleDouble b_7) {
    ExactSum _e4 = exact_two_product(a_13.high, b_7.high);
    float _e12 = exact_mul_add(a_13.high, b_7.low, (a_13.low * b_7.low));
    float _e13 = exact_mul_add(a_13.low, b_7.high, _e12);
    DoubleDouble _e17 = dd_fast_two_sum(_e4.sum, (_e4.error + _e13));
    return _e17;
}

DoubleDouble dd_div(DoubleDouble a_14, DoubleDouble b_8) {
    float high_4 = (a_14.high / b_8.high);
    ExactSum _e6 = exact_two_product(b_8.high, high_4);
    float _e10 = exact_mul_add(b_8.low, high_4, _e6.error);
    DoubleDouble _e11 = dd_fast_two_sum(_e6.sum, _e10);
    float remainder = ((a_14.high - _e11.high) + (a_14.low - _e11.low));
    DoubleDouble _e21 = dd_fast_two_sum(high_4, (remainder / b_8.high));
    return _e21;
}

DoubleDouble dd_sqrt(DoubleDouble a_15) {
    if ((a_15.high == 0.0)) {
        return a_15;
    }
    float _e7 = exact_one;
    float high_5 = (sqrt(a_15.high) * _e7);
    float _e11 = exact_mul_add(-(high_5), high_5, a_15.high);
    float remainder_1 = (_e11 + a_15.low);
    DoubleDouble _e16 = dd_fast_two_sum(high_5, (remainder_1 / (high_5 + high_5)));
    return _e16;
}

DoubleDouble dd_abs(DoubleDouble a_16) {
    if ((a_16.high < 0.0)) {
        DoubleDouble _e4 = dd_neg(a_16);
        return _e4;
    }
    return a_16;
}

bool dd_less(DoubleDouble a_17, DoubleDouble b_9) {
    bool local_14 = false;
    bool local_15 = false;
    if (!((a_17.high < b_9.high))) {
        if ((a_17.high == b_9.high)) {
            local_15 = (a_17.low < b_9.low);
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

bool dd_less_equal(DoubleDouble a_18, DoubleDouble b_10) {
    bool local_16 = false;
    bool local_17 = false;
    if (!((a_18.high < b_10.high))) {
        if ((a_18.high == b_10.high)) {
            local_17 = (a_18.low <= b_10.low);
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

DoubleDouble3_ dd3_of(vec3 v_7) {
    DoubleDouble _e2 = dd_of(v_7.x);
    DoubleDouble _e4 = dd_of(v_7.y);
    DoubleDouble _e6 = dd_of(v_7.z);
    return DoubleDouble3_(_e2, _e4, _e6);
}

DoubleDouble3_ dd3_add(DoubleDouble3_ a_19, DoubleDouble3_ b_11) {
    DoubleDouble _e4 = dd_add(a_19.x, b_11.x);
    DoubleDouble _e7 = dd_add(a_19.y, b_11.y);
    DoubleDouble _e10 = dd_add(a_19.z, b_11.z);
    return DoubleDouble3_(_e4, _e7, _e10);
}

DoubleDouble3_ dd3_sub(DoubleDouble3_ a_20, DoubleDouble3_ b_12) {
    DoubleDouble _e4 = dd_sub(a_20.x, b_12.x);
    DoubleDouble _e7 = dd_sub(a_20.y, b_12.y);
    DoubleDouble _e10 = dd_sub(a_20.z, b_12.z);
    return DoubleDouble3_(_e4, _e7, _e10);
}

DoubleDouble3_ dd3_scaled(DoubleDouble3_ v_8, DoubleDouble factor) {
    DoubleDouble _e3 = dd_mul(v_8.x, factor);
    DoubleDouble _e5 = dd_mul(v_8.y, factor);
    DoubleDouble _e7 = dd_mul(v_8.z, factor);
    return DoubleDouble3_(_e3, _e5, _e7);
}

DoubleDouble3_ dd3_divided(DoubleDouble3_ v_9, DoubleDouble divisor) {
    DoubleDouble _e3 = dd_div(v_9.x, divisor);
    DoubleDouble _e5 = dd_div(v_9.y, divisor);
    DoubleDouble _e7 = dd_div(v_9.z, divisor);
    return DoubleDouble3_(_e3, _e5, _e7);
}

DoubleDouble dd3_dot(DoubleDouble3_ a_21, DoubleDouble3_ b_13) {
    DoubleDouble _e4 = dd_mul(a_21.x, b_13.x);
    DoubleDouble _e7 = dd_mul(a_21.y, b_13.y);
    DoubleDouble _e8 = dd_add(_e4, _e7);
    DoubleDouble _e11 = dd_mul(a_21.z, b_13.z);
    DoubleDouble _e12 = dd_add(_e8, _e11);
    return _e12;
}

DoubleDouble dd3_magnitude(DoubleDouble3_ v_10) {
    DoubleDouble _e2 = dd_abs(v_10.x);
    DoubleDouble _e4 = dd_abs(v_10.y);
    DoubleDouble _e5 = dd_add(_e2, _e4);
    DoubleDouble _e7 = dd_abs(v_10.z);
    DoubleDouble _e8 = dd_add(_e5, _e7);
    return _e8;
}

DoubleDouble3_ dd3_perpendicular_to(DoubleDouble3_ v_11, DoubleDouble3_ axis_3) {
    DoubleDouble _e2 = dd3_dot(v_11, axis_3);
    DoubleDouble3_ _e3 = dd3_scaled(axis_3, _e2);
    DoubleDouble3_ _e4 = dd3_sub(v_11, _e3);
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

PreciseDecision precise_hit(DoubleDouble lambda_6, uint part_3) {
    return PreciseDecision(true, true, lambda_6, part_3);
}

PreciseBound precise_bound_new(PreciseLimits limits_1, DoubleDouble length_squared_2, DoubleDouble squares_1) {
    DoubleDouble _e3 = dd_mul(length_squared_2, squares_1);
    DoubleDouble _e5 = dd_constant(limits_1.error);
    DoubleDouble _e6 = dd_mul(_e3, _e5);
    DoubleDouble _e8 = dd_constant(ERROR_UNDERFLOW);
    DoubleDouble _e9 = dd_add(_e6, _e8);
    return PreciseBound(limits_1, _e3, _e9);
}

bool precise_bound_misses(PreciseBound bound_3, DoubleDouble discriminant_2) {
    DoubleDouble _e3 = dd_neg(discriminant_2);
    bool _e4 = dd_less(bound_3.error, _e3);
    return _e4;
}

bool precise_in_scale(DoubleDouble length_squared_3) {
    bool local_18 = false;
    DoubleDouble _e2 = dd_constant(SHORTEST_SQUARED);
    bool _e3 = dd_less_equal(_e2, length_squared_3);
    if (_e3) {
        DoubleDouble _e7 = dd_constant(LONGEST_SQUARED);
        bool _e8 = dd_less_equal(length_squared_3, _e7);
        local_18 = _e8;
    } else {
        local_18 = false;
    }
    bool _e10 = local_18;
    return _e10;
}

DoubleDouble precise_least_lambda() {
    float _e2 = exact_one;
    float _e6 = exact_one;
    return DoubleDouble((0.001 * _e2), (-1.0842022e-19 * _e6));
}

bool precise_in_range(PreciseLimits limits_2, DoubleDouble lambda_7) {
    DoubleDouble _e2 = precise_least_lambda();
    DoubleDouble _e4 = dd_constant(limits_2.lambda_error);
    DoubleDouble _e5 = dd_add(_e2, _e4);
    bool _e6 = dd_less_equal(_e5, lambda_7);
    return _e6;
}

bool precise_bound_is_too_small(PreciseBound bound_4, DoubleDouble a_22, DoubleDouble numerator_2, DoubleDouble root_2) {
    DoubleDouble _e4 = precise_least_lambda();
    DoubleDouble _e7 = dd_constant(bound_4.limits.lambda_error);
    DoubleDouble _e8 = dd_sub(_e4, _e7);
    DoubleDouble _e10 = dd_mul(a_22, _e8);
    DoubleDouble _e11 = dd_sub(_e10, numerator_2);
    DoubleDouble _e12 = dd_mul(_e11, root_2);
    bool _e13 = dd_less(bound_4.error, _e12);
    return _e13;
}

PreciseOutcome precise_bound_root(PreciseBound bound_5, DoubleDouble a_23, DoubleDouble numerator_3, DoubleDouble root_3) {
    bool local_19 = false;
    bool local_20 = false;
    DoubleDouble _e4 = dd_div(numerator_3, a_23);
    float share_1 = bound_5.limits.share;
    DoubleDouble _e8 = dd_constant(share_1);
    DoubleDouble _e9 = dd_mul(bound_5.size, _e8);
    DoubleDouble _e11 = dd_constant(ERROR_UNDERFLOW);
    DoubleDouble _e12 = dd_add(_e9, _e11);
    DoubleDouble _e13 = dd_mul(numerator_3, numerator_3);
    DoubleDouble _e16 = dd_constant((share_1 * 4.0));
    DoubleDouble _e17 = dd_mul(_e13, _e16);
    DoubleDouble _e18 = dd_add(_e12, _e17);
    DoubleDouble _e19 = dd_mul(root_3, numerator_3);
    bool _e20 = dd_less(_e18, _e19);
    DoubleDouble _e23 = dd_constant(ERROR_OVERFLOW);
    bool _e24 = dd_less(bound_5.size, _e23);
    if (_e20) {
        local_19 = _e24;
    } else {
        local_19 = false;
    }
    bool _e28 = local_19;
    if (_e28) {
        bool _e32 = precise_in_range(bound_5.limits, _e4);
        local_20 = _e32;
    } else {
        local_20 = false;
    }
    bool hits_1 = local_20;
    bool _e35 = precise_bound_is_too_small(bound_5, a_23, numerator_3, root_3);
    return PreciseOutcome(_e4, hits_1, _e35);
}

PreciseLimits precise_sphere_limits() {
    return PreciseLimits(6.3108872e-30, 4.8506386e-12, 1.0408341e-20);
}

PreciseDecision precise_sphere_filtered(vec3 center_4, float radius_3, Ray ray_11) {
    bool local_21 = false;
    bool local_22 = false;
    DoubleDouble3_ _e4 = dd3_of(ray_11.direction);
    DoubleDouble _e5 = dd3_dot(_e4, _e4);
    DoubleDouble _e6 = dd_of(radius_3);
    DoubleDouble _e7 = dd_of(radius_3);
    DoubleDouble _e8 = dd_mul(_e6, _e7);
    DoubleDouble3_ _e9 = dd3_of(center_4);
    DoubleDouble3_ _e11 = dd3_of(ray_11.origin);
    DoubleDouble3_ _e12 = dd3_sub(_e9, _e11);
    DoubleDouble _e13 = dd3_dot(_e12, _e12);
    DoubleDouble _e14 = dd_sub(_e13, _e8);
    DoubleDouble _e15 = dd3_dot(_e4, _e12);
    DoubleDouble _e16 = dd_mul(_e15, _e15);
    DoubleDouble _e17 = dd_mul(_e5, _e14);
    DoubleDouble _e18 = dd_sub(_e16, _e17);
    PreciseLimits _e19 = precise_sphere_limits();
    DoubleDouble _e20 = dd_add(_e13, _e8);
    PreciseBound _e21 = precise_bound_new(_e19, _e5, _e20);
    bool _e22 = precise_in_scale(_e5);
    if (!(_e22)) {
        PreciseDecision _e24 = precise_uncertain();
        return _e24;
    }
    bool _e25 = precise_bound_misses(_e21, _e18);
    if (_e25) {
        PreciseDecision _e26 = precise_miss();
        return _e26;
    }
    DoubleDouble _e27 = dd_sqrt(_e18);
    DoubleDouble _e28 = dd_sub(_e15, _e27);
    PreciseOutcome _e29 = precise_bound_root(_e21, _e5, _e28, _e27);
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
    DoubleDouble _e40 = dd_add(_e15, _e27);
    PreciseOutcome _e41 = precise_bound_root(_e21, _e5, _e40, _e27);
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
        PreciseDecision _e52 = precise_miss();
        return _e52;
    }
    PreciseDecision _e53 = precise_uncertain();
    return _e53;
}

float exact_code(bool certain, bool some, uint part_4) {
    if (!(certain)) {
        return 0.0;
    }
    return (some ? float((2u + part_4)) : 1.0);
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
    float radius_4 = _group_0_binding_0_cs[id.x].radius;
    SphereRecord _e28 = sphere_new(_e22, radius_4);
    Decision _e29 = exact_sphere_filtered(_e28, _e16);
    Decision _e30 = exact_sphere_compensated(_e28, _e16);
    PreciseDecision _e34 = precise_sphere_filtered(_e22, radius_4, _e16);
    ExactReport _e35 = exact_report(_e29, _e30, _e34);
    _group_0_binding_1_cs[id.x] = _e35;
    return;
}

