//! Codes that a shop has of its own: what is asked when one is met, and what may be answered.

use chordal_command::{AxisMask, Position, Units};
use std::collections::{HashMap, HashSet};
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use chordal_diagnostics::Span;

/// Knows codes and programs that neither the control nor the texts of a job have.
///
/// It is asked where an M code is met that the control's table does not have or does not carry out,
/// and where a program is called (`G65 P9010`, `M98 P9010`, a code that a setting makes a call) that
/// no text holds. Every question of a job runs its program anew, so the same call must be answered the
/// same way each time; [`ShopRecord`] sees to that for one that cannot promise it.
///
/// A closure is one:
///
/// ```
/// use chordal_gcode::{ShopAnswer, ShopCall, CustomCode, ShopCodes};
///
/// let shop = |call: &ShopCall<'_>| match call.code {
///     CustomCode::M(1200) => ShopAnswer::wait(2.5, "part flip"),
///     CustomCode::Program(9010) => ShopAnswer::text("G91 G28 Z0.\nG90"),
///     _ => ShopAnswer::NotMine,
/// };
/// let _: &dyn ShopCodes = &shop;
/// ```
pub trait ShopCodes: Send + Sync {
    /// What the machine does for a code.
    fn answer(&self, call: &ShopCall<'_>) -> ShopAnswer;
}

impl<F: Fn(&ShopCall<'_>) -> ShopAnswer + Send + Sync> ShopCodes for F {
    fn answer(&self, call: &ShopCall<'_>) -> ShopAnswer {
        self(call)
    }
}

/// What was met.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum CustomCode {
    /// An M code, ten times its number: M120 is 1200.
    M(u16),
    /// A called program that is not there.
    Program(u32),
}

impl fmt::Display for CustomCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            CustomCode::M(tenths) if tenths.is_multiple_of(10) => write!(f, "M{}", tenths / 10),
            CustomCode::M(tenths) => write!(f, "M{}.{}", tenths / 10, tenths % 10),
            CustomCode::Program(number) => write!(f, "O{number}"),
        }
    }
}

/// A code where it was met, and how the control stands before its block moves.
#[derive(Clone, Copy, Debug)]
pub struct ShopCall<'a> {
    /// The code.
    pub code: CustomCode,
    /// Which main program runs, by its place among the programs of the job.
    pub main: usize,
    /// How many calls of this run were asked about before.
    pub nth: u32,
    /// The block.
    pub block: Span,
    /// The name of its file.
    pub file: &'a str,
    /// Its line, from 1.
    pub line: u32,
    /// Its text.
    pub text: &'a str,
    /// Its words with the numbers as written, N left out; empty where they are arguments.
    pub words: &'a [(char, f64)],
    /// The local variables that a macro call sets, by number.
    pub arguments: &'a [(u32, f64)],
    /// The tool in the spindle.
    pub tool: u32,
    /// Where the tool tip is, program coordinates, mm and rad.
    pub position: Position,
    /// The axes of which that is known.
    pub known: AxisMask,
    /// Units of the program.
    pub units: Units,
    /// G91 is in force.
    pub incremental: bool,
    /// Speed of the spindle where it turns, rev/min; else 0.
    pub spindle_rpm: f64,
}

/// What a machine does for a code of the shop's own.
#[derive(Clone, PartialEq, Debug)]
pub enum ShopAnswer {
    /// Nobody knows the code: what the control says stands.
    NotMine,
    /// It takes a time.
    Wait {
        /// For how long; not below zero.
        seconds: f64,
        /// For what; `None`: the code's own name.
        label: Option<Arc<str>>,
    },
    /// It does what these blocks say, run as a subprogram. Their end is a return.
    Text(Arc<str>),
    /// It refuses, and says why.
    Refused(String),
}

impl ShopAnswer {
    /// A time in seconds, and for what.
    pub fn wait(seconds: f64, label: &str) -> ShopAnswer {
        ShopAnswer::Wait { seconds, label: Some(Arc::from(label)) }
    }

    /// NC blocks.
    pub fn text(text: &str) -> ShopAnswer {
        ShopAnswer::Text(Arc::from(text))
    }
}

/// Asks about each call once and gives the same answer in every later run.
///
/// A call is known by its main program and its number among the calls of the run. That is enough:
/// with the same answers before it a run comes to the same calls.
pub struct ShopRecord {
    inner: Arc<dyn ShopCodes>,
    known: Mutex<CachedAnswers>,
}

#[derive(Default)]
struct CachedAnswers {
    answers: HashMap<(usize, u32), ShopAnswer>,
    /// A text that is answered again and again is kept once.
    texts: HashSet<Arc<str>>,
}

impl ShopRecord {
    /// A record in which nothing stands yet, and who is asked.
    pub fn new(inner: Arc<dyn ShopCodes>) -> ShopRecord {
        ShopRecord { inner, known: Mutex::default() }
    }

    fn known(&self, call: &ShopCall<'_>) -> Option<ShopAnswer> {
        let known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        known.answers.get(&(call.main, call.nth)).cloned()
    }

    /// Notes an answer; of two for the same call the first counts.
    fn note(&self, call: &ShopCall<'_>, answer: ShopAnswer) -> ShopAnswer {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let answer = match answer {
            ShopAnswer::Text(text) => {
                let kept = known.texts.get(&text).cloned().unwrap_or(text);
                known.texts.insert(kept.clone());
                ShopAnswer::Text(kept)
            }
            other => other,
        };
        known.answers.entry((call.main, call.nth)).or_insert(answer).clone()
    }
}

impl ShopCodes for ShopRecord {
    fn answer(&self, call: &ShopCall<'_>) -> ShopAnswer {
        // The lock is not held while the shop is asked, which may take long.
        self.known(call).unwrap_or_else(|| {
            let answer = self.inner.answer(call);
            self.note(call, answer)
        })
    }
}
