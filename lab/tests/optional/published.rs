//! Compares our pictures of case 2 with the second published image, and checks the known differences. If there is no
//! reference folder, these tests are shown as ignored.

use std::path::Path;
use std::process::Command;

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::trial;

/// Returns a trial for each convention.
pub fn trials() -> Vec<Trial> {
    let folder = test_support::golden::reference_folder();
    let obstacle = (!folder.is_dir()).then(|| format!("needs RENDER_REFERENCE_DIR: no folder {}", folder.display()));
    let cases = [
        ("statement", &["RMSE       0.841 ", "maximum    7.667 ", "verdict    accepted"][..]),
        ("published", &["identical: 90000 pixels"][..]),
    ];
    let of_convention = |(convention, expected): (&'static str, &'static [&'static str])| {
        let folder = folder.clone();
        let name = format!("published::second_picture_against_the_{convention}_convention");
        trial(name, obstacle.as_deref(), move || compares_as_known(&folder, convention, expected))
    };
    cases.map(of_convention).into()
}

fn compares_as_known(folder: &Path, convention: &str, expected: &[&str]) -> Result<(), Failed> {
    let lab = || Command::new(env!("CARGO_BIN_EXE_render-lab"));
    let (place, [config, scene, published]) =
        (Folder::new(), ["config2.txt", "scene2.txt", "published2.ppm"].map(|name| folder.join(name)));
    let out = place.file("out.ppm");
    let rendered = lab().arg("render").args([&config, &scene, &out]).args(["--scatter", convention]).output()?;
    let compared = lab().arg("compare").args([&out, &published]).output()?;
    let text = String::from_utf8(compared.stdout)?;
    assert!(rendered.status.success() && expected.iter().all(|words| text.contains(words)), "{rendered:?} {text}");
    Ok(())
}
