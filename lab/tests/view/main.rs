//! Tests `render-lab view` as a running server: what it serves, and without a free file descriptor.

#![cfg(target_os = "linux")]

mod browser;
mod exhausted;
mod foreign;

use std::io::{BufRead, BufReader, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};

use test_support::folder::Folder;
use test_support::running::Running;

/// A running server with a small scene. It is killed when this value is dropped.
struct Server {
    child: Running,
    address: String,
    secret: String,
    _folder: Folder,
    /// Two servers at a time would disturb each other's times.
    _turn: MutexGuard<'static, ()>,
}

impl Server {
    /// Starts the server in a folder with its page.
    fn start() -> Self {
        let folder = Folder::with_scene("image_width: 8\nmax_depth: 2\n", "");
        std::fs::create_dir(folder.file("site")).expect("the folder is writable");
        folder.write("site/index.html", "<!doctype html><meta name=\"served-by\" content=\"\">");
        Self::run(Path::new(env!("CARGO_BIN_EXE_render-lab")), folder, &["--site", "site"])
    }

    /// Starts the server of `program` in `folder`.
    fn run(program: &Path, folder: Folder, options: &[&str]) -> Self {
        static TURN: Mutex<()> = Mutex::new(());
        let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
        let mut command = Command::new(program);
        command.current_dir(folder.path()).args(["view", "config.txt", "scene.txt", "--port", "0"]).args(options);
        let mut child = Running::start(command.stdout(Stdio::piped())).expect("the program starts");
        let mut line = String::new();
        BufReader::new(child.stdout.take().expect("it is a pipe")).read_line(&mut line).expect("it prints its address");
        let rest = line.trim().strip_prefix("http://").expect("it is an address");
        let (address, secret) = rest.split_once("/?secret=").expect("it has a secret");
        Self { child, address: address.to_owned(), secret: secret.to_owned(), _folder: folder, _turn: turn }
    }

    fn connect(&self) -> TcpStream {
        TcpStream::connect(&self.address).expect("the system takes connections for it")
    }

    /// Requests a path with the secret, and returns the connection.
    fn ask(&self, path: &str) -> TcpStream {
        let mut stream = self.connect();
        let Self { address, secret, .. } = self;
        let head = format!("GET {path} HTTP/1.1\r\nHost: {address}\r\nAuthorization: Bearer {secret}\r\n\r\n");
        stream.write_all(head.as_bytes()).expect("the system takes it");
        stream
    }
}
