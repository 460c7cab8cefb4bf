//! The words of the general settings, and what they stand for.

use chordal_kernel::rules::*;

use crate::parameters::*;

pub(super) const FULL_CIRCLES_BY_RADIUS: &[(&str, FullCircleByRadius)] = &[
    ("refused", FullCircleByRadius::Refused),
    ("no-motion", FullCircleByRadius::NoMotion),
    ("straight", FullCircleByRadius::Straight),
];

pub(super) const TOOL_CHANGERS: &[(&str, ToolChanger)] = &[
    ("sender", ToolChanger::Sender),
    ("nobody", ToolChanger::Nobody),
    ("machine", ToolChanger::Machine),
];

pub(super) const AFTER_REFUSAL: &[(&str, bool)] = &[("stop", false), ("continue", true)];

pub(super) const DWELL_UNITS: &[(&str, f64)] = &[("s", 1.0), ("ms", 0.001)];

pub(super) const X_WORDS: &[(&str, bool)] = &[("radii", true), ("diameters", false)];

pub(super) const CODE_SYSTEMS: &[(&str, u8)] = &[("A", 0), ("B", 1), ("C", 2)];

pub(super) const ROUTINE_COUNTS: &[(&str, FixedRoutineCount)] =
    &[("repeat", FixedRoutineCount::Repeat), ("once", FixedRoutineCount::Once)];

pub(super) const REGISTERS: &[(&str, u8)] = &[("R1", 1), ("R2", 2), ("R3", 3), ("R4", 4)];

pub(super) const OUTSIDE_CORNERS: &[(&str, OutsideCorner)] =
    &[("linear", OutsideCorner::Linear), ("arc", OutsideCorner::Arc)];

pub(super) const COMPENSATION_ENTRIES: &[(&str, CompensationEntry)] = &[
    ("A", CompensationEntry::A),
    ("B", CompensationEntry::B),
    ("contour", CompensationEntry::Contour),
];

pub(super) const OFFSET_MEMORIES: &[(&str, OffsetMemory)] = &[
    ("not known", OffsetMemory::NotKnown),
    ("A", OffsetMemory::Whole),
    ("C", OffsetMemory::GeometryAndWear),
    ("B", OffsetMemory::GeometryAndWear),
];

pub(super) const SPIRAL_ON_RAY: &[(&str, SpiralOnRay)] =
    &[("no-turn", SpiralOnRay::NoTurn), ("full-turn", SpiralOnRay::FullTurn)];

pub(super) const OMITTED_CENTER: &[(&str, OmittedCenter)] =
    &[("start", OmittedCenter::Start), ("zero", OmittedCenter::Zero)];

pub(super) const ARCS_WITHOUT_CENTER: &[(&str, bool)] = &[("line", true), ("refused", false)];
pub(super) const MACHINE_MOVES: &[(&str, bool)] = &[("rapid", true), ("in-force", false)];

pub(super) const EXCESS_DECIMALS: &[(&str, ExcessDecimals)] = &[
    ("exact", ExcessDecimals::Exact),
    ("cut", ExcessDecimals::Cut),
    ("rounded", ExcessDecimals::Rounded),
    ("unknown", ExcessDecimals::Unknown),
];

pub(super) const SPINDLE_AT_TOOL_CHANGE: &[(&str, bool)] = &[("stops", true), ("turns", false)];

pub(super) const NEAR_SEMICIRCLES: &[(&str, bool)] = &[("computed", false), ("middle", true)];

pub(super) const ROTARY_IN_ARC: &[(&str, bool)] = &[("allowed", true), ("refused", false)];

pub(super) const MACRO_ANGLES: &[(&str, bool)] = &[("0-to-360", true), ("180", false)];

pub(super) const UNIT_CODES: &[(&str, UnitCodes)] =
    &[("G20/G21", UnitCodes::G20), ("G70/G71", UnitCodes::G70), ("both", UnitCodes::Both)];

pub(super) const DECIMAL_POINTS: &[(&str, DecimalPoint)] =
    &[("least-increment", DecimalPoint::LeastIncrement), ("calculator", DecimalPoint::Calculator)];

pub(super) const ARC_CENTERS: &[(&str, ArcCenter)] = &[
    ("from-start", ArcCenter::FromStart),
    ("absolute", ArcCenter::Absolute),
    ("from-center", ArcCenter::FromCenter),
];

pub(super) const SPIRALS: &[(&str, SpiralForm)] = &[
    ("none", SpiralForm::None),
    ("pitches", SpiralForm::Pitches),
    ("increment-height-count", SpiralForm::IncrementHeightCount),
    ("increment-count", SpiralForm::IncrementCount),
];
