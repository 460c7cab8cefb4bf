//! The moves of a run as moves of the axes of the machine.

use chordal_collision::AxisMove;
use chordal_command::{AxisMask, Command, CommandKind, Move, Position};
use chordal_geometry::{Curve, Line, ParamCurve, PerAxis, Transform, Vec3};
use chordal_machine::{AXES, Machine};
use chordal_path::{AxisPieces, ProgramFrame, axis_pieces, rapid_corners, tip_pieces};

/// Follows a run, and gives its moves in machine coordinates.
pub(super) struct MoveFollower<'m> {
    machine: &'m Machine,
    frame: ProgramFrame,
    /// Where each axis stands, machine coordinates, mm and rad; `None`: not known.
    stand: PerAxis<Option<f64>>,
    /// How far straight moves of the axes may be from the exact ones while the tip is held, mm.
    deviation_mm: f64,
}

/// A move as the axes make it.
pub(super) struct FollowedMove {
    pub pieces: Vec<AxisMove>,
    /// The axes whose positions are known along it; those of others are zero in `pieces`.
    pub known: AxisMask,
    /// Why the move cannot be followed at all.
    pub not_followed: Option<&'static str>,
    /// The work offset is not known along one of X, Y and Z.
    pub lacks_offset: bool,
}

impl<'m> MoveFollower<'m> {
    /// From the frame before the first command. The axes begin at the first reference point, as far as it is given.
    pub fn new(machine: &'m Machine, frame: ProgramFrame, deviation_mm: f64) -> MoveFollower<'m> {
        MoveFollower { machine, frame, stand: machine.home, deviation_mm }
    }

    /// Follows a command; `None` if it moves nothing.
    pub fn follow(&mut self, command: &Command) -> Option<FollowedMove> {
        if self.frame.follow(command) {
            return None;
        }
        let motion = command.kind.motion()?;
        let lacks_offset = !self.frame.known.covers(AxisMask::LINEAR);
        let refused = |reason| FollowedMove {
            pieces: Vec::new(),
            known: AxisMask::NONE,
            not_followed: Some(reason),
            lacks_offset,
        };
        if self.frame.surface.is_some() {
            self.stand = [None; AXES];
            return Some(refused("polar or cylindrical interpolation is active"));
        }
        let found = match self.frame.part_frame.is_some() {
            true => self.on_part(&command.kind, motion),
            false => self.on_axes(&command.kind, motion),
        };
        Some(match found {
            Ok((pieces, known)) => FollowedMove { pieces, known, not_followed: None, lacks_offset },
            Err(reason) => refused(reason),
        })
    }

    /// The machine coordinate of an axis at a program position, if it is known. A rotary work offset that is not given is
    /// taken as 0.
    fn placed(&self, place: &Position, known: AxisMask, axis: usize) -> Option<f64> {
        let is_known = known.has(axis) && (axis >= 3 || self.frame.known.has(axis));
        is_known.then(|| self.frame.machine(place, axis))
    }

    /// A move whose coordinates are those of the axes.
    fn on_axes(
        &mut self,
        kind: &CommandKind,
        motion: &Move,
    ) -> Result<(Vec<AxisMove>, AxisMask), &'static str> {
        let from: PerAxis<Option<f64>> = std::array::from_fn(|axis| {
            self.placed(&motion.from, motion.from_known, axis).or(self.stand[axis])
        });
        let to: PerAxis<Option<f64>> = std::array::from_fn(|axis| {
            let stands = motion.from[axis] == motion.to[axis];
            self.placed(&motion.to, motion.to_known, axis).or(from[axis].filter(|_| stands))
        });
        self.stand = to;
        let known = AxisMask::with_values(&from).and(AxisMask::with_values(&to));
        let filled = |values: &PerAxis<Option<f64>>| -> Position {
            std::array::from_fn(|axis| values[axis].filter(|_| known.has(axis)).unwrap_or(0.0))
        };
        let (start, end) = (filled(&from), filled(&to));
        let mut pieces = Vec::new();
        if let CommandKind::Rapid { path, .. } = kind {
            if self.bends_at_unknown_speed(kind, &start, &end) {
                return Err("the speeds of the axes are not given, and the rapid bends by them");
            }
            let mut at = start;
            rapid_corners(self.machine, *path, &start, &end, |corner, _| {
                pieces.push(straight(&at, corner));
                at = *corner;
            });
            return Ok((pieces, known));
        }
        // What lies between the coordinates of the program and those of the machine is the same at both ends, unless the
        // program does not know where the axes stand.
        let offset: Position = std::array::from_fn(|axis| start[axis] - motion.from[axis]);
        let is_shifted = known.iter().all(|axis| {
            let axis = axis as usize;
            (motion.to[axis] + offset[axis] - end[axis]).abs() <= SAME_PLACE
        });
        if !is_shifted {
            let is_line = matches!(kind, CommandKind::Line { .. });
            let line = is_line.then(|| (vec![straight(&start, &end)], known));
            return line.ok_or("where its curve begins is not known");
        }
        let shift = Transform::translation(Vec3::new(offset[0], offset[1], offset[2]));
        tip_pieces(kind, motion, |curve, ends| {
            let rotary = ends.map(|place| -> [f64; 3] {
                std::array::from_fn(|axis| place[axis + 3] + offset[axis + 3])
            });
            pieces.push(AxisMove {
                curve: curve.transformed(&shift),
                rotary_from: rotary[0],
                rotary_to: rotary[1],
                deviation_mm: 0.0,
            });
        });
        Ok((pieces, known))
    }

    /// Whether a rapid of several axes runs each at its own speed, and one of the speeds is not given.
    fn bends_at_unknown_speed(&self, kind: &CommandKind, start: &Position, end: &Position) -> bool {
        let is_dog_leg =
            matches!(kind, CommandKind::Rapid { path: chordal_command::RapidPath::DogLeg, .. });
        let moving: Vec<usize> = (0..AXES).filter(|axis| start[*axis] != end[*axis]).collect();
        let has_speed = |axis: &usize| {
            let limits = self.machine.axes[*axis].as_ref();
            limits.and_then(|limits| limits.max_velocity).is_some()
        };
        is_dog_leg && moving.len() > 1 && !moving.iter().all(has_speed)
    }

    /// A move in a frame of the part: the axes follow the tip.
    fn on_part(
        &mut self,
        kind: &CommandKind,
        motion: &Move,
    ) -> Result<(Vec<AxisMove>, AxisMask), &'static str> {
        let Some(part_frame) = self.frame.part_frame.clone() else { return Ok(Default::default()) };
        let offsets = self.frame.offsets();
        let axes = part_frame.chain.as_ref().map_or(AxisMask::ROTARY, AxisMask::of_chain);
        let knows = |known: AxisMask| {
            known.covers(AxisMask::LINEAR.or(axes)) && self.frame.known.covers(AxisMask::LINEAR)
        };
        let (knows_start, knows_end) = (knows(motion.from_known), knows(motion.to_known));
        self.stand = [None; AXES];
        if knows_end {
            let place = part_frame.axes_of_tip(&motion.to, &offsets);
            self.stand = std::array::from_fn(|axis| Some(self.frame.machine(&place, axis)));
        }
        if !(knows_start && knows_end) {
            return Ok((vec![motionless()], AxisMask::NONE));
        }
        let all = Transform::translation(offsets.total());
        let turned = |angles: [f64; 3]| -> [f64; 3] {
            std::array::from_fn(|axis| {
                angles[axis] + offsets.work[axis + 3] + offsets.tool[axis + 3]
            })
        };
        let mut pieces = Vec::new();
        let mut is_whole = true;
        tip_pieces(kind, motion, |curve, ends| {
            let found = axis_pieces(&part_frame, curve, ends, &offsets, self.deviation_mm);
            is_whole &= found.is_some();
            let is_exact = found.as_ref().is_some_and(AxisPieces::is_exact);
            pieces.extend(found.into_iter().flatten().map(|piece| AxisMove {
                curve: piece.curve.transformed(&all),
                rotary_from: turned(piece.rotary_from),
                rotary_to: turned(piece.rotary_to),
                deviation_mm: if is_exact { 0.0 } else { self.deviation_mm },
            }));
        });
        match is_whole {
            true => Ok((pieces, AxisMask::ALL)),
            false => Err("the points about which the rotary axes turn are not known"),
        }
    }
}

/// Positions that differ by less are the same, mm and rad: above rounding, below any tolerance.
const SAME_PLACE: f64 = 1e-7;

fn straight(from: &Position, to: &Position) -> AxisMove {
    let point = |place: &Position| Vec3::new(place[0], place[1], place[2]);
    let rotary = |place: &Position| [place[3], place[4], place[5]];
    AxisMove {
        curve: Curve::Line(Line { start: point(from), end: point(to) }),
        rotary_from: rotary(from),
        rotary_to: rotary(to),
        deviation_mm: 0.0,
    }
}

/// A piece of a move of which no axis is known.
fn motionless() -> AxisMove {
    straight(&[0.0; AXES], &[0.0; AXES])
}
