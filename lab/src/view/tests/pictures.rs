//! Tests of the requests for pictures: their bytes, their limits, and how they are stopped.

use std::time::{Duration, Instant};

use test_support::golden;

use super::*;

#[test]
fn a_picture_has_the_bytes_of_the_evaluated_program() {
    let (_folder, view) = view();
    let cases: Vec<_> =
        golden::cases().into_iter().filter(|case| case.scatter == cpu::Scatter::Statement).take(4).collect();
    assert_eq!(cases.len(), 4);
    for (number, case) in cases.iter().enumerate() {
        let [config, scene] =
            [&case.config, &case.scene].map(|path| fs::read_to_string(path).expect("it is committed"));
        let (status, ppm) = asked(&view, "POST", &format!("/view/render/{number}"), &texts(&config, &scene));
        let digest = case.digest().expect("it is listed");
        assert_eq!((status, digest::sha256(ppm.as_bytes())), ("200", digest), "{}", case.name);
        let progress = asked(&view, "GET", "/view/progress", "").1;
        let (done, all) = progress.split_once(' ').expect("two numbers");
        assert!(done == all && all != "0", "all rows are finished: {progress}");
    }
}

#[test]
fn a_picture_that_cannot_be_made_gets_the_words_of_the_renderer() {
    let (_folder, view) = view();
    let render = |config: &str| asked(&view, "POST", "/view/render/1", &texts(config, ""));
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

/// Returns the texts of a picture that would take years. `cpu/tests/stopping.rs` has all kinds of them.
fn endless() -> String {
    texts("image_width: 8\nsamples_per_pixel: 9000000000000000000\n", "matte: m .5 .5 .5\nsphere: 0 0 0 1 m\n")
}

/// Returns the time after which a picture must have been cancelled: `RENDER_STOP_MS` milliseconds. The promise is
/// 100 ms, and by default the tests allow many times as much, because the machine may be busy.
fn soon() -> Duration {
    let milliseconds = std::env::var("RENDER_STOP_MS").map(|text| text.parse().expect("RENDER_STOP_MS is a number"));
    Duration::from_millis(milliseconds.unwrap_or(3000))
}

/// Waits until the picture that was requested last is being rendered.
fn until_rendering(view: &View) {
    while asked(view, "GET", "/view/progress", "").1 == "0 0" {
        std::thread::yield_now();
    }
    // From here on the renderer is between the start and the first row.
    std::thread::sleep(Duration::from_millis(20));
}

#[test]
fn a_picture_is_stopped_by_its_number_alone_or_by_a_new_picture_and_soon() {
    for (path, body) in [("/view/cancel/7", ""), ("/view/render/8", &texts("image_width: 8\n", ""))] {
        let (_folder, view) = view();
        std::thread::scope(|scope| {
            let picture = scope.spawn(|| asked(&view, "POST", "/view/render/7", &endless()));
            until_rendering(&view);
            assert_eq!(asked(&view, "POST", "/view/cancel/8", "").0, "200");
            assert!(!picture.is_finished());
            let start = Instant::now();
            assert_eq!(asked(&view, "POST", path, body).0, "200");
            assert_eq!(picture.join().expect("it does not panic").0, "409");
            assert!(start.elapsed() < soon(), "{path}: {:?}", start.elapsed());
            assert_eq!(view.budget.taken(), 0);
        });
    }
}

#[test]
fn a_picture_whose_client_has_gone_is_cancelled_and_the_next_one_comes_soon() {
    let small = texts("image_width: 8\n", "");
    let body = endless();
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
        assert!(start.elapsed() < soon(), "{:?}", start.elapsed());
    });
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
    let body = |pixels: u64| texts(&format!("image_width: {pixels}\naspect_ratio: {pixels} 1\n"), "");
    let (paths, text) = (12 << 23, body(64).len());
    let all = paths + 64 * 15 + text;
    let budget = Budget::new(all);
    view.native = Native::new(budget.clone());
    let render = |pixels: u64| {
        let [_client, server] = connection();
        answer(&server, &view, "POST", "/view/render/1", &body(pixels))
    };
    let answer = render(64);
    assert_eq!((answer.status, budget.taken()), ("200 OK", answer.body.len()), "until it is sent");
    let refused = render(64);
    let free = all - text - answer.body.len();
    let message = format!("this takes {} bytes, and {free} of {all} bytes are free; try", paths + 960);
    assert_eq!(refused.status, "503 Service Unavailable");
    assert!(refused.body.starts_with(message.as_bytes()), "{}", String::from_utf8_lossy(&refused.body));
    drop(answer);
    let refused = render(65 + text as u64 / 15);
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
