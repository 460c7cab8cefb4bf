//! Blocks that move: where they go, and lines and arcs for the kernel.

use std::f64::consts::TAU;

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::frames::InPlane;
use chordal_kernel::{ArcWords, ModalMotion};

use super::block_values::{BlockValues, KlartextView};
use super::contours::ContourFault;
use super::interpreter::KlartextInterpreter;
use super::run_state::{ContourMemory, KlartextFlow};
use crate::geometry::ContourElement;
use crate::syntax::{PathFunction, PathWords};

impl KlartextInterpreter<'_> {
    /// The plane of the tool.
    pub(super) fn tool_plane(&self) -> Plane {
        self.kernel.state.plane
    }

    /// The axis of the tool: 0 for X.
    pub(super) fn tool_axis(&self) -> usize {
        self.tool_plane().axes().2
    }

    /// The programmed position of the tool tip, mm and rad.
    pub(super) fn programmed(&self) -> Position {
        self.modes.frame.programmed(&self.kernel.state.position)
    }

    /// A path function with what else stands in its block.
    pub(super) fn path_block(&mut self, function: PathFunction, words: &PathWords) -> KlartextFlow {
        let function = match function {
            PathFunction::Repeated => self.modes.contour.function,
            other => other,
        };
        self.functions_at_start(words);
        let is_rapid = self.apply_feed(words.feed);
        self.set_compensation(function, words);
        let has_moved = self.path_motion(function, words, is_rapid);
        self.set_corner_mode(words);
        self.modes.contour.function = function;
        let flow = self.functions_at_end(&words.functions);
        let calls = words.functions.iter().any(|function| function.number == 99);
        if calls {
            self.modes.calls_each_block = false;
        }
        if self.modes.calls_each_block && has_moved && !calls && flow == KlartextFlow::Next {
            return self.call_cycle();
        }
        flow
    }

    /// Moves; false if the block has no coordinates.
    fn path_motion(&mut self, function: PathFunction, words: &PathWords, is_rapid: bool) -> bool {
        let has = |number: u32| words.functions.iter().any(|own| own.number == number);
        if let Some(retract) = words.functions.iter().find(|own| own.number == 140) {
            self.retract(retract, words, is_rapid);
            return true;
        }
        let is_arc = matches!(
            function,
            PathFunction::CenterArc
                | PathFunction::PolarArc
                | PathFunction::RadiusArc
                | PathFunction::TangentArc
                | PathFunction::PolarTangentArc
        );
        if !(words.has_coordinates() || is_arc && words.direction.is_some()) {
            return false;
        }
        if !self.has_axes(words) {
            return true;
        }
        let Some(values) = self.values(words) else {
            self.lose_axes(words);
            return true;
        };
        if has(91) || has(92) {
            self.machine_move(words, &values, is_rapid);
            return true;
        }
        let start = self.programmed();
        let mut contour = self.modes.contour.clone();
        let linear = [start[0], start[1], start[2]];
        let found = self.element(function, &values, linear, &mut contour);
        self.modes.contour = contour;
        match found {
            Ok(element) => self.cut(words, &values, &element, is_rapid),
            Err(fault) => {
                self.report_contour(fault, words);
                self.straight_to_end(words, &values, is_rapid);
            }
        }
        true
    }

    /// Axes whose target is not known go to an unknown place.
    fn lose_axes(&mut self, words: &PathWords) {
        let mut axes = AxisMask::NONE;
        for axis in 0..6 {
            if words.axes[axis].is_some() {
                axes.insert(axis);
            }
        }
        if words.polar_radius.is_some() || words.polar_angle.is_some() {
            axes = axes.or(AxisMask::XY);
        }
        self.kernel.go_astray(axes);
    }

    /// Reports why there is no element.
    pub(super) fn report_contour(&mut self, fault: ContourFault, words: &PathWords) {
        let range = match fault.is_of_radius {
            true => words.radius.map(|word| word.range),
            false => None,
        };
        let range = range.unwrap_or(self.here);
        let diagnostic = Diagnostic::new(fault.code, self.span(range), fault.message);
        let diagnostic =
            if fault.help.is_empty() { diagnostic } else { diagnostic.help(fault.help) };
        match fault.alarm {
            Some(alarm) => self.report_alarm(alarm, diagnostic),
            None => self.kernel.report(diagnostic),
        }
    }

    /// A straight move to the end of an element that cannot be made, as far as its end is known.
    fn straight_to_end(&mut self, words: &PathWords, values: &BlockValues, is_rapid: bool) {
        let start = self.programmed();
        let mut end = [start[0], start[1], start[2]];
        for (axis, value) in end.iter_mut().enumerate() {
            if let Some(coordinate) = values.axes[axis] {
                *value = coordinate.from(*value);
            }
        }
        self.modes.contour.direction = None;
        self.cut(words, values, &ContourElement::Line { end }, is_rapid);
    }

    /// The axes that a block names.
    fn named(&self, words: &PathWords, element: &ContourElement) -> AxisMask {
        let mut named = AxisMask::NONE;
        for axis in 0..6 {
            if words.axes[axis].is_some() {
                named.insert(axis);
            }
        }
        if words.polar_radius.is_some() || words.polar_angle.is_some() {
            let plane = self.modes.contour.center_plane.unwrap_or(self.tool_plane());
            let (a, b, _) = plane.axes();
            named.insert(a);
            named.insert(b);
        }
        if let ContourElement::Arc { plane, .. } = element {
            let (a, b, _) = plane.axes();
            named.insert(a);
            named.insert(b);
        }
        named
    }

    /// Moves along an element; rotary axes go with it.
    pub(super) fn cut(
        &mut self,
        words: &PathWords,
        values: &BlockValues,
        element: &ContourElement,
        is_rapid: bool,
    ) {
        let start = self.programmed();
        let mut end = start;
        end[..3].copy_from_slice(&element.end());
        for axis in 3..6 {
            if let Some(coordinate) = values.axes[axis] {
                end[axis] = coordinate.from(start[axis].to_degrees()).to_radians();
            }
        }
        let mut named = self.named(words, element);
        if let Some(angles) = self.rotary_of_vector(words.tool_vector) {
            end[3..].copy_from_slice(&angles);
            named = named.or(AxisMask::ROTARY.and(self.programs.control.axes()));
        }
        let turns_alone = named.and(AxisMask::LINEAR) == AxisMask::NONE && !self.follows_tip();
        if turns_alone && self.modes.outside_plane.is_some() {
            // The rotary axes turn to the plane, and the others stand.
            let view = KlartextView { span: self.span(self.here), words: Some(words) };
            self.kernel.by_axes(|kernel| {
                let mut target = kernel.state.position;
                target[3..].copy_from_slice(&end[3..]);
                kernel.state.motion =
                    if is_rapid { ModalMotion::Rapid } else { ModalMotion::Linear };
                kernel.state.place(named);
                kernel.straight(&view, target, named);
            });
            return;
        }
        let linear = [start[0], start[1], start[2]];
        let plane = self.tool_plane();
        let direction = element.end_direction(linear, plane);
        if !is_rapid {
            self.request_corner(element);
        }
        self.move_along(Some(words), element, end, named, is_rapid);
        self.kernel.corner_move_done();
        self.remember_element(linear, element);
        self.modes.contour.direction = direction;
    }

    /// The position of programmed coordinates, and the axes that reach a known place. Axes that are not named stay where
    /// they are, unless a rotation moves them.
    fn target_of(&mut self, programmed: &Position, named: AxisMask) -> (Position, AxisMask) {
        let map = *self.modes.frame.map();
        let reached = map.reached(named);
        let mapped = map.point(programmed);
        let mut end = self.kernel.state.position;
        (0..6).filter(|axis| reached.has(*axis)).for_each(|axis| end[axis] = mapped[axis]);
        let named = named.or(reached.and(self.kernel.state.known));
        self.kernel.state.place(named);
        (end, named)
    }

    /// Moves along an element.
    pub(super) fn move_along(
        &mut self,
        words: Option<&PathWords>,
        element: &ContourElement,
        end: Position,
        named: AxisMask,
        is_rapid: bool,
    ) {
        let from = self.kernel.state.position;
        let starts_known = self.kernel.state.known.covers(AxisMask::LINEAR);
        self.give_element(words, element, end, named, is_rapid);
        if starts_known {
            self.follow_blank(&from, element);
        }
    }

    /// Gives an element to the kernel.
    fn give_element(
        &mut self,
        words: Option<&PathWords>,
        element: &ContourElement,
        end: Position,
        named: AxisMask,
        is_rapid: bool,
    ) {
        let view = KlartextView { span: self.span(self.here), words };
        let (target, named) = self.target_of(&end, named);
        self.kernel.state.motion = if is_rapid { ModalMotion::Rapid } else { ModalMotion::Linear };
        let ContourElement::Arc { plane, center, sweep_rad, .. } = *element else {
            return self.kernel.straight(&view, target, named);
        };
        let is_mirrored = match self.modes.frame.in_plane(plane) {
            InPlane::Similar { mirrored, .. } => mirrored,
            InPlane::Unequal { .. } | InPlane::Tilted => {
                let what = "an arc in a plane that is scaled unequally, or that a rotation tilts, is not followed: it is drawn as a line";
                self.not_followed(self.here, what);
                return self.kernel.straight_instead(&view, target, named);
            }
        };
        let (a, b, _) = plane.axes();
        let mut place = end;
        (place[a], place[b]) = (center[0], center[1]);
        let place = self.modes.frame.map().point(&place);
        let direction = if sweep_rad > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw };
        // Turns before the last, which the kernel adds to what lies between start and end.
        let turns = ((sweep_rad.abs() / TAU - 1e-9).ceil() - 1.0).max(0.0) as u32;
        let arc = ArcWords {
            direction: direction.mirrored_if(is_mirrored),
            center: [Some(place[a]), Some(place[b])],
            turns,
        };
        let own = self.tool_plane();
        if plane != own {
            self.kernel.set_plane(view.span, plane);
        }
        let mut target = target;
        self.kernel.snap_to_start(&mut target);
        let kept = self.rapid_feed_of_arc(is_rapid);
        self.kernel.arc_by_center(&view, &arc, target, named);
        if let Some(feed) = kept {
            self.kernel.state.feed = feed;
        }
        if plane != own {
            self.kernel.set_plane(view.span, own);
        }
    }

    /// FMAX on an arc: the speed of the slower axis; the feed to restore after it.
    fn rapid_feed_of_arc(&mut self, is_rapid: bool) -> Option<Option<f64>> {
        if !is_rapid {
            return None;
        }
        let axes = self.kernel.machine.axes.iter().take(2).flatten();
        let slowest = axes.filter_map(|axis| axis.max_velocity).fold(f64::INFINITY, f64::min);
        let kept = self.kernel.state.feed;
        if slowest.is_finite() {
            self.kernel.state.feed = Some(slowest);
        }
        Some(kept)
    }

    /// A move in machine coordinates (M91, M92), those of the axes: the length of the tool does not count.
    fn machine_move(&mut self, words: &PathWords, values: &BlockValues, is_rapid: bool) {
        let mut place = [0.0; 6];
        let mut named = AxisMask::NONE;
        for (axis, value) in place.iter_mut().enumerate() {
            let Some(coordinate) = values.axes[axis] else { continue };
            let now = self.kernel.state.machine_position(axis);
            let unit = if axis < 3 { 1.0 } else { 1_f64.to_radians() };
            *value = match coordinate.is_incremental {
                true => now + coordinate.value * unit,
                false => coordinate.value * unit,
            };
            named.insert(axis);
        }
        self.kernel.state.motion = if is_rapid { ModalMotion::Rapid } else { ModalMotion::Linear };
        let view = KlartextView { span: self.span(self.here), words: Some(words) };
        self.kernel.to_machine_point(&view, place, named);
        self.modes.contour.direction = None;
    }

    /// M140: away from the part along the tool axis.
    fn retract(
        &mut self,
        function: &crate::syntax::MachineFunction,
        words: &PathWords,
        is_rapid: bool,
    ) {
        let Some(value) = function.value else {
            return self.retract_to_limit(function.range, words, is_rapid);
        };
        let Some(length) = self.operand(value, function.range) else { return };
        let start = self.programmed();
        let axis = self.tool_axis();
        let mut end = start;
        end[axis] += length * self.unit_mm();
        let element = ContourElement::Line { end: [end[0], end[1], end[2]] };
        let mut named = AxisMask::NONE;
        named.insert(axis);
        // Without a feed it is a rapid.
        let is_rapid = is_rapid || words.feed.is_none();
        self.move_along(Some(words), &element, end, named, is_rapid);
    }

    /// M140 MB MAX: to the limit of travel of the tool axis.
    fn retract_to_limit(&mut self, range: TextRange, words: &PathWords, is_rapid: bool) {
        let axis = self.tool_axis();
        let limits = self.kernel.machine.axes[axis].as_ref().and_then(|axis| axis.travel);
        let Some((_, limit)) = limits else {
            let what = "M140 MB MAX retracts to the limit of travel, which the machine file does not give: the tool stays";
            return self.assumed_once("M140", range, what);
        };
        let mut place = [0.0; 6];
        place[axis] = limit;
        let mut named = AxisMask::NONE;
        named.insert(axis);
        self.kernel.state.motion = match is_rapid || words.feed.is_none() {
            true => ModalMotion::Rapid,
            false => ModalMotion::Linear,
        };
        let view = KlartextView { span: self.span(self.here), words: Some(words) };
        self.kernel.to_machine_point(&view, place, named);
        self.modes.contour.direction = None;
    }

    /// CC: the centre of arcs and the pole of polar coordinates.
    pub(super) fn set_center(&mut self, words: &PathWords) {
        let Some(values) = self.values(words) else { return };
        let place = self.programmed();
        let mut contour = self.modes.contour.clone();
        self.place_center(&values, &place, &mut contour);
        self.modes.contour = contour;
    }

    /// CC in a memory of the contour, with the tool at a place. Its two axes choose the plane of arcs.
    pub(super) fn place_center(
        &self,
        values: &BlockValues,
        place: &Position,
        contour: &mut ContourMemory,
    ) {
        let own = self.tool_plane();
        let named: Vec<usize> = (0..3).filter(|axis| values.axes[*axis].is_some()).collect();
        let plane = match named.as_slice() {
            [0, 1] => Plane::Xy,
            [0, 2] => Plane::Zx,
            [1, 2] => Plane::Yz,
            // One axis keeps the plane if it has it.
            [axis] => contour.center_plane.filter(|plane| plane.axes().2 != *axis).unwrap_or(own),
            _ => own,
        };
        contour.center_plane = Some(plane);
        if named.is_empty() {
            let (a, b, _) = plane.axes();
            contour.center[a] = Some(place[a]);
            contour.center[b] = Some(place[b]);
        }
        for axis in named {
            if let Some(coordinate) = values.axes[axis] {
                contour.center[axis] = Some(coordinate.from(place[axis]));
            }
        }
        contour.polar = [None; 2];
    }

    /// A rapid in programmed coordinates of X, Y and Z.
    pub(super) fn rapid_to(&mut self, place: [f64; 3], named: AxisMask) {
        let mut end = self.programmed();
        end[..3].copy_from_slice(&place);
        if end == self.programmed() {
            return;
        }
        self.move_along(None, &ContourElement::Line { end: place }, end, named, true);
    }

    /// A straight cut in programmed coordinates of X, Y and Z.
    pub(super) fn feed_to(&mut self, place: [f64; 3], named: AxisMask) {
        let mut end = self.programmed();
        end[..3].copy_from_slice(&place);
        self.move_along(None, &ContourElement::Line { end: place }, end, named, false);
    }

    /// A problem with a word of a block, where the help says what to write.
    pub(super) fn bad_value(&mut self, range: TextRange, message: String, help: &str) {
        let diagnostic = Diagnostic::new(Code::BadWordValue, self.span(range), message);
        self.kernel.report(diagnostic.help(help));
    }
}
