//! The machine and its offsets.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const TRAVEL_EXCEEDED: CodeInfo = CodeInfo {
    code: Code::TravelExceeded,
    id: "CH601",
    name: "travel-exceeded",
    severity: Severity::Error,
    summary: "a move leaves the travel of the machine",
    explanation: r#"The end point (or a point of an arc) lies outside the travel of an axis; or, where the work offset is
not known, the program as a whole needs more travel than the axis has."#,
};

pub(super) const RAPID_INTO_PART: CodeInfo = CodeInfo {
    code: Code::RapidIntoPart,
    id: "CH602",
    name: "rapid-into-part",
    severity: Severity::Warning,
    summary: "a rapid move runs below the clearance plane",
    explanation: r#"A rapid moves down at an angle below the clearance plane, joins two cuts below it, or plunges below it
inside the region that the program cuts. Often a G0 should have been a G1. The clearance plane
is Z0 of the work coordinates unless the machine file's `[program] clearance` says otherwise."#,
};

pub(super) const OFFSET_NOT_SET: CodeInfo = CodeInfo {
    code: Code::OffsetNotSet,
    id: "CH603",
    name: "offset-not-set",
    severity: Severity::Note,
    summary: "the machine file has no value for an offset that the program uses",
    explanation: r#"The position of the machine relative to the part is not known, so moves in machine coordinates (G28, G53)
are not drawn and travel is checked only for the program as a whole. Give `[work_offsets.G54]` and
`[tools.1] length` in the machine file or with `--set`."#,
};

pub(super) const LENGTH_OFFSET_OF_OTHER_TOOL: CodeInfo = CodeInfo {
    code: Code::LengthOffsetOfOtherTool,
    id: "CH604",
    name: "length-offset-of-other-tool",
    severity: Severity::Note,
    summary: "the length offset is not that of the tool in the spindle",
    explanation: r#"The number of H (or D) is not the number of the tool in the spindle. Where offsets have the numbers of
their tools, this is a mistake; a Haas alarms on it (Setting 15)."#,
};

pub(super) const BAD_SETTING: CodeInfo = CodeInfo {
    code: Code::BadSetting,
    id: "CH605",
    name: "bad-setting",
    severity: Severity::Error,
    summary: "the control has no such setting, or not with this value",
    explanation: r#"`[settings]` of the machine file holds the control's own parameters. The control has no setting of this
name, or the setting cannot have this value. `chordal machines NAME` lists the settings with defaults and
sources."#,
};

pub(super) const SPINDLE_OVER_LIMIT: CodeInfo = CodeInfo {
    code: Code::SpindleOverLimit,
    id: "CH606",
    name: "spindle-over-limit",
    severity: Severity::Warning,
    summary: "the spindle speed is above the machine's maximum",
    explanation: r#"S is larger than `[spindle] max` of the machine file."#,
};

pub(super) const INTERNAL_ERROR: CodeInfo = CodeInfo {
    code: Code::InternalError,
    id: "CH901",
    name: "internal-error",
    severity: Severity::Error,
    summary: "Chordal has a defect",
    explanation: r#"This is a defect of Chordal, not of the program. Please report it with the program."#,
};
