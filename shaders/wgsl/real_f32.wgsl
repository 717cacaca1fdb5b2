// The number that all formulas are written over; twin of the parameter T in cpu/src/math/real.rs. In this composition:
// f32.
alias real = f32;

// No square is smaller: vectors are never scaled before they are normalised.
const SHORT_SQUARED: real = 0.0;
const SHORT_SCALE: real = 1.0;
