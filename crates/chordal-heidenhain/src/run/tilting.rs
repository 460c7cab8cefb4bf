//! Tilted planes (PLANE, cycle 19) and the control of the tip (M128, FUNCTION TCPM).

use chordal_command::AxisMask;
use chordal_diagnostics::{Code, TextRange};
use chordal_geometry::{Frame, Transform, Vec3};
use chordal_kernel::frames::plane_forms;
use chordal_kernel::{AngleSign, TurnError};

use super::interpreter::KlartextInterpreter;
use super::transformations::CoordinateChain;
use crate::syntax::{OperandWord, PlaneForm, PlanePositioning, PlaneWords};

/// A vector, or its part across another one, that is shorter has no direction.
const LEAST_LENGTH: f64 = 1e-9;

/// The rotation of three spatial angles, degrees: about X first, then Y, then Z, each about the axes before the rotation
/// (R = Rz·Ry·Rx).
fn spatial_rotation(degrees: [f64; 3]) -> Transform {
    plane_forms::about_fixed_axes(degrees.map(f64::to_radians), [0, 1, 2])
}

/// The rotation whose new Z is along a normal and whose new X is a base vector made perpendicular to it; `None` if they
/// are parallel or zero.
fn vector_rotation(base: Vec3, normal: Vec3) -> Option<Transform> {
    let length = normal.length();
    if length < LEAST_LENGTH || base.cross(normal).length() < LEAST_LENGTH * length {
        return None;
    }
    Frame::from_normal(Vec3::ZERO, normal, base).map(Transform::from_frame)
}

impl KlartextInterpreter<'_> {
    /// PLANE.
    pub(super) fn plane(&mut self, words: &PlaneWords) {
        let range = self.here;
        if words.positioning.is_none() {
            let message = "PLANE has none of MOVE, TURN and STAY";
            return self.problem(Code::MissingWord, range, message);
        }
        let rotation = match words.form {
            PlaneForm::Reset => None,
            PlaneForm::Spatial => {
                let angles = words.angles.map(|word| self.plane_value(word));
                let [Some(a), Some(b), Some(c)] = angles else {
                    let message = "PLANE SPATIAL lacks one of SPA, SPB and SPC";
                    return self.problem(Code::MissingWord, range, message);
                };
                Some(spatial_rotation([a, b, c]))
            }
            PlaneForm::Euler => {
                let angles = words.euler.map(|word| self.plane_value(word));
                let [Some(precession), Some(nutation), Some(rotation)] = angles else {
                    let message = "PLANE EULER lacks one of EULPR, EULNU and EULROT";
                    return self.problem(Code::MissingWord, range, message);
                };
                Some(plane_forms::euler([precession, nutation, rotation].map(f64::to_radians)))
            }
            PlaneForm::Points => match self.rotation_of_points(words) {
                Some(rotation) => Some(rotation),
                None => return,
            },
            PlaneForm::Relative => Some(self.rotation_in_plane(words)),
            PlaneForm::Vector => {
                let [base, normal] = [words.base, words.normal]
                    .map(|vector| vector.map(|word| self.plane_value(word).unwrap_or(0.0)))
                    .map(Vec3::from_array);
                let Some(rotation) = vector_rotation(base, normal) else {
                    let message = "the vectors of PLANE are parallel, or one of them is zero";
                    return self.problem(Code::TiltedPlane, range, message);
                };
                Some(rotation)
            }
            PlaneForm::Other => {
                let what = "this form of PLANE is not followed";
                return self.not_followed_once("PLANE", range, what);
            }
        };
        if !self.has_rotary_axes(rotation.as_ref(), "PLANE") {
            return;
        }
        match rotation {
            Some(rotation) => self.tilt(&rotation, words.positioning, words.sequence),
            None => self.level(words.positioning),
        }
    }

    /// PLANE POINTS: X from the first point to the second one, the third on the side of Y. The datum stays.
    fn rotation_of_points(&mut self, words: &PlaneWords) -> Option<Transform> {
        let range = self.here;
        let values = words.points.map(|point| point.map(|word| self.plane_value(word)));
        let mut points = [Vec3::ZERO; 3];
        for (point, values) in points.iter_mut().zip(values) {
            let [Some(x), Some(y), Some(z)] = values else {
                let message = "PLANE POINTS lacks one of the coordinates P1X to P3Z";
                self.problem(Code::MissingWord, range, message);
                return None;
            };
            *point = Vec3::new(x, y, z);
        }
        let [first, second, third] = points;
        let (along, aside) = (second - first, third - first);
        let found = vector_rotation(along, along.cross(aside));
        if found.is_none() {
            let message = "the three points of PLANE lie on a line";
            self.problem(Code::TiltedPlane, range, message);
        }
        found
    }

    /// PLANE RELATIV: a spatial angle about an axis of the plane that is in force.
    fn rotation_in_plane(&mut self, words: &PlaneWords) -> Transform {
        let angles = words.angles.map(|word| self.plane_value(word).unwrap_or(0.0));
        let turn = spatial_rotation(angles);
        let outside = self.modes.outside_plane.as_ref().and_then(CoordinateChain::rigid_map);
        match (self.kernel.tilted_plane(), outside) {
            (Some(plane), Some(outside)) => turn.then(&plane).then(&outside.inverse()),
            _ => turn,
        }
    }

    fn plane_value(&mut self, word: Option<OperandWord>) -> Option<f64> {
        let word = word?;
        self.operand(word.value, word.range)
    }

    /// Cycle 19: spatial angles, degrees; without any the plane is level again. The rotary axes stay.
    pub(super) fn working_plane(&mut self, angles: [Option<f64>; 3]) {
        let is_off = angles.iter().all(Option::is_none);
        let rotation = spatial_rotation(angles.map(|angle| angle.unwrap_or(0.0)));
        if !self.has_rotary_axes(Some(&rotation).filter(|_| !is_off), "cycle 19") {
            return;
        }
        match is_off {
            true => self.level(Some(PlanePositioning::Stay)),
            false => self.tilt(&rotation, Some(PlanePositioning::Stay), None),
        }
    }

    /// Whether the machine can have the plane; a level one needs no rotary axis.
    fn has_rotary_axes(&mut self, rotation: Option<&Transform>, name: &str) -> bool {
        if self.programs.control.axes().and(AxisMask::ROTARY) != AxisMask::NONE {
            return true;
        }
        let is_tilted = rotation.is_some_and(|rotation| {
            let z = rotation.apply_vector(Vec3::Z);
            let x = rotation.apply_vector(Vec3::X);
            (z - Vec3::Z).length() > 1e-9 || (x - Vec3::X).length() > 1e-9
        });
        if is_tilted {
            let what = format!(
                "the tilted plane of {name} is not followed: the machine has no rotary axis"
            );
            self.not_followed_once(name, self.here, &what);
        }
        false
    }

    /// From here on coordinates are those of a plane, which is rotated about the active datum.
    fn tilt(
        &mut self,
        rotation: &Transform,
        positioning: Option<PlanePositioning>,
        sequence: Option<bool>,
    ) {
        let range = self.here;
        let outside = match self.modes.outside_plane.take() {
            Some(outside) => outside,
            None => std::mem::take(&mut self.modes.chain),
        };
        let Some(map) = outside.rigid_map() else {
            let what = "a tilted plane in mirrored or scaled coordinates is not followed";
            self.modes.chain = outside;
            return self.not_followed(range, what);
        };
        self.modes.outside_plane = Some(outside);
        self.modes.chain = CoordinateChain::default();
        self.update_frame();
        self.kernel.set_tilted_plane(Some(rotation.then(&map)));
        let sign = sequence.map(|is_positive| match is_positive {
            true => AngleSign::Positive,
            false => AngleSign::Negative,
        });
        let turned = match positioning {
            Some(PlanePositioning::Stay) | None => {
                if sign.is_some() {
                    let what = "SEQ with STAY is not followed: Q120 to Q122 are those without it";
                    self.not_followed_once("SEQ", range, what);
                }
                self.set_plane_parameters()
            }
            Some(PlanePositioning::Turn) => self.kernel.turn_to_plane(false, sign),
            Some(PlanePositioning::Move) => self.kernel.turn_to_plane(true, sign),
        };
        if let Err(error) = turned {
            self.report_turn(error);
        }
    }

    /// Q120 to Q122: the positions of A, B and C that the plane needs, degrees.
    fn set_plane_parameters(&mut self) -> Result<(), TurnError> {
        let angles = self.kernel.rotary_of_direction(Vec3::Z)?;
        for (number, angle) in (120..=122).zip(angles) {
            self.parameters.set_shared(number, angle.to_degrees());
        }
        Ok(())
    }

    fn report_turn(&mut self, error: TurnError) {
        let range = self.here;
        match error {
            TurnError::NoPlane => {}
            TurnError::NoKinematics(why) => {
                if self.is_first_report("kinematics") {
                    let span = self.span(range);
                    self.kernel.report_no_kinematics(span, "the tilted plane", &why);
                }
                (120..=122).for_each(|number| self.parameters.set_shared(number, 0.0));
            }
            TurnError::Unreachable(why) => {
                let message = format!("the rotary axes do not reach this plane: {why}");
                self.problem(Code::TiltedPlane, range, message);
            }
        }
    }

    /// The plane is level again; with TURN and MOVE the rotary axes turn back to zero.
    fn level(&mut self, positioning: Option<PlanePositioning>) {
        if let Some(outside) = self.modes.outside_plane.take() {
            self.modes.chain = outside;
            self.update_frame();
            self.kernel.set_tilted_plane(None);
        }
        (120..=122).for_each(|number| self.parameters.set_shared(number, 0.0));
        if matches!(positioning, Some(PlanePositioning::Turn | PlanePositioning::Move)) {
            let axes = self.programs.control.axes().and(AxisMask::ROTARY);
            let mut target = self.kernel.state.position;
            axes.iter().for_each(|axis| target[axis as usize] = 0.0);
            self.kernel.rapid_to(target, axes);
        }
    }

    /// M128 and FUNCTION TCPM: the tip goes where the program says while rotary axes turn.
    pub(super) fn tool_center_point(&mut self, is_on: bool, range: TextRange, name: &str) {
        if !is_on {
            return self.kernel.end_tool_center();
        }
        if self.programs.control.axes().and(AxisMask::ROTARY) == AxisMask::NONE {
            let (code, message) = match self.programs.options.assumed_machine {
                true => (
                    Code::NotFollowed,
                    format!("{name} is not followed: the assumed machine has no rotary axis"),
                ),
                false => (Code::NoSuchAxis, format!("{name}: the machine has no rotary axis")),
            };
            if self.is_first_report(name) {
                self.problem(code, range, message);
            }
            return;
        }
        self.kernel.begin_tool_center();
        self.modes.contour.direction = None;
        if let Err(why) = self.kernel.rotary_chain()
            && self.is_first_report("kinematics")
        {
            let span = self.span(range);
            self.kernel.report_no_kinematics(span, name, &why);
        }
    }

    /// Whether M128 or TCPM is active.
    pub(super) fn follows_tip(&self) -> bool {
        self.kernel.state.part_frame.as_ref().is_some_and(|frame| frame.follows_tip)
    }

    /// The positions of the rotary axes for a direction of the tool (LN with TX, TY, TZ), rad; `None` where the direction
    /// is not given, or does not count because the tip is not followed.
    pub(super) fn rotary_of_vector(
        &mut self,
        vector: [Option<OperandWord>; 3],
    ) -> Option<[f64; 3]> {
        if vector.iter().all(Option::is_none) || !self.follows_tip() {
            return None;
        }
        let direction = vector.map(|word| self.plane_value(word).unwrap_or(0.0));
        match self.kernel.rotary_of_direction(Vec3::from_array(direction)) {
            Ok(angles) => Some(angles),
            Err(error) => {
                self.report_turn(error);
                self.kernel.go_astray(AxisMask::ROTARY);
                None
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: Vec3, expected: [f64; 3]) {
        assert!((found - Vec3::from_array(expected)).length() < 1e-4, "{found:?}");
    }

    #[test]
    fn spatial_angles_turn_about_the_axes_before_the_rotation() {
        let rotation = spatial_rotation([0.0, 30.0, 90.0]);
        near(rotation.apply_point(Vec3::new(10.0, 0.0, 0.0)), [0.0, 8.6603, -5.0]);
        near(rotation.apply_point(Vec3::new(0.0, 0.0, 10.0)), [0.0, 5.0, 8.6603]);
        let other = spatial_rotation([30.0, 0.0, 90.0]);
        near(other.apply_point(Vec3::new(0.0, 10.0, 0.0)), [-8.6603, 0.0, 5.0]);
    }

    #[test]
    fn vectors_give_the_new_axes() {
        let rotation = spatial_rotation([20.0, 30.0, 40.0]);
        let [x, z] = [Vec3::X, Vec3::Z].map(|axis| rotation.apply_vector(axis));
        // The base vector need not be perpendicular to the normal.
        let base = x + z * 0.3;
        let found = vector_rotation(base, z * 2.0);
        let found = found.expect("a rotation");
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            let expected = rotation.apply_vector(axis);
            near(found.apply_vector(axis), [expected.x, expected.y, expected.z]);
        }
        assert!(vector_rotation(Vec3::Z, Vec3::Z).is_none());
    }

    fn assert_same(one: &Transform, other: &Transform) {
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            let off = (one.apply_vector(axis) - other.apply_vector(axis)).length();
            assert!(off < 1e-12, "{one:?} is not {other:?}");
        }
    }

    #[test]
    fn forms_of_one_plane_are_the_same_rotation() {
        // Tilted by 30 degrees about X, then turned by 90 degrees about Z.
        let spatial = spatial_rotation([30.0, 0.0, 90.0]);
        let euler = plane_forms::euler([90.0, 30.0, 0.0].map(f64::to_radians));
        assert_same(&spatial, &euler);
        let (sin, cos) = (0.5, 0.75_f64.sqrt());
        let normal = Vec3::new(sin, 0.0, cos);
        let vectors = vector_rotation(Vec3::new(0.0, 2.0, 0.0), normal).expect("a rotation");
        assert_same(&spatial, &vectors);
        // The third point is on the side of the new Y, (-cos 30, 0, sin 30).
        let (along, aside) = (Vec3::new(0.0, 5.0, 0.0), Vec3::new(-cos, 3.0, sin));
        let points = vector_rotation(along, along.cross(aside));
        assert_same(&spatial, &points.expect("a rotation"));
    }

    #[test]
    fn parallel_vectors_are_no_plane() {
        assert!(vector_rotation(Vec3::Z, Vec3::Z * 2.0).is_none());
        assert!(vector_rotation(Vec3::X, Vec3::ZERO).is_none());
    }
}
