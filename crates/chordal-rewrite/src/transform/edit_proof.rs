//! Edits that stand alone: those whose proof fails are taken back, and said.

use chordal::Job;
use chordal::diagnostics::{FileId, Source};
use chordal_compare::{Category, ComparisonOptions, ComparisonVerdict, Difference};

use super::StepOutcome;
use super::edit::{WordEdit, apply};
use crate::source::first_text;
use crate::{Certificate, prove};

/// Edits are taken back so many times before all of them are.
const MAX_REVERT_ROUNDS: usize = 8;

/// An edit that was taken back, and what would have differed.
struct RevertedEdit {
    edit: WordEdit,
    category: Category,
    distance_mm: Option<f64>,
}

impl StepOutcome {
    /// Takes back each edit that changes the motion by more than the tolerances, and keeps the proof of
    /// those that are left. For edits of which none relies on another.
    pub(super) fn keep_proved(&mut self, job: &Job) {
        let mut refused = Vec::new();
        for round in 0.. {
            let certificate = self.prove(job);
            let verdict = certificate.comparison.verdict;
            if certificate.holds()
                || verdict == ComparisonVerdict::NotVerified
                || self.edits.is_empty()
            {
                self.certificate = Some(certificate);
                break;
            }
            let hit =
                if round < MAX_REVERT_ROUNDS { self.take_hit(&certificate) } else { Vec::new() };
            if hit.is_empty() {
                let category = first_category(&certificate);
                let all = std::mem::take(&mut self.edits);
                refused.extend(all.into_iter().map(|edit| RevertedEdit {
                    edit,
                    category,
                    distance_mm: None,
                }));
            } else {
                refused.extend(hit);
            }
        }
        self.note_refused(first_text(job), &refused);
    }

    fn prove(&mut self, job: &Job) -> Certificate {
        let new = apply(first_text(job), &mut self.edits);
        // Each difference takes back an edit.
        let options = ComparisonOptions { kept: 100_000, ..self.options() };
        prove(job, &job.with_text(new), &options, &self.expected)
    }

    /// Takes out the edits in whose text something differs.
    fn take_hit(&mut self, certificate: &Certificate) -> Vec<RevertedEdit> {
        let mut hit = Vec::new();
        for difference in &certificate.comparison.differences {
            let Some([first, last]) = old_text(difference) else { continue };
            self.edits.retain(|edit| {
                let is_hit = edit.range.start <= last && first < edit.range.end;
                if is_hit {
                    hit.push(RevertedEdit {
                        edit: edit.clone(),
                        category: difference.category,
                        distance_mm: difference.distance_mm,
                    });
                }
                !is_hit
            });
        }
        hit
    }

    fn note_refused(&mut self, text: &[u8], refused: &[RevertedEdit]) {
        let Some(first) = refused.iter().min_by_key(|refused| refused.edit.range.start) else {
            return;
        };
        let source = Source::new("", text);
        let lines = [first.edit.range.start, first.edit.range.end].map(|at| source.line_of(at));
        let rows = match refused.len() {
            1 => "1 row of chords stays as it is, in".to_string(),
            count => format!("{count} rows of chords stay as they are, the first in"),
        };
        let why = match (first.category, first.distance_mm) {
            (Category::Path, Some(mm)) => format!("the new path would be {mm:.4} mm off"),
            (Category::Feed, _) => {
                "the feed would change: in an arc that rises or falls, F is the \
                                    feed in its plane"
                    .to_string()
            }
            (category, _) => format!("it would differ in: {}", category.word()),
        };
        self.notes.push(format!("{rows} lines {} to {}: {why}", lines[0], lines[1]));
    }
}

fn first_category(certificate: &Certificate) -> Category {
    let first = certificate.comparison.differences.first();
    first.map_or(Category::Path, |difference| difference.category)
}

/// The first and the last byte of the old text that a difference is about.
pub(super) fn old_text(difference: &Difference) -> Option<[u32; 2]> {
    let blocks = difference.blocks[0]?;
    let ends = [blocks.first, blocks.last];
    let here = ends.iter().all(|place| place.span.file == FileId(0));
    let at = ends.map(|place| place.span.range.start);
    here.then(|| [at[0].min(at[1]), at[0].max(at[1])])
}
