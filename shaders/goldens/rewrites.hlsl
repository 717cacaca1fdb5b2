struct RewriteCase {
    float x;
    float y;
    float z;
    float minus_zero;
    float not_a_number;
};

struct RewriteReport {
    float sum_less_term;
    float common_factor;
    float root_squared;
    float zero_added;
    float is_not_itself;
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

RewriteReport ConstructRewriteReport(float arg0, float arg1, float arg2, float arg3, float arg4) {
    RewriteReport ret = (RewriteReport)0;
    ret.sum_less_term = arg0;
    ret.common_factor = arg1;
    ret.root_squared = arg2;
    ret.zero_added = arg3;
    ret.is_not_itself = arg4;
    return ret;
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

[numthreads(64, 1, 1)]
void rewrites(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 20))) {
        return;
    }
    float x = asfloat(cases.Load(0+id.x*20));
    float y = asfloat(cases.Load(4+id.x*20));
    float z = asfloat(cases.Load(8+id.x*20));
    float root = sqrt(x);
    float _e25 = asfloat(cases.Load(12+id.x*20));
    float zero_added = (_e25 + 0.0);
    float _e34 = asfloat(cases.Load(16+id.x*20));
    float _e39 = asfloat(cases.Load(16+id.x*20));
    float is_not_itself = ((_e34 != _e39) ? 1.0 : 0.0);
    {
        RewriteReport _value2 = ConstructRewriteReport(((x + y) - x), ((x * y) + (x * z)), (root * root), zero_added, is_not_itself);
        reports.Store(id.x*20+0, asuint(_value2.sum_less_term));
        reports.Store(id.x*20+4, asuint(_value2.common_factor));
        reports.Store(id.x*20+8, asuint(_value2.root_squared));
        reports.Store(id.x*20+12, asuint(_value2.zero_added));
        reports.Store(id.x*20+16, asuint(_value2.is_not_itself));
    }
    return;
}
