//! Tests of the help of the program, and of its status for a wrong command line.

use crate::{complaint, printed, run};

#[test]
fn help_tells_exit_statuses_and_examples() {
    let help = printed(&["--help"]);
    assert!(help.contains("Exit status:") && help.contains("130"), "{help}");
    for command in ["render", "compare", "inspect", "generate", "completions", "man"] {
        assert!(printed(&[command, "--help"]).contains("Examples:\n  render-lab "), "{command}");
    }
}

#[test]
fn help_explains_files_and_commands() {
    assert!(printed(&["help", "config"]).contains("| `samples_per_pixel:`      | whole number > 0      | 20 "));
    assert!(printed(&["help", "scene"]).contains("| `cylinder:`   | x y z radius ax ay az material |"));
    assert!(printed(&["help", "bench", "scale"]).contains("Usage: render-lab bench scale"));
    assert!(printed(&["help"]).contains("Exit status:"));
    assert!(complaint(&["help", "nonsense"]).contains("no command or topic [nonsense]"));
}

#[test]
fn a_command_line_that_is_not_understood_has_status_2() {
    for arguments in [&[][..], &["paint"], &["render", "--fast"], &["render", "a", "b", "c", "--layout", "x"]] {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{arguments:?}");
    }
}
