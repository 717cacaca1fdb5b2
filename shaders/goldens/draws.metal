// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size0;
    uint size1;
};

typedef float real;
struct DrawCase {
    real low;
    real high;
    metal::uint2 word;
};
typedef DrawCase type_1[1];
typedef real type_2[1];
constant real SHORT_SQUARED = 0.0;
constant real SHORT_SCALE = 1.0;
constant real BELOW_ONE = 0.99999994;
constant real LEAST_SQUARED = 0.0;
constant real ERROR_UNDERFLOW = 0.0;
constant real ERROR_OVERFLOW = 300000000000000000000000000000000000000.0;
constant real SHORTEST_SQUARED = 0.0;
constant real LONGEST_SQUARED = 300000000000000000000000000000000000000.0;
constant real EXTENT_UNDERFLOW = 0.0;
constant real SPLITTER = 4097.0;
constant real SPLIT_LIMIT = 1000000000000000000000000000000000.0;
constant real SPLIT_SCALE = 0.000015258789;
constant real SPLIT_UNSCALE = 65536.0;
constant real UNWRITTEN = -0.00000000000000028735182;

real uniform_canonical(
    metal::uint2 word
) {
    float whole = (static_cast<float>(word.y) * 4294967300.0) + static_cast<float>(word.x);
    float quotient = whole / 18446744000000000000.0;
    return (quotient < BELOW_ONE) ? quotient : BELOW_ONE;
}

real uniform_draw(
    metal::uint2 word_1,
    real low,
    real high
) {
    real _e3 = uniform_canonical(word_1);
    return (_e3 * (high - low)) + low;
}

struct drawsInput {
};
kernel void draws(
  metal::uint3 id [[thread_position_in_grid]]
, device type_1 const& cases [[buffer(0)]]
, device type_2& results [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    if (id.x >= (1 + (_buffer_sizes.size0 - 0 - 16) / 16)) {
        return;
    }
    metal::uint2 _e12 = cases[id.x].word;
    real _e17 = cases[id.x].low;
    real _e22 = cases[id.x].high;
    real _e23 = uniform_draw(_e12, _e17, _e22);
    results[id.x] = _e23;
    return;
}
