//! Tests `render-lab view` without a free file descriptor: it waits, and answers when descriptors are free again.
#![cfg(target_os = "linux")]

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use test_support::folder::Folder;

/// Time limit for the program, long enough for a busy machine.
const PATIENCE: Duration = Duration::from_secs(120);

/// A running server, its address and its secret. It is killed when this value is dropped.
struct Server(Child, String, String);

impl Server {
    fn start() -> Self {
        let folder = Folder::new();
        let config = folder.file("config.txt");
        fs::write(&config, "image_width: 8\nmax_depth: 2\n").expect("the folder is writable");
        let site = folder.file("site");
        fs::create_dir(&site).expect("the folder is writable");
        let page = "<meta name=\"served-by\" content=\"\">";
        fs::write(site.join("index.html"), page).expect("the folder is writable");
        let mut command = Command::new(env!("CARGO_BIN_EXE_render-lab"));
        command.args(["view", "--port", "0", "--site"]).args([&site, &config]);
        command.arg(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/materials/scene.txt"));
        let mut child = command.stdout(Stdio::piped()).spawn().expect("the program starts");
        let mut line = String::new();
        BufReader::new(child.stdout.take().expect("it is a pipe")).read_line(&mut line).expect("it is text");
        let parts = line.trim_end().strip_prefix("http://").and_then(|rest| rest.split_once("/?secret="));
        let (address, secret) = parts.unwrap_or_else(|| panic!("[{line}] has no address with a secret"));
        let (address, secret) = (address.to_owned(), secret.to_owned());
        Self(child, address, secret)
    }

    /// Returns the number of file descriptors that the process has open.
    fn descriptors(&self) -> usize {
        fs::read_dir(format!("/proc/{}/fd", self.0.id())).expect("it runs").count()
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(&self.1).expect("the system takes connections for it");
        stream.set_read_timeout(Some(PATIENCE)).expect("it is a time");
        stream
    }

    fn ask(&self) -> TcpStream {
        let mut stream = self.connect();
        let Self(_, address, secret) = self;
        let request = format!("GET / HTTP/1.1\r\nHost: {address}\r\nAuthorization: Bearer {secret}\r\n\r\n");
        stream.write_all(request.as_bytes()).expect("the system takes it");
        stream
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn answer(mut stream: TcpStream) -> String {
    let mut answer = String::new();
    stream.read_to_string(&mut answer).expect("it answers in time, in text");
    answer
}

#[test]
fn a_server_without_a_free_descriptor_answers_once_there_is_one() {
    let mut server = Server::start();
    assert!(answer(server.ask()).starts_with("HTTP/1.1 200"));
    // Leaves fewer free descriptors than the number of connections that the server accepts at a time.
    let most = server.descriptors() + 5;
    let process = server.0.id().to_string();
    let limited = Command::new("prlimit").args(["--pid", &process, &format!("--nofile={most}")]).status();
    assert!(limited.expect("util-linux has prlimit").success());

    let silent: Vec<_> = (0..20).map(|_| server.connect()).collect();
    let start = Instant::now();
    while server.descriptors() < most {
        assert!(start.elapsed() < PATIENCE, "{} of {most} descriptors are open", server.descriptors());
        std::thread::sleep(Duration::from_millis(5));
    }
    let waiting = server.ask();
    // The server tries several times in this time to accept the connection.
    std::thread::sleep(Duration::from_millis(300));
    assert_eq!(server.0.try_wait().expect("it can be asked"), None, "it goes on");
    waiting.set_nonblocking(true).expect("it is open");
    let error = (&waiting).read(&mut [0]).expect_err("there is no answer yet");
    assert_eq!(error.kind(), std::io::ErrorKind::WouldBlock);
    waiting.set_nonblocking(false).expect("it is open");

    drop(silent);
    assert!(answer(waiting).starts_with("HTTP/1.1 200"), "it is answered late, and not lost");
    assert!(answer(server.ask()).starts_with("HTTP/1.1 200"));
}
