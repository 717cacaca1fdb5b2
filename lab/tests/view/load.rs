//! `render-lab view` under 200 hostile requests a second, beside an honest user.
//!
//! Nothing hostile has the secret. Half of the requests end with an answer, and half keep their connection open. The
//! median time of an honest picture must be less than twice its usual time. `RENDER_LOAD_SECONDS=60` is the long form,
//! which `tests/extensive` runs.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use measure::statistics::Median;

use crate::Server;

/// Number of hostile requests a second.
const RATE: u32 = 200;

/// Number of threads that send them.
const THREADS: u32 = 8;

/// Number of connections that each thread keeps open.
const KEPT: usize = 40;

/// Number of bytes that the program may use at most for connections, besides what the honest picture needs. Each of up
/// to 32 connections, and of those that are just being closed, takes up to 0.8 MB.
const FOR_CONNECTIONS: u64 = 64_000_000;

impl Server {
    /// Sends a request with the secret, and returns the status and the length of the answer.
    fn answer(&self, method: &str, path: &str, body: &str) -> (String, usize) {
        let mut answer = Vec::new();
        self.ask(method, path, body).read_to_end(&mut answer).expect("it answers");
        (String::from_utf8_lossy(&answer[..answer.len().min(12)]).into_owned(), answer.len())
    }

    /// Returns the time of the honest picture in seconds. The honest page also asks whether a file has changed.
    fn picture(&self) -> f64 {
        let scene = "matte: m .5 .5 .5\nsphere: 0 0 0 4 m\nsphere: 1 5 0 3 m\nsphere: 4 -2 1 2 m\n";
        let config = "image_width: 480\nsamples_per_pixel: 150\n";
        let body = serde_json::json!({ "config": config, "scene": scene }).to_string();
        let start = Instant::now();
        assert_eq!(self.answer("GET", "/view/version", "").0, "HTTP/1.1 200");
        let (status, length) = self.answer("POST", "/view/render/1", &body);
        assert!(status == "HTTP/1.1 200" && length > 480 * 270 * 6, "{status} {length}");
        start.elapsed().as_secs_f64()
    }

    /// Returns the largest memory of the program so far, in bytes.
    fn memory(&self) -> u64 {
        let status = std::fs::read_to_string(format!("/proc/{}/status", self.child.id())).expect("it runs");
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).expect("Linux has this line");
        line.trim().trim_end_matches(" kB").parse::<u64>().expect("it is a number") * 1024
    }
}

/// Sends hostile request number `number`. Returns the connection if it stays open, or the status of the answer.
fn attack(address: &str, number: u32) -> std::io::Result<Result<TcpStream, String>> {
    let mut stream = TcpStream::connect(address)?;
    stream.set_read_timeout(Some(Duration::from_secs(2)))?;
    stream.set_write_timeout(Some(Duration::from_secs(2)))?;
    let host = format!("Host: {address}\r\n");
    let huge = r#"{"config":"samples_per_pixel: 9000000000000000000","scene":""}"#;
    let (request, stays) = match number % 8 {
        0 => (format!("GET / HTTP/1.1\r\n{host}\r\n"), false),
        1 => (format!("POST /view/render/1 HTTP/1.1\r\n{host}Content-Length: {}\r\n\r\n{huge}", huge.len()), false),
        2 => (format!("GET /view/files HTTP/1.1\r\n{host}Authorization: Bearer {number:032x}\r\n\r\n"), false),
        3 => (format!("GET /{} HTTP/1.1\r\n", "x".repeat(9000)), false),
        // A client that sends nothing, one whose request never ends, one whose body does not come, and one that does
        // not read its answer.
        4 => (String::new(), true),
        5 => (format!("GET / HTTP/1.1\r\n{host}A: "), true),
        6 => (format!("POST /view/render/2 HTTP/1.1\r\n{host}Content-Length: 67108864\r\n\r\n{huge}"), true),
        _ => (format!("GET /view/files HTTP/1.1\r\n{host}\r\n"), true),
    };
    stream.write_all(request.as_bytes())?;
    if stays {
        return Ok(Ok(stream));
    }
    let mut status = [0; 12];
    stream.read_exact(&mut status)?;
    Ok(Err(String::from_utf8_lossy(&status).into_owned()))
}

/// Attacks `address` until `stop`. Counts the requests, and the answers that refuse them.
fn attacks(address: &str, first: u32, stop: &AtomicBool, [sent, refused]: [&AtomicUsize; 2]) {
    let (start, mut kept) = (Instant::now(), std::collections::VecDeque::new());
    for turn in 0.. {
        // The requests of a second are spread over it, and none are left out if the machine is slow for a moment.
        let due = Duration::from_secs(1) / RATE * (turn * THREADS + first);
        std::thread::sleep(due.saturating_sub(start.elapsed()));
        if stop.load(Ordering::Relaxed) {
            return;
        }
        sent.fetch_add(1, Ordering::Relaxed);
        match attack(address, turn + first) {
            Ok(Ok(stream)) => kept.push_back(stream),
            Ok(Err(status)) => {
                assert!(["HTTP/1.1 403", "HTTP/1.1 414", "HTTP/1.1 503"].contains(&&status[..]), "{status}");
                refused.fetch_add(1, Ordering::Relaxed);
            }
            // The server may close the connection to make room for a newer one.
            Err(_) => {}
        }
        if kept.len() > KEPT {
            kept.pop_front();
        }
    }
}

#[test]
fn an_honest_picture_comes_within_twice_its_usual_time_and_memory_stays_small() {
    let seconds = std::env::var("RENDER_LOAD_SECONDS").map_or(6, |text| text.parse().expect("it is a number"));
    let program = Server::start();
    let alone = |count: usize| (0..count).map(|_| program.picture()).collect::<Vec<_>>();
    let mut usual = alone(8);
    let before = program.memory();

    let [sent, refused] = [0, 0].map(AtomicUsize::new);
    let (stop, mut loaded) = (AtomicBool::new(false), Vec::new());
    std::thread::scope(|scope| {
        for first in 0..THREADS {
            let (address, stop, counts) = (&program.address, &stop, [&sent, &refused]);
            scope.spawn(move || attacks(address, first, stop, counts));
        }
        let start = Instant::now();
        while start.elapsed() < Duration::from_secs(seconds) {
            loaded.push(program.picture());
        }
        stop.store(true, Ordering::Relaxed);
    });
    let after = program.memory();
    // The machine may have become slower or faster meanwhile.
    usual.extend(alone(8));

    let [sent, refused] = [sent, refused].map(AtomicUsize::into_inner);
    let (pictures, slowest) = (loaded.len(), loaded.iter().copied().fold(0.0, f64::max));
    let [usual, loaded] = [usual, loaded].map(|times| Median::of(&times).median);
    println!(
        "{sent} hostile requests in {seconds} s, {refused} refused; {pictures} pictures: median {loaded:.3} s, \
         slowest {slowest:.3} s, alone {usual:.3} s; memory {after} bytes, before {before}"
    );
    assert!(sent as u64 >= seconds * u64::from(RATE) * 4 / 5, "only {sent} requests");
    assert!(refused > sent / 8, "only {refused} of {sent} had an answer");
    assert!(pictures > 3 && loaded < 2.0 * usual, "{loaded} s instead of {usual} s");
    assert!(after < before + FOR_CONNECTIONS, "{after} bytes instead of {before}");
}
