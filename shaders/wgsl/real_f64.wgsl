// The number that all formulas are written over; twin of the parameter T in cpu/src/math/real.rs. In this composition:
// f64.
alias real = f64;

// Vectors with a smaller square are multiplied by SHORT_SCALE, its reciprocal, before they are normalised: 2^-600.
const SHORT_SQUARED: real = 2.409919865102884e-181lf;
const SHORT_SCALE: real = 4.149515568880993e180lf;
