//! Languages other than word-address blocks, one file each, recognized by their signs. A program in one that no crate
//! reads gets one message instead of hundreds, and none of its lines is taken for something else.

mod acramatic;
mod fagor;
mod grbl_kin;
mod heidenhain;
mod isg;
mod num;
mod okuma;
mod philips;
mod plotter;
mod printer;
mod selca;
mod shopbot;
mod sinumerik;
mod wire_edm;

use chordal_machine::ControlName;

use crate::recognition::RecognitionEvidence;

/// A language other than word-address blocks.
#[derive(Debug)]
pub struct NotRead {
    /// Its name in data, like the names of controls.
    pub name: &'static str,
    /// What such a program is, for users: `a lathe program for a Fanuc`.
    pub what: &'static str,
    /// The second half of the message about it: `lathe programs are not followed yet`; empty for a language that is read.
    pub why: &'static str,
    /// The signs that decide whether a text is in this language.
    pub signs: &'static [RecognitionEvidence],
    /// The sum of weights from which on a text is in this language.
    pub needed: i32,
    /// Further signs, which count once a text is in the language; of several such languages the highest sum wins.
    pub own: &'static [RecognitionEvidence],
    /// Without one of its own signs a text is in the other language that has the same signs.
    pub needs_own: bool,
    /// The control whose lexical rules an editor uses for the text; the control of this name if the language is read.
    pub shown_on: ControlName,
}

impl NotRead {
    /// True for a language that is read by a crate of its own.
    pub fn is_read(&self) -> bool {
        self.shown_on.as_str() == self.name
    }
}

/// All of them; of two with the same weight the first wins.
pub const ALL: &[&NotRead] = &[
    &heidenhain::HEIDENHAIN,
    &sinumerik::SINUMERIK,
    &sinumerik::SINUMERIK_LATHE,
    &okuma::OKUMA,
    &printer::PRINTER,
    &grbl_kin::GRBL_KIN,
    &fagor::FAGOR,
    &isg::ISG,
    &acramatic::ACRAMATIC,
    &philips::PHILIPS,
    &num::NUM,
    &selca::SELCA,
    &shopbot::SHOPBOT,
    &plotter::PLOTTER,
    &wire_edm::WIRE_EDM,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_not_those_of_controls() {
        for language in ALL {
            let taken = ControlName::ALL.iter().any(|name| name.as_str() == language.name);
            assert_eq!(taken, language.is_read(), "{}", language.name);
            assert_eq!(language.why.is_empty(), language.is_read(), "{}", language.name);
            assert!(language.needed > 0 && !language.signs.is_empty(), "{}", language.name);
        }
    }
}
