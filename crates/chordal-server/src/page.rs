//! The files of the page, and the HTTP routes.

use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::extract::{Path, Request, State, WebSocketUpgrade};
use axum::http::header::{self, HeaderName};
use axum::http::{HeaderMap, HeaderValue, StatusCode};
use axum::middleware::{self, Next};
use axum::response::{IntoResponse, Response};
use axum::routing::get;
use chordal_view::ProgramSource;
use tokio::sync::Semaphore;

use crate::guard::{AccessToken, AllowedHosts};
use crate::page_connection;

/// The only files that are served, built from `web/`: name, type and content.
const PAGE_FILES: &[(&str, &str, &[u8])] = &[
    ("", "text/html; charset=utf-8", include_bytes!("../page/index.html")),
    ("app.js", "text/javascript; charset=utf-8", include_bytes!("../page/app.js")),
    ("app.css", "text/css; charset=utf-8", include_bytes!("../page/app.css")),
    ("icon.svg", "image/svg+xml", include_bytes!("../page/icon.svg")),
];

/// The most pages that may be open at the same time: each has its own threads.
const MAX_PAGES: usize = 16;

/// The placeholder in the page for the nonce with which its editor may add styles.
const NONCE_PLACEHOLDER: &str = "NONCE-OF-THE-PAGE";

/// The shared state of the routes.
#[derive(Clone)]
pub struct PageSite {
    token: AccessToken,
    hosts: AllowedHosts,
    programs: Arc<dyn ProgramSource>,
    room: Arc<Semaphore>,
    idle: Duration,
}

/// The routes, behind the guard.
pub fn router(
    token: AccessToken,
    port: u16,
    programs: Arc<dyn ProgramSource>,
    idle: Duration,
) -> Router {
    let room = Arc::new(Semaphore::new(MAX_PAGES));
    let site = PageSite { token, hosts: AllowedHosts::of(port), programs, room, idle };
    Router::new()
        .route("/{token}/", get(index))
        .route("/{token}/live", get(connect))
        .route("/{token}/{file}", get(asset))
        .layer(middleware::from_fn_with_state(site.clone(), guard))
        .with_state(site)
}

/// Refuses foreign requests before anything else, and adds the protection headers to every answer.
async fn guard(State(site): State<PageSite>, request: Request, next: Next) -> Response {
    if let Err(status) = site.hosts.check(request.headers()) {
        return status.into_response();
    }
    let candidate = request.uri().path().split('/').nth(1).unwrap_or("");
    if !site.token.is(candidate) {
        return StatusCode::NOT_FOUND.into_response();
    }
    let mut response = next.run(request).await;
    let headers = response.headers_mut();
    for (name, value) in PROTECTION_HEADERS {
        headers.entry(name).or_insert(HeaderValue::from_static(value));
    }
    response
}

const PROTECTION_HEADERS: [(HeaderName, &str); 6] = [
    (header::CONTENT_SECURITY_POLICY, "default-src 'none'; frame-ancestors 'none'"),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    // The address contains the token and must not be sent to other servers.
    (header::REFERRER_POLICY, "no-referrer"),
    (header::CACHE_CONTROL, "no-store"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
];

async fn index() -> Response {
    let Ok(nonce) = AccessToken::random() else {
        return StatusCode::INTERNAL_SERVER_ERROR.into_response();
    };
    let (_, kind, bytes) = PAGE_FILES[0];
    let text = String::from_utf8_lossy(bytes).replace(NONCE_PLACEHOLDER, nonce.text());
    let policy = format!(
        "default-src 'none'; script-src 'self'; connect-src 'self'; img-src 'self' data:; \
         style-src 'self' 'nonce-{}'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
        nonce.text()
    );
    let mut headers = HeaderMap::new();
    headers.insert(header::CONTENT_TYPE, HeaderValue::from_static(kind));
    if let Ok(policy) = HeaderValue::from_str(&policy) {
        headers.insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    (headers, text).into_response()
}

async fn asset(Path((_, name)): Path<(String, String)>) -> Response {
    match PAGE_FILES[1..].iter().find(|(own, ..)| *own == name) {
        Some((_, kind, bytes)) => ([(header::CONTENT_TYPE, *kind)], *bytes).into_response(),
        None => StatusCode::NOT_FOUND.into_response(),
    }
}

async fn connect(State(site): State<PageSite>, upgrade: WebSocketUpgrade) -> Response {
    let Ok(place) = site.room.try_acquire_owned() else {
        return StatusCode::SERVICE_UNAVAILABLE.into_response();
    };
    upgrade
        .max_message_size(page_connection::MAX_MESSAGE_BYTES)
        .max_frame_size(page_connection::MAX_MESSAGE_BYTES)
        .on_upgrade(move |socket| async move {
            page_connection::serve_page(socket, site.programs, site.idle).await;
            drop(place);
        })
}
