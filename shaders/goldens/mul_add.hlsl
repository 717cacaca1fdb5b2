struct ExactSum {
    float sum;
    float error;
};

struct ExactHalves {
    float high;
    float low;
};

struct MulAddCase {
    float a;
    float b;
    float c;
    float one;
};

struct MulAddReport {
    float product;
    float error;
    float mul_add;
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

static float exact_one = (float)0;
ByteAddressBuffer cases : register(t0);
RWByteAddressBuffer reports : register(u1);

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

ExactHalves ConstructExactHalves(float arg0, float arg1) {
    ExactHalves ret = (ExactHalves)0;
    ret.high = arg0;
    ret.low = arg1;
    return ret;
}

ExactHalves exact_halves(float a_1)
{
    float large = (a_1 * SPLITTER);
    float _e4 = exact_one;
    float high = ((large * _e4) - (large - a_1));
    const ExactHalves exacthalves = ConstructExactHalves(high, (a_1 - high));
    return exacthalves;
}

ExactSum exact_two_product(float a_2, float b_1)
{
    bool scales_a = (SPLIT_LIMIT < abs(a_2));
    bool scales_b = (SPLIT_LIMIT < abs(b_1));
    float x = (scales_a ? (a_2 * SPLIT_SCALE) : a_2);
    float y = (scales_b ? (b_1 * SPLIT_SCALE) : b_1);
    float product = (x * y);
    const ExactHalves _e15 = exact_halves(x);
    const ExactHalves _e16 = exact_halves(y);
    float error = (((((_e15.high * _e16.high) - product) + (_e15.high * _e16.low)) + (_e15.low * _e16.high)) + (_e15.low * _e16.low));
    float unscaled = (scales_a ? (error * SPLIT_UNSCALE) : error);
    const ExactSum exactsum_1 = ConstructExactSum((a_2 * b_1), (scales_b ? (unscaled * SPLIT_UNSCALE) : unscaled));
    return exactsum_1;
}

float exact_mul_add(float a_3, float b_2, float c)
{
    bool local = (bool)0;
    bool local_1 = (bool)0;
    bool local_2 = (bool)0;
    bool local_3 = (bool)0;

    const ExactSum _e3 = exact_two_product(a_3, b_2);
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

MulAddReport ConstructMulAddReport(float arg0, float arg1, float arg2) {
    MulAddReport ret = (MulAddReport)0;
    ret.product = arg0;
    ret.error = arg1;
    ret.mul_add = arg2;
    return ret;
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

MulAddCase ConstructMulAddCase(float arg0, float arg1, float arg2, float arg3) {
    MulAddCase ret = (MulAddCase)0;
    ret.a = arg0;
    ret.b = arg1;
    ret.c = arg2;
    ret.one = arg3;
    return ret;
}

[numthreads(64, 1, 1)]
void mul_add(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 16))) {
        return;
    }
    MulAddCase this_case = ConstructMulAddCase(asfloat(cases.Load(id.x*16+0)), asfloat(cases.Load(id.x*16+4)), asfloat(cases.Load(id.x*16+8)), asfloat(cases.Load(id.x*16+12)));
    exact_one = this_case.one;
    const ExactSum _e13 = exact_two_product(this_case.a, this_case.b);
    const float _e17 = exact_mul_add(this_case.a, this_case.b, this_case.c);
    {
        MulAddReport _value2 = ConstructMulAddReport(_e13.sum, _e13.error, _e17);
        reports.Store(id.x*12+0, asuint(_value2.product));
        reports.Store(id.x*12+4, asuint(_value2.error));
        reports.Store(id.x*12+8, asuint(_value2.mul_add));
    }
    return;
}
