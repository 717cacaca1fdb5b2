// Each invocation converts one word of a generator to a number in [low, high).

struct DrawCase {
    low: real,
    high: real,
    word: vec2<u32>,
}

@group(0) @binding(0) var<storage, read> cases: array<DrawCase>;
@group(0) @binding(1) var<storage, read_write> results: array<real>;

@compute @workgroup_size(64)
fn draws(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&cases) {
        return;
    }
    results[id.x] = uniform_draw(cases[id.x].word, cases[id.x].low, cases[id.x].high);
}
