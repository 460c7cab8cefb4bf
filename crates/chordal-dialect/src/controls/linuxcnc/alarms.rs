//! The alarms of LinuxCNC (RS274/NGC).

use crate::vocabulary::*;

pub(super) const ALARMS: &[(Code, &str)] = &[
    (Code::InsideArcTooSmall, "Tool radius not less than arc radius with comp"),
    (
        Code::CompensationInterference,
        "{move} in concave corner cannot be reached by the tool without gouging",
    ),
    (
        Code::NoOffsetIntersection,
        "Arc move in concave corner cannot be reached by the tool without gouging / Arc to \
         straight motion makes a corner the compensated tool can't fit in without gouging",
    ),
    (
        Code::LeadInTooShort,
        "Length of cutter compensation entry move is not greater than the tool radius",
    ),
    (
        Code::CompensationOnArc,
        "The move just after exiting cutter compensation mode must be straight, not an arc",
    ),
    (Code::SideChangeRefused, "Cannot turn cutter radius comp on when on"),
    (Code::CompensationTwice, "Cannot turn cutter radius comp on when on"),
    (Code::NewOffsetRefused, "Cannot turn cutter radius comp on when on"),
    (Code::CompensationPlane, "Cutter radius compensation allowed only in XY, XZ planes"),
    (Code::ReferenceInCompensation, "Cannot use g28 or g30 with cutter radius comp"),
    (Code::ToolChangeInCompensation, "Cannot change tools with cutter radius compensation on"),
    (
        Code::ShiftInCompensation,
        "Cannot change axis offsets with cutter radius comp; for G10, Cannot change the active coordinate \
         system with cutter radius compensation on; for G54 to G59.3, Cannot change coordinate systems with \
         cutter radius compensation on",
    ),
    (Code::RadiusMismatch, "Radius to end of arc differs from radius to start"),
    (Code::RadiusTooShort, "Arc radius too small to reach end point"),
    (Code::FullCircleByRadius, "Current point same as end point of arc"),
    (Code::NoCenter, "R I J K words all missing for arc"),
    (Code::CenterAndRadius, "Mixed radius ijk format for arc"),
    (Code::ZeroRadius, "Zero-radius arc"),
    (Code::MissingFeed, "Cannot do linear feed with zero feed rate"),
    (Code::UnknownCode, "Unknown g code used"),
    (Code::SameGroup, "Two g codes used from same modal group"),
    (Code::RepeatedWord, "Multiple words of one letter on one line"),
    (Code::UnclosedComment, "Unclosed comment found"),
    (Code::BadNumber, "Bad number format"),
    (Code::PlaneChangeInCompensation, "Cannot change planes with cutter radius compensation on"),
    (Code::DivisionByZero, "Attempt to divide by zero"),
    (Code::MissingSubprogram, "EOF in file seeking o-word"),
    (Code::NestingTooDeep, "Too many subroutine levels"),
    (Code::UnsetName, "Named parameter not defined"),
    (Code::BadVariable, "Parameter number out of range"),
    (Code::UnbalancedBrackets, "Unclosed expression"),
    (Code::ProbeWithoutHit, "G38.2 probe move finished without making contact"),
    (Code::ProgramWithoutEnd, "File ended with no percent sign or program end"),
    (Code::CycleWithoutR, "R clearance plane unspecified in cycle"),
    (Code::CycleWithoutDepth, "Z value unspecified in xy plane canned cycle"),
    (Code::CycleWithoutPeck, "Q word missing with g83, or negative or zero q value used"),
    (Code::CycleWithoutDwell, "Dwell time p word missing"),
    (Code::CycleLevels, "R less than z in cycle in xy plane"),
    (Code::CycleInCompensation, "Cannot use canned cycles with cutter compensation on"),
    (Code::CycleZeroRepeats, "Cannot do zero repeats of cycle"),
    (Code::CycleInInverseTime, "Cannot use inverse time feed with canned cycles"),
    (Code::CycleRotaryWord, "Cannot put an a in canned cycle"),
    (Code::NoMotionInForce, "Cannot use axis values without a g code that uses them"),
    (
        Code::NoKeptModes,
        "Cannot restore context from invalid stack frame - missing M70/M73?",
    ),
    (Code::CycleSpindle, "Spindle not turning in cycle"),
    (
        Code::SplineWords,
        "Must specify both P and Q with G5 / Must specify both I and J, or neither / Must specify both I and J \
         with G5.1",
    ),
    (Code::SplinePoint, "You must specify both X and Y coordinates for Control Points"),
    (Code::SplineWeight, "Must specify positive weight P for every Control Point"),
    (Code::SplineOpen, "Cannot use G5.3 without G5.2 first"),
    (
        Code::SplineTooFew,
        "You must specify a number of control points at least equal to the order L = {delta}",
    ),
    (
        Code::SplinePlane,
        "Splines must be in the XY plane / Splines may not have motion in Z, A, B, or C",
    ),
    (Code::SplineInCompensation, "Cannot convert spline with cutter radius compensation"),
];
