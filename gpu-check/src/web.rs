//! Serves the page of `shader-lab`: the files of `web/`, and the data that the page loads. [`loopback`] is the server,
//! and [`chromium`] starts a browser.

pub mod chromium;
pub mod data;
pub mod lowered;

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::io;
use std::net::SocketAddr;

use loopback::Answer;
use loopback::request::Request;

/// The page's icon.
const ICON: &str = include_str!("../web/icon.svg");

/// The page's files: the path of the request, the content type and the text.
const FILES: [(&str, &str, &str); 13] = [
    ("/", "text/html", include_str!("../web/index.html")),
    ("/?drive", "text/html", include_str!("../web/index.html")),
    ("/icon.svg", "image/svg+xml", ICON),
    // Browsers request this icon before they have read which icon the page names.
    ("/favicon.ico", "image/svg+xml", ICON),
    ("/lab.css", "text/css", include_str!("../web/lab.css")),
    ("/page.js", "text/javascript", include_str!("../web/page.js")),
    ("/lab.js", "text/javascript", include_str!("../web/lab.js")),
    ("/gpu.js", "text/javascript", include_str!("../web/gpu.js")),
    ("/drive.js", "text/javascript", include_str!("../web/drive.js")),
    ("/lowered", "text/html", include_str!("../web/lowered.html")),
    ("/lowered.js", "text/javascript", include_str!("../web/lowered.js")),
    ("/conformance", "text/html", include_str!("../web/conformance.html")),
    ("/conformance.js", "text/javascript", include_str!("../web/conformance.js")),
];

/// A server that listens at a port.
#[derive(Debug)]
pub struct Server {
    server: loopback::Server,
    data: BTreeMap<String, Vec<u8>>,
}

/// A result that the page sent by `POST` to `results/`.
#[derive(Clone, Debug)]
pub struct Posted {
    /// The part of the path after `results/`.
    pub name: String,
    /// The bytes of the result.
    pub body: Vec<u8>,
}

impl Server {
    /// Returns a server that listens at `port`, or at any free port if `port` is 0. The server answers a request for
    /// `data/KEY` with the bytes of that key in `data`.
    ///
    /// # Errors
    /// An error if the port is in use.
    pub fn new(port: u16, data: BTreeMap<String, Vec<u8>>) -> io::Result<Self> {
        Ok(Self { server: loopback::Server::new(port)?, data })
    }

    /// Returns the address at which the server listens.
    ///
    /// # Errors
    /// The error of the system.
    pub fn address(&self) -> io::Result<SocketAddr> {
        self.server.address()
    }

    /// Serves every client. Calls `take` with each result that the page sends, before the answer, so that the results
    /// of a page arrive in order.
    ///
    /// # Errors
    /// An error if the system can accept no more connections.
    pub fn serve(self, take: impl Fn(Posted) + Send + Sync + 'static) -> io::Result<Infallible> {
        let data = self.data;
        self.server.serve(move |request| answer(request, &data, &take))
    }
}

/// Answers a request with a file or with data. If the request posts a result, calls `take` with it.
fn answer(request: Request, data: &BTreeMap<String, Vec<u8>>, take: &impl Fn(Posted)) -> Answer {
    let Request { method, path, body } = request;
    if let ("POST", Some(name)) = (method.as_str(), path.strip_prefix("/results/")) {
        take(Posted { name: name.to_owned(), body });
        return Answer::ok("text/plain", &b""[..]);
    }
    if let Some((_, kind, text)) = FILES.iter().find(|(name, ..)| *name == path) {
        return Answer::ok(kind, text.as_bytes());
    }
    match path.strip_prefix("/data/").and_then(|name| data.get(name)) {
        Some(bytes) => Answer::ok("application/octet-stream", bytes.clone()),
        None => Answer::not_found(),
    }
}

#[cfg(test)]
mod tests;
