//! The evaluated programs on other systems give the same digests. Each platform is built with Debian's compiler for
//! WebAssembly and ARM, and run by Node.js or by an emulator.
//!
//! A platform whose tools are missing is shown as ignored, with the packages that it needs. `tests/run --platforms`
//! installs the packages, and takes the pictures that need minutes too.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Arc, OnceLock};

use cpu::Scatter;
use libtest_mimic::{Arguments, Failed, Trial};
use test_support::folder::Folder;
use test_support::golden::{self, Golden};
use test_support::{digest, project_root};

/// A system on which the pictures are rendered.
struct Platform {
    name: &'static str,
    /// Rust's name of the system.
    target: &'static str,
    /// The flags of the compiler.
    flags: &'static str,
    /// The linker, and the emulator with the folder of the system's libraries; none for WebAssembly.
    emulated: Option<(&'static str, &'static str, &'static str)>,
    /// The files that it needs, each with the package of Debian that has the file.
    needs: &'static [(&'static str, &'static str)],
    /// The instruction sets that the programs are forced to take.
    sets: &'static [&'static str],
    /// Whether the platform is only tried by `tests/run --platforms`.
    is_slow: bool,
    /// The result of building, which all trials share.
    built: OnceLock<Result<(), String>>,
}

const COMPILER: (&str, &str) = ("/usr/bin/rustc", "rustc-web");
const SOURCES: (&str, &str) = ("/usr/lib/rustlib/src/rust/library/std/Cargo.toml", "rust-web-src");
const WASM_LINKER: (&str, &str) = ("/usr/bin/wasm-ld", "lld");
const ARM_LIBRARY: (&str, &str) = ("/usr/lib/rustlib/aarch64-unknown-linux-gnu/lib", "libstd-rust-web-dev:arm64");
const ARM_LINKER: (&str, &str) = ("/usr/bin/aarch64-linux-gnu-gcc", "gcc-aarch64-linux-gnu");
const ARM_C: (&str, &str) = ("/usr/aarch64-linux-gnu/lib/ld-linux-aarch64.so.1", "libc6-dev-arm64-cross");
const ARM_EMULATOR: (&str, &str) = ("/usr/bin/qemu-aarch64", "qemu-user");
const S390X_LINKER: (&str, &str) = ("/usr/bin/s390x-linux-gnu-gcc", "gcc-s390x-linux-gnu");
const S390X_C: (&str, &str) = ("/usr/s390x-linux-gnu/lib/ld64.so.1", "libc6-dev-s390x-cross");
const S390X_EMULATOR: (&str, &str) = ("/usr/bin/qemu-s390x", "qemu-user");

/// The variable that asks for all pictures on all platforms.
const ALL: &str = "RENDER_PLATFORMS";

fn platforms() -> Vec<Platform> {
    let wasm = &[COMPILER, SOURCES, WASM_LINKER];
    vec![
        Platform {
            name: "wasm32-simd128",
            target: "wasm32-unknown-unknown",
            flags: "-C target-feature=+simd128",
            emulated: None,
            needs: wasm,
            sets: &["simd128", "portable"],
            is_slow: false,
            built: OnceLock::new(),
        },
        Platform {
            name: "wasm32",
            target: "wasm32-unknown-unknown",
            flags: "",
            emulated: None,
            needs: wasm,
            sets: &["portable"],
            is_slow: true,
            built: OnceLock::new(),
        },
        Platform {
            name: "aarch64",
            target: "aarch64-unknown-linux-gnu",
            flags: "",
            emulated: Some((ARM_LINKER.0, ARM_EMULATOR.0, "/usr/aarch64-linux-gnu")),
            needs: &[COMPILER, ARM_LIBRARY, ARM_LINKER, ARM_C, ARM_EMULATOR],
            sets: &["neon", "portable"],
            is_slow: true,
            built: OnceLock::new(),
        },
        // The bytes of a number are in the opposite order there.
        Platform {
            name: "s390x",
            target: "s390x-unknown-linux-gnu",
            flags: "",
            emulated: Some((S390X_LINKER.0, S390X_EMULATOR.0, "/usr/s390x-linux-gnu")),
            needs: &[COMPILER, SOURCES, S390X_LINKER, S390X_C, S390X_EMULATOR],
            sets: &["portable"],
            is_slow: true,
            built: OnceLock::new(),
        },
    ]
}

impl Platform {
    /// Returns why the platform cannot be tried here, or `None` if it can.
    fn obstacle(&self) -> Option<String> {
        let missing: Vec<_> =
            self.needs.iter().filter(|(file, _)| !Path::new(file).exists()).map(|(_, package)| *package).collect();
        let has_node = Command::new("node").arg("--version").output().is_ok_and(|output| output.status.success());
        if !missing.is_empty() {
            Some(format!("needs {}", missing.join(", ")))
        } else if self.emulated.is_none() && !has_node {
            Some("needs nodejs".to_owned())
        } else if self.is_slow && std::env::var_os(ALL).is_none() {
            Some(format!("needs {ALL}=1"))
        } else {
            None
        }
    }

    /// The folder of the build.
    fn folder(&self) -> PathBuf {
        project_root().join("target/platforms").join(self.name)
    }

    /// Builds the programs, or the module, once for all trials.
    fn build(&self) -> Result<(), String> {
        let build = || {
            let mut cargo = Command::new(env!("CARGO"));
            cargo.current_dir(project_root()).env("RUSTC", COMPILER.0).env("RUSTFLAGS", self.flags);
            cargo.env_remove("CARGO_TARGET_DIR").env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO_ENCODED_RUSTFLAGS");
            cargo.args(["build", "--quiet", "--release", "--locked", "--target", self.target, "--target-dir"]);
            cargo.arg(self.folder());
            match self.emulated {
                None => cargo.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", "wasm-ld").args(["-p", "wasm"]),
                Some((linker, ..)) => {
                    let name = self.target.to_uppercase().replace('-', "_");
                    cargo.env(format!("CARGO_TARGET_{name}_LINKER"), linker).args(["-p", "cli", "--bins"])
                }
            };
            if self.needs.contains(&SOURCES) {
                // No package has the standard library, so it is built too, which needs this variable.
                cargo.env("RUSTC_BOOTSTRAP", "1").arg("-Zbuild-std=std,panic_abort");
            }
            let output = cargo.output().map_err(|error| error.to_string())?;
            output.status.success().then_some(()).ok_or_else(|| String::from_utf8_lossy(&output.stderr).into_owned())
        };
        self.built.get_or_init(build).clone()
    }

    /// Renders a picture and returns the bytes of the file.
    fn render(&self, golden: &Golden, layout: &str, set: &str) -> Result<Vec<u8>, Failed> {
        self.build()?;
        let built = self.folder().join(self.target).join("release");
        let mut command = match self.emulated {
            None => {
                let mut node = Command::new("node");
                node.arg(project_root().join("tests/platforms/render.mjs")).arg(built.join("wasm.wasm"));
                node.env("RENDER_LAYOUT", layout);
                node
            }
            Some((_, emulator, libraries)) => {
                let mut emulator = Command::new(emulator);
                emulator.args(["-L", libraries]).arg(built.join(format!("render-{layout}")));
                emulator
            }
        };
        let folder = Folder::new();
        let out = folder.file("out.ppm");
        let output = command.args([&golden.config, &golden.scene, &out]).env("RENDER_INSTRUCTION_SET", set).output()?;
        if !output.status.success() || !output.stderr.is_empty() {
            return Err(format!("{output:?}").into());
        }
        Ok(std::fs::read(out)?)
    }
}

/// Returns the pictures that are tried: the small cases, the course's first two, and with `RENDER_PLATFORMS` all four.
/// The programs have the statement's convention alone.
fn pictures() -> Vec<Golden> {
    let mut pictures = golden::cases();
    let folder = golden::reference_folder();
    if folder.is_dir() {
        let all = golden::reference(&folder);
        let count = if std::env::var_os(ALL).is_some_and(|value| value == "all") { 4 } else { 2 };
        pictures.extend(all.into_iter().take(2 * count));
    }
    pictures.retain(|golden| golden.scatter == Scatter::Statement);
    assert!(pictures.len() >= 16, "no picture is left out");
    pictures
}

fn has_its_digest(platform: &Platform, golden: &Golden, layout: &str, set: &str) -> Result<(), Failed> {
    let expected = golden.digest()?;
    let actual = digest::sha256(&platform.render(golden, layout, set)?);
    if actual == expected { Ok(()) } else { Err(format!("{actual} instead of {expected}").into()) }
}

fn main() {
    let mut trials = Vec::new();
    for platform in platforms().into_iter().map(Arc::new) {
        let obstacle = platform.obstacle();
        for golden in pictures() {
            for (number, &set) in platform.sets.iter().enumerate() {
                // Small pictures take both layouts, one for each instruction set.
                let layout = if number % 2 == 0 { "aos" } else { "soa" };
                let (platform, golden) = (Arc::clone(&platform), golden.clone());
                let name = format!("{} {} by render-{layout} with {set}", platform.name, golden.name);
                let trial = Trial::test(name, move || has_its_digest(&platform, &golden, layout, set));
                trials.push(match &obstacle {
                    Some(reason) => trial.with_kind(reason).with_ignored_flag(true),
                    None => trial,
                });
            }
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
