//! Serves a page to browsers on this machine. The owner of the server decides what a request is answered with.
//!
//! A page that is opened from a file may not load data. WebGPU needs a trusted origin, and the loopback address is one.
//! The server answers one request on each connection and closes it. The server is not made for an open network.
//! [`request`] reads requests and limits their size and time.

pub mod request;

use std::borrow::Cow;
use std::convert::Infallible;
use std::io::{self, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use request::{Refusal, Request};

/// Largest number of connections at a time. A browser opens up to six connections to one server.
pub const MAX_CONNECTIONS: usize = 32;

/// Time limit for the client to accept the next bytes of an answer.
const PATIENCE: Duration = Duration::from_secs(10);

/// Time that the server waits for a resource, such as a free file descriptor, before it accepts connections again.
const PAUSE: Duration = Duration::from_millis(50);

/// A server that listens at a port.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    /// Number of connections that are being served.
    connections: AtomicUsize,
    /// Sum of the lengths of all bodies that are being received, in bytes.
    bodies: AtomicUsize,
    /// Two time limits for a client: to send its whole request, and to accept the next bytes of an answer.
    patience: [Duration; 2],
}

/// The answer to a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The status, such as `200 OK`.
    pub status: &'static str,
    /// The content type, without a character set. Texts are UTF-8.
    pub kind: &'static str,
    /// The content.
    pub body: Cow<'static, [u8]>,
}

impl Answer {
    /// Returns the answer that succeeds with `body`.
    #[must_use]
    pub fn ok(kind: &'static str, body: impl Into<Cow<'static, [u8]>>) -> Self {
        Self { status: "200 OK", kind, body: body.into() }
    }

    /// Returns an answer that fails with `status`, and with `text` as an explanation.
    #[must_use]
    pub fn refused(status: &'static str, text: impl Into<String>) -> Self {
        Self { status, kind: "text/plain", body: text.into().into_bytes().into() }
    }

    /// Returns the answer to a request for a path that does not exist.
    #[must_use]
    pub fn not_found() -> Self {
        Self::refused("404 Not Found", "there is nothing here")
    }
}

/// An amount that has been added to a counter. It is subtracted when this value is dropped.
struct Share<'a>(&'a AtomicUsize, usize);

impl<'a> Share<'a> {
    /// Adds `amount` to `counter`. Returns `None`, and adds nothing, if the sum would exceed `most`.
    fn take(counter: &'a AtomicUsize, amount: usize, most: usize) -> Option<Self> {
        let add = |taken: usize| taken.checked_add(amount).filter(|&sum| sum <= most);
        counter.fetch_update(Ordering::SeqCst, Ordering::SeqCst, add).ok().map(|_| Self(counter, amount))
    }
}

impl Drop for Share<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(self.1, Ordering::SeqCst);
    }
}

impl Server {
    /// Returns a server that listens at `port`, or at any free port if `port` is 0.
    ///
    /// # Errors
    /// An error if the port is in use.
    pub fn new(port: u16) -> io::Result<Self> {
        let listener = TcpListener::bind(("127.0.0.1", port))?;
        let (connections, bodies) = (AtomicUsize::new(0), AtomicUsize::new(0));
        Ok(Self { listener, connections, bodies, patience: [request::MAX_TIME, PATIENCE] })
    }

    /// Returns the address at which the server listens.
    ///
    /// # Errors
    /// The error of the system.
    pub fn address(&self) -> io::Result<SocketAddr> {
        self.listener.local_addr()
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
                Ok((stream, _)) => stream,
                Err(error) if may_pass(&error) => {
                    std::thread::sleep(PAUSE);
                    continue;
                }
                Err(error) => return Err(error),
            };
            if shared.0.connections.fetch_add(1, Ordering::SeqCst) >= MAX_CONNECTIONS {
                // This answer is so short that it fits the system's buffer, so the server does not wait for the client.
                drop(respond(&stream, &Answer::refused("503 Service Unavailable", "too many connections")));
                shared.0.connections.fetch_sub(1, Ordering::SeqCst);
                continue;
            }
            let connection = Arc::clone(&shared);
            let talk = move || {
                let (server, answer) = &*connection;
                let _share = Share(&server.connections, 1);
                // An error is ignored: it means that the client has closed the connection.
                drop(server.talk(&stream, answer));
            };
            if std::thread::Builder::new().name("connection".to_owned()).spawn(talk).is_err() {
                // If no thread could be started, the connection is closed, and the client may try again.
                shared.0.connections.fetch_sub(1, Ordering::SeqCst);
            }
        }
    }

    /// Reads one request and sends its answer.
    fn talk(&self, stream: &TcpStream, answer: impl Fn(Request) -> Answer) -> io::Result<()> {
        let mut share = None;
        let reserve = |length| {
            share = Share::take(&self.bodies, length, request::MAX_BODY);
            share.is_some()
        };
        let [for_request, for_answer] = self.patience;
        stream.set_write_timeout(Some(for_answer))?;
        match Request::read(stream, for_request, reserve) {
            Ok(request) => respond(stream, &answer(request)),
            Err(Refusal::Broken(error)) => Err(error),
            Err(Refusal::Status(status)) => {
                respond(stream, &Answer::refused(status, status))?;
                drain(stream)
            }
        }
    }
}

/// Whether the error is temporary, so that accepting connections may work again: a client closed its connection, or
/// file descriptors or memory are short.
fn may_pass(error: &io::Error) -> bool {
    #[cfg(unix)]
    {
        use nix::errno::Errno;
        let short = [Errno::EMFILE, Errno::ENFILE, Errno::ENOBUFS, Errno::ENOMEM].map(|errno| Some(errno as i32));
        if short.contains(&error.raw_os_error()) {
            return true;
        }
    }
    matches!(
        error.kind(),
        io::ErrorKind::ConnectionAborted | io::ErrorKind::ConnectionReset | io::ErrorKind::Interrupted
    )
}

fn respond(mut stream: &TcpStream, Answer { status, kind, body }: &Answer) -> io::Result<()> {
    let length = body.len();
    // Browsers compile WebAssembly while it arrives only if its content type has no parameter.
    let charset = if kind.starts_with("text/") { "; charset=utf-8" } else { "" };
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}{charset}\r\nContent-Length: {length}\r\n\
         Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n"
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(body)
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
