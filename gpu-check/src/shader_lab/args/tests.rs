//! Tests of valid command lines, and of the messages for wrong ones.

use super::*;

const NEEDED: &str = "mine.wgsl --config c --scene s --out o.png";

fn parsed(text: &str) -> Result<Command, String> {
    parse(text.split_whitespace().map(OsString::from))
}

fn options(text: &str) -> Options {
    match parsed(&format!("{NEEDED} {text}")) {
        Ok(Command::Render(options)) => options,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_missing_or_wrong_argument_is_named() {
    assert!(parsed("--config c").is_err_and(|message| message.contains("--template writes one")));
    assert_eq!(parsed("mine.wgsl --scene s --out o"), Err("--config is missing".to_owned()));
    assert_eq!(parsed("mine.wgsl --config"), Err("--config needs a file after it".to_owned()));
    assert_eq!(parsed("--frobnicate"), Err("there is no option [--frobnicate]".to_owned()));
    assert_eq!(parsed("--secne s"), Err("there is no option [--secne]; did you mean [--scene]?".to_owned()));
    assert!(parsed("mine.wgsl --config c --scene s --out o.jpg").is_err_and(|message| message.contains(".jpg")));
    assert!(parsed("- --config - --scene s --out o.png").is_err_and(|message| message.contains("only one of")));
    assert!(OPTIONS.iter().all(|option| USAGE.contains(option) || ["--help", "--f64"].contains(option)));
}

#[cfg(unix)]
#[test]
fn names_of_files_may_be_any_bytes() {
    use std::os::unix::ffi::OsStringExt;

    let name = OsString::from_vec(b"m\xff.wgsl".to_vec());
    let options = [name.clone()].into_iter().chain("--config c --scene s --out o".split(' ').map(OsString::from));
    assert!(matches!(parse(options), Ok(Command::Render(options)) if options.modules.as_os_str() == name));
    let unknown = OsString::from_vec(b"--\xff".to_vec());
    assert_eq!(parse([unknown]), Err("there is no option [--\u{fffd}]".to_owned()));
}

#[test]
fn options_are_read() {
    let read = options("--f32 --show normal --pixel 3 4 --watch --set own=2.5");
    assert_eq!((read.precision, read.view, read.watch), (Precision::F32, Some(View::Normal), true));
    assert_eq!((read.pixel, read.constants), (Some([3, 4]), vec![("own".to_owned(), 2.5)]));
    assert!(options("").sync && !options("").first_difference);
    assert!(options("--first-difference").first_difference);
    let refused = parsed(&format!("{NEEDED} --first-difference --samples"));
    assert!(refused.is_err_and(|message| message.contains("does not go with --samples")));
    assert!(!options("--no-sync").sync);
}

#[test]
fn features_are_set_and_other_constants_left() {
    let options = options("--set has_metal=false --set max_depth=2 --set brightness=2");
    let (features, own) = options.apply(Features::all(5)).expect("they are valid");
    assert_eq!(features, Features { has_metal: false, ..Features::all(2) });
    assert_eq!(own, [("brightness", 2.0)]);
}

#[test]
fn a_depth_that_is_no_count_is_refused() {
    let message = options("--set max_depth=1.5").apply(Features::all(5)).expect_err("it is a fraction");
    assert!(message.starts_with("--set max_depth: 1.5 is not a whole number"), "{message}");
}

#[test]
fn random_numbers_need_one_option_and_their_convention_another() {
    assert_eq!(options("").samples, None);
    assert_eq!(options("--samples").samples, Some(Convention::Statement));
    assert_eq!(options("--scatter published --samples").samples, Some(Convention::Published));
    assert!(options("--samples --show difference").samples.is_some());
    for (text, message) in [
        ("--scatter statement", "--scatter needs --samples"),
        ("--samples --scatter mine", "--scatter: [mine] is neither statement nor published"),
        ("--samples --pixel 1 2", "--pixel follows one ray"),
        ("--samples --show lambda", "with --samples, --show shows only the difference"),
    ] {
        let fault = parsed(&format!("{NEEDED} {text}")).expect_err("it is refused");
        assert!(fault.starts_with(message), "{fault}");
    }
}
