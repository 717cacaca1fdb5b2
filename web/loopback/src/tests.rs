//! Tests of the server with clients over real connections.

use std::io::Read;

use super::*;

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
    let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
    client.write_all(request.as_bytes()).expect("it reads");
    let (stream, _) = server.listener.accept().expect("there is a connection");
    // The result is an error for a refused client, because this client keeps its end of the connection open.
    let _ = server.talk(&stream, answer);
    drop(stream);
    let mut answer = String::new();
    client.read_to_string(&mut answer).expect("it answers in text");
    answer
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
fn a_body_reaches_the_owner() {
    assert!(asked("POST /echo HTTP/1.1\r\nHost: localhost:8\r\nContent-Length: 3\r\n\r\nabc").ends_with("\r\n\r\nabc"));
}

#[test]
fn a_foreign_name_for_this_server_gets_nothing() {
    let answer = asked("GET /data/a HTTP/1.1\r\nHost: evil.example\r\n\r\n");
    assert!(answer.starts_with("HTTP/1.1 403") && !answer.contains("numbers"), "{answer}");
}

#[test]
fn bodies_share_one_limit_and_give_it_back() {
    let counter = AtomicUsize::new(0);
    let first = Share::take(&counter, 3, 5);
    assert!(first.is_some() && Share::take(&counter, 3, 5).is_none() && Share::take(&counter, usize::MAX, 5).is_none());
    assert!(Share::take(&counter, 2, 5).is_some(), "exactly the limit");
    drop(first);
    assert!(Share::take(&counter, 5, 5).is_some());
}

#[test]
fn all_bodies_together_have_a_limit_until_one_of_them_has_been_received() {
    let server = server();
    let post = |length: usize, body: &str| {
        format!("POST /echo HTTP/1.1\r\nHost: localhost\r\nContent-Length: {length}\r\n\r\n{body}")
    };
    let mut first = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
    // This client announces all bytes but one, and sends none of them.
    first.write_all(post(request::MAX_BODY - 1, "").as_bytes()).expect("it reads");
    let (stream, _) = server.listener.accept().expect("there is a connection");
    std::thread::scope(|scope| {
        let talk = scope.spawn(|| server.talk(&stream, answer));
        while server.bodies.load(Ordering::SeqCst) == 0 {
            std::thread::sleep(Duration::from_millis(1));
        }
        assert!(asked_of(&server, &post(2, "ab")).starts_with("HTTP/1.1 503"));
        assert!(asked_of(&server, &post(1, "a")).starts_with("HTTP/1.1 200"), "exactly the limit");
        drop(first);
        assert!(talk.join().expect("it does not panic").is_err(), "the body has not come");
        assert!(asked_of(&server, &post(2, "ab")).starts_with("HTTP/1.1 200"));
    });
}

#[test]
fn one_connection_too_many_gets_status_503_and_later_ones_are_answered() {
    let server = server();
    let address = server.address().expect("it listens");
    std::thread::spawn(move || server.serve(answer));
    // Each client opens a connection and sends nothing.
    let silent: Vec<_> = (0..MAX_CONNECTIONS).map(|_| TcpStream::connect(address).expect("it listens")).collect();
    let until = |wanted: &str| {
        for _ in 0..1000 {
            let answer = answer_to(address, &get("/data/a"));
            if answer.starts_with(wanted) {
                return;
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        panic!("no answer starts with {wanted}");
    };
    until("HTTP/1.1 503");
    drop(silent);
    until("HTTP/1.1 200");
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
