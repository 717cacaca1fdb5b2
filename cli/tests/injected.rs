//! Tests that make each system call of the programs fail once, and that send a signal in each of them.
//!
//! If `strace` cannot run, these tests are shown as ignored.

#[cfg(unix)]
fn trials() -> Vec<libtest_mimic::Trial> {
    use test_support::injection::{Disturbance, unavailable};

    let programs = [("aos", env!("CARGO_BIN_EXE_render-aos")), ("soa", env!("CARGO_BIN_EXE_render-soa"))];
    let disturbances = [
        (Disturbance::Errors, "every_call_fails_and_the_old_picture_stands_or_the_new_one"),
        (Disturbance::Signal, "a_signal_in_every_call_leaves_the_old_picture_or_the_new_one"),
        (Disturbance::SignalAsProcessOne, "a_signal_in_every_call_ends_process_1"),
        (Disturbance::Named, "failures_and_signals_where_a_file_needs_a_name"),
        (Disturbance::NamedAsProcessOne, "a_signal_in_every_call_ends_process_1_where_a_file_needs_a_name"),
    ];
    let mut trials = Vec::new();
    for (disturbance, name) in disturbances {
        let missing = unavailable(disturbance);
        for (short, program) in programs {
            let test = move || [None, Some("old")].into_iter().try_for_each(|old| disturb(program, old, disturbance));
            let trial = libtest_mimic::Trial::test(format!("{name}_{short}"), test);
            trials.push(trial.with_kind(missing.unwrap_or_default()).with_ignored_flag(missing.is_some()));
        }
    }
    trials
}

#[cfg(unix)]
fn disturb(
    program: &str,
    old: Option<&str>,
    disturbance: test_support::injection::Disturbance,
) -> Result<(), libtest_mimic::Failed> {
    let folder = test_support::folder::Folder::new();
    let [config, scene, d] = ["config.txt", "scene.txt", "d"].map(|name| folder.file(name));
    std::fs::write(&config, "image_width: 100\naspect_ratio: 1 1\nsamples_per_pixel: 1\n")?;
    std::fs::write(&scene, "")?;
    std::fs::create_dir(&d)?;
    let arguments: Vec<_> = [config, scene, d.join("out.ppm")].map(Into::into).to_vec();
    let job = test_support::injection::Job {
        program: program.into(),
        arguments,
        folder: d,
        old: old.map(|text| text.as_bytes().to_vec()),
        graceful: false,
        gate: None,
        only_folder: false,
        most: usize::MAX,
    };
    println!("{}", job.disturb(disturbance)?);
    Ok(())
}

#[cfg(not(unix))]
fn trials() -> Vec<libtest_mimic::Trial> {
    Vec::new()
}

fn main() {
    libtest_mimic::run(&libtest_mimic::Arguments::from_args(), trials()).exit();
}
