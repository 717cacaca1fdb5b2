//! Tests of the help of the program, and of its status for a wrong command line.

use crate::{complaint, printed};

#[test]
fn help_explains_files_and_commands() {
    assert!(printed(&["help", "config"]).contains("| `samples_per_pixel:`      | whole number > 0      | 20 "));
    assert!(printed(&["help", "scene"]).contains("| `cylinder:`   | x y z radius ax ay az material |"));
    assert!(printed(&["help", "bench", "scale"]).contains("Usage: render-lab bench scale"));
    assert!(printed(&["help"]).contains("Exit status:") && printed(&["--help"]).contains("  130  interrupted"));
    assert!(complaint(&["help", "nonsense"]).contains("invalid value 'nonsense' for '[TOPIC]'"));
    assert!(complaint(&["help", "bench", "nonsense"]).contains("no command or topic [nonsense]"));
}
