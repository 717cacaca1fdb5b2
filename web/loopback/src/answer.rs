//! The answer to a request, and its head.

use std::sync::Arc;

/// The headers of every answer. No page of another origin may show an answer in a frame, load it or refer to its
/// window. The browser loads nothing from another host, stores no answer, and does not guess content types.
pub const HEADERS: &str = "\
    Content-Security-Policy: default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; \
    style-src 'self' 'unsafe-inline'; img-src 'self' data:; base-uri 'none'; form-action 'none'; \
    frame-ancestors 'none'\r\n\
    X-Frame-Options: DENY\r\n\
    X-Content-Type-Options: nosniff\r\n\
    Referrer-Policy: no-referrer\r\n\
    Cache-Control: no-store\r\n\
    Cross-Origin-Opener-Policy: same-origin\r\n\
    Cross-Origin-Resource-Policy: same-origin\r\n\
    Connection: close\r\n";

/// The answer to a request.
#[derive(Debug)]
pub struct Answer {
    /// The status, such as `200 OK`.
    pub status: &'static str,
    /// The content type, without a character set. Texts are UTF-8.
    pub kind: &'static str,
    /// The content.
    pub body: Arc<Vec<u8>>,
}

impl Answer {
    /// Returns the answer that succeeds with `body`.
    #[must_use]
    pub fn ok(kind: &'static str, body: impl Into<Vec<u8>>) -> Self {
        Self::shared(kind, Arc::new(body.into()))
    }

    /// Returns the answer that succeeds with `body`, which other answers may use at the same time.
    #[must_use]
    pub const fn shared(kind: &'static str, body: Arc<Vec<u8>>) -> Self {
        Self { status: "200 OK", kind, body }
    }

    /// Returns an answer that fails with `status`, and with `text` as an explanation.
    #[must_use]
    pub fn refused(status: &'static str, text: impl Into<String>) -> Self {
        Self { status, kind: "text/plain", body: Arc::new(text.into().into_bytes()) }
    }

    /// Returns the answer to a request for a path that does not exist.
    #[must_use]
    pub fn not_found() -> Self {
        Self::refused("404 Not Found", "there is nothing here")
    }
}
