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

struct SphereCase {
    PackedRay ray;
    PackedVec3_ center_;
    float radius;
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

SphereView sphere_seen_from(SphereRecord sphere_1, float3 origin)
{
    float3 r_c = (sphere_1.center_ - origin);
    const float _e4 = vec3_dot(r_c, r_c);
    const SphereView sphereview = ConstructSphereView(r_c, (_e4 - sphere_1.radius_squared));
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
    float lambda_3 = (_e8 ? near : far);
    const bool _e10 = in_range(lambda_3);
    const Root root_1 = ConstructRoot(_e10, lambda_3);
    return root_1;
}

float3 sphere_outward(SphereRecord sphere_2, float3 point_1)
{
    return ((point_1 - sphere_2.center_) / (sphere_2.radius).xxx);
}

Root sphere_intersect(SphereRecord sphere_3, Ray ray_1)
{
    const float _e4 = vec3_dot(ray_1.direction, ray_1.direction);
    const SphereView _e6 = sphere_seen_from(sphere_3, ray_1.origin);
    const SphereQuadratic _e8 = sphere_quadratic(_e6, ray_1.direction, _e4);
    const Root _e11 = sphere_first_root(_e4, _e8.h, _e8.discriminant);
    const Root root_2 = ConstructRoot((!((_e8.discriminant < 0.0)) & _e11.some), _e11.lambda);
    return root_2;
}

float3 vec3_load(PackedVec3_ v_4)
{
    return float3(v_4.x, v_4.y, v_4.z);
}

PackedVec3_ ConstructPackedVec3_(float arg0, float arg1, float arg2) {
    PackedVec3_ ret = (PackedVec3_)0;
    ret.x = arg0;
    ret.y = arg1;
    ret.z = arg2;
    return ret;
}

PackedVec3_ vec3_store(float3 v_5)
{
    const PackedVec3_ packedvec3_ = ConstructPackedVec3_(v_5.x, v_5.y, v_5.z);
    return packedvec3_;
}

Ray ConstructRay(float3 arg0, float3 arg1) {
    Ray ret = (Ray)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

Ray ray_load(PackedRay ray_2)
{
    const float3 _e2 = vec3_load(ray_2.origin);
    const float3 _e4 = vec3_load(ray_2.direction);
    const Ray ray_4 = ConstructRay(_e2, _e4);
    return ray_4;
}

PackedRay ConstructPackedRay(PackedVec3_ arg0, PackedVec3_ arg1) {
    PackedRay ret = (PackedRay)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

PackedRay ray_store(Ray ray_3)
{
    const PackedVec3_ _e2 = vec3_store(ray_3.origin);
    const PackedVec3_ _e4 = vec3_store(ray_3.direction);
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

HitReport hit_report(float lambda_2, uint part, Hit hit)
{
    float front_1 = (hit.front ? 1.0 : 0.0);
    const PackedVec3_ _e10 = vec3_store(hit.point_);
    const PackedVec3_ _e12 = vec3_store(hit.normal);
    const HitReport hitreport_1 = ConstructHitReport(1.0, lambda_2, float(part), front_1, _e10, _e12);
    return hitreport_1;
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

[numthreads(64, 1, 1)]
void sphere(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 40))) {
        return;
    }
    PackedRay _e9 = ConstructPackedRay(ConstructPackedVec3_(asfloat(cases.Load(0+id.x*40+0+0)), asfloat(cases.Load(0+id.x*40+0+4)), asfloat(cases.Load(0+id.x*40+0+8))), ConstructPackedVec3_(asfloat(cases.Load(0+id.x*40+12+0)), asfloat(cases.Load(0+id.x*40+12+4)), asfloat(cases.Load(0+id.x*40+12+8))));
    const Ray _e10 = ray_load(_e9);
    PackedVec3_ _e15 = ConstructPackedVec3_(asfloat(cases.Load(24+id.x*40+0)), asfloat(cases.Load(24+id.x*40+4)), asfloat(cases.Load(24+id.x*40+8)));
    const float3 _e16 = vec3_load(_e15);
    float _e21 = asfloat(cases.Load(36+id.x*40));
    const SphereRecord _e22 = sphere_new(_e16, _e21);
    const Root _e23 = sphere_intersect(_e22, _e10);
    if (!(_e23.some)) {
        const HitReport _e29 = hit_report_none();
        {
            HitReport _value3 = _e29;
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
    const float3 _e31 = ray_at(_e10, _e23.lambda);
    const float3 _e33 = sphere_outward(_e22, _e31);
    const Hit _e34 = hit_facing(_e10.direction, _e31, _e33);
    const HitReport _e40 = hit_report(_e23.lambda, 0u, _e34);
    {
        HitReport _value2 = _e40;
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
