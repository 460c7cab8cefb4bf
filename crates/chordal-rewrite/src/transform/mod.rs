//! A program changed in place: moved, turned, mirrored, scaled, in other units, at other feeds, with
//! arcs in another form, with fewer blocks, with other numbers.
//!
//! The text is run first, so that every word is changed by what it means where it stands; a block that
//! runs in several ways is changed only where one change is right for all of them. The new text is run
//! as well, and compared with the old path, taken where it is meant to go.

mod arcs;
mod edit;
mod fit;
mod heights;
mod lines;
mod map;
mod number;
mod optimize;
mod proved;
mod rates;
mod record;
mod roles;
mod rows;
mod text;
mod units;
mod writer;

use chordal::Job;
use chordal::control::{Action, MotionCode, OnceCode, SurfaceCode, Units};
use chordal::diagnostics::FileId;
use chordal::geometry::{Transform, Vec3};
use chordal::syntax::{Block, BlockKind, BlockReader};
use chordal_compare::{Category, Mapping, Options, Verdict};

use crate::sides::prove_other_sides;
use crate::source::first_text;
use crate::{Certificate, Change, prove_mapped};

pub use edit::Refusal;
pub use heights::{HeightMap, MapError, Warp, Warped, warp};
pub use optimize::{
    ChipLimit, FeedProof, NotSplit, OptimizeError, OptimizeOptions, Optimized, Splits, ToolChips,
    optimize,
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
pub enum Step {
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

impl Step {
    /// A step by its name and its numbers, as another language gives it: lengths in mm, angles in
    /// degrees; `None` where there is no such step.
    pub fn of(name: &str, numbers: &[f64]) -> Option<Step> {
        let is_length = |value: f64| value > 0.0 && value.is_finite();
        let is_count = |value: f64| value >= 0.0 && value <= f64::from(u32::MAX);
        if numbers.iter().any(|number| !number.is_finite()) {
            return None;
        }
        Some(match (name, numbers) {
            ("shift", [x, y, z]) => Step::Shift([*x, *y, *z]),
            ("rotate", [degrees, x, y]) => {
                Step::Rotate { angle: degrees.to_radians(), about: [*x, *y] }
            }
            ("mirror-x", []) => Step::MirrorX,
            ("mirror-y", []) => Step::MirrorY,
            ("scale", [factor]) if is_length(*factor) => Step::Scale(*factor),
            ("mm", []) => Step::Units(Units::Millimetre),
            ("inch", []) => Step::Units(Units::Inch),
            ("rates", [feed, speed]) if is_length(*feed) && is_length(*speed) => {
                Step::Rates { feed: *feed, speed: *speed }
            }
            ("arcs-radius", []) => Step::Arcs(ArcForm::Radius),
            ("arcs-center", []) => Step::Arcs(ArcForm::Center),
            ("chords", [tolerance]) if is_length(*tolerance) => Step::Chords(*tolerance),
            ("fit", [tolerance, feed_tolerance])
                if is_length(*tolerance) && (0.0..1.0).contains(feed_tolerance) =>
            {
                Step::Fit { tolerance: *tolerance, feed_tolerance: *feed_tolerance }
            }
            ("simplify", [tolerance]) if is_length(*tolerance) => Step::Simplify(*tolerance),
            ("renumber", [first, step]) if is_count(*first) && is_count(*step) => {
                Step::Renumber { first: *first as u32, step: *step as u32 }
            }
            ("no-numbers", []) => Step::NoNumbers,
            ("strip-comments", []) => Step::StripComments,
            ("shrink", [most]) if is_count(*most) => Step::Shrink(*most as usize),
            _ => return None,
        })
    }

    /// It changes words of places and lengths, or what moves there are.
    fn reads_the_path(&self) -> bool {
        match self {
            Step::Shift(_)
            | Step::Rotate { .. }
            | Step::MirrorX
            | Step::MirrorY
            | Step::Scale(_)
            | Step::Units(_)
            | Step::Arcs(_)
            | Step::Chords(_)
            | Step::Fit { .. }
            | Step::Simplify(_) => true,
            Step::Renumber { .. }
            | Step::NoNumbers
            | Step::StripComments
            | Step::Shrink(_)
            | Step::Rates { .. } => false,
        }
    }

    fn run(&self, job: &Job) -> Result<Outcome, Refusal> {
        if self.reads_the_path() {
            refuse_what_has_no_roles(job)?;
        }
        let xy = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
        match *self {
            Step::Shift(by) => map::map(job, &Transform::translation(Vec3::from_array(by))),
            Step::Rotate { angle, about } => {
                map::map(job, &Transform::rotation_about(xy(about), Vec3::Z, angle))
            }
            Step::MirrorX => map::map(job, &Transform::mirror(Vec3::X, Vec3::ZERO)),
            Step::MirrorY => map::map(job, &Transform::mirror(Vec3::Y, Vec3::ZERO)),
            Step::Scale(factor) => map::map(job, &Transform::scale(factor).unwrap_or_default()),
            Step::Units(to) => units::units(job, to),
            Step::Arcs(form) => arcs::form(job, form),
            Step::Chords(tolerance) => arcs::chords(job, tolerance),
            Step::Fit { tolerance, feed_tolerance } => fit::fit(job, tolerance, feed_tolerance),
            Step::Simplify(tolerance) => fit::thin(job, tolerance),
            Step::Renumber { first, step } => text::renumber(job, first, step),
            Step::NoNumbers => Ok(text::no_numbers(job)),
            Step::StripComments => Ok(text::strip_comments(job)),
            Step::Shrink(most) => text::shrink(job, most),
            Step::Rates { feed, speed } => rates::rates(job, feed, speed),
        }
    }
}

/// The words of splines are not transformed: P and Q are lengths in one code and a weight in another. Nor are those of polar and
/// cylindrical interpolation, where a letter is a length that is an angle elsewhere.
fn refuse_what_has_no_roles(job: &Job) -> Result<(), Refusal> {
    let writer = writer::Writer::new(job);
    let mut reader = BlockReader::new(writer.text, FileId(0), writer.control.table.lexicon);
    let mut block = Block::new();
    while reader.read(&mut block) {
        if block.kind != BlockKind::Words {
            continue;
        }
        let mut actions = roles::actions(&block, writer.control);
        if let Some((what, help)) = actions.find_map(|(_, action)| without_roles(action)) {
            return Err(Refusal::new(writer.text, &block, what, help));
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
    None
}

/// What a step comes to.
#[derive(Debug, Default)]
struct Outcome {
    edits: Vec<edit::Edit>,
    /// The text and its changes, where they were made one after the other.
    whole: Option<(Vec<u8>, Vec<Change>)>,
    notes: Vec<String>,
    /// What the new path is meant to be.
    mapping: Mapping,
    /// How far it may be off, mm.
    tolerance_mm: f64,
    feed_tolerance: f64,
    speed_tolerance: f64,
    /// Differences that no writing can take away.
    expected: Vec<Category>,
    /// The proof of the edits, where it was made already.
    certificate: Option<Certificate>,
}

impl Outcome {
    /// How its proof compares.
    fn options(&self) -> Options {
        Options {
            tolerance_mm: self.tolerance_mm,
            feed_tolerance: self.feed_tolerance.max(Options::default().feed_tolerance),
            speed_tolerance: self.speed_tolerance.max(Options::default().speed_tolerance),
            in_step: true,
            unknown_in_step: true,
            sides_apart: true,
            ..Options::default()
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
pub struct Transformed {
    /// The new text.
    pub text: Vec<u8>,
    /// What was changed, step by step; lines are those of the text before each step.
    pub changes: Vec<Change>,
    /// What is to be known in addition to it.
    pub notes: Vec<String>,
    /// The new path compared with the old one.
    pub certificate: Certificate,
    meant: Meant,
}

/// What the new path is meant to be.
#[derive(Debug)]
pub(crate) struct Meant {
    options: Options,
    expected: Vec<Category>,
    mapping: Mapping,
}

impl Transformed {
    /// Proves another text in place of the one that came out, as one that was changed by hand.
    pub fn prove(&self, job: &Job, text: Vec<u8>) -> Certificate {
        self.meant.prove(job, &job.with_text(text))
    }
}

impl Meant {
    fn prove(&self, job: &Job, new: &Job) -> Certificate {
        prove_mapped(job, new, &self.options, &self.expected, &self.mapping)
    }
}

/// Changes the first text of a job, step by step, and proves it.
///
/// # Errors
/// The first block that no change would be right for.
pub fn transform(job: &Job, steps: &[Step]) -> Result<Transformed, Refusal> {
    let mut text = first_text(job).to_vec();
    let mut all = Outcome::default();
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
        all.mapping = Mapping {
            path: all.mapping.path.then(&outcome.mapping.path),
            feed: all.mapping.feed * outcome.mapping.feed,
            speed: all.mapping.speed * outcome.mapping.speed,
        };
    }
    let new = job.with_text(text.clone());
    let meant = Meant { options: all.options(), expected: all.expected, mapping: all.mapping };
    let mut certificate = all.certificate.unwrap_or_else(|| meant.prove(job, &new));
    let compared =
        prove_other_sides([job, &new], &mut certificate, |old, new| meant.prove(old, new));
    all.notes.extend(compared);
    let comparison = &mut certificate.comparison;
    let moves = comparison.moves.iter().any(|moves| *moves > 0);
    if comparison.max_distance_mm.is_none() && moves && text != first_text(job) {
        // Nothing was compared with anything: that is no proof.
        comparison.verdict = Verdict::Different;
        all.notes.push(
            "no move lies between known positions, so nothing can be proved: program X, Y and Z \
             before the first cut"
                .into(),
        );
    }
    if comparison.verdict == Verdict::NotVerified {
        all.notes.push(NOT_FOLLOWED.into());
    }
    Ok(Transformed { text, changes, notes: all.notes, certificate, meant })
}
