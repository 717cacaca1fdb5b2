//! Tests of the answers to the page's requests.

use std::fs;

use test_support::folder::Folder;
use test_support::{digest, golden};

use super::*;

/// A page of one file, as `web/build` makes it.
const INDEX: &str = "<!doctype html><meta name=\"served-by\" content=\"\">";

/// A view of two small files in a folder.
fn view() -> (Folder, View) {
    let folder = Folder::new();
    let write = |name: &str, text: &str| {
        let path = folder.file(name);
        fs::write(&path, text).expect("the folder is writable");
        path
    };
    let config = write("config.txt", "image_width: 8\naspect_ratio: 1 1\n");
    let scene = write("scene.txt", "matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n");
    fs::create_dir_all(folder.path().join("site/scenes")).expect("the folder is writable");
    write("site/index.html", INDEX);
    write("site/scenes/names.json", "[]");
    let site = Site::read(&folder.path().join("site")).expect("it has a page");
    let view = View::new(site, config, scene, Options::default());
    (folder, view)
}

fn asked(view: &View, method: &str, path: &str, body: &str) -> (&'static str, String) {
    let request = Request { method: method.to_owned(), path: path.to_owned(), body: body.into() };
    let answer = view.answer(&request);
    (&answer.status[..3], String::from_utf8_lossy(&answer.body).into_owned())
}

#[test]
fn the_files_of_the_page_are_served_and_no_others() {
    let (_folder, view) = view();
    let page = INDEX.replace("content=\"\"", "content=\"render-lab view\"");
    for path in ["/", "/index.html", "/?a"] {
        assert_eq!(asked(&view, "GET", path, ""), ("200", page.clone()), "{path}");
    }
    assert_eq!(asked(&view, "GET", "/scenes/names.json", "").0, "200");
    for path in ["/../config.txt", "/config.txt", "//etc/passwd", "", "/scenes", "/view/other"] {
        assert_eq!(asked(&view, "GET", path, "").0, "404", "{path}");
    }
    assert_eq!(asked(&view, "DELETE", "/", "").0, "405");
    assert_eq!(asked(&view, "POST", "/", "").0, "404");
}

#[test]
fn a_folder_without_the_page_is_refused_with_the_remedy() {
    let folder = Folder::new();
    let message = |folder: &Folder| match Site::read(folder.path()) {
        Err(crate::Failure::Other(message)) => message,
        other => panic!("{other:?}"),
    };
    assert!(
        message(&folder).ends_with("does not have the page; build it with web/build, or name its folder with --site")
    );
    fs::write(folder.file("index.html"), "<!doctype html>").expect("the folder is writable");
    assert!(message(&folder).contains("is of another version; build it with web/build"));
}

#[test]
fn the_input_files_are_given_with_a_version_that_changes_with_them() {
    let (_folder, view) = view();
    let (status, json) = asked(&view, "GET", "/view/files", "");
    let files: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    assert_eq!(status, "200");
    assert_eq!(files["config"], "image_width: 8\naspect_ratio: 1 1\n");
    let version = asked(&view, "GET", "/view/version", "").1;
    assert_eq!(files["version"], version.as_str());
    fs::write(&view.scene, "").expect("the folder is writable");
    assert_ne!(asked(&view, "GET", "/view/version", "").1, version);
    fs::remove_file(&view.scene).expect("the folder is writable");
    let (status, message) = asked(&view, "GET", "/view/files", "");
    assert!(status == "404" && message.starts_with("Cannot read file ["), "{message}");
}

/// Returns the body that asks to save the camera at `position`.
fn camera(version: &str, position: &str) -> String {
    let position = format!("camera_position: {position}");
    let lines = [&position[..], "camera_target: 0 0 1", "camera_north: 0 1 0"];
    serde_json::json!({ "version": version, "lines": lines }).to_string()
}

#[test]
fn a_camera_is_saved_into_the_configuration_that_the_page_has_read() {
    let (_folder, view) = view();
    let config = || fs::read_to_string(&view.config).expect("it is text");
    let save = |body: &str| asked(&view, "POST", "/view/camera", body);
    let version = || asked(&view, "GET", "/view/version", "").1;
    let first = version();
    assert_eq!(asked(&view, "GET", "/view/camera", "").0, "404", "a link saves nothing");
    let (status, answered) = save(&camera(&first, "0 0 -5"));
    assert_eq!((status, &answered), ("200", &version()), "the answer is the new version");
    let written =
        "image_width: 8\naspect_ratio: 1 1\ncamera_position: 0 0 -5\ncamera_target: 0 0 1\ncamera_north: 0 1 0\n";
    assert_eq!(config(), written);
    // The page has not read this file.
    assert_eq!(save(&camera(&first, "0 0 -6")).0, "409");
    let edited = format!("{written}max_depth: 7\n");
    fs::write(&view.config, &edited).expect("the folder is writable");
    assert_eq!(save(&camera(&answered, "0 0 -6")).0, "409");
    assert_eq!(config(), edited, "the file is as it was");
    assert_eq!(save(&camera(&version(), "0 0 -6")).0, "200");
    assert_eq!(config(), edited.replace("0 0 -5", "0 0 -6"));
}

#[test]
fn a_camera_that_cannot_be_saved_leaves_the_configuration() {
    let (folder, view) = view();
    let before = fs::read_to_string(&view.config).expect("it is text");
    let save = |body: &str| asked(&view, "POST", "/view/camera", body);
    let version = || asked(&view, "GET", "/view/version", "").1;
    assert_eq!(save("{}").0, "422");
    assert_eq!(save(&camera(&version(), &"1".repeat(5000))).0, "413");
    assert_eq!(save(&camera(&version(), "0 0 0\nmax_depth: 9")).0, "422");
    let (status, message) = save(&camera(&version(), "0 0 1"));
    assert!(status == "422" && message.contains("is the same point as camera_target"), "{message}");
    assert_eq!(fs::read_to_string(&view.config).expect("it is text"), before);
    fs::remove_file(&view.config).expect("the folder is writable");
    assert_eq!(save(&camera(&version(), "0 0 -5")).0, "422");
    fs::create_dir(&view.config).expect("the folder is writable");
    let (status, message) = save(&camera(&version(), "0 0 -5"));
    assert!(status == "422" && message.ends_with("is not a regular file"), "{message}");
    let names = fs::read_dir(folder.path()).expect("it is there").count();
    assert_eq!(names, 3, "no temporary file is left");
}

#[test]
fn a_picture_has_the_bytes_of_the_evaluated_program() {
    let (_folder, view) = view();
    let cases: Vec<_> =
        golden::cases().into_iter().filter(|case| case.scatter == cpu::Scatter::Statement).take(4).collect();
    assert_eq!(cases.len(), 4);
    for (number, case) in cases.iter().enumerate() {
        let [config, scene] =
            [&case.config, &case.scene].map(|path| fs::read_to_string(path).expect("it is committed"));
        let body = serde_json::json!({ "config": config, "scene": scene }).to_string();
        let (status, ppm) = asked(&view, "POST", &format!("/view/render/{number}"), &body);
        assert_eq!(
            (status, digest::sha256(ppm.as_bytes())),
            ("200", case.digest().expect("it is listed")),
            "{}",
            case.name
        );
        let [done, all]: [usize; 2] = [0, 1].map(|place| {
            let progress = asked(&view, "GET", "/view/progress", "").1;
            progress.split(' ').nth(place).and_then(|count| count.parse().ok()).expect("two numbers")
        });
        assert!(done == all && all > 0, "all rows are finished");
    }
}

#[test]
fn a_picture_that_cannot_be_made_gets_the_words_of_the_renderer() {
    let (_folder, view) = view();
    let render = |config: &str| {
        let body = serde_json::json!({ "config": config, "scene": "" }).to_string();
        asked(&view, "POST", "/view/render/1", &body)
    };
    assert_eq!(render("gama: 2"), ("422", "Unknown configuration key: [gama:]".to_owned()));
    assert_eq!(render("image_width: 20000\naspect_ratio: 1 1\n").0, "413");
    assert_eq!(asked(&view, "POST", "/view/render/1", "{").0, "422");
    assert_eq!(asked(&view, "POST", "/view/render/x", "{}").0, "404");
}

#[test]
fn only_the_picture_with_the_number_is_cancelled() {
    let (_folder, view) = view();
    // This picture takes minutes, and each of its rows a part of a second. The camera is inside the sphere.
    let scene = "matte: grey .5 .5 .5\nsphere: 0 0 -10 5 grey\n";
    let body = serde_json::json!({ "config": "samples_per_pixel: 200\n", "scene": scene }).to_string();
    std::thread::scope(|scope| {
        let picture = scope.spawn(|| asked(&view, "POST", "/view/render/7", &body));
        while asked(&view, "GET", "/view/progress", "").1 == "0 0" {
            std::thread::yield_now();
        }
        assert_eq!(asked(&view, "POST", "/view/cancel/8", "").0, "200");
        assert!(!picture.is_finished());
        assert_eq!(asked(&view, "POST", "/view/cancel/7", "").0, "200");
        assert_eq!(picture.join().expect("it does not panic").0, "409");
    });
}
