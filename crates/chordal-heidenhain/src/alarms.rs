//! What the control shows for an error. The texts differ between generations; they have no public numbers.

use chordal_diagnostics::Code;

/// The end of an arc is not on the circle.
pub const CIRCLE_END: &str = "CIRCLE END POS. INCORRECT";
/// A tangent arc has no element before it.
pub const ANGLE_REFERENCE: &str = "ANGLE REFERENCE MISSING";
/// CC was not programmed.
pub const CENTER_UNDEFINED: &str = "CIRCLE CENTER UNDEFINED";
/// A rounding does not fit between its elements.
pub const ROUNDING_TOO_LARGE: &str = "ROUNDING RADIUS TOO LARGE";
/// A rounding has no element before or after it.
pub const ROUNDING_UNDEFINED: &str = "ROUNDING OFF NOT DEFINED";
/// A chamfer is not between two lines.
pub const CHAMFER_NOT_PERMITTED: &str = "CHAMFER NOT PERMITTED";
/// Compensation begins on an arc.
pub const WRONGLY_STARTED: &str = "PATH OFFSET WRONGLY STARTED";
/// Compensation ends on an arc.
pub const WRONGLY_ENDED: &str = "PATH OFFSET WRONGLY ENDED";
/// RL follows RR, or the other way round.
pub const COMPENSATION_UNDEFINED: &str = "RADIUS COMP. UNDEFINED";
/// The tool does not fit.
pub const TOOL_TOO_LARGE: &str = "TOOL RADIUS TOO LARGE";
/// There is no feed.
pub const FEED_MISSING: &str = "FEED RATE IS MISSING";
/// There is no speed.
pub const WRONG_RPM: &str = "WRONG RPM";
/// A label does not exist.
pub const LABEL_NOT_FOUND: &str = "LABEL NUMBER NOT FOUND";
/// A label exists twice.
pub const LABEL_TWICE: &str = "LABEL NUMBER ALREADY ASSIGNED";
/// LBL 0 is called.
pub const LABEL_ZERO: &str = "JUMP TO LABEL 0 NOT PERMITTED";
/// Calls are nested too deep.
pub const NESTING: &str = "EXCESSIVE SUBPROGRAMMING";
/// A formula has no value.
pub const ARITHMETICAL_ERROR: &str = "ARITHMETICAL ERROR";
/// A cycle lacks some of its data.
pub const CYCLE_INCOMPLETE: &str = "CYCL INCOMPLETE";
/// There is no tool.
pub const TOOL_NOT_DEFINED: &str = "TOOL NOT DEFINED";
/// There is no datum table, or none of several is active.
pub const DATUM_TABLE_MISSING: &str = "DATUM TABLE ?";
/// The datum table has no line with this number.
pub const DATUM_NUMBER_MISSING: &str = "DATUM NUMBER NOT FOUND";
/// A word stands twice in a block.
pub const DOUBLE_PROGRAMMED: &str = "AXIS DOUBLE PROGRAMMED";

/// The texts of problems that always have the same one, and of those that the stages after the language find.
pub const TEXTS_OF_CODES: &[(Code, &str)] = &[
    (Code::MissingFeed, FEED_MISSING),
    (Code::MissingLabel, LABEL_NOT_FOUND),
    (Code::NestingTooDeep, NESTING),
    (Code::DivisionByZero, ARITHMETICAL_ERROR),
    (Code::OutsideDomain, ARITHMETICAL_ERROR),
    (Code::RadiusMismatch, CIRCLE_END),
    (Code::CornerTooLarge, ROUNDING_TOO_LARGE),
    (Code::CornerBlock, ROUNDING_UNDEFINED),
    (Code::CornerNext, ROUNDING_UNDEFINED),
    (Code::CornerNextMotion, ROUNDING_UNDEFINED),
    (Code::InsideArcTooSmall, TOOL_TOO_LARGE),
    (Code::CompensationInterference, TOOL_TOO_LARGE),
    (Code::NoOffsetIntersection, TOOL_TOO_LARGE),
    (Code::TravelExceeded, "LIMIT SWITCH"),
];
