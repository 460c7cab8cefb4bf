//! Tilted planes: the words that define them, and the codes that turn the tool to them.

use chordal_command::CompensationSide;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::TiltedPlaneCode;
use chordal_geometry::{Frame, Transform, Vec3};
use chordal_kernel::TurnError;
use chordal_syntax::Block;

use super::Interpreter;

/// The number of X, Y and Z, which are the origin of a plane.
const LINEAR_AXES: usize = 3;

/// The axes that I, J and K turn about.
const AXES_OF_ANGLES: [Vec3; 3] = [Vec3::X, Vec3::Y, Vec3::Z];

impl Interpreter<'_> {
    /// Carries out G68.2, G53.1 and their like.
    pub(super) fn tilted_plane(&mut self, block: &Block, at: usize, code: TiltedPlaneCode) {
        match code {
            TiltedPlaneCode::Define | TiltedPlaneCode::DefineByAxes => {
                self.define_plane(block, at, code == TiltedPlaneCode::DefineByAxes);
            }
            TiltedPlaneCode::Off => {
                self.unused_axes(block, |_, _| false);
                self.kernel.set_tilted_plane(Transform::identity());
            }
            TiltedPlaneCode::Turn { holds_tip } => {
                self.unused_axes(block, |_, _| false);
                self.turn_to_plane(block, at, holds_tip);
            }
        }
    }

    fn define_plane(&mut self, block: &Block, at: usize, by_axes: bool) {
        self.unused_axes(block, |axis, _| axis < LINEAR_AXES);
        let rules = self.control.table.tilted_plane;
        let name = self.code_text(block, at);
        if self.kernel.has_tilted_plane() {
            let message = format!("{name} while a tilted plane is in force");
            let help = "end the plane before with G69";
            self.report_plane(block, at, message, help, rules.twice);
        }
        if self.kernel.state.side != CompensationSide::Off {
            let message = format!("{name} while cutter compensation is on");
            let help = "cancel compensation with G40 on a move before";
            self.report_plane(block, at, message, help, rules.format);
        }
        let form = match (by_axes, block.letters().has(b'P')) {
            (true, _) => Some(1),
            (false, true) => self.count_of(block, b'P'),
            (false, false) => Some(0),
        };
        let angles = b"IJK".map(|letter| self.angle_of(block, letter).unwrap_or(0.0).to_radians());
        let rotation = match form {
            Some(0) => Some(euler(angles)),
            Some(1) => match self.order_of_axes(block) {
                Some(order) => Some(about_fixed_axes(angles, order)),
                None => {
                    let message = "Q is the order of the three axes, such as 123".to_string();
                    let help = "write each of 1, 2 and 3 once, or leave Q out";
                    self.report_plane(block, at, message, help, rules.format);
                    None
                }
            },
            Some(4) => two_projections(angles),
            _ => {
                let word = *block.last(b'P').unwrap_or(&block.words[at]);
                return self.not_followed(&word, "another way to define the plane");
            }
        };
        let Some(rotation) = rotation else {
            let word = block.words[at];
            return self.not_followed(&word, "a plane without a direction");
        };
        let origin = self.axis_words(block);
        let origin =
            Vec3::new(origin[0].unwrap_or(0.0), origin[1].unwrap_or(0.0), origin[2].unwrap_or(0.0));
        self.kernel.set_tilted_plane(rotation.then(&Transform::translation(origin)));
    }

    /// The axes of I, J and K in the order in which they turn; `None` if Q does not name each once.
    fn order_of_axes(&mut self, block: &Block) -> Option<[usize; 3]> {
        if !block.letters().has(b'Q') {
            return Some([0, 1, 2]);
        }
        let number = self.count_of(block, b'Q')?;
        let order =
            [number / 100, number / 10 % 10, number % 10].map(|digit| digit.wrapping_sub(1));
        let is_complete = number < 1000 && (0..3).all(|axis| order.contains(&axis));
        is_complete.then(|| order.map(|axis| axis as usize))
    }

    fn turn_to_plane(&mut self, block: &Block, at: usize, holds_tip: bool) {
        let rules = self.control.table.tilted_plane;
        let name = self.code_text(block, at);
        if let Some(word) = block.last(b'P').copied() {
            self.not_followed(&word, "the choice of a solution");
        }
        match self.kernel.turn_to_plane(holds_tip) {
            Ok(()) => {}
            Err(TurnError::NoPlane) => {
                let message = format!("{name} without a tilted plane");
                let help = "define the plane in a block before";
                self.report_plane(block, at, message, help, rules.without_plane);
            }
            Err(TurnError::NoKinematics(why)) => {
                let span = self.span(block.words[at].range);
                self.kernel.report_no_kinematics(span, &name, &why);
            }
            Err(TurnError::Unreachable(why)) => {
                let message = format!("{name}: {why}");
                let help = "choose another plane, or a machine whose axes reach it";
                self.report_plane(block, at, message, help, rules.unreachable);
            }
        }
    }

    fn report_plane(
        &mut self,
        block: &Block,
        at: usize,
        message: String,
        help: &str,
        alarm: Option<&str>,
    ) {
        let span = self.span(block.words[at].range);
        let diagnostic = Diagnostic::new(Code::TiltedPlane, span, message).help(help);
        match alarm {
            Some(alarm) => self.report_refused(diagnostic, alarm),
            None => self.kernel.report(diagnostic),
        }
    }
}

/// Euler angles: about Z, then about the new X, then about the new Z (Fanuc B-63944EN, G68.2).
fn euler([first, second, third]: [f64; 3]) -> Transform {
    turn(Vec3::Z, third).then(&turn(Vec3::X, second)).then(&turn(Vec3::Z, first))
}

/// Angles about axes that stay where they are, in an order.
fn about_fixed_axes(angles: [f64; 3], order: [usize; 3]) -> Transform {
    order.into_iter().fold(Transform::identity(), |rotation, axis| {
        rotation.then(&turn(AXES_OF_ANGLES[axis], angles[axis]))
    })
}

/// X lies at the first angle about Y, a second direction at the second one about X; then the plane turns about its normal
/// by the third. `None` where both directions are one.
fn two_projections([first, second, third]: [f64; 3]) -> Option<Transform> {
    let along = turn(Vec3::Y, first).apply_direction(Vec3::X);
    let across = turn(Vec3::X, second).apply_direction(Vec3::Y);
    let normal = along.cross(across);
    let frame = Frame::from_normal(Vec3::ZERO, normal, along)?;
    Some(turn(Vec3::Z, third).then(&Transform::from_frame(frame)))
}

fn turn(about: Vec3, angle: f64) -> Transform {
    Transform::rotation_about(Vec3::ZERO, about, angle)
}
