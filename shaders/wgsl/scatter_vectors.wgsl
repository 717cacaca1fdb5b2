// The scatter vectors of surfaces, in both conventions with random numbers; twin of
// cpu/src/sampling/scatter_vectors.rs.

// The values of Picture.convention, one for each of these variants of cpu::Scatter.
const STATEMENT: u32 = 1u;
const PUBLISHED: u32 = 2u;

// The largest number of vectors that a scatter vector of the published pictures is chosen from. Each is rejected with a
// probability of 0.48, so this number is exceeded with a probability of 1e-32. The loop needs an end, because a wrong
// shader could read words that no vector in the ball comes from.
const MAX_TRIES: u32 = 100u;

// The words of one run: the samples' words, three entries for each sample, and then a part of the scatter stream.
// - entry 3 i: the word for the x offset of sample i in its pixel;
// - entry 3 i + 1: the word for its y offset;
// - entry 3 i + 2: in `x`, the index in this buffer of the first word of the sample's scatter vectors.
@group(0) @binding(7) var<storage, read> words: array<vec2<u32>>;

// Returns the word at `index`. An index behind the buffer counts from the first word of the scatter stream again. In
// f64 that does not happen; in f32 a path may take more words than the path in f64, from which the buffer is made.
fn scatter_word(index: u32) -> vec2<u32> {
    let first = 3u * picture.sample_count;
    return words[first + (index - first) % (arrayLength(&words) - first)];
}

// A scatter vector, and the index of the word after those that it took.
struct ScatterVector {
    vector: vec3<real>,
    next_word: u32,
}

// Returns a random vector in the cube with sides of 2 `half` around the origin, from three words: x, then y, then z.
fn scatter_vector_in_cube(word: u32, half: real) -> vec3<real> {
    return vec3<real>(
        uniform_draw(scatter_word(word), -half, half),
        uniform_draw(scatter_word(word + 1u), -half, half),
        uniform_draw(scatter_word(word + 2u), -half, half),
    );
}

// ScatterVectors::next: returns the scatter vector whose first word is at `word`. `extent` is Material.extent.
fn scatter_vector_next(word: u32, extent: real) -> ScatterVector {
    if picture.convention == STATEMENT {
        return ScatterVector(scatter_vector_in_cube(word, extent), word + 3u);
    }
    return scatter_vector_published(word, extent);
}

// unit_vector: returns the first vector of the cube that lies in the unit ball and not too close to its centre, scaled
// to the length `extent`.
fn scatter_vector_published(word: u32, extent: real) -> ScatterVector {
    var next = word;
    for (var tries = 0u; tries < MAX_TRIES; tries++) {
        let vector = scatter_vector_in_cube(next, real(1.0));
        let length_squared = vec3_dot(vector, vector);
        next += 3u;
        if LEAST_SQUARED < length_squared && length_squared <= real(1.0) {
            return ScatterVector(vector / sqrt(length_squared) * extent, next);
        }
    }
    return ScatterVector(vec3<real>(), next);
}
