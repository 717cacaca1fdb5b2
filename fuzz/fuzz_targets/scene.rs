//! libFuzzer's way into `hostile::scene`.

#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| hostile::scene::check(bytes));
