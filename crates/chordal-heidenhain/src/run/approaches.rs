//! APPR and DEP.

use chordal_command::{AxisMask, CompensationSide};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::Vec2;

use super::free_contours::FreeBlock;
use super::interpreter::KlartextInterpreter;
use super::run_state::KlartextFlow;
use crate::alarms::CIRCLE_END;
use crate::geometry::{
    ApproachArc, ApproachFault, ApproachPath, ApproachRequest, ContourElement, approach_path,
    arc_about, departure_path,
};
use crate::syntax::{
    KlartextApproachForm, KlartextStatement, PathFunction, PathWords, UnfollowedFunction,
};

/// Blocks that are looked at for the first element after APPR.
const MAX_LOOK_AHEAD_BLOCKS: usize = 50;

/// The point and the direction of a contour at which an approach ends or a departure begins.
#[derive(Clone, Copy)]
struct ContourJoint {
    point: Vec2,
    direction: Vec2,
    side: CompensationSide,
    /// Where the tool comes from or goes to.
    outside: Vec2,
}

impl KlartextInterpreter<'_> {
    /// APPR: to the first point of a contour. The tool's centre goes to PH, from there to the offset point of the contour,
    /// where compensation begins.
    pub(super) fn approach(
        &mut self,
        form: KlartextApproachForm,
        words: &PathWords,
    ) -> KlartextFlow {
        self.functions_at_start(words);
        let is_straight_first = form != KlartextApproachForm::LineAndArc;
        // The line to PH has the feed before the block, the approach itself that of the block.
        let is_rapid = !is_straight_first && self.apply_feed(words.feed);
        let Some(point) = self.contour_point(words) else { return KlartextFlow::Next };
        let Some((end, request)) = self.approach_request_to(form, words, point) else {
            return KlartextFlow::Next;
        };
        let path = self.path_or_line(&request, approach_path(&request));
        self.approach_helper(&path, point, is_rapid);
        let is_rapid = if is_straight_first { self.apply_feed(words.feed) } else { is_rapid };
        let place = self.in_plane(point, path.contact);
        self.approach_part(&path, path.helper, place, request.center_angle_rad, is_rapid);
        self.switch_compensation(end.side);
        self.straight_part(point, false);
        self.modes.contour.direction = Some(end.direction);
        self.modes.contour.function = PathFunction::Line;
        self.functions_at_end(&words.functions)
    }

    /// What an approach to a point is made of; `None` if something is missing, which is reported.
    fn approach_request_to(
        &mut self,
        form: KlartextApproachForm,
        words: &PathWords,
        point: [f64; 3],
    ) -> Option<(ContourJoint, ApproachRequest)> {
        let Some((side, range)) = words.side.filter(|(side, _)| *side != CompensationSide::Off)
        else {
            let message = "APPR has neither RL nor RR: on which side the tool comes is not known";
            self.problem(Code::MissingWord, self.here, message);
            return None;
        };
        self.check_tool(side, range);
        let Some(direction) = self.next_direction(point) else {
            let what = "the first element after APPR is not known here, so that the approach is not followed";
            self.not_followed(self.here, what);
            self.kernel.go_astray(AxisMask::XY);
            return None;
        };
        let outside = self.on_plane(&self.programmed());
        let end = ContourJoint { point: self.on_plane(&point), direction, side, outside };
        Some((end, self.approach_request(form, words, end)?))
    }

    /// The straight part to PH: first in the plane, then along the axis of the tool.
    fn approach_helper(&mut self, path: &ApproachPath, point: [f64; 3], is_rapid: bool) {
        let normal = self.tool_axis();
        let start = self.programmed();
        let mut place = self.in_plane([start[0], start[1], start[2]], path.helper);
        self.straight_part(place, is_rapid);
        if place[normal] != point[normal] {
            place[normal] = point[normal];
            self.straight_part(place, is_rapid);
        }
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
        let Some((end, request)) = self.departure_request(form, words) else {
            return KlartextFlow::Next;
        };
        let path = self.path_or_line(&request, departure_path(&request));
        self.departure_moves(form, &path, end, request.center_angle_rad, is_rapid);
        self.modes.contour.direction = None;
        self.modes.contour.function = PathFunction::Line;
        // F of the block is for the departure alone.
        if kept.0.is_some() && kept.1 == self.kernel.state.feed_mode {
            self.kernel.state.feed = kept.0;
        }
        self.functions_at_end(&words.functions)
    }

    /// Where a departure ends and what it is made of; `None` if something is missing, which is reported.
    fn departure_request(
        &mut self,
        form: KlartextApproachForm,
        words: &PathWords,
    ) -> Option<([f64; 3], ApproachRequest)> {
        let side = self.programmed_side();
        let direction = self.modes.contour.direction.filter(|_| side != CompensationSide::Off);
        let Some(direction) = direction else {
            let message = "DEP leaves a contour with compensation, and none is active here";
            self.problem(Code::CompensationWithoutOffset, self.here, message);
            return None;
        };
        let end = self.contour_point(words)?;
        let point = self.on_plane(&self.programmed());
        let outside = self.on_plane(&end);
        let contour = ContourJoint { point, direction, side, outside };
        Some((end, self.approach_request(form, words, contour)?))
    }

    fn departure_moves(
        &mut self,
        form: KlartextApproachForm,
        path: &ApproachPath,
        end: [f64; 3],
        center_angle_rad: f64,
        is_rapid: bool,
    ) {
        let normal = self.tool_axis();
        self.switch_compensation(CompensationSide::Off);
        let start = self.programmed();
        let start = [start[0], start[1], start[2]];
        self.straight_part(self.in_plane(start, path.contact), false);
        let mut place = self.in_plane(start, path.helper);
        self.approach_part(path, path.contact, place, center_angle_rad, is_rapid);
        if form == KlartextApproachForm::LineAndArc {
            place = self.in_plane(place, self.on_plane(&end));
            self.straight_part(place, is_rapid);
        }
        if end[normal] != start[normal] {
            place[normal] = end[normal];
            self.straight_part(place, is_rapid);
        }
    }

    /// A position on the axes of the plane of the tool.
    fn on_plane(&self, place: &[f64]) -> Vec2 {
        let (a, b, _) = self.tool_plane().axes();
        Vec2::new(place[a], place[b])
    }

    /// A position with another point of the plane of the tool.
    fn in_plane(&self, mut place: [f64; 3], point: Vec2) -> [f64; 3] {
        let (a, b, _) = self.tool_plane().axes();
        (place[a], place[b]) = (point.a, point.b);
        place
    }

    /// The path, or where there is none a straight line, which is reported.
    fn path_or_line(
        &mut self,
        request: &ApproachRequest,
        found: Result<ApproachPath, ApproachFault>,
    ) -> ApproachPath {
        found.unwrap_or_else(|fault| {
            self.report_approach(fault);
            ApproachPath { helper: request.outside, contact: request.point, arc: None }
        })
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
        end: ContourJoint,
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
            point: end.point,
            direction: end.direction,
            is_left: end.side == CompensationSide::Left,
            tool_radius_mm: self.tool_radius_mm(),
            length_mm: values.length.unwrap_or(0.0),
            arc_radius_mm: values.radius.unwrap_or(0.0),
            center_angle_rad: values.center_angle.unwrap_or(0.0).to_radians(),
            outside: end.outside,
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
        from: Vec2,
        place: [f64; 3],
        center_angle_rad: f64,
        is_rapid: bool,
    ) {
        let Some(ApproachArc { center, direction }) = path.arc else {
            return self.straight_part(place, is_rapid);
        };
        let plane = self.tool_plane();
        let (center, sweep) = arc_about(from, self.on_plane(&place), center, direction);
        // CCA says how far an arc goes; that of LCT ends where it touches its line.
        let sweep_rad = match center_angle_rad > 0.0 {
            true => direction.sign() * center_angle_rad,
            false => sweep,
        };
        let mut end = self.programmed();
        end[..3].copy_from_slice(&place);
        let center = center.to_array();
        let element = ContourElement::Arc { plane, center, sweep_rad, end: place };
        self.move_along(None, &element, end, AxisMask::LINEAR, is_rapid);
    }

    /// The direction in which the contour begins at a point: that of the next element which moves in the plane.
    fn next_direction(&mut self, point: [f64; 3]) -> Option<Vec2> {
        let mut reader = self.running().reader.clone();
        let mut contour = self.modes.contour.clone();
        contour.direction = None;
        let plane = self.tool_plane();
        for _ in 0..MAX_LOOK_AHEAD_BLOCKS {
            let block = reader.next()?;
            if self.is_skipped(&block) {
                continue;
            }
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
                KlartextStatement::FreeElement(words) => {
                    let (range, number) = (block.range, block.number);
                    let block = FreeBlock { range, number, words };
                    return self.free_start_direction(block, reader, point);
                }
                KlartextStatement::FreePole(words) => {
                    self.modes.free_pole = self.free_pole(words, point);
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
