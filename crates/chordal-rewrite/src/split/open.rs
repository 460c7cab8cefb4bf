//! Stretches of the text that belong together whatever the run does: loops, jumps, variables.

use std::collections::HashMap;
use std::ops::Range;

use chordal::Job;
use chordal::syntax::BlockKind;
use chordal_editor::{NameOccurrence, NameRole, SymbolName};

use crate::source::{SourceBlocks, program};

/// Variables from this number on are the control's own.
const FIRST_SYSTEM_VARIABLE: u32 = 1000;

/// From a byte to another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct UnsplittableRange {
    from: u32,
    to: u32,
    /// What holds it together.
    pub(crate) what: String,
}

impl UnsplittableRange {
    /// The byte that it begins at.
    pub(crate) fn from(&self) -> u32 {
        self.from
    }

    /// True when a text split before this byte would part it.
    pub(crate) fn holds(&self, at: u32) -> bool {
        self.from < at && at <= self.to
    }
}

/// All that must not be split in the main program.
pub(crate) fn unsplittable_ranges(
    job: &Job,
    source: &SourceBlocks,
    main: &Range<usize>,
) -> Vec<UnsplittableRange> {
    let mut unsplittable_ranges = loops(source, main);
    let Some(program) = program(job) else { return unsplittable_ranges };
    let mut places: HashMap<SymbolName, Vec<NameOccurrence>> = HashMap::new();
    for place in program.occurrences() {
        places.entry(place.name.clone()).or_default().push(place);
    }
    unsplittable_ranges.extend(places.iter().filter_map(|(name, places)| match name {
        // Every part has the programs that it calls.
        SymbolName::Program(_) => None,
        SymbolName::Variable { name, .. } => variable(name, places),
        SymbolName::Subroutine(name) => whole(places, format!("o{name}")),
        SymbolName::Label { .. } | SymbolName::LineLabel(_) => {
            let what = match name {
                SymbolName::Label { number, .. } => format!("N{number}"),
                SymbolName::LineLabel(name) => format!(":{name}"),
                _ => String::new(),
            };
            let is_used = places.iter().any(|place| place.role == NameRole::Use);
            let is_sub = places.iter().any(|place| {
                let at = source.first_at(place.range.end).saturating_sub(1);
                place.role == NameRole::Definition && source.sub_of(at).is_some()
            });
            if is_used && !is_sub { whole(places, what) } else { None }
        }
    }));
    // In the order of the text: which of several is named does not depend on the order of a hash table.
    unsplittable_ranges.sort_by(|a, b| (a.from, a.to, &a.what).cmp(&(b.from, b.to, &b.what)));
    unsplittable_ranges
}

fn whole(places: &[NameOccurrence], what: String) -> Option<UnsplittableRange> {
    let from = places.iter().map(|place| place.range.start).min()?;
    let to = places.iter().map(|place| place.range.start).max()?;
    (from < to).then_some(UnsplittableRange { from, to, what })
}

/// From where a variable gets its first value to where it is used last. The values of the control's own
/// variables act without being named.
fn variable(name: &str, places: &[NameOccurrence]) -> Option<UnsplittableRange> {
    let provided = places.iter().filter(|place| place.role == NameRole::Definition);
    let from = provided.map(|place| place.range.start).min()?;
    let number = name.trim_start_matches(|letter: char| !letter.is_ascii_digit()).parse::<u32>();
    let is_system = number.is_ok_and(|number| number >= FIRST_SYSTEM_VARIABLE);
    let used = places.iter().filter(|place| place.role == NameRole::Use);
    let to = used.map(|place| place.range.start).max();
    let to = if is_system { Some(u32::MAX) } else { to };
    to.map(|to| UnsplittableRange { from, to, what: name.into() })
}

/// From `DO` to `END`.
fn loops(source: &SourceBlocks, main: &Range<usize>) -> Vec<UnsplittableRange> {
    let mut open = Vec::new();
    let mut unsplittable_ranges = Vec::new();
    for block in &source.blocks[main.clone()] {
        let BlockKind::Macro(range) = block.kind else { continue };
        let words = range.slice(source.text).to_ascii_uppercase();
        let begins = |word: &[u8]| words.trim_ascii_start().starts_with(word);
        if begins(b"WHILE") || begins(b"DO") {
            open.push(block.range.start);
        } else if begins(b"END")
            && let Some(from) = open.pop()
        {
            let what = "a loop".into();
            unsplittable_ranges.push(UnsplittableRange { from, to: block.range.start, what });
        }
    }
    unsplittable_ranges
}
