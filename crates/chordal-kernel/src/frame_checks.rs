//! Checks while a frame is active, and of the first block after a change.

use chordal_command::{AxisMask, Command, CommandKind, Position, Units};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_machine::{AXES, Axis};

use crate::kernel::Kernel;
use crate::statement::Statement;

/// Coordinates that differ by less are equal on a control that counts in 0.001 mm: half an increment, mm.
const EQUAL_COORDINATE_MM: f64 = 0.000_5;

impl Kernel<'_> {
    /// Adds up by how much changes of rotation or scaling have changed the coordinates of the present position.
    pub(crate) fn note_jump(&mut self, before: &Position) {
        let now = self.state.position;
        let jump = self.state.frame_jump.unwrap_or([0.0; AXES]);
        let jump: Position = std::array::from_fn(|axis| jump[axis] + now[axis] - before[axis]);
        let changed = jump.iter().any(|value| value.abs() > EQUAL_COORDINATE_MM);
        self.state.frame_jump = changed.then_some(jump);
    }

    /// Forgets the changes: a preset or a move in machine coordinates has set the position again.
    pub fn forget_jump(&mut self) {
        self.state.frame_jump = None;
    }

    /// Checks the first block in absolute coordinates after a change of rotation or scaling. If it names only one
    /// axis of the plane, the other keeps a coordinate that the program does not show.
    #[cold]
    pub fn check_first_after_frame(
        &mut self,
        at: &dyn Statement,
        target: &Position,
        named: AxisMask,
    ) {
        let Some(jump) = self.state.frame_jump else { return };
        let (a, b, _) = self.state.plane.axes();
        if self.state.incremental || !(named.has(a) || named.has(b)) {
            return;
        }
        self.state.frame_jump = None;
        let (alone, other) = if named.has(a) { (a, b) } else { (b, a) };
        if named.has(other) || jump[other].abs() <= EQUAL_COORDINATE_MM {
            return;
        }
        let now = self.state.position[other];
        let mut goes_to = *target;
        goes_to[other] = now;
        let work = self.state.frames.map().point(&goes_to);
        let letter = |axis: usize| Axis::ALL[axis].letter();
        let message = format!(
            "the first block after a change of rotation or scaling names {} alone: {} was {} before it and is {} now",
            letter(alone),
            letter(other),
            self.length_text(now - jump[other]),
            self.length_text(now),
        );
        let place = format!(
            "goes to {} {}, {} {} of the work coordinate system",
            letter(a),
            self.length_text(work[a]),
            letter(b),
            self.length_text(work[b]),
        );
        let help = format!("write {} in this block as well", letter(other));
        let span = at.span();
        self.report(
            Diagnostic::new(Code::OneAxisAfterFrame, span, message)
                .severity(Severity::Warning)
                .label(place)
                .help(help),
        );
    }

    /// Reports a scaled coordinate or radius with more digits than the control can store.
    #[cold]
    pub(crate) fn check_scaled_size(&mut self, command: &Command) {
        let most = self.rules.frames.largest_scaled_increments;
        if most == 0.0 || self.state.frames.scaling().is_none() {
            return;
        }
        let mut radius: f64 = 0.0;
        if let CommandKind::Arc { shape, .. } | CommandKind::Spiral { shape, .. } = &command.kind {
            radius = shape.radius_from.max(shape.radius_to);
        }
        let digits = match self.state.units {
            Units::Inch => self.rules.increment_digits_inch,
            Units::Millimetre => self.rules.increment_digits_mm,
        };
        let unit = self.state.units.mm();
        let largest = most * unit / 10f64.powi(i32::from(digits));
        let Some((from, to)) = command.kind.motion().map(|motion| (motion.from, motion.to)) else {
            return;
        };
        let over = (0..3).find(|&axis| to[axis].abs() > largest && to[axis] != from[axis]);
        let what = match over {
            Some(axis) => {
                format!("{} goes to {}", Axis::ALL[axis].letter(), self.length_text(to[axis]))
            }
            None if radius > largest => format!("the radius is {}", self.length_text(radius)),
            None => return,
        };
        let largest = self.length_text(largest);
        let span = command.origin.span;
        self.report(
            Diagnostic::new(
                Code::ScaledOverflow,
                span,
                format!("scaled, {what}, and this control holds {largest} at most"),
            )
            .help("check the scale factor: without a decimal point it counts in small units"),
        );
    }

    /// Reports a cycle along a mirrored or scaled axis, on controls whose manuals forbid it.
    pub fn check_cycle_in_frame(&mut self, at: &dyn Statement, axis: usize) {
        if self.rules.frames.cycles_along_scaled || self.state.frames.is_plain() {
            return;
        }
        let frames = &self.state.frames;
        let letter = Axis::ALL[axis].letter();
        let factor = frames.scaling().map_or(1.0, |scaling| scaling.factors[axis]);
        let message = if frames.mirrored().has(axis) {
            format!("a cycle drills along {letter}, which is mirrored")
        } else if factor != 1.0 {
            format!("a cycle drills along {letter}, which is scaled by {factor}")
        } else {
            return;
        };
        let span = at.span();
        self.report(
            Diagnostic::new(Code::FrameInCycle, span, message)
                .label("its levels change, its peck depth and clearance do not")
                .help(format!("cancel the mirror image or scaling of {letter} before the cycle")),
        );
    }
}
