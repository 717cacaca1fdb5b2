// Normalises vectors that may be short; twin of Vec3::unit_and_length in cpu/src/math/vec3.rs. It has its own file,
// because only cylinders need it.

// The result of Vec3::unit_and_length.
struct UnitAndLength {
    direction: vec3<real>,
    length: real,
}

// Vec3::unit_and_length: returns the vector of length one in the same direction, and the length, for short vectors too.
// The square of a vector shorter than 2^-300 may underflow in f64, so it is multiplied by 2^600 first. In f32 nothing
// is that short.
fn vec3_unit_and_length(v: vec3<real>) -> UnitAndLength {
    if vec3_dot(v, v) < SHORT_SQUARED {
        let scaled = v * SHORT_SCALE;
        let length = vec3_length(scaled);
        return UnitAndLength(scaled / length, length * SHORT_SQUARED);
    }
    let length = vec3_length(v);
    return UnitAndLength(v / length, length);
}
