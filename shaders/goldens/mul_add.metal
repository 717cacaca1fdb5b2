// language: metal2.0
#include <metal_stdlib>
#include <simd/simd.h>

using metal::uint;

struct _mslBufferSizes {
    uint size1;
    uint size2;
};

typedef float real;
struct ExactSum {
    real sum;
    real error;
};
struct ExactHalves {
    real high;
    real low;
};
struct MulAddCase {
    real a;
    real b;
    real c;
    real one;
};
struct MulAddReport {
    real product;
    real error;
    real mul_add;
};
typedef MulAddCase type_1[1];
typedef MulAddReport type_2[1];
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

ExactHalves exact_halves(
    real a_1,
    thread real& exact_one
) {
    real large = a_1 * SPLITTER;
    real _e4 = exact_one;
    real high = (large * _e4) - (large - a_1);
    return ExactHalves {high, a_1 - high};
}

ExactSum exact_two_product(
    real a_2,
    real b_1,
    thread real& exact_one
) {
    bool scales_a = SPLIT_LIMIT < metal::abs(a_2);
    bool scales_b = SPLIT_LIMIT < metal::abs(b_1);
    real x = scales_a ? (a_2 * SPLIT_SCALE) : a_2;
    real y = scales_b ? (b_1 * SPLIT_SCALE) : b_1;
    real product = x * y;
    ExactHalves _e15 = exact_halves(x, exact_one);
    ExactHalves _e16 = exact_halves(y, exact_one);
    real error = ((((_e15.high * _e16.high) - product) + (_e15.high * _e16.low)) + (_e15.low * _e16.high)) + (_e15.low * _e16.low);
    real unscaled = scales_a ? (error * SPLIT_UNSCALE) : error;
    return ExactSum {a_2 * b_1, scales_b ? (unscaled * SPLIT_UNSCALE) : unscaled};
}

real exact_mul_add(
    real a_3,
    real b_2,
    real c,
    thread real& exact_one
) {
    bool local = {};
    bool local_1 = {};
    bool local_2 = {};
    bool local_3 = {};
    ExactSum _e3 = exact_two_product(a_3, b_2, exact_one);
    real _e6 = exact_one;
    ExactSum _e7 = exact_two_sum(c, _e3.error, _e6);
    real _e11 = exact_one;
    ExactSum _e12 = exact_two_sum(_e3.sum, _e7.sum, _e11);
    real _e16 = exact_one;
    ExactSum _e17 = exact_two_sum(_e7.error, _e12.error, _e16);
    real _e21 = exact_one;
    ExactSum _e22 = exact_two_sum(_e12.sum, _e17.sum, _e21);
    real _e25 = exact_one;
    real neighbor = (_e22.sum * _e25) + (_e22.error * 1.5);
    bool is_tie = (_e22.error + _e22.error) == (neighbor - _e22.sum);
    if (0.0 < _e22.error) {
        local = 0.0 < _e17.error;
    } else {
        local = false;
    }
    bool _e45 = local;
    if (!(_e45)) {
        if (_e22.error < 0.0) {
            local_2 = _e17.error < 0.0;
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
    return _e63 ? neighbor : _e22.sum;
}

struct mul_addInput {
};
kernel void mul_add(
  metal::uint3 id [[thread_position_in_grid]]
, device type_1 const& cases [[buffer(0)]]
, device type_2& reports [[buffer(1)]]
, constant _mslBufferSizes& _buffer_sizes [[buffer(2)]]
) {
    real exact_one = {};
    if (id.x >= (1 + (_buffer_sizes.size1 - 0 - 16) / 16)) {
        return;
    }
    MulAddCase this_case = cases[id.x];
    exact_one = this_case.one;
    ExactSum _e13 = exact_two_product(this_case.a, this_case.b, exact_one);
    real _e17 = exact_mul_add(this_case.a, this_case.b, this_case.c, exact_one);
    reports[id.x] = MulAddReport {_e13.sum, _e13.error, _e17};
    return;
}
