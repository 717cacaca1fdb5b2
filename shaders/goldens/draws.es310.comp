#version 310 es

precision highp float;
precision highp int;

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

struct DrawCase {
    float low;
    float high;
    uvec2 word;
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

layout(std430, binding = 0) readonly buffer type_1_block_0Compute { DrawCase _group_0_binding_0_cs[]; };

layout(std430, binding = 1) buffer type_2_block_1Compute { float _group_0_binding_1_cs[]; };


float uniform_canonical(uvec2 word) {
    float whole = ((float(word.y) * 4294967300.0) + float(word.x));
    float quotient = (whole / 1.8446744e19);
    return ((quotient < BELOW_ONE) ? quotient : BELOW_ONE);
}

float uniform_draw(uvec2 word_1, float low, float high) {
    float _e3 = uniform_canonical(word_1);
    return ((_e3 * (high - low)) + low);
}

void main() {
    uvec3 id = gl_GlobalInvocationID;
    if ((id.x >= uint(_group_0_binding_0_cs.length()))) {
        return;
    }
    uvec2 _e12 = _group_0_binding_0_cs[id.x].word;
    float _e17 = _group_0_binding_0_cs[id.x].low;
    float _e22 = _group_0_binding_0_cs[id.x].high;
    float _e23 = uniform_draw(_e12, _e17, _e22);
    _group_0_binding_1_cs[id.x] = _e23;
    return;
}

