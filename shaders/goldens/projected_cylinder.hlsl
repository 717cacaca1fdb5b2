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

struct Crossings {
    bool some;
    float near;
    float far;
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

struct HitReport {
    float some;
    float lambda;
    float part;
    float front;
    PackedVec3_ point_;
    PackedVec3_ normal;
};

struct ProjectedCylinderCase {
    PackedRay ray;
    PackedVec3_ center_;
    float radius;
    PackedVec3_ axis;
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
    const Hit hit_1 = ConstructHit(point_, (front ? outward : -(outward)), front);
    return hit_1;
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

SphereQuadratic sphere_quadratic(SphereView view, float3 direction_1, float a_1)
{
    const float _e4 = vec3_dot(direction_1, view.r_c);
    const SphereQuadratic spherequadratic = ConstructSphereQuadratic(_e4, ((_e4 * _e4) - (a_1 * view.c)));
    return spherequadratic;
}

Root ConstructRoot(bool arg0, float arg1) {
    Root ret = (Root)0;
    ret.some = arg0;
    ret.lambda = arg1;
    return ret;
}

Root sphere_first_root(float a_2, float h, float discriminant)
{
    float root = sqrt(discriminant);
    float near = ((h - root) / a_2);
    float far = ((h + root) / a_2);
    const bool _e8 = in_range(near);
    float lambda_6 = (_e8 ? near : far);
    const bool _e10 = in_range(lambda_6);
    const Root root_1 = ConstructRoot(_e10, lambda_6);
    return root_1;
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
    const Root root_2 = ConstructRoot((!((_e8.discriminant < 0.0)) & _e11.some), _e11.lambda);
    return root_2;
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
    float root_3 = sqrt(quadratic.discriminant);
    float near_1 = ((-(quadratic.h) - root_3) / quadratic.a);
    float far_1 = ((-(quadratic.h) + root_3) / quadratic.a);
    const bool _e15 = in_range(near_1);
    const bool _e16 = cylinder_within_height(cylinder_3, ray_3, near_1);
    bool near_counts = (_e15 & _e16);
    const bool _e18 = in_range(far_1);
    const bool _e19 = cylinder_within_height(cylinder_3, ray_3, far_1);
    bool far_counts = (_e18 & _e19);
    const Root root_4 = ConstructRoot((near_counts | far_counts), (near_counts ? near_1 : far_1));
    return root_4;
}

Root cylinder_cap(CylinderRecord cylinder_4, Ray ray_4, float3 center_3)
{
    const float _e5 = vec3_dot(ray_4.direction, cylinder_4.axis);
    const float _e9 = vec3_dot((center_3 - ray_4.origin), cylinder_4.axis);
    float lambda_7 = (_e9 / _e5);
    const float3 _e11 = ray_at(ray_4, lambda_7);
    const float _e13 = vec3_length((_e11 - center_3));
    bool on_disc = (_e13 <= cylinder_4.radius);
    const bool _e20 = in_range(lambda_7);
    const Root root_5 = ConstructRoot(((!((abs(_e5) < 1e-8)) & _e20) & on_disc), lambda_7);
    return root_5;
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
    float lambda_8 = (replaces ? later.lambda : closest_2.lambda);
    const CylinderRoot cylinderroot = ConstructCylinderRoot((closest_2.some | later.some), lambda_8, (replaces ? part_1 : closest_2.part));
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
    bool some = (!((_e5.discriminant < 0.0)) & _e6.some);
    const CylinderRoot _e15 = cylinder_with_caps(cylinder_7, ray_6, ConstructRoot(some, _e6.lambda));
    const CylinderRoot cylinderroot_2 = _e15;
    return cylinderroot_2;
}

Crossings ConstructCrossings(bool arg0, float arg1, float arg2) {
    Crossings ret = (Crossings)0;
    ret.some = arg0;
    ret.near = arg1;
    ret.far = arg2;
    return ret;
}

Crossings projected_crossings(float3 direction_2, float3 r_c, float radius_squared)
{
    const float _e3 = vec3_dot(direction_2, direction_2);
    const float _e4 = vec3_dot(direction_2, r_c);
    float middle = (_e4 / _e3);
    float3 off_center = (r_c - (direction_2 * middle));
    const float _e8 = vec3_dot(off_center, off_center);
    float rest = (radius_squared - _e8);
    if ((rest < 0.0)) {
        const Crossings crossings = ConstructCrossings(false, 0.0, 0.0);
        return crossings;
    }
    float half_ = sqrt((rest / _e3));
    const Crossings crossings_1 = ConstructCrossings(true, (middle - half_), (middle + half_));
    return crossings_1;
}

Root projected_sphere_intersect(SphereRecord sphere_3, Ray ray_7)
{
    bool local = (bool)0;

    const Crossings _e7 = projected_crossings(ray_7.direction, (sphere_3.center_ - ray_7.origin), sphere_3.radius_squared);
    const bool _e11 = in_range(_e7.near);
    float lambda_9 = (_e11 ? _e7.near : _e7.far);
    if (_e7.some) {
        const bool _e16 = in_range(lambda_9);
        local = _e16;
    } else {
        local = false;
    }
    bool _e18 = local;
    const Root root_6 = ConstructRoot(_e18, lambda_9);
    return root_6;
}

CylinderRoot projected_cylinder_intersect(CylinderRecord cylinder_8, Ray ray_8)
{
    Root side_1 = (Root)0;
    bool local_1 = (bool)0;
    bool local_2 = (bool)0;
    bool local_3 = (bool)0;

    const float3 _e6 = vec3_perpendicular_to((cylinder_8.center_ - ray_8.origin), cylinder_8.axis);
    const float3 _e9 = vec3_perpendicular_to(ray_8.direction, cylinder_8.axis);
    const Crossings _e11 = projected_crossings(_e9, _e6, cylinder_8.radius_squared);
    if (_e11.some) {
        const bool _e15 = in_range(_e11.near);
        if (_e15) {
            const bool _e19 = cylinder_within_height(cylinder_8, ray_8, _e11.near);
            local_1 = _e19;
        } else {
            local_1 = false;
        }
        bool near_counts_1 = local_1;
        const bool _e23 = in_range(_e11.far);
        if (_e23) {
            const bool _e27 = cylinder_within_height(cylinder_8, ray_8, _e11.far);
            local_2 = _e27;
        } else {
            local_2 = false;
        }
        bool far_counts_1 = local_2;
        float lambda_10 = (near_counts_1 ? _e11.near : _e11.far);
        if (!(near_counts_1)) {
            local_3 = far_counts_1;
        } else {
            local_3 = true;
        }
        bool _e37 = local_3;
        side_1 = ConstructRoot(_e37, lambda_10);
    }
    Root _e39 = side_1;
    const CylinderRoot _e40 = cylinder_with_caps(cylinder_8, ray_8, _e39);
    const CylinderRoot cylinderroot_3 = _e40;
    return cylinderroot_3;
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

Ray ray_load(PackedRay ray_9)
{
    const float3 _e2 = vec3_load(ray_9.origin);
    const float3 _e4 = vec3_load(ray_9.direction);
    const Ray ray_11 = ConstructRay(_e2, _e4);
    return ray_11;
}

PackedRay ConstructPackedRay(PackedVec3_ arg0, PackedVec3_ arg1) {
    PackedRay ret = (PackedRay)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

PackedRay ray_store(Ray ray_10)
{
    const PackedVec3_ _e2 = vec3_store(ray_10.origin);
    const PackedVec3_ _e4 = vec3_store(ray_10.direction);
    const PackedRay packedray = ConstructPackedRay(_e2, _e4);
    return packedray;
}

HitReport ConstructHitReport(float arg0, float arg1, float arg2, float arg3, PackedVec3_ arg4, PackedVec3_ arg5) {
    HitReport ret = (HitReport)0;
    ret.some = arg0;
    ret.lambda = arg1;
    ret.part = arg2;
    ret.front = arg3;
    ret.point_ = arg4;
    ret.normal = arg5;
    return ret;
}

float3 ZeroValuefloat3() {
    return (float3)0;
}

HitReport hit_report_none()
{
    const PackedVec3_ _e1 = vec3_store(ZeroValuefloat3());
    const HitReport hitreport = ConstructHitReport(0.0, 0.0, 0.0, 0.0, _e1, _e1);
    return hitreport;
}

HitReport hit_report(float lambda_5, uint part_2, Hit hit)
{
    float front_1 = (hit.front ? 1.0 : 0.0);
    const PackedVec3_ _e10 = vec3_store(hit.point_);
    const PackedVec3_ _e12 = vec3_store(hit.normal);
    const HitReport hitreport_1 = ConstructHitReport(1.0, lambda_5, float(part_2), front_1, _e10, _e12);
    return hitreport_1;
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

[numthreads(64, 1, 1)]
void projected_cylinder(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 52))) {
        return;
    }
    PackedRay _e9 = ConstructPackedRay(ConstructPackedVec3_(asfloat(cases.Load(0+id.x*52+0+0)), asfloat(cases.Load(0+id.x*52+0+4)), asfloat(cases.Load(0+id.x*52+0+8))), ConstructPackedVec3_(asfloat(cases.Load(0+id.x*52+12+0)), asfloat(cases.Load(0+id.x*52+12+4)), asfloat(cases.Load(0+id.x*52+12+8))));
    const Ray _e10 = ray_load(_e9);
    PackedVec3_ _e15 = ConstructPackedVec3_(asfloat(cases.Load(24+id.x*52+0)), asfloat(cases.Load(24+id.x*52+4)), asfloat(cases.Load(24+id.x*52+8)));
    const float3 _e16 = vec3_load(_e15);
    float _e21 = asfloat(cases.Load(36+id.x*52));
    PackedVec3_ _e26 = ConstructPackedVec3_(asfloat(cases.Load(40+id.x*52+0)), asfloat(cases.Load(40+id.x*52+4)), asfloat(cases.Load(40+id.x*52+8)));
    const float3 _e27 = vec3_load(_e26);
    const CylinderRecord _e28 = cylinder_new(_e16, _e21, _e27);
    const CylinderRoot _e29 = projected_cylinder_intersect(_e28, _e10);
    if (!(_e29.some)) {
        const HitReport _e35 = hit_report_none();
        {
            HitReport _value3 = _e35;
            reports.Store(id.x*40+0, asuint(_value3.some));
            reports.Store(id.x*40+4, asuint(_value3.lambda));
            reports.Store(id.x*40+8, asuint(_value3.part));
            reports.Store(id.x*40+12, asuint(_value3.front));
            {
                PackedVec3_ _value4 = _value3.point_;
                reports.Store(id.x*40+16+0, asuint(_value4.x));
                reports.Store(id.x*40+16+4, asuint(_value4.y));
                reports.Store(id.x*40+16+8, asuint(_value4.z));
            }
            {
                PackedVec3_ _value4 = _value3.normal;
                reports.Store(id.x*40+28+0, asuint(_value4.x));
                reports.Store(id.x*40+28+4, asuint(_value4.y));
                reports.Store(id.x*40+28+8, asuint(_value4.z));
            }
        }
        return;
    }
    const float3 _e37 = ray_at(_e10, _e29.lambda);
    const float3 _e40 = cylinder_outward(_e28, _e29.part, _e37);
    const Hit _e41 = hit_facing(_e10.direction, _e37, _e40);
    const HitReport _e47 = hit_report(_e29.lambda, _e29.part, _e41);
    {
        HitReport _value2 = _e47;
        reports.Store(id.x*40+0, asuint(_value2.some));
        reports.Store(id.x*40+4, asuint(_value2.lambda));
        reports.Store(id.x*40+8, asuint(_value2.part));
        reports.Store(id.x*40+12, asuint(_value2.front));
        {
            PackedVec3_ _value3 = _value2.point_;
            reports.Store(id.x*40+16+0, asuint(_value3.x));
            reports.Store(id.x*40+16+4, asuint(_value3.y));
            reports.Store(id.x*40+16+8, asuint(_value3.z));
        }
        {
            PackedVec3_ _value3 = _value2.normal;
            reports.Store(id.x*40+28+0, asuint(_value3.x));
            reports.Store(id.x*40+28+4, asuint(_value3.y));
            reports.Store(id.x*40+28+8, asuint(_value3.z));
        }
    }
    return;
}
