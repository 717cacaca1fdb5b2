//! Tests that recorded calls are counted as they must be named.

use super::*;

#[test]
fn calls_are_counted_by_thread_from_the_first_that_names_the_output() {
    let text =
        "7 openat(1, \"c\") = 3\n8 openat(1, \"x\") = 3\n7 brk(0) = 1\n7 openat(1, \"d/out\") = 3\n8 close(3) = 0\n";
    let found = |only_folder| -> Vec<_> {
        calls::calls(text, "d/out", only_folder).into_iter().map(|call| (call.name, call.number)).collect()
    };
    assert_eq!(found(false), [("openat".to_owned(), 2), ("close".to_owned(), 1)]);
    assert_eq!(found(true), [("openat".to_owned(), 2)]);
}

#[test]
fn a_call_that_two_threads_make_is_left_out_and_one_thread_needs_no_number() {
    let text = "7 close(1) = 0\n8 write(1, \"d/out\") = 3\n8 close(3) = 0\n8 close(4) = 0\n";
    let found: Vec<_> = calls::calls(text, "d/out", false).into_iter().map(|call| (call.name, call.number)).collect();
    assert_eq!(found, [("write".to_owned(), 1), ("close".to_owned(), 2)]);
    let found = calls::calls("write(1</d/out>, \"\", 0) = 0\nclose(1</d/out>) = 0\n", "d/out", false);
    assert_eq!(found.len(), 2);
}
