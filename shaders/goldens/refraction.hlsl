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

struct RefractionCase {
    PackedVec3_ direction;
    PackedVec3_ normal;
    float ratio;
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
RWByteAddressBuffer results : register(u1);

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
    bool front_1 = (_e3 < 0.0);
    const Hit hit = ConstructHit(point_, (front_1 ? outward : -(outward)), front_1);
    return hit;
}

float3 scatter_matte(float3 normal, float3 vector_)
{
    float3 direction_5 = (normal + vector_);
    const bool _e3 = vec3_is_negligible(direction_5);
    return (_e3 ? normal : direction_5);
}

float3 scatter_reflect(float3 direction_1, float3 normal_1)
{
    const float _e2 = vec3_dot(direction_1, normal_1);
    return (direction_1 - (normal_1 * (_e2 * 2.0)));
}

float3 scatter_mirror(float3 direction_2, float3 normal_2)
{
    const float3 _e2 = scatter_reflect(direction_2, normal_2);
    const float3 _e3 = vec3_unit(_e2);
    return _e3;
}

float3 scatter_metal(float3 direction_3, float3 normal_3, float3 vector_1)
{
    const float3 _e3 = scatter_mirror(direction_3, normal_3);
    return (_e3 + vector_1);
}

float scatter_index_ratio(float index, bool front)
{
    return (front ? (1.0 / index) : index);
}

float3 scatter_refract(float3 direction_4, float3 normal_4, float ratio)
{
    const float3 _e4 = vec3_unit(direction_4);
    const float _e5 = vec3_dot(_e4, normal_4);
    float product = -(_e5);
    float cos_ = ((product < 1.0) ? product : 1.0);
    float sin_ = sqrt((1.0 - (cos_ * cos_)));
    const float3 _e12 = scatter_reflect(_e4, normal_4);
    float3 p = ((_e4 + (normal_4 * cos_)) * ratio);
    const float _e16 = vec3_dot(p, p);
    float3 refracted = (p - (normal_4 * sqrt(abs((1.0 - _e16)))));
    bool beyond = (1.0 < (ratio * sin_));
    return (beyond ? _e12 : refracted);
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

Ray ray_load(PackedRay ray_1)
{
    const float3 _e2 = vec3_load(ray_1.origin);
    const float3 _e4 = vec3_load(ray_1.direction);
    const Ray ray_3 = ConstructRay(_e2, _e4);
    return ray_3;
}

PackedRay ConstructPackedRay(PackedVec3_ arg0, PackedVec3_ arg1) {
    PackedRay ret = (PackedRay)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

PackedRay ray_store(Ray ray_2)
{
    const PackedVec3_ _e2 = vec3_store(ray_2.origin);
    const PackedVec3_ _e4 = vec3_store(ray_2.direction);
    const PackedRay packedray = ConstructPackedRay(_e2, _e4);
    return packedray;
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

RefractionCase ConstructRefractionCase(PackedVec3_ arg0, PackedVec3_ arg1, float arg2) {
    RefractionCase ret = (RefractionCase)0;
    ret.direction = arg0;
    ret.normal = arg1;
    ret.ratio = arg2;
    return ret;
}

[numthreads(64, 1, 1)]
void refraction(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 28))) {
        return;
    }
    RefractionCase this_case = ConstructRefractionCase(ConstructPackedVec3_(asfloat(cases.Load(id.x*28+0+0)), asfloat(cases.Load(id.x*28+0+4)), asfloat(cases.Load(id.x*28+0+8))), ConstructPackedVec3_(asfloat(cases.Load(id.x*28+12+0)), asfloat(cases.Load(id.x*28+12+4)), asfloat(cases.Load(id.x*28+12+8))), asfloat(cases.Load(id.x*28+24)));
    const float3 _e10 = vec3_load(this_case.direction);
    const float3 _e12 = vec3_load(this_case.normal);
    const float3 _e17 = scatter_refract(_e10, _e12, this_case.ratio);
    const PackedVec3_ _e18 = vec3_store(_e17);
    {
        PackedVec3_ _value2 = _e18;
        results.Store(id.x*12+0, asuint(_value2.x));
        results.Store(id.x*12+4, asuint(_value2.y));
        results.Store(id.x*12+8, asuint(_value2.z));
    }
    return;
}
