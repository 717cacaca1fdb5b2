#version 310 es

precision highp float;
precision highp int;

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

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
const float SHORT_SQUARED = 0.0;
const float SHORT_SCALE = 1.0;
const float BELOW_ONE = 0.99999994;
const float LEAST_SQUARED = 0.0;
const float ERROR_UNDERFLOW = 0.0;
const float ERROR_OVERFLOW = 3e38;
const float SHORTEST_SQUARED = 0.0;
const float LONGEST_SQUARED = 3e38;
const float EXTENT_UNDERFLOW = 0.0;
const float SPLITTER = 4097.0;
const float SPLIT_LIMIT = 1e33;
const float SPLIT_SCALE = 1.5258789e-5;
const float SPLIT_UNSCALE = 65536.0;
const float UNWRITTEN = -2.8735182e-16;

float exact_one = 0.0;

layout(std430, binding = 0) readonly buffer type_1_block_0Compute { MulAddCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_2_block_1Compute { MulAddReport _group_0_binding_1_cs[]; };


ExactSum exact_two_sum(float a, float b, float one) {
    float sum = ((a * one) + b);
    float b_part = (sum - a);
    float a_part = (sum - b_part);
    return ExactSum(sum, ((a - a_part) + (b - b_part)));
}

ExactHalves exact_halves(float a_1) {
    float large = (a_1 * SPLITTER);
    float _e4 = exact_one;
    float high = ((large * _e4) - (large - a_1));
    return ExactHalves(high, (a_1 - high));
}

ExactSum exact_two_product(float a_2, float b_1) {
    bool scales_a = (SPLIT_LIMIT < abs(a_2));
    bool scales_b = (SPLIT_LIMIT < abs(b_1));
    float x = (scales_a ? (a_2 * SPLIT_SCALE) : a_2);
    float y = (scales_b ? (b_1 * SPLIT_SCALE) : b_1);
    float product = (x * y);
    ExactHalves _e15 = exact_halves(x);
    ExactHalves _e16 = exact_halves(y);
    float error = (((((_e15.high * _e16.high) - product) + (_e15.high * _e16.low)) + (_e15.low * _e16.high)) + (_e15.low * _e16.low));
    float unscaled = (scales_a ? (error * SPLIT_UNSCALE) : error);
    return ExactSum((a_2 * b_1), (scales_b ? (unscaled * SPLIT_UNSCALE) : unscaled));
}

float exact_mul_add(float a_3, float b_2, float c) {
    bool local = false;
    bool local_1 = false;
    bool local_2 = false;
    bool local_3 = false;
    ExactSum _e3 = exact_two_product(a_3, b_2);
    float _e6 = exact_one;
    ExactSum _e7 = exact_two_sum(c, _e3.error, _e6);
    float _e11 = exact_one;
    ExactSum _e12 = exact_two_sum(_e3.sum, _e7.sum, _e11);
    float _e16 = exact_one;
    ExactSum _e17 = exact_two_sum(_e7.error, _e12.error, _e16);
    float _e21 = exact_one;
    ExactSum _e22 = exact_two_sum(_e12.sum, _e17.sum, _e21);
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

void main() {
    uvec3 id = gl_GlobalInvocationID;
    if ((id.x >= uint(_group_0_binding_0_cs.length()))) {
        return;
    }
    MulAddCase this_case = _group_0_binding_0_cs[id.x];
    exact_one = this_case.one;
    ExactSum _e13 = exact_two_product(this_case.a, this_case.b);
    float _e17 = exact_mul_add(this_case.a, this_case.b, this_case.c);
    _group_0_binding_1_cs[id.x] = MulAddReport(_e13.sum, _e13.error, _e17);
    return;
}

