//! Deliberate errors of the arithmetic.
