//! Tests with clients that are too slow. The server of these tests has shorter time limits, but the code of the
//! program.

use super::*;

/// Number of bytes that no buffer of the system can hold.
pub const LARGE: usize = 64 << 20;

fn server_with(patience: [Duration; 2]) -> Server {
    Server { patience, ..Server::new(0).expect("a port is free") }
}

#[test]
fn a_request_that_trickles_in_for_too_long_gets_no_answer_and_one_in_time_does() {
    let [short, long] = [50, 60_000].map(Duration::from_millis);
    let server = server_with([short, long]);
    let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
    let (stream, _) = server.listener.accept().expect("there is a connection");
    // Each byte comes in time, but the request never ends.
    let trickle = std::thread::spawn(move || {
        client.write_all(b"GET / HTTP/1.1\r\nHost: localhost\r\nA: ").expect("it reads");
        while client.write_all(b"x").is_ok() {
            std::thread::sleep(Duration::from_millis(5));
        }
    });
    let error = server.talk(&stream, answer).expect_err("it waits no longer");
    assert!(matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock), "{error}");
    stream.shutdown(Shutdown::Both).expect("it is open");
    trickle.join().expect("it ends when the connection does");

    let server = server_with([long, long]);
    let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
    let (stream, _) = server.listener.accept().expect("there is a connection");
    client.write_all(get("/data/a").as_bytes()).expect("it reads");
    server.talk(&stream, answer).expect("it has time enough");
}

#[test]
fn an_answer_that_the_client_does_not_read_is_given_up() {
    let [short, long] = [50, 60_000].map(Duration::from_millis);
    let server = server_with([long, short]);
    let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
    let (stream, _) = server.listener.accept().expect("there is a connection");
    client.write_all(get("/large").as_bytes()).expect("it reads");
    let error = server.talk(&stream, answer).expect_err("the client reads nothing");
    assert!(matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock), "{error}");
}
