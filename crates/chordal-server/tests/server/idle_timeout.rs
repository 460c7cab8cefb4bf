//! Idle connections are closed; the connection of an open page stays.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use chordal_server::PageServer;

use crate::common::{PageMessage, Shown, Site, serve_by};

const IDLE: Duration = Duration::from_millis(400);

fn site() -> Site {
    let shown = Shown::text("G21 G90\nG0 X1.\nM30\n");
    serve_by(PageServer::listen(0).unwrap().closing_after(IDLE), shown)
}

#[test]
fn whoever_says_nothing_or_half_a_request_is_closed() {
    let site = site();
    for received in ["", "GET / HTTP/1.1\r\nHost: ", "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"] {
        let mut socket = TcpStream::connect(("127.0.0.1", site.port)).unwrap();
        socket.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        socket.write_all(received.as_bytes()).unwrap();
        // The server closes it, not the timeout of this test.
        let mut all = Vec::new();
        let ended = socket.read_to_end(&mut all);
        assert!(ended.is_ok(), "{received:?}: the connection is still open");
    }
}

#[test]
fn a_page_that_is_there_stays() {
    let site = site();
    let mut live = site.live();
    live.json("times");
    let begun = Instant::now();
    // Reading answers the pings of the server.
    live.socket.get_ref().set_read_timeout(Some(IDLE / 10)).unwrap();
    while begun.elapsed() < 5 * IDLE {
        let _ = live.socket.read();
    }
    live.socket.get_ref().set_read_timeout(Some(Duration::from_secs(30))).unwrap();
    live.send(r#"{ "id": 3, "request": "outline" }"#);
    assert_eq!(live.json("outline")["id"], 3);
}

#[test]
fn a_page_that_does_not_answer_makes_room() {
    let site = site();
    let lost: Vec<_> = (0..16).map(|_| site.live()).collect();
    let begun = Instant::now();
    let mut live = loop {
        match site.connect(&format!("/{}/live", site.token), &[]) {
            Ok(live) => break live,
            Err(status) => assert_eq!(status, 503),
        }
        assert!(begun.elapsed() < Duration::from_secs(30), "no place was given back");
        std::thread::sleep(IDLE / 4);
    };
    assert!(matches!(live.next(), PageMessage::Json(_)));
    drop(lost);
}
