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

struct SphereRecord {
    float3 center_;
    float radius;
    float radius_squared;
    int _end_pad_0;
    int _end_pad_1;
    int _end_pad_2;
};

struct SphereView {
    float3 r_c;
    float c;
};

struct SphereQuadratic {
    float h;
    float discriminant;
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
    PackedVec3_ center_;
    float radius;
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

SphereRecord ConstructSphereRecord(float3 arg0, float arg1, float arg2) {
    SphereRecord ret = (SphereRecord)0;
    ret.center_ = arg0;
    ret.radius = arg1;
    ret.radius_squared = arg2;
    return ret;
}

SphereRecord sphere_new(float3 center_, float radius)
{
    const SphereRecord sphererecord = ConstructSphereRecord(center_, radius, (radius * radius));
    return sphererecord;
}

SphereView ConstructSphereView(float3 arg0, float arg1) {
    SphereView ret = (SphereView)0;
    ret.r_c = arg0;
    ret.c = arg1;
    return ret;
}

SphereView sphere_seen_from(SphereRecord sphere, float3 origin)
{
    float3 r_c_1 = (sphere.center_ - origin);
    const float _e4 = vec3_dot(r_c_1, r_c_1);
    const SphereView sphereview = ConstructSphereView(r_c_1, (_e4 - sphere.radius_squared));
    return sphereview;
}

SphereQuadratic ConstructSphereQuadratic(float arg0, float arg1) {
    SphereQuadratic ret = (SphereQuadratic)0;
    ret.h = arg0;
    ret.discriminant = arg1;
    return ret;
}

SphereQuadratic sphere_quadratic(SphereView view, float3 direction_1, float a_2)
{
    const float _e4 = vec3_dot(direction_1, view.r_c);
    const SphereQuadratic spherequadratic = ConstructSphereQuadratic(_e4, ((_e4 * _e4) - (a_2 * view.c)));
    return spherequadratic;
}

Root ConstructRoot(bool arg0, float arg1) {
    Root ret = (Root)0;
    ret.some = arg0;
    ret.lambda = arg1;
    return ret;
}

Root sphere_first_root(float a_3, float h, float discriminant)
{
    float root_4 = sqrt(discriminant);
    float near = ((h - root_4) / a_3);
    float far = ((h + root_4) / a_3);
    const bool _e8 = in_range(near);
    float lambda_8 = (_e8 ? near : far);
    const bool _e10 = in_range(lambda_8);
    const Root root_5 = ConstructRoot(_e10, lambda_8);
    return root_5;
}

float3 sphere_outward(SphereRecord sphere_1, float3 point_1)
{
    return ((point_1 - sphere_1.center_) / (sphere_1.radius).xxx);
}

Root sphere_intersect(SphereRecord sphere_2, Ray ray_1)
{
    const float _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    const SphereView _e6 = sphere_seen_from(sphere_2, ray_1.origin);
    const SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
    const Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    const Root root_6 = ConstructRoot((!((_e8.discriminant < 0.0)) & _e11.some), _e11.lambda);
    return root_6;
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

CylinderRecord cylinder_with_unit_axis(float3 center_1, float radius_1, float3 axis_1, float half_height)
{
    float3 to_cap = (axis_1 * half_height);
    const CylinderRecord cylinderrecord = ConstructCylinderRecord(center_1, axis_1, (center_1 + to_cap), (center_1 - to_cap), radius_1, (radius_1 * radius_1), half_height);
    return cylinderrecord;
}

CylinderRecord cylinder_new(float3 center_2, float radius_2, float3 axis_2)
{
    const UnitAndLength _e3 = vec3_unit_and_length(axis_2);
    const CylinderRecord _e8 = cylinder_with_unit_axis(center_2, radius_2, _e3.direction, (_e3.length_ / 2.0));
    const CylinderRecord cylinderrecord_1 = _e8;
    return cylinderrecord_1;
}

CylinderView ConstructCylinderView(float3 arg0, float arg1) {
    CylinderView ret = (CylinderView)0;
    ret.r_c = arg0;
    ret.c = arg1;
    return ret;
}

CylinderView cylinder_seen_from(CylinderRecord cylinder, float3 origin_1)
{
    const float3 _e5 = vec3_perpendicular_to((origin_1 - cylinder.center_), cylinder.axis);
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

CylinderQuadratic cylinder_quadratic(CylinderRecord cylinder_1, CylinderView view_1, float3 along)
{
    const float3 _e4 = vec3_perpendicular_to(along, cylinder_1.axis);
    const float _e5 = vec3_dot(_e4, _e4);
    const float _e7 = vec3_dot(view_1.r_c, _e4);
    const CylinderQuadratic cylinderquadratic = ConstructCylinderQuadratic(_e5, _e7, ((_e7 * _e7) - (_e5 * view_1.c)));
    return cylinderquadratic;
}

bool cylinder_within_height(CylinderRecord cylinder_2, Ray ray_2, float lambda_4)
{
    const float3 _e3 = ray_at(ray_2, lambda_4);
    const float _e7 = vec3_dot((_e3 - cylinder_2.center_), cylinder_2.axis);
    return (abs(_e7) <= cylinder_2.half_height);
}

Root cylinder_side(CylinderRecord cylinder_3, Ray ray_3, CylinderQuadratic quadratic)
{
    float root_7 = sqrt(quadratic.discriminant);
    float near_1 = ((-(quadratic.h) - root_7) / quadratic.a);
    float far_1 = ((-(quadratic.h) + root_7) / quadratic.a);
    const bool _e15 = in_range(near_1);
    const bool _e16 = cylinder_within_height(cylinder_3, ray_3, near_1);
    bool near_counts = (_e15 & _e16);
    const bool _e18 = in_range(far_1);
    const bool _e19 = cylinder_within_height(cylinder_3, ray_3, far_1);
    bool far_counts = (_e18 & _e19);
    const Root root_8 = ConstructRoot((near_counts | far_counts), (near_counts ? near_1 : far_1));
    return root_8;
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_4, float3 center_3)
{
    const float _e5 = vec3_dot(ray_4.direction, cylinder_4.axis);
    const float _e9 = vec3_dot((center_3 - ray_4.origin), cylinder_4.axis);
    float lambda_9 = (_e9 / _e5);
    const float3 _e11 = ray_at(ray_4, lambda_9);
    const float _e13 = vec3_length((_e11 - center_3));
    bool on_disc = (_e13 <= cylinder_4.radius);
    const bool _e20 = in_range(lambda_9);
    const Root root_9 = ConstructRoot(((!((abs(_e5) < 1e-8)) & _e20) & on_disc), lambda_9);
    return root_9;
}

float3 cylinder_outward(CylinderRecord cylinder_5, uint part, float3 point_2)
{
    const float3 _e6 = vec3_perpendicular_to((point_2 - cylinder_5.center_), cylinder_5.axis);
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
    float lambda_10 = (replaces ? later.lambda : closest_2.lambda);
    const CylinderRoot cylinderroot = ConstructCylinderRoot((closest_2.some | later.some), lambda_10, (replaces ? part_1 : closest_2.part));
    return cylinderroot;
}

CylinderRoot cylinder_with_caps(CylinderRecord cylinder_6, Ray ray_5, Root side)
{
    const Root _e4 = cylinder_cap(cylinder_6, ray_5, cylinder_6.top);
    const Root _e6 = cylinder_cap(cylinder_6, ray_5, cylinder_6.bottom);
    const CylinderRoot _e12 = cylinder_closer(ConstructCylinderRoot(side.some, side.lambda, SIDE), _e4, TOP);
    const CylinderRoot _e14 = cylinder_closer(_e12, _e6, BOTTOM);
    const CylinderRoot cylinderroot_1 = _e14;
    return cylinderroot_1;
}

CylinderRoot cylinder_intersect(CylinderRecord cylinder_7, Ray ray_6)
{
    const CylinderView _e3 = cylinder_seen_from(cylinder_7, ray_6.origin);
    const CylinderQuadratic _e5 = cylinder_quadratic(cylinder_7, _e3, ray_6.direction);
    const Root _e6 = cylinder_side(cylinder_7, ray_6, _e5);
    bool some_1 = (!((_e5.discriminant < 0.0)) & _e6.some);
    const CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_6, ConstructRoot(some_1, _e6.lambda));
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

Ray ray_load(PackedRay ray_7)
{
    const float3 _e2 = vec3_load(ray_7.origin);
    const float3 _e4 = vec3_load(ray_7.direction);
    const Ray ray_12 = ConstructRay(_e2, _e4);
    return ray_12;
}

PackedRay ConstructPackedRay(PackedVec3_ arg0, PackedVec3_ arg1) {
    PackedRay ret = (PackedRay)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

PackedRay ray_store(Ray ray_8)
{
    const PackedVec3_ _e2 = vec3_store(ray_8.origin);
    const PackedVec3_ _e4 = vec3_store(ray_8.direction);
    const PackedRay packedray = ConstructPackedRay(_e2, _e4);
    return packedray;
}

ExactHalves ConstructExactHalves(float arg0, float arg1) {
    ExactHalves ret = (ExactHalves)0;
    ret.high = arg0;
    ret.low = arg1;
    return ret;
}

ExactHalves exact_halves(float a_4)
{
    float large = (a_4 * SPLITTER);
    float _e4 = exact_one;
    float high_2 = ((large * _e4) - (large - a_4));
    const ExactHalves exacthalves = ConstructExactHalves(high_2, (a_4 - high_2));
    return exacthalves;
}

ExactSum exact_two_product(float a_5, float b_2)
{
    bool scales_a = (SPLIT_LIMIT < abs(a_5));
    bool scales_b = (SPLIT_LIMIT < abs(b_2));
    float x = (scales_a ? (a_5 * SPLIT_SCALE) : a_5);
    float y = (scales_b ? (b_2 * SPLIT_SCALE) : b_2);
    float product = (x * y);
    const ExactHalves _e15 = exact_halves(x);
    const ExactHalves _e16 = exact_halves(y);
    float error = (((((_e15.high * _e16.high) - product) + (_e15.high * _e16.low)) + (_e15.low * _e16.high)) + (_e15.low * _e16.low));
    float unscaled = (scales_a ? (error * SPLIT_UNSCALE) : error);
    const ExactSum exactsum_1 = ConstructExactSum((a_5 * b_2), (scales_b ? (unscaled * SPLIT_UNSCALE) : unscaled));
    return exactsum_1;
}

float exact_mul_add(float a_6, float b_3, float c)
{
    bool local = (bool)0;
    bool local_1 = (bool)0;
    bool local_2 = (bool)0;
    bool local_3 = (bool)0;

    const ExactSum _e3 = exact_two_product(a_6, b_3);
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

bool error_bound_misses(ErrorBound bound, float discriminant_1)
{
    return (bound.error < -(discriminant_1));
}

bool error_bound_is_too_small(ErrorBound bound_1, float a_7, float numerator, float root)
{
    return (bound_1.error < (((a_7 * bound_1.limits.least) - numerator) * root));
}

Outcome ConstructOutcome(float arg0, bool arg1, bool arg2) {
    Outcome ret = (Outcome)0;
    ret.lambda = arg0;
    ret.hits = arg1;
    ret.fails = arg2;
    return ret;
}

Outcome error_bound_root(ErrorBound bound_2, float a_8, float numerator_1, float root_1)
{
    bool local_5 = (bool)0;
    bool local_6 = (bool)0;

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
    const bool _e32 = error_bound_is_too_small(bound_2, a_8, numerator_1, root_1);
    const Outcome outcome = ConstructOutcome(lambda_11, hits, _e32);
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

Limits exact_sphere_limits()
{
    const Limits limits_3 = ConstructLimits(3.5527137e-15, 8.138021e-5, 0.001, 0.001);
    return limits_3;
}

float exact_sphere_squares(SphereRecord sphere_3, float3 r_c)
{
    const float _e2 = vec3_dot(r_c, r_c);
    return (_e2 + sphere_3.radius_squared);
}

Decision exact_sphere_filtered(SphereRecord sphere_4, Ray ray_9)
{
    bool local_7 = (bool)0;
    bool local_8 = (bool)0;

    const float _e4 = vec3_dot(ray_9.direction, ray_9.direction);
    const SphereView _e6 = sphere_seen_from(sphere_4, ray_9.origin);
    const SphereQuadratic _e8 = sphere_quadratic(_e6, ray_9.direction, _e4);
    const Limits _e9 = exact_sphere_limits();
    const float _e11 = exact_sphere_squares(sphere_4, _e6.r_c);
    const ErrorBound _e12 = error_bound_new(_e9, _e4, _e11);
    const bool _e13 = exact_in_scale(_e4);
    if (!(_e13)) {
        const Decision _e15 = decision_uncertain();
        const Decision decision_3 = _e15;
        return decision_3;
    }
    const bool _e17 = error_bound_misses(_e12, _e8.discriminant);
    if (_e17) {
        const Decision _e18 = decision_miss();
        const Decision decision_4 = _e18;
        return decision_4;
    }
    float root_10 = sqrt(_e8.discriminant);
    const Outcome _e23 = error_bound_root(_e12, _e4, (_e8.h - root_10), root_10);
    if (!(_e23.fails)) {
        local_7 = _e23.hits;
    } else {
        local_7 = false;
    }
    bool _e30 = local_7;
    if (_e30) {
        const Decision _e33 = decision_hit(_e23.lambda, SIDE);
        const Decision decision_5 = _e33;
        return decision_5;
    }
    const Outcome _e36 = error_bound_root(_e12, _e4, (_e8.h + root_10), root_10);
    if (_e23.fails) {
        local_8 = _e36.hits;
    } else {
        local_8 = false;
    }
    bool _e42 = local_8;
    if (_e42) {
        const Decision _e45 = decision_hit(_e36.lambda, SIDE);
        const Decision decision_6 = _e45;
        return decision_6;
    }
    if (_e36.fails) {
        const Decision _e47 = decision_miss();
        const Decision decision_7 = _e47;
        return decision_7;
    }
    const Decision _e48 = decision_uncertain();
    const Decision decision_8 = _e48;
    return decision_8;
}

SquareTerms ConstructSquareTerms(float arg0, float arg1) {
    SquareTerms ret = (SquareTerms)0;
    ret.difference = arg0;
    ret.sum = arg1;
    return ret;
}

SquareTerms exact_square_terms(SphereRecord sphere_5, float3 origin_2)
{
    float _e7 = exact_one;
    const ExactSum _e8 = exact_two_sum(sphere_5.center_.x, -(origin_2.x), _e7);
    float _e14 = exact_one;
    const ExactSum _e15 = exact_two_sum(sphere_5.center_.y, -(origin_2.y), _e14);
    float _e21 = exact_one;
    const ExactSum _e22 = exact_two_sum(sphere_5.center_.z, -(origin_2.z), _e21);
    const ExactSum _e25 = exact_two_product(_e8.sum, _e8.sum);
    const ExactSum _e28 = exact_two_product(_e15.sum, _e15.sum);
    const ExactSum _e31 = exact_two_product(_e22.sum, _e22.sum);
    const ExactSum _e34 = exact_two_product(sphere_5.radius, sphere_5.radius);
    float _e38 = exact_one;
    const ExactSum _e39 = exact_two_sum(_e25.sum, _e28.sum, _e38);
    float _e43 = exact_one;
    const ExactSum _e44 = exact_two_sum(_e39.sum, _e31.sum, _e43);
    float _e49 = exact_one;
    const ExactSum _e50 = exact_two_sum(_e44.sum, -(_e34.sum), _e49);
    const float _e58 = exact_mul_add(_e15.sum, _e15.error, (_e22.sum * _e22.error));
    const float _e59 = exact_mul_add(_e8.sum, _e8.error, _e58);
    float sums = ((_e39.error + _e44.error) + _e50.error);
    float products = ((_e25.error + _e28.error) + (_e31.error - _e34.error));
    const SquareTerms squareterms = ConstructSquareTerms((_e50.sum + ((sums + products) + (_e59 + _e59))), (_e44.sum + _e34.sum));
    return squareterms;
}

Decision exact_sphere_compensated(SphereRecord sphere_6, Ray ray_10)
{
    bool local_9 = (bool)0;
    bool local_10 = (bool)0;
    bool local_11 = (bool)0;
    bool local_12 = (bool)0;
    bool local_13 = (bool)0;

    const float _e4 = vec3_dot(ray_10.direction, ray_10.direction);
    const SphereView _e6 = sphere_seen_from(sphere_6, ray_10.origin);
    const SphereQuadratic _e8 = sphere_quadratic(_e6, ray_10.direction, _e4);
    float root_11 = sqrt(_e8.discriminant);
    const SquareTerms _e12 = exact_square_terms(sphere_6, ray_10.origin);
    float denominator = (abs(_e8.h) + root_11);
    float lambda_12 = (abs(_e12.difference) / denominator);
    float size_1 = (_e4 * _e12.sum);
    if (((size_1 + ERROR_UNDERFLOW) < ((root_11 * denominator) * 4096.0))) {
        local_9 = (size_1 < ERROR_OVERFLOW);
    } else {
        local_9 = false;
    }
    bool accurate_1 = local_9;
    bool c_is_large = (((_e12.sum * 7.1054274e-15) + ERROR_UNDERFLOW) < abs(_e12.difference));
    bool ahead = (0.0 < (_e8.h * _e12.difference));
    const bool _e46 = exact_in_scale(_e4);
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
        const Limits _e61 = exact_sphere_limits();
        local_13 = (_e61.most <= lambda_12);
    } else {
        local_13 = false;
    }
    bool _e65 = local_13;
    if (_e65) {
        const Decision _e67 = decision_hit(lambda_12, SIDE);
        const Decision decision_9 = _e67;
        return decision_9;
    }
    const Decision _e68 = decision_uncertain();
    const Decision decision_10 = _e68;
    return decision_10;
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

DoubleDouble dd_fast_two_sum(float a_9, float b_4)
{
    float _e3 = exact_one;
    float high_3 = ((a_9 * _e3) + b_4);
    const DoubleDouble doubledouble_2 = ConstructDoubleDouble(high_3, (b_4 - (high_3 - a_9)));
    return doubledouble_2;
}

DoubleDouble dd_add(DoubleDouble a_10, DoubleDouble b_5)
{
    float _e5 = exact_one;
    const ExactSum _e6 = exact_two_sum(a_10.high, b_5.high, _e5);
    float _e10 = exact_one;
    const ExactSum _e11 = exact_two_sum(a_10.low, b_5.low, _e10);
    const DoubleDouble _e16 = dd_fast_two_sum(_e6.sum, (_e6.error + _e11.sum));
    const DoubleDouble _e21 = dd_fast_two_sum(_e16.high, (_e16.low + _e11.error));
    const DoubleDouble doubledouble_3 = _e21;
    return doubledouble_3;
}

DoubleDouble dd_neg(DoubleDouble a_11)
{
    const DoubleDouble doubledouble_4 = ConstructDoubleDouble(-(a_11.high), -(a_11.low));
    return doubledouble_4;
}

DoubleDouble dd_sub(DoubleDouble a_12, DoubleDouble b_6)
{
    const DoubleDouble _e2 = dd_neg(b_6);
    const DoubleDouble _e3 = dd_add(a_12, _e2);
    const DoubleDouble doubledouble_5 = _e3;
    return doubledouble_5;
}

DoubleDouble dd_mul(DoubleDouble a_13, DoubleDouble b_7)
{
    const ExactSum _e4 = exact_two_product(a_13.high, b_7.high);
    const float _e12 = exact_mul_add(a_13.high, b_7.low, (a_13.low * b_7.low));
    const float _e13 = exact_mul_add(a_13.low, b_7.high, _e12);
    const DoubleDouble _e17 = dd_fast_two_sum(_e4.sum, (_e4.error + _e13));
    const DoubleDouble doubledouble_6 = _e17;
    return doubledouble_6;
}

DoubleDouble dd_div(DoubleDouble a_14, DoubleDouble b_8)
{
    float high_4 = (a_14.high / b_8.high);
    const ExactSum _e6 = exact_two_product(b_8.high, high_4);
    const float _e10 = exact_mul_add(b_8.low, high_4, _e6.error);
    const DoubleDouble _e11 = dd_fast_two_sum(_e6.sum, _e10);
    float remainder = ((a_14.high - _e11.high) + (a_14.low - _e11.low));
    const DoubleDouble _e21 = dd_fast_two_sum(high_4, (remainder / b_8.high));
    const DoubleDouble doubledouble_7 = _e21;
    return doubledouble_7;
}

DoubleDouble dd_sqrt(DoubleDouble a_15)
{
    if ((a_15.high == 0.0)) {
        const DoubleDouble doubledouble_8 = a_15;
        return doubledouble_8;
    }
    float _e7 = exact_one;
    float high_5 = (sqrt(a_15.high) * _e7);
    const float _e11 = exact_mul_add(-(high_5), high_5, a_15.high);
    float remainder_1 = (_e11 + a_15.low);
    const DoubleDouble _e16 = dd_fast_two_sum(high_5, (remainder_1 / (high_5 + high_5)));
    const DoubleDouble doubledouble_9 = _e16;
    return doubledouble_9;
}

DoubleDouble dd_abs(DoubleDouble a_16)
{
    if ((a_16.high < 0.0)) {
        const DoubleDouble _e4 = dd_neg(a_16);
        const DoubleDouble doubledouble_10 = _e4;
        return doubledouble_10;
    }
    const DoubleDouble doubledouble_11 = a_16;
    return doubledouble_11;
}

bool dd_less(DoubleDouble a_17, DoubleDouble b_9)
{
    bool local_14 = (bool)0;
    bool local_15 = (bool)0;

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

bool dd_less_equal(DoubleDouble a_18, DoubleDouble b_10)
{
    bool local_16 = (bool)0;
    bool local_17 = (bool)0;

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

DoubleDouble3_ ConstructDoubleDouble3_(DoubleDouble arg0, DoubleDouble arg1, DoubleDouble arg2) {
    DoubleDouble3_ ret = (DoubleDouble3_)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

DoubleDouble3_ dd3_of(float3 v_7)
{
    const DoubleDouble _e2 = dd_of(v_7.x);
    const DoubleDouble _e4 = dd_of(v_7.y);
    const DoubleDouble _e6 = dd_of(v_7.z);
    const DoubleDouble3_ doubledouble3_ = ConstructDoubleDouble3_(_e2, _e4, _e6);
    return doubledouble3_;
}

DoubleDouble3_ dd3_add(DoubleDouble3_ a_19, DoubleDouble3_ b_11)
{
    const DoubleDouble _e4 = dd_add(a_19.x, b_11.x);
    const DoubleDouble _e7 = dd_add(a_19.y, b_11.y);
    const DoubleDouble _e10 = dd_add(a_19.z, b_11.z);
    const DoubleDouble3_ doubledouble3_1 = ConstructDoubleDouble3_(_e4, _e7, _e10);
    return doubledouble3_1;
}

DoubleDouble3_ dd3_sub(DoubleDouble3_ a_20, DoubleDouble3_ b_12)
{
    const DoubleDouble _e4 = dd_sub(a_20.x, b_12.x);
    const DoubleDouble _e7 = dd_sub(a_20.y, b_12.y);
    const DoubleDouble _e10 = dd_sub(a_20.z, b_12.z);
    const DoubleDouble3_ doubledouble3_2 = ConstructDoubleDouble3_(_e4, _e7, _e10);
    return doubledouble3_2;
}

DoubleDouble3_ dd3_scaled(DoubleDouble3_ v_8, DoubleDouble factor)
{
    const DoubleDouble _e3 = dd_mul(v_8.x, factor);
    const DoubleDouble _e5 = dd_mul(v_8.y, factor);
    const DoubleDouble _e7 = dd_mul(v_8.z, factor);
    const DoubleDouble3_ doubledouble3_3 = ConstructDoubleDouble3_(_e3, _e5, _e7);
    return doubledouble3_3;
}

DoubleDouble3_ dd3_divided(DoubleDouble3_ v_9, DoubleDouble divisor)
{
    const DoubleDouble _e3 = dd_div(v_9.x, divisor);
    const DoubleDouble _e5 = dd_div(v_9.y, divisor);
    const DoubleDouble _e7 = dd_div(v_9.z, divisor);
    const DoubleDouble3_ doubledouble3_4 = ConstructDoubleDouble3_(_e3, _e5, _e7);
    return doubledouble3_4;
}

DoubleDouble dd3_dot(DoubleDouble3_ a_21, DoubleDouble3_ b_13)
{
    const DoubleDouble _e4 = dd_mul(a_21.x, b_13.x);
    const DoubleDouble _e7 = dd_mul(a_21.y, b_13.y);
    const DoubleDouble _e8 = dd_add(_e4, _e7);
    const DoubleDouble _e11 = dd_mul(a_21.z, b_13.z);
    const DoubleDouble _e12 = dd_add(_e8, _e11);
    const DoubleDouble doubledouble_12 = _e12;
    return doubledouble_12;
}

DoubleDouble dd3_magnitude(DoubleDouble3_ v_10)
{
    const DoubleDouble _e2 = dd_abs(v_10.x);
    const DoubleDouble _e4 = dd_abs(v_10.y);
    const DoubleDouble _e5 = dd_add(_e2, _e4);
    const DoubleDouble _e7 = dd_abs(v_10.z);
    const DoubleDouble _e8 = dd_add(_e5, _e7);
    const DoubleDouble doubledouble_13 = _e8;
    return doubledouble_13;
}

DoubleDouble3_ dd3_perpendicular_to(DoubleDouble3_ v_11, DoubleDouble3_ axis_3)
{
    const DoubleDouble _e2 = dd3_dot(v_11, axis_3);
    const DoubleDouble3_ _e3 = dd3_scaled(axis_3, _e2);
    const DoubleDouble3_ _e4 = dd3_sub(v_11, _e3);
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

PreciseDecision precise_hit(DoubleDouble lambda_6, uint part_3)
{
    const PreciseDecision precisedecision_2 = ConstructPreciseDecision(true, true, lambda_6, part_3);
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

bool precise_bound_misses(PreciseBound bound_3, DoubleDouble discriminant_2)
{
    const DoubleDouble _e3 = dd_neg(discriminant_2);
    const bool _e4 = dd_less(bound_3.error, _e3);
    return _e4;
}

bool precise_in_scale(DoubleDouble length_squared_3)
{
    bool local_18 = (bool)0;

    const DoubleDouble _e2 = dd_constant(SHORTEST_SQUARED);
    const bool _e3 = dd_less_equal(_e2, length_squared_3);
    if (_e3) {
        const DoubleDouble _e7 = dd_constant(LONGEST_SQUARED);
        const bool _e8 = dd_less_equal(length_squared_3, _e7);
        local_18 = _e8;
    } else {
        local_18 = false;
    }
    bool _e10 = local_18;
    return _e10;
}

DoubleDouble precise_least_lambda()
{
    float _e2 = exact_one;
    float _e6 = exact_one;
    const DoubleDouble doubledouble_14 = ConstructDoubleDouble((0.001 * _e2), (-1.0842022e-19 * _e6));
    return doubledouble_14;
}

bool precise_in_range(PreciseLimits limits_2, DoubleDouble lambda_7)
{
    const DoubleDouble _e2 = precise_least_lambda();
    const DoubleDouble _e4 = dd_constant(limits_2.lambda_error);
    const DoubleDouble _e5 = dd_add(_e2, _e4);
    const bool _e6 = dd_less_equal(_e5, lambda_7);
    return _e6;
}

bool precise_bound_is_too_small(PreciseBound bound_4, DoubleDouble a_22, DoubleDouble numerator_2, DoubleDouble root_2)
{
    const DoubleDouble _e4 = precise_least_lambda();
    const DoubleDouble _e7 = dd_constant(bound_4.limits.lambda_error);
    const DoubleDouble _e8 = dd_sub(_e4, _e7);
    const DoubleDouble _e10 = dd_mul(a_22, _e8);
    const DoubleDouble _e11 = dd_sub(_e10, numerator_2);
    const DoubleDouble _e12 = dd_mul(_e11, root_2);
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

PreciseOutcome precise_bound_root(PreciseBound bound_5, DoubleDouble a_23, DoubleDouble numerator_3, DoubleDouble root_3)
{
    bool local_19 = (bool)0;
    bool local_20 = (bool)0;

    const DoubleDouble _e4 = dd_div(numerator_3, a_23);
    float share_1 = bound_5.limits.share;
    const DoubleDouble _e8 = dd_constant(share_1);
    const DoubleDouble _e9 = dd_mul(bound_5.size, _e8);
    const DoubleDouble _e11 = dd_constant(ERROR_UNDERFLOW);
    const DoubleDouble _e12 = dd_add(_e9, _e11);
    const DoubleDouble _e13 = dd_mul(numerator_3, numerator_3);
    const DoubleDouble _e16 = dd_constant((share_1 * 4.0));
    const DoubleDouble _e17 = dd_mul(_e13, _e16);
    const DoubleDouble _e18 = dd_add(_e12, _e17);
    const DoubleDouble _e19 = dd_mul(root_3, numerator_3);
    const bool _e20 = dd_less(_e18, _e19);
    const DoubleDouble _e23 = dd_constant(ERROR_OVERFLOW);
    const bool _e24 = dd_less(bound_5.size, _e23);
    if (_e20) {
        local_19 = _e24;
    } else {
        local_19 = false;
    }
    bool _e28 = local_19;
    if (_e28) {
        const bool _e32 = precise_in_range(bound_5.limits, _e4);
        local_20 = _e32;
    } else {
        local_20 = false;
    }
    bool hits_1 = local_20;
    const bool _e35 = precise_bound_is_too_small(bound_5, a_23, numerator_3, root_3);
    const PreciseOutcome preciseoutcome = ConstructPreciseOutcome(_e4, hits_1, _e35);
    return preciseoutcome;
}

PreciseLimits ConstructPreciseLimits(float arg0, float arg1, float arg2) {
    PreciseLimits ret = (PreciseLimits)0;
    ret.error = arg0;
    ret.share = arg1;
    ret.lambda_error = arg2;
    return ret;
}

PreciseLimits precise_sphere_limits()
{
    const PreciseLimits preciselimits = ConstructPreciseLimits(6.3108872e-30, 4.8506386e-12, 1.0408341e-20);
    return preciselimits;
}

PreciseDecision precise_sphere_filtered(float3 center_4, float radius_3, Ray ray_11)
{
    bool local_21 = (bool)0;
    bool local_22 = (bool)0;

    const DoubleDouble3_ _e4 = dd3_of(ray_11.direction);
    const DoubleDouble _e5 = dd3_dot(_e4, _e4);
    const DoubleDouble _e6 = dd_of(radius_3);
    const DoubleDouble _e7 = dd_of(radius_3);
    const DoubleDouble _e8 = dd_mul(_e6, _e7);
    const DoubleDouble3_ _e9 = dd3_of(center_4);
    const DoubleDouble3_ _e11 = dd3_of(ray_11.origin);
    const DoubleDouble3_ _e12 = dd3_sub(_e9, _e11);
    const DoubleDouble _e13 = dd3_dot(_e12, _e12);
    const DoubleDouble _e14 = dd_sub(_e13, _e8);
    const DoubleDouble _e15 = dd3_dot(_e4, _e12);
    const DoubleDouble _e16 = dd_mul(_e15, _e15);
    const DoubleDouble _e17 = dd_mul(_e5, _e14);
    const DoubleDouble _e18 = dd_sub(_e16, _e17);
    const PreciseLimits _e19 = precise_sphere_limits();
    const DoubleDouble _e20 = dd_add(_e13, _e8);
    const PreciseBound _e21 = precise_bound_new(_e19, _e5, _e20);
    const bool _e22 = precise_in_scale(_e5);
    if (!(_e22)) {
        const PreciseDecision _e24 = precise_uncertain();
        const PreciseDecision precisedecision_3 = _e24;
        return precisedecision_3;
    }
    const bool _e25 = precise_bound_misses(_e21, _e18);
    if (_e25) {
        const PreciseDecision _e26 = precise_miss();
        const PreciseDecision precisedecision_4 = _e26;
        return precisedecision_4;
    }
    const DoubleDouble _e27 = dd_sqrt(_e18);
    const DoubleDouble _e28 = dd_sub(_e15, _e27);
    const PreciseOutcome _e29 = precise_bound_root(_e21, _e5, _e28, _e27);
    if (!(_e29.fails)) {
        local_21 = _e29.hits;
    } else {
        local_21 = false;
    }
    bool _e36 = local_21;
    if (_e36) {
        const PreciseDecision _e39 = precise_hit(_e29.lambda, SIDE);
        const PreciseDecision precisedecision_5 = _e39;
        return precisedecision_5;
    }
    const DoubleDouble _e40 = dd_add(_e15, _e27);
    const PreciseOutcome _e41 = precise_bound_root(_e21, _e5, _e40, _e27);
    if (_e29.fails) {
        local_22 = _e41.hits;
    } else {
        local_22 = false;
    }
    bool _e47 = local_22;
    if (_e47) {
        const PreciseDecision _e50 = precise_hit(_e41.lambda, SIDE);
        const PreciseDecision precisedecision_6 = _e50;
        return precisedecision_6;
    }
    if (_e41.fails) {
        const PreciseDecision _e52 = precise_miss();
        const PreciseDecision precisedecision_7 = _e52;
        return precisedecision_7;
    }
    const PreciseDecision _e53 = precise_uncertain();
    const PreciseDecision precisedecision_8 = _e53;
    return precisedecision_8;
}

float exact_code(bool certain, bool some, uint part_4)
{
    if (!(certain)) {
        return 0.0;
    }
    return (some ? float((2u + part_4)) : 1.0);
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
void exact_sphere(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 44))) {
        return;
    }
    float _e10 = asfloat(cases.Load(40+id.x*44));
    exact_one = _e10;
    PackedRay _e15 = ConstructPackedRay(ConstructPackedVec3_(asfloat(cases.Load(0+id.x*44+0+0)), asfloat(cases.Load(0+id.x*44+0+4)), asfloat(cases.Load(0+id.x*44+0+8))), ConstructPackedVec3_(asfloat(cases.Load(0+id.x*44+12+0)), asfloat(cases.Load(0+id.x*44+12+4)), asfloat(cases.Load(0+id.x*44+12+8))));
    const Ray _e16 = ray_load(_e15);
    PackedVec3_ _e21 = ConstructPackedVec3_(asfloat(cases.Load(24+id.x*44+0)), asfloat(cases.Load(24+id.x*44+4)), asfloat(cases.Load(24+id.x*44+8)));
    const float3 _e22 = vec3_load(_e21);
    float radius_4 = asfloat(cases.Load(36+id.x*44));
    const SphereRecord _e28 = sphere_new(_e22, radius_4);
    const Decision _e29 = exact_sphere_filtered(_e28, _e16);
    const Decision _e30 = exact_sphere_compensated(_e28, _e16);
    const PreciseDecision _e34 = precise_sphere_filtered(_e22, radius_4, _e16);
    const ExactReport _e35 = exact_report(_e29, _e30, _e34);
    {
        ExactReport _value2 = _e35;
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
