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
};
struct RewriteReport {
    real sum_less_term;
    real common_factor;
    real root_squared;
};
typedef RewriteCase type[1];
typedef RewriteReport type_1[1];

struct rewritesInput {
};
kernel void rewrites(
  metal::uint3 id [[thread_position_in_grid]]
, device type const& cases [[buffer(0)]]
, device type_1& reports [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    if (id.x >= (1 + (_buffer_sizes.size0 - 0 - 12) / 12)) {
        return;
    }
    real x = cases[id.x].x;
    real y = cases[id.x].y;
    real z = cases[id.x].z;
    float root = metal::sqrt(x);
    reports[id.x] = RewriteReport {(x + y) - x, (x * y) + (x * z), root * root};
    return;
}
