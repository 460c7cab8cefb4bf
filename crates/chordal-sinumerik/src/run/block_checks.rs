//! Words that may not stand in one block.

use chordal_diagnostics::{Code, TextRange};

use super::frames::is_frame_block;
use super::interpreter::Interpreter;
use super::run_state::PathMotion;
use super::words::{BlockWords, CENTER_NAMES};
use crate::syntax::{BlockStatement, ProgramBlock, StatementKind};

/// Names of modal functions by their group (NC Programming 12/2019, list of G functions). Groups of G codes have the
/// same numbers.
const GROUPS_OF_NAMES: &[(u32, &[&str])] = &[
    (1, &["CIP", "CT", "ASPLINE", "BSPLINE", "CSPLINE", "POLY", "INVCW", "INVCCW"]),
    (9, &["SUPA"]),
    (16, &["CFC", "CFTCP", "CFIN"]),
    (17, &["NORM", "KONT", "KONTC", "KONTT"]),
    (21, &["BRISK", "SOFT", "DRIVE"]),
    (22, &["CUT2D", "CUT2DF"]),
    (23, &["CDON", "CDOF", "CDOF2"]),
    (24, &["FFWON", "FFWOF"]),
    (25, &["ORIWKS", "ORIMKS"]),
    (28, &["WALIMON", "WALIMOF"]),
    (29, &["DIAMON", "DIAMOF", "DIAM90"]),
    (30, &["COMPOF", "COMPON", "COMPCURV", "COMPCAD", "COMPSURF"]),
    (37, &["FNORM", "FLIN", "FCUB"]),
    (45, &["SPATH", "UPATH"]),
    (51, &["ORIVECT", "ORIAXES"]),
    (55, &["RTLION", "RTLIOF"]),
    (59, &["DYNNORM", "DYNPOS", "DYNROUGH", "DYNSEMIFIN", "DYNFINISH"]),
];

/// The group of a modal function with a name; `None` for other names.
pub fn group_of_name(name: &str) -> Option<u32> {
    GROUPS_OF_NAMES.iter().find(|(_, names)| names.contains(&name)).map(|(group, _)| *group)
}

impl Interpreter<'_> {
    /// Two functions of one group in a block; `seen` has the G codes with their groups.
    pub(super) fn check_groups_of_names(&mut self, words: &BlockWords, seen: &[(u32, u32)]) {
        let mut names: Vec<(&str, u32)> = Vec::new();
        for (name, range) in &words.names {
            let Some(group) = group_of_name(name) else { continue };
            let code =
                seen.iter().find(|(_, own)| *own == group).map(|(code, _)| format!("G{code}"));
            let other = names.iter().find(|(other, own)| *own == group && other != name);
            if let Some(other) = code.or_else(|| other.map(|(other, _)| (*other).to_string())) {
                let message = format!("{other} and {name} are of one group and in one block");
                self.alarm(12060, Code::SameGroup, *range, message);
            }
            names.push((name, group));
        }
    }

    /// Functions that stand alone in their block: frames, G4, poles.
    pub(super) fn check_alone(&mut self, words: &BlockWords) {
        let alone = words.g_codes.iter().find(|(code, _)| matches!(code, 4 | 110..=112)).copied();
        let (what, is_dwell) = match alone {
            Some((code, _)) => (format!("G{code}"), code == 4),
            None if is_frame_block(words) && !words.names.is_empty() => {
                (words.names[0].0.clone(), false)
            }
            None => return,
        };
        let other_code =
            words.g_codes.iter().find(|(code, _)| !matches!(code, 4 | 58 | 59 | 110..=112));
        let other = other_code
            .or(words.m_codes.first())
            .map(|(_, range)| *range)
            .or(words.tool.as_ref().map(|(_, range)| *range))
            .or_else(|| words.other("F").filter(|_| !is_dwell).map(|word| word.range))
            .or_else(|| {
                words.axes.iter().flatten().next().filter(|_| is_dwell).map(|word| word.range)
            });
        if let Some(range) = other {
            let message = format!("{what} stands alone in its block");
            self.alarm(12120, Code::SameGroup, range, message);
        }
    }

    /// A call together with words that move or set something.
    pub(super) fn check_call_alone(&mut self, block: &ProgramBlock, call: TextRange, what: &str) {
        let is_other = |statement: &&BlockStatement| match &statement.kind {
            StatementKind::Word(word) => word.address.name != "P" && statement.range != call,
            StatementKind::Name(_) => statement.range != call,
            _ => false,
        };
        if let Some(other) = block.statements.iter().find(is_other) {
            let message = format!("{what} stands alone in its block");
            self.alarm(12120, Code::SameGroup, other.range, message);
        }
    }

    /// I, J or K where the motion has no centre.
    pub(super) fn check_centers(&mut self, words: &BlockWords) {
        let is_straight = matches!(self.modes.motion, PathMotion::Rapid | PathMotion::Linear);
        let has_thread = words.g_codes.iter().any(|(code, _)| matches!(code, 63 | 33..=35));
        if !is_straight || has_thread {
            return;
        }
        let found = (0..3).find_map(|axis| Some((CENTER_NAMES[axis], words.centers[axis]?.range)));
        if let Some((letter, range)) = found {
            let message = format!("{letter} in a block without an arc");
            self.alarm(12110, Code::UnusedWord, range, message);
        }
    }
}
