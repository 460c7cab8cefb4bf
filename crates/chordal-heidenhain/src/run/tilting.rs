//! Tilted planes (PLANE, cycle 19) and the control of the tip (M128, FUNCTION TCPM).

use chordal_command::AxisMask;
use chordal_diagnostics::{Code, TextRange};
use chordal_geometry::{Frame, Transform, Vec3};
use chordal_kernel::frames::{plane_forms, sin_cos_degrees};
use chordal_kernel::{AngleSign, TurnError};

use super::interpreter::KlartextInterpreter;
use super::transformations::CoordinateChain;
use crate::syntax::{AXIS_WORDS, OperandWord, PlaneForm, PlanePositioning, PlaneWords};

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

/// The rotation of a plane through two lines: in Z/X it rises by the first angle along X, in Y/Z by the second along Y. X is
/// along the first, turned by the third angle about the normal; degrees.
fn traces_rotation([main, minor, turn]: [f64; 3]) -> Transform {
    let slope = |degrees: f64| {
        let (sin, cos) = sin_cos_degrees(degrees);
        sin / cos
    };
    let (first, second) = (Vec3::new(1.0, 0.0, slope(main)), Vec3::new(0.0, 1.0, slope(minor)));
    let level = vector_rotation(first, first.cross(second)).unwrap_or(Transform::identity());
    Transform::rotation_about(Vec3::ZERO, Vec3::Z, turn.to_radians()).then(&level)
}

/// The rotary axes of a tilted plane.
#[derive(Clone, Copy)]
enum PlaneAngles {
    /// They follow from the plane, with the sign of SEQ for the axis nearer to the tool.
    Found(Option<AngleSign>),
    /// The program gives them: program positions of A, B and C, rad.
    Known([f64; 3]),
}

/// SEQ.
fn sign_of(sequence: Option<bool>) -> Option<AngleSign> {
    sequence.map(|is_positive| match is_positive {
        true => AngleSign::Positive,
        false => AngleSign::Negative,
    })
}

impl KlartextInterpreter<'_> {
    /// PLANE.
    pub(super) fn plane(&mut self, words: &PlaneWords) {
        let range = self.here;
        if words.positioning.is_none() {
            let message = "PLANE has none of MOVE, TURN and STAY";
            return self.problem(Code::MissingWord, range, message);
        }
        if words.form == PlaneForm::Reset {
            if self.has_rotary_axes(None, "PLANE") {
                self.level(words.positioning);
            }
            return;
        }
        if words.form == PlaneForm::Axial {
            return self.axial_plane(words);
        }
        let Some(rotation) = self.rotation_of_plane(words) else { return };
        if self.has_rotary_axes(Some(&rotation), "PLANE") {
            self.tilt(&rotation, words.positioning, PlaneAngles::Found(sign_of(words.sequence)));
        }
    }

    /// The rotation of a plane; `None` where a word is missing or wrong, which is reported.
    fn rotation_of_plane(&mut self, words: &PlaneWords) -> Option<Transform> {
        match words.form {
            PlaneForm::Spatial => {
                let message = "PLANE SPATIAL lacks one of SPA, SPB and SPC";
                Some(spatial_rotation(self.plane_angles(words.angles, message)?))
            }
            PlaneForm::Euler => {
                let message = "PLANE EULER lacks one of EULPR, EULNU and EULROT";
                let angles = self.plane_angles(words.euler, message)?;
                Some(plane_forms::euler(angles.map(f64::to_radians)))
            }
            PlaneForm::Projected => self.rotation_of_traces(words),
            PlaneForm::Points => self.rotation_of_points(words),
            PlaneForm::Relative => Some(self.rotation_in_plane(words)),
            PlaneForm::Vector => {
                let [base, normal] = [words.base, words.normal]
                    .map(|vector| vector.map(|word| self.plane_value(word).unwrap_or(0.0)))
                    .map(Vec3::from_array);
                let found = vector_rotation(base, normal);
                if found.is_none() {
                    let message = "the vectors of PLANE are parallel, or one of them is zero";
                    self.problem(Code::TiltedPlane, self.here, message);
                }
                found
            }
            PlaneForm::Axial | PlaneForm::Reset | PlaneForm::Other => {
                let what = "this form of PLANE is not followed";
                self.not_followed_once("PLANE", self.here, what);
                None
            }
        }
    }

    /// Three angles that must all be there, degrees.
    fn plane_angles(&mut self, words: [Option<OperandWord>; 3], missing: &str) -> Option<[f64; 3]> {
        let [Some(first), Some(second), Some(third)] = words.map(|word| self.plane_value(word))
        else {
            self.problem(Code::MissingWord, self.here, missing);
            return None;
        };
        Some([first, second, third])
    }

    /// PLANE PROJECTED (iTNC 530, 12.3): the plane goes through two lines, in Z/X and in Y/Z, that rise by the angles. X is
    /// along the first, turned by ROT.
    fn rotation_of_traces(&mut self, words: &PlaneWords) -> Option<Transform> {
        let message = "PLANE PROJECTED lacks one of PROPR, PROMIN and ROT";
        let [main, minor, turn] = self.plane_angles(words.projected, message)?;
        for (name, angle) in [("PROPR", main), ("PROMIN", minor)] {
            if angle.abs() >= 90.0 {
                let message = format!("{name} is {angle} degrees");
                let help = "the angles of PLANE PROJECTED are between -90 and 90 degrees";
                self.bad_value(self.here, message, help);
                return None;
            }
        }
        let main = if self.programs.settings.projected_plane_rises { main } else { -main };
        if main != 0.0 && minor != 0.0 {
            // Manuals show X and Y of such a plane in a picture alone.
            let what = "X of PLANE PROJECTED is assumed to lie in Z/X before ROT";
            self.assumed_once("PLANE PROJECTED", self.here, what);
        }
        Some(traces_rotation([main, minor, turn]))
    }

    /// PLANE AXIAL: the plane on which the tool stands upright when the rotary axes are at positions. An axis without a
    /// word stays where it is.
    fn axial_plane(&mut self, words: &PlaneWords) {
        let axes = self.programs.control.axes();
        let place = self.programmed();
        let mut angles = [place[3], place[4], place[5]];
        let mut has_word = false;
        for (axis, word) in words.axial.into_iter().enumerate() {
            let Some(word) = word else { continue };
            has_word = true;
            if !axes.has(axis + 3) {
                let letter = AXIS_WORDS[axis + 3];
                let message =
                    format!("PLANE AXIAL names {letter}, which this machine does not have");
                return self.problem(Code::NoSuchAxis, word.range, message);
            }
            let Some(value) = self.plane_value(Some(word)) else { return };
            let from = if word.is_incremental { angles[axis] } else { 0.0 };
            angles[axis] = from + value.to_radians();
        }
        if !has_word {
            let message = "PLANE AXIAL lacks an angle A, B or C";
            return self.problem(Code::MissingWord, self.here, message);
        }
        match self.kernel.tool_axes_at(&angles) {
            Ok([x, _, z]) => {
                // The axes do not follow a rotation of the coordinates, which the plane would.
                let outside = self.modes.outside_plane.as_ref().unwrap_or(&self.modes.chain);
                let back = outside.rigid_map().unwrap_or(Transform::identity()).inverse();
                let [x, z] = [x, z].map(|axis| back.apply_vector(axis));
                let Some(rotation) = vector_rotation(x, z) else { return };
                self.tilt(&rotation, words.positioning, PlaneAngles::Known(angles));
            }
            Err(error) => self.report_turn(error),
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
            false => {
                let angles = PlaneAngles::Found(None);
                self.tilt(&rotation, Some(PlanePositioning::Stay), angles);
            }
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
        angles: PlaneAngles,
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
        let holds_tip = positioning == Some(PlanePositioning::Move);
        let turned = match (positioning, angles) {
            (Some(PlanePositioning::Stay) | None, angles) => self.set_plane_parameters(angles),
            (_, PlaneAngles::Found(sign)) => self.kernel.turn_to_plane(holds_tip, sign),
            (_, PlaneAngles::Known(angles)) => self.kernel.turn_to_angles(holds_tip, &angles),
        };
        if let Err(error) = turned {
            self.report_turn(error);
        }
    }

    /// Q120 to Q122: the positions of A, B and C that the plane needs, degrees.
    fn set_plane_parameters(&mut self, angles: PlaneAngles) -> Result<(), TurnError> {
        let angles = match angles {
            PlaneAngles::Found(sign) => self.kernel.rotary_of_plane(sign)?,
            PlaneAngles::Known(angles) => angles,
        };
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
    fn traces_rise_by_their_angles() {
        // One angle alone is a rotation about Y or X.
        assert_same(&traces_rotation([0.0, 40.0, 0.0]), &spatial_rotation([40.0, 0.0, 0.0]));
        assert_same(&traces_rotation([25.0, 0.0, 0.0]), &spatial_rotation([0.0, -25.0, 0.0]));
        let rotation = traces_rotation([20.0, 30.0, 0.0]);
        let normal = rotation.apply_vector(Vec3::Z);
        for line in [
            Vec3::new(20_f64.to_radians().cos(), 0.0, 20_f64.to_radians().sin()),
            Vec3::new(0.0, 30_f64.to_radians().cos(), 30_f64.to_radians().sin()),
        ] {
            assert!(line.dot(normal).abs() < 1e-12, "{normal:?}");
        }
        assert!(rotation.apply_vector(Vec3::X).y.abs() < 1e-12);
        // ROT turns X and Y in the plane.
        let turned = traces_rotation([20.0, 30.0, 90.0]);
        let off = turned.apply_vector(Vec3::X) - rotation.apply_vector(Vec3::Y);
        assert!(off.length() < 1e-12);
    }

    #[test]
    fn parallel_vectors_are_no_plane() {
        assert!(vector_rotation(Vec3::Z, Vec3::Z * 2.0).is_none());
        assert!(vector_rotation(Vec3::X, Vec3::ZERO).is_none());
    }
}
