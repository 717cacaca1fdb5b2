//! Tests with clients that are too slow. The server of these tests has shorter time limits, but the code of the
//! program.

use super::*;

/// Number of bytes that no buffer of the system can hold.
pub const LARGE: usize = 64 << 20;

fn server_with([request, answer]: [Duration; 2]) -> Server {
    let patience = Patience { request, answer, rate: usize::MAX };
    Server { patience, ..Server::new(0).expect("a port is free") }
}

#[test]
fn a_request_that_trickles_in_for_too_long_gets_no_answer_and_one_in_time_does() {
    let [short, long] = [50, 60_000].map(Duration::from_millis);
    let server = server_with([short, long]);
    let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
    let stream = accept(&server);
    // Each byte comes in time, but the request never ends.
    let trickle = std::thread::spawn(move || {
        client.write_all(b"GET / HTTP/1.1\r\nHost: localhost\r\nA: ").expect("it reads");
        while client.write_all(b"x").is_ok() {
            std::thread::sleep(Duration::from_millis(5));
        }
    });
    let error = talk(&server, &stream).expect_err("it waits no longer");
    assert!(matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock), "{error}");
    stream.shutdown(Shutdown::Both).expect("it is open");
    trickle.join().expect("it ends when the connection does");

    let server = server_with([long, long]);
    let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
    let stream = accept(&server);
    client.write_all(get("/data/a").as_bytes()).expect("it reads");
    talk(&server, &stream).expect("it has time enough");
}

#[test]
fn an_answer_that_the_client_does_not_read_is_given_up() {
    let [short, long] = [50, 60_000].map(Duration::from_millis);
    let server = server_with([long, short]);
    let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
    let stream = accept(&server);
    client.write_all(get("/large").as_bytes()).expect("it reads");
    let error = talk(&server, &stream).expect_err("the client reads nothing");
    assert!(matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock), "{error}");
}

#[test]
fn an_answer_that_the_client_reads_too_slowly_is_given_up() {
    let short = Duration::from_millis(50);
    let slowly = |rate: usize| {
        let patience = Patience { request: Duration::from_secs(60), answer: short, rate };
        let server = Server { patience, ..Server::new(0).expect("a port is free") };
        let mut client = TcpStream::connect(server.address().expect("it listens")).expect("it listens");
        let stream = accept(&server);
        client.write_all(get("/large").as_bytes()).expect("it reads");
        // The client never stops reading, so each write of the server has some success.
        let reader = std::thread::spawn(move || {
            let mut bytes = vec![0; 1 << 16];
            let mut sum = 0;
            while let Ok(length @ 1..) = client.read(&mut bytes) {
                sum += length;
                std::thread::sleep(Duration::from_millis(1));
            }
            sum
        });
        let result = talk(&server, &stream);
        drop(stream);
        assert_eq!(server.budget.taken(), 0, "the bytes are given back");
        (result.is_ok(), reader.join().expect("it does not panic") >= LARGE)
    };
    assert_eq!(slowly(usize::MAX), (false, false));
    assert_eq!(slowly(1 << 20), (true, true), "64 s are enough");
}
