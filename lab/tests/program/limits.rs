//! Tests of inputs beyond the limits of `docs/testing.md`, of outputs that are also inputs, and of standard streams
//! that cannot be written.

use std::fs;

use test_support::folder::Folder;

use crate::{bash, bash_complaint, complaint};

#[test]
fn a_picture_file_of_exactly_the_limit_is_read_and_one_byte_more_is_refused() {
    let folder = Folder::new();
    let name = folder.name("holes.ppm");
    fs::write(&name, "P6 1 1 255\n").expect("the folder is writable");
    let header = fs::metadata(&name).expect("it exists").len();
    let most = lab::picture::MAX_FILE_BYTES;
    let pixels = format!("{} bytes of pixels where 1 x 1 are announced", most - header);
    for (bytes, reason) in [(most, &pixels[..]), (most + 1, "it is larger than 1073741824 bytes")] {
        let file = fs::OpenOptions::new().write(true).open(&name).expect("it is ours");
        file.set_len(bytes).expect("holes take no place");
        let message = complaint(&["compare", &name, &name]);
        assert!(message.contains(&format!("holes.ppm: {reason}")), "{bytes}: {message}");
    }
}

#[test]
fn an_output_that_is_an_input_is_refused_under_any_name_and_stays() {
    let folder = Folder::new();
    let lines = [
        "$lab render config scene $OUT",
        "$lab compare picture.ppm picture.ppm --heatmap $OUT",
        "$lab bench merge --out $OUT bench.json",
    ];
    for (line, input) in lines.iter().zip(["scene", "picture.ppm", "bench.json"]) {
        for out in [input, "hard", "soft"] {
            let prepare = "cp $root/scenes/grid/config.txt config; cp $root/scenes/grid/scene.txt scene; \
                           cp $root/docs/report/data/bench.json .; printf 'P3 1 1 255 0 0 0\n' > picture.ppm";
            let links = format!("ln -f {input} hard; ln -sf {input} soft; cp {input} before");
            let line = format!("{prepare}; {links}; OUT={out}; {line}; s=$?; cmp {input} before && exit $s");
            let message = bash_complaint(&folder, &line);
            assert!(message.contains("it is the same file as the input ["), "{line} {out}: {message}");
        }
    }
    let pictures = "picture.ppm picture.ppm";
    for line in [
        "generate new ./new",
        "render config scene new.ppm --checkpoint ./new.ppm",
        &format!("compare {pictures} --heatmap new.png --html ./new.png"),
        &format!("compare {pictures} --heatmap - --html /dev/fd/1"),
        "grade . --html - --csv -",
    ] {
        let message = bash_complaint(&folder, &format!("$lab {line}"));
        assert!(message.contains("; the outputs need a file each"), "{line}: {message}");
    }
    let twice = ["inspect - /dev/fd/0", "bench diff - -", "bench merge --out m - x -", "animate x - m --to /dev/stdin"];
    for line in twice {
        let message = bash_complaint(&folder, &format!("$lab {line}"));
        assert!(message.contains("standard input (-) can be only one of the files"), "{line}: {message}");
    }
    for name in ["index.html", "findings.json", "charts/scale-width.svg"] {
        let line = format!("mkdir -p r/charts; cp bench.json r/{name}; $lab report r/{name} --out r; s=$?");
        let message = bash_complaint(&folder, &format!("{line}; cmp bench.json r/{name} && rm -r r && exit $s"));
        assert!(message.contains("it is the same file as the input ["), "{name}: {message}");
    }
}

#[test]
fn complaints_name_the_file_and_the_remedy() {
    let folder = Folder::new();
    folder.write("same", "camera_position: 0 0 0\n");
    folder.write("empty", "");
    bash(&folder, "mkdir grades; mkfifo pipe grades/grade.toml");
    for (line, words) in [
        ("inspect same empty", "[same]: camera_position is the same point"),
        ("convert same empty o.xml", "[same]: camera_position is the same point"),
        ("animate same empty o.png", "same: frame 0: "),
        ("animate empty empty same", "same: it is a file, and a folder is needed"),
        ("check same", "; name the program ./same"),
        ("grade grades", "grade.toml: it is not a regular file"),
        ("compare pipe ./pipe", "./pipe: a pipe or standard input (-) can be only one of the files"),
        ("convert pipe empty o.xml", "cannot be standard input (-) or pipes"),
        ("render empty empty o.ppm --checkpoint -", "a checkpoint has no standard output (-)"),
        ("man -", "a folder has no standard output (-)"),
        ("check --html - --json same", "both write to standard output"),
        ("help config foo", "no command or topic [foo]"),
        ("generate c s --objects -1", "invalid value '-1' for '--objects"),
        ("generate c s --cylinders 0,5", "write a decimal point, not a comma"),
        ("bench diff <(printf '\\xff\\xfe{') x", "the byte order mark of UTF-16; save the file as UTF-8"),
    ] {
        let message = bash_complaint(&folder, &format!("$lab {line}"));
        assert!(message.contains(words), "{line}: {message}");
    }
}

#[test]
fn a_pipe_gives_its_content_once_and_that_is_enough() {
    let folder = Folder::new();
    let inputs = "cat $root/scenes/grid/config.txt";
    let line = format!("$lab render <({inputs}; echo image_width: 16) <(cat $root/scenes/grid/scene.txt) o.png --json");
    let output = bash(&folder, &line);
    assert!(output.status.success() && String::from_utf8_lossy(&output.stdout).contains("\"width\": 16"), "{output:?}");
}

#[test]
fn closed_full_and_readable_outputs_are_errors_and_no_panic() {
    let folder = Folder::new();
    let commands = [
        "compare $root/docs/materials.png $root/docs/materials.png",
        "inspect $root/scenes/grid/scene.txt",
        "bench tasks",
        "completions bash",
        "--help",
        "render $root/scenes/grid/config.txt $root/scenes/grid/scene.txt /dev/stdout --set image_width=16",
        "render $root/scenes/grid/config.txt $root/scenes/grid/scene.txt x.png --set image_width=16 --json",
    ];
    for command in commands {
        for redirection in [">&-", ">/dev/full", "1</dev/null"] {
            let message = bash_complaint(&folder, &format!("$lab {command} {redirection}"));
            assert!(message.starts_with("Error: Cannot write file [/dev/stdout]: "), "{command}: {message}");
        }
        for redirection in ["2>&-", "2>/dev/full", "<&-", "| head -c 1"] {
            let output = bash(&folder, &format!("set -o pipefail; $lab {command} {redirection}"));
            // The reader takes one byte of a picture and closes the pipe. Then the program fails, unless the whole
            // picture was in the pipe before.
            let lost = command.contains("/dev/stdout") && redirection.starts_with('|') && {
                String::from_utf8_lossy(&output.stderr)
                    .starts_with("Error: Cannot write file [/dev/stdout]: Broken pipe")
            };
            let expected = if lost { 2 } else { 0 };
            assert_eq!(output.status.code(), Some(expected), "{command} {redirection}: {output:?}");
        }
    }
    bash_complaint(&folder, "$lab nonsense 2>/dev/full");
}

#[test]
fn a_small_limit_on_the_stack_does_not_end_a_rendering() {
    let folder = Folder::new();
    let line =
        "ulimit -s 256; $lab render $root/scenes/grid/config.txt $root/scenes/grid/scene.txt o.png --set image_width=8";
    let output = bash(&folder, line);
    assert!(output.status.success(), "{output:?}");
}

#[test]
fn names_cannot_command_a_terminal() {
    let folder = Folder::new();
    let lines = [
        r"$lab inspect $'\e[2J\nx'",
        r"$lab compare $'\e[2J\nx' $'\e[2J\nx'",
        r"$lab report $'\e[2J\nx' --out o",
        r"$lab render $root/scenes/grid/config.txt $root/scenes/grid/scene.txt $'\e[2J\nx/y.png'",
        r"printf 'sph\x1b[2Jere: 1\n' > scene; $lab inspect scene; $lab inspect $'\e[2J\nx'",
    ];
    for line in lines {
        let message = bash_complaint(&folder, line);
        assert!(!message.contains('\u{1b}') && message.contains(r"\u{1b}[2J"), "{line}: {message}");
    }
    // The message about an unknown command repeats the argument, but without the control character.
    assert!(!bash_complaint(&folder, r"$lab $'\e[2J\nx'").contains('\u{1b}'));
}
