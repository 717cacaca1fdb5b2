//! The secret that a browser must have to use a server. All users of a machine can connect to its loopback address, and
//! every page in a browser can send requests there.
//!
//! The program prints an address with the secret. From there on a browser proves it in two ways:
//!
//! - A request for data, or with a body, has the secret in the header `Authorization`. The page keeps the secret in its
//!   storage, which a browser separates by port.
//! - Files of the page are requested by the browser, which adds no such header. They need a cookie, which the answer to
//!   the address with the secret sets. It is `SameSite=Strict`, so a foreign page cannot open this one. A browser sends
//!   a cookie to all ports of a host, and so to servers of other users. So the cookie is a second secret, which opens
//!   nothing but the files of the page.

use crate::request::Head;

/// What a request may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Admission {
    /// Nothing.
    None,
    /// May use the requested path.
    Full,
    /// Gets the index page and the cookie. The request is the first one, with the secret in its address.
    First,
}

/// The two secrets of a server.
#[derive(Clone, Debug)]
pub struct Secret {
    /// The secret in the address and in `Authorization`.
    key: String,
    /// The name and the value of the cookie.
    cookie: String,
    /// The start of the paths that a cookie does not open.
    private: &'static str,
}

impl Secret {
    /// Returns new secrets for the server at `port`. Paths that begin with `private` are data, which a cookie does not
    /// open.
    ///
    /// # Errors
    /// An error if the system gives no random numbers.
    pub fn new(port: u16, private: &'static str) -> std::io::Result<Self> {
        Ok(Self { key: random()?, cookie: format!("page-{port}={}", random()?), private })
    }

    /// Returns the path of the address with the secret.
    #[must_use]
    pub fn path(&self) -> String {
        format!("/?secret={}", self.key)
    }

    /// Returns the value of the header that sets the cookie.
    #[must_use]
    pub fn set_cookie(&self) -> String {
        format!("{}; Path=/; SameSite=Strict; HttpOnly", self.cookie)
    }

    /// Returns what the request with this head may do.
    #[must_use]
    pub fn admit(&self, head: &Head) -> Admission {
        // The page takes the secret from its query. So a cookie opens no address with a query. Otherwise a link of a
        // stranger could replace the secret that the page has.
        let is_file = head.method == "GET" && !head.path.starts_with(self.private) && !head.path.contains('?');
        let has_key = |header: &String| header.strip_prefix("Bearer ").is_some_and(|key| is_same(key, &self.key));
        let has_cookie = || head.cookies.iter().any(|cookie| is_same(cookie, &self.cookie));
        if head.method == "GET" && is_same(&head.path, &self.path()) {
            Admission::First
        } else if head.authorization.as_ref().is_some_and(has_key) || is_file && has_cookie() {
            Admission::Full
        } else {
            Admission::None
        }
    }
}

/// Returns 128 random bits as hexadecimal digits.
fn random() -> std::io::Result<String> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(std::io::Error::other)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

/// Whether two texts are the same. The time does not depend on the number of equal leading bytes. So it reveals nothing
/// about a secret but its length.
fn is_same(one: &str, other: &str) -> bool {
    let differences = one.bytes().zip(other.bytes()).fold(0, |bits, (one, other)| bits | (one ^ other));
    one.len() == other.len() && std::hint::black_box(differences) == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(method: &str, path: &str) -> Head {
        Head { method: method.to_owned(), path: path.to_owned(), ..Head::default() }
    }

    #[test]
    fn the_address_the_header_and_the_cookie_open_what_they_should() {
        let secret = Secret::new(8020, "/view/").expect("there are random numbers");
        let first = head("GET", &secret.path());
        assert_eq!(secret.admit(&first), Admission::First);
        assert_eq!(secret.admit(&Head { method: "POST".to_owned(), ..first }), Admission::None);
        for (method, path, by_cookie) in [
            ("GET", "/", Admission::Full),
            ("GET", "/main.js", Admission::Full),
            ("GET", "/?secret=x", Admission::None),
            ("GET", "/?a=1&%73ecret=x", Admission::None),
            ("GET", "/index.html?secret=x", Admission::None),
            ("GET", "/view/files", Admission::None),
            ("POST", "/main.js", Admission::None),
            ("POST", "/view/camera", Admission::None),
        ] {
            let with = |authorization: &str, cookie: &str| {
                let (authorization, cookies) = (Some(authorization.to_owned()), vec![cookie.to_owned()]);
                secret.admit(&Head { authorization, cookies, ..head(method, path) })
            };
            assert_eq!(secret.admit(&head(method, path)), Admission::None, "{path}");
            assert_eq!(with("", &secret.cookie), by_cookie, "{path}");
            assert_eq!(with(&format!("Bearer {}", secret.key), ""), Admission::Full, "{path}");
            for wrong in [secret.key.clone(), "Bearer ".to_owned(), format!("Bearer {}0", secret.key)] {
                assert_eq!(with(&wrong, "page-8020="), Admission::None, "{path}");
            }
        }
    }

    #[test]
    fn secrets_are_long_and_never_the_same() {
        let [one, other] = [1, 1].map(|port| Secret::new(port, "/").expect("there are random numbers"));
        assert_eq!((one.key.len(), one.cookie.len()), (32, "page-1=".len() + 32));
        assert!(one.key != other.key && one.cookie != other.cookie && !one.cookie.contains(&one.key));
    }
}
