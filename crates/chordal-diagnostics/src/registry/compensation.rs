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

pub(super) const GOUGE: CodeInfo = CodeInfo {
    code: Code::CutterGouges,
    id: "CH530",
    name: "cutter-gouges",
    severity: Severity::Error,
    summary: "the tool cuts into the programmed contour",
    explanation: r#"Somewhere on its compensated path the tool centre comes nearer to the contour of the part than the
tool radius: metal goes that should stay. The message names the depth, the point, the block that cuts
and the block that is cut. The two may lie many blocks apart, in a neck or a slot narrower than the
tool; a control looks only a few blocks ahead and often runs such a program without an alarm.

This is what the geometry says. What the control itself does, alarm or cut, is told separately: an
alarm without this message is a false alarm, this message without an alarm is the dangerous case.

Take a smaller tool or a smaller offset; `chordal comp-range` gives the largest one and the block that
limits it. Depths under 2 microns, or under twice the least increment, are not reported."#,
};

pub(super) const GOUGE_AT_LEAD: CodeInfo = CodeInfo {
    code: Code::CutterGougesAtLead,
    id: "CH531",
    name: "cutter-gouges-at-lead",
    severity: Severity::Warning,
    summary: "the lead-in or lead-out cuts into the end of the contour",
    explanation: r#"While compensation comes on or goes off, the tool moves aslant and is not yet, or no longer, a full
radius away from the first or last wall. Within a tool radius of that end it cuts into the contour.
Programs often begin and end off the part, where this cuts air; then nothing is wrong.

The way in is clear of the first wall if its start lies at least a tool radius to the tool's side of
that wall, measured square to it. A lead-in in line with the wall always cuts a little: 0.15 mm with a
radius of 5 and 20 mm of lead. Start farther to the side, or lead in with an arc."#,
};

pub(super) const SIDE_AMBIGUOUS: CodeInfo = CodeInfo {
    code: Code::SideAmbiguous,
    id: "CH532",
    name: "side-ambiguous",
    severity: Severity::Note,
    summary: "a contour is run both ways, so neither side of it is the part",
    explanation: r#"Two blocks run along the same line or arc in opposite directions with compensation on the same side.
The tool passes on both sides of it, as in a slot programmed along its middle, and nothing tells on
which side metal should stay. The check for gouges takes the curve itself as the limit on both sides."#,
};

pub(super) const GOUGE_SEARCH_LIMIT: CodeInfo = CodeInfo {
    code: Code::GougeSearchLimit,
    id: "CH533",
    name: "gouge-search-limit",
    severity: Severity::Warning,
    summary: "not every place of the contour was checked for gouges",
    explanation: r#"The contour folds so often within a tool radius that the check stopped at its limit of comparisons.
What it reported is real; there may be more. Check the contour in parts, or with a smaller tool."#,
};
