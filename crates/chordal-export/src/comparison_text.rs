//! A comparison of two programs as words.

use std::path::Path;

use chordal::{Code, Job};
use chordal_compare::{Comparison, ComparisonVerdict, Difference};

use crate::comparison::value_text;
use crate::numbers::{SummaryUnits, counted, grouped, short};

/// Most differences that the text lists.
const MAX_LISTED_DIFFERENCES: usize = 20;

/// A comparison for people, the two called by these names.
pub fn comparison_text(
    found: &Comparison,
    names: [&str; 2],
    jobs: [&Job; 2],
    tolerance_mm: f64,
) -> String {
    let units = SummaryUnits::of(found.reports[0].summary.inch);
    let mut text = comparison_headline(found, units, tolerance_mm);
    if let Some(at) = found.farthest {
        let [a, b] = [0, 1].map(|side: usize| format!("{}:{}", names[side], at[side].line));
        text += &format!("furthest apart at {a} and {b}\n");
    }
    for (name, report) in names.iter().zip(&found.reports) {
        let unknown =
            report.diagnostics.iter().filter(|one| one.code == Code::NotSimulated).count();
        if unknown > 0 {
            let words = counted(unknown as u64, "word", "words");
            text += &format!(
                "{name}: {words} not carried out: compared by their codes, not by what they do; `chordal check` lists them\n"
            );
        }
        if !report.verified() {
            text += &format!(
                "{name}: not verified to its end; `chordal check` says from which line on\n"
            );
        }
        if report.counts.errors > 0 {
            let errors = counted(report.counts.errors, "error", "errors");
            text += &format!("{name}: {errors}; `chordal check` lists them\n");
        }
    }
    for one in found.differences.iter().take(MAX_LISTED_DIFFERENCES) {
        text += &difference_text(one, names, jobs, units);
    }
    let more =
        found.differences.len().saturating_sub(MAX_LISTED_DIFFERENCES) as u64 + found.dropped;
    if more > 0 {
        text += &format!("\nand {}\n", counted(more, "more difference", "more differences"));
    }
    text
}

/// The answer in a line.
pub fn comparison_headline(found: &Comparison, units: SummaryUnits, tolerance_mm: f64) -> String {
    let total = found.differences.len() as u64 + found.dropped;
    let differences = counted(total, "difference", "differences");
    match (found.verdict, found.max_distance_mm) {
        (ComparisonVerdict::Same, None) if found.moves == [0, 0] => "same: neither moves\n".into(),
        (ComparisonVerdict::Same, None) => {
            "same as far as can be checked: no move lies between positions that are known \
                                 relative to the part\n"
                .into()
        }
        (ComparisonVerdict::Same, Some(_)) => format!(
            "same: {}\n",
            match found.moves {
                [a, b] if a == b => counted(a, "move", "moves"),
                [a, b] => format!("{a} moves in the first program, {b} in the second"),
            }
        ),
        (ComparisonVerdict::Within, most) => {
            let most = length_text(most.unwrap_or_default(), units);
            format!(
                "within the tolerance: the paths are at most {most} apart, {} is allowed\n",
                length_text(tolerance_mm, units)
            )
        }
        (ComparisonVerdict::NotVerified, _) => {
            "not verified: a program does something that is not followed, and what comes after it is not known\n"
                .into()
        }
        (ComparisonVerdict::Different, None) => format!("different: {differences}\n"),
        (ComparisonVerdict::Different, Some(most)) if most <= chordal_compare::COINCIDENT_MM => {
            format!("different: {differences}; the paths are the same\n")
        }
        (ComparisonVerdict::Different, Some(most)) => {
            format!(
                "different: {differences}; the paths are at most {} apart\n",
                length_text(most, units)
            )
        }
    }
}

/// How two programs are called: by the names of their files, or by their machines where it is one program.
pub fn comparison_names(names: [&str; 2], jobs: [&Job; 2]) -> [String; 2] {
    if names[0] == names[1] {
        return jobs.map(|job| job.machine().name.clone());
    }
    let short = names.map(|name| Path::new(name).file_name().and_then(|name| name.to_str()));
    match short {
        [Some(a), Some(b)] if a != b => [a.into(), b.into()],
        _ => names.map(str::to_string),
    }
}

/// A difference in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DifferenceWords {
    /// In what, how far apart, by how much one is the other moved, how often.
    pub head: String,
    /// What each of the two has.
    pub sides: [SideWords; 2],
}

/// What one of the two has, in words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SideWords {
    /// The value, where it is one.
    pub value: Option<String>,
    /// The words of its first block; of the block before, where it lacks what the other has.
    pub words: String,
    /// It has nothing of the kind.
    pub lacks: bool,
}

/// The parts of a difference that are words.
pub fn difference_words(one: &Difference, jobs: [&Job; 2], units: SummaryUnits) -> DifferenceWords {
    let mut head = one.category.word().to_string();
    if let Some(distance) = one.distance_mm {
        head += &format!(": at most {} apart", length_text(distance, units));
    }
    if let Some(shift) = one.shift_mm {
        let shift = shift.map(|mm| length_text(mm, units));
        head += &format!(", moved by X {} Y {} Z {}", shift[0], shift[1], shift[2]);
    }
    if one.times > 1 {
        head += &format!(", {} times", grouped(one.times));
    }
    let sides = [0, 1].map(|side: usize| SideWords {
        value: one.values.as_ref().map(|values| value_text(&values[side], units)),
        words: one.blocks[side].as_ref().map_or_else(String::new, |at| {
            jobs[side].sources().words(at.first.span).trim().to_string()
        }),
        lacks: one.steps[side] == 0,
    });
    DifferenceWords { head, sides }
}

/// A difference with the lines of both.
pub fn difference_text(
    one: &Difference,
    names: [&str; 2],
    jobs: [&Job; 2],
    units: SummaryUnits,
) -> String {
    let DifferenceWords { head, sides } = difference_words(one, jobs, units);
    let mut text = format!("\n{head}\n");
    let places = [0, 1].map(|side: usize| match &one.blocks[side] {
        None => names[side].to_string(),
        Some(at) => match at.lines() {
            (from, to) if from == to => format!("{}:{from}", names[side]),
            (from, to) => format!("{}:{from}-{to}", names[side]),
        },
    });
    let width = places.iter().map(|place| place.chars().count()).max().unwrap_or(0);
    for (side, SideWords { value, words, lacks }) in sides.into_iter().enumerate() {
        let lacks = lacks && one.blocks[side].is_some();
        let words = if lacks { format!("(has no such block; after {words})") } else { words };
        let value = value.map_or_else(String::new, |value| format!("  {value}"));
        let moves = match one.steps[side] {
            0 | 1 => String::new(),
            steps => format!("  ({})", counted(steps, "block", "blocks")),
        };
        text += format!("  {:width$}{value}  | {words}{moves}", places[side]).trim_end();
        text.push('\n');
    }
    text
}

/// To a hundredth of a micrometre: what is less is written as a power of ten.
pub fn length_text(mm: f64, units: SummaryUnits) -> String {
    let value = mm / units.length_mm();
    let text =
        if value == 0.0 || value.abs() >= 1e-4 { short(value, 5) } else { format!("{value:.1e}") };
    format!("{text} {}", units.length_unit())
}
