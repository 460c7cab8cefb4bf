//! Rows of chords as arcs and lines, and as fewer chords.

use std::collections::HashMap;

use chordal::Job;
use chordal::control::table::MotionModality;
use chordal::control::{Action, ModeCode, MotionCode};
use chordal::control::{ArcShape, Units};
use chordal::diagnostics::TextRange;
use chordal::geometry::{Curve, FitOptions, FitPiece, Plane, Vec2, Vec3, fit_path, simplify};
use chordal::syntax::{Block, Word};

use super::StepOutcome;
use super::arcs::center_words;
use super::edit::{TransformRefusal, WordEdit};
use super::lines::BlockWords;
use super::record::RunRecord;
use super::roles::actions;
use super::rows::{StraightCut, rows};
use super::writer::WordWriter;

/// Shorter rows stay.
const MIN_ROW_BLOCKS: usize = 3;
/// Steps of the last digit that rounding the ends and the centre of an arc may take it off.
const ROUNDING_STEPS: f64 = 2.0;

/// Rows of chords as lines and arcs within a tolerance, mm, each cut at the slowest of its feeds, which may
/// be apart by a part of the fastest. A row that would not make the same motion stays as it is.
pub(super) fn fit(
    job: &Job,
    tolerance: f64,
    feed_tolerance: f64,
) -> Result<StepOutcome, TransformRefusal> {
    let writer = WordWriter::new(job);
    let record = RunRecord::of(job);
    let mut outcome =
        StepOutcome { tolerance_mm: tolerance, feed_tolerance, ..StepOutcome::default() };
    let (mut rows_of, mut rough) = (HashMap::new(), 0);
    rows(&writer, &record, MIN_ROW_BLOCKS, feed_tolerance, |row, following| {
        let units = row[0].run.context.units;
        let step = units.mm() * 0.1f64.powi(i32::from(writer.style.digits(units)));
        let left = tolerance - ROUNDING_STEPS * step;
        if left < step {
            rough += row.len();
            return;
        }
        let points: Vec<Vec3> =
            std::iter::once(row[0].from()).chain(row.iter().map(StraightCut::to)).collect();
        let options = FitOptions {
            max_radius: writer.control.parameters.rules.arc.max_radius_mm.min(10_000.0),
            ..FitOptions::within(left)
        };
        let Ok(fitted) = fit_path(&points, &options) else { return };
        if fitted.len() >= row.len() {
            return;
        }
        let edit = replace(&writer, row, following, &fitted);
        rows_of.insert(edit.range.start, [row.len(), fitted.len()]);
        outcome.edits.push(edit);
    });
    outcome.keep_proved(job);
    let counts = outcome.edits.iter().filter_map(|edit| rows_of.get(&edit.range.start));
    let [chords, pieces] = counts.fold([0, 0], |[chords, pieces], [a, b]| [chords + a, pieces + b]);
    if rough > 0 {
        outcome.notes.push(format!(
            "{rough} chords stay: the tolerance is not larger than the rounding of the program's last digit"
        ));
    }
    outcome.notes.push(format!("{chords} chords are {pieces} lines and arcs"));
    Ok(outcome)
}

/// The blocks of fitted pieces in the place of those of a row.
fn replace(
    writer: &WordWriter,
    row: &[StraightCut],
    next_block: Option<&Block>,
    fitted: &[FitPiece],
) -> WordEdit {
    let first = &row[0].block;
    let last = &row[row.len() - 1].block;
    let context = &row[0].run.context;
    let separator = TextRange::new(first.range.end, row[1].block.range.start).slice(writer.text);
    let separator = String::from_utf8_lossy(separator).into_owned();
    let mut typist = MoveWriter {
        writer,
        units: context.units,
        at: row[0].from().to_array(),
        motion: first.word(b'G').is_none().then_some(Action::Motion(MotionCode::Linear)),
        plane: context.plane,
        rule: context.arc_center,
    };
    let mut lines = Vec::new();
    let mut numbered = None;
    for (index, piece) in fitted.iter().enumerate() {
        let mut words = BlockWords::default();
        // The number of the first block that it stands for, where there is one.
        let block = (piece.span[0].ceil() as usize).min(row.len() - 1);
        if let Some(number) = row[block].block.word(b'N').filter(|_| numbered < Some(block)) {
            words.push(writer.word(number));
            numbered = Some(block);
        }
        typist.piece(piece, &mut words);
        if let Some(feed) = slowest(row).filter(|_| index == 0) {
            words.push(writer.word(feed));
        }
        lines.push(words.join(writer.style.gap()));
    }
    let feed = last_feed(row).filter(|_| next_block.is_none_or(|block| block.word(b'F').is_none()));
    lines.extend(typist.restore(context.plane, next_block, feed));
    let range = TextRange::new(first.range.start, last.range.end);
    WordEdit::new(range, lines.join(&separator), "chords as lines and arcs")
}

/// The F word of the slowest feed of a row; nothing where it is the one that was active before.
fn slowest(row: &[StraightCut]) -> Option<&Word> {
    let feed = row.iter().filter_map(|cut| cut.run.feed).min_by(f64::total_cmp);
    let slow = || row.iter().filter(|cut| cut.run.feed == feed);
    // Where no block of that feed says it, it was active before the row, and so at its first block.
    slow().find_map(|cut| cut.block.word(b'F'))
}

/// The F word that holds after a row, where it is not the one that the row is written with.
fn last_feed(row: &[StraightCut]) -> Option<&Word> {
    let feed = |cut: &StraightCut| cut.run.feed;
    let slow = row.iter().filter_map(feed).min_by(f64::total_cmp);
    let last = row.last().filter(|cut| feed(cut) != slow)?;
    row.iter().rev().filter(|cut| feed(cut) == feed(last)).find_map(|cut| cut.block.word(b'F'))
}

/// Writes moves, each with the words that change.
struct MoveWriter<'a> {
    writer: &'a WordWriter<'a>,
    units: Units,
    /// Where the tool stands by the digits that were written, mm.
    at: [f64; 3],
    /// The active motion code, where one is.
    motion: Option<Action>,
    plane: Plane,
    rule: chordal::control::ArcCenter,
}

impl MoveWriter<'_> {
    fn code(&self, action: Action) -> String {
        self.writer.g_code(action).unwrap_or_default()
    }

    fn motion(&mut self, action: Action, words: &mut BlockWords) {
        if self.motion != Some(action) {
            words.push(self.code(action));
            self.motion = Some(action);
        }
    }

    fn piece(&mut self, piece: &FitPiece, words: &mut BlockWords) {
        match piece.curve {
            Curve::Arc(arc) => {
                self.plane(piece.plane, words);
                let is_ccw = arc.sweep > 0.0;
                self.motion(
                    if is_ccw {
                        Action::Motion(MotionCode::ArcCcw)
                    } else {
                        Action::Motion(MotionCode::ArcCw)
                    },
                    words,
                );
                let from = self.at;
                let (a, b, _) = piece.plane.axes();
                let mut always = [false; 3];
                (always[a], always[b]) = (true, true);
                self.axes(arc.end, always, words);
                let shape = ArcShape {
                    plane: piece.plane,
                    // A whole turn has no chord.
                    center: if arc.start == arc.end {
                        let center = piece.plane.project(arc.center);
                        [center.a, center.b]
                    } else {
                        center(piece.plane, from, self.at, arc.sweep)
                    },
                    sweep: arc.sweep,
                    radius_from: arc.radius,
                    radius_to: arc.radius,
                };
                let from = [from[0], from[1], from[2], 0.0, 0.0, 0.0];
                let gap = self.writer.style.gap();
                words
                    .push(center_words(self.writer, &shape, from, self.rule, self.units).join(gap));
            }
            other => {
                use chordal::geometry::ParamCurve;
                self.motion(Action::Motion(MotionCode::Linear), words);
                self.axes(other.end(), [false; 3], words);
            }
        }
    }

    fn plane(&mut self, plane: Plane, words: &mut BlockWords) {
        if self.plane != plane {
            words.push(self.code(match plane {
                Plane::Xy => Action::Mode(ModeCode::PlaneXy),
                Plane::Zx => Action::Mode(ModeCode::PlaneZx),
                Plane::Yz => Action::Mode(ModeCode::PlaneYz),
            }));
            self.plane = plane;
        }
    }

    fn axes(&mut self, to: Vec3, always: [bool; 3], words: &mut BlockWords) {
        for (axis, target) in to.to_array().into_iter().enumerate() {
            let number = self.writer.length(target, self.units, None, 0);
            let value = number.parse::<f64>().unwrap_or(target) * self.units.mm();
            if always[axis] || (value - self.at[axis]).abs() > 1e-9 {
                words.push(format!("{}{number}", char::from(b"XYZ"[axis])));
                self.at[axis] = value;
            }
        }
    }

    /// What brings back what the blocks after rely on.
    fn restore(
        &mut self,
        plane: Plane,
        next_block: Option<&Block>,
        feed: Option<&Word>,
    ) -> Option<String> {
        let mut words = BlockWords::default();
        let is_changed = self.plane != plane;
        self.plane(plane, &mut words);
        let says_motion = next_block.is_some_and(|block| {
            let is_motion = |action| {
                matches!(
                    action,
                    Action::Motion(MotionCode::Rapid)
                        | Action::Motion(MotionCode::Linear)
                        | Action::Motion(MotionCode::ArcCw)
                        | Action::Motion(MotionCode::ArcCcw)
                        | Action::Cycle(_)
                )
            };
            actions(block, self.writer.control).any(|(_, action)| is_motion(action))
        });
        let exclusive = self.writer.control.table.motion == MotionModality::Exclusive;
        let is_arc =
            exclusive && self.motion != Some(Action::Motion(MotionCode::Linear)) && !says_motion;
        if is_arc {
            self.motion(Action::Motion(MotionCode::Linear), &mut words);
        }
        if let Some(feed) = feed {
            words.push(self.writer.word(feed));
        }
        (is_changed || is_arc || feed.is_some()).then(|| words.join(self.writer.style.gap()))
    }
}

/// The centre of an arc that turns by `sweep` between two places: both are on it, however they were
/// rounded.
pub(super) fn center(plane: Plane, from: [f64; 3], to: [f64; 3], sweep: f64) -> [f64; 2] {
    let [from, to] = [from, to].map(|at| plane.project(Vec3::from_array(at)));
    let (chord, middle) = (to - from, (from + to) * 0.5);
    let left: Vec2 = chord.turned_left();
    let center = middle + left * (0.5 / (sweep / 2.0).tan());
    [center.a, center.b]
}

/// The edits that leave out chords, mm.
pub(super) fn thin(job: &Job, tolerance: f64) -> Result<StepOutcome, TransformRefusal> {
    const REASON: &str = "fewer chords";
    let writer = WordWriter::new(job);
    let record = RunRecord::of(job);
    let mut outcome = StepOutcome { tolerance_mm: tolerance, ..StepOutcome::default() };
    let (mut chords, mut left) = (0, 0);
    rows(&writer, &record, MIN_ROW_BLOCKS, 0.0, |row, _| {
        // The first block has the words that all others rely on: it stays.
        let points: Vec<Vec3> = row.iter().map(StraightCut::to).collect();
        let Ok(kept) = simplify(&points, tolerance) else { return };
        (chords, left) = (chords + row.len(), left + kept.len());
        for pair in kept.windows(2) {
            let (before, here) = (&row[pair[0]], &row[pair[1]]);
            if pair[1] > pair[0] + 1 {
                let gone =
                    TextRange::new(row[pair[0] + 1].block.range.start, here.block.range.start);
                outcome.edits.push(WordEdit::new(gone, "", REASON));
            }
            name_axes(&writer, before, here, &mut outcome.edits);
        }
    });
    outcome.notes.push(format!("{chords} chords are {left}"));
    Ok(outcome)
}

/// Names the axes that blocks left out would have named.
fn name_axes(
    writer: &WordWriter,
    before: &StraightCut,
    here: &StraightCut,
    edits: &mut Vec<WordEdit>,
) {
    let mut put_in = BlockWords::default();
    let mut at = None;
    for axis in 0..3 {
        let letter = b"XYZ"[axis];
        if let Some(word) = here.block.last(letter) {
            at = Some(word.range.end);
        } else if here.run.to[axis] != before.run.to[axis] {
            let number = writer.length(here.run.to[axis], here.run.context.units, None, 0);
            put_in.push(format!("{}{number}", char::from(letter)));
        }
    }
    let words = put_in.join(writer.style.gap());
    if let (Some(at), false) = (at, words.is_empty()) {
        let gap = writer.style.gap();
        edits.push(WordEdit::insert(at, format!("{gap}{words}"), "an axis of a removed block"));
    }
}
