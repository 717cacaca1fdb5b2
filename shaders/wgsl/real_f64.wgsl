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
