//! Arcs in another form: by radius, by centre, as chords.

use chordal::Job;
use chordal::control::{Action, MotionCode};
use chordal::control::{ArcCenter, ArcShape, CompensationSide, FeedMode, Units};
use chordal::geometry::{ParamCurve, Placement, Plane, Vec3, spiral_from_center};
use chordal::machine::PerAxis;
use chordal::syntax::{Block, Word};

use super::edit::{TransformRefusal, WordEdit, replace_words};
use super::lines::{BlockWords, newline, tail};
use super::record::{BlockEffect, BlockPass, BlockRuns, RunRecord};
use super::roles::{NumberRole, actions, roles};
use super::writer::WordWriter;
use super::{ArcForm, StepOutcome};

/// Half circles are left as they are within this much, radians: there a radius says little of the centre.
const HALF_CIRCLE_TOLERANCE_RAD: f64 = 0.02;
/// A whole turn has no radius form.
const FULL_CIRCLE_TOLERANCE_RAD: f64 = 1e-6;

/// What arcs of a text are to be.
struct ArcRewriter<'a> {
    writer: WordWriter<'a>,
    outcome: StepOutcome,
}

/// The edits that write arcs by radius or by centre.
pub(super) fn form(job: &Job, form: ArcForm) -> Result<StepOutcome, TransformRefusal> {
    let mut arcs = ArcRewriter { writer: WordWriter::new(job), outcome: StepOutcome::default() };
    let record = RunRecord::of(job);
    let mut kept = Vec::new();
    arcs.each(&record, |arcs, block, runs| {
        let roles = roles(block, &runs.first.context, arcs.writer.control);
        let is_center =
            |role: &NumberRole| matches!(role, NumberRole::Center(_) | NumberRole::Spoke(_));
        let words = |desired: &dyn Fn(&Word, &NumberRole) -> bool| -> Vec<Word> {
            let both = block.words.iter().zip(&roles).filter(|(word, role)| desired(word, role));
            both.map(|(word, _)| *word).collect()
        };
        let centers = words(&|_, role| is_center(role));
        let radii =
            words(&|word, role| word.letter == b'R' && *role == NumberRole::Length && !word.comma);
        let (old, new) = match form {
            ArcForm::Radius if !centers.is_empty() => match arcs.radius(block, runs) {
                Some(new) => (centers, new),
                None => {
                    kept.push(block.line);
                    return Ok(());
                }
            },
            ArcForm::Center if !radii.is_empty() && centers.is_empty() => {
                (radii, arcs.center(block, runs)?)
            }
            _ => return Ok(()),
        };
        arcs.same_arc(block, runs)?;
        arcs.replace(&old, &new, "the arc in its other form");
        Ok(())
    })?;
    if let [first, ..] = kept[..] {
        arcs.outcome.notes.push(format!(
            "{} arcs keep their centres, the first on line {first}: full and half turns have no reliable radius form",
            kept.len()
        ));
    }
    // The centre of an arc by radius moves more than the radius does.
    arcs.outcome.tolerance_mm = 4.0 * arcs.writer.tolerance_mm();
    Ok(arcs.outcome)
}

/// The edits that write arcs and spirals as chords within a tolerance, mm.
pub(super) fn chords(job: &Job, tolerance: f64) -> Result<StepOutcome, TransformRefusal> {
    let mut arcs = ArcRewriter { writer: WordWriter::new(job), outcome: StepOutcome::default() };
    let record = RunRecord::of(job);
    arcs.each(&record, |arcs, block, runs| arcs.chords(block, runs, tolerance))?;
    arcs.outcome.tolerance_mm = tolerance + arcs.writer.tolerance_mm();
    Ok(arcs.outcome)
}

impl<'a> ArcRewriter<'a> {
    fn each(
        &mut self,
        record: &RunRecord,
        mut see: impl FnMut(&mut Self, &Block, &BlockRuns) -> Result<(), TransformRefusal>,
    ) -> Result<(), TransformRefusal> {
        for block in self.writer.word_blocks() {
            let Some(runs) = record.blocks.get(&block.range.start) else { continue };
            let is_arc = runs
                .contexts
                .iter()
                .any(|one| matches!(one.did, BlockEffect::Arc | BlockEffect::Spiral));
            if is_arc {
                see(self, &block, runs)?;
            }
        }
        Ok(())
    }

    fn refuse(&self, block: &Block, what: impl Into<String>, help: &str) -> TransformRefusal {
        TransformRefusal::new(self.writer.text, block, what, help)
    }

    fn same_arc(&self, block: &Block, runs: &BlockRuns) -> Result<(), TransformRefusal> {
        if runs.same_arc && runs.contexts.len() == 1 {
            return Ok(());
        }
        Err(self.refuse(
            block,
            format!("the block runs {} times, and its arc is not always the same", runs.count),
            "keep this form, or copy the subprogram for each use",
        ))
    }

    /// The radius word; `None` where a radius would not say enough.
    fn radius(&self, _: &Block, runs: &BlockRuns) -> Option<String> {
        let shape = runs.first.shape?;
        let sweep = shape.sweep.abs();
        let half = std::f64::consts::PI;
        let is_unsound = (sweep - half).abs() < HALF_CIRCLE_TOLERANCE_RAD
            || sweep > 2.0 * half - FULL_CIRCLE_TOLERANCE_RAD
            || (shape.radius_from - shape.radius_to).abs() > 0.01
            || runs.first.context.did != BlockEffect::Arc;
        if is_unsound {
            return None;
        }
        let radius = if sweep > half { -shape.radius_from } else { shape.radius_from };
        let number = self.writer.length(radius, runs.first.context.units, None, 0);
        let registers = self.writer.control.table.lexicon.registers;
        let sign = if registers && radius >= 0.0 { "+" } else { "" };
        Some(if registers { format!("R0{sign}{number}") } else { format!("R{number}") })
    }

    fn center(&self, block: &Block, runs: &BlockRuns) -> Result<String, TransformRefusal> {
        let run = &runs.first;
        if run.context.arc_center == ArcCenter::Absolute && !runs.same {
            return Err(self.refuse(
                block,
                "the block runs at several positions, and the centre is absolute here",
                "keep the radius",
            ));
        }
        let Some(shape) = run.shape else { return Ok(String::new()) };
        Ok(center_words(&self.writer, &shape, run.from, run.context.arc_center, run.context.units)
            .join(self.writer.style.gap()))
    }

    fn replace(&mut self, old: &[Word], new: &str, reason: &'static str) {
        self.outcome.edits.extend(replace_words(self.writer.text, old, new, reason));
    }

    fn chords(
        &mut self,
        block: &Block,
        runs: &BlockRuns,
        tolerance: f64,
    ) -> Result<(), TransformRefusal> {
        const REASON: &str = "the arc as chords";
        let run = &runs.first;
        self.same_arc(block, runs)?;
        if !runs.same && !run.context.incremental {
            return Err(self.refuse(
                block,
                format!("the block runs {} times, from different places", runs.count),
                "copy the subprogram for each use, or write its moves in G91",
            ));
        }
        if run.context.side != CompensationSide::Off
            || run.context.feed_mode == FeedMode::InverseTime
        {
            return Err(self.refuse(
                block,
                "cutter compensation or G93 is active, and both depend on single blocks",
                "keep these arcs",
            ));
        }
        if run.moves > 1 {
            return Err(self.refuse(
                block,
                format!("the block makes {} moves", run.moves),
                "write the moves out",
            ));
        }
        let linear = self.writer.control.table.g_codes.iter();
        let linear = linear.clone().find(|row| row.action == Action::Motion(MotionCode::Linear));
        let (Some(shape), Some(linear), Some(tail)) =
            (run.shape, linear, tail(self.writer.text, block))
        else {
            return Err(self.refuse(
                block,
                "something else follows the block on its line",
                "write each block on a line of its own",
            ));
        };
        let points = corners(run, &shape, tolerance)
            .map_err(|error| self.refuse(block, error, "allow a larger tolerance"))?;
        let lines = self.moves(run, &points);
        let context = &run.context;
        let roles = roles(block, context, self.writer.control);
        let mut is_coded = false;
        for (word, action) in actions(block, self.writer.control) {
            let is_arc = matches!(
                action,
                Action::Motion(MotionCode::ArcCw)
                    | Action::Motion(MotionCode::ArcCcw)
                    | Action::Motion(MotionCode::SpiralCw)
                    | Action::Motion(MotionCode::SpiralCcw)
            );
            if is_arc {
                is_coded = true;
                self.outcome.edits.push(WordEdit::new(
                    word.range,
                    self.writer.code(word, linear.code),
                    REASON,
                ));
            }
        }
        let words: Vec<Word> = block
            .words
            .iter()
            .zip(&roles)
            .filter(|(word, role)| {
                let is_shape = matches!(
                    role,
                    NumberRole::Place(_)
                        | NumberRole::Distance(_)
                        | NumberRole::Center(_)
                        | NumberRole::Spoke(_)
                        | NumberRole::Length
                );
                is_shape || b"PLQ".contains(&word.letter)
            })
            .map(|(word, _)| *word)
            .collect();
        let gap = self.writer.style.gap();
        let first = if is_coded {
            lines[0].clone()
        } else {
            format!("{}{gap}{}", linear.name(b'G'), lines[0])
        };
        self.replace(&words, &first, REASON);
        let end = newline(self.writer.text);
        let at = block.range.end + tail.len() as u32;
        let more: String = lines[1..].iter().map(|line| format!("{end}{line}{tail}")).collect();
        if !more.is_empty() {
            self.outcome.edits.push(WordEdit::insert(at, more, REASON));
        }
        Ok(())
    }

    /// A row of words for each chord: the axes that change.
    fn moves(&self, run: &BlockPass, points: &[Vec3]) -> Vec<String> {
        let units = run.context.units;
        let written = |mm: f64| -> (String, f64) {
            let number = self.writer.length(mm, units, None, 0);
            let value = number.parse::<f64>().unwrap_or(0.0) * units.mm();
            (number, value)
        };
        let mut at = points[0].to_array();
        let mut lines = Vec::new();
        for point in &points[1..] {
            let mut words = BlockWords::default();
            for (axis, target) in point.to_array().into_iter().enumerate() {
                if (target - at[axis]).abs() < 1e-9 {
                    continue;
                }
                // What was rounded before is made up for.
                let base = if run.context.incremental { at[axis] } else { 0.0 };
                let (number, value) = written(target - base);
                at[axis] = base + value;
                words.push(format!("{}{number}", char::from(b"XYZ"[axis])));
            }
            lines.push(words.join(self.writer.style.gap()));
        }
        lines.retain(|line| !line.is_empty());
        if lines.is_empty() {
            lines.push(String::new());
        }
        lines
    }
}

/// The corners of an arc's chords, mm.
fn corners(run: &BlockPass, shape: &ArcShape, tolerance: f64) -> Result<Vec<Vec3>, String> {
    let point = |at: PerAxis<f64>| Vec3::new(at[0], at[1], at[2]);
    let center = (shape.center[0], shape.center[1]);
    let fit =
        spiral_from_center(shape.plane, point(run.from), point(run.to), center, shape.sweep, 0.0);
    let chords =
        fit.curve.chords(tolerance, Placement::Inscribed).map_err(|error| error.to_string())?;
    Ok(chords.collect())
}

/// The centre words of an arc by the active rule.
pub(super) fn center_words(
    writer: &WordWriter,
    shape: &ArcShape,
    from: PerAxis<f64>,
    rule: ArcCenter,
    units: Units,
) -> BlockWords {
    let (a, b, _) = shape.plane.axes();
    // I stands before J before K.
    let mut axes = [(a, shape.center[0]), (b, shape.center[1])];
    if shape.plane == Plane::Zx {
        axes.reverse();
    }
    let mut words = BlockWords::default();
    for (axis, center) in axes {
        let value = match rule {
            ArcCenter::FromStart => center - from[axis],
            ArcCenter::FromCenter => from[axis] - center,
            ArcCenter::Absolute => center,
        };
        let number = writer.length(value, units, None, 0);
        words.push(format!("{}{number}", char::from(b"IJK"[axis])));
    }
    words
}
