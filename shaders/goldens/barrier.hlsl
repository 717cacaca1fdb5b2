struct ExactSum {
    float sum;
    float error;
};

struct BarrierCase {
    float a;
    float b;
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

ByteAddressBuffer cases : register(t0);
RWByteAddressBuffer results : register(u1);

ExactSum ConstructExactSum(float arg0, float arg1) {
    ExactSum ret = (ExactSum)0;
    ret.sum = arg0;
    ret.error = arg1;
    return ret;
}

ExactSum exact_two_sum(float a, float b, float one)
{
    float sum = ((a * one) + b);
    float b_part = (sum - a);
    float a_part = (sum - b_part);
    const ExactSum exactsum = ConstructExactSum(sum, ((a - a_part) + (b - b_part)));
    return exactsum;
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

BarrierCase ConstructBarrierCase(float arg0, float arg1, float arg2) {
    BarrierCase ret = (BarrierCase)0;
    ret.a = arg0;
    ret.b = arg1;
    ret.one = arg2;
    return ret;
}

[numthreads(64, 1, 1)]
void barrier(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 12))) {
        return;
    }
    BarrierCase this_case = ConstructBarrierCase(asfloat(cases.Load(id.x*12+0)), asfloat(cases.Load(id.x*12+4)), asfloat(cases.Load(id.x*12+8)));
    const ExactSum _e15 = exact_two_sum(this_case.a, this_case.b, this_case.one);
    {
        ExactSum _value2 = _e15;
        results.Store(id.x*8+0, asuint(_value2.sum));
        results.Store(id.x*8+4, asuint(_value2.error));
    }
    return;
}
