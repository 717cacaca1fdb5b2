struct RewriteCase {
    float x;
    float y;
    float z;
};

struct RewriteReport {
    float sum_less_term;
    float common_factor;
    float root_squared;
};

ByteAddressBuffer cases : register(t0);
RWByteAddressBuffer reports : register(u1);

RewriteReport ConstructRewriteReport(float arg0, float arg1, float arg2) {
    RewriteReport ret = (RewriteReport)0;
    ret.sum_less_term = arg0;
    ret.common_factor = arg1;
    ret.root_squared = arg2;
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
    if ((id.x >= ((NagaBufferLength(cases) - 0) / 12))) {
        return;
    }
    float x = asfloat(cases.Load(0+id.x*12));
    float y = asfloat(cases.Load(4+id.x*12));
    float z = asfloat(cases.Load(8+id.x*12));
    float root = sqrt(x);
    {
        RewriteReport _value2 = ConstructRewriteReport(((x + y) - x), ((x * y) + (x * z)), (root * root));
        reports.Store(id.x*12+0, asuint(_value2.sum_less_term));
        reports.Store(id.x*12+4, asuint(_value2.common_factor));
        reports.Store(id.x*12+8, asuint(_value2.root_squared));
    }
    return;
}
