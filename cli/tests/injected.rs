//! Tests that make each system call of the programs fail once, and that send a signal in each of them.
//!
//! If `strace` cannot run, these tests are shown as ignored.

#[cfg(unix)]
mod unix {
    use libtest_mimic::{Failed, Trial};
    use test_support::folder::Folder;
    use test_support::injection::{Disturbance, Job, most, unavailable};

    pub fn trials() -> Vec<Trial> {
        // Both programs write by the same code, so few calls of each name are disturbed in the second one.
        let programs =
            [("aos", env!("CARGO_BIN_EXE_render-aos"), usize::MAX), ("soa", env!("CARGO_BIN_EXE_render-soa"), most(2))];
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
            for (short, program, most) in programs {
                let test = move || {
                    [None, Some("old")].into_iter().try_for_each(|old| disturb((program, most), old, disturbance))
                };
                trials.push(test_support::trial(format!("{name}_{short}"), missing, test));
            }
        }
        trials
    }

    fn disturb((program, most): (&str, usize), old: Option<&str>, disturbance: Disturbance) -> Result<(), Failed> {
        let folder = Folder::with_scene("image_width: 100\naspect_ratio: 1 1\nsamples_per_pixel: 1\n", "");
        let d = folder.file("d");
        std::fs::create_dir(&d)?;
        let job = Job {
            program: program.into(),
            arguments: ["config.txt", "scene.txt", "d/out.ppm"].map(|name| folder.file(name).into()).to_vec(),
            folder: d,
            old: old.map(|text| text.as_bytes().to_vec()),
            graceful: false,
            gate: None,
            only_folder: false,
            most,
        };
        println!("{} runs", job.disturb(disturbance)?);
        Ok(())
    }
}

fn main() {
    #[cfg(unix)]
    test_support::run_trials(unix::trials())
}
