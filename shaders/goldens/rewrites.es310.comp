#version 310 es

precision highp float;
precision highp int;

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

struct RewriteCase {
    float x;
    float y;
    float z;
    float minus_zero;
    float not_a_number;
};
struct RewriteReport {
    float sum_less_term;
    float common_factor;
    float root_squared;
    float zero_added;
    float is_not_itself;
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

layout(std430, binding = 0) readonly buffer type_block_0Compute { RewriteCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_1_block_1Compute { RewriteReport _group_0_binding_1_cs[]; };


void main() {
    uvec3 id = gl_GlobalInvocationID;
    if ((id.x >= uint(_group_0_binding_0_cs.length()))) {
        return;
    }
    float x = _group_0_binding_0_cs[id.x].x;
    float y = _group_0_binding_0_cs[id.x].y;
    float z = _group_0_binding_0_cs[id.x].z;
    float root = sqrt(x);
    float _e25 = _group_0_binding_0_cs[id.x].minus_zero;
    float zero_added = (_e25 + 0.0);
    float _e34 = _group_0_binding_0_cs[id.x].not_a_number;
    float _e39 = _group_0_binding_0_cs[id.x].not_a_number;
    float is_not_itself = ((_e34 != _e39) ? 1.0 : 0.0);
    _group_0_binding_1_cs[id.x] = RewriteReport(((x + y) - x), ((x * y) + (x * z)), (root * root), zero_added, is_not_itself);
    return;
}

