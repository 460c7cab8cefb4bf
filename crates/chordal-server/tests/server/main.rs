//! The server as a page and as strangers meet it.

#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "speaks to a server")]
#![allow(missing_docs, reason = "tests")]

mod against;
mod common;
mod failures;
mod idle;
mod live;
mod security;
mod stock;
mod turned;
