// The number that all formulas are written over; twin of the parameter T in cpu/src/real.rs. In this composition: f64.
alias real = f64;
