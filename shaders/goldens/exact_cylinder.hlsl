struct ExactSum {
    float sum;
    float error;
};

struct Ray {
    float3 origin;
    int _pad1_0;
    float3 direction;
    int _end_pad_0;
};

struct Root {
    bool some;
    float lambda;
};

struct Hit {
    float3 point_;
    int _pad1_0;
    float3 normal;
    bool front;
};

struct UnitAndLength {
    float3 direction;
    float length_;
};

struct CylinderRecord {
    float3 center_;
    int _pad1_0;
    float3 axis;
    int _pad2_0;
    float3 top;
    int _pad3_0;
    float3 bottom;
    float radius;
    float radius_squared;
    float half_height;
    int _end_pad_0;
    int _end_pad_1;
};

struct CylinderView {
    float3 r_c;
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
    DoubleDouble3_ center_;
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
    PackedVec3_ center_;
    float radius;
    PackedVec3_ axis;
    float one;
};

static const float SHORT_SQUARED = 0.0;
static const float SHORT_SCALE = 1.0;
static const float BELOW_ONE = 0.99999994;
static const float LEAST_SQUARED = 0.0;
static const float ERROR_UNDERFLOW = 0.0;
static const float ERROR_OVERFLOW = 3e38;
static const float SHORTEST_SQUARED = 0.0;
static const float LONGEST_SQUARED = 3e38;
static const float EXTENT_UNDERFLOW = 0.0;
static const float SPLITTER = 4097.0;
static const float SPLIT_LIMIT = 1e33;
static const float SPLIT_SCALE = 1.5258789e-5;
static const float SPLIT_UNSCALE = 65536.0;
static const float UNWRITTEN = -2.8735182e-16;
static const uint SIDE = 0u;
static const uint TOP = 1u;
static const uint BOTTOM = 2u;

static float exact_one = (float)0;
ByteAddressBuffer cases : register(t0);
RWByteAddressBuffer reports : register(u1);

float vec3_dot(float3 a, float3 b)
{
    return (((a.x * b.x) + (a.y * b.y)) + (a.z * b.z));
}

float vec3_length(float3 v)
{
    const float _e1 = vec3_dot(v, v);
    return sqrt(_e1);
}

float3 vec3_unit(float3 v_1)
{
    const float _e1 = vec3_length(v_1);
    return (v_1 / (_e1).xxx);
}

float3 vec3_perpendicular_to(float3 v_2, float3 axis)
{
    const float _e2 = vec3_dot(v_2, axis);
    return (v_2 - (axis * _e2));
}

bool vec3_is_negligible(float3 v_3)
{
    return (((abs(v_3.x) < 1e-8) & (abs(v_3.y) < 1e-8)) & (abs(v_3.z) < 1e-8));
}

ExactSum ConstructExactSum(float arg0, float arg1) {
    ExactSum ret = (ExactSum)0;
    ret.sum = arg0;
    ret.error = arg1;
    return ret;
}

ExactSum exact_two_sum(float a_1, float b_1, float one)
{
    float sum = ((a_1 * one) + b_1);
    float b_part = (sum - a_1);
    float a_part = (sum - b_part);
    const ExactSum exactsum = ConstructExactSum(sum, ((a_1 - a_part) + (b_1 - b_part)));
    return exactsum;
}

float3 ray_at(Ray ray, float lambda)
{
    return (ray.origin + (ray.direction * lambda));
}

bool in_range(float lambda_1)
{
    return (0.001 <= lambda_1);
}

Hit ConstructHit(float3 arg0, float3 arg1, bool arg2) {
    Hit ret = (Hit)0;
    ret.point_ = arg0;
    ret.normal = arg1;
    ret.front = arg2;
    return ret;
}

Hit hit_facing(float3 direction, float3 point_, float3 outward)
{
    const float _e3 = vec3_dot(direction, outward);
    bool front = (_e3 < 0.0);
    const Hit hit = ConstructHit(point_, (front ? outward : -(outward)), front);
    return hit;
}

UnitAndLength ConstructUnitAndLength(float3 arg0, float arg1) {
    UnitAndLength ret = (UnitAndLength)0;
    ret.direction = arg0;
    ret.length_ = arg1;
    return ret;
}

UnitAndLength vec3_unit_and_length(float3 v_4)
{
    const float _e1 = vec3_dot(v_4, v_4);
    if ((_e1 < SHORT_SQUARED)) {
        float3 scaled = (v_4 * SHORT_SCALE);
        const float _e6 = vec3_length(scaled);
        const UnitAndLength unitandlength = ConstructUnitAndLength((scaled / (_e6).xxx), (_e6 * SHORT_SQUARED));
        return unitandlength;
    }
    const float _e12 = vec3_length(v_4);
    const UnitAndLength unitandlength_1 = ConstructUnitAndLength((v_4 / (_e12).xxx), _e12);
    return unitandlength_1;
}

bool tie_later_cap_is_closer(float lambda_2, float closest)
{
    return (lambda_2 < closest);
}

int tie_rank(uint order, bool on_cap)
{
    return (on_cap ? asint(asuint(int(-1)) - asuint(int(order))) : int(order));
}

bool tie_is_closer(float lambda_3, int rank, float closest_1, int closest_rank)
{
    return ((lambda_3 < closest_1) | ((lambda_3 <= closest_1) & (rank >= closest_rank)));
}

CylinderRecord ConstructCylinderRecord(float3 arg0, float3 arg1, float3 arg2, float3 arg3, float arg4, float arg5, float arg6) {
    CylinderRecord ret = (CylinderRecord)0;
    ret.center_ = arg0;
    ret.axis = arg1;
    ret.top = arg2;
    ret.bottom = arg3;
    ret.radius = arg4;
    ret.radius_squared = arg5;
    ret.half_height = arg6;
    return ret;
}

CylinderRecord cylinder_with_unit_axis(float3 center_, float radius, float3 axis_1, float half_height)
{
    float3 to_cap = (axis_1 * half_height);
    const CylinderRecord cylinderrecord = ConstructCylinderRecord(center_, axis_1, (center_ + to_cap), (center_ - to_cap), radius, (radius * radius), half_height);
    return cylinderrecord;
}

CylinderRecord cylinder_new(float3 center_1, float radius_1, float3 axis_2)
{
    const UnitAndLength _e3 = vec3_unit_and_length(axis_2);
    const CylinderRecord _e8 = cylinder_with_unit_axis(center_1, radius_1, _e3.direction, (_e3.length_ / 2.0));
    const CylinderRecord cylinderrecord_1 = _e8;
    return cylinderrecord_1;
}

CylinderView ConstructCylinderView(float3 arg0, float arg1) {
    CylinderView ret = (CylinderView)0;
    ret.r_c = arg0;
    ret.c = arg1;
    return ret;
}

CylinderView cylinder_seen_from(CylinderRecord cylinder, float3 origin)
{
    const float3 _e5 = vec3_perpendicular_to((origin - cylinder.center_), cylinder.axis);
    const float _e6 = vec3_dot(_e5, _e5);
    const CylinderView cylinderview = ConstructCylinderView(_e5, (_e6 - cylinder.radius_squared));
    return cylinderview;
}

CylinderQuadratic ConstructCylinderQuadratic(float arg0, float arg1, float arg2) {
    CylinderQuadratic ret = (CylinderQuadratic)0;
    ret.a = arg0;
    ret.h = arg1;
    ret.discriminant = arg2;
    return ret;
}

CylinderQuadratic cylinder_quadratic(CylinderRecord cylinder_1, CylinderView view, float3 along)
{
    const float3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    const float _e5 = vec3_dot(_e4, _e4);
    const float _e7 = vec3_dot(view.r_c, _e4);
    const CylinderQuadratic cylinderquadratic = ConstructCylinderQuadratic(_e5, _e7, ((_e7 * _e7) - (_e5 * view.c)));
    return cylinderquadratic;
}

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_1, float lambda_4)
{
    const float3 _e3 = ray_at(ray_1, lambda_4);
    const float _e7 = vec3_dot((_e3 - cylinder_2.center_), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

Root ConstructRoot(bool arg0, float arg1) {
    Root ret = (Root)0;
    ret.some = arg0;
    ret.lambda = arg1;
    return ret;
}

Root cylinder_side(CylinderRecord cylinder_3, Ray ray_2, CylinderQuadratic quadratic)
{
    float root_6 = sqrt(quadratic.discriminant);
    float near = ((-(quadratic.h) - root_6) / quadratic.a);
    float far = ((-(quadratic.h) + root_6) / quadratic.a);
    const bool _e15 = in_range(near);
    const bool _e16 = cylinder_within_height(cylinder_3, ray_2, near);
    bool near_counts = (_e15 & _e16);
    const bool _e18 = in_range(far);
    const bool _e19 = cylinder_within_height(cylinder_3, ray_2, far);
    bool far_counts = (_e18 & _e19);
    const Root root_7 = ConstructRoot((near_counts | far_counts), (near_counts ? near : far));
    return root_7;
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_3, float3 center_2)
{
    const float _e5 = vec3_dot(ray_3.direction, cylinder_4.axis);
    const float _e9 = vec3_dot((center_2 - ray_3.origin), cylinder_4.axis);
    float lambda_10 = (_e9 / _e5);
    const float3 _e11 = ray_at(ray_3, lambda_10);
    const float _e13 = vec3_length((_e11 - center_2));
    bool on_disc = (_e13 <= cylinder_4.radius);
    const bool _e20 = in_range(lambda_10);
    const Root root_8 = ConstructRoot(((!((abs(_e5) < 1e-8)) & _e20) & on_disc), lambda_10);
    return root_8;
}

float3 cylinder_outward(CylinderRecord cylinder_5, uint part, float3 point_1)
{
    const float3 _e6 = vec3_perpendicular_to((point_1 - cylinder_5.center_), cylinder_5.axis);
    float3 cap = ((part == TOP) ? cylinder_5.axis : -(cylinder_5.axis));
    return ((part == SIDE) ? _e6 : cap);
}

CylinderRoot ConstructCylinderRoot(bool arg0, float arg1, uint arg2) {
    CylinderRoot ret = (CylinderRoot)0;
    ret.some = arg0;
    ret.lambda = arg1;
    ret.part = arg2;
    return ret;
}

CylinderRoot cylinder_closer(CylinderRoot closest_2, Root later, uint part_1)
{
    const bool _e8 = tie_later_cap_is_closer(later.lambda, closest_2.lambda);
    bool replaces = (later.some & (!(closest_2.some) | _e8));
    float lambda_11 = (replaces ? later.lambda : closest_2.lambda);
    const CylinderRoot cylinderroot = ConstructCylinderRoot((closest_2.some | later.some), lambda_11, (replaces ? part_1 : closest_2.part));
    return cylinderroot;
}

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_6, Ray ray_4, Root side)
{
    const Root _e4 = cylinder_cap(cylinder_6, ray_4, cylinder_6.top);
    const Root _e6 = cylinder_cap(cylinder_6, ray_4, cylinder_6.bottom);
    const CylinderRoot _e12 = cylinder_closer(ConstructCylinderRoot(side.some, side.lambda, SIDE), _e4, TOP);
    const CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    const CylinderRoot cylinderroot_1 = _e14;
    return cylinderroot_1;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_7, Ray ray_5)
{
    const CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_5.origin);
    const CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_5.direction);
    const Root _e6 = cylinder_side(cylinder_7, ray_5, _e5);
    bool some_1 = (!((_e5.discriminant < 0.0)) & _e6.some);
    const CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_5, ConstructRoot(some_1, _e6.lambda));
    const CylinderRoot cylinderroot_2 = _e15;
    return cylinderroot_2;
}

float3 vec3_load(PackedVec3_ v_5)
{
    return float3(v_5.x, v_5.y, v_5.z);
}

PackedVec3_ ConstructPackedVec3_(float arg0, float arg1, float arg2) {
    PackedVec3_ ret = (PackedVec3_)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

PackedVec3_ vec3_store(float3 v_6)
{
    const PackedVec3_ packedvec3_ = ConstructPackedVec3_(v_6.x, v_6.y, v_6.z);
    return packedvec3_;
}

Ray ConstructRay(float3 arg0, float3 arg1) {
    Ray ret = (Ray)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

Ray ray_load(PackedRay ray_6)
{
    const float3 _e2 = vec3_load(ray_6.origin);
    const float3 _e4 = vec3_load(ray_6.direction);
    const Ray ray_14 = ConstructRay(_e2, _e4);
    return ray_14;
}

PackedRay ConstructPackedRay(PackedVec3_ arg0, PackedVec3_ arg1) {
    PackedRay ret = (PackedRay)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

PackedRay ray_store(Ray ray_7)
{
    const PackedVec3_ _e2 = vec3_store(ray_7.origin);
    const PackedVec3_ _e4 = vec3_store(ray_7.direction);
    const PackedRay packedray = ConstructPackedRay(_e2, _e4);
    return packedray;
}

ExactHalves ConstructExactHalves(float arg0, float arg1) {
    ExactHalves ret = (ExactHalves)0;
    ret.high = arg0;
    ret.low = arg1;
    return ret;
}

ExactHalves exact_halves(float a_2)
{
    float large = (a_2 * SPLITTER);
    float _e4 = exact_one;
    float high_2 = ((large * _e4) - (large - a_2));
    const ExactHalves exacthalves = ConstructExactHalves(high_2, (a_2 - high_2));
    return exacthalves;
}

ExactSum exact_two_product(float a_3, float b_2)
{
    bool scales_a = (SPLIT_LIMIT < abs(a_3));
    bool scales_b = (SPLIT_LIMIT < abs(b_2));
    float x = (scales_a ? (a_3 * SPLIT_SCALE) : a_3);
    float y = (scales_b ? (b_2 * SPLIT_SCALE) : b_2);
    float product = (x * y);
    const ExactHalves _e15 = exact_halves(x);
    const ExactHalves _e16 = exact_halves(y);
    float error = (((((_e15.high * _e16.high) - product) + (_e15.high * _e16.low)) + (_e15.low * _e16.high)) + (_e15.low * _e16.low));
    float unscaled = (scales_a ? (error * SPLIT_UNSCALE) : error);
    const ExactSum exactsum_1 = ConstructExactSum((a_3 * b_2), (scales_b ? (unscaled * SPLIT_UNSCALE) : unscaled));
    return exactsum_1;
}

float exact_mul_add(float a_4, float b_3, float c)
{
    bool local = (bool)0;
    bool local_1 = (bool)0;
    bool local_2 = (bool)0;
    bool local_3 = (bool)0;

    const ExactSum _e3 = exact_two_product(a_4, b_3);
    float _e6 = exact_one;
    const ExactSum _e7 = exact_two_sum(c, _e3.error, _e6);
    float _e11 = exact_one;
    const ExactSum _e12 = exact_two_sum(_e3.sum, _e7.sum, _e11);
    float _e16 = exact_one;
    const ExactSum _e17 = exact_two_sum(_e7.error, _e12.error, _e16);
    float _e21 = exact_one;
    const ExactSum _e22 = exact_two_sum(_e12.sum, _e17.sum, _e21);
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

Decision ConstructDecision(bool arg0, bool arg1, float arg2, uint arg3) {
    Decision ret = (Decision)0;
    ret.certain = arg0;
    ret.some = arg1;
    ret.lambda = arg2;
    ret.part = arg3;
    return ret;
}

Decision decision_uncertain()
{
    const Decision decision = ConstructDecision(false, false, 0.0, 0u);
    return decision;
}

Decision decision_miss()
{
    const Decision decision_1 = ConstructDecision(true, false, 0.0, 0u);
    return decision_1;
}

Decision decision_hit(float lambda_5, uint part_2)
{
    const Decision decision_2 = ConstructDecision(true, true, lambda_5, part_2);
    return decision_2;
}

bool exact_in_scale(float length_squared)
{
    bool local_4 = (bool)0;

    if ((SHORTEST_SQUARED <= length_squared)) {
        local_4 = (length_squared <= LONGEST_SQUARED);
    } else {
        local_4 = false;
    }
    bool _e8 = local_4;
    return _e8;
}

ErrorBound ConstructErrorBound(Limits arg0, float arg1, float arg2) {
    ErrorBound ret = (ErrorBound)0;
    ret.limits = arg0;
    ret.size = arg1;
    ret.error = arg2;
    return ret;
}

ErrorBound error_bound_new(Limits limits, float length_squared_1, float squares)
{
    float size = (length_squared_1 * squares);
    const ErrorBound errorbound = ConstructErrorBound(limits, size, ((size * limits.error) + ERROR_UNDERFLOW));
    return errorbound;
}

bool error_bound_misses(ErrorBound bound, float discriminant)
{
    return (bound.error < -(discriminant));
}

bool error_bound_is_too_small(ErrorBound bound_1, float a_5, float numerator, float root)
{
    return (bound_1.error < (((a_5 * bound_1.limits.least) - numerator) * root));
}

Outcome ConstructOutcome(float arg0, bool arg1, bool arg2) {
    Outcome ret = (Outcome)0;
    ret.lambda = arg0;
    ret.hits = arg1;
    ret.fails = arg2;
    return ret;
}

Outcome error_bound_root(ErrorBound bound_2, float a_6, float numerator_1, float root_1)
{
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;

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
    const bool _e32 = error_bound_is_too_small(bound_2, a_6, numerator_1, root_1);
    const Outcome outcome = ConstructOutcome(lambda_12, hits, _e32);
    return outcome;
}

Limits ConstructLimits(float arg0, float arg1, float arg2, float arg3) {
    Limits ret = (Limits)0;
    ret.error = arg0;
    ret.share = arg1;
    ret.least = arg2;
    ret.most = arg3;
    return ret;
}

Limits exact_cylinder_limits()
{
    const Limits limits_3 = ConstructLimits(2.1316282e-14, 1.5258789e-5, 0.001, 0.001);
    return limits_3;
}

float exact_magnitude(float3 v_7)
{
    return ((abs(v_7.x) + abs(v_7.y)) + abs(v_7.z));
}

float exact_cylinder_extent(CylinderRecord cylinder_8)
{
    const float _e2 = exact_magnitude(cylinder_8.center_);
    return (((_e2 + cylinder_8.radius) + cylinder_8.half_height) + EXTENT_UNDERFLOW);
}

float exact_cylinder_margin(CylinderRecord cylinder_9, Ray ray_8, float lambda_6)
{
    const float _e4 = exact_magnitude(ray_8.direction);
    float along_1 = ((lambda_6 * _e4) * 3.7252903e-9);
    const float _e8 = exact_cylinder_extent(cylinder_9);
    return (along_1 + (_e8 * 7.1054274e-15));
}

ExactSide ConstructExactSide(ErrorBound arg0, float arg1, float arg2, float arg3, float arg4, float arg5, float arg6) {
    ExactSide ret = (ExactSide)0;
    ret.bound = arg0;
    ret.length_squared = arg1;
    ret.a = arg2;
    ret.h = arg3;
    ret.discriminant = arg4;
    ret.along = arg5;
    ret.slope = arg6;
    return ret;
}

ExactSide exact_side_new(CylinderRecord cylinder_10, Ray ray_9)
{
    float3 from_center = (ray_9.origin - cylinder_10.center_);
    const CylinderView _e6 = cylinder_seen_from(cylinder_10, ray_9.origin);
    const CylinderQuadratic _e8 = cylinder_quadratic(cylinder_10, _e6, ray_9.direction);
    const float _e11 = vec3_dot(ray_9.direction, ray_9.direction);
    const float _e12 = vec3_dot(from_center, from_center);
    float squares_2 = (_e12 + cylinder_10.radius_squared);
    const Limits _e15 = exact_cylinder_limits();
    const ErrorBound _e16 = error_bound_new(_e15, _e11, squares_2);
    const float _e18 = vec3_dot(from_center, cylinder_10.axis);
    const float _e21 = vec3_dot(ray_9.direction, cylinder_10.axis);
    const ExactSide exactside = ConstructExactSide(_e16, _e11, _e8.a, _e8.h, _e8.discriminant, _e18, _e21);
    return exactside;
}

ExactCrossing ConstructExactCrossing(float arg0, bool arg1, bool arg2, bool arg3, bool arg4, bool arg5) {
    ExactCrossing ret = (ExactCrossing)0;
    ret.lambda = arg0;
    ret.hits = arg1;
    ret.straight = arg2;
    ret.behind = arg3;
    ret.above = arg4;
    ret.below = arg5;
    return ret;
}

ExactCrossing exact_side_crossing(ExactSide side_1, CylinderRecord cylinder_11, Ray ray_10, float numerator_2, float root_2)
{
    bool local_7 = (bool)0;
    bool local_8 = (bool)0;
    bool local_9 = (bool)0;
    bool local_10 = (bool)0;
    bool local_11 = (bool)0;
    bool local_12 = (bool)0;

    bool steep_enough = (side_1.length_squared <= (side_1.a * 274877900000.0));
    const Outcome _e12 = error_bound_root(side_1.bound, side_1.a, numerator_2, root_2);
    float along_2 = (side_1.along + (_e12.lambda * side_1.slope));
    const float _e19 = exact_cylinder_margin(cylinder_11, ray_10, _e12.lambda);
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
    const ExactCrossing exactcrossing = ConstructExactCrossing(_e12.lambda, hits_1, straight, behind, _e52, _e58);
    return exactcrossing;
}

bool exact_crossing_fails(ExactCrossing crossing)
{
    bool local_13 = (bool)0;
    bool local_14 = (bool)0;

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

bool exact_crossing_passes_by(ExactCrossing entry, ExactCrossing leaving)
{
    bool local_15 = (bool)0;
    bool local_16 = (bool)0;
    bool local_17 = (bool)0;
    bool local_18 = (bool)0;

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

Decision exact_cap_filtered(CylinderRecord cylinder_12, Ray ray_11, float3 center_3, uint part_3)
{
    bool local_19 = (bool)0;
    bool local_20 = (bool)0;
    bool local_21 = (bool)0;
    bool local_22 = (bool)0;
    bool local_23 = (bool)0;
    bool local_24 = (bool)0;
    bool local_25 = (bool)0;

    float3 to_center = (center_3 - ray_11.origin);
    const float _e7 = vec3_dot(to_center, cylinder_12.axis);
    const float _e10 = vec3_dot(ray_11.direction, cylinder_12.axis);
    float steepness = abs(_e10);
    const float _e13 = exact_magnitude(ray_11.direction);
    float slope_error = (_e13 * 8.881784e-16);
    if (((steepness + slope_error) < 1e-8)) {
        const Decision _e19 = decision_miss();
        const Decision decision_3 = _e19;
        return decision_3;
    }
    bool steep = ((1e-8 + slope_error) < steepness);
    float distance_1 = ((_e10 < 0.0) ? -(_e7) : _e7);
    const float _e27 = exact_cylinder_extent(cylinder_12);
    const float _e28 = exact_magnitude(to_center);
    float size_1 = (_e27 + _e28);
    float distance_error = (size_1 * 1.7763568e-15);
    if (steep) {
        local_19 = ((distance_1 + distance_error) < ((steepness - slope_error) * 0.001));
    } else {
        local_19 = false;
    }
    bool _e40 = local_19;
    if (_e40) {
        const Decision _e41 = decision_miss();
        const Decision decision_4 = _e41;
        return decision_4;
    }
    float lambda_13 = (_e7 / _e10);
    if ((size_1 < (distance_1 * 262144.0))) {
        local_20 = (_e13 < (steepness * 524288.0));
    } else {
        local_20 = false;
    }
    bool accurate_2 = local_20;
    if (accurate_2) {
        const Limits _e55 = exact_cylinder_limits();
        local_21 = (_e55.most <= lambda_13);
    } else {
        local_21 = false;
    }
    bool is_in_range = local_21;
    const float3 _e60 = ray_at(ray_11, lambda_13);
    const float _e62 = vec3_length((_e60 - center_3));
    const float _e63 = exact_cylinder_margin(cylinder_12, ray_11, lambda_13);
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
        const Decision _e75 = decision_hit(lambda_13, part_3);
        const Decision decision_5 = _e75;
        return decision_5;
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
        const Decision _e87 = decision_miss();
        const Decision decision_6 = _e87;
        return decision_6;
    }
    const Decision _e88 = decision_uncertain();
    const Decision decision_7 = _e88;
    return decision_7;
}

Decision exact_cylinder_filtered(CylinderRecord cylinder_13, Ray ray_12)
{
    bool local_26 = (bool)0;
    bool local_27 = (bool)0;
    bool local_28 = (bool)0;
    bool local_29 = (bool)0;

    const ExactSide _e2 = exact_side_new(cylinder_13, ray_12);
    const bool _e4 = exact_in_scale(_e2.length_squared);
    if (!(_e4)) {
        const Decision _e6 = decision_uncertain();
        const Decision decision_8 = _e6;
        return decision_8;
    }
    const bool _e9 = error_bound_misses(_e2.bound, _e2.discriminant);
    if (_e9) {
        const Decision _e10 = decision_miss();
        const Decision decision_9 = _e10;
        return decision_9;
    }
    float root_9 = sqrt(_e2.discriminant);
    const ExactCrossing _e16 = exact_side_crossing(_e2, cylinder_13, ray_12, (-(_e2.h) - root_9), root_9);
    const ExactCrossing _e20 = exact_side_crossing(_e2, cylinder_13, ray_12, (-(_e2.h) + root_9), root_9);
    if (_e16.behind) {
        local_26 = _e20.straight;
    } else {
        local_26 = false;
    }
    bool _e26 = local_26;
    if (_e26) {
        const Decision _e29 = decision_hit(_e20.lambda, SIDE);
        const Decision decision_10 = _e29;
        return decision_10;
    }
    if (_e16.hits) {
        const Decision _e33 = decision_hit(_e16.lambda, SIDE);
        const Decision decision_11 = _e33;
        return decision_11;
    }
    const bool _e34 = exact_crossing_fails(_e16);
    if (_e34) {
        if (!(_e20.hits)) {
            const bool _e41 = exact_crossing_fails(_e20);
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
        const Decision _e47 = decision_uncertain();
        const Decision decision_12 = _e47;
        return decision_12;
    }
    const bool _e48 = exact_crossing_passes_by(_e16, _e20);
    if (_e48) {
        const Decision _e49 = decision_miss();
        const Decision decision_13 = _e49;
        return decision_13;
    }
    bool down = (_e2.slope < 0.0);
    float half_1 = (down ? -(cylinder_13.half_height) : cylinder_13.half_height);
    float3 along_3 = (cylinder_13.axis * half_1);
    const Decision _e64 = exact_cap_filtered(cylinder_13, ray_12, (cylinder_13.center_ - along_3), (down ? TOP : BOTTOM));
    if (!(!(_e64.certain))) {
        local_29 = _e64.some;
    } else {
        local_29 = true;
    }
    bool _e72 = local_29;
    if (_e72) {
        const Decision decision_14 = _e64;
        return decision_14;
    }
    if (_e20.hits) {
        const Decision _e76 = decision_hit(_e20.lambda, SIDE);
        const Decision decision_15 = _e76;
        return decision_15;
    }
    const Decision _e82 = exact_cap_filtered(cylinder_13, ray_12, (cylinder_13.center_ + along_3), (down ? BOTTOM : TOP));
    const Decision decision_16 = _e82;
    return decision_16;
}

DoubleDouble ConstructDoubleDouble(float arg0, float arg1) {
    DoubleDouble ret = (DoubleDouble)0;
    ret.high = arg0;
    ret.low = arg1;
    return ret;
}

DoubleDouble dd_of(float high)
{
    const DoubleDouble doubledouble = ConstructDoubleDouble(high, 0.0);
    return doubledouble;
}

DoubleDouble dd_constant(float high_1)
{
    float _e2 = exact_one;
    const DoubleDouble _e4 = dd_of((high_1 * _e2));
    const DoubleDouble doubledouble_1 = _e4;
    return doubledouble_1;
}

DoubleDouble dd_fast_two_sum(float a_7, float b_4)
{
    float _e3 = exact_one;
    float high_3 = ((a_7 * _e3) + b_4);
    const DoubleDouble doubledouble_2 = ConstructDoubleDouble(high_3, (b_4 - (high_3 - a_7)));
    return doubledouble_2;
}

DoubleDouble dd_add(DoubleDouble a_8, DoubleDouble b_5)
{
    float _e5 = exact_one;
    const ExactSum _e6 = exact_two_sum(a_8.high, b_5.high, _e5);
    float _e10 = exact_one;
    const ExactSum _e11 = exact_two_sum(a_8.low, b_5.low, _e10);
    const DoubleDouble _e16 = dd_fast_two_sum(_e6.sum, (_e6.error + _e11.sum));
    const DoubleDouble _e21 = dd_fast_two_sum(_e16.high, (_e16.low + _e11.error));
    const DoubleDouble doubledouble_3 = _e21;
    return doubledouble_3;
}

DoubleDouble dd_neg(DoubleDouble a_9)
{
    const DoubleDouble doubledouble_4 = ConstructDoubleDouble(-(a_9.high), -(a_9.low));
    return doubledouble_4;
}

DoubleDouble dd_sub(DoubleDouble a_10, DoubleDouble b_6)
{
    const DoubleDouble _e2 = dd_neg(b_6);
    const DoubleDouble _e3 = dd_add(a_10, _e2);
    const DoubleDouble doubledouble_5 = _e3;
    return doubledouble_5;
}

DoubleDouble dd_mul(DoubleDouble a_11, DoubleDouble b_7)
{
    const ExactSum _e4 = exact_two_product(a_11.high, b_7.high);
    const float _e12 = exact_mul_add(a_11.high, b_7.low, (a_11.low * b_7.low));
    const float _e13 = exact_mul_add(a_11.low, b_7.high, _e12);
    const DoubleDouble _e17 = dd_fast_two_sum(_e4.sum, (_e4.error + _e13));
    const DoubleDouble doubledouble_6 = _e17;
    return doubledouble_6;
}

DoubleDouble dd_div(DoubleDouble a_12, DoubleDouble b_8)
{
    float high_4 = (a_12.high / b_8.high);
    const ExactSum _e6 = exact_two_product(b_8.high, high_4);
    const float _e10 = exact_mul_add(b_8.low, high_4, _e6.error);
    const DoubleDouble _e11 = dd_fast_two_sum(_e6.sum, _e10);
    float remainder = ((a_12.high - _e11.high) + (a_12.low - _e11.low));
    const DoubleDouble _e21 = dd_fast_two_sum(high_4, (remainder / b_8.high));
    const DoubleDouble doubledouble_7 = _e21;
    return doubledouble_7;
}

DoubleDouble dd_sqrt(DoubleDouble a_13)
{
    if ((a_13.high == 0.0)) {
        const DoubleDouble doubledouble_8 = a_13;
        return doubledouble_8;
    }
    float _e7 = exact_one;
    float high_5 = (sqrt(a_13.high) * _e7);
    const float _e11 = exact_mul_add(-(high_5), high_5, a_13.high);
    float remainder_1 = (_e11 + a_13.low);
    const DoubleDouble _e16 = dd_fast_two_sum(high_5, (remainder_1 / (high_5 + high_5)));
    const DoubleDouble doubledouble_9 = _e16;
    return doubledouble_9;
}

DoubleDouble dd_abs(DoubleDouble a_14)
{
    if ((a_14.high < 0.0)) {
        const DoubleDouble _e4 = dd_neg(a_14);
        const DoubleDouble doubledouble_10 = _e4;
        return doubledouble_10;
    }
    const DoubleDouble doubledouble_11 = a_14;
    return doubledouble_11;
}

bool dd_less(DoubleDouble a_15, DoubleDouble b_9)
{
    bool local_30 = (bool)0;
    bool local_31 = (bool)0;

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

bool dd_less_equal(DoubleDouble a_16, DoubleDouble b_10)
{
    bool local_32 = (bool)0;
    bool local_33 = (bool)0;

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

DoubleDouble3_ ConstructDoubleDouble3_(DoubleDouble arg0, DoubleDouble arg1, DoubleDouble arg2) {
    DoubleDouble3_ ret = (DoubleDouble3_)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

DoubleDouble3_ dd3_of(float3 v_8)
{
    const DoubleDouble _e2 = dd_of(v_8.x);
    const DoubleDouble _e4 = dd_of(v_8.y);
    const DoubleDouble _e6 = dd_of(v_8.z);
    const DoubleDouble3_ doubledouble3_ = ConstructDoubleDouble3_(_e2, _e4, _e6);
    return doubledouble3_;
}

DoubleDouble3_ dd3_add(DoubleDouble3_ a_17, DoubleDouble3_ b_11)
{
    const DoubleDouble _e4 = dd_add(a_17.x, b_11.x);
    const DoubleDouble _e7 = dd_add(a_17.y, b_11.y);
    const DoubleDouble _e10 = dd_add(a_17.z, b_11.z);
    const DoubleDouble3_ doubledouble3_1 = ConstructDoubleDouble3_(_e4, _e7, _e10);
    return doubledouble3_1;
}

DoubleDouble3_ dd3_sub(DoubleDouble3_ a_18, DoubleDouble3_ b_12)
{
    const DoubleDouble _e4 = dd_sub(a_18.x, b_12.x);
    const DoubleDouble _e7 = dd_sub(a_18.y, b_12.y);
    const DoubleDouble _e10 = dd_sub(a_18.z, b_12.z);
    const DoubleDouble3_ doubledouble3_2 = ConstructDoubleDouble3_(_e4, _e7, _e10);
    return doubledouble3_2;
}

DoubleDouble3_ dd3_scaled(DoubleDouble3_ v_9, DoubleDouble factor)
{
    const DoubleDouble _e3 = dd_mul(v_9.x, factor);
    const DoubleDouble _e5 = dd_mul(v_9.y, factor);
    const DoubleDouble _e7 = dd_mul(v_9.z, factor);
    const DoubleDouble3_ doubledouble3_3 = ConstructDoubleDouble3_(_e3, _e5, _e7);
    return doubledouble3_3;
}

DoubleDouble3_ dd3_divided(DoubleDouble3_ v_10, DoubleDouble divisor)
{
    const DoubleDouble _e3 = dd_div(v_10.x, divisor);
    const DoubleDouble _e5 = dd_div(v_10.y, divisor);
    const DoubleDouble _e7 = dd_div(v_10.z, divisor);
    const DoubleDouble3_ doubledouble3_4 = ConstructDoubleDouble3_(_e3, _e5, _e7);
    return doubledouble3_4;
}

DoubleDouble dd3_dot(DoubleDouble3_ a_19, DoubleDouble3_ b_13)
{
    const DoubleDouble _e4 = dd_mul(a_19.x, b_13.x);
    const DoubleDouble _e7 = dd_mul(a_19.y, b_13.y);
    const DoubleDouble _e8 = dd_add(_e4, _e7);
    const DoubleDouble _e11 = dd_mul(a_19.z, b_13.z);
    const DoubleDouble _e12 = dd_add(_e8, _e11);
    const DoubleDouble doubledouble_12 = _e12;
    return doubledouble_12;
}

DoubleDouble dd3_magnitude(DoubleDouble3_ v_11)
{
    const DoubleDouble _e2 = dd_abs(v_11.x);
    const DoubleDouble _e4 = dd_abs(v_11.y);
    const DoubleDouble _e5 = dd_add(_e2, _e4);
    const DoubleDouble _e7 = dd_abs(v_11.z);
    const DoubleDouble _e8 = dd_add(_e5, _e7);
    const DoubleDouble doubledouble_13 = _e8;
    return doubledouble_13;
}

DoubleDouble3_ dd3_perpendicular_to(DoubleDouble3_ v_12, DoubleDouble3_ axis_3)
{
    const DoubleDouble _e2 = dd3_dot(v_12, axis_3);
    const DoubleDouble3_ _e3 = dd3_scaled(axis_3, _e2);
    const DoubleDouble3_ _e4 = dd3_sub(v_12, _e3);
    const DoubleDouble3_ doubledouble3_5 = _e4;
    return doubledouble3_5;
}

PreciseDecision ConstructPreciseDecision(bool arg0, bool arg1, DoubleDouble arg2, uint arg3) {
    PreciseDecision ret = (PreciseDecision)0;
    ret.certain = arg0;
    ret.some = arg1;
    ret.lambda = arg2;
    ret.part = arg3;
    return ret;
}

PreciseDecision precise_uncertain()
{
    const DoubleDouble _e3 = dd_constant(0.0);
    const PreciseDecision precisedecision = ConstructPreciseDecision(false, false, _e3, SIDE);
    return precisedecision;
}

PreciseDecision precise_miss()
{
    const DoubleDouble _e3 = dd_constant(0.0);
    const PreciseDecision precisedecision_1 = ConstructPreciseDecision(true, false, _e3, SIDE);
    return precisedecision_1;
}

PreciseDecision precise_hit(DoubleDouble lambda_7, uint part_4)
{
    const PreciseDecision precisedecision_2 = ConstructPreciseDecision(true, true, lambda_7, part_4);
    return precisedecision_2;
}

PreciseBound ConstructPreciseBound(PreciseLimits arg0, DoubleDouble arg1, DoubleDouble arg2) {
    PreciseBound ret = (PreciseBound)0;
    ret.limits = arg0;
    ret.size = arg1;
    ret.error = arg2;
    return ret;
}

PreciseBound precise_bound_new(PreciseLimits limits_1, DoubleDouble length_squared_2, DoubleDouble squares_1)
{
    const DoubleDouble _e3 = dd_mul(length_squared_2, squares_1);
    const DoubleDouble _e5 = dd_constant(limits_1.error);
    const DoubleDouble _e6 = dd_mul(_e3, _e5);
    const DoubleDouble _e8 = dd_constant(ERROR_UNDERFLOW);
    const DoubleDouble _e9 = dd_add(_e6, _e8);
    const PreciseBound precisebound = ConstructPreciseBound(limits_1, _e3, _e9);
    return precisebound;
}

bool precise_bound_misses(PreciseBound bound_3, DoubleDouble discriminant_1)
{
    const DoubleDouble _e3 = dd_neg(discriminant_1);
    const bool _e4 = dd_less(bound_3.error, _e3);
    return _e4;
}

bool precise_in_scale(DoubleDouble length_squared_3)
{
    bool local_34 = (bool)0;

    const DoubleDouble _e2 = dd_constant(SHORTEST_SQUARED);
    const bool _e3 = dd_less_equal(_e2, length_squared_3);
    if (_e3) {
        const DoubleDouble _e7 = dd_constant(LONGEST_SQUARED);
        const bool _e8 = dd_less_equal(length_squared_3, _e7);
        local_34 = _e8;
    } else {
        local_34 = false;
    }
    bool _e10 = local_34;
    return _e10;
}

DoubleDouble precise_least_lambda()
{
    float _e2 = exact_one;
    float _e6 = exact_one;
    const DoubleDouble doubledouble_14 = ConstructDoubleDouble((0.001 * _e2), (-1.0842022e-19 * _e6));
    return doubledouble_14;
}

bool precise_in_range(PreciseLimits limits_2, DoubleDouble lambda_8)
{
    const DoubleDouble _e2 = precise_least_lambda();
    const DoubleDouble _e4 = dd_constant(limits_2.lambda_error);
    const DoubleDouble _e5 = dd_add(_e2, _e4);
    const bool _e6 = dd_less_equal(_e5, lambda_8);
    return _e6;
}

bool precise_bound_is_too_small(PreciseBound bound_4, DoubleDouble a_20, DoubleDouble numerator_3, DoubleDouble root_3)
{
    const DoubleDouble _e4 = precise_least_lambda();
    const DoubleDouble _e7 = dd_constant(bound_4.limits.lambda_error);
    const DoubleDouble _e8 = dd_sub(_e4, _e7);
    const DoubleDouble _e10 = dd_mul(a_20, _e8);
    const DoubleDouble _e11 = dd_sub(_e10, numerator_3);
    const DoubleDouble _e12 = dd_mul(_e11, root_3);
    const bool _e13 = dd_less(bound_4.error, _e12);
    return _e13;
}

PreciseOutcome ConstructPreciseOutcome(DoubleDouble arg0, bool arg1, bool arg2) {
    PreciseOutcome ret = (PreciseOutcome)0;
    ret.lambda = arg0;
    ret.hits = arg1;
    ret.fails = arg2;
    return ret;
}

PreciseOutcome precise_bound_root(PreciseBound bound_5, DoubleDouble a_21, DoubleDouble numerator_4, DoubleDouble root_4)
{
    bool local_35 = (bool)0;
    bool local_36 = (bool)0;

    const DoubleDouble _e4 = dd_div(numerator_4, a_21);
    float share_1 = bound_5.limits.share;
    const DoubleDouble _e8 = dd_constant(share_1);
    const DoubleDouble _e9 = dd_mul(bound_5.size, _e8);
    const DoubleDouble _e11 = dd_constant(ERROR_UNDERFLOW);
    const DoubleDouble _e12 = dd_add(_e9, _e11);
    const DoubleDouble _e13 = dd_mul(numerator_4, numerator_4);
    const DoubleDouble _e16 = dd_constant((share_1 * 4.0));
    const DoubleDouble _e17 = dd_mul(_e13, _e16);
    const DoubleDouble _e18 = dd_add(_e12, _e17);
    const DoubleDouble _e19 = dd_mul(root_4, numerator_4);
    const bool _e20 = dd_less(_e18, _e19);
    const DoubleDouble _e23 = dd_constant(ERROR_OVERFLOW);
    const bool _e24 = dd_less(bound_5.size, _e23);
    if (_e20) {
        local_35 = _e24;
    } else {
        local_35 = false;
    }
    bool _e28 = local_35;
    if (_e28) {
        const bool _e32 = precise_in_range(bound_5.limits, _e4);
        local_36 = _e32;
    } else {
        local_36 = false;
    }
    bool hits_2 = local_36;
    const bool _e35 = precise_bound_is_too_small(bound_5, a_21, numerator_4, root_4);
    const PreciseOutcome preciseoutcome = ConstructPreciseOutcome(_e4, hits_2, _e35);
    return preciseoutcome;
}

PreciseCylinder ConstructPreciseCylinder(DoubleDouble3_ arg0, DoubleDouble3_ arg1, DoubleDouble arg2, DoubleDouble arg3, DoubleDouble arg4) {
    PreciseCylinder ret = (PreciseCylinder)0;
    ret.center_ = arg0;
    ret.axis = arg1;
    ret.radius = arg2;
    ret.radius_squared = arg3;
    ret.half_height = arg4;
    return ret;
}

PreciseCylinder precise_cylinder_new(float3 center_4, float radius_2, float3 axis_4)
{
    const DoubleDouble3_ _e3 = dd3_of(axis_4);
    const DoubleDouble _e4 = dd3_dot(_e3, _e3);
    const DoubleDouble _e6 = dd_constant(SHORT_SQUARED);
    const bool _e7 = dd_less(_e4, _e6);
    const DoubleDouble _e11 = dd_constant((_e7 ? SHORT_SCALE : 1.0));
    const DoubleDouble3_ _e12 = dd3_scaled(_e3, _e11);
    const DoubleDouble _e13 = dd3_dot(_e12, _e12);
    const DoubleDouble _e14 = dd_sqrt(_e13);
    const DoubleDouble _e18 = dd_constant((_e7 ? SHORT_SQUARED : 1.0));
    const DoubleDouble _e19 = dd_mul(_e14, _e18);
    const DoubleDouble _e20 = dd_of(radius_2);
    const DoubleDouble _e22 = dd_constant(2.0);
    const DoubleDouble _e23 = dd_div(_e19, _e22);
    const DoubleDouble3_ _e24 = dd3_of(center_4);
    const DoubleDouble3_ _e25 = dd3_divided(_e12, _e14);
    const DoubleDouble _e26 = dd_mul(_e20, _e20);
    const PreciseCylinder precisecylinder = ConstructPreciseCylinder(_e24, _e25, _e20, _e26, _e23);
    return precisecylinder;
}

PreciseLimits ConstructPreciseLimits(float arg0, float arg1, float arg2) {
    PreciseLimits ret = (PreciseLimits)0;
    ret.error = arg0;
    ret.share = arg1;
    ret.lambda_error = arg2;
    return ret;
}

PreciseLimits precise_cylinder_limits()
{
    const PreciseLimits preciselimits = ConstructPreciseLimits(3.7865323e-29, 9.094947e-13, 5.5511154e-20);
    return preciselimits;
}

DoubleDouble precise_cylinder_extent(PreciseCylinder cylinder_14)
{
    const DoubleDouble _e2 = dd3_magnitude(cylinder_14.center_);
    const DoubleDouble _e4 = dd_add(_e2, cylinder_14.radius);
    const DoubleDouble _e6 = dd_add(_e4, cylinder_14.half_height);
    const DoubleDouble _e8 = dd_constant(EXTENT_UNDERFLOW);
    const DoubleDouble _e9 = dd_add(_e6, _e8);
    const DoubleDouble doubledouble_15 = _e9;
    return doubledouble_15;
}

DoubleDouble precise_cylinder_margin(PreciseCylinder cylinder_15, DoubleDouble3_ direction_1, DoubleDouble lambda_9)
{
    const DoubleDouble _e3 = dd3_magnitude(direction_1);
    const DoubleDouble _e4 = dd_mul(lambda_9, _e3);
    const DoubleDouble _e6 = dd_constant(1.110223e-16);
    const DoubleDouble _e7 = dd_mul(_e4, _e6);
    const DoubleDouble _e8 = precise_cylinder_extent(cylinder_15);
    const DoubleDouble _e10 = dd_constant(1.2621775e-29);
    const DoubleDouble _e11 = dd_mul(_e8, _e10);
    const DoubleDouble _e12 = dd_add(_e7, _e11);
    const DoubleDouble doubledouble_16 = _e12;
    return doubledouble_16;
}

PreciseSide ConstructPreciseSide(PreciseBound arg0, DoubleDouble arg1, DoubleDouble arg2, DoubleDouble arg3, DoubleDouble arg4, DoubleDouble arg5, DoubleDouble arg6) {
    PreciseSide ret = (PreciseSide)0;
    ret.bound = arg0;
    ret.length_squared = arg1;
    ret.a = arg2;
    ret.h = arg3;
    ret.discriminant = arg4;
    ret.along = arg5;
    ret.slope = arg6;
    return ret;
}

PreciseSide precise_side_new(PreciseCylinder cylinder_16, DoubleDouble3_ origin_1, DoubleDouble3_ direction_2)
{
    const DoubleDouble3_ _e4 = dd3_sub(origin_1, cylinder_16.center_);
    const DoubleDouble3_ _e6 = dd3_perpendicular_to(_e4, cylinder_16.axis);
    const DoubleDouble _e7 = dd3_dot(_e6, _e6);
    const DoubleDouble _e9 = dd_sub(_e7, cylinder_16.radius_squared);
    const DoubleDouble3_ _e11 = dd3_perpendicular_to(direction_2, cylinder_16.axis);
    const DoubleDouble _e12 = dd3_dot(_e11, _e11);
    const DoubleDouble _e13 = dd3_dot(_e6, _e11);
    const DoubleDouble _e14 = dd_mul(_e13, _e13);
    const DoubleDouble _e15 = dd_mul(_e12, _e9);
    const DoubleDouble _e16 = dd_sub(_e14, _e15);
    const DoubleDouble _e17 = dd3_dot(direction_2, direction_2);
    const DoubleDouble _e18 = dd3_dot(_e4, _e4);
    const DoubleDouble _e20 = dd_add(_e18, cylinder_16.radius_squared);
    const PreciseLimits _e21 = precise_cylinder_limits();
    const PreciseBound _e22 = precise_bound_new(_e21, _e17, _e20);
    const DoubleDouble _e24 = dd3_dot(_e4, cylinder_16.axis);
    const DoubleDouble _e26 = dd3_dot(direction_2, cylinder_16.axis);
    const PreciseSide preciseside = ConstructPreciseSide(_e22, _e17, _e12, _e13, _e16, _e24, _e26);
    return preciseside;
}

PreciseCrossing ConstructPreciseCrossing(DoubleDouble arg0, bool arg1, bool arg2, bool arg3, bool arg4, bool arg5) {
    PreciseCrossing ret = (PreciseCrossing)0;
    ret.lambda = arg0;
    ret.hits = arg1;
    ret.straight = arg2;
    ret.behind = arg3;
    ret.above = arg4;
    ret.below = arg5;
    return ret;
}

PreciseCrossing precise_side_crossing(PreciseSide side_2, PreciseCylinder cylinder_17, DoubleDouble3_ direction_3, DoubleDouble numerator_5, DoubleDouble root_5)
{
    bool local_37 = (bool)0;
    bool local_38 = (bool)0;
    bool local_39 = (bool)0;
    bool local_40 = (bool)0;
    bool local_41 = (bool)0;
    bool local_42 = (bool)0;

    const DoubleDouble _e8 = dd_constant(7.7371252e25);
    const DoubleDouble _e9 = dd_mul(side_2.a, _e8);
    const bool _e10 = dd_less_equal(side_2.length_squared, _e9);
    const PreciseOutcome _e13 = precise_bound_root(side_2.bound, side_2.a, numerator_5, root_5);
    const DoubleDouble _e17 = dd_mul(_e13.lambda, side_2.slope);
    const DoubleDouble _e18 = dd_add(side_2.along, _e17);
    const DoubleDouble _e20 = precise_cylinder_margin(cylinder_17, direction_3, _e13.lambda);
    if (_e10) {
        local_37 = _e13.hits;
    } else {
        local_37 = false;
    }
    bool accurate_3 = local_37;
    const DoubleDouble _e27 = dd_sub(cylinder_17.half_height, _e20);
    const DoubleDouble _e29 = dd_add(cylinder_17.half_height, _e20);
    if (accurate_3) {
        const DoubleDouble _e32 = dd_abs(_e18);
        const bool _e33 = dd_less(_e32, _e27);
        local_38 = _e33;
    } else {
        local_38 = false;
    }
    bool hits_3 = local_38;
    if (hits_3) {
        const DoubleDouble _e40 = dd_abs(side_2.along);
        const bool _e41 = dd_less(_e40, _e27);
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
        const bool _e51 = dd_less(_e29, _e18);
        local_41 = _e51;
    } else {
        local_41 = false;
    }
    bool _e53 = local_41;
    if (accurate_3) {
        const DoubleDouble _e56 = dd_neg(_e18);
        const bool _e57 = dd_less(_e29, _e56);
        local_42 = _e57;
    } else {
        local_42 = false;
    }
    bool _e59 = local_42;
    const PreciseCrossing precisecrossing = ConstructPreciseCrossing(_e13.lambda, hits_3, _e43, _e48, _e53, _e59);
    return precisecrossing;
}

bool precise_crossing_fails(PreciseCrossing crossing_1)
{
    bool local_43 = (bool)0;
    bool local_44 = (bool)0;

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

bool precise_crossing_passes_by(PreciseCrossing entry_1, PreciseCrossing leaving_1)
{
    bool local_45 = (bool)0;
    bool local_46 = (bool)0;
    bool local_47 = (bool)0;
    bool local_48 = (bool)0;

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

PreciseDecision precise_cap_filtered(PreciseCylinder cylinder_18, DoubleDouble3_ origin_2, DoubleDouble3_ direction_4, DoubleDouble3_ center_5, uint part_5)
{
    DoubleDouble distance_ = (DoubleDouble)0;
    bool local_49 = (bool)0;
    bool local_50 = (bool)0;
    bool local_51 = (bool)0;
    bool local_52 = (bool)0;
    bool local_53 = (bool)0;
    bool local_54 = (bool)0;
    bool local_55 = (bool)0;

    const DoubleDouble _e6 = dd_constant(1e-8);
    const DoubleDouble3_ _e7 = dd3_sub(center_5, origin_2);
    const DoubleDouble _e9 = dd3_dot(_e7, cylinder_18.axis);
    const DoubleDouble _e11 = dd3_dot(direction_4, cylinder_18.axis);
    const DoubleDouble _e12 = dd_abs(_e11);
    const DoubleDouble _e13 = dd3_magnitude(direction_4);
    const DoubleDouble _e15 = dd_constant(1.5777218e-30);
    const DoubleDouble _e16 = dd_mul(_e13, _e15);
    const DoubleDouble _e17 = dd_add(_e12, _e16);
    const bool _e18 = dd_less(_e17, _e6);
    if (_e18) {
        const PreciseDecision _e19 = precise_miss();
        const PreciseDecision precisedecision_3 = _e19;
        return precisedecision_3;
    }
    const DoubleDouble _e20 = dd_add(_e6, _e16);
    const bool _e21 = dd_less(_e20, _e12);
    distance_ = _e9;
    const DoubleDouble _e24 = dd_constant(0.0);
    const bool _e25 = dd_less(_e11, _e24);
    if (_e25) {
        const DoubleDouble _e26 = dd_neg(_e9);
        distance_ = _e26;
    }
    const DoubleDouble _e27 = precise_cylinder_extent(cylinder_18);
    const DoubleDouble _e28 = dd3_magnitude(_e7);
    const DoubleDouble _e29 = dd_add(_e27, _e28);
    DoubleDouble _e30 = distance_;
    const DoubleDouble _e32 = dd_constant(3.1554436e-30);
    const DoubleDouble _e33 = dd_mul(_e29, _e32);
    const DoubleDouble _e34 = dd_add(_e30, _e33);
    if (_e21) {
        const DoubleDouble _e37 = dd_sub(_e12, _e16);
        const DoubleDouble _e38 = precise_least_lambda();
        const DoubleDouble _e39 = dd_mul(_e37, _e38);
        const bool _e40 = dd_less(_e34, _e39);
        local_49 = _e40;
    } else {
        local_49 = false;
    }
    bool _e42 = local_49;
    if (_e42) {
        const PreciseDecision _e43 = precise_miss();
        const PreciseDecision precisedecision_4 = _e43;
        return precisedecision_4;
    }
    const DoubleDouble _e44 = dd_div(_e9, _e11);
    DoubleDouble _e45 = distance_;
    const DoubleDouble _e47 = dd_constant(4398046500000.0);
    const DoubleDouble _e48 = dd_mul(_e45, _e47);
    const bool _e49 = dd_less(_e29, _e48);
    if (_e49) {
        const DoubleDouble _e53 = dd_constant(8796093000000.0);
        const DoubleDouble _e54 = dd_mul(_e12, _e53);
        const bool _e55 = dd_less(_e13, _e54);
        local_50 = _e55;
    } else {
        local_50 = false;
    }
    bool accurate_4 = local_50;
    if (accurate_4) {
        const PreciseLimits _e60 = precise_cylinder_limits();
        const bool _e61 = precise_in_range(_e60, _e44);
        local_51 = _e61;
    } else {
        local_51 = false;
    }
    bool is_in_range_1 = local_51;
    const DoubleDouble3_ _e64 = dd3_scaled(direction_4, _e44);
    const DoubleDouble3_ _e65 = dd3_add(origin_2, _e64);
    const DoubleDouble3_ _e66 = dd3_sub(_e65, center_5);
    const DoubleDouble _e67 = dd3_dot(_e66, _e66);
    const DoubleDouble _e68 = dd_sqrt(_e67);
    const DoubleDouble _e69 = precise_cylinder_margin(cylinder_18, direction_4, _e44);
    if (_e21) {
        local_52 = is_in_range_1;
    } else {
        local_52 = false;
    }
    bool _e73 = local_52;
    if (_e73) {
        const DoubleDouble _e77 = dd_sub(cylinder_18.radius, _e69);
        const bool _e78 = dd_less(_e68, _e77);
        local_53 = _e78;
    } else {
        local_53 = false;
    }
    bool _e80 = local_53;
    if (_e80) {
        const PreciseDecision _e81 = precise_hit(_e44, part_5);
        const PreciseDecision precisedecision_5 = _e81;
        return precisedecision_5;
    }
    if (_e21) {
        local_54 = is_in_range_1;
    } else {
        local_54 = false;
    }
    bool _e85 = local_54;
    if (_e85) {
        const DoubleDouble _e89 = dd_add(cylinder_18.radius, _e69);
        const bool _e90 = dd_less(_e89, _e68);
        local_55 = _e90;
    } else {
        local_55 = false;
    }
    bool _e92 = local_55;
    if (_e92) {
        const PreciseDecision _e93 = precise_miss();
        const PreciseDecision precisedecision_6 = _e93;
        return precisedecision_6;
    }
    const PreciseDecision _e94 = precise_uncertain();
    const PreciseDecision precisedecision_7 = _e94;
    return precisedecision_7;
}

PreciseDecision precise_cylinder_filtered(float3 center_6, float radius_3, float3 axis_5, Ray ray_13)
{
    bool local_56 = (bool)0;
    bool local_57 = (bool)0;
    bool local_58 = (bool)0;
    DoubleDouble half_ = (DoubleDouble)0;
    bool local_59 = (bool)0;

    const PreciseCylinder _e4 = precise_cylinder_new(center_6, radius_3, axis_5);
    const DoubleDouble3_ _e6 = dd3_of(ray_13.origin);
    const DoubleDouble3_ _e8 = dd3_of(ray_13.direction);
    const PreciseSide _e9 = precise_side_new(_e4, _e6, _e8);
    const bool _e11 = precise_in_scale(_e9.length_squared);
    if (!(_e11)) {
        const PreciseDecision _e13 = precise_uncertain();
        const PreciseDecision precisedecision_8 = _e13;
        return precisedecision_8;
    }
    const bool _e16 = precise_bound_misses(_e9.bound, _e9.discriminant);
    if (_e16) {
        const PreciseDecision _e17 = precise_miss();
        const PreciseDecision precisedecision_9 = _e17;
        return precisedecision_9;
    }
    const DoubleDouble _e19 = dd_sqrt(_e9.discriminant);
    const DoubleDouble _e21 = dd_neg(_e9.h);
    const DoubleDouble _e22 = dd_sub(_e21, _e19);
    const PreciseCrossing _e23 = precise_side_crossing(_e9, _e4, _e8, _e22, _e19);
    const DoubleDouble _e25 = dd_neg(_e9.h);
    const DoubleDouble _e26 = dd_add(_e25, _e19);
    const PreciseCrossing _e27 = precise_side_crossing(_e9, _e4, _e8, _e26, _e19);
    if (_e23.behind) {
        local_56 = _e27.straight;
    } else {
        local_56 = false;
    }
    bool _e33 = local_56;
    if (_e33) {
        const PreciseDecision _e36 = precise_hit(_e27.lambda, SIDE);
        const PreciseDecision precisedecision_10 = _e36;
        return precisedecision_10;
    }
    if (_e23.hits) {
        const PreciseDecision _e40 = precise_hit(_e23.lambda, SIDE);
        const PreciseDecision precisedecision_11 = _e40;
        return precisedecision_11;
    }
    const bool _e41 = precise_crossing_fails(_e23);
    if (_e41) {
        if (!(_e27.hits)) {
            const bool _e48 = precise_crossing_fails(_e27);
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
        const PreciseDecision _e54 = precise_uncertain();
        const PreciseDecision precisedecision_12 = _e54;
        return precisedecision_12;
    }
    const bool _e55 = precise_crossing_passes_by(_e23, _e27);
    if (_e55) {
        const PreciseDecision _e56 = precise_miss();
        const PreciseDecision precisedecision_13 = _e56;
        return precisedecision_13;
    }
    const DoubleDouble _e59 = dd_constant(0.0);
    const bool _e60 = dd_less(_e9.slope, _e59);
    half_ = _e4.half_height;
    if (_e60) {
        DoubleDouble _e63 = half_;
        const DoubleDouble _e64 = dd_neg(_e63);
        half_ = _e64;
    }
    DoubleDouble _e66 = half_;
    const DoubleDouble3_ _e67 = dd3_scaled(_e4.axis, _e66);
    const DoubleDouble3_ _e69 = dd3_sub(_e4.center_, _e67);
    const PreciseDecision _e73 = precise_cap_filtered(_e4, _e6, _e8, _e69, (_e60 ? TOP : BOTTOM));
    if (!(!(_e73.certain))) {
        local_59 = _e73.some;
    } else {
        local_59 = true;
    }
    bool _e81 = local_59;
    if (_e81) {
        const PreciseDecision precisedecision_14 = _e73;
        return precisedecision_14;
    }
    if (_e27.hits) {
        const PreciseDecision _e85 = precise_hit(_e27.lambda, SIDE);
        const PreciseDecision precisedecision_15 = _e85;
        return precisedecision_15;
    }
    const DoubleDouble3_ _e87 = dd3_add(_e4.center_, _e67);
    const PreciseDecision _e91 = precise_cap_filtered(_e4, _e6, _e8, _e87, (_e60 ? BOTTOM : TOP));
    const PreciseDecision precisedecision_16 = _e91;
    return precisedecision_16;
}

float exact_code(bool certain, bool some, uint part_6)
{
    if (!(certain)) {
        return 0.0;
    }
    return (some ? float((2u + part_6)) : 1.0);
}

ExactReport exact_report(Decision plain, Decision compensated, PreciseDecision doubled)
{
    ExactReport report = (ExactReport)0;
    Decision answer = (Decision)0;

    const float _e8 = exact_code(plain.certain, plain.some, plain.part);
    report.plain = _e8;
    report.plain_lambda = plain.lambda;
    const float _e15 = exact_code(compensated.certain, compensated.some, compensated.part);
    report.compensated = _e15;
    report.compensated_lambda = compensated.lambda;
    const float _e22 = exact_code(doubled.certain, doubled.some, doubled.part);
    report.doubled = _e22;
    report.doubled_high = doubled.lambda.high;
    report.doubled_low = doubled.lambda.low;
    answer = plain;
    report.step_ = 1.0;
    if (!(plain.certain)) {
        answer = compensated;
        report.step_ = 2.0;
        if (!(compensated.certain)) {
            answer = ConstructDecision(doubled.certain, doubled.some, doubled.lambda.high, doubled.part);
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
    const ExactReport exactreport = _e62;
    return exactreport;
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

[numthreads(64, 1, 1)]
void exact_cylinder(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 56))) {
        return;
    }
    float _e10 = asfloat(cases.Load(52+id.x*56));
    exact_one = _e10;
    PackedRay _e15 = ConstructPackedRay(ConstructPackedVec3_(asfloat(cases.Load(0+id.x*56+0+0)), asfloat(cases.Load(0+id.x*56+0+4)), asfloat(cases.Load(0+id.x*56+0+8))), ConstructPackedVec3_(asfloat(cases.Load(0+id.x*56+12+0)), asfloat(cases.Load(0+id.x*56+12+4)), asfloat(cases.Load(0+id.x*56+12+8))));
    const Ray _e16 = ray_load(_e15);
    PackedVec3_ _e21 = ConstructPackedVec3_(asfloat(cases.Load(24+id.x*56+0)), asfloat(cases.Load(24+id.x*56+4)), asfloat(cases.Load(24+id.x*56+8)));
    const float3 _e22 = vec3_load(_e21);
    PackedVec3_ _e27 = ConstructPackedVec3_(asfloat(cases.Load(40+id.x*56+0)), asfloat(cases.Load(40+id.x*56+4)), asfloat(cases.Load(40+id.x*56+8)));
    const float3 _e28 = vec3_load(_e27);
    float radius_4 = asfloat(cases.Load(36+id.x*56));
    const CylinderRecord _e34 = cylinder_new(_e22, radius_4, _e28);
    const Decision _e35 = exact_cylinder_filtered(_e34, _e16);
    const PreciseDecision _e36 = precise_cylinder_filtered(_e22, radius_4, _e28, _e16);
    const Decision _e40 = decision_uncertain();
    const ExactReport _e41 = exact_report(_e35, _e40, _e36);
    {
        ExactReport _value2 = _e41;
        reports.Store(id.x*44+0, asuint(_value2.step_));
        reports.Store(id.x*44+4, asuint(_value2.some));
        reports.Store(id.x*44+8, asuint(_value2.lambda));
        reports.Store(id.x*44+12, asuint(_value2.part));
        reports.Store(id.x*44+16, asuint(_value2.plain));
        reports.Store(id.x*44+20, asuint(_value2.plain_lambda));
        reports.Store(id.x*44+24, asuint(_value2.compensated));
        reports.Store(id.x*44+28, asuint(_value2.compensated_lambda));
        reports.Store(id.x*44+32, asuint(_value2.doubled));
        reports.Store(id.x*44+36, asuint(_value2.doubled_high));
        reports.Store(id.x*44+40, asuint(_value2.doubled_low));
    }
    return;
}
