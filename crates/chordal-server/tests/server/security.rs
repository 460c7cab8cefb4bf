//! Requests without the secret address or from elsewhere get nothing.

use crate::common::{PageMessage, Shown, Site, serve};
use tungstenite::Message;

const PROGRAM: &str = "G21\nG1 X10 F100\nM30\n";

fn site() -> Site {
    serve(Shown::text(PROGRAM))
}

#[test]
fn the_page_and_its_files_are_served_to_who_knows_the_address() {
    let site = site();
    let token = &site.token;
    for (file, kind) in [
        ("", "text/html"),
        ("app.js", "text/javascript"),
        ("app.css", "text/css"),
        ("icon.svg", "image/svg+xml"),
    ] {
        let (status, head, body) = site.get(&format!("/{token}/{file}"));
        assert_eq!(status, 200, "{file}");
        assert!(head.contains(&format!("content-type: {kind}")), "{head}");
        assert!(!body.is_empty());
        for header in [
            "x-content-type-options: nosniff",
            "referrer-policy: no-referrer",
            "cache-control: no-store",
            "cross-origin-resource-policy: same-origin",
        ] {
            assert!(head.contains(header), "{file}: {header}");
        }
    }
}

#[test]
fn the_page_may_load_nothing_from_other_servers() {
    let site = site();
    let (_, head, body) = site.get(&format!("/{}/", site.token));
    let policy = head.lines().find(|line| line.starts_with("content-security-policy")).unwrap();
    assert!(policy.contains("default-src 'none'") && policy.contains("script-src 'self'"));
    assert!(!policy.contains("unsafe") && !policy.contains('*') && !policy.contains("http"));
    // Styles of the editor have the nonce of this answer; the next answer has another one.
    let body = String::from_utf8(body).unwrap();
    let nonce = policy.split("'nonce-").nth(1).unwrap().split('\'').next().unwrap();
    assert!(body.contains(nonce));
    let (_, again, _) = site.get(&format!("/{}/", site.token));
    assert!(!again.contains(nonce));
}

#[test]
fn without_the_token_there_is_nothing() {
    let site = site();
    let short = &site.token[..40];
    let longer = format!("{}0", site.token);
    for path in [
        "/",
        "/app.js",
        "/live",
        "//",
        "/x/app.js",
        &format!("/{short}/app.js"),
        &format!("/{longer}/"),
    ] {
        let (status, _, body) = site.get(path);
        assert_eq!((status, body.len()), (404, 0), "{path}");
    }
    assert_eq!(site.connect("/x/live", &[]).err(), Some(404));
    assert_eq!(site.connect("/live", &[]).err(), Some(404));
}

#[test]
fn another_host_or_origin_is_refused_even_with_the_token() {
    let site = site();
    let (token, port) = (&site.token, site.port);
    let first = format!("GET /{token}/app.js HTTP/1.1");
    let own = format!("Host: 127.0.0.1:{port}");
    for lines in [
        vec!["Host: evil.example".to_string()],
        vec![format!("Host: evil.example:{port}")],
        vec!["Host: 127.0.0.1".to_string()],
        vec![format!("Host: 127.0.0.1:{port}.evil.example")],
        vec![own.clone(), "Origin: http://evil.example".into()],
        vec![own.clone(), "Origin: null".into()],
        vec![own.clone(), format!("Origin: http://127.0.0.1:{}", port.wrapping_add(1))],
    ] {
        let (status, _, body) = site.raw(&first, &lines);
        assert_eq!((status, body.len()), (403, 0), "{lines:?}");
    }
    for own in ["127.0.0.1", "localhost"] {
        let lines = [format!("Host: {own}:{port}"), format!("Origin: http://{own}:{port}")];
        assert_eq!(site.raw(&first, &lines).0, 200, "{own}");
    }
    let live = format!("/{token}/live");
    for headers in [
        &[("origin", "http://evil.example")][..],
        &[("origin", "null")],
        &[("host", "evil.example")],
    ] {
        assert_eq!(site.connect(&live, headers).err(), Some(403), "{headers:?}");
    }
    assert!(site.connect(&live, &[("origin", &format!("http://127.0.0.1:{port}"))]).is_ok());
}

#[test]
fn nothing_but_the_page_is_served() {
    let site = site();
    let token = &site.token;
    for path in [
        "../Cargo.toml",
        "..%2fCargo.toml",
        "..%2f..%2f..%2f..%2fetc%2fpasswd",
        "%2e%2e/%2e%2e/etc/passwd",
        "/etc/passwd",
        "....//etc/passwd",
        "app.js/../../src/lib.rs",
        "app.js%00.html",
        "part.nc",
        "index.html",
        "APP.JS",
    ] {
        let (status, _, body) = site.get(&format!("/{token}/{path}"));
        assert!(matches!(status, 404 | 400), "{path}: {status}");
        assert!(body.len() < 100, "{path}");
    }
    for method in ["POST", "PUT", "DELETE", "OPTIONS", "TRACE"] {
        let first = format!("{method} /{token}/app.js HTTP/1.1");
        let (status, ..) = site.raw(&first, &[format!("Host: {}", site.host())]);
        assert!(status >= 400, "{method}: {status}");
    }
}

#[test]
fn malformed_messages_are_told_and_the_connection_goes_on() {
    let site = site();
    let mut live = site.live();
    live.json("report");
    for text in [
        "",
        "no json",
        "{}",
        "[1,2]",
        r#"{"request":"format_disk"}"#,
        r#"{"request":"edit","changes":[{"from":5,"to":1,"insert":""}]}"#,
        r#"{"request":"edit","changes":[{"from":0,"to":999999999999,"insert":""}]}"#,
        r#"{"request":"edit","changes":"all"}"#,
        r#"{"request":"chords","tolerance_mm":-1}"#,
        r#"{"request":"chords","tolerance_mm":0}"#,
        r#"{"request":"chords","tolerance_mm":1e999}"#,
        r#"{"request":"save"}"#,
        r#"{"request":"compare_with"}"#,
        r#"{"request":"compare_with","other":"named"}"#,
        r#"{"request":"compare_with","other":"/etc/passwd"}"#,
        r#"{"request":"compare_with","other":{"file":"/etc/passwd"}}"#,
        r#"{"request":"tolerance","tolerance_mm":-0.1}"#,
        r#"{"request":"tolerance","tolerance_mm":1e999}"#,
        r#"{"request":"other_text","file":0,"line":1}"#,
        r#"{"request":"other_text","line":-1}"#,
    ] {
        live.send(text);
        let error = live.json("error");
        assert!(error["message"].as_str().is_some_and(|message| !message.is_empty()), "{text}");
    }
    let deep = "[".repeat(200_000);
    live.send(&deep);
    live.json("error");
    live.socket.send(Message::binary(vec![0u8; 100])).unwrap();
    live.json("error");
    live.send(r#"{"id":7,"request":"state","done":1,"line":2}"#);
    assert_eq!(live.json("state")["id"], 7);
}

#[test]
fn a_message_beyond_the_limit_ends_the_connection_and_not_the_server() {
    let site = site();
    let mut live = site.live();
    live.json("report");
    let huge = "x".repeat(33 << 20);
    // The server may close the connection while this is being sent.
    let _ = live.socket.send(Message::text(huge));
    loop {
        match live.next() {
            PageMessage::Closed => break,
            PageMessage::Json(object) => assert_ne!(object["type"], "state"),
            PageMessage::Columns(_) => {}
        }
    }
    site.live().json("report");
}

#[test]
fn more_pages_than_there_is_room_for_are_refused_until_one_goes() {
    let site = site();
    let live = format!("/{}/live", site.token);
    let mut pages: Vec<_> = (0..16).map(|_| site.live()).collect();
    assert_eq!(site.connect(&live, &[]).err(), Some(503));
    pages[0].json("report");
    pages.remove(0).socket.close(None).unwrap();
    let patience = std::time::Instant::now();
    while site.connect(&live, &[]).is_err() {
        assert!(patience.elapsed().as_secs() < 30, "a page that has gone makes room");
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
}
