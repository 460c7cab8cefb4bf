//! Answers the requests of the page of `chordal view`, with a server or entirely in a browser.
//!
//! A [`ProgramView`] holds the text of one page and its machine. It takes the requests of the page and sends answers
//! and columns to a [`PageOutbox`]. Long work is a [`WorkItem`]: the owner of the view decides on which thread or in
//! which worker [`ProgramView::work`] executes it. Nothing here starts a thread, or reads a clock, a file or a
//! socket.
//!
//! The files: `request` has the requests of a page and `outbox` sends messages to it; `document` is the edited text;
//! `run` and `times` make columns of a path and of its timing, `stream` and `frame` pack them; `comparison` compares
//! the program with another one; `stock` and `turned_stock` cut the stock; `text_answers` answers questions about the
//! words of the text; `reading` lists the controls that the program may be for; `failure` reports panics;
//! `work_order` lets a view work for another one.

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
mod machine_bodies;
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
