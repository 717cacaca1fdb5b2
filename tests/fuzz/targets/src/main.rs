//! The libFuzzer program of every target. Cargo builds it once for each, and its name says which target it calls.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz_oracles::check(env!("CARGO_BIN_NAME"), bytes));
