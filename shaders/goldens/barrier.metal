// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size0;
    uint size1;
};

typedef float real;
struct ExactSum {
    real sum;
    real error;
};
struct BarrierCase {
    real a;
    real b;
    real one;
};
typedef BarrierCase type[1];
typedef ExactSum type_1[1];
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

ExactSum exact_two_sum(
    real a,
    real b,
    real one
) {
    real sum = (a * one) + b;
    real b_part = sum - a;
    real a_part = sum - b_part;
    return ExactSum {sum, (a - a_part) + (b - b_part)};
}

struct barrierInput {
};
kernel void barrier(
  metal::uint3 id [[thread_position_in_grid]]
, device type const& cases [[buffer(0)]]
, device type_1& results [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    if (id.x >= (1 + (_buffer_sizes.size0 - 0 - 12) / 12)) {
        return;
    }
    BarrierCase this_case = cases[id.x];
    ExactSum _e15 = exact_two_sum(this_case.a, this_case.b, this_case.one);
    results[id.x] = _e15;
    return;
}
