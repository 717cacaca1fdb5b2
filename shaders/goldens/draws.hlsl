struct DrawCase {
    float low;
    float high;
    uint2 word;
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

float uniform_canonical(uint2 word)
{
    float whole = ((float(word.y) * 4294967300.0) + float(word.x));
    float quotient = (whole / 1.8446744e19);
    return ((quotient < BELOW_ONE) ? quotient : BELOW_ONE);
}

float uniform_draw(uint2 word_1, float low, float high)
{
    const float _e3 = uniform_canonical(word_1);
    return ((_e3 * (high - low)) + low);
}

uint NagaBufferLength(ByteAddressBuffer buffer)
{
    uint ret;
    buffer.GetDimensions(ret);
    return ret;
}

[numthreads(64, 1, 1)]
void draws(uint3 id : SV_DispatchThreadID)
{
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 16))) {
        return;
    }
    uint2 _e12 = asuint(cases.Load2(8+id.x*16));
    float _e17 = asfloat(cases.Load(0+id.x*16));
    float _e22 = asfloat(cases.Load(4+id.x*16));
    const float _e23 = uniform_draw(_e12, _e17, _e22);
    results.Store(id.x*4, asuint(_e23));
    return;
}
