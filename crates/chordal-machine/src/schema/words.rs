//! Fields whose values are words: how a word is set, and how it is written.

use chordal_kinematics::RolloverRule;

use crate::axis::{AXIS_NAMES, Axis};
use crate::control::ControlName;
use crate::machine::{
    Probe, ProbeHit, RapidShape, RotaryTarget, StartingKinematics, TcpFrame, Turret,
};
use crate::setup::{BodyShape, MeshUnit};
use crate::solid::{LinearOrder, MachineSolidShape, SolidLink};
use crate::tool::ToolShape;
use crate::turning::ToolFacing;

/// A field that holds one of the words of its key.
pub(crate) trait WordField {
    /// The word for the value in a file; `None` if the file needs no key.
    fn word(&self) -> Option<&'static str>;

    /// Sets the value to one of the words of the key.
    fn set_word(&mut self, word: &str);

    /// Words that the application has added to those of the key.
    fn registered_words(&self) -> Vec<&'static str> {
        Vec::new()
    }
}

/// The optional fields of enums that have `ALL` and `as_str`.
macro_rules! optional_words {
    ($($kind:ty),*) => {$(
        impl WordField for Option<$kind> {
            fn word(&self) -> Option<&'static str> {
                self.map(<$kind>::as_str)
            }

            fn set_word(&mut self, word: &str) {
                *self = <$kind>::ALL.into_iter().find(|value| value.as_str() == word);
            }
        }
    )*};
}

optional_words!(
    BodyShape,
    LinearOrder,
    MachineSolidShape,
    MeshUnit,
    RapidShape,
    RolloverRule,
    RotaryTarget,
    SolidLink,
    StartingKinematics,
    ToolFacing,
    ToolShape
);

impl WordField for Option<Axis> {
    fn word(&self) -> Option<&'static str> {
        self.map(|axis| AXIS_NAMES[axis as usize])
    }

    fn set_word(&mut self, word: &str) {
        *self = Axis::from_letter(word.as_bytes()[0]);
    }
}

impl WordField for ControlName {
    fn word(&self) -> Option<&'static str> {
        Some(self.as_str())
    }

    fn set_word(&mut self, word: &str) {
        *self = word.parse().unwrap_or(*self);
    }

    fn registered_words(&self) -> Vec<&'static str> {
        let registered = |name: &ControlName| matches!(name, ControlName::Registered(_));
        ControlName::all().into_iter().filter(registered).map(ControlName::as_str).collect()
    }
}

impl WordField for Turret {
    fn word(&self) -> Option<&'static str> {
        (*self != Turret::default()).then(|| self.as_str())
    }

    fn set_word(&mut self, word: &str) {
        *self = Turret::ALL.into_iter().find(|side| side.as_str() == word).unwrap_or(*self);
    }
}

impl WordField for TcpFrame {
    fn word(&self) -> Option<&'static str> {
        (*self != TcpFrame::default()).then(|| self.as_str())
    }

    fn set_word(&mut self, word: &str) {
        *self = TcpFrame::ALL.into_iter().find(|frame| frame.as_str() == word).unwrap_or(*self);
    }
}

impl WordField for Probe {
    fn word(&self) -> Option<&'static str> {
        self.hit.map(ProbeHit::as_str)
    }

    /// A word removes the planes, as a plane removes the word.
    fn set_word(&mut self, word: &str) {
        let hit = ProbeHit::ALL.into_iter().find(|hit| hit.as_str() == word);
        *self = Probe { hit, ..Probe::default() };
    }
}
