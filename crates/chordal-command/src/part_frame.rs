//! Coordinates in a frame that is fixed to the part: tool centre point control, tilted planes.

use chordal_geometry::{Curve, Frame, ParamCurve, Transform, Vec3};
use chordal_kinematics::{JointPath, KinematicChain, RotaryMount, TipJet, TipMotion};

use crate::axes::Position;

/// A frame that is fixed to the part, in which the program gives the tip of the tool: under tool centre point control (G43.4,
/// G234, TRAORI), and in a tilted plane (G68.2, G268). The control moves the linear axes so that the tip is there, however
/// the rotary axes stand.
#[derive(Clone, Debug, PartialEq)]
pub struct PartFrame {
    /// The rotary axes of the machine; `None` where the machine file does not give them: then the tip is known and the
    /// positions of the linear axes are not.
    pub chain: Option<KinematicChain>,
    /// The machine angles of A, B and C at which the work coordinate system is parallel to the machine, rad.
    pub frame_angles: [f64; 3],
    /// From program coordinates to those of the work coordinate system, a rotation and a translation: the identity
    /// without a tilted plane.
    pub plane: Transform,
    /// The control holds the tip while rotary axes turn (tool centre point control); otherwise they turn alone.
    pub follows_tip: bool,
}

/// What lies between program coordinates and the gauge point, mm and rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProgramOffsets {
    /// What is added to program coordinates, without the tool offset.
    pub work: Position,
    /// The offset of the tool, including its length.
    pub tool: Position,
}

impl ProgramOffsets {
    /// The machine angles of A, B and C at a position.
    pub fn angles(&self, place: &Position) -> [f64; 3] {
        std::array::from_fn(|axis| place[axis + 3] + self.work[axis + 3] + self.tool[axis + 3])
    }

    fn linear(values: &Position) -> Vec3 {
        Vec3::new(values[0], values[1], values[2])
    }

    /// What is added to X, Y and Z in all, mm.
    pub fn total(&self) -> Vec3 {
        ProgramOffsets::linear(&self.work) + ProgramOffsets::linear(&self.tool)
    }

    /// The vector from the gauge point to the tip with the heads at zero.
    fn tool_vector(&self) -> Vec3 {
        -ProgramOffsets::linear(&self.tool)
    }
}

impl PartFrame {
    /// The positions of the axes, without the offsets, that bring the tip to a position in program coordinates: where the
    /// program would have to move without this frame.
    pub fn axes_of_tip(&self, tip: &Position, offsets: &ProgramOffsets) -> Position {
        let on_work = self.plane.apply_point(ProgramOffsets::linear(tip));
        let Some(chain) = &self.chain else { return with_linear(tip, on_work) };
        let on_part =
            self.part_zero(chain).apply_point(on_work + ProgramOffsets::linear(&offsets.work));
        let gauge_point = chain.gauge_point(on_part, &offsets.angles(tip), offsets.tool_vector());
        with_linear(tip, gauge_point - offsets.total())
    }

    /// The position of the tip in program coordinates from those of the axes without the offsets: the inverse of
    /// [`PartFrame::axes_of_tip`].
    pub fn tip_of_axes(&self, axes: &Position, offsets: &ProgramOffsets) -> Position {
        let to_plane = self.plane.inverse();
        let Some(chain) = &self.chain else {
            return with_linear(axes, to_plane.apply_point(ProgramOffsets::linear(axes)));
        };
        let gauge_point = ProgramOffsets::linear(axes) + offsets.total();
        let pose = chain.pose(gauge_point, &offsets.angles(axes), offsets.tool_vector());
        let on_part = self.part_zero(chain).inverse().apply_point(pose.tip);
        with_linear(axes, to_plane.apply_point(on_part - ProgramOffsets::linear(&offsets.work)))
    }

    /// Whether the work coordinates of the tip follow from the linear axes alone while the rotary axes stand at a position:
    /// the tables as in the frame of the part, the heads at zero.
    pub fn is_aligned(&self, place: &Position, offsets: &ProgramOffsets) -> bool {
        let angles = offsets.angles(place);
        match &self.chain {
            None => angles == self.frame_angles,
            Some(chain) => chain.joints().iter().all(|joint| {
                let index = joint.letter.index();
                let aligned = match joint.side {
                    RotaryMount::Table => self.frame_angles[index],
                    RotaryMount::Head => 0.0,
                };
                angles[index] == aligned
            }),
        }
    }

    /// Whether a rotary axis turns the tool; false without a chain.
    pub fn turns_tool(&self) -> bool {
        let joints = self.chain.as_ref().map(|chain| chain.joints());
        joints.into_iter().flatten().any(|joint| joint.side == RotaryMount::Head)
    }

    /// Whether the plane is that of the work coordinate system.
    pub fn is_level(&self) -> bool {
        self.plane == Transform::identity()
    }

    /// The direction of a vector of program coordinates in part coordinates of the chain; `None` without a chain.
    pub fn direction_on_part(&self, direction: Vec3) -> Option<Vec3> {
        let chain = self.chain.as_ref()?;
        Some(self.part_zero(chain).apply_direction(self.plane.apply_direction(direction)))
    }

    /// The unit vector from the tip of the tool to its holder in the frame, without the tilted plane; `None` without a chain.
    pub fn tool_direction(&self, place: &Position, offsets: &ProgramOffsets) -> Option<Vec3> {
        let chain = self.chain.as_ref()?;
        let to_frame = self.part_zero(chain).inverse();
        Some(to_frame.apply_direction(chain.direction(&offsets.angles(place))))
    }

    /// The rotation from the directions of the linear axes of the machine to those of the frame, without the tilted plane:
    /// by how much the tables have turned. The identity without a chain.
    pub fn machine_axes(&self, place: &Position, offsets: &ProgramOffsets) -> Transform {
        let Some(chain) = &self.chain else { return Transform::identity() };
        let to_part = chain.part_transform(&offsets.angles(place));
        let to_frame = to_part.then(&self.part_zero(chain).inverse());
        let [u, v, w] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| to_frame.apply_direction(axis));
        Transform::from_frame(Frame { origin: Vec3::ZERO, u, v, w })
    }

    /// The path of the axes, machine coordinates, while the tip follows a curve in program coordinates and the rotary axes
    /// turn evenly from one position to another; `None` where the chain is not known, and needed.
    pub fn joint_path(
        &self,
        curve: &Curve,
        [from, to]: [&Position; 2],
        offsets: &ProgramOffsets,
    ) -> Option<JointPath<TipCurve>> {
        // While the tables lie as in the frame, the linear axes need no chain.
        let is_aligned = || self.is_aligned(from, offsets) && self.is_aligned(to, offsets);
        let chain = self.chain.or_else(|| is_aligned().then_some(KinematicChain::CARTESIAN))?;
        let shift = Transform::translation(ProgramOffsets::linear(&offsets.work));
        let to_part = self.plane.then(&shift).then(&self.part_zero(&chain));
        let on_part = curve.transformed(&to_part);
        Some(JointPath {
            chain,
            tip: TipCurve { curve: on_part, length_mm: on_part.length() },
            from: offsets.angles(from),
            to: offsets.angles(to),
            tool: offsets.tool_vector(),
        })
    }

    /// The transform from the frame of the part to part coordinates of the chain, which are those of the machine with
    /// every table at zero.
    fn part_zero(&self, chain: &KinematicChain) -> Transform {
        chain.part_transform(&self.frame_angles)
    }
}

/// A curve of the tip by the share of its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipCurve {
    /// The curve, part coordinates, mm.
    pub curve: Curve,
    /// Its length, mm.
    pub length_mm: f64,
}

impl TipMotion for TipCurve {
    fn tip(&self, sigma: f64) -> TipJet {
        let along = sigma * self.length_mm;
        let second = self.length_mm * self.length_mm;
        if self.length_mm == 0.0 {
            return TipJet { point: self.curve.start(), ..TipJet::default() };
        }
        TipJet {
            point: self.curve.point_at(along),
            first: self.curve.tangent_at(along) * self.length_mm,
            second: self.curve.curvature_at(along) * second,
        }
    }

    fn point(&self, sigma: f64) -> Vec3 {
        match &self.curve {
            Curve::Line(line) => line.start.lerp(line.end, sigma),
            curve => curve.point_at(sigma * self.length_mm),
        }
    }

    fn derivative_bounds(&self, _from: f64, _to: f64) -> (f64, f64) {
        let second = match &self.curve {
            Curve::Line(_) => 0.0,
            curve => curve.max_curvature() * self.length_mm * self.length_mm,
        };
        (self.length_mm, second)
    }
}

fn with_linear(place: &Position, linear: Vec3) -> Position {
    let [x, y, z] = linear.to_array();
    let [_, _, _, a, b, c] = *place;
    [x, y, z, a, b, c]
}

#[cfg(test)]
mod tests {
    use chordal_geometry::Line;
    use chordal_kinematics::{RotaryJoint, RotaryLetter};

    use super::*;

    /// C through X-300 Y-200 on A through Y-200 Z-400, G54 at (-300, -200, -380), a tool of 100 mm.
    fn trunnion() -> (PartFrame, ProgramOffsets) {
        let chain = KinematicChain::new(&[
            RotaryJoint::table(RotaryLetter::C, Vec3::new(-300.0, -200.0, 0.0)),
            RotaryJoint::table(RotaryLetter::A, Vec3::new(0.0, -200.0, -400.0)),
        ]);
        let frame = PartFrame {
            chain: Some(chain.expect("a chain")),
            frame_angles: [0.0; 3],
            plane: Transform::identity(),
            follows_tip: true,
        };
        let offsets = ProgramOffsets {
            work: [-300.0, -200.0, -380.0, 0.0, 0.0, 0.0],
            tool: [0.0, 0.0, 100.0, 0.0, 0.0, 0.0],
        };
        (frame, offsets)
    }

    fn machine(axes: &Position, offsets: &ProgramOffsets) -> [f64; 3] {
        std::array::from_fn(|axis| axes[axis] + offsets.work[axis] + offsets.tool[axis])
    }

    fn assert_near(found: [f64; 3], expected: [f64; 3]) {
        let near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-4);
        assert!(near, "{found:?}");
    }

    #[test]
    fn the_axes_follow_a_turned_table() {
        let (frame, offsets) = trunnion();
        let tip = [10.0, 0.0, 20.0, 30_f64.to_radians(), 0.0, 45_f64.to_radians()];
        let axes = frame.axes_of_tip(&tip, &offsets);
        assert_near(machine(&axes, &offsets), [-292.9289, -186.1237, -261.8234]);
        let back = frame.tip_of_axes(&axes, &offsets);
        assert_near([back[0], back[1], back[2]], [10.0, 0.0, 20.0]);
        let upright = [10.0, 0.0, 20.0, 0.0, 0.0, 0.0];
        assert_eq!(frame.axes_of_tip(&upright, &offsets).map(|v| (v * 1e9).round() / 1e9), upright);
        assert!(frame.is_aligned(&upright, &offsets) && !frame.is_aligned(&tip, &offsets));
    }

    #[test]
    fn the_axes_bend_while_the_tip_goes_straight() {
        let (frame, offsets) = trunnion();
        let line = Curve::Line(Line { start: Vec3::ZERO, end: Vec3::new(50.0, 0.0, 0.0) });
        let from = [0.0; 6];
        let to = [50.0, 0.0, 0.0, 30_f64.to_radians(), 0.0, 90_f64.to_radians()];
        let path = frame.joint_path(&line, [&from, &to], &offsets).expect("a chain");
        let at = |sigma: f64| path.positions(sigma).gauge_point.to_array();
        assert_near(at(0.5), [-282.3223, -211.8989, -276.1062]);
        assert_near(at(1.0), [-300.0, -233.3013, -257.6795]);
    }

    #[test]
    fn a_frame_at_other_angles_is_that_of_the_turned_part() {
        // With the frame at C90, X of the program is -Y of the part that the table carries at zero.
        let (frame, offsets) = trunnion();
        let quarter = 90_f64.to_radians();
        let turned = PartFrame { frame_angles: [0.0, 0.0, quarter], ..frame };
        let tip = [10.0, 0.0, 20.0, 0.0, 0.0, quarter];
        assert!(turned.is_aligned(&tip, &offsets));
        let axes = turned.axes_of_tip(&tip, &offsets);
        assert_near([axes[0], axes[1], axes[2]], [10.0, 0.0, 20.0]);
    }
}
