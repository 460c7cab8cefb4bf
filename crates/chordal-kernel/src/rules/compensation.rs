//! What a control does in cutter radius compensation, as data.
//!
//! The words "inside" and "outside" are those of the manuals: inside is a corner whose
//! work-side angle is above 180 degrees.

/// What counts when a radius value is in the offset table.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum OffsetKind {
    /// The table holds diameters.
    Diameter,
    /// The table holds radii.
    Radius,
}

/// How compensation goes round an outside corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum OutsideCorner {
    /// Straight on to the intersection, with a further line where that is far away.
    Linear,
    /// An arc about the corner.
    Arc,
}

/// How compensation starts and ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CompensationEntry {
    /// Perpendicular to the first block of the contour.
    A,
    /// By the intersection, or round the corner with a further line.
    B,
    /// As if the first move were already part of the contour.
    Contour,
}

/// What is done with a thing that a control may allow, pass over or refuse.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum AllowanceRule {
    /// It is done.
    Allowed,
    /// It is passed over.
    Ignored,
    /// The control alarms.
    Refused,
}

/// What G41 or G40 does in a block that does not move.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum AloneAction {
    /// It waits for the next move in the plane.
    Waits,
    /// The tool moves aside, or back, by the offset (start-up type C).
    Perpendicular,
}

/// A change from G41 to G42 or back without G40 between.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SideChange {
    /// The left and the right offset cross; where they do not, the vector stands on the new
    /// block at its start.
    Crossing,
    /// The block with the new code goes from one side to the other; refused on an arc.
    Along,
    /// Refused on a line, done on an arc.
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

/// How long the first move must be.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum LeadLength {
    /// No rule.
    Any,
    /// At least the offset.
    AtLeastOffset,
    /// Longer than the offset.
    AboveOffset,
}

/// How a control looks for places where the offset does not fit.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum InterferenceSearch {
    /// The compensated move goes against the programmed one, or an arc turns by more than
    /// 180 degrees otherwise.
    Direction,
    /// An arc turns by more than 180 degrees otherwise (Fanuc 5008#1).
    ArcAngle,
    /// The offset vectors at both ends of a block cross.
    Vectors,
    /// Inside radii, reversed moves, and arcs that come out longer than programmed by more
    /// than a small angle.
    Strict,
}

/// What is done where interference was found.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum InterferenceRemedy {
    /// The control alarms.
    Alarm,
    /// The block is left out where its neighbours cross, else the control alarms.
    Avoid,
}

/// Spirals while compensation is on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SpiralCompensation {
    /// The control alarms.
    Refused,
    /// Done by circles through the ends.
    ByCircles,
}

/// The rules of a control for cutter radius compensation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CompensationRules {
    /// An offset joint closer than this is tangent, mm.
    pub tangent_mm: f64,
    /// A kink up to here counts as tangent and is not trimmed, rad (LinuxCNC 0.05).
    pub tangent_rad: f64,
    /// The later of two corner points is dropped when it is not further than this on either
    /// axis, mm; 0 keeps all.
    pub drop_link_mm: f64,
    /// Most blocks without motion in the plane between two that move; `None` for no limit.
    pub idle_blocks: Option<u32>,
    /// A block that goes nowhere counts as so many blocks without motion.
    pub zero_move_counts: u32,
    /// M0 and M1 end the look-ahead.
    pub stops_end_look_ahead: bool,
    /// G41 or G42 in a block that does not move.
    pub on_alone: AloneAction,
    /// G40 in a block that does not move.
    pub off_alone: AloneAction,
    /// G40 acts at once: the next move of any axis ends on its programmed point.
    pub off_at_once: bool,
    /// A path that turns back by 180 degrees, give or take the kink of a tangent, is an outside corner;
    /// into an arc, or out of one into a line, with the tool outside of it an inside one.
    pub cusps_meet: bool,
    /// F of G93 is for the programmed length, and its speed holds for the path of the tool.
    pub inverse_time_as_speed: bool,
    /// The arc round a corner belongs to the block after it: its feed, or straight at its rapid.
    pub corner_of_next: bool,
    /// G40 with I J ends the last block at the crossing with that direction.
    pub off_toward: bool,
    /// Compensation may start on an arc.
    pub start_on_arc: bool,
    /// The same G41 or G42 again, alone in its block.
    pub repeated: RepeatedCodeRule,
    /// G41 to G42.
    pub side_change: SideChange,
    /// Another D while compensation is on.
    pub new_offset: AllowanceRule,
    /// Another D in the block of an arc.
    pub new_offset_on_arc: AllowanceRule,
    /// Length of the first move.
    pub lead: LeadLength,
    /// The first move after G41 or G42 is the lead-in, whatever it moves.
    pub lead_follows_code: bool,
    /// Where it works.
    pub planes: CompensationPlanes,
    /// The control's own check.
    pub interference: InterferenceSearch,
    /// It is looked for.
    pub checks: bool,
    /// What follows from it.
    pub remedy: InterferenceRemedy,
    /// An inside arc of exactly the offset's radius is refused.
    pub equal_radius_refused: bool,
    /// An arc may come out longer than programmed by so much, rad: in mm and in inch
    /// (for [`InterferenceSearch::Strict`]).
    pub longer_arc_rad: [f64; 2],
    /// Spirals.
    pub spirals: SpiralCompensation,
    /// Shift of coordinates, reference point and machine coordinates while it is on.
    pub coordinate_change: AllowanceRule,
    /// G40, or G41 without D, takes the tool in the spindle as the offset's number.
    pub offset_of_tool: bool,
    /// Inside arcs are fed at F·(R−r)/R, but not below this part of F; 1 for F as it is.
    pub inside_feed_least: f64,
}

/// What the same code again does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum RepeatedCodeRule {
    /// Nothing.
    Ignored,
    /// The vector stands perpendicular on the end of the block before.
    Perpendicular,
    /// The control alarms.
    Refused,
}

impl CompensationRules {
    /// What most controls share.
    pub const COMMON: CompensationRules = CompensationRules {
        tangent_mm: 0.002,
        tangent_rad: 0.0,
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
