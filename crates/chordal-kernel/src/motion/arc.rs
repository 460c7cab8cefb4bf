//! Arcs, helices and full circles: by centre or by radius, with the radius error that a control allows.

use chordal_command::{
    ArcShape, AxisMask, CommandKind, CompensationSide, Feed, FeedAlong, FeedMode, Move, Position,
};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_geometry::{
    ArcSweep, HalfCircleTolerance, Plane, RadiusError, TurnDirection, Vec3, arc_sweep,
    center_from_radius, chords_in_whole,
};

use crate::frames::InPlane;
use crate::kernel::Kernel;
use crate::rules::{ArcCenter, ArcMismatch, FullCircleByRadius, OmittedCenter};
use crate::state::ModalMotion;
use crate::statement::{Statement, WordMeaning};

/// X, Y and Z of a position.
#[inline]
pub(crate) fn point(position: &Position) -> Vec3 {
    Vec3::new(position[0], position[1], position[2])
}

/// The words of an arc, except its end point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArcWords {
    /// Clockwise or counterclockwise.
    pub direction: TurnDirection,
    /// The centre words on the two axes of the plane, mm, `None` when omitted; [`ArcCenter`] says how they are read.
    pub center: [Option<f64>; 2],
    /// Full turns in addition to the arc between start and end.
    pub turns: u32,
}

/// An arc whose ends lie at different distances from its centre: the problem, and the words it comes from.
#[derive(Clone, PartialEq, Debug)]
pub struct MisfitArc {
    /// The problem, not reported yet.
    pub problem: Diagnostic,
    /// The plane.
    pub plane: Plane,
    /// Start point, program coordinates, mm.
    pub start: Position,
    /// End point, program coordinates, mm.
    pub end: Position,
    /// Its words.
    pub arc: ArcWords,
}

impl Kernel<'_> {
    /// The centre on the axes of the plane, mm, when its words are read by `rule`.
    pub fn center(&self, words: [Option<f64>; 2], rule: ArcCenter) -> (f64, f64) {
        let (a, b, _) = self.state.plane.axes();
        let from = self.state.control_position.as_ref().unwrap_or(&self.state.position);
        self.center_from_start((from[a], from[b]), words, rule)
    }

    /// The same for an arc that begins at `start`.
    fn center_from_start(
        &self,
        start: (f64, f64),
        words: [Option<f64>; 2],
        rule: ArcCenter,
    ) -> (f64, f64) {
        let [first, second] = words;
        match rule {
            ArcCenter::FromStart => {
                (start.0 + first.unwrap_or(0.0), start.1 + second.unwrap_or(0.0))
            }
            ArcCenter::FromCenter => {
                (start.0 - first.unwrap_or(0.0), start.1 - second.unwrap_or(0.0))
            }
            ArcCenter::Absolute => {
                // An omitted absolute centre word is the start's coordinate on one control and zero on another.
                let omitted = match self.rules.arc.omitted_center {
                    OmittedCenter::Start => start,
                    OmittedCenter::Zero => (0.0, 0.0),
                };
                (first.unwrap_or(omitted.0), second.unwrap_or(omitted.1))
            }
        }
    }

    /// The distances of the present position and of the end from a centre, in the plane, mm.
    pub fn radii(&self, center: [Option<f64>; 2], target: &Position) -> [f64; 2] {
        let (a, b, _) = self.state.plane.axes();
        let center = self.center(center, self.state.arc_center);
        [&self.state.position, target].map(|place| (place[a] - center.0).hypot(place[b] - center.1))
    }

    /// The arc between two points; its centre words are read by the active rule.
    pub fn sweep_by_words(&self, start: &Position, end: &Position, arc: &ArcWords) -> ArcSweep {
        let plane = self.state.plane;
        let (a, b, _) = plane.axes();
        let center =
            self.center_from_start((start[a], start[b]), arc.center, self.state.arc_center);
        arc_sweep(plane, point(start), point(end), center, arc.direction, arc.turns)
    }

    /// Cuts an arc, a helix or a full circle about a centre.
    pub fn arc_by_center(
        &mut self,
        at: &dyn Statement,
        arc: &ArcWords,
        target: Position,
        named: AxisMask,
    ) {
        if let Some(misfit) = self.arc_about_center(at, arc, target, named) {
            self.report(misfit.problem);
        }
    }

    /// The same, but an arc whose radii differ is returned, for a language that can add to the problem before
    /// it reports it; `None` when the radii agree.
    pub fn arc_about_center(
        &mut self,
        at: &dyn Statement,
        arc: &ArcWords,
        target: Position,
        named: AxisMask,
    ) -> Option<Box<MisfitArc>> {
        if !self.arc_fits_frames(at) {
            self.straight_instead(at, target, named);
            return None;
        }
        let plane = self.state.plane;
        let from = self.state.position;
        let center = self.center(arc.center, self.state.arc_center);
        let (start, end) = (point(&from), point(&target));
        let fit = arc_sweep(plane, start, end, center, arc.direction, arc.turns);
        if fit.radius_start <= self.rules.arc.coincidence_mm {
            self.report_zero_radius(at);
            self.straight_instead(at, target, named);
            return None;
        }
        // The control checks the arc from where it assumes the tool to be.
        let judged = match self.state.control_position {
            None => self.fit_in_work(&fit, center, arc, &target),
            Some(place) => arc_sweep(plane, point(&place), end, center, arc.direction, arc.turns),
        };
        let misfit = self.misfit(at, &judged, arc, &target);
        self.check_radius_limit(at, judged.radius_start.max(judged.radius_end));
        self.check_vanishing_circle(at, &fit);
        self.emit_arc(at, center, &fit, target, named);
        misfit
    }

    /// Cuts an arc by its radius, mm; negative for more than half a circle.
    pub fn arc_by_radius(
        &mut self,
        at: &dyn Statement,
        radius: (Span, f64),
        arc: &ArcWords,
        target: Position,
        named: AxisMask,
    ) {
        let (span, radius) = radius;
        if !self.arc_fits_frames(at) {
            return self.straight_instead(at, target, named);
        }
        let plane = self.state.plane;
        let (start, end) = (point(&self.state.position), point(&target));
        // Rounding must not decide when the error equals the tolerance.
        let tolerance = self.rules.half_circle_tolerance(self.state.units);
        let found = match self.state.frames.in_plane(plane) {
            InPlane::Unequal { largest, mirrored } => {
                self.unequal_center(&target, radius * largest, arc.direction, mirrored, tolerance)
            }
            // The control checks the arc in the work coordinate system.
            InPlane::Similar { factor, .. } => {
                let tolerance = tolerance.scaled(1.0 / factor);
                center_from_radius(plane, start, end, radius, arc.direction, tolerance)
            }
            InPlane::Tilted => {
                center_from_radius(plane, start, end, radius, arc.direction, tolerance)
            }
        };
        match found {
            Ok(center) => {
                let fit = arc_sweep(plane, start, end, center, arc.direction, arc.turns);
                let judged = self.fit_in_work(&fit, center, arc, &target);
                self.check_radius_limit(at, judged.radius_start);
                self.emit_arc(at, center, &fit, target, named);
            }
            Err(RadiusError::FullCircle) => self.full_circle_by_radius(at, span, target, named),
            Err(RadiusError::TooShort { chord, radius, short_by }) => {
                let (chord, radius, needed, short) = (
                    self.length_text(chord),
                    self.length_text(radius),
                    self.length_text(chord / 2.0),
                    self.length_text(short_by),
                );
                self.report(
                    Diagnostic::new(
                        Code::RadiusTooShort,
                        span,
                        format!(
                            "start and end are {chord} apart; a radius of {radius} does not reach"
                        ),
                    )
                    .label(format!("short by {short}"))
                    .help(format!("the radius must be at least {needed}; check the end point too")),
                );
                self.straight_instead(at, target, named);
            }
            Err(RadiusError::NotFinite) => {}
        }
    }

    /// The arc in the work coordinate system, where the control checks it.
    fn fit_in_work(
        &self,
        fit: &ArcSweep,
        center: (f64, f64),
        arc: &ArcWords,
        target: &Position,
    ) -> ArcSweep {
        if self.state.frames.is_plain() {
            return *fit;
        }
        let plane = self.state.plane;
        let (a, b, _) = plane.axes();
        let map = self.state.frames.map();
        let mut place = *target;
        (place[a], place[b]) = center;
        let place = map.point(&place);
        let (from, to) = (map.point(&self.state.position), map.point(target));
        if self.state.frames.in_plane(plane) == InPlane::Tilted {
            return *fit;
        }
        let direction = arc.direction.mirrored_if(self.state.frames.in_plane(plane).is_mirrored());
        let center = (place[a], place[b]);
        arc_sweep(plane, point(&from), point(&to), center, direction, arc.turns)
    }

    /// The centre, in program coordinates, of an arc by its radius when the axes of the plane are scaled
    /// differently: the ends are scaled by their own factors, the radius by the larger one.
    fn unequal_center(
        &self,
        target: &Position,
        radius: f64,
        direction: TurnDirection,
        mirrored: bool,
        tolerance: HalfCircleTolerance,
    ) -> Result<(f64, f64), RadiusError> {
        let plane = self.state.plane;
        let (a, b, _) = plane.axes();
        let frames = &self.state.frames;
        let from = frames.map().point(&self.state.position);
        let to = frames.map().point(target);
        let direction = direction.mirrored_if(mirrored);
        let (start, end) = (point(&from), point(&to));
        let (x, y) = center_from_radius(plane, start, end, radius, direction, tolerance)?;
        let mut place = from;
        (place[a], place[b]) = (x, y);
        let place = frames.inverse().point(&place);
        Ok((place[a], place[b]))
    }

    fn full_circle_by_radius(
        &mut self,
        at: &dyn Statement,
        span: Span,
        target: Position,
        named: AxisMask,
    ) {
        let [a, b] = at.center_names(self.state.plane);
        let by = format!("give the centre with {a} or {b} and leave the end out");
        let (what, severity) = match self.rules.arc.full_circle_by_radius {
            FullCircleByRadius::Refused => ("the control refuses it", Severity::Error),
            FullCircleByRadius::NoMotion => ("nothing moves", Severity::Warning),
            FullCircleByRadius::Straight => return self.straight_instead(at, target, named),
        };
        self.report(
            Diagnostic::new(
                Code::FullCircleByRadius,
                span,
                format!("start and end are the same point: a radius gives no circle, and {what}"),
            )
            .severity(severity)
            .help(by),
        );
        if self.rules.arc.full_circle_by_radius == FullCircleByRadius::Refused {
            self.straight_instead(at, target, named);
        }
    }

    /// Emits the arc; with [`ArcMismatch::ArcThenLine`] and a radius error, an arc of the start's radius and then a
    /// line to the end.
    pub fn emit_arc(
        &mut self,
        at: &dyn Statement,
        center: (f64, f64),
        fit: &ArcSweep,
        target: Position,
        named: AxisMask,
    ) {
        let error = fit.radius_error().abs();
        let parameters = &self.rules.arc;
        let plane = self.state.plane;
        let equal = !matches!(self.state.frames.in_plane(plane), InPlane::Unequal { .. });
        let rest = parameters.arc_mismatch == ArcMismatch::ArcThenLine
            && equal
            && error > parameters.coincidence_mm
            && error <= parameters.radius_error_tolerance_mm;
        let mut shape = ArcShape {
            plane,
            center: [center.0, center.1],
            sweep: fit.sweep,
            radius_from: fit.radius_start,
            radius_to: fit.radius_end,
        };
        let mut arc_end = target;
        if rest {
            // The intersection of the arc of the start's radius with the ray from the centre to the programmed end.
            let (a, b, _) = plane.axes();
            let scale = fit.radius_start / fit.radius_end;
            arc_end[a] = center.0 + (target[a] - center.0) * scale;
            arc_end[b] = center.1 + (target[b] - center.1) * scale;
            shape.radius_to = fit.radius_start;
        }
        self.check_rotary_in_arc(at, &target);
        let (_, _, normal) = plane.axes();
        let tilted = self.state.frames.in_plane(plane) == InPlane::Tilted;
        if tilted && arc_end[normal] != self.state.position[normal] {
            self.report(
                Diagnostic::new(
                    Code::NotFollowed,
                    at.span(),
                    "a helix of another plane in a rotated work coordinate system is not followed",
                )
                .label("shown as a straight line"),
            );
            return self.straight_instead(at, target, named);
        }
        let motion = self.moved_to(arc_end, named);
        let mut feed = self.feed_for(at, &motion, Some(&shape));
        feed.along = self.feed_along(&motion, plane);
        self.take_speed_of_segments(at, &shape, &mut feed);
        self.emit(CommandKind::Arc { motion, shape, feed });
        if rest {
            let motion = self.moved_to(target, named);
            feed.along = FeedAlong::Path;
            self.emit(CommandKind::Line { motion, feed });
        }
    }

    /// Inverse time on a control that divides arcs into segments: F times their number becomes mm/min (GRBL).
    fn take_speed_of_segments(&mut self, at: &dyn Statement, shape: &ArcShape, feed: &mut Feed) {
        let Some(junctions) = self.rules.path.junctions else { return };
        if feed.mode != FeedMode::InverseTime || feed.value.is_nan() || feed.value <= 0.0 {
            return;
        }
        let (radius, angle) = (shape.radius_from, shape.sweep.abs());
        let count = chords_in_whole(radius, angle, junctions.arc_tolerance_mm);
        if !count.is_finite() || count < 1.0 {
            return;
        }
        let each_minute = feed.value * 60.0;
        (feed.value, feed.mode) = (feed.value * count, FeedMode::PerTime);
        if std::mem::replace(&mut self.reported.inverse_time_arc, true) {
            return;
        }
        let length = (shape.radius_from * shape.sweep).abs();
        let meant = self.length_text(length * each_minute);
        let runs = self.length_text(each_minute * count);
        let message = format!(
            "an arc in inverse time runs at {runs}/min here, not at {meant}/min: the control multiplies F by the \
             {count} segments of the arc and takes that for mm/min"
        );
        self.report(
            Diagnostic::new(Code::InverseTimeArc, at.span(), message)
                .label("the first one in this program")
                .help("write G94 and a feed per minute before arcs"),
        );
    }

    /// What F measures on a helix; on a flat arc both are the same.
    pub fn feed_along(&self, motion: &Move, plane: Plane) -> FeedAlong {
        let (_, _, normal) = plane.axes();
        if motion.from[normal] == motion.to[normal] {
            FeedAlong::Path
        } else {
            self.rules.arc.helix_feed
        }
    }

    /// Moves an end that misses the start by rounding only onto the start: a full circle.
    #[inline]
    pub fn snap_to_start(&self, target: &mut Position) {
        let (a, b, _) = self.state.plane.axes();
        let from = &self.state.position;
        let (da, db) = (target[a] - from[a], target[b] - from[b]);
        let near = self.rules.arc.coincidence_mm;
        if da * da + db * db < near * near {
            target[a] = from[a];
            target[b] = from[b];
        }
    }

    /// Moves straight to the end of an arc that cannot be made.
    pub fn straight_instead(&mut self, at: &dyn Statement, target: Position, named: AxisMask) {
        if target == self.state.position {
            return;
        }
        if self.state.motion == ModalMotion::Rapid {
            return self.straight(at, target, named);
        }
        self.line(at, target, named);
    }

    #[inline]
    fn misfit(
        &mut self,
        at: &dyn Statement,
        fit: &ArcSweep,
        arc: &ArcWords,
        target: &Position,
    ) -> Option<Box<MisfitArc>> {
        let p = &self.rules.arc;
        let error = fit.radius_error().abs();
        // Rounding must not decide when the error equals the tolerance.
        let factor = p.radius_error_factor(self.state.units);
        if p.judged_before || error <= factor * p.radius_error_tolerance_mm * (1.0 + 1e-9) {
            return None;
        }
        let by_radius = p.radius_error_relative > 0.0
            && error <= factor * p.radius_error_limit_mm
            && error <= p.radius_error_relative * fit.radius_start.max(fit.radius_end);
        if by_radius { None } else { Some(self.misfit_arc(at, fit, arc, target)) }
    }

    #[cold]
    fn misfit_arc(
        &mut self,
        at: &dyn Statement,
        fit: &ArcSweep,
        arc: &ArcWords,
        target: &Position,
    ) -> Box<MisfitArc> {
        let span = at.words(WordMeaning::EndAndCenter(self.state.plane));
        let error = self.length_text(fit.radius_error().abs());
        let factor = self.rules.arc.radius_error_factor(self.state.units);
        let allowed = self.length_text(factor * self.rules.arc.radius_error_tolerance_mm);
        let (from, to) = (self.length_text(fit.radius_start), self.length_text(fit.radius_end));
        let place = if fit.radius_end > fit.radius_start { "outside" } else { "inside" };
        let alarm = self.alarm_text(Code::RadiusMismatch, Some(error.clone()));
        let mut diagnostic = Diagnostic::new(
            Code::RadiusMismatch,
            span,
            format!("the end is {error} off the arc; this control allows {allowed}"),
        )
        .label(format!("radius {from} at the start, {to} at the end"))
        .note(format!("the end lies {place} the circle through the start"));
        diagnostic.alarm = alarm;
        diagnostic = match self.other_center(fit, arc, target) {
            Some((rule, radius)) => self.with_other_center(diagnostic, rule, radius),
            None => diagnostic.help(
                "check the end point and the centre words of this block, and the end point of the \
                 block before, where the arc starts",
            ),
        };
        Box::new(MisfitArc {
            problem: diagnostic,
            plane: self.state.plane,
            start: self.state.position,
            end: *target,
            arc: *arc,
        })
    }

    /// Adds the note that the same words make a true arc under another rule for the centre, and at the first such
    /// arc the setting for it.
    fn with_other_center(
        &mut self,
        diagnostic: Diagnostic,
        rule: ArcCenter,
        radius: f64,
    ) -> Diagnostic {
        let (words, value) = match rule {
            ArcCenter::FromStart => ("from the start to the centre", "from-start"),
            ArcCenter::Absolute => ("as the centre's coordinates", "absolute"),
            ArcCenter::FromCenter => ("from the centre to the start", "from-center"),
        };
        let radius = self.length_text(radius);
        let diagnostic = diagnostic
            .note(format!("the radii agree ({radius}) when the centre words are read {words}"));
        if self.reported.other_center.replace(rule) == Some(rule) {
            return diagnostic.help("as at the first arc with this problem");
        }
        diagnostic.help(format!(
            "if all centres of this program are meant so, --set settings.arc_center={value}; \
             otherwise check the end point and the centre words of this block"
        ))
    }

    /// Another rule for the centre under which the same words make a true arc (radii agree to 1 % of the present
    /// error), and its radius, mm; `None` when there is none.
    fn other_center(
        &self,
        fit: &ArcSweep,
        arc: &ArcWords,
        target: &Position,
    ) -> Option<(ArcCenter, f64)> {
        let (a, b, _) = self.state.plane.axes();
        let active = self.state.arc_center;
        let (start, end) =
            ((self.state.position[a], self.state.position[b]), (target[a], target[b]));
        let rules = [ArcCenter::FromStart, ArcCenter::Absolute, ArcCenter::FromCenter];
        rules.into_iter().filter(|rule| *rule != active).find_map(|rule| {
            let center = self.center(arc.center, rule);
            let radius =
                |p: (f64, f64)| ((p.0 - center.0).powi(2) + (p.1 - center.1).powi(2)).sqrt();
            let (from, to) = (radius(start), radius(end));
            let is_true = from > 1e-6 && (from - to).abs() < 0.01 * fit.radius_error().abs();
            is_true.then_some((rule, from))
        })
    }

    fn check_radius_limit(&mut self, at: &dyn Statement, radius: f64) {
        let parameters = &self.rules.arc;
        let compensated = self.state.side != CompensationSide::Off;
        let limit = if compensated {
            parameters.max_radius_compensated_mm
        } else {
            parameters.max_radius_mm
        };
        if radius <= limit * (1.0 + 1e-9) {
            return;
        }
        let (is, allowed) = (self.length_text(radius), self.length_text(limit));
        let with = if compensated { " with cutter compensation" } else { "" };
        let span = at.words(WordMeaning::CenterOrRadius);
        self.report(
            Diagnostic::new(
                Code::RadiusOverLimit,
                span,
                format!("a radius of {is} is above the {allowed} that this control allows{with}"),
            )
            .label(format!("at most {allowed}"))
            .help("program it as lines, or with arcs of a smaller radius"),
        );
    }

    fn report_zero_radius(&mut self, at: &dyn Statement) {
        let span = at.words(WordMeaning::Center);
        let (severity, label) = if self.rules.arc.judged_before {
            (Severity::Warning, "the control moves straight to the end")
        } else {
            (Severity::Error, "these words place it there")
        };
        self.report(
            Diagnostic::new(Code::ZeroRadius, span, "the centre of this arc is its start point")
                .severity(severity)
                .label(label)
                .help(match self.state.arc_center {
                    ArcCenter::FromStart => "give the distance from the start to the centre",
                    ArcCenter::Absolute => "give the coordinates of the centre",
                    ArcCenter::FromCenter => "give the distance from the centre to the start",
                }),
        );
    }

    /// Reports a rotary axis in an arc block, on a control that does not move it there.
    pub fn check_rotary_in_arc(&mut self, at: &dyn Statement, target: &Position) {
        let turns = target[3..] != self.state.position[3..];
        // Tool centre point control is made to turn while the tip goes along an arc.
        let follows_tip = self.state.part_frame.as_ref().is_some_and(|frame| frame.follows_tip);
        if self.rules.arc.rotary_in_arc || !turns || follows_tip {
            return;
        }
        let title = self.alarms.title;
        let span = at.words(WordMeaning::Axes(AxisMask::ROTARY));
        self.report(
            Diagnostic::new(
                Code::RotaryInArc,
                span,
                format!("a rotary axis in the block of an arc: {title} does not turn it there"),
            )
            .label("shown turning with the arc")
            .help("turn it in a block before; if this machine turns it with the arc, set `rotary_in_arc`"),
        );
    }
}
