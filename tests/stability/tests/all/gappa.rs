//! Proves margins a second time by Gappa, which `tests/extensive proofs` runs.

use std::collections::BTreeSet;
use std::io::Write;
use std::process::{Command, Stdio};

use stability::proof::gappa::{Proof, scripts};
use stability::proof::rows;

/// Returns whether Gappa proves a text, and what it says.
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
    (output.status.success(), said)
}

#[test]
#[ignore = "needs Gappa; tests/extensive proofs runs it"]
fn gappa_proves_every_exported_proof_and_none_for_single_precision() {
    let (mut failures, mut refused) = (Vec::new(), 0);
    for Proof { row, what, text } in scripts() {
        let (is_proved, said) = prove(&text);
        println!("{row}: {what}");
        if !is_proved {
            failures.push(format!("{row}: {what}\n{text}\n{said}"));
        }
        if text.contains("rnd(") {
            // A line that begins with `$` splits the domain. Gappa would look for a proof of each part for minutes.
            let text: String =
                text.lines().filter(|line| !line.starts_with('$')).map(|line| format!("{line}\n")).collect();
            let (is_proved, said) = prove(&text.replace("ieee_64", "ieee_32"));
            assert!(!is_proved && said.contains("not satisfied"), "{row}: {what}, in f32\n{text}\n{said}");
            refused += 1;
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(refused >= 8, "{refused} proofs depend on rounding");
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
