//! Tests with files that are neither pictures nor text, and with signals at any moment.

use std::fs::{self, File};
use std::io::Write;
use std::os::unix::net::UnixListener;
use std::os::unix::process::ExitStatusExt;
use std::process::{Command, ExitStatus, Stdio};
use std::time::Instant;

use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use test_support::folder::Folder;

use crate::{bash, lab};

const GRID: [&str; 2] = ["scenes/grid/config.txt", "scenes/grid/scene.txt"];

/// Runs `render-lab` in an address space of 200 MB, and returns its error message. Checks that the program ends with
/// status 2, and not by a signal.
fn complaint_in_little_memory(arguments: &[&str]) -> String {
    let mut shell = Command::new("bash");
    shell.args(["-c", "ulimit -v 200000; exec \"$@\"", "limited", env!("CARGO_BIN_EXE_render-lab")]).args(arguments);
    let output = shell.current_dir(test_support::project_root()).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
    String::from_utf8(output.stderr).expect("it complains in text")
}

#[test]
fn endless_and_empty_pictures_are_refused_in_little_memory() {
    let folder = Folder::new();
    let holes = folder.name("holes.ppm");
    File::create(&holes).and_then(|file| file.set_len(4 << 30)).expect("holes take no place");
    for name in ["/dev/zero", "/dev/null", &holes] {
        let message = complaint_in_little_memory(&["compare", name, name]);
        assert!(message.contains(&format!("{name}: neither PPM (P3 or P6) nor PNG")), "{message}");
    }
    // This file begins like a picture and is 5 GiB long. Reading it must end with an error about memory or about its
    // size.
    let mut file = File::create(folder.file("long.ppm")).expect("the folder is writable");
    file.write_all(b"P6 9 9 255\n").and_then(|()| file.set_len(5 << 30)).expect("holes take no place");
    let message = complaint_in_little_memory(&["compare", &folder.name("long.ppm"), &folder.name("long.ppm")]);
    assert!(message.contains("long.ppm: "), "{message}");
}

#[test]
fn endless_configurations_are_refused_with_and_without_settings() {
    let folder = Folder::new();
    let out = folder.name("out.ppm");
    for settings in [&[][..], &["--set", "gamma=1"]] {
        let arguments = [&["render", "/dev/zero", GRID[1], &out], settings].concat();
        let message = complaint_in_little_memory(&arguments);
        assert!(message.contains("[/dev/zero]: line 1 is longer than 1048576 bytes"), "{message}");
        assert!(folder.names().is_empty());
    }
}

/// Sends `signal` at random moments to `runs` renderings. After each one, the old picture or the new one must stand,
/// and no other file. Returns the statuses of the renderings that did not succeed.
fn stopped(signal: Signal, runs: usize) -> Vec<ExitStatus> {
    let folder = Folder::new();
    let out = folder.name("out.png");
    let arguments = ["render", GRID[0], GRID[1], &out, "--set", "image_width=200", "--set", "samples_per_pixel=1"];
    let start = Instant::now();
    assert!(lab(&arguments).status().expect("the program runs").success());
    let whole = start.elapsed();
    let new = fs::read(&out).expect("it was written");
    let mut stopped = Vec::new();
    let mut draws = cpu::internals::sampling::uniform::Uniform::new(3);
    for _ in 0..runs {
        fs::write(&out, "old").expect("the folder is writable");
        // A process that a shell starts in the background ignores SIGINT and SIGQUIT, and so do its children. `env`
        // resets this. Without the limit, some signals would write the memory of the process into a file.
        let mut limited = Command::new("env");
        limited.args(["--default-signal", "bash", "-c", "ulimit -c 0; exec \"$@\"", "limited"]);
        limited.arg(env!("CARGO_BIN_EXE_render-lab")).args(arguments);
        limited.current_dir(test_support::project_root()).stderr(Stdio::null());
        let mut child = limited.spawn().expect("bash starts");
        std::thread::sleep(whole.mul_f64(draws.canonical()));
        let id = Pid::from_raw(i32::try_from(child.id()).expect("it is a process"));
        kill(id, signal).expect("it is ours, and not yet waited for");
        let status = child.wait().expect("it ends");
        let picture = fs::read(&out).expect("a picture stands");
        if status.success() {
            assert!(picture == new, "{signal}");
        } else {
            assert!(picture == b"old" || picture == new, "{signal}: {} bytes", picture.len());
            stopped.push(status);
        }
        assert_eq!(folder.names(), ["out.png"], "{signal}");
    }
    println!("{signal}: {} of {runs} stopped", stopped.len());
    assert!(!stopped.is_empty(), "{signal}");
    stopped
}

#[test]
fn a_request_to_stop_at_any_moment_leaves_the_old_picture_or_the_new_one() {
    // If the signal comes before the program listens, it ends the program without a status. Later the status is
    // 130.
    for signal in [Signal::SIGTERM, Signal::SIGINT] {
        let statuses = stopped(signal, 40);
        assert!(statuses.iter().all(|status| matches!(status.code(), None | Some(130))), "{signal}: {statuses:?}");
    }
}

#[test]
fn other_signals_end_the_program_at_any_moment_and_leave_the_old_picture_or_the_new_one() {
    for signal in [Signal::SIGQUIT, Signal::SIGXCPU, Signal::SIGUSR1, Signal::SIGALRM] {
        let statuses = stopped(signal, 30);
        assert!(statuses.iter().all(|status| status.signal() == Some(signal as i32)), "{signal}: {statuses:?}");
    }
}

#[test]
fn a_limit_on_file_sizes_is_an_error_and_leaves_the_old_files() {
    let lines = [
        "render $root/scenes/grid/config.txt $root/scenes/grid/scene.txt d/out.png --set image_width=200",
        "render $root/scenes/grid/config.txt $root/scenes/grid/scene.txt d/out.ppm --set image_width=200",
        "compare $root/docs/materials.png $root/docs/materials.png --heatmap d/out.png",
        "bench merge --out d/out.json $root/docs/report/data/bench.json",
        "report $root/docs/report/data/bench.json --out d",
    ];
    for line in lines {
        let folder = Folder::new();
        let old =
            "mkdir -p d/charts; for file in d/{index.html,findings.json,out.{png,ppm,json}}; do echo old > $file; done";
        let output = bash(&folder, &format!("{old}; ulimit -f 1; $lab {line}"));
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{line}: {message}");
        assert!(message.contains("Error: Cannot write file [d/") && message.contains("File too large"), "{message}");
        assert!(folder.names_in("d/charts").is_empty(), "{line}");
        let names = folder.names_in("d");
        assert_eq!(names, ["charts", "findings.json", "index.html", "out.json", "out.png", "out.ppm"], "{line}");
        assert!(names[1..].iter().all(|name| folder.read(&format!("d/{name}")) == b"old\n"), "{line}");
    }
}

#[test]
fn a_socket_as_output_is_refused_before_anything_is_rendered() {
    let folder = Folder::new();
    let socket = folder.name("out");
    let _listener = UnixListener::bind(&socket).expect("the folder is writable");
    // The picture would take hours.
    let line = "timeout 60 $lab render $root/scenes/grid/config.txt $root/scenes/grid/scene.txt out \
                --set samples_per_pixel=4000000000";
    let output = bash(&folder, line);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(String::from_utf8_lossy(&output.stderr).contains("Cannot write file [out]: "), "{output:?}");
}
