//! Reads one HTTP/1.1 request, and limits its size and its time.

use std::io::{self, BufRead, BufReader, Read};
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// Largest length of the request line and of each header, in bytes.
pub const MAX_LINE: usize = 8192;

/// Largest number of headers of a request.
pub const MAX_HEADERS: usize = 100;

/// Largest length of a body in bytes, and of all bodies together that are received at the same time.
pub const MAX_BODY: usize = 64 << 20;

/// Time limit for a client to send its whole request.
pub const MAX_TIME: Duration = Duration::from_secs(30);

/// The names in `Host` that a page from this machine may use for this server. A request with another name comes from a
/// foreign page: its author makes that name resolve to this machine, to read the data (DNS rebinding).
const HOSTS: [&str; 3] = ["127.0.0.1", "localhost", "[::1]"];

/// A request that a client has sent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Request {
    /// The method, such as `GET`.
    pub method: String,
    /// The path with its query, from the first slash.
    pub path: String,
    /// The body of a `POST` request; empty for other methods.
    pub body: Vec<u8>,
}

/// The reason why a request is refused.
#[derive(Debug)]
pub enum Refusal {
    /// The server answers with this HTTP status.
    Status(&'static str),
    /// The connection is broken or too slow, so the server does not answer.
    Broken(io::Error),
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Self {
        Self::Broken(error)
    }
}

/// A stream whose reads fail after the time `end`. If only each read had a limit, a slow client could send forever.
struct Timed<'a> {
    stream: &'a TcpStream,
    end: Instant,
}

impl Read for Timed<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let left = self.end.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(io::ErrorKind::TimedOut.into());
        }
        self.stream.set_read_timeout(Some(left))?;
        self.stream.read(buffer)
    }
}

impl Request {
    /// Reads a request, which the client must send within `time`. Calls `reserve` with the length of the body before
    /// receiving it. If `reserve` returns false, the request is refused.
    ///
    /// # Errors
    /// [`Refusal::Status`] if the request exceeds a limit, has a foreign name in `Host`, or is not HTTP.
    /// [`Refusal::Broken`] if the connection ends or is too slow.
    pub fn read(stream: &TcpStream, time: Duration, reserve: impl FnOnce(usize) -> bool) -> Result<Self, Refusal> {
        Self::parse(BufReader::new(Timed { stream, end: Instant::now() + time }), reserve)
    }

    fn parse(mut reader: impl BufRead, reserve: impl FnOnce(usize) -> bool) -> Result<Self, Refusal> {
        let first = line(&mut reader, "414 URI Too Long")?;
        let mut words = first.split(' ').map(str::to_owned);
        let (method, path) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
        let headers = Headers::read(&mut reader)?;
        let [host] = &headers.hosts[..] else { return Err(Refusal::Status("400 Bad Request")) };
        // A page of another server on this machine has another port in its origin.
        if !is_this_machine(host) || headers.origin.as_ref().is_some_and(|origin| origin != host) {
            return Err(Refusal::Status("403 Forbidden"));
        }
        let mut body = Vec::new();
        if method == "POST" {
            if headers.length > MAX_BODY {
                return Err(Refusal::Status("413 Content Too Large"));
            }
            if !reserve(headers.length) || body.try_reserve_exact(headers.length).is_err() {
                return Err(Refusal::Status("503 Service Unavailable"));
            }
            body.resize(headers.length, 0);
            reader.read_exact(&mut body)?;
        }
        Ok(Self { method, path, body })
    }
}

/// The headers that this server uses.
#[derive(Default)]
struct Headers {
    hosts: Vec<String>,
    /// The address of the page that sends the request; `None` if the browser does not send it.
    origin: Option<String>,
    length: usize,
}

impl Headers {
    fn read(reader: &mut impl BufRead) -> Result<Self, Refusal> {
        const TOO_LARGE: &str = "431 Request Header Fields Too Large";

        let mut headers = Self::default();
        for _ in 0..=MAX_HEADERS {
            let line = line(reader, TOO_LARGE)?;
            if line.is_empty() {
                return Ok(headers);
            }
            let Some((name, value)) = line.split_once(':') else { continue };
            let value = value.trim();
            match name.to_ascii_lowercase().as_str() {
                "host" => headers.hosts.push(value.to_owned()),
                "origin" => headers.origin = Some(value.strip_prefix("http://").unwrap_or(value).to_owned()),
                "content-length" => {
                    headers.length = value.parse().map_err(|_| Refusal::Status("400 Bad Request"))?;
                }
                _ => {}
            }
        }
        Err(Refusal::Status(TOO_LARGE))
    }
}

/// Returns the next line without its line end. A line of more than [`MAX_LINE`] bytes is refused with the status
/// `too_long`.
fn line(reader: &mut impl BufRead, too_long: &'static str) -> Result<String, Refusal> {
    let mut line = Vec::new();
    // Two more bytes, for the line end.
    let length = reader.take(MAX_LINE as u64 + 2).read_until(b'\n', &mut line)?;
    if length == 0 {
        return Err(Refusal::Broken(io::ErrorKind::UnexpectedEof.into()));
    }
    let content = line.strip_suffix(b"\n").map(|line| line.strip_suffix(b"\r").unwrap_or(line));
    match content {
        Some(content) if content.len() <= MAX_LINE => Ok(String::from_utf8_lossy(content).into_owned()),
        None if length < MAX_LINE + 2 => Err(Refusal::Broken(io::ErrorKind::UnexpectedEof.into())),
        _ => Err(Refusal::Status(too_long)),
    }
}

/// Whether `host`, with or without a port, is one of the names in [`HOSTS`].
fn is_this_machine(host: &str) -> bool {
    let is_port = |text: &str| text.parse::<u16>().is_ok();
    HOSTS.iter().any(|name| {
        let rest = host.get(..name.len()).filter(|start| start.eq_ignore_ascii_case(name)).map(|_| &host[name.len()..]);
        rest.is_some_and(|rest| rest.is_empty() || rest.strip_prefix(':').is_some_and(is_port))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &[u8]) -> Result<Request, &'static str> {
        Request::parse(text, |_| true).map_err(|refusal| match refusal {
            Refusal::Status(status) => &status[..3],
            Refusal::Broken(_) => "broken",
        })
    }

    fn with_headers(headers: &str) -> Result<Request, &'static str> {
        read(format!("GET / HTTP/1.1\r\n{headers}\r\n").as_bytes())
    }

    #[test]
    fn a_request_line_of_exactly_the_limit_is_read_and_one_byte_more_refused() {
        let rest = " HTTP/1.1\r\nHost: localhost\r\n\r\n";
        let path = "x".repeat(MAX_LINE - "GET / HTTP/1.1".len());
        assert!(
            read(format!("GET /{path}{rest}").as_bytes()).is_ok_and(|request| request.path.len() == path.len() + 1)
        );
        assert_eq!(read(format!("GET /{path}x{rest}").as_bytes()), Err("414"));
        assert_eq!(read(&[b'x'; 3 * MAX_LINE]), Err("414"), "a line without an end is not read to its end");
    }

    #[test]
    fn headers_have_limits_on_their_size_and_their_number() {
        let long = |length: usize| format!("Host: localhost\r\nA: {}\r\n", "x".repeat(length - "A: ".len()));
        assert!(with_headers(&long(MAX_LINE)).is_ok());
        assert_eq!(with_headers(&long(MAX_LINE + 1)), Err("431"));
        let many = |count: usize| format!("Host: localhost\r\n{}", "A: b\r\n".repeat(count - 1));
        assert!(with_headers(&many(MAX_HEADERS)).is_ok());
        assert_eq!(with_headers(&many(MAX_HEADERS + 1)), Err("431"));
    }

    #[test]
    fn a_body_has_a_limit_and_counts_towards_the_limit_of_all_bodies() {
        let post =
            |length: usize| format!("POST /results/a HTTP/1.1\r\nHost: [::1]:1\r\nContent-Length: {length}\r\n\r\n");
        let mut whole = post(MAX_BODY).into_bytes();
        whole.resize(whole.len() + MAX_BODY, b'x');
        assert!(read(&whole).is_ok_and(|request| request.body.len() == MAX_BODY));
        assert_eq!(read(post(MAX_BODY + 1).as_bytes()), Err("413"));
        assert_eq!(read(post(usize::MAX).as_bytes()), Err("413"));
        assert_eq!(read(post(3).as_bytes()), Err("broken"), "the body is missing");
        let refusal = Request::parse(post(3).as_bytes(), |length| length != 3).expect_err("no share is left");
        assert!(matches!(refusal, Refusal::Status("503 Service Unavailable")));
        assert_eq!(with_headers("Host: localhost\r\nContent-Length: -1\r\n"), Err("400"));
    }

    #[test]
    fn names_that_are_not_of_this_machine_are_refused() {
        for host in ["127.0.0.1", "127.0.0.1:8000", "localhost:1", "LOCALHOST", "[::1]:65535"] {
            assert!(with_headers(&format!("Host: {host}\r\n")).is_ok(), "{host}");
        }
        for host in ["evil.example", "127.0.0.1.evil.example", "localhost:", "localhost:x", "localhost@evil", "", "ä"]
        {
            assert_eq!(with_headers(&format!("Host: {host}\r\n")), Err("403"), "{host}");
        }
        assert_eq!(with_headers(""), Err("400"), "it names no host");
        assert_eq!(with_headers("Host: localhost\r\nHost: localhost\r\n"), Err("400"));
        assert!(with_headers("Host: localhost:1\r\nOrigin: http://localhost:1\r\n").is_ok());
        for origin in
            ["https://evil.example", "http://localhost:2", "http://127.0.0.1:1", "https://localhost:1", "null"]
        {
            assert_eq!(with_headers(&format!("Host: localhost:1\r\nOrigin: {origin}\r\n")), Err("403"), "{origin}");
        }
    }

    #[test]
    fn a_request_that_ends_early_is_broken() {
        for text in ["", "GET / HTTP/1.1", "GET / HTTP/1.1\r\nHost: localhost", "GET / HTTP/1.1\r\nHost: localhost\r\n"]
        {
            assert_eq!(read(text.as_bytes()), Err("broken"), "{text}");
        }
        assert!(read(b"\xff\xfe\r\nHost: localhost\r\n\r\n").is_ok(), "any bytes are read");
    }
}
