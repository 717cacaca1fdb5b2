//! Tests of the scripts of `render-lab completions`. Each script is run by its own shell.

use std::fs;
use std::process::Command;

use test_support::folder::Folder;

use crate::printed;

/// Whether the shell is installed. If it is not, this function prints a line, and the test that needs the shell checks
/// nothing.
fn is_there(shell: &str) -> bool {
    let found = Command::new(shell).arg("--version").output().is_ok();
    if !found {
        println!("there is no {shell}, so its script was not run");
    }
    found
}

/// Runs the commands `text` in a shell, and returns what it prints. `$SCRIPT` is the path of the completion script.
fn said(shell: &str, arguments: &[&str], text: &str) -> String {
    let folder = Folder::new();
    let script = folder.file("_render-lab");
    fs::write(&script, printed(&["completions", shell])).expect("the folder is writable");
    let output =
        Command::new(shell).args(arguments).args(["-c", text]).env("SCRIPT", &script).output().expect("the shell runs");
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).expect("it is text")
}

#[test]
fn bash_completes_commands_options_and_values_at_every_level() {
    let complete = |words: &[&str]| {
        let (last, before) = (words[words.len() - 1], words[words.len() - 2]);
        let text = format!(
            "source \"$SCRIPT\"; COMP_WORDS=({}); COMP_CWORD={}; _render__lab render-lab '{last}' '{before}'; \
             printf '%s\\n' \"${{COMPREPLY[@]}}\"",
            words.join(" "),
            words.len() - 1
        );
        said("bash", &[], &text).lines().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(complete(&["render-lab", "rend"]), ["render"]);
    assert_eq!(complete(&["render-lab", "render", "--sc"]), ["--scatter"]);
    assert_eq!(complete(&["render-lab", "render", "--layout", "s"]), ["soa"]);
    assert_eq!(complete(&["render-lab", "bench", "sc"]), ["scale"]);
    assert_eq!(complete(&["render-lab", "bench", "scale", "--rep"]), ["--repeats"]);
}

#[test]
fn zsh_takes_its_script_and_knows_the_options_of_a_command() {
    if !is_there("zsh") {
        return;
    }
    // zsh's function `_arguments` needs a terminal. The test defines another `_arguments`, which prints its arguments,
    // and sets the first word to `render`.
    let text = "compdef() { :; }; _arguments() { print -l -- \"$@\"; state=render-lab; line=(render); }; \
                words=(render-lab render --sc); CURRENT=3; source \"$SCRIPT\"; _render-lab";
    let said = said("zsh", &["-f"], text);
    assert!(said.contains("--scatter=[How surfaces scatter light]"), "{said}");
}

#[test]
fn fish_completes_options_of_a_command() {
    if !is_there("fish") {
        return;
    }
    let text = "source $SCRIPT; complete -C 'render-lab render --sc'; complete -C 'render-lab bench sc'";
    let said = said("fish", &["--no-config"], text);
    assert!(said.contains("--scatter\t") && said.contains("scale\t"), "{said}");
}
