//! Tests that the programs render with a small stack, or say how much they need.

use std::fs;

use crate::workshop::{PROGRAMS, Workshop};

#[test]
fn a_stack_suffices_or_is_refused_with_a_message() {
    let scene: String =
        (0..2000).map(|index| format!("sphere: {} {} 0 .4 m\n", index % 50 - 25, index / 50 - 20)).collect();
    let config = "image_width: 40\nsamples_per_pixel: 2\ncamera_position: 0 0 30\ncamera_target: 0 0 0\n";
    let workshop = Workshop::new(config, format!("matte: m .5 .5 .5\n{scene}"));
    let expected = workshop.render();
    for program in PROGRAMS {
        let (mut refused, mut rendered) = (0, 0);
        // With less than 64 KiB the system cannot start every program. From 1024 KiB on no exact room is known.
        for kibibytes in (64..400).step_by(2).chain([1020, 1024]) {
            let output = workshop.after(&format!("ulimit -s {kibibytes}"), program).output();
            let output = output.expect("the program runs");
            if output.status.success() {
                assert!(fs::read(workshop.file("d/out.ppm")).expect("it was written") == expected, "{kibibytes}");
                fs::remove_file(workshop.file("d/out.ppm")).expect("it is ours");
                rendered += 1;
                continue;
            }
            let stderr = String::from_utf8_lossy(&output.stderr);
            let says_so = stderr.starts_with("Error: The stack is too small: ") && stderr.contains("ulimit -s 8192");
            assert!(output.status.code() == Some(1) && says_so, "with {kibibytes} KiB: {output:?}");
            assert!(kibibytes < 320, "320 KiB must suffice in all builds");
            refused += 1;
        }
        println!("refused with {refused} sizes, rendered with {rendered}");
        assert!(refused > 20 && rendered >= 42);
    }
}
