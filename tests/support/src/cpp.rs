//! The programs in C++ of `tests/literal`, which share no code with the renderer: `literal.cpp` renders, and
//! `student.cpp` makes the mistakes that the variable `MISTAKES` names.

use std::path::PathBuf;
use std::process::Command;

use crate::folder::Folder;

/// The compiler. It must be g++, because pictures depend on the random distributions of its library, libstdc++.
const COMPILER: &str = "g++";

/// Returns what this machine lacks to build the programs, or `None`.
#[must_use]
pub fn missing() -> Option<&'static str> {
    let runs = Command::new(COMPILER).arg("--version").output().is_ok_and(|output| output.status.success());
    (!runs).then_some("needs g++")
}

/// Builds the program `name` into `folder`, and returns its path.
///
/// # Errors
/// What the compiler says.
pub fn build(name: &str, folder: &Folder) -> Result<PathBuf, String> {
    let program = folder.file(name);
    let source = crate::project_root().join("tests/literal").join(name).with_extension("cpp");
    let mut compiler = Command::new(COMPILER);
    // A fused multiply-add rounds once instead of twice, which would change bytes of the picture. So contraction is
    // switched off.
    compiler.args(["-std=c++20", "-O2", "-ffp-contract=off", "-pthread", "-o"]).arg(&program).arg(source);
    let output = compiler.output().map_err(|error| error.to_string())?;
    if output.status.success() { Ok(program) } else { Err(String::from_utf8_lossy(&output.stderr).into_owned()) }
}
