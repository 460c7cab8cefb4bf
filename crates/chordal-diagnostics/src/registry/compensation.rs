//! Cutter radius compensation.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const ON_ARC: CodeInfo = CodeInfo {
    code: Code::CompensationOnArc,
    id: "CH501",
    name: "compensation-on-arc",
    severity: Severity::Error,
    summary: "compensation starts or ends on an arc",
    explanation: r#"Cutter radius compensation comes on and goes off along a straight move, the lead-in and the
lead-out. With G41, G42 or G40 on an arc the control alarms."#,
};

pub(super) const NOT_CARRIED_OUT: CodeInfo = CodeInfo {
    code: Code::CompensationNotCarriedOut,
    id: "CH502",
    name: "compensation-not-carried-out",
    severity: Severity::Note,
    summary: "the programmed path is shown, not the compensated one",
    explanation: r#"The program turns cutter radius compensation on. This version follows the programmed contour and does
not move the tool centre aside by the offset."#,
};

pub(super) const WITHOUT_OFFSET: CodeInfo = CodeInfo {
    code: Code::CompensationWithoutOffset,
    id: "CH503",
    name: "compensation-without-offset",
    severity: Severity::Warning,
    summary: "compensation is on with no offset chosen",
    explanation: r#"G41 or G42 stands with no D (on a Fadal in Format 1, H) chosen before. Nothing says how far to stay
away from the contour."#,
};

pub(super) const PLANE_CHANGE: CodeInfo = CodeInfo {
    code: Code::PlaneChangeInCompensation,
    id: "CH504",
    name: "plane-change-in-compensation",
    severity: Severity::Error,
    summary: "the plane changes while compensation is on",
    explanation: r#"The offset is applied in the plane that was active when compensation came on; a change of plane before
G40 is refused."#,
};

pub(super) const AT_END: CodeInfo = CodeInfo {
    code: Code::CompensationAtEnd,
    id: "CH505",
    name: "compensation-at-end",
    severity: Severity::Warning,
    summary: "compensation is still on at the end of the program",
    explanation: r#"The program ends with G41 or G42 active. Some controls alarm, others begin the next program with it.
Put a G40 on the lead-out."#,
};
