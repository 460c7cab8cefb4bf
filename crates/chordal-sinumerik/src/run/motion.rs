//! Axis words → targets, straight moves, rapids, roundings.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, TextRange};
use chordal_kernel::frames::sin_cos_degrees;
use chordal_kernel::{CornerForm, ModalMotion, ProgrammedCorner};

use super::frames::is_frame_block;
use super::interpreter::Interpreter;
use super::run_state::PathMotion;
use super::words::{BlockStatementView, BlockWords, ValueWord};

/// Where a block goes.
#[derive(Clone, Copy, Debug)]
pub struct BlockTarget {
    /// The end in programmed coordinates, mm.
    pub programmed: [f64; 3],
    /// The start in programmed coordinates, mm.
    pub start: [f64; 3],
    /// The end in the coordinates of the settable frame, mm and rad.
    pub end: Position,
    /// The axes that move.
    pub named: AxisMask,
}

/// How far the end point of a line may be off the direction of its ANG, mm.
const COINCIDENT_LINE_MM: f64 = 0.001;

impl Interpreter<'_> {
    /// Moves, if the block has a motion; false if nothing moves.
    pub(super) fn moves(&mut self, range: TextRange, words: &BlockWords) -> bool {
        self.set_pole(words);
        if is_frame_block(words)
            || words.g_codes.iter().any(|(code, _)| matches!(code, 4 | 25 | 26 | 110..=112))
        {
            return false;
        }
        if let Some((code, range)) =
            words.g_codes.iter().find(|(code, _)| matches!(code, 74 | 75 | 751)).copied()
        {
            self.go_to_point_of_machine(code, range, words);
            return false;
        }
        let is_full_circle = matches!(self.modes.motion, PathMotion::Arc(_))
            && (words.centers.iter().any(Option::is_some) || words.other("AR").is_some());
        if !words.has_path_motion() && !is_full_circle {
            return false;
        }
        if words.has_unknown_path {
            self.go_astray(words);
            return true;
        }
        if self.modes.machine_block {
            self.machine_move(range, words);
            return true;
        }
        if words.astray != AxisMask::NONE && !self.goes_straight() {
            self.go_astray(words);
            return true;
        }
        let Some(target) = self.target(range, words) else { return false };
        let span = self.span(range);
        let view = BlockStatementView { span, words };
        self.request_corner(words);
        let start = self.kernel.state.position;
        self.kernel.state.motion = self.kernel_motion();
        match self.modes.motion {
            PathMotion::Rapid | PathMotion::Linear | PathMotion::NotFollowed => {
                self.line_of_contour(words, &target);
                self.kernel.straight(&view, target.end, target.named);
                let end = self.kernel.state.position;
                let along: [f64; 3] = std::array::from_fn(|axis| end[axis] - start[axis]);
                if along.iter().any(|value| *value != 0.0) {
                    self.modes.last_direction = Some(along);
                }
            }
            PathMotion::Thread => self.thread_move(&view, range, words, &target),
            PathMotion::ChangingThread { grows } => {
                self.changing_thread_move(&view, range, words, &target, grows);
            }
            PathMotion::Arc(_) | PathMotion::ThroughPoint | PathMotion::Tangent => {
                self.arc(&view, range, words, &target);
            }
        }
        self.lose_axes(words.astray);
        self.kernel.corner_move_done();
        true
    }

    /// A straight move after the one with which compensation began tells how the contour begins.
    fn line_of_contour(&mut self, words: &BlockWords, target: &BlockTarget) {
        let begins = words.g_codes.iter().any(|(code, _)| matches!(code, 41 | 42));
        let (a, b, _) = self.kernel.state.plane.axes();
        let start = self.kernel.state.position;
        let along = [target.end[a] - start[a], target.end[b] - start[b]];
        if !begins && along != [0.0; 2] {
            self.contour_begins([start[a], start[b]], along);
        }
    }

    /// Whether the motion in force is a straight one.
    fn goes_straight(&self) -> bool {
        matches!(
            self.modes.motion,
            PathMotion::Rapid
                | PathMotion::Linear
                | PathMotion::Thread
                | PathMotion::ChangingThread { .. }
        )
    }

    /// G74: the reference point of the named axes. G75: a fixed point, whose place no reference of a machine file gives.
    fn go_to_point_of_machine(&mut self, code: u32, range: TextRange, words: &BlockWords) {
        let named = words.axis_mask();
        if code == 74 {
            let home = self.kernel.machine.home;
            return self.kernel.go_to_reference(named, &home);
        }
        self.kernel.go_astray(named);
        self.lose_path(range, "the place of G75", "the fixed point of the machine");
    }

    /// The motion as the kernel knows it: an arc that cannot be made is cut as a line.
    fn kernel_motion(&self) -> ModalMotion {
        match self.modes.motion {
            PathMotion::Rapid => ModalMotion::Rapid,
            _ => ModalMotion::Linear,
        }
    }

    /// The programmed coordinates of the tool tip, mm.
    pub(super) fn programmed_position(&self) -> [f64; 3] {
        self.modes.frame.programmed(&self.kernel.state.position)
    }

    /// The end of a block.
    fn target(&mut self, range: TextRange, words: &BlockWords) -> Option<BlockTarget> {
        let start = self.programmed_position();
        let mut programmed = start;
        let incremental = self.kernel.state.incremental;
        if words.other("AP").is_some() || words.other("RP").is_some() {
            self.polar_end(range, words, start, &mut programmed)?;
        } else if (0..3).any(|axis| words.axes[axis].is_some()) {
            (self.modes.polar_angle, self.modes.polar_radius) = (None, None);
        }
        for (axis, value) in programmed.iter_mut().enumerate() {
            if let Some(word) = words.axes[axis] {
                let unit = self.unit_of_axis(axis, &word);
                *value = word.coordinate(start[axis], unit, incremental);
            }
        }
        self.line_by_angle(words, start, &mut programmed);
        let mut named = words.axis_mask();
        if words.other("AP").is_some()
            || words.other("RP").is_some()
            || words.other("ANG").is_some()
        {
            let (a, b, _) = self.kernel.state.plane.axes();
            named.insert(a);
            named.insert(b);
        }
        let mut end = self.kernel.state.position;
        // A rotated frame moves axes that are not programmed.
        let reached = self.modes.frame.reached(named);
        let mapped = self.mapped(programmed);
        (0..3).filter(|axis| reached.has(*axis)).for_each(|axis| end[axis] = mapped[axis]);
        named = named.or(reached.and(self.kernel.state.known));
        for (value, word) in end.iter_mut().zip(&words.axes).skip(3) {
            let Some(word) = word else { continue };
            *value = word.coordinate(*value, 1_f64.to_radians(), incremental);
        }
        if let Some(first) = words.directions.iter().flatten().next() {
            let direction = words.directions.map(|word| word.map_or(0.0, |word| word.value));
            if let Some(angles) = self.rotary_of_direction(direction, first.range) {
                end[3..].copy_from_slice(&angles);
                named = named.or(AxisMask::ROTARY.and(self.programs.control.axes()));
            }
        }
        self.kernel.state.place(named);
        Some(BlockTarget { programmed, start, end, named })
    }

    /// A move in machine coordinates (G53, G153, SUPA): the active tool length stays.
    fn machine_move(&mut self, range: TextRange, words: &BlockWords) {
        let lengths = self.kernel.state.offsets.tool_in_force();
        let mut place = [0.0; 6];
        for (axis, value) in place.iter_mut().enumerate() {
            let Some(word) = words.axes[axis] else { continue };
            *value = match axis {
                0..3 => word.value * self.unit_of_axis(axis, &word) + lengths[axis],
                _ => word.value.to_radians(),
            };
        }
        self.kernel.state.motion = self.kernel_motion();
        let span = self.span(range);
        let view = BlockStatementView { span, words };
        self.kernel.to_machine_point(&view, place, words.axis_mask());
        self.modes.last_direction = None;
    }

    /// G110, G111, G112: the pole of polar coordinates.
    fn set_pole(&mut self, words: &BlockWords) {
        let code = words.g_codes.iter().find(|(code, _)| (110..=112).contains(code));
        let Some((code, range)) = code.copied() else { return };
        let from = match code {
            110 => self.programmed_position(),
            112 => self.modes.pole,
            _ => [0.0; 3],
        };
        let (a, b, _) = self.kernel.state.plane.axes();
        let unit = self.unit_mm();
        let mut pole = from;
        let outside = (0..3).find(|axis| *axis != a && *axis != b && words.axes[*axis].is_some());
        if let Some(axis) = outside {
            let letter = chordal_machine::AXIS_NAMES[axis];
            let message = format!("{letter} is no axis of the plane, in which the pole is");
            self.alarm(14270, Code::PolarWords, range, message);
        }
        for axis in [a, b] {
            pole[axis] +=
                words.axes[axis].map_or(0.0, |word| word.value * self.unit_of_axis(axis, &word));
        }
        if let (Some(angle), Some(radius)) = (words.other("AP"), words.other("RP")) {
            let (sin, cos) = sin_cos_degrees(angle.value);
            pole[a] += radius.value * unit * cos;
            pole[b] += radius.value * unit * sin;
        } else if words.other("AP").is_some() != words.other("RP").is_some() {
            self.alarm(14270, Code::PolarWords, range, "a pole needs both AP and RP");
        }
        self.modes.pole = pole;
    }

    /// The end of a block with AP or RP.
    fn polar_end(
        &mut self,
        range: TextRange,
        words: &BlockWords,
        start: [f64; 3],
        end: &mut [f64; 3],
    ) -> Option<()> {
        let (a, b, _) = self.kernel.state.plane.axes();
        let pole = self.modes.pole;
        let (along, across) = (start[a] - pole[a], start[b] - pole[b]);
        let angle_now =
            self.modes.polar_angle.unwrap_or_else(|| libm::atan2(across, along).to_degrees());
        let radius_now = self.modes.polar_radius.unwrap_or_else(|| along.hypot(across));
        let incremental = |word: &ValueWord| word.is_incremental(false);
        let angle = words.other("AP").map_or(angle_now, |word| match incremental(&word) {
            true => angle_now + word.value,
            false => word.value,
        });
        let unit = self.unit_mm();
        let radius = words.other("RP").map_or(radius_now, |word| match incremental(&word) {
            true => radius_now + word.value * unit,
            false => word.value * unit,
        });
        if radius < 0.0 {
            let message = format!("the polar radius is {}", self.kernel.length_text(radius));
            self.alarm(14200, Code::PolarWords, range, message);
            return None;
        }
        if angle.abs() > 360.0 && words.other("AP").is_some_and(|word| !incremental(&word)) {
            self.alarm(
                14210,
                Code::PolarWords,
                range,
                format!("the polar angle {angle} is more than 360"),
            );
            return None;
        }
        let (sin, cos) = sin_cos_degrees(angle);
        (end[a], end[b]) = (pole[a] + radius * cos, pole[b] + radius * sin);
        (self.modes.polar_angle, self.modes.polar_radius) = (Some(angle), Some(radius));
        Some(())
    }

    /// `ANG=` with one axis of the plane: the other one follows from the angle.
    fn line_by_angle(&mut self, words: &BlockWords, start: [f64; 3], end: &mut [f64; 3]) {
        let Some(angle) = words.other("ANG") else { return };
        let (a, b, _) = self.kernel.state.plane.axes();
        let (sin, cos) = sin_cos_degrees(angle.value);
        match (words.axes[a], words.axes[b]) {
            (Some(_), None) if cos != 0.0 => end[b] = start[b] + (end[a] - start[a]) * sin / cos,
            (None, Some(_)) if sin != 0.0 => end[a] = start[a] + (end[b] - start[b]) * cos / sin,
            (Some(_), Some(_)) => {
                let [along, across] = [end[a] - start[a], end[b] - start[b]];
                let off_mm = across * cos - along * sin;
                if off_mm.abs() > 2.0 * COINCIDENT_LINE_MM || along * cos + across * sin < 0.0 {
                    let message =
                        format!("the end point is not in the direction of {} degrees", angle.value);
                    self.alarm(10795, Code::PolarWords, angle.range, message);
                }
            }
            _ => {
                self.not_followed(angle.range, "ANG without one axis of the plane is not followed")
            }
        }
    }

    /// CHF, CHR, RND and RNDM at the end of this block's move.
    fn request_corner(&mut self, words: &BlockWords) {
        let unit = self.unit_mm();
        let found = [
            ("RND", CornerForm::Rounding),
            ("CHR", CornerForm::Chamfer),
            ("CHF", CornerForm::ChamferOfLength),
        ]
        .into_iter()
        .find_map(|(name, form)| Some((name, form, words.other(name)?)));
        let (name, form, size, range) = match found {
            Some((name, form, word)) => (name, form, word.value * unit, word.range),
            None if self.modes.modal_rounding_mm > 0.0
                && self.modes.motion != PathMotion::Rapid =>
            {
                ("RNDM", CornerForm::Rounding, self.modes.modal_rounding_mm, self.here())
            }
            None => return,
        };
        if size <= 0.0 {
            return;
        }
        let word = self.span(range);
        let corner = ProgrammedCorner { word, name, form, size_mm: size, block: None, feed: None };
        self.kernel.request_corner(corner);
    }
}
