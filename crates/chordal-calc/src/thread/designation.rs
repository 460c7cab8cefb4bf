//! What a thread's name says.

use super::class::FitClass;
use super::pipe_sizes::PipeSize;
use super::{ThreadHand, ThreadSize};
use crate::error::CalcError;
use crate::numbers::AnswerUnit;

/// What kind of thread a name means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThreadForm {
    /// 60°, inches (ASME B1.1).
    Unified,
    /// 60°, millimetres (ISO 68-1).
    Metric,
    /// 60°, taper 1:16 (ASME B1.20.1).
    Npt,
    /// The same, sealed by its crests and roots (ASME B1.20.3).
    Nptf,
    /// 55°, parallel pipe thread (ISO 228-1), BSPP.
    G,
    /// 55°, taper 1:16 (ISO 7-1), BSPT.
    R,
}

/// What a thread's name says: `M30x2-6g`, `1 1/16-28 UN-2A LH`, `G 1/2`.
#[derive(Clone, Debug, PartialEq)]
pub struct ThreadDesignation {
    /// Nominal diameter, mm; outside diameter of the pipe for NPT.
    pub major: f64,
    /// Pitch, mm.
    pub pitch: f64,
    /// The unit it is named in.
    pub units: AnswerUnit,
    /// Its profile and taper.
    pub form: ThreadForm,
    /// The classes of fit in the name: none, one, or one outside and one inside.
    pub classes: Vec<FitClass>,
    /// LH or RH, where the name says it.
    pub hand: Option<ThreadHand>,
    /// What to know about the name: another series, or a number that was left out.
    pub notes: Vec<String>,
    pub(super) pipe: Option<&'static PipeSize>,
}

impl ThreadDesignation {
    /// The thread with so many starts, for what needs the 60° profile.
    ///
    /// # Errors
    /// When it is a pipe thread.
    pub fn thread(&self, starts: u32) -> Result<ThreadSize, CalcError> {
        let ThreadDesignation { major, pitch, .. } = *self;
        match self.form {
            ThreadForm::Unified | ThreadForm::Metric => Ok(ThreadSize { major, pitch, starts }),
            ThreadForm::G => Err(CalcError::new(
                "a G thread has the 55° profile; programs are written for 60° threads",
                "calc thread gives its sizes",
            )),
            ThreadForm::Npt | ThreadForm::Nptf | ThreadForm::R => Err(CalcError::new(
                "a pipe thread with a taper of 1:16 needs a path that becomes wider with every turn; \
                 programs are written for parallel threads",
                "calc thread gives its sizes",
            )),
        }
    }

    pub(super) fn new(
        major: f64,
        pitch: f64,
        units: AnswerUnit,
        form: ThreadForm,
    ) -> ThreadDesignation {
        ThreadDesignation {
            major,
            pitch,
            units,
            form,
            classes: Vec::new(),
            hand: None,
            notes: Vec::new(),
            pipe: None,
        }
    }

    /// Takes LH or RH; true when the word was one.
    pub(super) fn take_hand(&mut self, word: &str) -> Result<bool, CalcError> {
        let own = match word.to_ascii_uppercase().as_str() {
            "LH" | "LEFT" => ThreadHand::Left,
            "RH" | "RIGHT" => ThreadHand::Right,
            "HAND" if self.hand.is_some() => return Ok(true),
            _ => return Ok(false),
        };
        if self.hand.is_some_and(|other| other != own) {
            return Err(CalcError::new(
                "a thread cannot be both left and right hand",
                "give one of LH and RH",
            ));
        }
        self.hand = Some(own);
        Ok(true)
    }
}

/// What is said of a name that is none.
pub(super) fn no_thread(text: &str) -> CalcError {
    CalcError::new(
        format!("`{text}` is not a thread"),
        "write it like M30x2, 1.5-8, 1 1/16-28, #10-24, 1/2 NPT or G 1/2; inch threads need the threads \
         per inch",
    )
}
