//! Renders with a person's own WGSL modules and tells how far that is from the truth.

use std::convert::Infallible;
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use gpu_check::shader_lab::args::{self, Command, USAGE};
use gpu_check::shader_lab::{TEMPLATE, watch::Lab};
use gpu_check::web::{Server, data};
use gpu_check::{Error, Gpu};

/// Exit status for a picture that differs, where that is asked for; as of `diff` and `render-lab`.
const DIFFERS: u8 = 1;
/// Exit status for an error.
const TROUBLE: u8 = 2;

fn main() -> ExitCode {
    gpu_check::runtime::ensure_folder();
    let command = match args::parse(std::env::args().skip(1)) {
        Ok(command) => command,
        Err(message) => return failed(&format!("{message}; see --help")),
    };
    match command {
        Command::Help => {
            println!("{USAGE}");
            ExitCode::SUCCESS
        }
        Command::Template(path) => template(&path),
        Command::Serve { port, config, scene } => match serve(port, &config, &scene) {
            Ok(never) => match never {},
            Err(message) => failed(&message),
        },
        Command::Render(options) => {
            let (again, check) = (options.watch, options.check);
            // A picture on standard output leaves no room for words there.
            let is_output_taken = options.out.as_os_str() == "-";
            let said = move |text: &str| if is_output_taken { noted(text) } else { said(text) };
            let mut lab = Lab::new(options);
            if !again {
                return match lab.render() {
                    Ok(outcome) if check && outcome.differs => {
                        said(&outcome.report);
                        ExitCode::from(DIFFERS)
                    }
                    Ok(outcome) => said(&outcome.report),
                    Err(message) => failed(&message),
                };
            }
            lab.watch(|result| {
                match result {
                    Ok(outcome) => said(&outcome.report),
                    Err(message) => failed(&format!("{message}\nthe last good picture stays; save again to go on")),
                };
                true
            });
            ExitCode::SUCCESS
        }
    }
}

/// Writes a module to start from, but never over another file.
fn template(path: &Path) -> ExitCode {
    let written = OpenOptions::new().write(true).create_new(true).open(path);
    match written.and_then(|mut file| file.write_all(TEMPLATE.as_bytes())) {
        Ok(()) => said(&format!(
            "wrote {path}; now:\nshader-lab {path} --config scenes/materials/config.txt --scene \
             scenes/materials/scene.txt --out out.png --watch\n",
            path = path.display()
        )),
        Err(cause) => failed(&format!("{}: {cause}", path.display())),
    }
}

fn serve(port: u16, config: &Path, scene: &Path) -> Result<Infallible, String> {
    let data = || data::collect(&Gpu::open()?, &cpu::Config::read(config)?, &cpu::Scene::read(scene)?);
    let data = data().map_err(|error: Error| error.to_string())?;
    let at_port = |error: std::io::Error| format!("port {port}: {error}");
    let server = Server::new(port, data).map_err(at_port)?;
    let address = server.address().map_err(at_port)?;
    said(&format!("http://{address}/ for a browser with WebGPU; on Linux: chromium --enable-unsafe-webgpu\n"));
    // Only a test has results to send.
    server.serve(drop).map_err(at_port)
}

/// Output that nobody reads any more, as after `| head`, is no fault.
fn said(text: &str) -> ExitCode {
    let _ = std::io::stdout().write_all(text.as_bytes());
    ExitCode::SUCCESS
}

/// The same on standard error.
fn noted(text: &str) -> ExitCode {
    let _ = std::io::stderr().write_all(text.as_bytes());
    ExitCode::SUCCESS
}

fn failed(message: &str) -> ExitCode {
    let _ = writeln!(std::io::stderr(), "Error: {message}");
    ExitCode::from(TROUBLE)
}
