//! The page of `chordal view` without a server: its session as WebAssembly, in workers of the browser.
//!
//! The page sends a worker the requests that it would send a server, and gets the same answers and columns. A worker
//! has one [`chordal_view::ProgramView`]; the files are those that the page has opened (`opened_files`), and what JavaScript calls is in
//! `interface`. A panic ends the module, not the page: its worker is started again.

mod interface;
mod open_message;
mod opened_files;
