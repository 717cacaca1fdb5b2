//! Renders with the user's own WGSL modules, and reports the difference between that picture and the CPU's picture.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use gpu_check::Error;
use gpu_check::shader_lab::args::Arguments;
use gpu_check::shader_lab::files::shown;
use gpu_check::shader_lab::png::STANDARD_OUTPUT;
use gpu_check::shader_lab::{TEMPLATE, guard, watch::Lab};
use gpu_check::terminal::{self, TROUBLE, failed};
use output::{Options, Output, stop};

/// Exit status with `--check` if the picture differs from the CPU's, as for `diff` and `render-lab`.
const DIFFERS: u8 = 1;
/// Exit status of a panic, the same as that of the standard library. [`guard::check`] uses it to distinguish a panic
/// from an error message.
const PANICKED: u8 = 101;

fn main() -> ExitCode {
    gpu_check::runtime::ensure_folder();
    // From here on, a signal that ends the process first removes the temporary files.
    stop::remove_temporary_when_stopped();
    // naga, wgpu and drivers read nested text by recursion. The stack of the main thread may be too small for that.
    let thread = std::thread::Builder::new().name("lab".to_owned()).stack_size(shaders::limits::STACK_BYTES);
    match thread.spawn(run).map(std::thread::JoinHandle::join) {
        Ok(Ok(status)) => status,
        // The thread panicked, and the panic has printed its message.
        Ok(Err(_)) => ExitCode::from(PANICKED),
        Err(cause) => failed(&format!("no thread with a stack of {} bytes: {cause}", shaders::limits::STACK_BYTES)),
    }
}

fn run() -> ExitCode {
    if std::env::args_os().nth(1).is_some_and(|argument| argument == guard::FLAG) {
        return match guard::compile(std::env::args_os().skip(2)) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => failed(&error.to_string()),
        };
    }
    let arguments = match Arguments::read(std::env::args_os()) {
        Ok(arguments) => arguments,
        Err(answer) => return terminal::answer(&answer),
    };
    match arguments {
        Arguments { template: Some(path), .. } => template(&path),
        Arguments { options: None, .. } => ExitCode::from(TROUBLE),
        Arguments { options: Some(options), .. } => {
            let (watch, check) = (options.watch, options.check);
            // If the picture goes to standard output, the report goes to standard error.
            let is_output_taken = [OsStr::new("-"), OsStr::new(STANDARD_OUTPUT)].contains(&options.out.as_os_str());
            let said = move |text: &str| {
                if is_output_taken {
                    terminal::note(text.trim_end());
                    return ExitCode::SUCCESS;
                }
                said(text)
            };
            let mut lab = Lab::new(options);
            if !watch {
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

/// Writes the template to a new file. An existing file is never overwritten.
fn template(path: &Path) -> ExitCode {
    if path.symlink_metadata().is_ok() {
        return failed(&format!("{}: a file of this name exists; choose another", shown(path)));
    }
    let output = Output::open(path, Options { sync: true });
    match output.and_then(|output| output.fill(|file| file.write_all(TEMPLATE.as_bytes()))) {
        Ok(()) => {
            let program = std::env::args_os().next().map_or("shader-lab".into(), PathBuf::from);
            let [program, module] = [&program, path].map(quoted);
            let [config, scene] = ["config.txt", "scene.txt"].map(|name| quoted(example().join(name)));
            said(&format!(
                "wrote {}; now:\n{program} {module} --config {config} --scene {scene} --out out.png --watch\n",
                shown(path)
            ))
        }
        Err(error) => failed(&Error::from(error).to_string()),
    }
}

/// Returns the folder of an example, relative to the current folder or, if it is not there, in the checkout in which
/// this program was built.
fn example() -> PathBuf {
    let folder = Path::new("scenes/materials");
    let program = std::env::current_exe().unwrap_or_default();
    let checkouts = program.ancestors().skip(1).map(|checkout| checkout.join(folder));
    let mut places = std::iter::once(folder.to_owned()).chain(checkouts);
    places.find(|place| place.is_dir()).unwrap_or_else(|| folder.to_owned())
}

/// Returns the name of a file as a shell reads it: in quotes, unless all characters stand for themselves.
fn quoted(path: impl AsRef<Path>) -> String {
    let name = shown(path.as_ref());
    let is_plain = |letter: char| letter.is_alphanumeric() || "/._-+:@%,".contains(letter);
    if name.chars().all(is_plain) { name } else { format!("'{}'", name.replace('\'', r"'\''")) }
}

fn said(text: &str) -> ExitCode {
    match terminal::print(text) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => failed(&error.to_string()),
    }
}
