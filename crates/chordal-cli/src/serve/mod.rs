//! `chordal serve`: questions and answers as lines of JSON, for senders and other programs.
//!
//! One thread reads lines, this one answers them in their order. A question that is asked about a file can be
//! repeated whenever the file changes.

mod lines;
mod message;
mod stamp;
mod watching;

use std::collections::VecDeque;
use std::io::{self, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use chordal_ask::{QuestionFailure as Unanswered, inline};
use serde_json::{Value, json};

use crate::failure::{CommandFailure, ExitVerdict};
use message::{PendingQuestion, ServeMessage};
use watching::WatchList;

const EXAMPLES: &str = "\
Each line of standard input is a question, a JSON object; each line of standard output is an answer:

  {\"id\":1,\"ask\":\"check\",\"program\":{\"file\":\"part.nc\",\"machine\":\"haas-vf2\"}}
  {\"id\":2,\"ask\":\"time\",\"program\":{\"file\":\"part.nc\"},\"watch\":true}
  {\"id\":3,\"ask\":\"path\",\"program\":{\"text\":\"G21 G0 X10.\"}}
  {\"cancel\":2}

docs/serve.md describes them. It ends with the end of its input.";

/// Answers other programs: questions and answers as lines of JSON
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Speaks over standard input and output
    #[arg(long, required = true)]
    stdio: bool,
}

/// Name and version of the protocol.
const PROTOCOL: &str = "chordal.serve/1";

/// How often the files of watched questions are looked at.
const POLL_INTERVAL: Duration = Duration::from_millis(100);

pub fn run(args: &Args) -> Result<ExitVerdict, CommandFailure> {
    let Args { stdio: _ } = args;
    let (send, lines) = channel();
    std::thread::spawn(move || {
        lines::read(&mut io::stdin().lock(), |line| send.send(line).is_ok())
    });
    // Standard output belongs to the answers: the words of a panic go to standard error, as always.
    let mut serving =
        ServeSession { lines, waiting: VecDeque::new(), watching: WatchList::default() };
    serving.send(&json!({ "protocol": PROTOCOL, "version": env!("CARGO_PKG_VERSION") }))?;
    serving.until_the_end()?;
    Ok(ExitVerdict::Clean)
}

struct ServeSession {
    lines: Receiver<lines::InputLine>,
    waiting: VecDeque<PendingQuestion>,
    watching: WatchList,
}

impl ServeSession {
    fn until_the_end(&mut self) -> Result<(), CommandFailure> {
        loop {
            let is_open = self.take_lines()?;
            if let Some(question) = self.waiting.pop_front().or_else(|| self.watching.changed()) {
                self.answer(question)?;
            } else if !is_open {
                return Ok(());
            }
        }
    }

    /// Takes what was asked in the meantime; waits for it where there is nothing to do. False when
    /// no more can come.
    fn take_lines(&mut self) -> Result<bool, CommandFailure> {
        let wait = match (self.waiting.is_empty(), self.watching.is_empty()) {
            (false, _) => Duration::ZERO,
            (true, false) => POLL_INTERVAL,
            (true, true) => Duration::MAX,
        };
        let mut next = self.lines.recv_timeout(wait);
        loop {
            match next {
                Ok(line) => self.take(line)?,
                Err(RecvTimeoutError::Timeout) => return Ok(true),
                Err(RecvTimeoutError::Disconnected) => return Ok(false),
            }
            next = self.lines.recv_timeout(Duration::ZERO);
        }
    }

    fn take(&mut self, line: lines::InputLine) -> Result<(), CommandFailure> {
        let line = match line {
            Ok(line) => line,
            Err(rejected) => return self.send(&json!({ "id": null, "error": rejected.json() })),
        };
        match ServeMessage::read(&line) {
            Ok(ServeMessage::Ask(question)) => self.waiting.push_back(*question),
            Ok(ServeMessage::Cancel(id)) => {
                let before = self.waiting.len();
                self.waiting.retain(|question| question.id != id);
                let was_known = self.watching.forget(&id) || self.waiting.len() < before;
                self.send(&json!({ "id": id, "cancelled": was_known }))?;
            }
            Err(refused) => {
                self.send(&json!({ "id": refused.id, "error": refused.failure.json() }))?;
            }
        }
        Ok(())
    }

    fn answer(&mut self, question: PendingQuestion) -> Result<(), CommandFailure> {
        let mut reported = json!({ "id": question.id, "ask": question.ask });
        if question.times > 0 {
            reported["again"] = json!(question.times);
        }
        // What the file holds when it is read: what it becomes in the meantime is a change.
        let stamps = question.stamps();
        match answer(&question) {
            Ok(answer) => reported["answer"] = answer,
            Err(failure) => reported["error"] = failure.json(),
        }
        if question.is_watched {
            self.watching.keep(question, stamps);
        }
        self.send(&reported)
    }

    fn send(&self, message: &Value) -> Result<(), CommandFailure> {
        let mut out = io::stdout().lock();
        let written = writeln!(out, "{message}").and_then(|()| out.flush());
        written.map_err(|error| CommandFailure::write("standard output", &error))
    }
}

/// A panic ends the answer, not the service.
fn answer(question: &PendingQuestion) -> Result<Value, Unanswered> {
    let answered = || question.request().and_then(chordal_ask::answer).map(inline);
    catch_unwind(AssertUnwindSafe(answered)).unwrap_or_else(|payload| {
        let text = payload.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("a panic");
        Err(Unanswered::own(format!("Chordal itself failed on it: {text}")))
    })
}
