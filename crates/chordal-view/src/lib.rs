//! The answers for the page of `chordal view`, wherever it runs: with a server or in a browser alone.
//!
//! A [`ProgramView`] has the text of one page and its machine. It takes the requests of the page and gives answers
//! and columns to a [`PageOutbox`]. What takes long is a [`WorkItem`]: the owner of the view decides on what thread, or in what
//! worker, [`ProgramView::work`] does it. Nothing here starts a thread, reads a clock, a file or a socket.
//!
//! One file per concern: `request` has the requests of a page and `outbox` takes what goes to it;
//! `document` is the text as it is edited; `run` and `times` make columns of a path and of its time,
//! `stream` and `frame` pack them, `comparison` compares it with another program, `stock` and `turned_stock` cut
//! the stock with it, `text_answers` answers about the words of the text; `reading`
//! lists the controls that a program may be for; `failure` reports panics; `work_order` lets a view work for another one.

#![forbid(unsafe_code)]

mod answer;
mod cancel_token;
mod chords;
mod columns;
mod comparison;
mod content_hash;
mod document;
mod engagement;
mod failure;
mod frame;
mod modal;
mod outbox;
mod part_path;
mod program;
mod program_loader;
mod reading;
mod request;
mod run;
mod stock;
mod stream;
mod text_answers;
mod times;
mod turned_stock;
mod view;
mod work_order;

pub use content_hash::ContentHash;
pub use outbox::{PageOutbox, PagePort};
pub use program::{
    ComparedProgram, ListedMachine, ProgramRefusal, ProgramSource, builtin_machines,
};
pub use program_loader::{open_program, refusal};
pub use reading::ChosenMachine;
pub use request::PageRequest;
pub use view::{ProgramView, WorkItem};
pub use work_order::WorkOrder;
