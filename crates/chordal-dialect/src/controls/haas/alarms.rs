//! The alarms of Haas mills.

use crate::vocabulary::*;

pub(in crate::controls) const ALARMS: &[(Code, &str)] = &[
    (Code::InsideArcTooSmall, "alarm 342 CUTTER COMP PATH TOO SMALL"),
    (Code::CompensationInterference, "alarm 342 CUTTER COMP PATH TOO SMALL"),
    (Code::NoOffsetIntersection, "alarm 342 CUTTER COMP PATH TOO SMALL"),
    (Code::LeadInTooShort, "alarm 342 CUTTER COMP PATH TOO SMALL"),
    (Code::CompensationPlane, "alarm 344 cutter compensation with G18 and G19"),
    (Code::RadiusMismatch, "alarm 304 INVALID I, J, OR K IN G02 OR G03"),
    (Code::RadiusTooShort, "alarm 302 INVALID R CODE"),
    (Code::CenterOutsidePlane, "alarm 303 INVALID X, Y, OR Z IN G02 OR G03"),
    (
        Code::CompensationOnArc,
        "alarm 340 or 341 cutter compensation beginning or ending with G02 or G03",
    ),
    (Code::PlaneChangeInCompensation, "alarm 344 cutter compensation with G18 and G19"),
    (Code::ProgramWithoutEnd, "alarm 312 PROGRAM END"),
    (Code::LengthOffsetOfOtherTool, "alarm 332 H and T not matched"),
    (Code::PocketWithoutGeometry, "alarm 314 SUBPROGRAM NOT IN MEMORY"),
    (Code::PocketGeometry, "alarm 370 POCKET DEFINITION ERROR"),
    (Code::BadVariable, "503"),
    (Code::UnbalancedBrackets, "504"),
    (Code::DivisionByZero, "508"),
    (Code::BadExpression, "510"),
    (Code::LoopMismatch, "524"),
    (Code::BadArgument, "529"),
    (Code::MacroNesting, "531"),
    (Code::BadOutput, "535"),
];
