//! A server of one page, to this machine only: `web/` and the data that it asks for.
//!
//! A page from a file may not fetch, and WebGPU wants a trusted origin, which the loopback address is. A request is
//! answered and its connection closed; nothing here is for the open network.

pub mod data;

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::time::Duration;

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
/// Most bytes that the page may send.
const MOST: usize = 256 << 20;

/// The server, ready to be asked.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    data: BTreeMap<String, Vec<u8>>,
}

/// What the page sent under `results/`.
#[derive(Clone, Debug)]
pub struct Posted {
    /// The rest of the address.
    pub name: String,
    /// Its content.
    pub body: Vec<u8>,
}

impl Server {
    /// A server of `data`, by what stands after `data/` in the address, at `port`, or at any that is free for zero.
    ///
    /// # Errors
    /// When the port is taken.
    pub fn new(port: u16, data: BTreeMap<String, Vec<u8>>) -> io::Result<Self> {
        Ok(Self { listener: TcpListener::bind(("127.0.0.1", port))?, data })
    }

    /// Where it listens.
    ///
    /// # Errors
    /// As the system reports.
    pub fn address(&self) -> io::Result<SocketAddr> {
        self.listener.local_addr()
    }

    /// Answers whoever asks, each in a thread of its own, since browsers open connections that they may use later.
    /// What is sent under `results/` goes to `take`.
    ///
    /// # Errors
    /// When no further connection can come. A fault of one connection is that connection's end and nothing else.
    pub fn serve(self, take: impl Fn(Posted) + Send + Sync + 'static) -> io::Result<Infallible> {
        let shared = Arc::new((self, take));
        loop {
            let (stream, _) = shared.0.listener.accept()?;
            let shared = Arc::clone(&shared);
            std::thread::spawn(move || shared.0.talk(stream, &shared.1));
        }
    }

    /// Answers one request. What it brought is taken before the answer, so that what follows cannot overtake it.
    fn talk(&self, mut stream: TcpStream, take: impl Fn(Posted)) -> io::Result<()> {
        stream.set_read_timeout(Some(Duration::from_secs(10)))?;
        let mut reader = BufReader::new(stream.try_clone()?);
        let mut line = String::new();
        reader.read_line(&mut line)?;
        let mut words = line.split(' ').map(str::to_owned);
        let (method, path) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
        let length = content_length(&mut reader)?.min(MOST);
        if let ("POST", Some(name)) = (method.as_str(), path.strip_prefix("/results/")) {
            let mut body = vec![0; length];
            reader.read_exact(&mut body)?;
            take(Posted { name: name.to_owned(), body });
            return respond(&mut stream, "200 OK", "text/plain", b"");
        }
        let file = FILES.iter().find(|(name, ..)| *name == path);
        let data = path.strip_prefix("/data/").and_then(|name| self.data.get(name));
        match (file, data) {
            (Some((_, kind, text)), _) => respond(&mut stream, "200 OK", kind, text.as_bytes()),
            (None, Some(bytes)) => respond(&mut stream, "200 OK", "application/octet-stream", bytes),
            (None, None) => respond(&mut stream, "404 Not Found", "text/plain", b"there is nothing here"),
        }
    }
}

/// Reads the headers to their end.
fn content_length(reader: &mut impl BufRead) -> io::Result<usize> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if reader.read_line(&mut line)? == 0 || line.trim().is_empty() {
            return Ok(length);
        }
        if let Some((name, value)) = line.split_once(':')
            && name.eq_ignore_ascii_case("content-length")
        {
            length = value.trim().parse().unwrap_or(0);
        }
    }
}

fn respond(stream: &mut TcpStream, status: &str, kind: &str, body: &[u8]) -> io::Result<()> {
    let length = body.len();
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}; charset=utf-8\r\nContent-Length: {length}\r\n\
         Cache-Control: no-store\r\nConnection: close\r\n\r\n"
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(body)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    fn asked(request: &str) -> (String, Option<Posted>) {
        let server = Server::new(0, BTreeMap::from([("a".to_owned(), b"numbers".to_vec())])).expect("a port is free");
        let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
        client.write_all(request.as_bytes()).expect("it reads");
        let (stream, _) = server.listener.accept().expect("there is a connection");
        let posted = Cell::new(None);
        server.talk(stream, |taken| posted.set(Some(taken))).expect("it is a request");
        let mut answer = String::new();
        client.read_to_string(&mut answer).expect("it answers in text");
        (answer, posted.into_inner())
    }

    #[test]
    fn the_page_and_its_data_are_handed_out() {
        let page = asked("GET / HTTP/1.1\r\n\r\n").0;
        assert!(page.contains("<title>shader-lab</title>"));
        // A browser asks for no other icon.
        assert!(page.contains("<link rel=\"icon\" href=\"data:image/svg+xml,") && page.contains("width=device-width"));
        assert!(asked("GET /data/a HTTP/1.1\r\n\r\n").0.ends_with("\r\n\r\nnumbers"));
    }

    #[test]
    fn nothing_else_is() {
        for path in ["/data/b", "/../Cargo.toml", "//etc/passwd", ""] {
            assert!(asked(&format!("GET {path} HTTP/1.1\r\n\r\n")).0.starts_with("HTTP/1.1 404"), "{path}");
        }
    }

    #[test]
    fn results_are_taken() {
        let (_, posted) = asked("POST /results/kernels/sphere HTTP/1.1\r\nContent-Length: 3\r\n\r\nabc");
        let posted = posted.expect("it brought something");
        assert_eq!((posted.name.as_str(), &posted.body[..]), ("kernels/sphere", &b"abc"[..]));
    }
}
