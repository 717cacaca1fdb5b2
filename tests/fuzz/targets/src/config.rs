//! The libFuzzer program that calls `fuzz_oracles::config::check`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzz_oracles::config::check(bytes));
