//! Runs the program `lower-f64` as a user does.

use std::process::{Command, Output};

use test_support::folder::Folder;

const GOOD: &str = "@group(0) @binding(0) var<storage, read_write> x: f64;\n\
    @compute @workgroup_size(1) fn main() { x = x + x; }\n";

/// Returns a module that makes naga store and compare arrays of `count` elements.
fn huge(count: usize) -> String {
    let line = |name| format!("const {name} = array<u32, {count}>() == array<u32, {count}>();\n");
    ["a", "b", "c"].map(line).concat()
}

fn lower(folder: &Folder, name: &str, text: &str) -> Output {
    folder.write(name, text);
    let mut command = Command::new(env!("CARGO_BIN_EXE_lower-f64"));
    command.current_dir(folder).arg(name).output().expect("the program starts")
}

/// Returns the message of an error.
fn fault(output: &Output) -> String {
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(output.stdout.is_empty(), "{output:?}");
    String::from_utf8(output.stderr.clone()).expect("it is text")
}

#[test]
fn a_module_is_lowered_and_an_error_has_its_place() {
    let folder = Folder::new();
    let output = lower(&folder, "good.wgsl", GOOD);
    assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
    let text = String::from_utf8(output.stdout).expect("it is text");
    assert!(text.contains("f64_add(") && !text.contains(": f64"), "{text}");
    let text = "\n\nvar<private> m: mat2x2<f64>;\n";
    let message = fault(&lower(&folder, "bad.wgsl", text));
    assert!(message.starts_with("Error: bad.wgsl:3:1: a matrix of f64 cannot be lowered to integers\n"), "{message}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_module_that_takes_too_much_is_refused_and_a_smaller_one_is_not() {
    let folder = Folder::new();
    // The separate process keeps a limit that is lower than its own. Without one this module takes 4 GiB.
    let limited = |name: &str, text: String| {
        folder.write(name, text);
        let mut shell = test_support::running::bash();
        shell.args(["-c", "ulimit -v 800000; exec \"$@\"", "limited", env!("CARGO_BIN_EXE_lower-f64"), name]);
        shell.current_dir(folder.path()).output().expect("the shell starts")
    };
    let message = fault(&limited("huge.wgsl", huge(500_000_000)));
    assert!(message.starts_with("Error: huge.wgsl: the module takes too much to lower: naga ended by "), "{message}");
    assert!(message.contains("at most 4096 MiB of memory and 20 s are allowed; simplify it"), "{message}");
    // naga refuses the comparison of arrays, but in the limits.
    let message = fault(&limited("small.wgsl", huge(1000)));
    assert!(message.starts_with("Error: small.wgsl:1:"), "{message}");
}

#[cfg(unix)]
#[test]
fn no_message_can_control_a_terminal() {
    let folder = Folder::new();
    let name = "red\u{1b}[31m\n.wgsl";
    let message = fault(&lower(&folder, name, "\u{1b}[2J"));
    assert!(message.starts_with("Error: red\\u{1b}[31m\\n.wgsl:1:1: "), "{message}");
    assert!(!message.contains('\u{1b}'), "{message}");
    let missing = fault(&Command::new(env!("CARGO_BIN_EXE_lower-f64")).arg("\u{1b}c").output().expect("it starts"));
    assert!(missing.starts_with("Error: \\u{1b}c: No such file"), "{missing}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_standard_output_that_cannot_be_written_is_an_error() {
    let folder = Folder::new();
    folder.write("good.wgsl", GOOD);
    for (redirection, reason) in [(">&-", "standard output is closed"), (">/dev/full", "No space left on device")] {
        let mut shell = Command::new("sh");
        shell.args(["-c", &format!("\"$1\" good.wgsl {redirection}"), "sh", env!("CARGO_BIN_EXE_lower-f64")]);
        let message = fault(&shell.current_dir(folder.path()).output().expect("the shell starts"));
        assert!(
            message.starts_with("Error: Cannot write file [/dev/stdout]: ") && message.contains(reason),
            "{message}"
        );
    }
}
