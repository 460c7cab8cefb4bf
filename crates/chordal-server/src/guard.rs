//! Decides which requests are answered: those from this computer, from the page itself, with the secret address.
//!
//! Any web site can send requests to loopback, and can make a host name of its own point there (DNS rebinding). So a
//! request must name this server (`Host`), must not come from another page (`Origin`), and must contain the token.
//! Other requests get no content.

use axum::http::header::{HOST, ORIGIN};
use axum::http::{HeaderMap, StatusCode};
use subtle::ConstantTimeEq;

const TOKEN_BYTES: usize = 24;

/// The secret part of the address.
#[derive(Clone, Debug)]
pub struct AccessToken(String);

impl AccessToken {
    /// Creates a token of 192 random bits, in hexadecimal.
    ///
    /// # Errors The system provides no random numbers.
    pub fn random() -> Result<AccessToken, getrandom::Error> {
        let mut bytes = [0; TOKEN_BYTES];
        getrandom::fill(&mut bytes)?;
        Ok(AccessToken(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    /// The token as it is written in the address.
    pub fn text(&self) -> &str {
        &self.0
    }

    /// Whether the candidate is the token. The comparison takes constant time, so that the time does not reveal how
    /// many characters are right.
    pub fn is(&self, candidate: &str) -> bool {
        self.0.as_bytes().ct_eq(candidate.as_bytes()).into()
    }
}

/// The host names under which a browser may address this server.
#[derive(Clone, Debug)]
pub struct AllowedHosts([String; 2]);

impl AllowedHosts {
    /// The host names with this port.
    pub fn of(port: u16) -> AllowedHosts {
        AllowedHosts([format!("127.0.0.1:{port}"), format!("localhost:{port}")])
    }

    /// Refuses a request that names another server or comes from another page.
    ///
    /// # Errors The HTTP status of the refusal.
    pub fn check(&self, headers: &HeaderMap) -> Result<(), StatusCode> {
        let only = |name| {
            let mut values = headers.get_all(name).iter();
            (values.next(), values.next().is_some())
        };
        let (Some(host), false) = only(HOST) else { return Err(StatusCode::FORBIDDEN) };
        if !self.0.iter().any(|own| host.as_bytes().eq_ignore_ascii_case(own.as_bytes())) {
            return Err(StatusCode::FORBIDDEN);
        }
        match only(ORIGIN) {
            (None, _) => Ok(()),
            (Some(origin), false) if self.is_own(origin.as_bytes()) => Ok(()),
            _ => Err(StatusCode::FORBIDDEN),
        }
    }

    fn is_own(&self, origin: &[u8]) -> bool {
        let host = origin.strip_prefix(b"http://");
        host.is_some_and(|host| self.0.iter().any(|own| host == own.as_bytes()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(pairs: &[(&str, &str)]) -> bool {
        let mut headers = HeaderMap::new();
        for (name, value) in pairs {
            let name: axum::http::HeaderName = name.parse().unwrap();
            headers.append(name, value.parse().unwrap());
        }
        AllowedHosts::of(8080).check(&headers).is_ok()
    }

    #[test]
    fn only_our_own_names_and_pages() {
        assert!(check(&[("host", "127.0.0.1:8080")]));
        assert!(check(&[("host", "localhost:8080"), ("origin", "http://localhost:8080")]));
        for headers in [
            &[][..],
            &[("host", "127.0.0.1")],
            &[("host", "127.0.0.1:80")],
            &[("host", "evil.example:8080")],
            &[("host", "127.0.0.1:8080"), ("host", "evil.example")],
            &[("host", "127.0.0.1:8080"), ("origin", "http://evil.example")],
            &[("host", "127.0.0.1:8080"), ("origin", "https://127.0.0.1:8080")],
            &[("host", "127.0.0.1:8080"), ("origin", "null")],
            &[("host", "127.0.0.1:8080"), ("origin", "http://127.0.0.1:8080.evil.example")],
        ] {
            assert!(!check(headers), "{headers:?}");
        }
    }

    #[test]
    fn tokens_are_long_and_differ() {
        let (one, other) = (AccessToken::random().unwrap(), AccessToken::random().unwrap());
        assert_eq!(one.text().len(), 48);
        assert_ne!(one.text(), other.text());
        assert!(one.is(one.text()) && !one.is(other.text()) && !one.is("") && !one.is(&one.0[1..]));
    }
}
