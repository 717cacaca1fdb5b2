//! Renders with a person's own WGSL modules and tells how far that is from the truth.

use std::convert::Infallible;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

use cpu::output::{Options, Output, stop};
use gpu_check::shader_lab::args::{self, Command, USAGE};
use gpu_check::shader_lab::files::shown;
use gpu_check::shader_lab::{TEMPLATE, guard, truth, watch::Lab};
use gpu_check::web::{Server, data};
use gpu_check::{Error, Gpu};

fn main() -> ExitCode {
    // From here on a signal that ends the process leaves no temporary file.
    stop::remove_temporary_when_stopped();
    // naga, wgpu and drivers read nested text by recursion, and the stack of the main thread may be of any size.
    let thread = std::thread::Builder::new().name("lab".to_owned()).stack_size(shaders::limits::STACK_BYTES);
    match thread.spawn(run).map(std::thread::JoinHandle::join) {
        Ok(Ok(status)) => status,
        // It has said why.
        Ok(Err(_)) => ExitCode::FAILURE,
        Err(cause) => failed(&format!("no thread with a stack of {} bytes: {cause}", shaders::limits::STACK_BYTES)),
    }
}

fn run() -> ExitCode {
    let mut arguments = std::env::args_os().skip(1).peekable();
    if arguments.next_if(|argument| argument == guard::FLAG).is_some() {
        return match guard::compile(arguments) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => failed(&error.to_string()),
        };
    }
    let command = match args::parse(arguments) {
        Ok(command) => command,
        Err(message) => return failed(&format!("{message}\n\n{USAGE}")),
    };
    match command {
        Command::Help => said(&format!("{USAGE}\n")),
        Command::Template(path) => template(&path),
        Command::Serve { port, config, scene } => match serve(port, &config, &scene) {
            Ok(never) => match never {},
            Err(message) => failed(&message),
        },
        Command::Render(options) => {
            let again = options.watch;
            let mut lab = Lab::new(options);
            if !again {
                return match lab.render() {
                    Ok(report) => said(&report),
                    Err(message) => failed(&message),
                };
            }
            lab.watch(|result| {
                match result {
                    Ok(report) => said(&report),
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
    if path.symlink_metadata().is_ok() {
        return failed(&format!("{}: a file of this name exists; choose another", shown(path)));
    }
    let output = Output::open(path, Options { sync: true });
    match output.and_then(|output| output.fill(|file| file.write_all(TEMPLATE.as_bytes()))) {
        Ok(()) => said(&format!(
            "wrote {path}; now:\nshader-lab {path} --config scenes/materials/config.txt --scene \
             scenes/materials/scene.txt --out out.png --watch\n",
            path = shown(path)
        )),
        Err(error) => failed(&Error::from(error).to_string()),
    }
}

fn serve(port: u16, config: &Path, scene: &Path) -> Result<Infallible, String> {
    let data = || {
        let (config, scene) = (cpu::Config::read(config)?, cpu::Scene::read(scene)?);
        truth::check_size(&config)?;
        data::collect(&Gpu::open()?, &config, &scene)
    };
    let data = data().map_err(|error: Error| error.to_string())?;
    let at_port = |error: std::io::Error| format!("port {port}: {error}");
    let server = Server::new(port, data).map_err(at_port)?;
    let address = server.address().map_err(at_port)?;
    said(&format!("http://{address}/ for a browser with WebGPU; on Linux: chromium --enable-unsafe-webgpu\n"));
    // Only a test has results to send.
    server.serve(drop).map_err(at_port)
}

/// Output that nobody reads any more, as after `| head`, is no fault; closed or full output is one.
fn said(text: &str) -> ExitCode {
    let output = Output::open(Path::new("/dev/stdout"), Options::default());
    match output.and_then(|output| output.fill(|file| file.write_all(escaped(text).as_bytes()))) {
        Err(cpu::Error::Write { cause, .. }) if cause.kind() == std::io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => failed(&error.to_string()),
        Ok(()) => ExitCode::SUCCESS,
    }
}

fn failed(message: &str) -> ExitCode {
    let _ = std::io::stderr().write_all(format!("Error: {}\n", escaped(message)).as_bytes());
    ExitCode::FAILURE
}

/// Text of several lines without characters that a terminal would obey.
fn escaped(text: &str) -> String {
    text.split('\n').map(|line| cpu::text::escape(line.as_bytes())).collect::<Vec<_>>().join("\n")
}
