//! What the page of `chordal view` is answered, wherever it runs: next to a server or in a browser alone.
//!
//! A [`View`] holds the text of one page and its machine. It takes the requests of the page and gives answers
//! and columns to an [`Outbox`]. What takes long is [`Work`]: whoever holds the view decides on what thread, or in what
//! worker, [`View::work`] does it. Nothing here starts a thread, reads a clock, a file or a socket.
//!
//! One file per concern: `request` says what a page may ask and `outbox` takes what goes to it;
//! `document` is the text as it is edited; `run` and `times` make columns of a path and of its time,
//! `stream` and `frame` pack them, `other` compares it with another program, `stock` and `turned` cut
//! the stock with it, `words` asks what an editor asks; `reading`
//! says as what a program may be read; `failed` what is told where Chordal itself failed; `handed` is a view that works for another one.

#![forbid(unsafe_code)]

mod answer;
mod chords;
mod columns;
mod content;
mod document;
mod engagement;
mod failed;
mod frame;
mod handed;
mod modal;
mod open;
mod other;
mod outbox;
mod program;
mod reading;
mod request;
mod run;
mod stock;
mod stream;
mod times;
mod turned;
mod view;
mod wanted;
mod words;

pub use content::Content;
pub use handed::Handed;
pub use open::{open, refusal};
pub use outbox::{Outbox, Port};
pub use program::{Against, MachineChoice, Programs, Refusal, builtin_machines};
pub use reading::ChosenMachine;
pub use request::Request;
pub use view::{View, Work};
