//! Reads one HTTP/1.1 request, and limits its size and its time.

use std::borrow::Cow;
use std::io::{self, BufRead, Read};
use std::time::Duration;

/// Largest length of the request line and of each header, in bytes.
pub const MAX_LINE: usize = 8192;

/// Largest number of headers of a request.
pub const MAX_HEADERS: usize = 100;

/// Largest length of a body, in bytes: a text of 16 MiB, and what is said about it.
pub const MAX_BODY: usize = (16 << 20) + 1024;

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
    /// The server answers with this HTTP status and this text.
    Status(&'static str, Cow<'static, str>),
    /// The connection is broken or too slow, so the server does not answer.
    Broken(io::Error),
}

impl Refusal {
    /// Returns the refusal with `status`. Its text is the status too.
    const fn status(status: &'static str) -> Self {
        Self::Status(status, Cow::Borrowed(status))
    }
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Self {
        Self::Broken(error)
    }
}

/// The request line and the headers that this server uses.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Head {
    /// The method, such as `GET`.
    pub method: String,
    /// The path with its query, from the first slash.
    pub path: String,
    /// Length of the body in bytes.
    pub length: usize,
    /// Whether a page of another origin has sent the request, as the browser says.
    pub is_foreign: bool,
    /// The value of `Authorization`.
    pub authorization: Option<String>,
    /// The cookies, each as `NAME=VALUE`.
    pub cookies: Vec<String>,
}

impl Head {
    /// Reads the request line and all headers.
    ///
    /// # Errors
    /// [`Refusal::Status`] if the request exceeds a limit, has a foreign name in `Host` or a foreign `Origin`, or is
    /// not HTTP. [`Refusal::Broken`] if the connection ends or is too slow.
    pub fn read(reader: &mut impl BufRead) -> Result<Self, Refusal> {
        const TOO_LARGE: &str = "431 Request Header Fields Too Large";
        const BAD: Refusal = Refusal::status("400 Bad Request");

        let first = line(reader, "414 URI Too Long")?;
        let mut words = first.split(' ').map(str::to_owned);
        let (method, path) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
        let (mut head, mut hosts, mut origin) = (Self { method, path, ..Self::default() }, Vec::new(), None);
        for count in 0.. {
            let line = line(reader, TOO_LARGE)?;
            if line.is_empty() {
                break;
            }
            if count == MAX_HEADERS {
                return Err(Refusal::status(TOO_LARGE));
            }
            let Some((name, value)) = line.split_once(':') else { continue };
            let value = value.trim();
            match name.to_ascii_lowercase().as_str() {
                "host" => hosts.push(value.to_owned()),
                "origin" => origin = Some(value.strip_prefix("http://").unwrap_or(value).to_owned()),
                "sec-fetch-site" => head.is_foreign |= !["same-origin", "none"].contains(&value),
                "authorization" => head.authorization = Some(value.to_owned()),
                "cookie" => head.cookies.extend(value.split(';').map(|cookie| cookie.trim().to_owned())),
                "content-length" => head.length = value.parse().map_err(|_| BAD)?,
                _ => {}
            }
        }
        let [host] = &hosts[..] else { return Err(BAD) };
        // A page of another server on this machine has another port in its origin.
        if !is_this_machine(host) || origin.is_some_and(|origin| origin != *host) {
            return Err(Refusal::status("403 Forbidden"));
        }
        Ok(head)
    }

    /// Reads the body of a `POST` request. Requests of other methods have none.
    ///
    /// # Errors
    /// [`Refusal::Status`] if the body is too long, or if memory is short. [`Refusal::Broken`] if the connection ends
    /// or is too slow.
    pub fn with_body(self, reader: &mut impl BufRead) -> Result<Request, Refusal> {
        let Self { method, path, length, .. } = self;
        let length = if method == "POST" { length } else { 0 };
        if length > MAX_BODY {
            let text = format!("a body of {length} bytes is too long; it may have {MAX_BODY}");
            return Err(Refusal::Status("413 Content Too Large", text.into()));
        }
        let mut body = Vec::new();
        let short = |_| Refusal::Status("503 Service Unavailable", "memory is short".into());
        body.try_reserve_exact(length).map_err(short)?;
        body.resize(length, 0);
        reader.read_exact(&mut body)?;
        Ok(Request { method, path, body })
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
        _ => Err(Refusal::status(too_long)),
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

    fn read(mut text: &[u8]) -> Result<Request, &'static str> {
        let request = Head::read(&mut text).and_then(|head| head.with_body(&mut text));
        request.map_err(|refusal| match refusal {
            Refusal::Status(status, _) => &status[..3],
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
    fn a_body_of_exactly_the_limit_is_read_and_one_byte_more_refused() {
        let post =
            |length: usize| format!("POST /results/a HTTP/1.1\r\nHost: [::1]:1\r\nContent-Length: {length}\r\n\r\n");
        let mut whole = post(MAX_BODY).into_bytes();
        whole.resize(whole.len() + MAX_BODY, b'x');
        assert!(read(&whole).is_ok_and(|request| request.body.len() == MAX_BODY));
        assert_eq!(read(post(MAX_BODY + 1).as_bytes()), Err("413"));
        assert_eq!(read(post(usize::MAX).as_bytes()), Err("413"));
        assert_eq!(read(post(3).as_bytes()), Err("broken"), "the body is missing");
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
    fn the_browser_says_which_pages_are_foreign() {
        let is_foreign = |headers: &str| {
            let text = format!("GET / HTTP/1.1\r\nHost: localhost\r\n{headers}\r\n");
            Head::read(&mut text.as_bytes()).expect("it is valid").is_foreign
        };
        for own in ["", "Sec-Fetch-Site: same-origin\r\n", "sec-fetch-site:none\r\n"] {
            assert!(!is_foreign(own), "{own}");
        }
        for site in ["cross-site", "same-site", "", "none, cross-site"] {
            assert!(is_foreign(&format!("Sec-Fetch-Site: {site}\r\n")), "{site}");
        }
        assert!(is_foreign("Sec-Fetch-Site: cross-site\r\nSec-Fetch-Site: none\r\n"));
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
