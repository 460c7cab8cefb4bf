//! Moving, turning, mirroring and scaling a program, word by word.

use chordal::control::{Action, AfterCode, ModeCode, MotionCode, OnceCode};
use chordal::control::{AxisMask, RapidPath};
use chordal::geometry::{Plane, Transform, Vec3};
use chordal::syntax::{Block, Word, WordValue};
use chordal::{Control, Job};
use chordal_compare::{Category, RunMapping};

use super::StepOutcome;
use super::edit::{TransformRefusal, WordEdit};
use super::record::{BlockEffect, BlockRuns, ReadingContext, RunRecord};
use super::roles::{LatheBlockSort, NumberRole, actions, drilling_axis, is_fixed, roles};
use super::writer::WordWriter;

/// A similarity that leaves Z an axis by itself, taken apart.
struct PlaneMap {
    /// What becomes of X and Y: `plane[row][column]`.
    plane: [[f64; 2]; 2],
    z: f64,
    shift: [f64; 3],
    scale: f64,
    /// X and Y mix.
    turns: bool,
}

impl PlaneMap {
    fn of(transform: &Transform) -> PlaneMap {
        // A quarter turn leaves 6e-17 where a zero is due.
        let snap = |value: f64| {
            let near = value.round();
            if (value - near).abs() < 1e-15 { near } else { value }
        };
        let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| transform.apply_vector(axis));
        let plane = [[snap(x.x), snap(y.x)], [snap(x.y), snap(y.y)]];
        PlaneMap {
            plane,
            z: snap(z.z),
            shift: transform.apply_point(Vec3::ZERO).to_array(),
            scale: transform.scale_factor(),
            turns: plane[0][1] != 0.0 || plane[1][0] != 0.0,
        }
    }

    fn factor(&self, axis: usize) -> f64 {
        [self.plane[0][0], self.plane[1][1], self.z][axis]
    }

    /// X becomes Y and Y becomes X, each alone: a turn by 90° or 270°.
    fn swaps_axes(&self) -> bool {
        let [[a, _], [_, d]] = self.plane;
        self.turns && a == 0.0 && d == 0.0
    }

    /// The axis that an axis becomes, where each of them becomes one.
    fn image(&self, axis: usize) -> usize {
        if axis < 2 && self.swaps_axes() { 1 - axis } else { axis }
    }

    /// What a way along an axis is multiplied by to be one along its image.
    fn image_factor(&self, axis: usize) -> f64 {
        if axis == 2 { self.z } else { self.plane[self.image(axis)][axis] }
    }

    /// Arcs in a plane turn the other way in the plane that it becomes.
    fn is_mirrored(&self, plane: Plane) -> bool {
        let [[a, b], [c, d]] = self.plane;
        // ZX becomes YZ with Z first, and YZ becomes ZX with Z last: seen from the other side.
        let sign = match plane {
            Plane::Xy => a * d - b * c,
            Plane::Zx if self.swaps_axes() => -c * self.z,
            Plane::Yz if self.swaps_axes() => -b * self.z,
            Plane::Zx => a * self.z,
            Plane::Yz => d * self.z,
        };
        sign < 0.0
    }

    /// Only X, Y and Z are moved.
    fn is_shift(&self) -> bool {
        self.plane == [[1.0, 0.0], [0.0, 1.0]] && self.z == 1.0
    }
}

/// The edits that take the path where a transform takes it.
pub(super) fn map(job: &Job, transform: &Transform) -> Result<StepOutcome, TransformRefusal> {
    refuse_other_part(job, &PlaneMap::of(transform))?;
    let record = RunRecord::with_contours(job);
    let mapper = MapWriter { writer: WordWriter::new(job), map: PlaneMap::of(transform) };
    let writer = &mapper.writer;
    let mut outcome = StepOutcome {
        mapping: RunMapping { path: *transform, ..RunMapping::default() },
        ..StepOutcome::default()
    };
    let mut idle = Vec::new();
    for block in writer.word_blocks() {
        match record.blocks.get(&block.range.start) {
            Some(runs) => outcome.edits.extend(mapper.block(&block, runs)?),
            None if "XYZ".bytes().any(|axis| block.letters().has(axis)) => idle.push(block.line),
            None => {}
        }
    }
    if let Some((file, line)) = record.in_other_text {
        let name = job.sources().get(file).map_or("", |source| source.name());
        outcome
            .notes
            .push(format!("line {line} of {name} moves, too: that file is left unchanged"));
    }
    outcome.note_idle(&idle);
    // From a place that is not known a way is not known, moved or not.
    outcome.expected.push(Category::Unknown);
    if mapper.map.turns && job.rules().rapid == RapidPath::DogLeg {
        // A rapid along one axis moves two after a turn, each at its own speed.
        outcome.expected.push(Category::RapidPath);
        outcome.notes.push(
            "rapids are dog-legs on this control: after the turn they bend at another point".into(),
        );
    }
    outcome.tolerance_mm = writer.tolerance_mm();
    Ok(outcome)
}

/// X of a lathe is measured from the axis of the spindle: moved along it, or turned, a path makes another part.
fn refuse_other_part(job: &Job, map: &PlaneMap) -> Result<(), TransformRefusal> {
    let turns = job.profile().turns;
    if !turns || (map.shift[..2] == [0.0; 2] && !map.turns && map.plane[1][1] == 1.0) {
        return Ok(());
    }
    if !map.turns && map.scale != 1.0 && map.shift == [0.0; 3] {
        return Ok(());
    }
    Err(TransformRefusal::new(
        crate::source::first_text(job),
        &Block::new(),
        "on a lathe X is measured from the axis of the spindle: this makes another part",
        "a lathe program can be shifted along Z, mirrored in X, scaled, and written in the other unit",
    ))
}

struct MapWriter<'a> {
    writer: WordWriter<'a>,
    map: PlaneMap,
}

impl MapWriter<'_> {
    fn refuse(&self, block: &Block, what: impl Into<String>, help: &str) -> TransformRefusal {
        TransformRefusal::new(self.writer.text, block, what, help)
    }

    /// One edit that is right for every run of the block.
    fn block(&self, block: &Block, runs: &BlockRuns) -> Result<Vec<WordEdit>, TransformRefusal> {
        let edits = runs.edits_of_all(|context| self.in_context(block, runs, context))?;
        edits.ok_or_else(|| {
            self.refuse(
                block,
                "the block runs in different states, and no single change is right for all",
                "write the code that differs (G90 or G91, units, plane) into the block, or copy the \
                 subprogram for each use",
            )
        })
    }

    fn in_context(
        &self,
        block: &Block,
        runs: &BlockRuns,
        context: &ReadingContext,
    ) -> Result<Vec<WordEdit>, TransformRefusal> {
        let map = &self.map;
        if map.scale != 1.0 && context.side != chordal::control::CompensationSide::Off {
            return Err(self.refuse(
                block,
                "cutter compensation is on: the tool radius does not scale with the path",
                "scale the path without compensation",
            ));
        }
        let is_turned = self.writer.control.table.turns();
        if is_turned && map.scale != 1.0 {
            let turned = LatheBlockSort::of(block, context, self.writer.control);
            if turned.is_thread() {
                return Err(self.refuse(
                    block,
                    "a thread does not scale: its lead belongs to its diameter",
                    "scale the rest, and write the thread for its new diameter",
                ));
            }
            if context.keeps_surface_speed {
                return Err(self.refuse(
                    block,
                    "a cutting speed (G96) makes other revolutions of another diameter",
                    "scale the program with spindle speeds (G97)",
                ));
            }
        }
        if is_turned && map.is_mirrored(Plane::Zx) && has_compensation(block, self.writer.control) {
            return Err(self.refuse(
                block,
                "mirrored in X, the tool of a compensated contour has another tip number",
                "mirror the contour without compensation, or set the other tip number and write it by hand",
            ));
        }
        let mut edits = Vec::new();
        self.codes(block, context, &mut edits)?;
        let roles = roles(block, context, self.writer.control);
        let is_upright = map.turns
            && match context.did {
                BlockEffect::Arc | BlockEffect::Spiral => context.plane != Plane::Xy,
                BlockEffect::Cycle => drilling_axis(context, self.writer.control) != 2,
                BlockEffect::Nothing
                | BlockEffect::Rapid
                | BlockEffect::Line
                | BlockEffect::Spline => false,
            };
        if is_upright {
            if !map.swaps_axes() {
                return Err(self.refuse(
                    block,
                    "an arc or a cycle in G18 or G19 would lie in no plane of the control",
                    "rotate by 90°, 180° or 270°, or write it in G17 or as chords (--chords)",
                ));
            }
            self.renamed(block, context, &roles, &mut edits)?;
        } else if map.turns {
            self.pairs(block, runs, context, &roles, &mut edits)?;
        }
        for (word, role) in block.words.iter().zip(&roles) {
            let (factor, plus) = match *role {
                NumberRole::Place(axis)
                | NumberRole::Distance(axis)
                | NumberRole::Center(axis)
                | NumberRole::Spoke(axis)
                    if map.turns && (axis < 2 || is_upright) =>
                {
                    continue;
                }
                NumberRole::Place(axis) | NumberRole::Center(axis) => {
                    (map.factor(axis), map.shift[axis])
                }
                NumberRole::Distance(axis) | NumberRole::Spoke(axis) => (map.factor(axis), 0.0),
                NumberRole::Length => (map.scale, 0.0),
                NumberRole::Counted if map.scale != 1.0 => {
                    let units = (context.units, context.units);
                    let text = self.writer.counted(block, word, units, map.scale)?;
                    edits.push(WordEdit::new(word.range, text, self.reason()));
                    continue;
                }
                NumberRole::Doubtful if !map.is_shift() => {
                    return Err(self.refuse(
                        block,
                        format!("`{}` may be a length or a direction", self.writer.word(word)),
                        "write the moves out, or use the control's own G68, G51 or mirror setting",
                    ));
                }
                _ => continue,
            };
            if factor == 1.0 && plus == 0.0 {
                continue;
            }
            let units = (context.units, context.units);
            let text = self.writer.scaled_length(block, word, units, factor, plus)?;
            edits.push(WordEdit::new(word.range, text, self.reason()));
        }
        Ok(edits)
    }

    fn reason(&self) -> &'static str {
        "the path is moved"
    }

    /// Codes that say left or right.
    fn codes(
        &self,
        block: &Block,
        context: &ReadingContext,
        edits: &mut Vec<WordEdit>,
    ) -> Result<(), TransformRefusal> {
        for (word, action) in actions(block, self.writer.control) {
            if makes_moves_of_its_own(action) && !self.map.is_shift() {
                return Err(self.refuse(
                    block,
                    format!(
                        "`{}` makes moves whose directions are not given by words",
                        self.writer.word(word)
                    ),
                    "write the moves out, or rotate with the control's own G68",
                ));
            }
            let plane = quarter_turned(action).filter(|_| self.map.swaps_axes());
            let mirrored = || mirrored(action).filter(|_| self.map.is_mirrored(context.plane));
            let Some(other) = plane.or_else(mirrored) else { continue };
            let mut rows = self.writer.control.g_codes();
            let Some(row) = rows.find(|row| row.action == other) else {
                return Err(self.refuse(
                    block,
                    format!(
                        "the control has no code for the image of `{}`",
                        self.writer.word(word)
                    ),
                    "write the move in another form",
                ));
            };
            let text = self.writer.code(word, row.code);
            let reason = match plane {
                Some(_) => "X becomes Y, and the plane of arcs with it",
                None => "a mirror image turns in the other direction",
            };
            edits.push(WordEdit::new(word.range, text, reason));
        }
        Ok(())
    }

    /// Words of an arc or a cycle in G18 or G19 after a quarter turn: X becomes Y, I becomes J, and the other way round.
    fn renamed(
        &self,
        block: &Block,
        context: &ReadingContext,
        roles: &[NumberRole],
        edits: &mut Vec<WordEdit>,
    ) -> Result<(), TransformRefusal> {
        for (word, role) in block.words.iter().zip(roles) {
            let (axis, is_place) = match *role {
                NumberRole::Place(axis) | NumberRole::Center(axis) => (axis, true),
                NumberRole::Distance(axis) | NumberRole::Spoke(axis) => (axis, false),
                _ => continue,
            };
            let image = self.map.image(axis);
            let (factor, plus) =
                (self.map.image_factor(axis), if is_place { self.map.shift[image] } else { 0.0 });
            let letters = [b"XYZ", b"IJK"].into_iter().find(|all| all.contains(&word.letter));
            let letter = letters.map_or(word.letter, |all| all[image]);
            if (letter, factor, plus) == (word.letter, 1.0, 0.0) {
                continue;
            }
            let units = (context.units, context.units);
            let text = match (factor, plus) {
                (1.0, 0.0) => self.writer.word(word),
                _ => self.writer.scaled_length(block, word, units, factor, plus)?,
            };
            let rest = text.get(1..).unwrap_or_default();
            let text = format!("{}{rest}", char::from(letter));
            edits.push(WordEdit::new(word.range, text, self.reason()));
        }
        Ok(())
    }

    /// Words of X and Y, which a turn mixes: where there is one, the other comes to be.
    fn pairs(
        &self,
        block: &Block,
        runs: &BlockRuns,
        context: &ReadingContext,
        roles: &[NumberRole],
        edits: &mut Vec<WordEdit>,
    ) -> Result<(), TransformRefusal> {
        let find = |role: &dyn Fn(usize) -> NumberRole| {
            [0, 1].map(|axis| {
                let place = roles.iter().rposition(|one| *one == role(axis))?;
                Some(&block.words[place])
            })
        };
        for (letters, words, is_place) in [
            (*b"XY", find(&NumberRole::Place), true),
            (*b"XY", find(&NumberRole::Distance), false),
            (*b"IJ", find(&NumberRole::Center), true),
            (*b"IJ", find(&NumberRole::Spoke), false),
        ] {
            let Some(one) = words[0].or(words[1]) else { continue };
            let mut old = [0.0; 2];
            for axis in 0..2 {
                old[axis] = match words[axis] {
                    Some(word) => self.literal(block, word, context)?,
                    None if !is_place => 0.0,
                    None if letters[0] == b'X' => self.missing(block, runs, axis)?,
                    None => runs.first.shape.map_or(f64::NAN, |shape| shape.center[axis]),
                };
            }
            let [[a, b], [c, d]] = self.map.plane;
            let shift = if is_place { self.map.shift } else { [0.0; 3] };
            let new = [a * old[0] + b * old[1] + shift[0], c * old[0] + d * old[1] + shift[1]];
            self.write_pair(context, letters, words, one, new, is_place, edits);
        }
        Ok(())
    }

    #[allow(
        clippy::too_many_arguments,
        reason = "one place, told apart from the finding of its parts"
    )]
    fn write_pair(
        &self,
        context: &ReadingContext,
        letters: [u8; 2],
        words: [Option<&Word>; 2],
        one: &Word,
        new: [f64; 2],
        is_place: bool,
        edits: &mut Vec<WordEdit>,
    ) {
        let reason = self.reason();
        let mut put_in = String::new();
        for axis in 0..2 {
            let digits = words[axis].or(Some(one)).and_then(Word::number);
            let number = self.writer.length(new[axis], context.units, digits, 0);
            match words[axis] {
                Some(word) => {
                    let text = super::edit::with_number(self.writer.text, word, &number);
                    edits.push(WordEdit::new(word.range, text, reason));
                }
                None if !is_place && number.parse() == Ok(0.0) => {}
                None => {
                    put_in = format!("{}{number}", char::from(letters[axis]));
                }
            }
        }
        if !put_in.is_empty() {
            let gap = self.writer.style.gap();
            // X and I stand before Y and J.
            let edit = if words[0].is_some() {
                WordEdit::insert(one.range.end, format!("{gap}{put_in}"), reason)
            } else {
                WordEdit::insert(one.range.start, format!("{put_in}{gap}"), reason)
            };
            edits.push(edit);
        }
    }

    fn literal(
        &self,
        block: &Block,
        word: &Word,
        context: &ReadingContext,
    ) -> Result<f64, TransformRefusal> {
        match word.value {
            WordValue::Number(number) => Ok(self.writer.length_mm(context.units, number)),
            _ => Err(self.refuse(
                block,
                format!(
                    "`{}` {}: a rotation needs its number",
                    self.writer.word(word),
                    if is_fixed(word) { "is not written as a number" } else { "is computed" },
                ),
                "rotate with the control's own G68, or write the positions as numbers",
            )),
        }
    }

    /// The coordinate that a block does not name.
    fn missing(
        &self,
        block: &Block,
        runs: &BlockRuns,
        axis: usize,
    ) -> Result<f64, TransformRefusal> {
        let letter = ["X", "Y"][axis];
        let is_return = actions(block, self.writer.control)
            .any(|(_, action)| matches!(action, Action::Once(OnceCode::ReturnToReference { .. })));
        let known: AxisMask = runs.first.known[1];
        if !runs.same_end {
            return Err(self.refuse(
                block,
                format!("the block runs {} times, each time at a different {letter}", runs.count),
                &format!("program {letter} in the block"),
            ));
        }
        if !known.has(axis) || is_return {
            return Err(self.refuse(
                block,
                format!("the position of {letter} is not known here, and a rotation needs it"),
                &format!("program {letter} in the block"),
            ));
        }
        Ok(runs.first.to[axis])
    }
}

/// G41 or G42.
fn has_compensation(block: &Block, control: &Control) -> bool {
    actions(block, control)
        .any(|(_, action)| matches!(action, Action::Mode(code) if code.other_side().is_some()))
}

/// Moves whose directions no word says.
fn makes_moves_of_its_own(action: Action) -> bool {
    // Those of lathes have words whose directions are known.
    let once = |code: OnceCode| code.is_pocket() || matches!(code, OnceCode::Pattern(_));
    action.once().is_some_and(once) || action == Action::After(AfterCode::RunCycleHere)
}

/// The code of the plane that a plane becomes by a quarter turn about Z.
fn quarter_turned(action: Action) -> Option<Action> {
    let [zx, yz] = [ModeCode::PlaneZx, ModeCode::PlaneYz].map(Action::Mode);
    let others = [(zx, yz), (yz, zx)];
    others.into_iter().find(|(plane, _)| *plane == action).map(|(_, other)| other)
}

/// The code that does the same in a mirror; `None` where it is the same code.
fn mirrored(action: Action) -> Option<Action> {
    match action {
        Action::Motion(code) => Some(Action::Motion(match code {
            MotionCode::ArcCw => MotionCode::ArcCcw,
            MotionCode::ArcCcw => MotionCode::ArcCw,
            MotionCode::SpiralCw => MotionCode::SpiralCcw,
            MotionCode::SpiralCcw => MotionCode::SpiralCw,
            MotionCode::Rapid | MotionCode::Linear => return None,
            // The thread stays as it is.
            MotionCode::Thread | MotionCode::RigidTap => return None,
            // It goes where its words say.
            MotionCode::Turn(_) => return None,
            // Programs with splines are not transformed.
            MotionCode::Spline(_) | MotionCode::SplineEnd => return None,
        })),
        Action::Mode(code) => Some(Action::Mode(code.other_side()?)),
        Action::Reading(_)
        | Action::Before(_)
        | Action::Length(_)
        | Action::Cycle(_)
        | Action::Once(_)
        | Action::After(_)
        | Action::Call(_)
        | Action::NoEffect
        | Action::NotSimulated
        | Action::NotFollowed => None,
    }
}
