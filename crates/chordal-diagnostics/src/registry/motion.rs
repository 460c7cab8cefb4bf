//! Motion.

use super::{Code, CodeInfo};
use crate::Severity;

pub(super) const RADIUS_MISMATCH: CodeInfo = CodeInfo {
    code: Code::RadiusMismatch,
    id: "CH401",
    name: "radius-mismatch",
    severity: Severity::Error,
    summary: "start and end of an arc lie at different distances from its centre",
    explanation: r#"An arc by its centre gives the same circle twice: the start point is on it, and the end point must be,
too. When the two distances differ by more than the control's tolerance, one of the numbers is wrong.

    G18
    G1 X-3.4585 Z-1.168
    G2 X-2.9928 Z-.952 I-.48 K.8314      radii 0.9600 and 1.1283

The message gives the two radii, the difference, and the tolerance of this control
(`radius_error_tolerance`, on Fanuc No. 3410, on Mitsubishi #1084 RadErr). Look for swapped
digits and lost signs in the end point of this block *and of the block before*, then in the
centre words. Other common causes: centre words that another control reads as absolute, and
an R0 or I0 that was typed as another number."#,
};

pub(super) const RADIUS_TOO_SHORT: CodeInfo = CodeInfo {
    code: Code::RadiusTooShort,
    id: "CH402",
    name: "radius-too-short",
    severity: Severity::Error,
    summary: "the radius does not reach from start to end",
    explanation: r#"The distance from start to end is more than twice the radius, so no circle of that radius passes
through both. Chordal shows the shortest radius that is possible."#,
};

pub(super) const FULL_CIRCLE_BY_RADIUS: CodeInfo = CodeInfo {
    code: Code::FullCircleByRadius,
    id: "CH403",
    name: "full-circle-by-radius",
    severity: Severity::Error,
    summary: "a full circle cannot be given by its radius",
    explanation: r#"Any number of circles with one radius pass through one point. Give the centre (I, J or K), and leave the
end point out."#,
};

pub(super) const CENTER_OUTSIDE_PLANE: CodeInfo = CodeInfo {
    code: Code::CenterOutsidePlane,
    id: "CH404",
    name: "center-outside-plane",
    severity: Severity::Error,
    summary: "a centre word does not belong to the plane",
    explanation: r#"In G17 the centre is given by I and J, in G18 by I and K, in G19 by J and K. The third letter has
no meaning in that plane: either the plane or the letter is wrong."#,
};

pub(super) const NO_CENTER: CodeInfo = CodeInfo {
    code: Code::NoCenter,
    id: "CH405",
    name: "no-center",
    severity: Severity::Error,
    summary: "an arc has neither centre nor radius",
    explanation: r#"G2 and G3 need the centre (I, J, K) or the radius (R). On a Fadal a block without them is a straight
line, and Chordal warns only where G2 or G3 is in the same block."#,
};

pub(super) const MISSING_FEED: CodeInfo = CodeInfo {
    code: Code::MissingFeed,
    id: "CH406",
    name: "missing-feed",
    severity: Severity::Error,
    summary: "a cutting move before the first feed",
    explanation: r#"G1, G2 and G3 need a feed. Before the first F the control alarms, or, worse, uses the feed of the
program that ran before. In inverse time (G93) every block needs its own F."#,
};

pub(super) const FEED_OVER_LIMIT: CodeInfo = CodeInfo {
    code: Code::FeedOverLimit,
    id: "CH407",
    name: "feed-over-limit",
    severity: Severity::Error,
    summary: "the feed is above what the machine allows",
    explanation: r#"The machine file gives the largest feed. Controls alarm, or cut at their maximum without a message: the
program takes longer than its feeds say."#,
};

pub(super) const RADIUS_OVER_LIMIT: CodeInfo = CodeInfo {
    code: Code::RadiusOverLimit,
    id: "CH408",
    name: "radius-over-limit",
    severity: Severity::Error,
    summary: "the radius is larger than the control can interpolate",
    explanation: r#"Controls have a largest radius: a Fadal 399.9999 in, with cutter compensation 99.9999 in. Program a
larger arc as lines."#,
};

pub(super) const CENTER_AND_RADIUS: CodeInfo = CodeInfo {
    code: Code::CenterAndRadius,
    id: "CH409",
    name: "center-and-radius",
    severity: Severity::Error,
    summary: "an arc has both a centre and a radius",
    explanation: r#"Centre and radius say the same thing twice. When a block has both, Fanuc-style controls use R and ignore
the centre; LinuxCNC refuses the block."#,
};

pub(super) const SPIRAL_TURNS: CodeInfo = CodeInfo {
    code: Code::SpiralTurns,
    id: "CH410",
    name: "spiral-turns",
    severity: Severity::Error,
    summary: "the turns of a spiral do not fit its ends",
    explanation: r#"Start, end and centre fix the angle of a spiral up to whole turns. A radius change per turn (Q) or a
height per turn (K) gives a number of turns that must agree with that angle; a count (L, P) may
contradict Q. The message gives the turns that follow from each."#,
};

pub(super) const NO_SPIRALS: CodeInfo = CodeInfo {
    code: Code::NoSpirals,
    id: "CH411",
    name: "no-spirals",
    severity: Severity::Error,
    summary: "this control has no spiral command",
    explanation: r#"The block asks for a spiral or a cone, which this control cannot interpolate. A conversion would write
arcs or chords."#,
};

pub(super) const ZERO_RADIUS: CodeInfo = CodeInfo {
    code: Code::ZeroRadius,
    id: "CH412",
    name: "zero-radius",
    severity: Severity::Error,
    summary: "the centre of an arc is its start point",
    explanation: r#"All centre words are zero, or the centre, given in absolute coordinates, is the position of the tool.
There is no circle to follow."#,
};

pub(super) const SPINDLE_STOPPED: CodeInfo = CodeInfo {
    code: Code::SpindleStopped,
    id: "CH413",
    name: "spindle-stopped",
    severity: Severity::Warning,
    summary: "a cutting move with the spindle stopped",
    explanation: r#"The program cuts, and no M3 or M4 came before, or the spindle was stopped after it. Reported once for
each tool."#,
};

pub(super) const NEARLY_TANGENT: CodeInfo = CodeInfo {
    code: Code::NearlyTangent,
    id: "CH414",
    name: "nearly-tangent",
    severity: Severity::Note,
    summary: "an arc joins its neighbour almost, but not quite, tangentially",
    explanation: r#"The direction turns by a small angle where an arc begins or ends. Rounded coordinates cause hundredths
of a degree; tenths of a degree are usually a mistake in a number. The corner leaves a visible mark."#,
};

pub(super) const ROTARY_OVER_LIMIT: CodeInfo = CodeInfo {
    code: Code::RotaryOverLimit,
    id: "CH415",
    name: "rotary-over-limit",
    severity: Severity::Error,
    summary: "a rotary axis turns further in one block than the control allows",
    explanation: r#"Controls limit how far a rotary axis may turn in one block; a Fadal allows 1080 degrees. Divide the
move."#,
};

pub(super) const ROTARY_IN_ARC: CodeInfo = CodeInfo {
    code: Code::RotaryInArc,
    id: "CH416",
    name: "rotary-in-arc",
    severity: Severity::Warning,
    summary: "a rotary axis in the block of an arc, on a control that does not turn it with the arc",
    explanation: r#"Circular interpolation moves the two axes of the plane, and on most controls a third linear axis for a
helix. Some controls do not turn a rotary axis in the same block; others do. The setting
`rotary_in_arc` says what the control does. Chordal shows the arc with the rotary axis turning with it.

    G1 A90. F500.
    G3 I-1. F10.             the axis turned before the arc"#,
};

pub(super) const RAPID_AFTER_ARC: CodeInfo = CodeInfo {
    code: Code::RapidAfterArc,
    id: "CH417",
    name: "rapid-after-arc",
    severity: Severity::Warning,
    summary: "a block without a motion code, after an arc, moves at rapid speed",
    explanation: r#"On a Fadal G2 and G3 give a direction, and G0 or G1 stays active. After G0 an arc runs at the feed, and
the next block without a centre runs at rapid speed again.

    G0 X2. Y0
    I-.5 G3 F10.
    X-1.                     a rapid, not a cut

Write G1 where a cut is meant, G0 where a rapid is meant."#,
};

pub(super) const CLEARANCE_IN_INCREMENTAL: CodeInfo = CodeInfo {
    code: Code::ClearanceInIncremental,
    id: "CH418",
    name: "clearance-in-incremental",
    severity: Severity::Note,
    summary: "a rapid in G91 repeats the number of a clearance height in G90",
    explanation: r#"The program goes to a height such as Z0.1 in G90, and later to the same number in G91. There it is a
distance: the tool moves up by 0.1 and ends at another height. G90 was probably forgotten; then the
depths before it were measured from another height, too.

    G43 H01 Z0.1              G90: to 0.1
    G91 G01 Z-0.5156          to -0.4156
    G03 I-0.5 Z0.125 L5       up to 0.2094
    G00 Z0.1                  up by 0.1 to 0.3094: G91 is still active"#,
};
