// The number type of all formulas, here f32; twin of the parameter T in cpu/src/math/real.rs.
alias real = f32;

// No square is less than zero, so vectors are never scaled before they are normalised.
const SHORT_SQUARED: real = 0.0;
const SHORT_SCALE: real = 1.0;

// The largest number below 1. A random number that rounds to 1 becomes this number.
const BELOW_ONE: real = 0x1.fffffep-1;
// A scatter vector of the published pictures has a square above this number: 1e-160, rounded to f32.
const LEAST_SQUARED: real = 0.0;
// The limits of the exact intersections (exact/error_bound.wgsl). Only the f64 values have a proof. In f32 nothing is
// out of scale, and nothing is added against underflow.
const ERROR_UNDERFLOW: real = 0.0;
const ERROR_OVERFLOW: real = 3e38;
const SHORTEST_SQUARED: real = 0.0;
const LONGEST_SQUARED: real = 3e38;
const EXTENT_UNDERFLOW: real = 0.0;
const LEAST_SIZE: real = 0.0;
// The factor that splits a number of 24 bits into two halves, 2^12 + 1 (exact/error_free.wgsl). Numbers above
// SPLIT_LIMIT are multiplied by SPLIT_SCALE = 2^-16 first, because the product would overflow.
const SPLITTER: real = 4097.0;
const SPLIT_LIMIT: real = 1e33;
const SPLIT_SCALE: real = 1.52587890625e-5;
const SPLIT_UNSCALE: real = 65536.0;

// The number whose bytes are all 0xA5. An output holds these bytes until a kernel writes it (gpu_check::pipeline).
const UNWRITTEN: real = -2.8735182454018313e-16;
