//! The codes of all diagnostics. A code never changes its meaning and is never reused.
//!
//! There is one file per family; each entry has the number, the name, the severity, a summary in one line, and the
//! text that `chordal explain` prints.

mod compensation;
mod cycles;
mod frames;
mod machine;
mod macros;
mod motion;
mod pockets;
mod program;
mod reading;
mod stock;
mod words;

use std::fmt;
use std::sync::LazyLock;

use crate::Severity;

/// The registry entry of a code.
#[derive(Clone, Copy, Debug)]
pub struct CodeInfo {
    /// The code itself.
    pub code: Code,
    /// The stable number, such as `CH401`.
    pub id: &'static str,
    /// The stable name, such as `radius-mismatch`.
    pub name: &'static str,
    /// The severity, unless a control has another one.
    pub severity: Severity,
    /// The summary in one line.
    pub summary: &'static str,
    /// Paragraphs: what it means, why it matters, what to do, an example.
    pub explanation: &'static str,
}

/// A code of a diagnostic, by its number: `Code::RadiusMismatch` is 401.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Code(u16);

/// Declares the codes of a family: constants of [`Code`] and their registry entries.
///
/// `Name = number, "stable-name", Severity; "one line"; "explanation";`
macro_rules! codes {
    ($($code:ident = $number:literal, $name:literal, $severity:ident; $summary:literal; $explanation:literal;)*) => {
        #[allow(non_upper_case_globals, reason = "codes are written like the variants of an enum")]
        impl super::Code {
            $(#[doc = concat!("CH", $number, ": ", $summary)]
            pub const $code: super::Code = super::Code($number);)*
        }

        pub(super) const FAMILY: &[super::CodeInfo] = &[$(super::CodeInfo {
            code: super::Code($number),
            id: concat!("CH", $number),
            name: $name,
            severity: $crate::Severity::$severity,
            summary: $summary,
            explanation: $explanation,
        },)*];
    };
}
use codes;

static FAMILIES: [&[CodeInfo]; 11] = [
    reading::FAMILY,
    program::FAMILY,
    words::FAMILY,
    motion::FAMILY,
    frames::FAMILY,
    compensation::FAMILY,
    machine::FAMILY,
    macros::FAMILY,
    cycles::FAMILY,
    pockets::FAMILY,
    stock::FAMILY,
];

/// All codes in the order of their numbers.
static ALL: LazyLock<Vec<&'static CodeInfo>> = LazyLock::new(|| {
    let mut all: Vec<_> = FAMILIES.into_iter().flatten().collect();
    all.sort_by_key(|info| info.code);
    all
});

impl Code {
    /// All codes in the order of their numbers.
    pub fn all() -> impl ExactSizeIterator<Item = Code> {
        ALL.iter().map(|info| info.code)
    }

    /// Whether the code is reported only once per file, because it holds for all numbers of the file.
    pub const fn is_once_per_file(self) -> bool {
        matches!(self, Code::ExcessDecimals)
    }

    /// Whether a diagnostic of this code and severity means that the path is unknown from there on, because the
    /// control may continue differently.
    pub const fn loses_path(self, severity: Severity) -> bool {
        match self {
            Code::NotFollowed
            | Code::NotRead
            | Code::UnknownCode
            | Code::MissingSubprogram
            | Code::UnsupportedMacro
            | Code::BudgetReached => matches!(severity, Severity::Error),
            Code::ReadingNotKnown
            | Code::UnknownPath
            | Code::AssumedBranch
            | Code::SkipAssumed
            | Code::InputNotAnswered
            | Code::MacroAlone => true,
            // As a note it only says that the tip is taken as programmed.
            Code::TipNotKnown => !matches!(severity, Severity::Note),
            _ => false,
        }
    }

    /// Whether the time is unknown from there on, because a feed, a speed or a wait depends on an unknown value, or the order
    /// of the cuts of a cycle is assumed.
    pub const fn loses_time(self) -> bool {
        matches!(self, Code::UnknownTime | Code::CyclePathAssumed | Code::KinematicsNotKnown)
    }

    /// The registry entry.
    pub fn info(self) -> &'static CodeInfo {
        let place = ALL.binary_search_by_key(&self, |info| info.code);
        ALL[place.expect("only the families make codes, and each has its entry there")]
    }

    /// Finds a code by its number (`CH401`, any case) or name (`radius-mismatch`).
    pub fn find(text: &str) -> Option<Code> {
        let matches = |info: &&&CodeInfo| {
            info.id.eq_ignore_ascii_case(text) || info.name.eq_ignore_ascii_case(text)
        };
        ALL.iter().find(matches).map(|info| info.code)
    }

    /// The stable number, such as `CH401`.
    pub fn id(self) -> &'static str {
        self.info().id
    }
}

impl fmt::Debug for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "CH{:03} {}", self.0, self.info().name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_names_are_unique() {
        let codes: Vec<_> = Code::all().collect();
        assert!(codes.windows(2).all(|pair| pair[0] < pair[1]), "{codes:?}");
        let mut names: Vec<_> = codes.iter().map(|code| code.info().name).collect();
        names.sort_unstable();
        assert!(names.windows(2).all(|pair| pair[0] != pair[1]));
        for info in FAMILIES.into_iter().flatten() {
            assert_eq!(Code::find(info.id), Some(info.code));
            assert!(!info.explanation.trim().is_empty(), "{}", info.id);
        }
    }

    #[test]
    fn a_family_holds_its_numbers_in_order() {
        for family in FAMILIES {
            assert!(family.windows(2).all(|pair| pair[0].code < pair[1].code));
        }
    }
}
