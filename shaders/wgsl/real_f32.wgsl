// The number type of all formulas, here f32; twin of the parameter T in cpu/src/math/real.rs.
alias real = f32;

// No square is less than zero, so vectors are never scaled before they are normalised.
const SHORT_SQUARED: real = 0.0;
const SHORT_SCALE: real = 1.0;
