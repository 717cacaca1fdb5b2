//! Tests of the answers to the page's requests.

use std::cell::Cell;

use super::*;

fn asked(method: &str, path: &str, body: &[u8]) -> (Answer, Option<Posted>) {
    let posted = Cell::new(None);
    let request = Request { method: method.to_owned(), path: path.to_owned(), body: body.to_vec() };
    let data = BTreeMap::from([("a".to_owned(), b"numbers".to_vec())]);
    let answer = answer(request, &data, &|taken| posted.set(Some(taken)));
    (answer, posted.into_inner())
}

fn got(path: &str) -> Answer {
    asked("GET", path, b"").0
}

fn text(answer: &Answer) -> String {
    String::from_utf8_lossy(&answer.body).into_owned()
}

#[test]
fn the_pages_and_their_data_are_served() {
    for (path, title) in [("/jobs", "<title>jobs of a test</title>"), ("/conformance", "<title>conformance</title>")] {
        assert!(text(&got(path)).contains(title), "{path}");
    }
    assert_eq!(text(&got("/data/a")), "numbers");
}

#[test]
fn other_paths_are_not_found() {
    for path in ["/", "/data/b", "/../Cargo.toml", "//etc/passwd", ""] {
        assert!(got(path).status.starts_with("404"), "{path}");
    }
}

#[test]
fn results_are_taken() {
    let (_, posted) = asked("POST", "/results/kernels/sphere", b"abc");
    let posted = posted.expect("it has a body");
    assert_eq!((posted.name.as_str(), &posted.body[..]), ("kernels/sphere", &b"abc"[..]));
    assert!(asked("GET", "/results/kernels/sphere", b"").1.is_none(), "only a POST sends results");
}
