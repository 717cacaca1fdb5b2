//! A server of one page, to this machine only: `web/` and the data that it asks for.
//!
//! A page from a file may not fetch, and WebGPU wants a trusted origin, which the loopback address is. A request is
//! answered and its connection closed; nothing here is for the open network. [`request`] reads requests within limits.

pub mod data;
pub mod request;

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::io::{self, Read, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use request::{Refusal, Request};

/// The page's files.
const FILES: [(&str, &str, &str); 7] = [
    ("/", "text/html", include_str!("../web/index.html")),
    ("/?drive", "text/html", include_str!("../web/index.html")),
    ("/lab.css", "text/css", include_str!("../web/lab.css")),
    ("/page.js", "text/javascript", include_str!("../web/page.js")),
    ("/lab.js", "text/javascript", include_str!("../web/lab.js")),
    ("/gpu.js", "text/javascript", include_str!("../web/gpu.js")),
    ("/drive.js", "text/javascript", include_str!("../web/drive.js")),
];

/// Most connections at a time. A browser opens six to one address.
pub const MAX_CONNECTIONS: usize = 32;

/// How long the client may take for an answer's next bytes.
const PATIENCE: Duration = Duration::from_secs(10);

/// How long the server waits for a resource, such as a free file descriptor, before it accepts again.
const PAUSE: Duration = Duration::from_millis(50);

/// The server, ready to be asked.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    data: BTreeMap<String, Vec<u8>>,
    /// Connections being served.
    connections: AtomicUsize,
    /// Bytes of all bodies that are being received.
    bodies: AtomicUsize,
    /// How long a client may take for its whole request, and for an answer's next bytes.
    patience: [Duration; 2],
}

/// What the page sent under `results/`.
#[derive(Clone, Debug)]
pub struct Posted {
    /// The rest of the address.
    pub name: String,
    /// Its content.
    pub body: Vec<u8>,
}

/// A share of a counter, given back when it is dropped.
struct Share<'a>(&'a AtomicUsize, usize);

impl<'a> Share<'a> {
    /// `amount` of what `counter` counts, unless there would be more than `most` in all.
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
    /// A server of `data`, by what stands after `data/` in the address, at `port`, or at any that is free for zero.
    ///
    /// # Errors
    /// When the port is taken.
    pub fn new(port: u16, data: BTreeMap<String, Vec<u8>>) -> io::Result<Self> {
        let listener = TcpListener::bind(("127.0.0.1", port))?;
        let (connections, bodies) = (AtomicUsize::new(0), AtomicUsize::new(0));
        Ok(Self { listener, data, connections, bodies, patience: [request::MAX_TIME, PATIENCE] })
    }

    /// Where it listens.
    ///
    /// # Errors
    /// As the system reports.
    pub fn address(&self) -> io::Result<SocketAddr> {
        self.listener.local_addr()
    }

    /// Answers every client, each in a thread of its own, since browsers open connections that they may use later.
    /// `take` is given what the page sends.
    ///
    /// # Errors
    /// When the system takes no more connections, for another reason than a lack that may pass.
    pub fn serve(self, take: impl Fn(Posted) + Send + Sync + 'static) -> io::Result<Infallible> {
        let shared = Arc::new((self, take));
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
                // So short an answer fits the system's buffer, and the server does not wait for the client.
                drop(respond(&stream, "503 Service Unavailable", "text/plain", b"too many connections"));
                shared.0.connections.fetch_sub(1, Ordering::SeqCst);
                continue;
            }
            let connection = Arc::clone(&shared);
            let talk = move || {
                let (server, take) = &*connection;
                let _share = Share(&server.connections, 1);
                // A client that breaks off has no use for an error.
                drop(server.talk(&stream, take));
            };
            if std::thread::Builder::new().name("connection".to_owned()).spawn(talk).is_err() {
                // The connection is closed, and the client may try again.
                shared.0.connections.fetch_sub(1, Ordering::SeqCst);
            }
        }
    }

    /// Answers one request. What it brought is taken before the answer, so that what follows cannot overtake it.
    fn talk(&self, stream: &TcpStream, take: impl Fn(Posted)) -> io::Result<()> {
        let mut share = None;
        let reserve = |length| {
            share = Share::take(&self.bodies, length, request::MAX_BODY);
            share.is_some()
        };
        let [for_request, for_answer] = self.patience;
        stream.set_write_timeout(Some(for_answer))?;
        let request = match Request::read(stream, for_request, reserve) {
            Ok(request) => request,
            Err(Refusal::Broken(error)) => return Err(error),
            Err(Refusal::Status(status)) => {
                respond(stream, status, "text/plain", status.as_bytes())?;
                return drain(stream);
            }
        };
        let Request { method, path, body } = request;
        if let ("POST", Some(name)) = (method.as_str(), path.strip_prefix("/results/")) {
            take(Posted { name: name.to_owned(), body });
            return respond(stream, "200 OK", "text/plain", b"");
        }
        let file = FILES.iter().find(|(name, ..)| *name == path);
        let data = path.strip_prefix("/data/").and_then(|name| self.data.get(name));
        match (file, data) {
            (Some((_, kind, text)), _) => respond(stream, "200 OK", kind, text.as_bytes()),
            (None, Some(bytes)) => respond(stream, "200 OK", "application/octet-stream", bytes),
            (None, None) => respond(stream, "404 Not Found", "text/plain", b"there is nothing here"),
        }
    }
}

/// Whether accepting may work again later: a client broke off, or file descriptors or memory are short.
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

fn respond(mut stream: &TcpStream, status: &str, kind: &str, body: &[u8]) -> io::Result<()> {
    let length = body.len();
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}; charset=utf-8\r\nContent-Length: {length}\r\n\
         Cache-Control: no-store\r\nConnection: close\r\n\r\n"
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(body)
}

/// Reads what a refused client still sends, for a moment: closing at once could take the answer from it.
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
