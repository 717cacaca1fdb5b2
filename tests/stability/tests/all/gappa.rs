//! Proves margins a second time by Gappa, which `tests/extensive proofs` runs.

use std::collections::BTreeSet;
use std::io::Write;
use std::process::{Command, Stdio};

use stability::proof::gappa::{Proof, scripts};
use stability::proof::rows;

/// Returns whether Gappa proves a text, and what it says. It must not doubt a hint.
fn prove(text: &str) -> (bool, String) {
    let mut command = Command::new("gappa");
    let mut gappa = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("Gappa is installed");
    gappa.stdin.take().expect("it is a pipe").write_all(text.as_bytes()).expect("Gappa reads the text");
    let output = gappa.wait_with_output().expect("Gappa ends");
    let said = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    // Gappa takes both sides of a hint as equal, and only warns if it cannot show that they are.
    (output.status.success() && !said.contains("not trivially equal"), said)
}

#[test]
#[ignore = "needs Gappa; tests/extensive proofs runs it"]
fn gappa_proves_every_exported_proof_and_none_that_is_wrong() {
    let (mut failures, mut refused) = (Vec::new(), BTreeSet::new());
    for Proof { row, what, text, wrong: [right, wrong] } in scripts() {
        let (is_proved, said) = prove(&text);
        if !is_proved {
            failures.push(format!("{row}: {what}\n{text}\n{said}"));
        }
        // Of the proofs of several parts of a domain, one is enough here.
        if refused.insert((row, what)) {
            println!("{row}: {what}");
            // A line that begins with `$` splits the domain. Gappa would look for a proof of each part for minutes.
            let text: String =
                text.lines().filter(|line| !line.starts_with('$')).map(|line| format!("{line}\n")).collect();
            assert!(text.contains(&right), "{row}: {what} has no {right}\n{text}");
            let (is_proved, said) = prove(&text.replace(&right, &wrong));
            let is_refused = !is_proved && (said.contains("not satisfied") || said.contains("no contradiction"));
            assert!(is_refused, "{row}: {what}, wrong\n{text}\n{said}");
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn the_page_names_the_rows_that_are_proved_twice() {
    let rows = rows();
    let proved: BTreeSet<_> = scripts().iter().map(|proof| proof.row).collect();
    assert!(proved.iter().all(|name| rows.iter().any(|row| row.what == *name)), "{proved:?}");
    let page = include_str!("../../../../docs/margins.md");
    let (_, section) = page.split_once("## Which margins are proved twice?").expect("the page has the section");
    let section = section.split("\n## ").next().unwrap_or_default();
    let named: BTreeSet<_> =
        section.lines().filter_map(|line| Some(line.strip_prefix("| ")?.split_once(" | ")?.0)).skip(1).collect();
    assert_eq!(named, proved);
}
