//! Renders a picture with a program or a module that was built for another system.

use std::path::Path;
use std::process::Command;

use libtest_mimic::Failed;
use test_support::folder::Folder;
use test_support::project_root;

use super::build::Need;

/// What runs the program or the module.
#[derive(Clone, Copy, Debug)]
pub enum Host {
    /// This machine, which must be an x86-64 Linux.
    Native,
    /// QEMU, with the folder of the system's libraries.
    Emulator { qemu: Need, libraries: &'static str },
    /// Node.js, with `tests/platforms/render.mjs`.
    Node,
}

/// One picture to render: paths of the configuration and of the scene, the layout, and the instruction set.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    pub config: &'a Path,
    pub scene: &'a Path,
    /// `aos` or `soa`.
    pub layout: &'a str,
    /// Name of the instruction set that the renderer must take.
    pub set: &'a str,
}

impl Host {
    /// Returns the package that is missing on this machine, or `None`.
    pub fn missing(&self) -> Option<&'static str> {
        match self {
            Self::Native => (!cfg!(all(target_os = "linux", target_arch = "x86_64"))).then_some("x86-64 Linux"),
            Self::Emulator { qemu: (file, package), .. } => (!Path::new(file).exists()).then_some(*package),
            Self::Node => Command::new("node").arg("--version").output().is_err().then_some("nodejs"),
        }
    }

    /// Renders a picture with what is in the folder `built`, and returns the bytes of the PPM file.
    ///
    /// # Errors
    /// What the program prints, if it fails or prints a message.
    pub fn render(&self, built: &Path, job: Job<'_>) -> Result<Vec<u8>, Failed> {
        let program = built.join(format!("render-{}", job.layout));
        let command = match self {
            Self::Native => Command::new(program),
            Self::Emulator { qemu, libraries } => {
                let mut emulator = Command::new(qemu.0);
                // Without the path, the system's loader would take libraries of Debian's package for the same system.
                // The loader and the library of C must have one version: with others, threads did not start.
                let path = format!("LD_LIBRARY_PATH={libraries}/lib");
                emulator.args(["-L", libraries, "-E", &path]).arg(program);
                emulator
            }
            Self::Node => {
                let mut node = Command::new("node");
                node.arg(project_root().join("tests/platforms/render.mjs")).arg(built.join("wasm.wasm"));
                node.arg(job.layout);
                node
            }
        };
        write_file(command, job)
    }
}

/// Runs a command that takes the three arguments of the programs, and returns the bytes of the file that it writes.
fn write_file(mut command: Command, job: Job<'_>) -> Result<Vec<u8>, Failed> {
    let folder = Folder::new();
    let out = folder.file("out.ppm");
    command.args([job.config, job.scene, &out]).env("RENDER_INSTRUCTION_SET", job.set);
    let output = command.output()?;
    if !output.status.success() || !output.stderr.is_empty() {
        return Err(format!("{output:?}").into());
    }
    Ok(std::fs::read(out)?)
}
