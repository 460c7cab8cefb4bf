//! A program bent over a map of measured heights: every cut is raised by the height at its place.
//!
//! `grid` is the map, `way` cuts a move where the surface bends, `levels` says what Z counts from, `checks` refuses
//! what cannot be bent, `write` changes the blocks, and `proof` holds the new run against the old one and the map,
//! without looking at how it was written.

mod checks;
mod grid;
mod levels;
mod plane_path;
mod proof;
mod write;

use chordal::Job;
use chordal_compare::{Category, ComparisonOptions, ComparisonVerdict, RunMapping};

pub use grid::{HeightMap, MapError};

use super::edit::{self, TransformRefusal};
use super::{IntendedMotion, TransformedProgram, refuse_what_has_no_roles};
use crate::prove;
use crate::source::first_text;
use crate::word_address::refuse_other_languages;

/// How a program is bent.
#[derive(Clone, Copy, Debug)]
pub struct HeightOptions {
    /// The new path may be so far off the old one on the surface, mm.
    pub tolerance_mm: f64,
    /// Beyond the map its edge goes on; otherwise a cut there is refused.
    pub clamp: bool,
}

/// A program bent over a map.
#[derive(Debug)]
pub struct HeightCorrection {
    /// The new text, its changes and its proof; distances are those from the old path on the surface.
    pub done: TransformedProgram,
    /// The lowest and the highest height under a cut, mm; nothing where there is no cut.
    pub heights_mm: Option<[f64; 2]>,
    /// How many moves the old program makes, and the new one.
    pub moves: [u64; 2],
}

/// What happens between moves, which stays as it is.
const BETWEEN_MOVES: &[Category] = &[
    Category::Tool,
    Category::Dwell,
    Category::Stop,
    Category::Code,
    Category::Written,
    Category::Variable,
    Category::Message,
    Category::Alarm,
    Category::Probe,
    Category::Output,
    Category::Value,
    Category::NotRun,
];

/// Raises every move of a program by the height of the map at its place, and proves it.
///
/// # Errors
/// The first block that cannot be bent, and why.
pub fn warp(
    job: &Job,
    map: &HeightMap,
    warp: &HeightOptions,
) -> Result<HeightCorrection, TransformRefusal> {
    refuse_other_languages(job)?;
    refuse_what_has_no_roles(job)?;
    let mut written = write::write(job, map, warp)?;
    let old = first_text(job);
    let text = edit::apply(old, &mut written.edits);
    let changes = edit::changes(old, &written.edits);
    let new = job.with_text(text.clone());
    // The comparison looks for one path near another. Here every move has its own others, so they are held
    // against each other move by move; of the comparison what happens between the moves is kept, and what both runs say
    // of themselves.
    let ignored = Category::ALL.into_iter().filter(|category| !BETWEEN_MOVES.contains(category));
    let options = ComparisonOptions { ignored: ignored.collect(), ..ComparisonOptions::default() };
    let mut certificate = prove(job, &new, &options, &[]);
    let mut notes = written.notes;
    let proved = proof::prove(job, &new, map, &written.trail, warp);
    let comparison = &mut certificate.comparison;
    certificate.tolerance_mm = warp.tolerance_mm;
    comparison.farthest = None;
    comparison.farthest_at_mm = None;
    comparison.max_distance_mm = None;
    match &proved {
        Ok(proved) => {
            comparison.max_distance_mm = Some(proved.deviation_mm);
            if !comparison.differences.is_empty() {
                comparison.verdict = ComparisonVerdict::Different;
            } else if comparison.verdict != ComparisonVerdict::NotVerified {
                let is_same = proved.deviation_mm <= chordal_compare::COINCIDENT_MM;
                comparison.verdict =
                    if is_same { ComparisonVerdict::Same } else { ComparisonVerdict::Within };
            }
        }
        Err(why) => {
            comparison.verdict = ComparisonVerdict::Different;
            notes.push(why.clone());
        }
    }
    let (heights_mm, moves) = match proved {
        Ok(proved) => (proved.heights_mm, proved.moves),
        Err(_) => (None, [0, 0]),
    };
    if comparison.verdict == ComparisonVerdict::NotVerified {
        notes.push(super::NOT_FOLLOWED.into());
    }
    let meant = IntendedMotion { options, expected: Vec::new(), mapping: RunMapping::default() };
    let done = TransformedProgram { text, changes, notes, certificate, meant };
    Ok(HeightCorrection { done, heights_mm, moves })
}
