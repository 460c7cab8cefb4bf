//! What a control does with canned cycles, as data.
//!
//! Each table gives its own `CycleRules`; a machine file changes single ones by the settings
//! that the table lists. Lengths are mm, times s.

/// Canned cycles.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
#[allow(missing_docs, reason = "named by their common codes")]
pub enum CycleKind {
    ChipBreak,
    LeftTap,
    FineBore,
    Drill,
    DrillDwell,
    Peck,
    Tap,
    BoreFeedOut,
    BoreStop,
    BackBore,
    BoreManual,
    BoreDwell,
    /// Tapping with a head that reverses by itself (Fadal G75).
    SelfReversingTap,
    /// Boring with feed out, by trade knowledge alone (Fadal G87).
    BoreInOut,
}

/// What sort of cycle it is: how its hole is made, and so what its words are.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CycleFamily {
    /// Down in one cut.
    Drill,
    /// In steps, with a short lift after each.
    ChipBreak,
    /// In steps, out of the hole after each.
    Peck,
    /// In step with the spindle.
    Tap,
    /// Down and out again with the tool at the wall.
    Bore,
    /// The same, out with the tool set aside.
    FineBore,
    /// From behind, past the bore with the tool set aside.
    BackBore,
}

/// Whether P is a dwell at the bottom of the hole.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CycleDwell {
    /// Nothing waits there; what P of a cycle with pecks does is said by [`PeckRules`].
    None,
    /// Where P is written.
    Optional,
    /// The dwell is a part of the cycle.
    Essential,
}

/// What is known of a cycle, whichever control has it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CycleFacts {
    /// For people: `a pecking cycle`.
    pub name: &'static str,
    /// What sort it is.
    pub family: CycleFamily,
    /// What P is.
    pub dwell: CycleDwell,
    /// With E the spindle throws the chips off after the hole (Haas).
    pub throws_chips: bool,
    /// One control alone has it: it is never the same on another.
    pub of_one_control: bool,
}

impl CycleKind {
    /// What is known of the cycle: a row for each.
    pub const fn facts(self) -> CycleFacts {
        use CycleDwell::{Essential, None as Never, Optional};
        use CycleFamily::{BackBore, Bore, ChipBreak, Drill, FineBore, Peck, Tap};
        const fn row(name: &'static str, family: CycleFamily, dwell: CycleDwell) -> CycleFacts {
            CycleFacts { name, family, dwell, throws_chips: false, of_one_control: false }
        }
        match self {
            CycleKind::ChipBreak => row("a chip-breaking cycle", ChipBreak, Never),
            CycleKind::Peck => row("a pecking cycle", Peck, Never).throws_chips(),
            CycleKind::Drill => row("a drilling cycle", Drill, Never).throws_chips(),
            CycleKind::DrillDwell => row("a drilling cycle", Drill, Essential).throws_chips(),
            CycleKind::Tap => row("a tapping cycle", Tap, Optional).throws_chips(),
            CycleKind::LeftTap => row("a tapping cycle", Tap, Optional),
            CycleKind::SelfReversingTap => row("a tapping cycle", Tap, Optional).of_one_control(),
            CycleKind::BoreFeedOut => row("a boring cycle", Bore, Never),
            CycleKind::BoreInOut => row("a boring cycle", Bore, Never).of_one_control(),
            CycleKind::BoreStop | CycleKind::BoreManual | CycleKind::BoreDwell => {
                row("a boring cycle", Bore, Essential)
            }
            CycleKind::FineBore => row("a boring cycle", FineBore, Optional),
            CycleKind::BackBore => row("back boring", BackBore, Optional),
        }
    }

    /// What sort of cycle it is.
    pub const fn family(self) -> CycleFamily {
        self.facts().family
    }

    /// A tap, whichever way it turns.
    pub const fn is_tap(self) -> bool {
        matches!(self.family(), CycleFamily::Tap)
    }

    /// A cycle that drills in steps.
    pub const fn is_peck(self) -> bool {
        matches!(self.family(), CycleFamily::Peck | CycleFamily::ChipBreak)
    }

    /// The tool steps aside from the wall.
    pub const fn steps_aside(self) -> bool {
        matches!(self.family(), CycleFamily::FineBore | CycleFamily::BackBore)
    }

    /// A cycle whose dwell P is a part of it.
    pub const fn dwells(self) -> bool {
        matches!(self.facts().dwell, CycleDwell::Essential)
    }
}

impl CycleFacts {
    const fn throws_chips(self) -> CycleFacts {
        CycleFacts { throws_chips: true, ..self }
    }

    const fn of_one_control(self) -> CycleFacts {
        CycleFacts { of_one_control: true, ..self }
    }
}

/// Patterns of holes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum HolePattern {
    /// L holes on a whole circle.
    Circle,
    /// L holes on an arc, K degrees apart.
    Arc,
    /// L holes on a line.
    Line,
}

/// Along which axis a cycle drills.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum DrillingAxis {
    /// Z, whatever the plane (Fanuc 5101#0 = 0).
    AlwaysZ,
    /// The normal of the plane (LinuxCNC; Fanuc 5101#0 = 1).
    PlaneNormal,
    /// Z, or X by the code of the cycle (lathes).
    OfCode,
}

/// Which words of a block set off a hole while a cycle is in force.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FiringWords {
    /// A place in the plane: X or Y (Haas, Fadal).
    Place,
    /// Any of X, Y and Z (LinuxCNC); R alone is an error.
    AnyAxis,
    /// An axis word or R (Fanuc, Mitsubishi).
    AxisOrLevel,
}

/// Whether the block that defines a cycle makes a hole.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum DefinitionFires {
    /// Also without a place: where the tool stands.
    Always,
    /// Where it names a place.
    WithPlace,
    /// Never.
    Never,
}

/// What R and Z say in G91.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum IncrementalLevels {
    /// R from the initial level and Z from R, when they are given; the levels stay.
    WhenProgrammed,
    /// The same, and words that stay are read again in the mode of each block (LinuxCNC).
    ReadAgain,
    /// Levels are absolute; a depth in G91 is an alarm (Fadal).
    Refused,
}

/// What happens to a cycle without an R level.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum MissingLevel {
    /// An error.
    Refused,
    /// The level where the tool stands.
    Current,
    /// The initial level, which is noted once: the whole way down is a feed.
    Initial,
}

/// What the order of the levels must be.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum LevelOrder {
    /// Not checked by the control; a depth above R is told as doubtful.
    Free,
    /// Z not above R (LinuxCNC).
    DepthBelowR,
    /// Z not above R, and neither above the initial level (Fadal).
    AllBelowInitial,
}

/// What a repeat count of zero does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ZeroRepeats {
    /// An error (LinuxCNC).
    Refused,
    /// The words are kept, nothing moves (Fanuc, Mitsubishi).
    Stored,
    /// The place is gone to, without a hole (Haas).
    PlaceOnly,
}

/// How the tool goes to the place of a hole.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum HoleApproach {
    /// In the plane at the present level, then to R, up or down.
    PlaceThenLevel,
    /// In the plane at the present level where that is above R, else straight to the place at
    /// the level of the return; up to R first where the initial level is below it (LinuxCNC).
    ByClearLevel,
    /// Up to R where the tool is below it, in the plane at that level, then down to R (Mach3).
    FromAboveR,
}

/// What P does in a pecking cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum PeckDwell {
    /// Nothing.
    None,
    /// A dwell at the bottom of the hole.
    Bottom,
    /// A dwell at each peck of G73.
    EachPeck,
}

/// What F is in a tapping cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum TapFeed {
    /// The feed, as everywhere: lead × speed in G94, the lead in G95.
    Programmed,
    /// The lead, in G94 too (Mitsubishi `,R1`).
    Lead,
    /// The speed of the spindle; Q is the lead (Fadal Format 1).
    SpeedWithLeadQ,
}

/// Which way the tool steps aside in G76 and G87.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ShiftWords {
    /// Q, in a direction that a parameter names.
    Q,
    /// The vector I, J (J, K in G19; K, I in G18).
    Vector,
    /// Q, or the vector where Q is not given.
    QOrVector,
}

/// A direction in the plane.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub struct ShiftDirection {
    /// Along the second axis of the plane, not the first.
    pub second: bool,
    /// Towards minus.
    pub minus: bool,
}

/// How G87 (Haas G77) bores from behind.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum BackBore {
    /// Shifted at the initial level; R lies below the part; feed up to Z.
    ShiftAtInitial,
    /// Shifted at R, fed to Z, shifted back there (the words of the Haas manual).
    ShiftAtR,
    /// Z is below, K the top of the bore; feed up and down again (LinuxCNC).
    UpAndDown,
}

/// Pecks.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PeckRules {
    /// Without Q it is one cut (lathes).
    pub q_optional: bool,
    /// Pecks of G83 return to R, not by the lift alone (Fanuc lathes, No. 5101#2).
    pub full_return: bool,
    /// Q must be above zero; elsewhere its sign is ignored.
    pub positive_only: bool,
    /// I, J, K: first peck, decrease, smallest peck (Haas, Fadal).
    pub decreasing: bool,
    /// G73 with Q and K returns to R whenever K is drilled since the last return (Haas).
    pub return_after_k: bool,
    /// How far above R the chip-clearing return of G83 goes (Haas Setting 52), mm.
    pub return_above_r_mm: f64,
    /// The returns of G73 go that far too (Haas manual of 1999).
    pub chip_break_above_r: bool,
    /// P.
    pub dwell: PeckDwell,
    /// P of G73 is the distance of the lift, not a time (Fadal).
    pub p_is_lift: bool,
    /// P of G83 is the clearance, not a time (Fadal, older).
    pub p_is_clearance: bool,
    /// Pecks of G83 return to the level of G98 or G99, not to R (grblHAL).
    pub returns_to_clear: bool,
    /// After such a return the tool feeds down, also where it has drilled (grblHAL).
    pub feeds_down: bool,
    /// A dwell at the bottom of every peck, whatever P, s (grblHAL).
    pub dwell_each_s: f64,
}

impl PeckRules {
    /// P of the cycle is the distance of a lift or a clearance, not a time.
    pub fn p_is_distance(&self, kind: CycleKind) -> bool {
        kind == CycleKind::ChipBreak && self.p_is_lift
            || kind == CycleKind::Peck && self.p_is_clearance
    }
}

/// Taps.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TapRules {
    /// In G18 and G19 the cut goes to exchanged coordinates (LinuxCNC).
    pub exchanged_off_xy: bool,
    /// What F is.
    pub feed: TapFeed,
    /// The cycle starts the spindle itself where it stands.
    pub starts_spindle: bool,
    /// The spindle must already turn the right way (LinuxCNC).
    pub spindle_must_turn: bool,
    /// The feed out goes all the way to the level of the return (LinuxCNC).
    pub out_to_clear: bool,
    /// Speed of the way out over that of the way in (Haas Setting 130).
    pub out_factor: f64,
    /// J in the block overrides that factor (Haas).
    pub out_factor_by_j: bool,
    /// Q taps in pecks (Fanuc).
    pub pecks_by_q: bool,
    /// Peck tapping returns to R (Fanuc 5200#5 = 1), not by the lift.
    pub peck_full_return: bool,
    /// Lift and clearance of peck tapping (Fanuc 5213), mm.
    pub peck_lift_mm: f64,
    /// The dwell recurs at R.
    pub dwell_at_r: bool,
    /// The dwell at the bottom comes after the spindle has reversed (LinuxCNC).
    pub dwell_after_reverse: bool,
    /// A tap without P waits as long as the last cycle that had one, G80 or not (LinuxCNC).
    pub keeps_dwell: bool,
}

/// Boring.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoreRules {
    /// G89 feeds all the way to the level of the return (LinuxCNC).
    pub dwell_out_to_clear: bool,
    /// G86 dwells before the spindle stops.
    pub dwell_before_stop: bool,
    /// G86 wants a turning spindle (LinuxCNC).
    pub spindle_must_turn: bool,
    /// Which words shift the tool.
    pub shift: ShiftWords,
    /// Where Q shifts it.
    pub direction: ShiftDirection,
    /// The shift of G76 is a feed move, not a rapid (Mitsubishi).
    pub shift_at_feed: bool,
    /// G87.
    pub back: BackBore,
}

/// What ends a cycle beside G80.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub struct CycleCancel {
    /// G0, G1, G2, G3.
    pub by_motion: bool,
    /// G28, G29 (Fadal).
    pub by_reference: bool,
    /// M6 (Fadal).
    pub by_tool_change: bool,
    /// G49, H0 (Fadal).
    pub by_length_cancel: bool,
}

/// The rules of canned cycles.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CycleRules {
    /// Along which axis.
    pub axis: DrillingAxis,
    /// What sets off a hole.
    pub fires_on: FiringWords,
    /// Whether the definition does.
    pub definition: DefinitionFires,
    /// R and Z in G91.
    pub incremental: IncrementalLevels,
    /// R is the distance from the initial level (Fanuc lathes, No. 5102#6 = 0).
    pub r_from_initial: bool,
    /// R of a cycle that drills along X is a diameter, as X is.
    pub radial_r_is_diameter: bool,
    /// R not given.
    pub missing_r: MissingLevel,
    /// The order of the levels.
    pub order: LevelOrder,
    /// Words stay when one cycle follows another.
    pub keeps_words: bool,
    /// The letter of the repeat count.
    pub repeat_letter: u8,
    /// A count of zero.
    pub zero_repeats: ZeroRepeats,
    /// How the tool gets there.
    pub approach: HoleApproach,
    /// What ends a cycle.
    pub cancel: CycleCancel,
    /// P without a decimal point: seconds in one unit.
    pub dwell_integer_s: f64,
    /// P with a decimal point: seconds in one unit.
    pub dwell_point_s: f64,
    /// P must be given where a cycle dwells (LinuxCNC G82, G86, G88, G89).
    pub needs_p: bool,
    /// Refused in inverse time and with rotary words (LinuxCNC).
    pub strict: bool,
    /// Cycle codes and motion codes are one group, and after G80 an axis word needs a motion
    /// code (LinuxCNC).
    pub one_group_with_motion: bool,
    /// G99, not G98, at power-on.
    pub starts_at_r: bool,
    /// Registers of the fixed bolt circle (Fadal L93NN): radius and first angle.
    pub bolt_circle: [u8; 2],
    /// Pecks.
    pub peck: PeckRules,
    /// Taps.
    pub tap: TapRules,
    /// Bores.
    pub bore: BoreRules,
}

impl CycleRules {
    /// What most controls share.
    pub const COMMON: CycleRules = CycleRules {
        axis: DrillingAxis::AlwaysZ,
        fires_on: FiringWords::AxisOrLevel,
        definition: DefinitionFires::Always,
        incremental: IncrementalLevels::WhenProgrammed,
        r_from_initial: false,
        radial_r_is_diameter: false,
        missing_r: MissingLevel::Refused,
        order: LevelOrder::Free,
        keeps_words: true,
        repeat_letter: b'L',
        zero_repeats: ZeroRepeats::Stored,
        approach: HoleApproach::PlaceThenLevel,
        cancel: CycleCancel {
            by_motion: true,
            by_reference: false,
            by_tool_change: false,
            by_length_cancel: false,
        },
        dwell_integer_s: 0.001,
        dwell_point_s: 0.001,
        needs_p: false,
        strict: false,
        one_group_with_motion: false,
        starts_at_r: false,
        bolt_circle: [1, 2],
        peck: PeckRules {
            q_optional: false,
            full_return: true,
            positive_only: false,
            decreasing: false,
            return_after_k: false,
            return_above_r_mm: 0.0,
            chip_break_above_r: false,
            dwell: PeckDwell::None,
            p_is_lift: false,
            p_is_clearance: false,
            returns_to_clear: false,
            feeds_down: false,
            dwell_each_s: 0.0,
        },
        tap: TapRules {
            exchanged_off_xy: false,
            feed: TapFeed::Programmed,
            starts_spindle: true,
            spindle_must_turn: false,
            out_to_clear: false,
            out_factor: 1.0,
            out_factor_by_j: false,
            pecks_by_q: false,
            peck_full_return: false,
            peck_lift_mm: 1.0,
            dwell_at_r: false,
            dwell_after_reverse: false,
            keeps_dwell: false,
        },
        bore: BoreRules {
            dwell_out_to_clear: false,
            dwell_before_stop: false,
            spindle_must_turn: false,
            shift: ShiftWords::Q,
            direction: ShiftDirection { second: false, minus: false },
            shift_at_feed: false,
            back: BackBore::ShiftAtInitial,
        },
    };
}
