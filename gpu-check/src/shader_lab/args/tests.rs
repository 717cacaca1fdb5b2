//! Tests of valid command lines, and of the messages for wrong ones.

use super::*;

const NEEDED: &str = "mine.wgsl --config c --scene s --out o.png";

fn parsed(text: &str) -> Result<Arguments, String> {
    let line = ["shader-lab"].into_iter().chain(text.split_whitespace()).map(OsString::from);
    Arguments::read(line).map_err(|error| error.render().to_string())
}

fn options(text: &str) -> Options {
    let arguments = parsed(&format!("{NEEDED} {text}")).unwrap_or_else(|message| panic!("{message}"));
    arguments.options.expect("there are options")
}

#[test]
fn a_missing_or_wrong_argument_is_named() {
    for (text, message) in [
        ("", "<MODULES>"),
        ("mine.wgsl --scene s --out o", "--config <FILE>"),
        ("mine.wgsl --config", "a value is required for '--config <FILE>'"),
        ("--secne s", "a similar argument exists: '--scene'"),
        ("mine.wgsl --config c --scene s --out o.jpg", "a picture cannot be written as .jpg"),
        ("- --config - --scene s --out o.png", "can be only one of"),
        ("- --config c --scene s --out o.png --watch", "--watch needs files"),
        ("mine.wgsl --template t", "cannot be used with"),
        ("NEEDED --set own", "it is not NAME=VALUE"),
        ("NEEDED --set own=red", "[red] is not a number"),
        ("NEEDED --pixel 1", "2 values required"),
        ("NEEDED --scatter statement", "--samples"),
        ("NEEDED --samples --scatter mine", "[possible values: statement, published]"),
        ("NEEDED --samples --pixel 1 2", "cannot be used with '--pixel"),
        ("NEEDED --samples --first-difference", "cannot be used with '--first-difference'"),
    ] {
        let fault = parsed(&text.replace("NEEDED", NEEDED)).expect_err(text);
        assert!(fault.starts_with("error: ") && fault.contains(message), "{text}: {fault}");
    }
    assert!(parsed("mine.wgsl --config c --scene s --out -").is_ok());
    assert_eq!(parsed("--template t").map(|arguments| arguments.template), Ok(Some("t".into())));
}

#[test]
fn the_ending_of_a_name_must_be_that_of_a_picture() {
    for name in ["a.png", "a.PPM", "-", "/dev/stdout"] {
        assert_eq!(check_name(Path::new(name)), Ok(()), "{name}");
    }
    assert!(check_name(Path::new("a.jpg")).is_err_and(|message| message.contains("must end in .png or .ppm")));
}

#[cfg(unix)]
#[test]
fn names_of_files_may_be_any_bytes() {
    use std::os::unix::ffi::OsStringExt;

    let name = OsString::from_vec(b"m\xff.wgsl".to_vec());
    let line = ["shader-lab".into(), name.clone()];
    let line = line.into_iter().chain("--config c --scene s --out o".split(' ').map(OsString::from));
    let options = Arguments::read(line).expect("they are names").options.expect("there are options");
    assert!(options.modules.as_os_str() == name);
    let unknown = OsString::from_vec(b"--\xff".to_vec());
    let fault = Arguments::read(["shader-lab".into(), unknown]).expect_err("there is no such option");
    assert!(fault.render().to_string().contains("unexpected argument '--\u{fffd}'"), "{fault}");
}

#[test]
fn options_are_read() {
    let read = options("--f32 --pixel 3 4 --watch --set own=2.5");
    assert_eq!((read.precision(), read.watch), (Precision::F32, true));
    assert_eq!((read.pixel(), read.constants), (Some([3, 4]), vec![("own".to_owned(), 2.5)]));
    assert!(!options("").no_sync && !options("").first_difference);
    assert!(options("--first-difference").first_difference && options("--no-sync").no_sync);
}

#[test]
fn features_are_set_a_depth_must_be_whole_and_other_constants_are_left() {
    let options = options("--set has_metal=false --set max_depth=2 --set brightness=2");
    let (features, own) = options.apply(Features::all(5)).expect("they are valid");
    assert_eq!(features, Features { has_metal: false, ..Features::all(2) });
    assert_eq!(own, [("brightness", 2.0)]);
    let message = self::options("--set max_depth=1.5").apply(Features::all(5)).expect_err("it is a fraction");
    assert!(message.starts_with("--set max_depth: 1.5 is not a whole number"), "{message}");
}

#[test]
fn random_numbers_have_the_convention_of_the_statement_unless_another_is_named() {
    assert_eq!(options("").convention(), None);
    assert_eq!(options("--samples").convention(), Some(Convention::Statement));
    assert_eq!(options("--scatter published --samples").convention(), Some(Convention::Published));
}
