//! Tests with clients that are too slow. The server of these tests has shorter time limits, but the code of the
//! program.

use super::*;

/// Number of bytes that no buffer of the system can hold.
pub const LARGE: usize = 64 << 20;

const SHORT: Duration = Duration::from_millis(50);
const LONG: Duration = Duration::from_secs(60);

fn server_with(request: Duration, answer: Duration, rate: usize) -> Server {
    Server { patience: Patience { request, answer, rate }, ..server() }
}

#[test]
fn a_request_that_trickles_in_for_too_long_gets_no_answer() {
    let server = server_with(SHORT, LONG, usize::MAX);
    let (mut client, stream) = connected(&server, "GET / HTTP/1.1\r\nHost: localhost\r\nA: ");
    // Each byte comes in time, but the request never ends.
    let trickle = std::thread::spawn(move || {
        while client.write_all(b"x").is_ok() {
            std::thread::sleep(Duration::from_millis(5));
        }
    });
    let error = talk(&server, &stream).expect_err("it waits no longer");
    assert!(matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock), "{error}");
    stream.shutdown(Shutdown::Both).expect("it is open");
    trickle.join().expect("it ends when the connection does");
}

#[test]
fn an_answer_that_the_client_does_not_read_is_given_up() {
    let server = server_with(LONG, SHORT, usize::MAX);
    let (_client, stream) = connected(&server, &get("/large"));
    let error = talk(&server, &stream).expect_err("the client reads nothing");
    assert!(matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock), "{error}");
}

#[test]
fn an_answer_that_the_client_reads_too_slowly_is_given_up() {
    let slowly = |rate: usize| {
        let server = server_with(LONG, SHORT, rate);
        let (mut client, stream) = connected(&server, &get("/large"));
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
        (result.is_ok(), reader.join().expect("it does not panic") >= LARGE)
    };
    assert_eq!(slowly(usize::MAX), (false, false));
    assert_eq!(slowly(1 << 20), (true, true), "64 s are enough");
}
