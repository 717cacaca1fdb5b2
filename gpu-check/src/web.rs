//! Runs shaders in a browser: serves two pages of `web/` and the data that they load, and takes their results.
//! [`loopback`] is the server, and [`chromium`] starts a browser. The page `/jobs` runs a list of [`jobs`]. The page
//! `/conformance` runs the probes of [`conformance`](crate::conformance).

pub mod chromium;
pub mod formulas;
pub mod jobs;
pub mod lowered;

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::io;
use std::net::SocketAddr;

use loopback::Answer;
use loopback::request::Request;

/// The pages' files: the path of the request, the content type and the text.
const FILES: [(&str, &str, &str); 5] = [
    ("/jobs", "text/html", include_str!("../web/jobs.html")),
    ("/jobs.js", "text/javascript", include_str!("../web/jobs.js")),
    ("/gpu.js", "text/javascript", include_str!("../web/gpu.js")),
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
        self.server.serve(move |request, _| answer(request, &data, &take))
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
