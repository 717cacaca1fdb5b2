//! Runs `shader-lab` with more and more address space. As long as that is too little, the program must end with a
//! message and status 2, and not by a panic or a signal.

use gpu_check::shader_lab::TEMPLATE;
use test_support::folder::Folder;
use test_support::project_root;

/// Smallest address space in kB with which the system's loader can start the program. The constants below are in kB
/// too.
const LEAST: usize = 40_000;
const STEP: usize = 25_000;
const MOST: usize = 4_000_000;

#[test]
fn with_too_little_memory_the_program_says_so_and_never_dies() {
    let folder = Folder::new();
    folder.write("config", "image_width: 8\nmax_depth: 1\n");
    folder.write("my.wgsl", TEMPLATE);
    for (refused, kilobytes) in (LEAST..MOST).step_by(STEP).enumerate() {
        let mut shell = test_support::running::bash();
        shell.args(["-c", &format!("ulimit -v {kilobytes}; exec \"$@\""), "limited", env!("CARGO_BIN_EXE_shader-lab")]);
        shell.args(["my.wgsl", "--config", "config", "--out", "out.png", "--scene"]);
        shell.arg(project_root().join("scenes/materials/scene.txt")).current_dir(folder.path());
        let output = shell.output().expect("bash starts");
        if output.status.success() {
            println!("refused {refused} times up to {kilobytes} kB");
            assert!(refused >= 10, "only {refused} steps");
            assert!(folder.file("out.png").is_file());
            return;
        }
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && stderr.contains("Error: "), "at {kilobytes} kB: {output:?}");
        assert!(!stderr.contains("panicked") && !folder.file("out.png").exists(), "at {kilobytes} kB: {stderr}");
    }
    panic!("{MOST} kB are not enough");
}
