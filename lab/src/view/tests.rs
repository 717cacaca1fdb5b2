//! Tests of the answers to the page's requests.

use std::fs;

use test_support::folder::Folder;

use super::*;

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
    let view = View::new(site, inputs, Options::default());
    (folder, view)
}

fn asked(view: &View, method: &str, path: &str, body: &str) -> (&'static str, String) {
    let answer = view.answer(&Request { method: method.to_owned(), path: path.to_owned(), body: body.into() });
    (&answer.status[..3], String::from_utf8_lossy(&answer.body).into_owned())
}

/// Checks that the request is refused with this status, and returns the message.
fn refused(view: &View, method: &str, path: &str, body: &str, expected: &str) -> String {
    let (status, message) = asked(view, method, path, body);
    assert_eq!(status, expected, "{path}: {message}");
    message
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

/// Returns the versions of both files.
fn versions(view: &View) -> [String; 2] {
    let both = asked(view, "GET", "/view/version", "").1;
    let (config, scene) = both.split_once(' ').expect("there are two");
    [config.to_owned(), scene.to_owned()]
}

#[test]
fn the_input_files_are_given_with_versions_that_change_with_them() {
    let (_folder, view) = view();
    let versions_before = versions(&view);
    let (status, answer) = asked(&view, "GET", "/view/files", "");
    let (head, texts) = answer.split_once('\n').expect("the head is a line");
    let head: serde_json::Value = serde_json::from_str(head).expect("it is JSON");
    let path = view.inputs.each_ref().map(|input| input.path().to_str().expect("it is a text"));
    let expected = serde_json::json!({ "version": versions_before, "path": path, "length": 33 });
    assert_eq!((status, head, texts), ("200", expected, &*format!("{CONFIG}{SCENE}")));
    fs::write(path[1], "").expect("the folder is writable");
    assert_eq!((&versions(&view)[0], versions(&view)[1] == versions_before[1]), (&versions_before[0], false));
}

#[test]
fn a_pipe_or_a_link_in_the_place_of_a_file_is_refused_at_once() {
    let (folder, view) = view();
    let config = view.inputs[0].path();
    let before = versions(&view)[0].clone();
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
        assert!(refused(&view, "POST", "/view/config", &format!("{before}\n"), "422").contains(reason), "{reason}");
        assert_eq!(versions(&view)[0], "missing");
        refused(&view, "POST", "/view/config", "missing\ngamma: 1\n", "409");
    }
    assert_eq!(folder.read("secret.txt"), b"gamma: 3\n");
    assert_eq!(folder.names(), ["config.txt", "scene.txt", "secret.txt", "site"], "no temporary file is left");
}

#[test]
fn a_text_is_saved_over_the_version_that_the_page_has_read_and_over_no_other() {
    let (folder, view) = view();
    for (index, name) in ["config", "scene"].into_iter().enumerate() {
        let (path, file) = (format!("/view/{name}"), format!("{name}.txt"));
        let save = |version: &str, text: &str| asked(&view, "POST", &path, &format!("{version}\n{text}"));
        let first = versions(&view)[index].clone();
        assert_eq!(asked(&view, "GET", &path, "").0, "404", "a link saves nothing");
        // A text with faults is saved too: the user goes on tomorrow.
        let (status, second) = save(&first, "gama: 2\r\n\nä");
        assert_eq!((status, &second), ("200", &versions(&view)[index]), "the answer is the new version");
        assert_eq!(folder.read(&file), "gama: 2\r\n\nä".as_bytes());
        assert_eq!(save(&first, "x").0, "409", "the page has not read this file");
        fs::write(folder.file(&file), "edited").expect("the folder is writable");
        assert_eq!(save(&second, "x").0, "409");
        assert_eq!(save("missing", "x").0, "409");
        assert_eq!(folder.read(&file), b"edited", "the edit stays");
        assert_eq!(save(&versions(&view)[index], "").0, "200");
        assert_eq!(folder.read(&file), b"");
    }
}

#[test]
fn a_file_that_does_not_exist_is_empty_and_is_created_once() {
    let folder = Folder::new();
    fs::create_dir_all(folder.file("site")).expect("the folder is writable");
    folder.write("site/index.html", INDEX);
    let site = Site::read(&folder.file("site")).expect("it has a page");
    let inputs = ["config.txt", "scene.txt"].map(|name| Input::new(&folder.file(name)).expect("its folder exists"));
    let view = View::new(site, inputs, Options { sync: true });
    assert_eq!(versions(&view), ["missing", "missing"]);
    let (status, answer) = asked(&view, "GET", "/view/files", "");
    assert!(status == "200" && answer.ends_with("\"length\":0}\n"), "{answer}");
    let (status, version) = asked(&view, "POST", "/view/scene", "missing\nmatte: m 1 1 1\n");
    assert_eq!((status, &version), ("200", &versions(&view)[1]));
    refused(&view, "POST", "/view/scene", "missing\n", "409");
    assert_eq!(folder.read("scene.txt"), b"matte: m 1 1 1\n");
    assert_eq!(folder.names(), ["scene.txt", "site"], "no temporary file is left");
    assert!(Input::new(&folder.file("none/config.txt")).is_err(), "there is no folder");
}

#[test]
fn what_is_no_text_for_a_file_leaves_the_file() {
    let (folder, view) = view();
    refused(&view, "POST", "/view/config", "", "422");
    let version = versions(&view)[0].clone();
    let body = [version.as_bytes(), b"\n\xff"].concat();
    let request = Request { method: "POST".to_owned(), path: "/view/config".to_owned(), body };
    assert!(view.answer(&request).status.starts_with("422"), "it is not UTF-8");
    let most = input::MAX_TEXT as usize;
    refused(&view, "POST", "/view/config", &format!("{version}\n{}", "\n".repeat(most + 1)), "413");
    assert_eq!(folder.read("config.txt"), CONFIG.as_bytes());
    let body = format!("{version}\n{}", "\n".repeat(most));
    assert!(body.len() <= loopback::request::MAX_BODY, "the server takes the largest text");
    assert_eq!(asked(&view, "POST", "/view/config", &body).0, "200");
    fs::remove_file(view.inputs[0].path()).expect("the folder is writable");
    fs::create_dir(view.inputs[0].path()).expect("the folder is writable");
    let message = refused(&view, "POST", "/view/config", &format!("{version}\n"), "422");
    assert!(message.contains("it is not a regular file"), "{message}");
}
