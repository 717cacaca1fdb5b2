//! Tests of the answers to the page's requests.

use std::fs;
use std::net::{TcpListener, TcpStream};
use std::time::{Duration, Instant};

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
    let inputs = [config, scene].map(|path| Input::new(&path).expect("it is a file"));
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

fn asked_by(server: &TcpStream, view: &View, method: &str, path: &str, body: &str) -> (&'static str, String) {
    let request = Request { method: method.to_owned(), path: path.to_owned(), body: body.into() };
    let answer = view.answer(&request, &Client::new(server));
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
    let version = asked(&view, "GET", "/view/version", "").1;
    let [config, scene] = ["image_width: 8\naspect_ratio: 1 1\n", "matte: grey .5 .5 .5\nsphere: 0 0 0 1 grey\n"];
    assert_eq!(asked(&view, "GET", "/view/files", ""), ("200", format!("{version} 33\n{config}{scene}")));
    fs::write(view.scene.path(), "").expect("the folder is writable");
    assert_ne!(asked(&view, "GET", "/view/version", "").1, version);
    fs::remove_file(view.scene.path()).expect("the folder is writable");
    let (status, message) = asked(&view, "GET", "/view/files", "");
    assert!(status == "404" && message.starts_with("Cannot read file ["), "{message}");
}

#[cfg(unix)]
#[test]
fn a_pipe_or_a_link_in_the_place_of_a_file_is_refused_at_once() {
    let (folder, view) = view();
    let config = view.config.path();
    let refused = |reason: &str| {
        let (status, message) = asked(&view, "GET", "/view/files", "");
        assert!(status == "404" && message.contains(reason), "{message}");
        let (status, message) = asked(&view, "POST", "/view/camera", &camera("", "0 0 -5"));
        assert!(status == "422" && message.contains(reason), "{message}");
        assert!(asked(&view, "GET", "/view/version", "").1.starts_with("missing-"));
    };
    fs::remove_file(config).expect("the folder is writable");
    nix::unistd::mkfifo(config, nix::sys::stat::Mode::S_IRWXU).expect("the folder is writable");
    refused("it is not a regular file");
    fs::remove_file(config).expect("the folder is writable");
    std::os::unix::fs::symlink("/dev/zero", config).expect("the folder is writable");
    refused("symbolic links");
    fs::remove_file(config).expect("the folder is writable");
    std::os::unix::fs::symlink(folder.write("secret.txt", "gamma: 3\n"), config).expect("the folder is writable");
    refused("symbolic links");
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
    let request = Request { method: "GET".to_owned(), path: "/view/files".to_owned(), body: Vec::new() };
    let answer = view.answer(&request, &Client::new(&server));
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
    let (_folder, view) = view();
    let config = || fs::read_to_string(view.config.path()).expect("it is text");
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
    fs::write(view.config.path(), &edited).expect("the folder is writable");
    assert_eq!(save(&camera(&answered, "0 0 -6")).0, "409");
    assert_eq!(config(), edited, "the file is as it was");
    assert_eq!(save(&camera(&version(), "0 0 -6")).0, "200");
    assert_eq!(config(), edited.replace("0 0 -5", "0 0 -6"));
}

#[test]
fn a_camera_that_cannot_be_saved_leaves_the_configuration() {
    let (folder, view) = view();
    let before = fs::read_to_string(view.config.path()).expect("it is text");
    let save = |body: &str| asked(&view, "POST", "/view/camera", body);
    let version = || asked(&view, "GET", "/view/version", "").1;
    assert_eq!(save("{}").0, "422");
    assert_eq!(save(&camera(&version(), &"1".repeat(5000))).0, "413");
    assert_eq!(save(&camera(&version(), "0 0 0\nmax_depth: 9")).0, "422");
    let (status, message) = save(&camera(&version(), "0 0 1"));
    assert!(status == "422" && message.contains("is the same point as camera_target"), "{message}");
    assert_eq!(fs::read_to_string(view.config.path()).expect("it is text"), before);
    fs::remove_file(view.config.path()).expect("the folder is writable");
    assert_eq!(save(&camera(&version(), "0 0 -5")).0, "422");
    fs::create_dir(view.config.path()).expect("the folder is writable");
    let (status, message) = save(&camera(&version(), "0 0 -5"));
    assert!(status == "422" && message.contains("it is not a regular file"), "{message}");
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
    let (status, message) = render("image_width: 33554433\naspect_ratio: 33554433 1\n");
    assert!(status == "413" && message.contains("33554433 pixels, and the page shows at most 33554432"), "{message}");
    assert_eq!(asked(&view, "POST", "/view/render/1", "{").0, "422");
    assert_eq!(asked(&view, "POST", "/view/render/x", "{}").0, "404");
}

/// Returns the body that asks for a picture.
fn texts(config: &str, scene: &str) -> String {
    serde_json::json!({ "config": config, "scene": scene }).to_string()
}

/// Pictures that would take longer than anyone waits: with most samples, and with a path between mirrors or in glass.
fn endless() -> [String; 3] {
    let one = "image_width: 1\naspect_ratio: 1 1\nsamples_per_pixel: 1\nmax_depth: 1000000000000000000\n";
    [
        texts("image_width: 8\nsamples_per_pixel: 9000000000000000000\n", "matte: m .5 .5 .5\nsphere: 0 0 0 1 m\n"),
        texts(
            &format!("{one}camera_position: 9.9 0 0\ncamera_target: 9.9 1 0\ncamera_north: 0 0 1\n"),
            "refractive: g 1.5\nsphere: 0 0 0 10 g\n",
        ),
        texts(
            &format!("{one}camera_position: 0 0 0\ncamera_target: 0 .3 -1\nfield_of_view: .001\n"),
            "refractive: g 1.5\nmetal: m 1 1 1 0\ncylinder: 0 0 4999990 1 0 0 10000000 g\ncylinder: 0 0 -5.5 .99 0 0 1 m\n",
        ),
    ]
}

/// Time after which a picture must have been cancelled, many times as long as the promised 100 ms.
const SOON: Duration = Duration::from_secs(3);

/// Waits until the picture that was requested last is being rendered.
fn until_rendering(view: &View) {
    while asked(view, "GET", "/view/progress", "").1 == "0 0" {
        std::thread::yield_now();
    }
    // From here on the renderer is between the start and the first row.
    std::thread::sleep(Duration::from_millis(20));
}

#[test]
fn only_the_picture_with_the_number_is_cancelled_and_soon() {
    for body in endless() {
        let (_folder, view) = view();
        std::thread::scope(|scope| {
            let picture = scope.spawn(|| asked(&view, "POST", "/view/render/7", &body));
            until_rendering(&view);
            assert_eq!(asked(&view, "POST", "/view/cancel/8", "").0, "200");
            assert!(!picture.is_finished());
            let start = Instant::now();
            assert_eq!(asked(&view, "POST", "/view/cancel/7", "").0, "200");
            assert_eq!(picture.join().expect("it does not panic").0, "409");
            assert!(start.elapsed() < SOON, "{:?}", start.elapsed());
            assert_eq!(view.budget.taken(), 0);
        });
    }
}

#[test]
fn a_picture_whose_client_has_gone_is_cancelled_and_the_next_one_comes_soon() {
    let small = texts("image_width: 8\n", "");
    for body in endless() {
        let (_folder, view) = view();
        std::thread::scope(|scope| {
            // As many clients go as there are connections. Only the first one is rendered before it goes.
            let gone: Vec<_> = (0..loopback::connections::MAX_CONNECTIONS as u32)
                .map(|number| {
                    let [client, server] = connection();
                    let (view, body) = (&view, &body);
                    let path = format!("/view/render/{number}");
                    let picture = scope.spawn(move || asked_by(&server, view, "POST", &path, body));
                    if number == 0 {
                        until_rendering(view);
                    }
                    drop(client);
                    picture
                })
                .collect();
            for picture in gone {
                assert_eq!(picture.join().expect("it does not panic").0, "409");
            }
            let start = Instant::now();
            assert_eq!(asked(&view, "POST", "/view/render/99", &small).0, "200");
            assert!(start.elapsed() < SOON, "{:?}", start.elapsed());
        });
    }
}

#[test]
fn a_new_picture_stops_the_one_before_it() {
    for body in endless() {
        let (_folder, view) = view();
        std::thread::scope(|scope| {
            let picture = scope.spawn(|| asked(&view, "POST", "/view/render/1", &body));
            until_rendering(&view);
            let start = Instant::now();
            assert_eq!(asked(&view, "POST", "/view/render/2", &texts("image_width: 8\n", "")).0, "200");
            assert!(start.elapsed() < SOON, "{:?}", start.elapsed());
            assert_eq!(picture.join().expect("it does not panic").0, "409");
        });
    }
}

#[test]
fn a_path_that_hits_too_many_surfaces_is_refused_with_the_number() {
    let (_folder, view) = view();
    let one = "image_width: 1\naspect_ratio: 1 1\nsamples_per_pixel: 1\nmax_depth:";
    let mirrors = "metal: m 1 1 1 0\nsphere: 0 0 -10 100 m\n";
    // The first surface of a path is not counted, and the last ray hits one that is not stored.
    let render = |depth: u64| asked(&view, "POST", "/view/render/1", &texts(&format!("{one} {depth}\n"), mirrors));
    assert_eq!(render((1 << 23) + 2).0, "200");
    let (status, message) = render((1 << 23) + 3);
    assert!(status == "413" && message.contains("more than 8388608 surfaces"), "{message}");
}

#[test]
fn a_picture_is_counted_and_one_that_does_not_fit_is_refused_with_the_numbers() {
    let (_folder, mut view) = view();
    let paths = 12 << 23;
    let budget = Budget::new(paths + 64 * 15);
    view.native = Native::new(budget.clone());
    let render = |pixels: u64| {
        let config = format!("image_width: {pixels}\naspect_ratio: {pixels} 1\n");
        let [_client, server] = connection();
        let body = texts(&config, "").into_bytes();
        let request = Request { method: "POST".to_owned(), path: "/view/render/1".to_owned(), body };
        view.answer(&request, &Client::new(&server))
    };
    let answer = render(64);
    assert_eq!((answer.status, budget.taken()), ("200 OK", answer.body.len()), "until it is sent");
    let refused = render(64);
    let free = paths + 64 * 15 - answer.body.len();
    let text = format!("this takes {} bytes, and {free} of {} bytes are free; try", paths + 960, paths + 960);
    assert_eq!(refused.status, "503 Service Unavailable");
    assert!(refused.body.starts_with(text.as_bytes()), "{}", String::from_utf8_lossy(&refused.body));
    drop(answer);
    let refused = render(65);
    assert!(refused.body.ends_with(b"make it smaller"), "{}", String::from_utf8_lossy(&refused.body));
    assert_eq!(budget.taken(), 0);
    assert_eq!(render(64).status, "200 OK");
}

#[test]
fn texts_of_exactly_the_limit_are_rendered_and_one_byte_more_is_refused() {
    let (_folder, view) = view();
    let render = |config: &str, scene: &str| asked(&view, "POST", "/view/render/1", &texts(config, scene));
    let small = "image_width: 8\n";
    let config = |length: usize| format!("{small}{}", "\n".repeat(length - small.len()));
    let most = input::MAX_TEXT as usize;
    assert_eq!(render(&config(most), &"\n".repeat(most)).0, "200");
    for (config, scene) in [(config(most + 1), String::new()), (small.to_owned(), "\n".repeat(most + 1))] {
        let (status, message) = render(&config, &scene);
        assert!(status == "413" && message.contains("has 16777217 bytes"), "{message}");
    }
}
