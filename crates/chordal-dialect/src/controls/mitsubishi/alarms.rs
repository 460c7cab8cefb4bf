//! The alarms of Mitsubishi M700 and M800.

use crate::vocabulary::*;

pub(in crate::controls) const ALARMS: &[(Code, &str)] = &[
    (Code::InsideArcTooSmall, "P153 Compensation interference"),
    (Code::CompensationInterference, "P153 Compensation interference"),
    (Code::NoOffsetIntersection, "P152 No intersection"),
    (Code::RadiusMismatch, "P70 Arc end point deviation large"),
    (Code::RadiusTooShort, "P71 Arc center error"),
    (Code::NoCenter, "P33 Format error"),
    (Code::CornerNext, "P382 No corner movement"),
    (Code::CornerNextMotion, "P382 No corner movement"),
    (Code::SpiralTurns, "P33 Format error"),
    (Code::CenterOutsidePlane, "P33 Format error"),
    (Code::CompensationOnArc, "P151 Radius compensation during arc mode"),
    (Code::MissingSubprogram, "P232 No program number"),
    (Code::MissingLabel, "P231 No sequence number"),
    (Code::NestingTooDeep, "P230 Subprogram nesting over"),
    (Code::MissingFeed, "P62 No F command"),
    (Code::UnknownCode, "P34 Improper G code"),
    (Code::SpiralInFrame, "P34 Improper G code"),
    (Code::OutsideDomain, "P282 CALCULATION IMPOSSIBLE"),
    (Code::DivisionByZero, "P283 DIVIDE BY ZERO"),
    (Code::BadVariable, "P241 NO VARI NUMBER"),
    (Code::FrameValue, "P35 Cmd-value over"),
    (Code::ScalingOption, "P350"),
    (Code::RotationOption, "P260"),
    (Code::UnequalScaleArc, "P70 Arc end point deviation large"),
];
