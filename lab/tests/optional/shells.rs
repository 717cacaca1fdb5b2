//! The scripts of `render-lab completions` for zsh and fish, each run by its shell. Shown as ignored where the shell is
//! missing; the tests of the program have the script for bash.

use std::fs;
use std::process::Command;

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::trial;

/// `_arguments` of zsh needs a terminal. A function in its place prints its arguments, and sets the first word to
/// render.
const ZSH: &str = "compdef() { :; }; _arguments() { print -l -- \"$@\"; state=render-lab; line=(render); }; \
                   words=(render-lab render --sc); CURRENT=3; source \"$SCRIPT\"; _render-lab";

const FISH: &str = "source $SCRIPT; complete -C 'render-lab render --sc'; complete -C 'render-lab bench sc'";

/// Returns a trial for each shell.
pub fn trials() -> Vec<Trial> {
    let shells = [
        ("zsh", "-f", ZSH, &["--scatter=[How surfaces scatter light]"][..]),
        ("fish", "--no-config", FISH, &["--scatter\t", "scale\t"]),
    ];
    let of_shell =
        |(shell, option, text, expected): (&'static str, &'static str, &'static str, &'static [&'static str])| {
            let is_missing = Command::new(shell).arg("--version").output().is_err();
            let test = move || completes(shell, option, text, expected);
            let missing = is_missing.then(|| format!("needs {shell}"));
            trial(format!("shells::{shell}_completes_options_of_a_command"), missing.as_deref(), test)
        };
    shells.map(of_shell).into()
}

/// Runs `text` in a shell, with `$SCRIPT` as the completion script for this shell, and looks for `expected`.
fn completes(shell: &str, option: &str, text: &str, expected: &[&str]) -> Result<(), Failed> {
    let folder = Folder::new();
    let script = folder.file("_render-lab");
    let written = Command::new(env!("CARGO_BIN_EXE_render-lab")).args(["completions", shell]).output()?;
    fs::write(&script, written.stdout)?;
    let output = Command::new(shell).args([option, "-c", text]).env("SCRIPT", &script).output()?;
    let said = String::from_utf8(output.stdout)?;
    match expected.iter().find(|words| !said.contains(**words)) {
        Some(missing) => Err(format!("no {missing:?} in {said}").into()),
        None if output.status.success() => Ok(()),
        None => Err(format!("{}", output.status).into()),
    }
}
