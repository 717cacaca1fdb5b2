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

struct Accumulation {
    PackedVec3_ starts[2];
    uint first_sample;
    uint sample_count;
    uint samples_per_pixel;
    uint unused;
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

ByteAddressBuffer accumulation : register(t0);
ByteAddressBuffer samples : register(t1);
RWByteAddressBuffer means_of_pixels : register(u2);

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

uint NagaBufferLengthRW(RWByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

[numthreads(64, 1, 1)]
void means(uint3 id : SV_DispatchThreadID)
{
    float3 sum = (float3)0;
    uint sample_ = (uint)0;

    if ((id.x >= ((NagaBufferLengthRW(means_of_pixels) - 0) / 12))) {
        return;
    }
    uint _e8 = asuint(accumulation.Load(32));
    uint _e12 = asuint(accumulation.Load(24));
    uint begin = max((id.x * _e8), _e12);
    uint _e19 = asuint(accumulation.Load(32));
    uint pixel_end = ((id.x + 1u) * _e19);
    uint _e23 = asuint(accumulation.Load(24));
    uint _e26 = asuint(accumulation.Load(28));
    uint end = min(pixel_end, (_e23 + _e26));
    PackedVec3_ _e35 = ConstructPackedVec3_(asfloat(accumulation.Load(min(id.x, 1u)*12+0+0)), asfloat(accumulation.Load(min(id.x, 1u)*12+0+4)), asfloat(accumulation.Load(min(id.x, 1u)*12+0+8)));
    const float3 _e36 = vec3_load(_e35);
    sum = _e36;
    sample_ = begin;
    uint2 loop_bound = uint2(4294967295u, 4294967295u);
    bool loop_init = true;
    while(true) {
        if (all(loop_bound == uint2(0u, 0u))) { break; }
        loop_bound -= uint2(loop_bound.y == 0u, 1u);
        if (!loop_init) {
            uint _e54 = sample_;
            sample_ = (_e54 + 1u);
        }
        loop_init = false;
        uint _e39 = sample_;
        if ((_e39 < end)) {
        } else {
            break;
        }
        {
            float3 _e41 = sum;
            uint _e43 = sample_;
            uint _e46 = asuint(accumulation.Load(24));
            PackedVec3_ _e50 = ConstructPackedVec3_(asfloat(samples.Load(0+(_e43 - _e46)*20+0)), asfloat(samples.Load(0+(_e43 - _e46)*20+4)), asfloat(samples.Load(0+(_e43 - _e46)*20+8)));
            const float3 _e51 = vec3_load(_e50);
            sum = (_e41 + _e51);
        }
    }
    if ((end == pixel_end)) {
        float3 _e57 = sum;
        uint _e60 = asuint(accumulation.Load(32));
        sum = (_e57 / (float(_e60)).xxx);
    }
    float3 _e67 = sum;
    const PackedVec3_ _e68 = vec3_store(_e67);
    {
        PackedVec3_ _value2 = _e68;
        means_of_pixels.Store(id.x*12+0, asuint(_value2.x));
        means_of_pixels.Store(id.x*12+4, asuint(_value2.y));
        means_of_pixels.Store(id.x*12+8, asuint(_value2.z));
    }
    return;
}
