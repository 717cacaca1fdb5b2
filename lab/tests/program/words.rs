//! Tests of the help of the program, and of its status for a wrong command line.

use crate::{complaint, printed, run};

#[test]
fn help_explains_files_and_commands() {
    assert!(printed(&["help", "config"]).contains("| `samples_per_pixel:`      | whole number > 0      | 20 "));
    assert!(printed(&["help", "scene"]).contains("| `cylinder:`   | x y z radius ax ay az material |"));
    assert!(printed(&["help", "bench", "scale"]).contains("Usage: render-lab bench scale"));
    assert!(printed(&["help"]).contains("Exit status:") && printed(&["--help"]).contains("  130  interrupted"));
    assert!(complaint(&["help", "nonsense"]).contains("invalid value 'nonsense' for '[TOPIC]'"));
    assert!(complaint(&["help", "bench", "nonsense"]).contains("no command or topic [nonsense]"));
}

#[test]
fn a_command_line_that_is_not_understood_has_status_2() {
    for arguments in [&[][..], &["paint"], &["render", "--fast"], &["render", "a", "b", "c", "--layout", "x"]] {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty() && !output.stderr.is_empty(), "{arguments:?}");
    }
}
