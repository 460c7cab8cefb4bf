//! A program changed in place: moved, turned, mirrored, scaled, in other units, at other feeds, with
//! arcs in another form, with fewer blocks, with other numbers.
//!
//! The text is run first, so that every word is changed by what it means where it stands; a block that
//! runs in several ways is changed only where one change is right for all of them. The new text is run
//! as well, and compared with the old path, taken where it is meant to go.

mod arcs;
mod edit;
mod edit_proof;
mod fit;
mod heights;
mod lines;
mod map;
mod number;
mod optimize;
mod rates;
mod record;
mod roles;
mod rows;
mod text;
mod units;
mod writer;

use chordal::Job;
use chordal::control::{Action, LengthCode, ModeCode, MotionCode, OnceCode, SurfaceCode, Units};
use chordal::geometry::{Transform, Vec3};
use chordal_compare::{Category, ComparisonOptions, ComparisonVerdict, RunMapping};

use crate::sides::prove_other_sides;
use crate::source::first_text;
use crate::word_address::refuse_other_languages;
use crate::{Certificate, Change, prove_mapped};

pub use edit::TransformRefusal;
pub use heights::{HeightCorrection, HeightMap, HeightOptions, MapError, warp};
pub use optimize::{
    ChipLimit, FeedProof, NotSplit, OptimizeError, OptimizeOptions, OptimizedProgram, SplitResult,
    ToolChips, optimize,
};

/// Said where a proof ends at something that is not followed.
const NOT_FOLLOWED: &str = "the program does something that is not followed, so nothing can be proved: \
                            `chordal check` says from which line on";

/// How arcs are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArcForm {
    /// By R.
    Radius,
    /// By I, J and K.
    Center,
}

/// A change of a program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TransformStep {
    /// Moves the path, mm.
    Shift([f64; 3]),
    /// Turns it about Z at a place of X and Y (mm), radians counter-clockwise.
    Rotate {
        /// By how much.
        angle: f64,
        /// About where.
        about: [f64; 2],
    },
    /// Changes the sign of X.
    MirrorX,
    /// Changes the sign of Y.
    MirrorY,
    /// Multiplies every length; above zero.
    Scale(f64),
    /// Writes lengths in this unit.
    Units(Units),
    /// Multiplies feeds and spindle speeds.
    Rates {
        /// What feeds of cuts are multiplied by.
        feed: f64,
        /// What spindle speeds, and feeds of taps, are multiplied by.
        speed: f64,
    },
    /// Writes arcs by radius or by centre.
    Arcs(ArcForm),
    /// Writes arcs and spirals as chords within so many mm.
    Chords(f64),
    /// Writes rows of chords as tangent lines and arcs.
    Fit {
        /// So far off the chords at most, mm.
        tolerance: f64,
        /// Feeds of one row may differ by this part of the fastest; the slowest is written.
        feed_tolerance: f64,
    },
    /// Leaves out chords, so that the path stays within so many mm.
    Simplify(f64),
    /// Numbers anew the blocks that have numbers.
    Renumber {
        /// Of the first block of each program.
        first: u32,
        /// From one to the next.
        step: u32,
    },
    /// Takes out block numbers that nothing goes to.
    NoNumbers,
    /// Takes out comments.
    StripComments,
    /// Makes the text no longer than so many bytes, by what does nothing.
    Shrink(usize),
}

impl TransformStep {
    /// A step by its name and its numbers, as another language gives it: lengths in mm, angles in
    /// degrees; `None` where there is no such step.
    pub fn of(name: &str, numbers: &[f64]) -> Option<TransformStep> {
        let is_length = |value: f64| value > 0.0 && value.is_finite();
        let is_count = |value: f64| value >= 0.0 && value <= f64::from(u32::MAX);
        if numbers.iter().any(|number| !number.is_finite()) {
            return None;
        }
        Some(match (name, numbers) {
            ("shift", [x, y, z]) => TransformStep::Shift([*x, *y, *z]),
            ("rotate", [degrees, x, y]) => {
                TransformStep::Rotate { angle: degrees.to_radians(), about: [*x, *y] }
            }
            ("mirror-x", []) => TransformStep::MirrorX,
            ("mirror-y", []) => TransformStep::MirrorY,
            ("scale", [factor]) if is_length(*factor) => TransformStep::Scale(*factor),
            ("mm", []) => TransformStep::Units(Units::Millimetre),
            ("inch", []) => TransformStep::Units(Units::Inch),
            ("rates", [feed, speed]) if is_length(*feed) && is_length(*speed) => {
                TransformStep::Rates { feed: *feed, speed: *speed }
            }
            ("arcs-radius", []) => TransformStep::Arcs(ArcForm::Radius),
            ("arcs-center", []) => TransformStep::Arcs(ArcForm::Center),
            ("chords", [tolerance]) if is_length(*tolerance) => TransformStep::Chords(*tolerance),
            ("fit", [tolerance, feed_tolerance])
                if is_length(*tolerance) && (0.0..1.0).contains(feed_tolerance) =>
            {
                TransformStep::Fit { tolerance: *tolerance, feed_tolerance: *feed_tolerance }
            }
            ("simplify", [tolerance]) if is_length(*tolerance) => {
                TransformStep::Simplify(*tolerance)
            }
            ("renumber", [first, step]) if is_count(*first) && is_count(*step) => {
                TransformStep::Renumber { first: *first as u32, step: *step as u32 }
            }
            ("no-numbers", []) => TransformStep::NoNumbers,
            ("strip-comments", []) => TransformStep::StripComments,
            ("shrink", [most]) if is_count(*most) => TransformStep::Shrink(*most as usize),
            _ => return None,
        })
    }

    /// It changes words of places and lengths, or what moves there are.
    fn reads_the_path(&self) -> bool {
        match self {
            TransformStep::Shift(_)
            | TransformStep::Rotate { .. }
            | TransformStep::MirrorX
            | TransformStep::MirrorY
            | TransformStep::Scale(_)
            | TransformStep::Units(_)
            | TransformStep::Arcs(_)
            | TransformStep::Chords(_)
            | TransformStep::Fit { .. }
            | TransformStep::Simplify(_) => true,
            TransformStep::Renumber { .. }
            | TransformStep::NoNumbers
            | TransformStep::StripComments
            | TransformStep::Shrink(_)
            | TransformStep::Rates { .. } => false,
        }
    }

    fn run(&self, job: &Job) -> Result<StepOutcome, TransformRefusal> {
        if self.reads_the_path() {
            refuse_what_has_no_roles(job)?;
        }
        let xy = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
        match *self {
            TransformStep::Shift(by) => {
                map::map(job, &Transform::translation(Vec3::from_array(by)))
            }
            TransformStep::Rotate { angle, about } => {
                map::map(job, &Transform::rotation_about(xy(about), Vec3::Z, angle))
            }
            TransformStep::MirrorX => map::map(job, &Transform::mirror(Vec3::X, Vec3::ZERO)),
            TransformStep::MirrorY => map::map(job, &Transform::mirror(Vec3::Y, Vec3::ZERO)),
            TransformStep::Scale(factor) => {
                map::map(job, &Transform::scale(factor).unwrap_or_default())
            }
            TransformStep::Units(to) => units::units(job, to),
            TransformStep::Arcs(form) => arcs::form(job, form),
            TransformStep::Chords(tolerance) => arcs::chords(job, tolerance),
            TransformStep::Fit { tolerance, feed_tolerance } => {
                fit::fit(job, tolerance, feed_tolerance)
            }
            TransformStep::Simplify(tolerance) => fit::thin(job, tolerance),
            TransformStep::Renumber { first, step } => text::renumber(job, first, step),
            TransformStep::NoNumbers => Ok(text::no_numbers(job)),
            TransformStep::StripComments => Ok(text::strip_comments(job)),
            TransformStep::Shrink(most) => text::shrink(job, most),
            TransformStep::Rates { feed, speed } => rates::rates(job, feed, speed),
        }
    }
}

/// The words of splines are not transformed: P and Q are lengths in one code and a weight in another. Nor are those of polar and
/// cylindrical interpolation, where a letter is a length that is an angle elsewhere.
fn refuse_what_has_no_roles(job: &Job) -> Result<(), TransformRefusal> {
    let writer = writer::WordWriter::new(job);
    for block in writer.word_blocks() {
        let mut actions = roles::actions(&block, writer.control);
        if let Some((what, help)) = actions.find_map(|(_, action)| without_roles(action)) {
            return Err(TransformRefusal::new(writer.text, &block, what, help));
        }
    }
    Ok(())
}

fn without_roles(action: Action) -> Option<(&'static str, &'static str)> {
    if let Action::Motion(MotionCode::Spline(_) | MotionCode::SplineEnd) = action {
        let help = "write the splines as lines or arcs first, or move the work offset in place of the program";
        return Some(("the words of splines are not transformed", help));
    }
    if action == Action::Once(OnceCode::Engraving) {
        let help = "move the work offset in place of the program";
        return Some(("the words of an engraved text are not transformed", help));
    }
    if let Action::Once(OnceCode::Surface(code)) = action {
        let help = "move the work offset, or the angle of the rotary axis, in place of the program";
        let what = "coordinates on a face or a cylinder are not transformed";
        return (code != SurfaceCode::FaceOff).then_some((what, help));
    }
    let is_on_part = matches!(
        action,
        Action::Length(
            LengthCode::ToolCenter | LengthCode::ToolCenterByVector | LengthCode::AlongTool,
        ) | Action::Once(OnceCode::TiltedPlane(_))
            | Action::Mode(ModeCode::FixtureError)
    );
    if is_on_part {
        let help = "move the work offset in place of the program";
        return Some(("coordinates of a tilted tool or plane are not transformed", help));
    }
    None
}

/// What a step comes to.
#[derive(Debug, Default)]
struct StepOutcome {
    edits: Vec<edit::WordEdit>,
    /// The text and its changes, where they were made one after the other.
    whole: Option<(Vec<u8>, Vec<Change>)>,
    notes: Vec<String>,
    /// What the new path is meant to be.
    mapping: RunMapping,
    /// How far it may be off, mm.
    tolerance_mm: f64,
    feed_tolerance: f64,
    speed_tolerance: f64,
    /// Differences that no writing can take away.
    expected: Vec<Category>,
    /// The proof of the edits, where it was made already.
    certificate: Option<Certificate>,
}

impl StepOutcome {
    /// How its proof compares.
    fn options(&self) -> ComparisonOptions {
        ComparisonOptions {
            tolerance_mm: self.tolerance_mm,
            feed_tolerance: self.feed_tolerance.max(ComparisonOptions::default().feed_tolerance),
            speed_tolerance: self.speed_tolerance.max(ComparisonOptions::default().speed_tolerance),
            in_step: true,
            unknown_in_step: true,
            separate_sides: true,
            ..ComparisonOptions::default()
        }
    }

    /// Reports blocks that never ran.
    fn note_idle(&mut self, lines: &[u32]) {
        if let [first, ..] = lines {
            let count = lines.len();
            let blocks = if count == 1 { "block is" } else { "blocks are" };
            self.notes.push(format!(
                "{count} {blocks} never run, left unchanged, the first on line {first}"
            ));
        }
    }
}

/// A program after its steps.
#[derive(Debug)]
pub struct TransformedProgram {
    /// The new text.
    pub text: Vec<u8>,
    /// What was changed, step by step; lines are those of the text before each step.
    pub changes: Vec<Change>,
    /// What is to be known in addition to it.
    pub notes: Vec<String>,
    /// The new path compared with the old one.
    pub certificate: Certificate,
    meant: IntendedMotion,
}

/// What the new path is meant to be.
#[derive(Debug)]
pub(crate) struct IntendedMotion {
    options: ComparisonOptions,
    expected: Vec<Category>,
    mapping: RunMapping,
}

impl TransformedProgram {
    /// Proves another text in place of the one that came out, as one that was changed by hand.
    pub fn prove(&self, job: &Job, text: Vec<u8>) -> Certificate {
        self.meant.prove(job, &job.with_text(text))
    }
}

impl IntendedMotion {
    fn prove(&self, job: &Job, new: &Job) -> Certificate {
        prove_mapped(job, new, &self.options, &self.expected, &self.mapping)
    }
}

/// Changes the first text of a job, step by step, and proves it.
///
/// # Errors
/// The first block that no change would be right for.
pub fn transform(
    job: &Job,
    steps: &[TransformStep],
) -> Result<TransformedProgram, TransformRefusal> {
    refuse_other_languages(job)?;
    let mut text = first_text(job).to_vec();
    let mut all = StepOutcome::default();
    let mut changes = Vec::new();
    for step in steps {
        let now = job.with_text(text);
        let mut outcome = step.run(&now)?;
        let (new, mut made) = match outcome.whole.take() {
            Some(whole) => whole,
            None => {
                let new = edit::apply(first_text(&now), &mut outcome.edits);
                (new, edit::changes(first_text(&now), &outcome.edits))
            }
        };
        text = new;
        changes.append(&mut made);
        all.notes.append(&mut outcome.notes);
        all.tolerance_mm =
            all.tolerance_mm * outcome.mapping.path.scale_factor() + outcome.tolerance_mm;
        all.expected.append(&mut outcome.expected);
        all.feed_tolerance = all.feed_tolerance.max(outcome.feed_tolerance);
        all.speed_tolerance = all.speed_tolerance.max(outcome.speed_tolerance);
        all.certificate = outcome.certificate.filter(|_| steps.len() == 1);
        all.mapping = RunMapping {
            path: all.mapping.path.then(&outcome.mapping.path),
            feed: all.mapping.feed * outcome.mapping.feed,
            speed: all.mapping.speed * outcome.mapping.speed,
        };
    }
    let new = job.with_text(text.clone());
    let meant =
        IntendedMotion { options: all.options(), expected: all.expected, mapping: all.mapping };
    let mut certificate = all.certificate.unwrap_or_else(|| meant.prove(job, &new));
    let compared =
        prove_other_sides([job, &new], &mut certificate, |old, new| meant.prove(old, new));
    all.notes.extend(compared);
    let comparison = &mut certificate.comparison;
    let moves = comparison.moves.iter().any(|moves| *moves > 0);
    if comparison.max_distance_mm.is_none() && moves && text != first_text(job) {
        // Nothing was compared with anything: that is no proof.
        comparison.verdict = ComparisonVerdict::Different;
        all.notes.push(
            "no move lies between known positions, so nothing can be proved: program X, Y and Z \
             before the first cut"
                .into(),
        );
    }
    if comparison.verdict == ComparisonVerdict::NotVerified {
        all.notes.push(NOT_FOLLOWED.into());
    }
    Ok(TransformedProgram { text, changes, notes: all.notes, certificate, meant })
}
