#version 430 core
#extension GL_ARB_compute_shader : require
#extension GL_ARB_shader_storage_buffer_object : require
layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

struct ExactSum {
    float sum;
    float error;
};
struct BarrierCase {
    float a;
    float b;
    float one;
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

layout(std430, binding = 0) readonly buffer type_block_0Compute { BarrierCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_1_block_1Compute { ExactSum _group_0_binding_1_cs[]; };


ExactSum exact_two_sum(float a, float b, float one) {
    float sum = ((a * one) + b);
    float b_part = (sum - a);
    float a_part = (sum - b_part);
    return ExactSum(sum, ((a - a_part) + (b - b_part)));
}

void main() {
    uvec3 id = gl_GlobalInvocationID;
    if ((id.x >= uint(_group_0_binding_0_cs.length()))) {
        return;
    }
    BarrierCase this_case = _group_0_binding_0_cs[id.x];
    ExactSum _e15 = exact_two_sum(this_case.a, this_case.b, this_case.one);
    _group_0_binding_1_cs[id.x] = _e15;
    return;
}

