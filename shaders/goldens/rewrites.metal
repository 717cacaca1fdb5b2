// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size0;
    uint size1;
};

typedef float real;
struct RewriteCase {
    real x;
    real y;
    real z;
    real minus_zero;
    real not_a_number;
};
struct RewriteReport {
    real sum_less_term;
    real common_factor;
    real root_squared;
    real zero_added;
    real is_not_itself;
};
typedef RewriteCase type[1];
typedef RewriteReport type_1[1];
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

struct rewritesInput {
};
kernel void rewrites(
  metal::uint3 id [[thread_position_in_grid]]
, device type const& cases [[buffer(0)]]
, device type_1& reports [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    if (id.x >= (1 + (_buffer_sizes.size0 - 0 - 20) / 20)) {
        return;
    }
    real x = cases[id.x].x;
    real y = cases[id.x].y;
    real z = cases[id.x].z;
    float root = metal::sqrt(x);
    real _e25 = cases[id.x].minus_zero;
    real zero_added = _e25 + 0.0;
    real _e34 = cases[id.x].not_a_number;
    real _e39 = cases[id.x].not_a_number;
    float is_not_itself = (_e34 != _e39) ? 1.0 : 0.0;
    reports[id.x] = RewriteReport {(x + y) - x, (x * y) + (x * z), root * root, zero_added, is_not_itself};
    return;
}
