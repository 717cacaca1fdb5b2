// The number type of all formulas, here f64; twin of the parameter T in cpu/src/math/real.rs.
alias real = f64;

// A vector whose square is less than SHORT_SQUARED = 2^-600 is multiplied by SHORT_SCALE = 2^600 before it is
// normalised.
const SHORT_SQUARED: real = 2.409919865102884e-181lf;
const SHORT_SCALE: real = 4.149515568880993e180lf;

// The largest number below 1. A random number that rounds to 1 becomes this number.
const BELOW_ONE: real = 0x1.fffffffffffffp-1lf;
// A scatter vector of the published pictures has a square above this number.
const LEAST_SQUARED: real = 1e-160lf;
// The limits of the exact intersections (exact/error_bound.wgsl): 2^-600, 2^1000, 2^-300, 2^300, 2^-300 and 2^-350.
const ERROR_UNDERFLOW: real = 2.409919865102884e-181lf;
const ERROR_OVERFLOW: real = 1.0715086071862673e301lf;
const SHORTEST_SQUARED: real = 4.909093465297727e-91lf;
const LONGEST_SQUARED: real = 2.037035976334486e90lf;
const EXTENT_UNDERFLOW: real = 4.909093465297727e-91lf;
const LEAST_SIZE: real = 4.3601508761683463e-106lf;
// The factor that splits a number of 53 bits into two halves, 2^27 + 1 (exact/error_free.wgsl). Numbers above
// SPLIT_LIMIT = 2^960 are multiplied by SPLIT_SCALE = 2^-64 first, because the product would overflow.
const SPLITTER: real = 134217729.0lf;
const SPLIT_LIMIT: real = 9.7453140114e288lf;
const SPLIT_SCALE: real = 5.421010862427522e-20lf;
const SPLIT_UNSCALE: real = 1.8446744073709552e19lf;

// The number whose bytes are all 0xA5. An output holds these bytes until a kernel writes it (gpu_check::pipeline).
const UNWRITTEN: real = -2.4983353906949635e-127lf;
