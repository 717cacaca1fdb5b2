//! Tests of the answers to the page's requests. Those for pictures are in `pictures`.

use std::fs;
use std::net::{TcpListener, TcpStream};

use test_support::folder::Folder;

use super::*;

mod pictures;

/// A page of one file, as `web/build` makes it.
const INDEX: &str = "<!doctype html><meta name=\"served-by\" content=\"\">";

const CONFIG: &str = "image_width: 8\naspect_ratio: 1 1\n";
const SCENE: &str = "matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n";

/// A view of two small files in a folder.
fn view() -> (Folder, View) {
    let folder = Folder::with_scene(CONFIG, SCENE);
    fs::create_dir_all(folder.file("site/scenes")).expect("the folder is writable");
    folder.write("site/index.html", INDEX);
    folder.write("site/scenes/names.json", "[]");
    let site = Site::read(&folder.file("site")).expect("it has a page");
    let inputs = ["config.txt", "scene.txt"].map(|name| Input::new(&folder.file(name)).expect("it is a file"));
    let view = View::new(site, inputs, Budget::new(BYTES), Options::default());
    (folder, view)
}

/// The bytes of the tests' budget.
const BYTES: usize = loopback::MAX_BYTES;

/// Both ends of a connection: that of the client and that of the server.
fn connection() -> [TcpStream; 2] {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let client = TcpStream::connect(listener.local_addr().expect("it listens")).expect("it listens");
    [client, listener.accept().expect("there is a connection").0]
}

fn asked(view: &View, method: &str, path: &str, body: &str) -> (&'static str, String) {
    let [_client, server] = connection();
    asked_by(&server, view, method, path, body)
}

/// Checks that the request is refused with this status, and returns the message.
fn refused(view: &View, method: &str, path: &str, body: &str, expected: &str) -> String {
    let (status, message) = asked(view, method, path, body);
    assert_eq!(status, expected, "{path}: {message}");
    message
}

fn asked_by(server: &TcpStream, view: &View, method: &str, path: &str, body: &str) -> (&'static str, String) {
    let answer = answer(server, view, method, path, body);
    (&answer.status[..3], String::from_utf8_lossy(&answer.body).into_owned())
}

fn answer(server: &TcpStream, view: &View, method: &str, path: &str, body: &str) -> Answer {
    let request = Request { method: method.to_owned(), path: path.to_owned(), body: body.into() };
    view.answer(&request, &Client::new(server))
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
    folder.write("index.html", "<!doctype html>");
    assert!(message(&folder).contains("is of another version; build it with web/build"));
}

#[test]
fn the_input_files_are_given_with_a_version_that_changes_with_them() {
    let (_folder, view) = view();
    let version = asked(&view, "GET", "/view/version", "").1;
    assert_eq!(asked(&view, "GET", "/view/files", ""), ("200", format!("{version} 33\n{CONFIG}{SCENE}")));
    fs::write(view.scene.path(), "").expect("the folder is writable");
    assert_ne!(asked(&view, "GET", "/view/version", "").1, version);
    fs::remove_file(view.scene.path()).expect("the folder is writable");
    assert!(refused(&view, "GET", "/view/files", "", "404").starts_with("Cannot read file ["));
}

#[test]
fn a_pipe_or_a_link_in_the_place_of_a_file_is_refused_at_once() {
    let (folder, view) = view();
    let config = view.config.path();
    let secret = folder.write("secret.txt", "gamma: 3\n");
    // In the place of the configuration: a named pipe, or a link to the target.
    for (target, reason) in [
        (None, "it is not a regular file"),
        (Some("/dev/zero".as_ref()), "symbolic links"),
        (Some(&*secret), "symbolic links"),
    ] {
        fs::remove_file(config).expect("the folder is writable");
        match target {
            None => nix::unistd::mkfifo(config, nix::sys::stat::Mode::S_IRWXU).expect("the folder is writable"),
            Some(target) => std::os::unix::fs::symlink(target, config).expect("the folder is writable"),
        }
        assert!(refused(&view, "GET", "/view/files", "", "404").contains(reason), "{reason}");
        assert!(refused(&view, "POST", "/view/camera", &camera("", "0 0 -5"), "422").contains(reason), "{reason}");
        assert!(asked(&view, "GET", "/view/version", "").1.starts_with("missing-"));
    }
    assert_eq!(folder.read("secret.txt"), b"gamma: 3\n");
}

#[test]
fn the_answer_with_the_files_is_counted_and_refused_with_the_numbers() {
    let (_folder, mut view) = view();
    let texts = 33 + 42;
    view.budget = Budget::new(2 * texts + 1000);
    let share = view.budget.take(1).expect("it fits");
    let (status, message) = asked(&view, "GET", "/view/files", "");
    assert_eq!(
        (status, message.split(';').next()),
        ("503", Some("this takes 1150 bytes, and 1149 of 1150 bytes are free"))
    );
    drop(share);
    let [_client, server] = connection();
    let answer = answer(&server, &view, "GET", "/view/files", "");
    assert_eq!((answer.status, view.budget.taken()), ("200 OK", answer.body.len()), "until it is sent");
    drop(answer);
    assert_eq!(view.budget.taken(), 0);
}

/// Returns the body that asks to save the camera at `position`.
fn camera(version: &str, position: &str) -> String {
    let position = format!("camera_position: {position}");
    let lines = [&position[..], "camera_target: 0 0 1", "camera_north: 0 1 0"];
    serde_json::json!({ "version": version, "lines": lines }).to_string()
}

#[test]
fn a_camera_is_saved_into_the_configuration_that_the_page_has_read() {
    let (folder, view) = view();
    let config = || String::from_utf8(folder.read("config.txt")).expect("it is text");
    let save = |body: &str| asked(&view, "POST", "/view/camera", body);
    let version = || asked(&view, "GET", "/view/version", "").1;
    let first = version();
    assert_eq!(asked(&view, "GET", "/view/camera", "").0, "404", "a link saves nothing");
    let (status, answered) = save(&camera(&first, "0 0 -5"));
    assert_eq!((status, &answered), ("200", &version()), "the answer is the new version");
    let written = format!("{CONFIG}camera_position: 0 0 -5\ncamera_target: 0 0 1\ncamera_north: 0 1 0\n");
    assert_eq!(config(), written);
    // The page has not read this file.
    assert_eq!(save(&camera(&first, "0 0 -6")).0, "409");
    let edited = format!("{written}max_depth: 7\n");
    fs::write(view.config.path(), &edited).expect("the folder is writable");
    assert_eq!(save(&camera(&answered, "0 0 -6")).0, "409");
    assert_eq!(config(), edited, "the file is as it was");
    assert_eq!(save(&camera(&version(), "0 0 -6")).0, "200");
    assert_eq!(config(), edited.replace("0 0 -5", "0 0 -6"));
}

#[test]
fn a_camera_that_cannot_be_saved_leaves_the_configuration() {
    let (folder, view) = view();
    let version = || asked(&view, "GET", "/view/version", "").1;
    let refused = |body: &str, status| refused(&view, "POST", "/view/camera", body, status);
    refused("{}", "422");
    refused(&camera(&version(), &"1".repeat(5000)), "413");
    refused(&camera(&version(), "0 0 0\nmax_depth: 9"), "422");
    let message = refused(&camera(&version(), "0 0 1"), "422");
    assert!(message.contains("is the same point as camera_target"), "{message}");
    assert_eq!(folder.read("config.txt"), CONFIG.as_bytes());
    fs::remove_file(view.config.path()).expect("the folder is writable");
    refused(&camera(&version(), "0 0 -5"), "422");
    fs::create_dir(view.config.path()).expect("the folder is writable");
    let message = refused(&camera(&version(), "0 0 -5"), "422");
    assert!(message.contains("it is not a regular file"), "{message}");
    assert_eq!(folder.names(), ["config.txt", "scene.txt", "site"], "no temporary file is left");
}
