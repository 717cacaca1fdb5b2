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

struct Camera {
    float3 position;
    int _pad1_0;
    float3 origin;
    int _pad2_0;
    float3 delta_x;
    int _pad3_0;
    float3 delta_y;
    int _end_pad_0;
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

struct CameraCase {
    PackedVec3_ position;
    PackedVec3_ origin;
    PackedVec3_ delta_x;
    PackedVec3_ delta_y;
    float row;
    float column;
    float offset_x;
    float offset_y;
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
static const float LEAST_SIZE = 0.0;
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
    bool front = (_e3 < 0.0);
    const Hit hit = ConstructHit(point_, (front ? outward : -(outward)), front);
    return hit;
}

Ray ConstructRay(float3 arg0, float3 arg1) {
    Ray ret = (Ray)0;
    ret.origin = arg0;
    ret.direction = arg1;
    return ret;
}

Ray camera_ray(Camera camera_1, float row, float column, float2 offset)
{
    float x = offset.x;
    float y = offset.y;
    float3 window_point = ((camera_1.origin + (camera_1.delta_x * (column + x))) + (camera_1.delta_y * (row + y)));
    const Ray ray_3 = ConstructRay(camera_1.position, (window_point - camera_1.position));
    return ray_3;
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

Ray ray_load(PackedRay ray_1)
{
    const float3 _e2 = vec3_load(ray_1.origin);
    const float3 _e4 = vec3_load(ray_1.direction);
    const Ray ray_4 = ConstructRay(_e2, _e4);
    return ray_4;
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

Camera ConstructCamera(float3 arg0, float3 arg1, float3 arg2, float3 arg3) {
    Camera ret = (Camera)0;
    ret.position = arg0;
    ret.origin = arg1;
    ret.delta_x = arg2;
    ret.delta_y = arg3;
    return ret;
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

CameraCase ConstructCameraCase(PackedVec3_ arg0, PackedVec3_ arg1, PackedVec3_ arg2, PackedVec3_ arg3, float arg4, float arg5, float arg6, float arg7) {
    CameraCase ret = (CameraCase)0;
    ret.position = arg0;
    ret.origin = arg1;
    ret.delta_x = arg2;
    ret.delta_y = arg3;
    ret.row = arg4;
    ret.column = arg5;
    ret.offset_x = arg6;
    ret.offset_y = arg7;
    return ret;
}

[numthreads(64, 1, 1)]
void camera(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 64))) {
        return;
    }
    CameraCase this_case = ConstructCameraCase(ConstructPackedVec3_(asfloat(cases.Load(id.x*64+0+0)), asfloat(cases.Load(id.x*64+0+4)), asfloat(cases.Load(id.x*64+0+8))), ConstructPackedVec3_(asfloat(cases.Load(id.x*64+12+0)), asfloat(cases.Load(id.x*64+12+4)), asfloat(cases.Load(id.x*64+12+8))), ConstructPackedVec3_(asfloat(cases.Load(id.x*64+24+0)), asfloat(cases.Load(id.x*64+24+4)), asfloat(cases.Load(id.x*64+24+8))), ConstructPackedVec3_(asfloat(cases.Load(id.x*64+36+0)), asfloat(cases.Load(id.x*64+36+4)), asfloat(cases.Load(id.x*64+36+8))), asfloat(cases.Load(id.x*64+48)), asfloat(cases.Load(id.x*64+52)), asfloat(cases.Load(id.x*64+56)), asfloat(cases.Load(id.x*64+60)));
    const float3 _e10 = vec3_load(this_case.position);
    const float3 _e12 = vec3_load(this_case.origin);
    const float3 _e14 = vec3_load(this_case.delta_x);
    const float3 _e16 = vec3_load(this_case.delta_y);
    Camera camera_2 = ConstructCamera(_e10, _e12, _e14, _e16);
    float2 offset_1 = float2(this_case.offset_x, this_case.offset_y);
    const Ray _e26 = camera_ray(camera_2, this_case.row, this_case.column, offset_1);
    const PackedRay _e27 = ray_store(_e26);
    {
        PackedRay _value2 = _e27;
        {
            PackedVec3_ _value3 = _value2.origin;
            results.Store(id.x*24+0+0, asuint(_value3.x));
            results.Store(id.x*24+0+4, asuint(_value3.y));
            results.Store(id.x*24+0+8, asuint(_value3.z));
        }
        {
            PackedVec3_ _value3 = _value2.direction;
            results.Store(id.x*24+12+0, asuint(_value3.x));
            results.Store(id.x*24+12+4, asuint(_value3.y));
            results.Store(id.x*24+12+8, asuint(_value3.z));
        }
    }
    return;
}
