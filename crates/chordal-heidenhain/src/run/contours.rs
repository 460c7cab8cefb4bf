//! Path functions → lines and arcs in programmed coordinates.

use std::f64::consts::TAU;

use chordal_diagnostics::Code;
use chordal_geometry::{Plane, RadiusError, TurnDirection, Vec2};
use chordal_kernel::frames::sin_cos_degrees;

use super::block_values::BlockValues;
use super::interpreter::KlartextInterpreter;
use super::run_state::ContourMemory;
use crate::alarms::{ANGLE_REFERENCE, CENTER_UNDEFINED, CIRCLE_END};
use crate::geometry::{
    COINCIDENT_POINTS_MM, ContourElement, arc_about, arc_by_radius, arc_fault_mm, tangent_center,
};
use crate::syntax::PathFunction;

/// Why a path function gives no element.
#[derive(Clone, PartialEq, Debug)]
pub struct ContourFault {
    /// The code of the problem.
    pub code: Code,
    /// The control's own words; `None` where they are not known.
    pub alarm: Option<&'static str>,
    /// What is wrong.
    pub message: String,
    /// What to do; empty where nothing else can be said.
    pub help: &'static str,
    /// The radius is at fault.
    pub is_of_radius: bool,
}

impl ContourFault {
    fn new(code: Code, message: impl Into<String>, help: &'static str) -> ContourFault {
        ContourFault { code, alarm: None, message: message.into(), help, is_of_radius: false }
    }

    fn with_alarm(self, alarm: &'static str) -> ContourFault {
        ContourFault { alarm: Some(alarm), ..self }
    }
}

impl KlartextInterpreter<'_> {
    /// The element of a path function that begins at `start`, mm; the memory takes what the function leaves.
    pub(super) fn element(
        &self,
        function: PathFunction,
        values: &BlockValues,
        start: [f64; 3],
        contour: &mut ContourMemory,
    ) -> Result<ContourElement, ContourFault> {
        let mut end = start;
        for (axis, value) in end.iter_mut().enumerate() {
            if let Some(coordinate) = values.axes[axis] {
                *value = coordinate.from(*value);
            }
        }
        let own = self.tool_plane();
        match function {
            PathFunction::Line | PathFunction::Repeated => Ok(ContourElement::Line { end }),
            PathFunction::PolarLine => {
                self.polar_end(values, start, contour, &mut end)?;
                Ok(ContourElement::Line { end })
            }
            PathFunction::CenterArc => {
                let plane = contour.center_plane.unwrap_or(own);
                let center = center_of(contour, plane)?;
                self.center_arc(values, plane, center, start, end)
            }
            PathFunction::PolarArc => self.polar_arc(values, contour, start, end),
            PathFunction::RadiusArc => self.radius_arc(values, own, start, end),
            PathFunction::TangentArc => tangent_arc(own, contour, start, end),
            PathFunction::PolarTangentArc => {
                self.polar_end(values, start, contour, &mut end)?;
                let plane = contour.center_plane.unwrap_or(own);
                tangent_arc(plane, contour, start, end)
            }
        }
    }

    /// The end of a block with PR and PA.
    fn polar_end(
        &self,
        values: &BlockValues,
        start: [f64; 3],
        contour: &mut ContourMemory,
        end: &mut [f64; 3],
    ) -> Result<(), ContourFault> {
        let plane = contour.center_plane.unwrap_or(self.tool_plane());
        let center = center_of(contour, plane)?;
        let (a, b, _) = plane.axes();
        let from = Vec2::new(start[a], start[b]);
        let radius_now = center.distance(from);
        let angle_now = libm::atan2(from.b - center.b, from.a - center.a).to_degrees();
        let [last_radius, last_angle] = contour.polar;
        let radius = match values.polar_radius {
            Some(word) => word.from(last_radius.unwrap_or(radius_now)),
            None => last_radius.unwrap_or(radius_now),
        };
        let angle = match values.polar_angle {
            Some(word) => word.from(last_angle.unwrap_or(angle_now)),
            None => last_angle.unwrap_or(angle_now),
        };
        let (sin, cos) = sin_cos_degrees(angle);
        (end[a], end[b]) = (center.a + radius * cos, center.b + radius * sin);
        contour.polar = [Some(radius), Some(angle)];
        Ok(())
    }

    /// C: an arc about CC.
    fn center_arc(
        &self,
        values: &BlockValues,
        plane: Plane,
        center: Vec2,
        start: [f64; 3],
        end: [f64; 3],
    ) -> Result<ContourElement, ContourFault> {
        let (a, b, _) = plane.axes();
        let (from, to) = (Vec2::new(start[a], start[b]), Vec2::new(end[a], end[b]));
        let direction = direction_of(values)?;
        let radius = center.distance(from);
        let off = arc_fault_mm(from, to, center);
        let allowed = self.programs.settings.arc_tolerance_mm;
        if radius <= COINCIDENT_POINTS_MM || off.abs() > allowed {
            let [one, other, most] =
                [radius, radius + off, allowed].map(|mm| self.kernel.length_text(mm));
            let message = format!(
                "the circle centre is {one} from the start and {other} from the end: at most {most} apart is allowed"
            );
            let help = "check the end point and CC";
            return Err(
                ContourFault::new(Code::RadiusMismatch, message, help).with_alarm(CIRCLE_END)
            );
        }
        let (center, sweep_rad) = arc_about(from, to, center, direction);
        Ok(arc(plane, center, sweep_rad, end))
    }

    /// CP: an arc about CC by its angle.
    fn polar_arc(
        &self,
        values: &BlockValues,
        contour: &mut ContourMemory,
        start: [f64; 3],
        mut end: [f64; 3],
    ) -> Result<ContourElement, ContourFault> {
        let plane = contour.center_plane.unwrap_or(self.tool_plane());
        let center = center_of(contour, plane)?;
        let (a, b, _) = plane.axes();
        let from = Vec2::new(start[a], start[b]);
        let radius = center.distance(from);
        if radius <= COINCIDENT_POINTS_MM {
            let message = "the arc begins at its own centre";
            return Err(ContourFault::new(
                Code::ZeroRadius,
                message,
                "move away from CC before it",
            )
            .with_alarm(CIRCLE_END));
        }
        let angle_now = libm::atan2(from.b - center.b, from.a - center.a).to_degrees();
        let Some(word) = values.polar_angle else {
            let message = "CP has no angle PA or IPA";
            return Err(ContourFault::new(Code::MissingWord, message, "write PA or IPA"));
        };
        let sweep_deg = if word.is_incremental {
            let own = if word.value < 0.0 { TurnDirection::Cw } else { TurnDirection::Ccw };
            if values.direction.is_some_and(|direction| direction != own) && word.value != 0.0 {
                let message = format!(
                    "IPA{:+} turns against {}",
                    word.value,
                    if own == TurnDirection::Cw { "DR+" } else { "DR-" }
                );
                let help = "the sign of IPA is that of DR";
                return Err(ContourFault::new(Code::BadWordValue, message, help));
            }
            word.value
        } else {
            let direction = direction_of(values)?.sign();
            let turned = (direction * (word.value - angle_now)).rem_euclid(360.0);
            // An end at the start is a full circle; rounding must not decide.
            let turned = if (1e-9..=360.0 - 1e-9).contains(&turned) { turned } else { 360.0 };
            direction * turned
        };
        let angle = if word.is_incremental { angle_now + sweep_deg } else { word.value };
        let whole = (sweep_deg / 360.0).fract() == 0.0;
        let (sin, cos) = sin_cos_degrees(angle);
        (end[a], end[b]) = match whole {
            true => (from.a, from.b),
            false => (center.a + radius * cos, center.b + radius * sin),
        };
        contour.polar = [Some(radius), Some(angle)];
        if sweep_deg == 0.0 {
            return Ok(ContourElement::Line { end });
        }
        Ok(arc(plane, center, sweep_deg / 360.0 * TAU, end))
    }

    /// CR: an arc by its radius.
    fn radius_arc(
        &self,
        values: &BlockValues,
        plane: Plane,
        start: [f64; 3],
        end: [f64; 3],
    ) -> Result<ContourElement, ContourFault> {
        let (a, b, _) = plane.axes();
        let Some(radius) = values.radius else {
            let message = "CR has no radius R";
            return Err(ContourFault::new(Code::MissingWord, message, "write R+ or R-"));
        };
        let direction = direction_of(values)?;
        let (from, to) = (Vec2::new(start[a], start[b]), Vec2::new(end[a], end[b]));
        let of_radius = |code, message: String, help| ContourFault {
            is_of_radius: true,
            ..ContourFault::new(code, message, help).with_alarm(CIRCLE_END)
        };
        match arc_by_radius(from, to, radius, direction) {
            Ok((center, sweep_rad)) => Ok(arc(plane, center, sweep_rad, end)),
            Err(RadiusError::FullCircle) => {
                let message = "start and end of CR are one point: a radius gives no circle";
                let help = "write a full circle with CC and C";
                Err(of_radius(Code::FullCircleByRadius, message.into(), help))
            }
            Err(RadiusError::TooShort { chord, radius, .. }) => {
                let [chord, radius, needed] =
                    [chord, radius.abs(), chord / 2.0].map(|mm| self.kernel.length_text(mm));
                let message = format!(
                    "start and end are {chord} apart; a radius of {radius} does not reach: it must be {needed} or more"
                );
                Err(of_radius(Code::RadiusTooShort, message, "check the radius and the end point"))
            }
            Err(RadiusError::NotFinite) => {
                Err(of_radius(Code::NumberOverflow, "the radius is too large".into(), ""))
            }
        }
    }
}

fn arc(plane: Plane, center: Vec2, sweep_rad: f64, end: [f64; 3]) -> ContourElement {
    ContourElement::Arc { plane, center: center.to_array(), sweep_rad, end }
}

/// CC on the axes of a plane.
fn center_of(contour: &ContourMemory, plane: Plane) -> Result<Vec2, ContourFault> {
    let (a, b, _) = plane.axes();
    match (contour.center[a], contour.center[b]) {
        (Some(first), Some(second)) => Ok(Vec2::new(first, second)),
        _ => {
            let message = "no circle centre CC was programmed before this block";
            let help = "write CC with both coordinates before it";
            Err(ContourFault::new(Code::NoCenter, message, help).with_alarm(CENTER_UNDEFINED))
        }
    }
}

fn direction_of(values: &BlockValues) -> Result<TurnDirection, ContourFault> {
    values.direction.ok_or_else(|| {
        ContourFault::new(Code::MissingWord, "the arc has no direction DR", "write DR+ or DR-")
    })
}

/// CT: an arc that goes on in the direction of the element before.
fn tangent_arc(
    plane: Plane,
    contour: &ContourMemory,
    start: [f64; 3],
    end: [f64; 3],
) -> Result<ContourElement, ContourFault> {
    let (a, b, _) = plane.axes();
    let Some(direction) = contour.direction else {
        let message = "a tangent arc needs an element before it that moves in the plane";
        let help = "write L, C, CR or CT with a move in the plane before it";
        return Err(ContourFault::new(Code::NoCenter, message, help).with_alarm(ANGLE_REFERENCE));
    };
    Ok(match tangent_center(Vec2::new(start[a], start[b]), direction, Vec2::new(end[a], end[b])) {
        Some((center, sweep_rad)) => arc(plane, center, sweep_rad, end),
        None => ContourElement::Line { end },
    })
}
