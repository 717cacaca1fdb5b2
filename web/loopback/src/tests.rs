//! Tests of the server with clients over real connections.

use std::io::Read;

use super::*;
use crate::connections::MAX_CONNECTIONS;

mod slow;

fn server() -> Server {
    Server::new(0).expect("a port is free")
}

/// The answers of the tests' server.
fn answer(request: Request) -> Answer {
    match request.path.as_str() {
        "/data/a" => Answer::ok("text/plain", &b"numbers"[..]),
        "/echo" => Answer::ok("text/plain", request.body),
        "/large" => Answer::ok("text/plain", vec![b'x'; slow::LARGE]),
        _ => Answer::not_found(),
    }
}

/// Sends `request` and returns the answer. An error of writing is ignored, because the server may close the connection
/// before it has read the whole request.
fn answer_to(address: SocketAddr, request: &str) -> String {
    let mut client = TcpStream::connect(address).expect("it listens");
    let _ = client.write_all(request.as_bytes());
    let mut answer = Vec::new();
    let _ = client.read_to_end(&mut answer);
    String::from_utf8_lossy(&answer).into_owned()
}

fn asked(request: &str) -> String {
    asked_of(&server(), request)
}

fn asked_of(server: &Server, request: &str) -> String {
    let (mut client, stream) = connected(server, request);
    // The result is an error for a refused client, because this client keeps its end of the connection open.
    let _ = talk(server, &stream);
    drop(stream);
    let mut answer = String::new();
    client.read_to_string(&mut answer).expect("it answers in text");
    answer
}

/// Returns both ends of a new connection: that of the client, which has sent `request`, and that of the server.
fn connected(server: &Server, request: &str) -> (TcpStream, Arc<TcpStream>) {
    let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
    client.write_all(request.as_bytes()).expect("it reads");
    (client, Arc::new(server.listener.accept().expect("there is a connection").0))
}

/// Answers the one request of a connection.
fn talk(server: &Server, stream: &Arc<TcpStream>) -> io::Result<()> {
    let number = server.connections.enter(stream).expect("there is a place");
    server.talk(stream, server.connections.place(number), answer)
}

fn get(path: &str) -> String {
    format!("GET {path} HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
}

#[test]
fn a_request_is_answered_with_what_the_owner_says() {
    assert!(asked(&get("/data/a")).ends_with("\r\n\r\nnumbers"));
    assert!(asked(&get("/data/b")).starts_with("HTTP/1.1 404"));
    assert!(asked(&get("/data/a")).contains("Content-Type: text/plain; charset=utf-8\r\nContent-Length: 7\r\n"));
}

#[test]
fn a_foreign_name_for_this_server_gets_nothing() {
    let answer = asked("GET /data/a HTTP/1.1\r\nHost: evil.example\r\n\r\n");
    assert!(answer.starts_with("HTTP/1.1 403") && !answer.contains("numbers"), "{answer}");
    let answer = asked("GET /data/a HTTP/1.1\r\nHost: localhost\r\nSec-Fetch-Site: cross-site\r\n\r\n");
    assert!(answer.contains("a page of another origin") && !answer.contains("secret"), "{answer}");
}

#[test]
fn every_answer_has_the_headers_that_keep_foreign_pages_out() {
    let foreign = "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n";
    for answer in [get("/data/a"), get("/none"), foreign.to_owned()].map(|request| asked(&request)) {
        for header in [
            "frame-ancestors 'none'\r\n",
            "\r\nContent-Security-Policy: default-src 'self'; ",
            "\r\nX-Frame-Options: DENY\r\n",
            "\r\nX-Content-Type-Options: nosniff\r\n",
            "\r\nCache-Control: no-store\r\n",
            "\r\nCross-Origin-Opener-Policy: same-origin\r\n",
            "\r\nCross-Origin-Resource-Policy: same-origin\r\n",
        ] {
            assert!(answer.contains(header), "{header}: {answer}");
        }
    }
}

#[test]
fn a_server_with_a_secret_answers_only_requests_that_prove_it() {
    let server = server().with_secret("/data/").expect("there are random numbers");
    let path = server.url().expect("it listens").split_once(":").expect("it is an address").1[12..].to_owned();
    let path = &path[path.find('/').expect("there is a path")..];
    let key = path.strip_prefix("/?secret=").expect("it has the secret");
    let ask = |path: &str, headers: &str| {
        asked_of(&server, &format!("GET {path} HTTP/1.1\r\nHost: localhost\r\n{headers}\r\n"))
    };
    assert!(ask("/data/a", "").starts_with("HTTP/1.1 403 Forbidden"));
    assert!(ask("/data/a", "").contains("Open the address that the program has printed."));
    assert!(ask("/data/a", &format!("Authorization: Bearer {key}\r\n")).ends_with("\r\n\r\nnumbers"));
    // Another page may open the address with the secret. The browser then has the cookie.
    let first = ask(path, "Sec-Fetch-Site: cross-site\r\n");
    let cookie = first.split("Set-Cookie: ").nth(1).and_then(|rest| rest.split("\r\n").next()).expect("there is one");
    let cookie = cookie.strip_suffix("; Path=/; SameSite=Strict; HttpOnly").expect("it is strict").to_owned();
    let cookie = format!("Cookie: other=1; {cookie}\r\n");
    assert!(ask("/b", &cookie).starts_with("HTTP/1.1 404") && !ask("/b", &cookie).contains("Set-Cookie"));
    assert!(ask("/b", "").starts_with("HTTP/1.1 403"));
    assert!(ask("/data/a", &cookie).starts_with("HTTP/1.1 403"), "a cookie opens no data");
    assert!(ask("/b", &format!("{cookie}Sec-Fetch-Site: same-site\r\n")).starts_with("HTTP/1.1 403"));
    // The body of a client without the secret is not received.
    let post = format!("POST /echo HTTP/1.1\r\nHost: localhost\r\n{cookie}Content-Length: 9000000\r\n\r\n");
    assert!(asked_of(&server, &post).starts_with("HTTP/1.1 403"));
}

/// Repeats a request until its answer starts with `wanted`.
fn until(address: SocketAddr, wanted: &str) {
    for _ in 0..1000 {
        if answer_to(address, &get("/data/a")).starts_with(wanted) {
            return;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    panic!("no answer starts with {wanted}");
}

#[test]
fn clients_that_send_nothing_keep_no_other_client_away() {
    let server = server();
    let address = server.address().expect("it listens");
    std::thread::spawn(move || server.serve(answer));
    let silent: Vec<_> = (0..2 * MAX_CONNECTIONS).map(|_| TcpStream::connect(address).expect("it listens")).collect();
    assert!(answer_to(address, &get("/data/a")).ends_with("numbers"));
    // The oldest ones are closed, to make room for the newest ones.
    let is_closed = |mut stream: &TcpStream| {
        stream.set_read_timeout(Some(Duration::from_secs(20))).expect("it is open");
        stream.read(&mut [0]).is_ok_and(|length| length == 0)
    };
    assert!(silent[..MAX_CONNECTIONS].iter().all(is_closed));
    let last = silent.last().expect("there are some");
    last.set_nonblocking(true).expect("it is open");
    assert_eq!(last.peek(&mut [0]).expect_err("it is open").kind(), io::ErrorKind::WouldBlock);
}

#[test]
fn a_refused_client_has_its_place_until_its_connection_ends() {
    // The server shuts its side down before it drains the connection, so the answer ends while the place is taken. One
    // look may come too late, so the test looks several times.
    let is_counted = || {
        let server = server();
        let (mut client, stream) = connected(&server, "bad\r\n\r\n");
        std::thread::scope(|scope| {
            let refused = scope.spawn(|| drop(talk(&server, &stream)));
            client.read_to_end(&mut Vec::new()).expect("it is answered");
            let count = server.connections.count();
            drop(refused.join());
            assert_eq!(server.connections.count(), 0, "the place is given back");
            count == 1
        })
    };
    assert!((0..100).any(|_| is_counted()));
}

#[test]
fn too_many_valid_requests_get_status_503_and_later_ones_are_answered() {
    let server = server();
    let address = server.address().expect("it listens");
    std::thread::spawn(move || server.serve(answer));
    // The request of each client is valid, but its body does not come. A connection may be closed for a newer one
    // before its request is read, so a few more clients than places may be needed.
    let post = "POST /echo HTTP/1.1\r\nHost: localhost\r\nContent-Length: 9\r\n\r\n";
    let mut valid = Vec::new();
    while !answer_to(address, &get("/data/a")).starts_with("HTTP/1.1 503") {
        let mut stream = TcpStream::connect(address).expect("it listens");
        stream.write_all(post.as_bytes()).expect("it reads");
        valid.push(stream);
        assert!(valid.len() < 1000, "none is refused");
    }
    assert!(valid.len() >= MAX_CONNECTIONS - 1, "{} are enough", valid.len());
    drop(valid);
    until(address, "HTTP/1.1 200");
}

#[cfg(unix)]
#[test]
fn a_lack_of_file_descriptors_may_pass_and_a_closed_socket_may_not() {
    use nix::errno::Errno;

    for errno in [Errno::EMFILE, Errno::ENFILE, Errno::ENOMEM, Errno::ECONNABORTED, Errno::EINTR] {
        assert!(may_pass(&io::Error::from_raw_os_error(errno as i32)), "{errno}");
    }
    assert!(!may_pass(&io::Error::from_raw_os_error(Errno::EBADF as i32)));
}
