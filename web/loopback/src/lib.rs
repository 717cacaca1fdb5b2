//! Serves a page to browsers on this machine. The owner of the server decides what a request is answered with.
//!
//! A page that is opened from a file may not load data. WebGPU needs a trusted origin, and the loopback address is one.
//! The server answers one request on each connection and closes it. The server is not made for an open network.
//!
//! [`request`] reads requests and limits their size. [`client`] limits their time. [`secret`] tells which requests are
//! answered. [`connections`] limits their number.

mod answer;
pub mod client;
pub mod connections;
pub mod request;
pub mod secret;

use std::convert::Infallible;
use std::io::{self, BufReader, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::time::Duration;

use nix::errno::Errno;

pub use answer::Answer;
use answer::HEADERS;
use client::Timed;
use connections::{Connections, Place};
use request::{Head, Refusal, Request};
use secret::{Admission, Secret};

/// Time limit for the client to accept an answer, besides the time for its bytes at [`LEAST_RATE`].
const PATIENCE: Duration = Duration::from_secs(10);

/// Least number of bytes a second at which a client must accept an answer. A browser on the same machine is a hundred
/// times as fast.
const LEAST_RATE: usize = 8 << 20;

/// Time that the server waits for a resource, such as a free file descriptor, before it accepts connections again.
const PAUSE: Duration = Duration::from_millis(50);

/// The text for a request without the secret.
const NO_SECRET: &str = "403 Forbidden: this needs the secret of this server. Open the address that the program has \
    printed. You can open a link to this page after that: copy the link into the address bar.\n";

/// The text for a request of a foreign page to a server that has no secret.
const FOREIGN: &str = "403 Forbidden: a page of another origin has sent this request. Open the address of this server \
    in the address bar.\n";

/// A server that listens at a port.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    connections: Connections,
    /// The secret that every request must prove. If it is `None`, all requests are answered.
    secret: Option<Secret>,
    patience: Patience,
}

/// The time limits for a client.
#[derive(Clone, Copy, Debug)]
struct Patience {
    /// Time to send the whole request.
    request: Duration,
    /// Time to accept an answer, besides the time for its bytes.
    answer: Duration,
    /// Least number of bytes of an answer that must be accepted in a second.
    rate: usize,
}

impl Server {
    /// Returns a server that listens at `port`, or at any free port if `port` is 0. It has no secret.
    ///
    /// # Errors
    /// An error if the port is in use.
    pub fn new(port: u16) -> io::Result<Self> {
        let listener = TcpListener::bind(("127.0.0.1", port))?;
        let patience = Patience { request: request::MAX_TIME, answer: PATIENCE, rate: LEAST_RATE };
        Ok(Self { listener, connections: Connections::default(), secret: None, patience })
    }

    /// Returns the server with a new secret. Paths that begin with `private` are data, which a cookie does not open.
    ///
    /// # Errors
    /// An error if the system gives no random numbers.
    pub fn with_secret(self, private: &'static str) -> io::Result<Self> {
        let secret = Secret::new(self.address()?.port(), private)?;
        Ok(Self { secret: Some(secret), ..self })
    }

    /// Returns the address at which the server listens.
    ///
    /// # Errors
    /// The error of the system.
    pub fn address(&self) -> io::Result<SocketAddr> {
        self.listener.local_addr()
    }

    /// Returns the address to open in a browser, with the secret if there is one.
    ///
    /// # Errors
    /// The error of the system.
    pub fn url(&self) -> io::Result<String> {
        let path = self.secret.as_ref().map_or_else(|| "/".to_owned(), Secret::path);
        Ok(format!("http://{}{path}", self.address()?))
    }

    /// Serves every client in its own thread, because browsers open connections that they may use only later. Calls
    /// `answer` with each request.
    ///
    /// # Errors
    /// An error if the system can accept no more connections. A temporary error, such as too few file descriptors, is
    /// not returned.
    pub fn serve(self, answer: impl Fn(Request) -> Answer + Send + Sync + 'static) -> io::Result<Infallible> {
        let shared = Arc::new((self, answer));
        loop {
            let stream = match shared.0.listener.accept() {
                Ok((stream, _)) => Arc::new(stream),
                Err(error) if may_pass(&error) => {
                    std::thread::sleep(PAUSE);
                    continue;
                }
                Err(error) => return Err(error),
            };
            let Some(number) = shared.0.connections.enter(&stream) else {
                // This answer is so short that it fits the system's buffer, so the server does not wait for the client.
                let full = Answer::refused("503 Service Unavailable", "too many connections");
                drop(shared.0.respond(&stream, &full, None));
                continue;
            };
            let connection = Arc::clone(&shared);
            let talk = move || {
                let (server, answer) = &*connection;
                // An error is ignored: it means that the client has closed the connection.
                drop(server.talk(&stream, server.connections.place(number), answer));
            };
            if std::thread::Builder::new().name("connection".to_owned()).spawn(talk).is_err() {
                // If no thread could be started, the connection is closed, and the client may try again.
                drop(shared.0.connections.place(number));
            }
        }
    }

    /// Reads one request and sends its answer. The connection has `place` until the end, also if it is refused.
    fn talk(&self, stream: &TcpStream, mut place: Place, answer: impl Fn(Request) -> Answer) -> io::Result<()> {
        match self.read(stream, &mut place) {
            Ok((request, is_first)) => {
                let cookie = self.secret.as_ref().filter(|_| is_first).map(Secret::set_cookie);
                self.respond(stream, &answer(request), cookie)
            }
            Err(Refusal::Broken(error)) => Err(error),
            Err(Refusal::Status(status, text)) => {
                self.respond(stream, &Answer::refused(status, text), None)?;
                drain(stream)
            }
        }
    }

    /// Reads one request. Also returns whether it is the first one, with the secret in its address.
    fn read(&self, stream: &TcpStream, place: &mut Place) -> Result<(Request, bool), Refusal> {
        let mut reader = BufReader::new(Timed::new(stream, self.patience.request));
        let mut head = Head::read(&mut reader)?;
        let admission = self.secret.as_ref().map_or(Admission::Full, |secret| secret.admit(&head));
        let is_first = admission == Admission::First;
        if admission == Admission::None || head.is_foreign && !is_first {
            let text = if self.secret.is_some() { NO_SECRET } else { FOREIGN };
            return Err(Refusal::Status("403 Forbidden", text.into()));
        }
        if is_first {
            head.path.truncate(1);
        }
        if !place.keep() {
            return Err(Refusal::Broken(io::ErrorKind::ConnectionAborted.into()));
        }
        Ok((head.with_body(&mut reader)?, is_first))
    }

    /// Sends an answer. The client must accept all of it in time.
    fn respond(&self, stream: &TcpStream, answer: &Answer, cookie: Option<String>) -> io::Result<()> {
        let Answer { status, kind, body, .. } = answer;
        let Patience { answer: time, rate, .. } = self.patience;
        let length = body.len();
        // Browsers compile WebAssembly while it arrives only if its content type has no parameter.
        let charset = if kind.starts_with("text/") { "; charset=utf-8" } else { "" };
        let cookie = cookie.map(|cookie| format!("Set-Cookie: {cookie}\r\n")).unwrap_or_default();
        let head = format!(
            "HTTP/1.1 {status}\r\nContent-Type: {kind}{charset}\r\nContent-Length: {length}\r\n{HEADERS}{cookie}\r\n"
        );
        let mut client = Timed::new(stream, time + Duration::from_secs_f64(length as f64 / rate as f64));
        client.write_all(head.as_bytes())?;
        client.write_all(body)
    }
}

/// Whether the error is temporary, so that accepting connections may work again: a client closed its connection, or
/// file descriptors or memory are short.
fn may_pass(error: &io::Error) -> bool {
    let short = [Errno::EMFILE, Errno::ENFILE, Errno::ENOBUFS, Errno::ENOMEM].map(|errno| Some(errno as i32));
    let passing = [io::ErrorKind::ConnectionAborted, io::ErrorKind::ConnectionReset, io::ErrorKind::Interrupted];
    short.contains(&error.raw_os_error()) || passing.contains(&error.kind())
}

/// Reads for a moment what a refused client still sends. If the connection were closed at once, the client might lose
/// the answer.
fn drain(mut stream: &TcpStream) -> io::Result<()> {
    stream.shutdown(Shutdown::Write)?;
    stream.set_read_timeout(Some(PAUSE))?;
    let mut bytes = [0; 4096];
    for _ in 0..16 {
        if stream.read(&mut bytes)? == 0 {
            break;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
