// The number type of all formulas, here f32; twin of the parameter T in cpu/src/math/real.rs.
alias real = f32;

// No square is less than zero, so vectors are never scaled before they are normalised.
const SHORT_SQUARED: real = 0.0;
const SHORT_SCALE: real = 1.0;

// The largest number below 1. A random number that rounds to 1 becomes this number.
const BELOW_ONE: real = 0x1.fffffep-1;
// A scatter vector of the published pictures has a square above this number: 1e-160, rounded to f32.
const LEAST_SQUARED: real = 0.0;
