//! Tests the page of `web/site` in Chromium: the editors, the exact picture, links, looks, and `render-lab view`.
//!
//! The tests are in `web/site/tests`, each a trial here. `tests/run --browser` builds the page and runs them. They are
//! shown as ignored if Chromium, Node.js or the built page is missing. `SCREENSHOTS` may name a folder for pictures of
//! the page.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Arc, Mutex, PoisonError};

use cpu::{Aos, Scatter};
use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::{golden, project_root, trial};

/// Lines that are added to the configurations of the large scenes. The last line with a key counts.
const REDUCED: &str = "\nimage_width: 160\nsamples_per_pixel: 8\n";

/// Returns the path of Chromium: the file that `CHROMIUM` names, or the usual one of Debian.
pub fn chromium() -> PathBuf {
    std::env::var_os("CHROMIUM").map_or_else(|| "/usr/bin/chromium".into(), PathBuf::from)
}

/// Returns the folder of the built page.
fn site() -> PathBuf {
    project_root().join("out/site")
}

/// Returns why the page cannot be tested here, or `None` if it can.
fn obstacle() -> Option<&'static str> {
    let has_node = Command::new("node").arg("--version").output().is_ok_and(|output| output.status.success());
    if !has_node {
        Some("needs nodejs and npm")
    } else if !chromium().is_file() {
        Some("needs chromium")
    } else if !site().join("index.html").is_file() || !project_root().join("web/site/node_modules").is_dir() {
        Some("needs web/build")
    } else {
        None
    }
}

/// Returns the command that runs the script of the tests with `argument`.
fn script(argument: &str) -> Command {
    let mut node = Command::new("node");
    node.arg(project_root().join("web/site/tests/run.mjs")).arg(argument);
    node.env("SITE", site()).env("CHROMIUM", chromium()).env("RENDER_LAB", env!("CARGO_BIN_EXE_render-lab"));
    node
}

/// Returns the names of the tests.
fn names() -> Result<Vec<String>, String> {
    let output = script("--list").output().map_err(|error| error.to_string())?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let names: Vec<_> = text.lines().map(str::to_owned).collect();
    if output.status.success() && names.len() > 20 { Ok(names) } else { Err(format!("{output:?}")) }
}

/// Writes the pictures that the page must render: the 16 small cases with the digests of the program in C++, and all
/// scenes of `scenes/` in a reduced size with the digests of `render-aos`.
fn write_expected(folder: &Folder) -> Result<(), Failed> {
    let mut pictures = Vec::new();
    for case in golden::cases().into_iter().filter(|case| case.scatter == Scatter::Statement) {
        let [config, scene] = [&case.config, &case.scene].map(std::fs::read_to_string);
        pictures.push((case.name.clone(), config?, scene?, case.digest()?));
    }
    for entry in std::fs::read_dir(project_root().join("scenes"))? {
        let path = entry?.path();
        let config = std::fs::read_to_string(path.join("config.txt"))? + REDUCED;
        let scene = std::fs::read_to_string(path.join("scene.txt"))?;
        pictures.push((path.display().to_string(), config.clone(), scene.clone(), rendered(&config, &scene)?));
    }
    assert!(pictures.len() >= 16 + 6, "{} pictures", pictures.len());
    let list: Vec<_> = pictures
        .into_iter()
        .map(|(name, config, scene, digest)| {
            serde_json::json!({ "name": name, "config": config, "scene": scene, "digest": digest })
        })
        .collect();
    folder.write("expected.json", serde_json::to_vec(&list)?);
    Ok(())
}

/// Returns the digest of the file that `render-aos` writes.
fn rendered(config: &str, scene: &str) -> Result<String, Failed> {
    let folder = Folder::with_scene(config, scene);
    let [config, scene, out] = ["config.txt", "scene.txt", "out.ppm"].map(|name| folder.file(name));
    cli::program::run::<Aos>([&config, &scene, &out].map(|path| path.into()))
        .map_err(|error| String::from_utf8_lossy(&error.message(false)).into_owned())?;
    Ok(format::digest::sha256(&std::fs::read(out)?))
}

/// Runs the test `name`.
fn passes(name: &str, expected: &Path) -> Result<(), Failed> {
    let output = script(name).env("EXPECTED", expected).output()?;
    print!("{}", String::from_utf8_lossy(&output.stdout));
    if output.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&output.stderr).into_owned().into()) }
}

/// Returns a trial for each test of the page. Each test starts a browser, and two browsers at a time would wait for
/// each other on a small machine, so they run one after the other.
pub fn trials() -> Vec<Trial> {
    let is_required = std::env::var_os("BROWSER_REQUIRED").is_some();
    let reason = obstacle().map(str::to_owned);
    let names = reason.map_or_else(names, Err);
    let names = match names {
        Ok(names) => names,
        Err(reason) if is_required || obstacle().is_none() => {
            return vec![Trial::test("site::the_page", move || Err(reason.into()))];
        }
        Err(reason) => return vec![trial("site::the_page", Some(&reason), || Ok(()))],
    };
    let expected = Arc::new(Mutex::new(None));
    let of_name = |name: String| {
        let expected = Arc::clone(&expected);
        Trial::test(format!("site::{name}"), move || {
            let mut expected = expected.lock().unwrap_or_else(PoisonError::into_inner);
            if expected.is_none() {
                let folder = Folder::new();
                write_expected(&folder)?;
                *expected = Some(folder);
            }
            let folder = expected.as_ref().ok_or("it was just made")?;
            passes(&name, &folder.file("expected.json"))
        })
    };
    names.into_iter().map(of_name).collect()
}
