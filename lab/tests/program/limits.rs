//! Tests of inputs beyond the limits of `docs/testing.md`, of outputs that are also inputs, and of standard streams
//! that cannot be written.

use std::fs::File;

use test_support::folder::Folder;

use crate::{bash, bash_complaint};

#[test]
fn a_picture_file_of_exactly_the_limit_is_read_and_one_byte_more_is_refused() {
    let folder = Folder::new();
    let header = "P6 1 1 255\n";
    let path = folder.write("holes.ppm", header);
    let most = lab::picture::MAX_FILE_BYTES;
    let pixels = format!("{} bytes of pixels where 1 x 1 are announced", most - header.len() as u64);
    for (bytes, reason) in [(most, &pixels[..]), (most + 1, "it is larger than 1073741824 bytes")] {
        let file = File::options().write(true).open(&path);
        file.and_then(|file| file.set_len(bytes)).expect("holes take no place");
        let message = bash_complaint(&folder, "$lab compare holes.ppm holes.ppm");
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
    let same = "camera_position: 0 0 0\n";
    folder.write("same", same);
    folder.write("empty", "");
    bash(
        &folder,
        "mkdir grades; mkfifo pipe grades/grade.toml; printf 'P3 1 1 255 0 0 0' | tee o | sed 's/1/2/; s/$/ 0 0 0/' > two",
    );
    let names = folder.names();
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
        ("generate c s --objects 10000001", "a number from 0 to 10000000 is needed"),
        ("generate c s --cylinders 1.5", "a number from 0 to 1 is needed"),
        ("generate c s --cylinders nan", "a number from 0 to 1 is needed"),
        ("generate c s --matte -1", "a number that is not negative is needed"),
        ("generate c s --extent 0", "a number from 1e-100 to 1e100 is needed"),
        ("generate c s --extent 1e300", "a number from 1e-100 to 1e100 is needed"),
        (
            "generate c s --matte 0 --metal 0 --refractive 0",
            "one of --matte, --metal and --refractive must be positive",
        ),
        ("generate c /nowhere/s", "/nowhere/s"),
        ("generate - -", "need a file each"),
        ("render empty empty o.ppm --crop 0,0,1921,1", "--crop goes beyond the picture of 1920 x 1080 pixels"),
        ("render empty empty o.ppm --crop 0,1079,1,2", "--crop goes beyond the picture of 1920 x 1080 pixels"),
        ("render empty empty o.ppm --crop 0,1,1,18446744073709551615", "--crop goes beyond the picture"),
        ("render same empty o.ppm --crop 1,2,0,4", "four numbers are needed, COLUMN,ROW,WIDTH,HEIGHT"),
        ("render same empty o.ppm --crop 1,2,3,4,5", "four numbers are needed, COLUMN,ROW,WIDTH,HEIGHT"),
        ("render same empty o.ppm --crop -1,2,3,4", "four numbers are needed, COLUMN,ROW,WIDTH,HEIGHT"),
        ("render same empty o.ppm --rows 3..3", "two rows are needed, the second larger, as in 0..100 or ..100"),
        ("render same empty o.ppm --rows 10", "two rows are needed, the second larger, as in 0..100 or ..100"),
        (
            "render same empty o.jpg",
            "o.jpg: a picture cannot be written as .jpg; its name must end in .ppm, .png, .pfm, .npy or .exr",
        ),
        ("render same empty o.exr --checkpoint c", "are for pictures of colours"),
        ("render - - o.ppm", "can be only one of the files"),
        ("render same empty - --json", "both write to standard output"),
        (
            "render empty empty same --set gamma=0",
            "Error: --set gamma=0: gamma: [0] is not a number above 0; the line is: ",
        ),
        ("render empty empty same --set image_width=100000000", "--set image_width=100000000: the image is too large"),
        ("render /nowhere empty same", "Error: Cannot read file [/nowhere]: "),
        ("render empty empty /nowhere/o.png", "Error: Cannot write file [/nowhere/o.png]: "),
        ("render empty empty o.png --samples 5", "write '--set samples_per_pixel=5'"),
        ("animate empty empty o.png --width=9", "write '--set image_width=9'"),
        ("render empty empty o.png --heatmapp x.png", "'--heatmap' is an option of compare"),
        ("render empty empty o.png --cropp 1", "a similar argument exists: '--crop'"),
        ("render empty empty", "required arguments were not provided"),
        ("animate same empty -", "no standard output (-)"),
        ("compare o o --max 3", "--heatmap"),
        ("compare o o --heatmap map.jpg", "its name must end in .png or .ppm"),
        ("compare o same", "same: neither PPM"),
        ("compare o two", "different sizes: 1 x 1 and 2 x 1"),
        ("compare o /nowhere", "Error: /nowhere: "),
        ("convert same empty x.png", "the third file must be a scene to write, whose name ends in .pbrt or .xml"),
        ("bench all --part 4/3 --out o.json", "I/N is needed, as in 3/10"),
        ("bench error --out /nowhere/e.json", "/nowhere/e.json"),
        ("bench merge --out o.json same", "same: not the JSON that `render-lab bench ... --out FILE` writes: "),
        ("report same --out r", "same: not the JSON that `render-lab bench ... --out FILE` writes: "),
        ("check /no/such/program", "/no/such/program"),
        ("help nonsense", "invalid value 'nonsense' for '[TOPIC]'"),
        ("help rendr", "a similar value exists: 'render'"),
        ("help bench scal", "no command or topic [scal]; did you mean [scale]?"),
        ("help bench nonsense", "no command or topic [nonsense]"),
        ("generate c s --cylinders 0,5", "write a decimal point, not a comma"),
        ("bench diff <(printf '\\xff\\xfe{') x", "the byte order mark of UTF-16; save the file as UTF-8"),
    ] {
        let message = bash_complaint(&folder, &format!("$lab {line}"));
        assert!(message.contains(words) && folder.names() == names, "{line}: {message}");
    }
    assert_eq!(folder.read("same"), same.as_bytes(), "the old file stays");
}

#[test]
fn a_pipe_gives_its_content_once_and_a_small_stack_is_enough() {
    let folder = Folder::new();
    let [config, scene] = ["config.txt", "scene.txt"].map(|name| format!("$root/scenes/grid/{name}"));
    let pipes = format!("$lab render <(cat {config}; echo image_width: 16) <(cat {scene}) o.png --json");
    let small = format!("ulimit -s 256; $lab render {config} {scene} o.png --set image_width=16 --json");
    for line in [pipes, small] {
        let output = bash(&folder, &line);
        let width = String::from_utf8_lossy(&output.stdout).contains("\"width\": 16");
        assert!(output.status.success() && width, "{line}: {output:?}");
    }
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
