//! Renders a picture with a program or a module that was built for another system.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use libtest_mimic::Failed;
use test_support::folder::Folder;
use test_support::project_root;

use super::build::Need;

/// Names of the browser's program, in the order in which they are tried.
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// What runs the program or the module.
#[derive(Clone, Copy, Debug)]
pub enum Host {
    /// This machine, which must be an x86-64 Linux.
    Native,
    /// QEMU, with the folder of the system's libraries.
    Emulator { qemu: Need, libraries: &'static str },
    /// Node.js, with `tests/platforms/render.mjs`.
    Node,
    /// Headless Chromium, with `tests/platforms/page.html`.
    Chromium,
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
            Self::Node => find(&["node"]).is_none().then_some("nodejs"),
            Self::Chromium => find(&BROWSERS).is_none().then_some("chromium"),
        }
    }

    /// Renders a picture with what is in the folder `built`, and returns the bytes of the PPM file.
    ///
    /// # Errors
    /// What the program prints, if it fails or prints a message.
    pub fn render(&self, built: &Path, job: Job<'_>) -> Result<Vec<u8>, Failed> {
        let program = built.join(format!("render-{}", job.layout));
        let command = match self {
            Self::Chromium => return render_in_chromium(&built.join("wasm.wasm"), job),
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
                node.env("RENDER_LAYOUT", job.layout);
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

/// Opens a page that renders the picture while it loads. The browser prints the page when it has loaded.
fn render_in_chromium(module: &Path, job: Job<'_>) -> Result<Vec<u8>, Failed> {
    let folder = Folder::new();
    for file in ["page.html", "call.js"] {
        std::fs::copy(project_root().join("tests/platforms").join(file), folder.file(file))?;
    }
    // A page from a file may not read other files, but it may load scripts. So the bytes are in a script.
    let mut input = String::from("const input = {\n");
    for (name, path) in [("module", module), ("config", job.config), ("scene", job.scene)] {
        writeln!(input, "{name}: new Uint8Array({:?}),", std::fs::read(path)?)?;
    }
    writeln!(input, "isSoa: {}, isPortable: {} }};", job.layout == "soa", job.set == "portable")?;
    folder.write("input.js", input);
    let mut command = Command::new(find(&BROWSERS).ok_or("there is no Chromium")?);
    command.args(["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]);
    command.arg(format!("--user-data-dir={}", folder.file("profile").display())).arg("--dump-dom");
    command.arg(format!("file://{}", folder.file("page.html").display()));
    // The browser's own messages are about services of a desktop, which is not there.
    let output = command.stderr(Stdio::null()).output()?;
    let page = String::from_utf8(output.stdout)?;
    let shown = page.split_once("<pre>").and_then(|(_, rest)| rest.rsplit_once("</pre>")).map(|(text, _)| text);
    match shown {
        Some(text) if text.starts_with("P3\n") => Ok(text.into()),
        _ => Err(format!("{}: {}", output.status, shown.unwrap_or(&page)).into()),
    }
}

/// Returns the path of the first program with one of `names` in the folders of `PATH`.
fn find(names: &[&str]) -> Option<PathBuf> {
    let folders: Vec<_> = std::env::split_paths(&std::env::var_os("PATH")?).collect();
    names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name))).find(|path| path.is_file())
}
