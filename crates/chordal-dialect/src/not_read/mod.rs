//! Languages that Chordal recognizes and does not read, one file each: a program of them is one message and
//! not two hundred, and nothing is read as something that it is not.

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

/// A language that is not read.
#[derive(Debug)]
pub struct NotRead {
    /// Its name, as the names of controls are.
    pub name: &'static str,
    /// What such a program is, for people: `a lathe program for a Fanuc`.
    pub what: &'static str,
    /// What is said of it: `lathe programs are not followed yet`.
    pub why: &'static str,
    /// The signs that decide whether a text is in this language.
    pub signs: &'static [RecognitionEvidence],
    /// So much they must weigh together.
    pub needed: i32,
    /// Signs that tell it from others of its kind. They count once the text is in the language.
    pub own: &'static [RecognitionEvidence],
    /// The control that the text is shown on: its comments and words, not its motion.
    pub shown_on: ControlName,
}

/// All of them. Of two that weigh alike the first counts.
pub const ALL: &[&NotRead] = &[
    &heidenhain::HEIDENHAIN,
    &sinumerik::SINUMERIK,
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
            assert!(!taken, "{}", language.name);
            assert!(language.needed > 0 && !language.signs.is_empty(), "{}", language.name);
        }
    }
}
