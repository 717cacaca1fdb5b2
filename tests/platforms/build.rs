//! Builds the programs or the WebAssembly module for another system, with Debian's compiler for WebAssembly and ARM.

use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

use test_support::project_root;

/// A file that a build or a host needs, and the package of Debian that has the file.
pub type Need = (&'static str, &'static str);

/// The compiler. Debian's package `rustc` is older than this project needs.
pub const COMPILER: Need = ("/usr/bin/rustc", "rustc-web");
/// Returns why the compiler cannot build this project, or `None` if it can. Debian 12 has an older one.
pub fn compiler_is_too_old() -> Option<String> {
    let needed = env!("CARGO_PKG_RUST_VERSION");
    let output = Command::new(COMPILER.0).arg("--version").output().ok()?;
    let said = String::from_utf8_lossy(&output.stdout);
    let found = said.split(' ').nth(1).unwrap_or_default();
    let numbers = |version: &str| -> Vec<u32> { version.split('.').filter_map(|part| part.parse().ok()).collect() };
    (numbers(found) < numbers(needed)).then(|| format!("needs {} {needed}, and this is {found}", COMPILER.1))
}

/// The sources of the standard library.
pub const SOURCES: Need = ("/usr/lib/rustlib/src/rust/library/std/Cargo.toml", "rust-web-src");

/// A system and the flags for which the project is built.
#[derive(Debug)]
pub struct Build {
    /// The folder's name in `target/platforms`.
    pub folder: &'static str,
    /// Rust's name of the system.
    pub target: &'static str,
    /// The package of the workspace.
    pub package: &'static str,
    /// The flags of the compiler.
    pub flags: &'static str,
    /// The linker.
    pub linker: &'static str,
    /// The files that the build needs. With [`SOURCES`] among them, the standard library is built too.
    pub needs: &'static [Need],
    built: OnceLock<Result<(), String>>,
}

impl Build {
    /// Returns the build of the WebAssembly module.
    pub fn wasm(folder: &'static str, flags: &'static str) -> Self {
        let needs = &[COMPILER, SOURCES, ("/usr/bin/wasm-ld", "lld")];
        Self { package: "wasm", ..Self::programs(folder, "wasm32-unknown-unknown", "wasm-ld", needs) }.with_flags(flags)
    }

    /// Returns the build of the evaluated programs for `target`.
    pub fn programs(folder: &'static str, target: &'static str, linker: &'static str, needs: &'static [Need]) -> Self {
        Self { folder, target, package: "cli", flags: "", linker, needs, built: OnceLock::new() }
    }

    /// Returns the build with other flags of the compiler.
    pub fn with_flags(self, flags: &'static str) -> Self {
        Self { flags, ..self }
    }

    /// Builds on the first call, and returns the folder of the programs or of the module.
    ///
    /// # Errors
    /// The messages of the compiler.
    pub fn release(&self) -> Result<PathBuf, String> {
        let build = || self.cargo(&["build", "--quiet", "--release", "-p", self.package]).map(drop);
        self.built.get_or_init(build).clone()?;
        Ok(self.root().join(self.target).join("release"))
    }

    /// Runs Cargo for this system, and returns what Cargo prints.
    ///
    /// # Errors
    /// The messages of Cargo, if it fails.
    pub fn cargo(&self, arguments: &[&str]) -> Result<String, String> {
        let linker = format!("CARGO_TARGET_{}_LINKER", self.target.to_uppercase().replace('-', "_"));
        let mut cargo = Command::new(env!("CARGO"));
        cargo.current_dir(project_root()).env("RUSTC", COMPILER.0).env("RUSTFLAGS", self.flags);
        cargo.env_remove("CARGO_TARGET_DIR").env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO_ENCODED_RUSTFLAGS");
        cargo.env(linker, self.linker).args(arguments);
        cargo.args(["--locked", "--target", self.target, "--target-dir"]).arg(self.root());
        if self.needs.contains(&SOURCES) {
            // No package has the standard library of this system, so it is built too, which needs this variable. The
            // programs abort instead of unwinding, so no feature of the library is needed.
            cargo.env("RUSTC_BOOTSTRAP", "1").args(["-Zbuild-std=std,panic_abort", "-Zbuild-std-features="]);
        }
        let output = cargo.output().map_err(|error| error.to_string())?;
        let [printed, messages] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes));
        if output.status.success() { Ok(printed.into_owned()) } else { Err(format!("{printed}{messages}")) }
    }

    fn root(&self) -> PathBuf {
        project_root().join("target/platforms").join(self.folder)
    }
}
