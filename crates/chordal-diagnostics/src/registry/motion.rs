//! Motion.

use super::codes;

codes! {
    RadiusMismatch = 401, "radius-mismatch", Error;
    "start and end of an arc lie at different distances from its centre";
    r#"An arc that is given by its centre gives the same circle twice: the start point is on it, and the end point
must be, too. When the two distances differ by more than the control's tolerance, one of the numbers is wrong.

    G18
    G1 X-3.4585 Z-1.168
    G2 X-2.9928 Z-.952 I-.48 K.8314      radii 0.9600 and 1.1283

The message gives the two radii, the difference, and the tolerance of this control
(`radius_error_tolerance`, on Fanuc No. 3410, on Mitsubishi #1084 RadErr). Look for swapped
digits and lost signs in the end point of this block *and of the block before*, then in the
centre words. Other common causes: centre words that another control reads as absolute, and
an R0 or I0 that was typed as another number.

Where one changed word makes a true arc, Chordal names it, the simplest change first: a sign, the
letter, two digits that have changed places, the decimal point, another digit, a number in place
of zero. Here `Z-1.618` in the block before makes both radii 0.9600. Editors offer it as a fix.
Several words may do, and that one does is no proof that it was meant: hold it against the drawing."#;

    RadiusTooShort = 402, "radius-too-short", Error;
    "the radius does not reach from start to end";
    r#"The distance from start to end is more than twice the radius, so no circle of that radius passes
through both. Chordal shows the shortest radius that is possible."#;

    FullCircleByRadius = 403, "full-circle-by-radius", Error;
    "a full circle cannot be given by its radius";
    r#"Any number of circles with one radius pass through one point. Give the centre (I, J or K), and do not give
an end point."#;

    CenterOutsidePlane = 404, "center-outside-plane", Error;
    "a centre word does not belong to the plane";
    r#"In G17 the centre is given by I and J, in G18 by I and K, in G19 by J and K. The third letter has
no meaning in that plane: either the plane or the letter is wrong."#;

    NoCenter = 405, "no-center", Error;
    "an arc has neither centre nor radius";
    r#"G2 and G3 need the centre (I, J, K) or the radius (R). On a Fadal a block without them is a straight
line, and Chordal warns only where G2 or G3 is in the same block."#;

    MissingFeed = 406, "missing-feed", Error;
    "a cutting move before the first feed";
    r#"G1, G2 and G3 need a feed. Before the first F the control alarms, or, worse, uses the feed of the
program that ran before. In inverse time (G93) every block needs its own F."#;

    FeedOverLimit = 407, "feed-over-limit", Error;
    "the feed is above what the machine allows";
    r#"The machine file gives the largest feed. Controls alarm, or cut at their maximum without a message: the
program takes longer than its feeds say."#;

    RadiusOverLimit = 408, "radius-over-limit", Error;
    "the radius is larger than the control can interpolate";
    r#"Controls have a largest radius: a Fadal 399.9999 in, with cutter compensation 99.9999 in. Program a
larger arc as lines."#;

    CenterAndRadius = 409, "center-and-radius", Error;
    "an arc has both a centre and a radius";
    r#"Centre and radius say the same thing twice. When a block has both, Fanuc-style controls use R and ignore
the centre; LinuxCNC refuses the block."#;

    SpiralTurns = 410, "spiral-turns", Error;
    "the turns of a spiral do not fit its ends";
    r#"Start, end and centre fix the angle of a spiral up to whole turns. A radius change per turn (Q) or a
height per turn (K) gives a number of turns that must agree with that angle; a count (L, P) may
contradict Q. The message gives the turns that follow from each."#;

    NoSpirals = 411, "no-spirals", Error;
    "this control has no spiral command";
    r#"The block asks for a spiral or a cone, which this control cannot interpolate. A conversion would write
arcs or chords."#;

    ZeroRadius = 412, "zero-radius", Error;
    "the centre of an arc is its start point";
    r#"All centre words are zero, or the centre, given in absolute coordinates, is the position of the tool.
There is no circle to follow."#;

    SpindleStopped = 413, "spindle-stopped", Warning;
    "a cutting move with the spindle stopped";
    r#"The program cuts, and no M3 or M4 came before, or the spindle was stopped after it. Reported once for
each tool."#;

    NearlyTangent = 414, "nearly-tangent", Note;
    "an arc joins its neighbour almost, but not quite, tangentially";
    r#"The direction turns by a small angle where an arc begins or ends. Rounded coordinates cause hundredths
of a degree; tenths of a degree are usually a mistake in a number. The corner leaves a visible mark."#;

    RotaryOverLimit = 415, "rotary-over-limit", Error;
    "a rotary axis turns further in one block than the control allows";
    r#"Controls limit how far a rotary axis may turn in one block; a Fadal allows 1080 degrees. Divide the
move."#;

    RotaryInArc = 416, "rotary-in-arc", Warning;
    "a rotary axis in the block of an arc, on a control that does not turn it with the arc";
    r#"Circular interpolation moves the two axes of the plane, and on most controls a third linear axis for a
helix. Some controls do not turn a rotary axis in the same block; others do. The setting
`rotary_in_arc` says what the control does. Chordal shows the arc with the rotary axis turning with it.

    G1 A90. F500.
    G3 I-1. F10.             the axis turned before the arc"#;

    RapidAfterArc = 417, "rapid-after-arc", Warning;
    "a block without a motion code, after an arc, moves at rapid speed";
    r#"On a Fadal G2 and G3 give a direction, and G0 or G1 stays active. After G0 an arc runs at the feed, and
the next block without a centre runs at rapid speed again.

    G0 X2. Y0
    I-.5 G3 F10.
    X-1.                     a rapid, not a cut

Write G1 where a cut is meant, G0 where a rapid is meant."#;

    ClearanceInIncremental = 418, "clearance-in-incremental", Note;
    "a rapid in G91 repeats the number of a clearance height in G90";
    r#"The program goes to a height such as Z0.1 in G90, and later to the same number in G91. There it is a
distance: the tool moves up by 0.1 and ends at another height. G90 was probably forgotten; then the
depths before it were measured from another height, too.

    G43 H01 Z0.1              G90: to 0.1
    G91 G01 Z-0.5156          to -0.4156
    G03 I-0.5 Z0.125 L5       up to 0.2094
    G00 Z0.1                  up by 0.1 to 0.3094: G91 is still active"#;

    SplineWords = 419, "spline-words", Error;
    "a spline lacks a word that fixes its shape";
    r#"A cubic spline (G5) needs P and Q, the way from its end to its second control point, and takes I and J,
the way from its start to the first, both or neither: without them it goes on in the direction in
which the last G5 ended. A quadratic spline (G5.1) needs I and J.

    G5 X10 Y0 I0 J5 P0 Q5
    G5 X20 Y0 P0 Q-5           I and J from the block before: I0 J-5"#;

    SplinePoint = 420, "spline-point", Error;
    "a control point lacks X or Y";
    r#"Each line of a NURBS block (G5.2 to G5.3) gives one control point by X and Y together. Only the first line
may give P alone: the weight of the point where the tool stands."#;

    SplineWeight = 421, "spline-weight", Error;
    "a control point has no weight above zero";
    r#"Each control point of a NURBS block needs its weight P, and a weight is above zero. A larger weight pulls the
curve nearer to its point; with equal weights it is a plain B-spline."#;

    SplineOpen = 422, "spline-open", Error;
    "a NURBS block lacks its beginning or its end";
    r#"A NURBS is written from G5.2 to G5.3; the tool moves at G5.3. Without G5.3, another motion code or the end
of the program throws the control points away. G5.3 without G5.2 has no points.

    G5.2 X1 Y2 P1 L4
    X3 Y3 P2
    X5 Y0 P1
    G5.3"#;

    SplineTooFew = 423, "spline-too-few", Error;
    "a NURBS has fewer control points than its order";
    r#"A curve of order L (degree L − 1) needs L control points or more. The position of the tool at G5.2 is the
first of them. Without L the order is 3."#;

    SplinePlane = 424, "spline-plane", Error;
    "a spline with another plane or another axis";
    r#"Splines move X and Y in the plane G17. The control refuses them in G18 and G19, and with a word of
another axis. Write such a curve as lines or arcs."#;

    SplineInCompensation = 425, "spline-in-compensation", Error;
    "a spline with cutter compensation on";
    r#"The control does not offset splines. Cancel compensation with G40 first, or program the path of the tool
centre."#;

    SplineOrder = 426, "spline-order", Error;
    "the order of a spline is higher than Chordal carries out";
    r#"Chordal carries out splines up to order 6 (degree 5) exactly. The message gives the order that the program
asks for. The path shows a straight line in its place."#;

    CornerBlock = 427, "corner-block", Error;
    "`,R` or `,C` in a block that cannot end in a corner";
    r#"`,R` rounds the corner between the end of its block and the next move, `,C` puts a chamfer there. Its block
must cut a line (on some controls also an arc) in the active plane. It cannot be a rapid, a cycle, a
thread, or a block that moves nothing; and a block takes one of the two. The path shows the corner as
it is without the word.

    G1 X20. ,R2. F300.
    Y15."#;

    CornerNext = 428, "corner-next", Error;
    "no move follows a block with `,R` or `,C`";
    r#"The control needs the next move to find the rounding or the chamfer, so the next block must move in the
same plane and in the same coordinates. Some controls allow one dwell (G4) between. The path shows
the corner as it is without the word.

    G1 X20. ,R2. F300.
    M8                         write it into a block before
    Y15."#;

    CornerNextMotion = 429, "corner-next-motion", Error;
    "the move after `,R` or `,C` is of the wrong kind";
    r#"A rounding or a chamfer stands between two cuts: lines, and on some controls arcs. A rapid, a thread, a
spiral or a cycle cannot follow. Remove the word, or cut to a point after the corner first."#;

    CornerTooLarge = 437, "corner-too-large", Error;
    "a rounding or a chamfer does not fit between its two moves";
    r#"The arc of `,R` must touch both moves within their lengths, and `,C` takes its length from both. What an
earlier corner took from the same move is no longer there. The message says how much fits. The path
shows the corner as it is without the word."#;

    InverseTimeArc = 445, "inverse-time-arc", Warning;
    "an arc in inverse time (G93) that the control runs at another speed";
    r#"GRBL, grblHAL and FluidNC cut an arc into straight segments. In inverse time they multiply F by the number of
the segments, and then take the product for mm/min: `G93 G2 X20 I10 F30` of 78 segments runs at 2340 mm/min, and does
not take the thirtieth part of a minute. Lines in G93 are right. Chordal gives the time that the control takes. Write arcs
in G94."#;

    VanishingCircle = 446, "vanishing-circle", Note;
    "an arc that ends one increment from its start, and may be meant as a full circle";
    r#"An end at the start makes a full circle. One that misses it by an increment makes an arc of almost nothing, or of
almost a whole turn, by its direction:

    X1. Y0
    G3 X1. Y0.0001 I-1.     0.006 degrees
    G3 X1. Y0. I-1.         360 degrees

Chordal shows the arc as it is written. Write the start as the end where a circle is meant."#;

    SpiralInFrame = 447, "spiral-in-frame", Error;
    "a spiral while coordinates are mirrored or scaled";
    r#"A Mitsubishi does not cut spirals and cones under G51.1 (mirror image) or G51 (scaling), and stops with P34 (M700V
manual 6.13). Cancel the mirror and the scaling before it, or write the mirrored spiral out."#;
}
