//! libFuzzer's way into `hostile::picture`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| hostile::picture::check(bytes));
