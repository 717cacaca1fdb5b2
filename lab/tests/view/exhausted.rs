//! Tests `render-lab view` without a free file descriptor: it waits, and answers when descriptors are free again.

use std::fs;
use std::io::Read;
use std::net::TcpStream;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::Server;

/// Time limit for the program, long enough for a busy machine.
const PATIENCE: Duration = Duration::from_secs(120);

impl Server {
    /// Returns the number of file descriptors that the process has open.
    fn descriptors(&self) -> usize {
        fs::read_dir(format!("/proc/{}/fd", self.child.id())).expect("it runs").count()
    }

    fn page(&self) -> TcpStream {
        let stream = self.ask("/");
        stream.set_read_timeout(Some(PATIENCE)).expect("it is a time");
        stream
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
    assert!(answer(server.page()).starts_with("HTTP/1.1 200"));
    // Leaves fewer free descriptors than the number of connections that the server accepts at a time.
    let most = server.descriptors() + 5;
    let process = server.child.id().to_string();
    let limited = Command::new("prlimit").args(["--pid", &process, &format!("--nofile={most}")]).status();
    assert!(limited.expect("util-linux has prlimit").success());

    let silent: Vec<_> = (0..20).map(|_| server.connect()).collect();
    let start = Instant::now();
    while server.descriptors() < most {
        assert!(start.elapsed() < PATIENCE, "{} of {most} descriptors are open", server.descriptors());
        std::thread::sleep(Duration::from_millis(5));
    }
    let waiting = server.page();
    // The server tries several times in this time to accept the connection.
    std::thread::sleep(Duration::from_millis(300));
    assert_eq!(server.child.try_wait().expect("it can be asked"), None, "it goes on");
    waiting.set_nonblocking(true).expect("it is open");
    let error = (&waiting).read(&mut [0]).expect_err("there is no answer yet");
    assert_eq!(error.kind(), std::io::ErrorKind::WouldBlock);
    waiting.set_nonblocking(false).expect("it is open");

    drop(silent);
    assert!(answer(waiting).starts_with("HTTP/1.1 200"), "it is answered late, and not lost");
    assert!(answer(server.page()).starts_with("HTTP/1.1 200"));
}
