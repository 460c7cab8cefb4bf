//! Custom M codes and programs: the call that a run passes to its caller, and the possible answers.

use chordal_command::{AxisMask, Position, Units};
use std::collections::{HashMap, HashSet};
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use chordal_diagnostics::Span;

/// Answers codes and programs that neither the control nor the texts of a job define.
///
/// It is called for an M code that the control's table does not contain or does not carry out, and for a call
/// (`G65 P9010`, `M98 P9010`, a code that a setting makes a call) of a program that no text contains. A job runs
/// its program several times, so the same call must always get the same answer; wrap an implementation that
/// cannot guarantee this in [`ShopRecord`].
///
/// A closure implements it:
///
/// ```
/// use chordal_kernel::{ShopAnswer, ShopCall, CustomCode, ShopCodes};
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

/// A custom code or program.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord)]
pub enum CustomCode {
    /// An M code, ten times its number: M120 is 1200.
    M(u16),
    /// A called program that no text contains.
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

/// A custom code in its block, and the state of the control before the block moves.
#[derive(Clone, Copy, Debug)]
pub struct ShopCall<'a> {
    /// The code.
    pub code: CustomCode,
    /// The index of the running main program among the programs of the job.
    pub main: usize,
    /// Number of custom codes of this run before this one.
    pub nth: u32,
    /// The block.
    pub block: Span,
    /// The name of its file.
    pub file: &'a str,
    /// Its line, from 1.
    pub line: u32,
    /// Its text.
    pub text: &'a str,
    /// Its words with the numbers as written, without N; empty when they are arguments.
    pub words: &'a [(char, f64)],
    /// The local variables that a macro call sets, by number.
    pub arguments: &'a [(u32, f64)],
    /// The tool in the spindle.
    pub tool: u32,
    /// The tool tip, program coordinates, mm and rad.
    pub position: Position,
    /// The axes whose position is known.
    pub known: AxisMask,
    /// Units of the program.
    pub units: Units,
    /// G91 is active.
    pub incremental: bool,
    /// Speed of the spindle, rev/min; 0 when it is stopped.
    pub spindle_rpm: f64,
}

/// What a machine does for a custom code or program.
#[derive(Clone, PartialEq, Debug)]
pub enum ShopAnswer {
    /// The code is not known here: the control reports it as usual.
    NotMine,
    /// It takes time and moves nothing.
    Wait {
        /// Its time, s; not negative.
        seconds: f64,
        /// The reason; `None` for the name of the code.
        label: Option<Arc<str>>,
    },
    /// It runs these NC blocks as a subprogram; their end is a return.
    Text(Arc<str>),
    /// It is refused, for this reason.
    Refused(String),
}

impl ShopAnswer {
    /// A time, s, and its reason.
    pub fn wait(seconds: f64, label: &str) -> ShopAnswer {
        ShopAnswer::Wait { seconds, label: Some(Arc::from(label)) }
    }

    /// NC blocks to run as a subprogram.
    pub fn text(text: &str) -> ShopAnswer {
        ShopAnswer::Text(Arc::from(text))
    }
}

/// Passes on each call once and repeats the answer in every later run.
///
/// A call is identified by its main program and its number among the calls of the run. This is sufficient: after
/// the same answers, a run makes the same calls.
pub struct ShopRecord {
    inner: Arc<dyn ShopCodes>,
    known: Mutex<CachedAnswers>,
}

#[derive(Default)]
struct CachedAnswers {
    answers: HashMap<(usize, u32), ShopAnswer>,
    /// Equal texts are stored once.
    texts: HashSet<Arc<str>>,
}

impl ShopRecord {
    /// An empty record in front of `inner`.
    pub fn new(inner: Arc<dyn ShopCodes>) -> ShopRecord {
        ShopRecord { inner, known: Mutex::default() }
    }

    fn known(&self, call: &ShopCall<'_>) -> Option<ShopAnswer> {
        let known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        known.answers.get(&(call.main, call.nth)).cloned()
    }

    /// Stores an answer; of two answers to the same call the first counts.
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
        // The lock is released during the call, which may take long.
        self.known(call).unwrap_or_else(|| {
            let answer = self.inner.answer(call);
            self.note(call, answer)
        })
    }
}
