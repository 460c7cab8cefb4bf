//! R0, RL and RR; APPR and DEP.

use chordal_command::{AxisMask, CommandKind, CompensationSide};
use chordal_diagnostics::{Code, Diagnostic};

use super::interpreter::KlartextInterpreter;
use super::run_state::KlartextFlow;
use crate::alarms::{
    CIRCLE_END, COMPENSATION_UNDEFINED, TOOL_NOT_DEFINED, WRONGLY_ENDED, WRONGLY_STARTED,
};
use crate::geometry::{
    ApproachArc, ApproachFault, ApproachPath, ApproachRequest, ContourElement, approach_path,
    arc_about, departure_path,
};
use crate::syntax::{
    KlartextApproachForm, KlartextStatement, PathFunction, PathWords, UnfollowedFunction,
};

/// Blocks that are looked at for the first element after APPR.
const MAX_LOOK_AHEAD_BLOCKS: usize = 50;

impl KlartextInterpreter<'_> {
    /// R0, RL and RR of a block.
    pub(super) fn set_compensation(&mut self, function: PathFunction, words: &PathWords) {
        let Some((side, range)) = words.side else { return };
        let before = self.programmed_side();
        if side == before {
            return;
        }
        let is_line = matches!(function, PathFunction::Line | PathFunction::PolarLine);
        if !is_line {
            let (alarm, what) = match side {
                CompensationSide::Off => (WRONGLY_ENDED, "ends"),
                _ => (WRONGLY_STARTED, "begins"),
            };
            let message = format!("tool radius compensation {what} on an arc");
            let diagnostic = Diagnostic::new(Code::CompensationOnArc, self.span(range), message);
            self.report_alarm(alarm, diagnostic.help("write it into a block with a straight line"));
        }
        if side != CompensationSide::Off && before != CompensationSide::Off {
            let message = "compensation changes from one side to the other";
            let diagnostic = Diagnostic::new(Code::SideChangeRefused, self.span(range), message);
            let help = "write a block with R0 between the two";
            self.report_alarm(COMPENSATION_UNDEFINED, diagnostic.help(help));
        }
        self.check_tool(side, range);
        self.switch_compensation(side);
    }

    /// M97 after the move of its block: the outside corner at its end is passed without an arc, which lets the tool into
    /// small steps. M98: the inside corner at its end is open, and is cut to the ends of both elements (TNC 620 81760x-02
    /// p. 370).
    pub(super) fn set_corner_mode(&mut self, words: &PathWords) {
        let has = |number: u32| words.functions.iter().any(|function| function.number == number);
        let (meets, opens) = (has(97), has(98));
        // A corner is made when the move after it is known, so that the mode stays for one move more.
        if (meets, opens) != (self.modes.meets_corner, self.modes.opens_corner) {
            (self.modes.meets_corner, self.modes.opens_corner) = (meets, opens);
            self.kernel.emit(CommandKind::CornerMode { meets, opens });
        }
        if opens && self.is_first_report("M98") {
            let message = "after M98 the manuals do not give the path from the end of this element to the next: it is assumed";
            let diagnostic = Diagnostic::new(Code::CyclePathAssumed, self.span(self.here), message);
            let help =
                "both elements are cut to their ends; the tool goes straight from one to the other";
            self.kernel.report(diagnostic.help(help));
        }
    }

    /// The side as programmed: a mirrored contour has the tool on its other side.
    fn programmed_side(&self) -> CompensationSide {
        let plane = self.tool_plane();
        self.kernel.state.side.mirrored_if(self.modes.frame.in_plane(plane).is_mirrored())
    }

    fn check_tool(&mut self, side: CompensationSide, range: chordal_diagnostics::TextRange) {
        if side != CompensationSide::Off && !self.modes.has_tool {
            let message = "tool radius compensation begins, and no tool was called";
            self.alarm(TOOL_NOT_DEFINED, Code::CompensationWithoutOffset, range, message);
        }
    }

    /// Switches compensation of the next line.
    fn switch_compensation(&mut self, side: CompensationSide) {
        let plane = self.tool_plane();
        let is_mirrored = self.modes.frame.in_plane(plane).is_mirrored();
        let side = side.mirrored_if(is_mirrored);
        self.kernel.state.side = side;
        let number = self.kernel.state.radius_offset.filter(|_| side != CompensationSide::Off);
        let span = self.span(self.here);
        self.kernel.emit_compensation(number, None, span);
    }

    /// The radius of the tool in programmed lengths, mm.
    fn tool_radius_mm(&self) -> f64 {
        let number = self.kernel.state.radius_offset;
        let radius = number.and_then(|number| self.kernel.state.offsets.radius_mm(number));
        radius.unwrap_or(0.0) / self.modes.frame.factor(self.tool_plane())
    }

    /// APPR: to the first point of a contour. The tool's centre goes to PH, from there to the offset point of the contour,
    /// where compensation begins.
    pub(super) fn approach(
        &mut self,
        form: KlartextApproachForm,
        words: &PathWords,
    ) -> KlartextFlow {
        self.functions_at_start(words);
        let is_straight_first = form != KlartextApproachForm::LineAndArc;
        // The way to PH has the feed before the block, the approach itself that of the block.
        let mut is_rapid = !is_straight_first && self.apply_feed(words.feed);
        let start = self.programmed();
        let Some(point) = self.contour_point(words) else { return KlartextFlow::Next };
        let plane = self.tool_plane();
        let (a, b, normal) = plane.axes();
        let Some((side, range)) = words.side.filter(|(side, _)| *side != CompensationSide::Off)
        else {
            let message = "APPR has neither RL nor RR: on which side the tool comes is not known";
            self.problem(Code::MissingWord, self.here, message);
            return KlartextFlow::Next;
        };
        self.check_tool(side, range);
        let Some(direction) = self.next_direction(point) else {
            let what = "the first element after APPR is not known here, so that the approach is not followed";
            self.not_followed(self.here, what);
            self.kernel.go_astray(AxisMask::XY);
            return KlartextFlow::Next;
        };
        let outside = [start[a], start[b]];
        let Some(request) =
            self.approach_request(form, words, [point[a], point[b]], direction, side, outside)
        else {
            return KlartextFlow::Next;
        };
        let path = match approach_path(&request) {
            Ok(path) => path,
            Err(fault) => {
                self.report_approach(fault);
                ApproachPath { helper: request.outside, contact: request.point, arc: None }
            }
        };
        let mut place = [start[0], start[1], start[2]];
        (place[a], place[b]) = (path.helper[0], path.helper[1]);
        self.straight_part(place, is_rapid);
        if place[normal] != point[normal] {
            place[normal] = point[normal];
            self.straight_part(place, is_rapid);
        }
        if is_straight_first {
            is_rapid = self.apply_feed(words.feed);
        }
        (place[a], place[b]) = (path.contact[0], path.contact[1]);
        self.approach_part(&path, path.helper, place, request.center_angle_rad, is_rapid);
        self.switch_compensation(side);
        (place[a], place[b]) = (point[a], point[b]);
        self.straight_part(place, false);
        self.modes.contour.direction = Some(direction);
        self.modes.contour.function = PathFunction::Line;
        self.functions_at_end(&words.functions)
    }

    /// DEP: away from the last point of a contour, where compensation ends.
    pub(super) fn departure(
        &mut self,
        form: KlartextApproachForm,
        words: &PathWords,
    ) -> KlartextFlow {
        self.functions_at_start(words);
        let kept = (self.kernel.state.feed, self.kernel.state.feed_mode);
        let is_rapid = self.apply_feed(words.feed);
        let start = self.programmed();
        let plane = self.tool_plane();
        let (a, b, normal) = plane.axes();
        let side = self.programmed_side();
        let Some(direction) =
            self.modes.contour.direction.filter(|_| side != CompensationSide::Off)
        else {
            let message = "DEP leaves a contour with compensation, and none is active here";
            self.problem(Code::CompensationWithoutOffset, self.here, message);
            return KlartextFlow::Next;
        };
        let Some(end) = self.contour_point(words) else { return KlartextFlow::Next };
        let outside = [end[a], end[b]];
        let point = [start[a], start[b]];
        let Some(request) = self.approach_request(form, words, point, direction, side, outside)
        else {
            return KlartextFlow::Next;
        };
        let path = match departure_path(&request) {
            Ok(path) => path,
            Err(fault) => {
                self.report_approach(fault);
                ApproachPath { helper: request.outside, contact: request.point, arc: None }
            }
        };
        self.switch_compensation(CompensationSide::Off);
        let mut place = [start[0], start[1], start[2]];
        (place[a], place[b]) = (path.contact[0], path.contact[1]);
        self.straight_part(place, false);
        (place[a], place[b]) = (path.helper[0], path.helper[1]);
        self.approach_part(&path, path.contact, place, request.center_angle_rad, is_rapid);
        if form == KlartextApproachForm::LineAndArc {
            (place[a], place[b]) = (end[a], end[b]);
            self.straight_part(place, is_rapid);
        }
        if end[normal] != start[normal] {
            place[normal] = end[normal];
            self.straight_part(place, is_rapid);
        }
        self.modes.contour.direction = None;
        self.modes.contour.function = PathFunction::Line;
        if kept.0.is_some() && kept.1 == self.kernel.state.feed_mode {
            self.kernel.state.feed = kept.0;
        }
        self.functions_at_end(&words.functions)
    }

    /// The point that the coordinates of a block give, from where the tool is; `None` if that is reported.
    fn contour_point(&mut self, words: &PathWords) -> Option<[f64; 3]> {
        let values = self.values(words)?;
        let start = self.programmed();
        let linear = [start[0], start[1], start[2]];
        let function = match words.polar_radius.is_some() || words.polar_angle.is_some() {
            true => PathFunction::PolarLine,
            false => PathFunction::Line,
        };
        let mut contour = self.modes.contour.clone();
        let found = self.element(function, &values, linear, &mut contour);
        self.modes.contour = contour;
        match found {
            Ok(element) => Some(element.end()),
            Err(fault) => {
                self.report_contour(fault, words);
                None
            }
        }
    }

    /// The data of an approach or departure; `None` if a word is missing, which is reported.
    fn approach_request(
        &mut self,
        form: KlartextApproachForm,
        words: &PathWords,
        point: [f64; 2],
        direction: [f64; 2],
        side: CompensationSide,
        outside: [f64; 2],
    ) -> Option<ApproachRequest> {
        let values = self.values(words)?;
        let missing = match form {
            KlartextApproachForm::Tangent | KlartextApproachForm::Normal => {
                values.length.is_none().then_some("its length LEN")
            }
            KlartextApproachForm::Arc => match (values.radius, values.center_angle) {
                (None, _) => Some("its radius R"),
                (_, None) => Some("its angle CCA"),
                _ => None,
            },
            KlartextApproachForm::LineAndArc => values.radius.is_none().then_some("its radius R"),
        };
        if let Some(missing) = missing {
            let message = format!("this block lacks {missing}");
            self.problem(Code::MissingWord, self.here, message);
            return None;
        }
        Some(ApproachRequest {
            form,
            point,
            direction,
            is_left: side == CompensationSide::Left,
            tool_radius_mm: self.tool_radius_mm(),
            length_mm: values.length.unwrap_or(0.0),
            arc_radius_mm: values.radius.unwrap_or(0.0),
            center_angle_rad: values.center_angle.unwrap_or(0.0).to_radians(),
            outside,
        })
    }

    fn report_approach(&mut self, fault: ApproachFault) {
        let range = self.here;
        let message = match fault {
            ApproachFault::InsideArc(distance_mm, radius) => {
                let [distance_mm, radius] =
                    [distance_mm, radius].map(|mm| self.kernel.length_text(mm));
                format!(
                    "the point outside is {distance_mm} from the centre of the arc, whose radius is {radius}: no line touches it from there"
                )
            }
            ApproachFault::NoRadius => "the radius of the arc is not above zero".to_string(),
        };
        let diagnostic = Diagnostic::new(Code::RadiusTooShort, self.span(range), message);
        let help = "begin further away, or take a smaller radius";
        self.report_alarm(CIRCLE_END, diagnostic.help(help));
    }

    fn straight_part(&mut self, place: [f64; 3], is_rapid: bool) {
        match is_rapid {
            true => self.rapid_to(place, AxisMask::LINEAR),
            false => self.feed_to(place, AxisMask::LINEAR),
        }
    }

    /// The line or arc of an approach or departure, from a point of the plane to `place`.
    fn approach_part(
        &mut self,
        path: &ApproachPath,
        from: [f64; 2],
        place: [f64; 3],
        center_angle_rad: f64,
        is_rapid: bool,
    ) {
        let Some(ApproachArc { center, direction }) = path.arc else {
            return self.straight_part(place, is_rapid);
        };
        let plane = self.tool_plane();
        let (a, b, _) = plane.axes();
        let (center, sweep) = arc_about(from, [place[a], place[b]], center, direction);
        // CCA says how far an arc goes; that of LCT ends where it touches its line.
        let sweep_rad = match center_angle_rad > 0.0 {
            true => direction.sign() * center_angle_rad,
            false => sweep,
        };
        let mut end = self.programmed();
        end[..3].copy_from_slice(&place);
        let element = ContourElement::Arc { plane, center, sweep_rad, end: place };
        self.move_along(None, &element, end, AxisMask::LINEAR, is_rapid);
    }

    /// The direction in which the contour begins at a point: that of the next element which moves in the plane.
    fn next_direction(&mut self, point: [f64; 3]) -> Option<[f64; 2]> {
        let reader = self.running().reader.clone();
        let mut contour = self.modes.contour.clone();
        contour.direction = None;
        let plane = self.tool_plane();
        for block in reader.take(MAX_LOOK_AHEAD_BLOCKS) {
            match &block.statement {
                KlartextStatement::Path(function, words) => {
                    let values = self.values(words)?;
                    let function = match function {
                        PathFunction::Repeated => PathFunction::Line,
                        other => *other,
                    };
                    let element = self.element(function, &values, point, &mut contour).ok()?;
                    if let Some(direction) = element.start_direction(point, plane) {
                        return Some(direction);
                    }
                }
                KlartextStatement::Center(words) => {
                    let values = self.values(words)?;
                    let mut place = self.programmed();
                    place[..3].copy_from_slice(&point);
                    self.place_center(&values, &place, &mut contour);
                }
                KlartextStatement::Nothing
                | KlartextStatement::Functions(_)
                | KlartextStatement::Label(_)
                | KlartextStatement::Rounding(_)
                | KlartextStatement::Chamfer(..)
                | KlartextStatement::NotFollowed(UnfollowedFunction::Probe) => {}
                _ => return None,
            }
        }
        None
    }
}
