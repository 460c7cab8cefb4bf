//! The rules of a control for cutter radius compensation, as data.
//!
//! "Inside" and "outside" are used as in the manuals: a corner is inside when its angle on the side of the
//! workpiece is above 180 degrees.

/// What the values of the offset table mean.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum OffsetKind {
    /// The table holds diameters.
    Diameter,
    /// The table holds radii.
    Radius,
}

/// The path of compensation round an outside corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum OutsideCorner {
    /// Straight to the intersection of the offset moves, cut off by another line when that is far away.
    Linear,
    /// An arc about the corner.
    Arc,
}

/// Up to which change of direction an outside corner ends where the offset paths meet; beyond, it is an arc.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CornerAngles {
    /// The largest change of direction of such a corner whatever the program chooses, rad (Sinumerik MD20230).
    pub always_meets_rad: f64,
    /// The same where the program chooses the meeting point, rad (Sinumerik G451, MD20210).
    pub meets_rad: f64,
}

/// How compensation starts and ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CompensationEntry {
    /// To the point perpendicular to the start of the first block of the contour.
    A,
    /// Through the intersection, or round the corner with an additional line.
    B,
    /// As if the first move were already part of the contour.
    Contour,
}

/// Whether a control allows, ignores or refuses something.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum AllowanceRule {
    /// It is carried out.
    Allowed,
    /// It has no effect.
    Ignored,
    /// The control stops with an alarm.
    Refused,
}

/// What G41 or G40 does in a block without a move.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum AloneAction {
    /// It waits for the next move in the plane.
    Waits,
    /// The tool moves sideways by the offset, or back (start-up type C).
    Perpendicular,
}

/// A change from G41 to G42 or back without G40 between.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SideChange {
    /// Through the intersection of the left and the right offset path; if there is none, the offset vector is
    /// perpendicular to the start of the new block.
    Crossing,
    /// The block with the new code moves from one side to the other; refused on an arc.
    Along,
    /// Refused on a line, carried out on an arc.
    RefusedOnLine,
    /// Refused.
    Refused,
}

/// The planes that compensation works in.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CompensationPlanes {
    /// XY, ZX and YZ.
    All,
    /// XY and ZX.
    NotYz,
    /// XY alone.
    XyOnly,
}

/// Minimum length of the first move.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum LeadLength {
    /// No rule.
    Any,
    /// At least the offset.
    AtLeastOffset,
    /// Longer than the offset.
    AboveOffset,
}

/// How a control detects that the offset path does not fit (interference).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum InterferenceSearch {
    /// The compensated move runs opposite to the programmed one, or an arc differs in angle by more than
    /// 180 degrees.
    Direction,
    /// An arc differs in angle by more than 180 degrees (Fanuc 5008#1).
    ArcAngle,
    /// The offset vectors at both ends of a block cross.
    Vectors,
    /// Inside radii, reversed moves, and arcs that become longer than programmed by more than a small angle.
    Strict,
}

/// What follows from interference.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum InterferenceRemedy {
    /// The control stops with an alarm.
    Alarm,
    /// The block is skipped if its neighbours cross; otherwise the control stops with an alarm.
    Avoid,
}

/// Spirals while compensation is on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SpiralCompensation {
    /// The control stops with an alarm.
    Refused,
    /// Replaced by circles through the ends.
    ByCircles,
}

/// The rules of a control for cutter radius compensation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompensationRules {
    /// Offset moves whose ends are closer than this join tangentially, mm.
    pub tangent_mm: f64,
    /// A corner up to this angle counts as tangent and is not trimmed, rad (LinuxCNC 0.05).
    pub tangent_rad: f64,
    /// Where the control lets the program choose between arcs and meeting points; `None` where it does not.
    pub corner_angles: Option<CornerAngles>,
    /// The second of two corner points is dropped if it differs by at most this on both axes, mm; 0 keeps all.
    pub drop_link_mm: f64,
    /// Largest number of blocks without motion in the plane between two moves; `None` for no limit.
    pub idle_blocks: Option<u32>,
    /// A block whose move has no length counts as this many blocks without motion.
    pub zero_move_counts: u32,
    /// M0 and M1 end the look-ahead.
    pub stops_end_look_ahead: bool,
    /// G41 or G42 in a block without a move.
    pub on_alone: AloneAction,
    /// G40 in a block without a move.
    pub off_alone: AloneAction,
    /// G40 acts at once: the next move of any axis ends on its programmed point.
    pub off_at_once: bool,
    /// A reversal by 180 degrees (within `tangent_rad`) is an outside corner; into an arc, or from an arc into a
    /// line, with the tool outside the arc, an inside corner.
    pub cusps_meet: bool,
    /// F of G93 gives the speed on the programmed length, and the tool path has the same speed.
    pub inverse_time_as_speed: bool,
    /// The arc round a corner belongs to the next block and has its feed; before a rapid it is a straight rapid.
    pub corner_of_next: bool,
    /// Moves outside of the plane between the two blocks of a corner come before its arc.
    pub moves_before_corner: bool,
    /// G40 with I J ends the last block at the intersection with that direction.
    pub off_toward: bool,
    /// Compensation may start on an arc.
    pub start_on_arc: bool,
    /// The same G41 or G42 again, alone in its block.
    pub repeated: RepeatedCodeRule,
    /// A change from G41 to G42 or back.
    pub side_change: SideChange,
    /// Another D while compensation is on.
    pub new_offset: AllowanceRule,
    /// Another D in the block of an arc.
    pub new_offset_on_arc: AllowanceRule,
    /// Minimum length of the first move.
    pub lead: LeadLength,
    /// The first move after G41 or G42 is the lead-in, whichever axes it moves.
    pub lead_follows_code: bool,
    /// The planes it works in.
    pub planes: CompensationPlanes,
    /// How the control detects interference.
    pub interference: InterferenceSearch,
    /// The control checks for interference.
    pub checks: bool,
    /// What follows from interference.
    pub remedy: InterferenceRemedy,
    /// An inside arc of exactly the offset's radius is refused.
    pub equal_radius_refused: bool,
    /// An arc may become longer than programmed by this angle, rad, in mm and in inch programs (for
    /// [`InterferenceSearch::Strict`]).
    pub longer_arc_rad: [f64; 2],
    /// Spirals.
    pub spirals: SpiralCompensation,
    /// Coordinate shifts, reference returns and machine coordinates while it is on.
    pub coordinate_change: AllowanceRule,
    /// G40, and G41 without D, use the number of the tool in the spindle as the offset number.
    pub offset_of_tool: bool,
    /// The feed of inside arcs is F·(R−r)/R, so that the contour is cut at F, but at least this fraction of F; 1
    /// for an unchanged F.
    pub inside_feed_least: f64,
}

/// The effect of the same code again.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum RepeatedCodeRule {
    /// Nothing.
    Ignored,
    /// The offset vector becomes perpendicular to the end of the previous block.
    Perpendicular,
    /// The control stops with an alarm.
    Refused,
}

impl CompensationRules {
    /// The rules most controls share.
    pub const COMMON: CompensationRules = CompensationRules {
        tangent_mm: 0.002,
        tangent_rad: 0.0,
        corner_angles: None,
        drop_link_mm: 0.0,
        idle_blocks: None,
        zero_move_counts: 1,
        stops_end_look_ahead: false,
        on_alone: AloneAction::Waits,
        off_alone: AloneAction::Waits,
        off_at_once: false,
        cusps_meet: false,
        inverse_time_as_speed: false,
        corner_of_next: false,
        moves_before_corner: false,
        off_toward: false,
        start_on_arc: false,
        repeated: RepeatedCodeRule::Ignored,
        side_change: SideChange::Crossing,
        new_offset: AllowanceRule::Allowed,
        new_offset_on_arc: AllowanceRule::Allowed,
        lead: LeadLength::Any,
        lead_follows_code: false,
        planes: CompensationPlanes::All,
        interference: InterferenceSearch::Direction,
        checks: true,
        remedy: InterferenceRemedy::Alarm,
        equal_radius_refused: false,
        longer_arc_rad: [f64::INFINITY; 2],
        spirals: SpiralCompensation::Refused,
        coordinate_change: AllowanceRule::Allowed,
        offset_of_tool: false,
        inside_feed_least: 1.0,
    };
}
