//! The server as seen by a page and by other clients.

#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "speaks to a server")]
#![allow(missing_docs, reason = "tests")]

mod common;
mod comparison;
mod failures;
mod idle_timeout;
mod page_connection;
mod security;
mod stock;
mod turned_stock;
