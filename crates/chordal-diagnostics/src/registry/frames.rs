//! Coordinate frames: mirroring, scaling, rotation, polar coordinates.

use super::codes;

codes! {
    FrameValue = 430, "frame-value", Error;
    "a scale factor or an angle that the control does not take";
    r#"Scaling takes a factor within limits: above zero, and below a largest value of the control. A factor without
a decimal point counts in units of 0.001 on many controls: P2000 is 2.

    G51 X0 Y0 P0        a factor of zero leaves nothing

The scaling of this block is not carried out."#;

    UnequalScaleArc = 431, "unequal-scale-arc", Error;
    "an arc in a plane whose axes have different scale factors";
    r#"With different factors a circle becomes an ellipse, and no milling control makes ellipses. Fanuc scales ends and
centre by their own factors and then judges the arc as always; Haas and Mitsubishi refuse it.

Scale both axes of the plane alike, or write the curve as short lines."#;

    FramePlane = 432, "frame-plane", Error;
    "an arc, compensation or a change of plane that does not fit the rotation";
    r#"G68 turns the coordinates in the plane that was active in its block. Arcs and cutter compensation must be in
that plane, and the plane may not change before G69.

    G17 G68 X0 Y0 R30.
    G18 G2 X10. Z0 I5. K0        ZX is not the plane that was turned"#;

    FrameWithReference = 433, "frame-beside-reference", Warning;
    "a reference return or a work offset while coordinates are mirrored, scaled or rotated";
    r#"Manuals ask to cancel G68, G51 and G51.1 before G27 to G30, G52 to G59 and G92. Controls carry the block out, but
what becomes of the centre of a rotation or a scaling differs from one to the next.

Chordal carries the block out: the point of G28 goes through the frames, G53 does not."#;

    FrameInCompensation = 434, "frame-in-compensation", Error;
    "mirror, scaling or rotation starts or ends while cutter compensation is on";
    r#"The contour jumps into other coordinates while the control is looking ahead along it, so the tool leaves the
contour or cuts into it. Write the frame first, then G41 or G42; end in reverse order: G40, then G69, G50 or G50.1."#;

    ScalingOption = 435, "scaling-option", Error;
    "scaling on a control without this option";
    r#"Scaling (G51) is an option of this control, and its setting says that the machine does not have it. The control
stops at this block.

Write the scaled coordinates into the program, or correct the setting if the machine has the option."#;

    RotationOption = 436, "rotation-option", Error;
    "rotation on a control without this option";
    r#"Rotation of coordinates (G68) is an option of this control, and its setting says that the machine does not have
it. The control stops at this block.

Write the rotated coordinates into the program, or correct the setting if the machine has the option."#;

    SpatialRotation = 438, "spatial-rotation", Error;
    "a rotation about an axis in space that the control refuses";
    r#"G68 with I, J and K rotates the coordinates about an axis in space. It needs I, J, K and R in its block, and I, J
and K may not all be 0. Cutter compensation must be off. A length offset either starts before it and ends after it, or starts and
ends inside it. Some codes may not be used while it is active.

    G68 X0 Y0 Z0 I1. J0 K0 R30.      about the X axis
    G43 H1
    G69                              the length offset started inside: G49 must be before G69

Chordal does not carry out the rotation itself (CH312)."#;

    OneAxisAfterFrame = 439, "one-axis-after-frame", Warning;
    "the first absolute block after a rotation or scaling names one axis only";
    r#"G68, G69, G51 and G50 move nothing, but they change the coordinates of the position where the tool stands. A block
that names one axis of the plane keeps the coordinate of the other axis. This coordinate is now another number than before, so
the tool goes to a place that the program does not show, and controls differ in what they do. Mitsubishi asks for both axes.

    G0 X10. Y0
    G68 X0 Y0 R90.      the tool stands at X0 Y-10 of the rotated coordinates
    X20.                goes to X20 Y-10, not to X20 Y0

Write both axes of the plane in the first block after each of these codes."#;

    ScaledOverflow = 440, "scaled-overflow", Error;
    "a scaled coordinate or radius is larger than the control can hold";
    r#"A control holds coordinates with a fixed number of digits. Scaling by a large factor gives numbers beyond them, and
the control stops.

Check the factor: a number without a decimal point counts in units of 0.001 on many controls, with a point in whole ones."#;

    FrameInCycle = 441, "frame-in-cycle", Warning;
    "a canned cycle along an axis that is mirrored or scaled";
    r#"Manuals ask not to mirror or scale the drilling axis in a canned cycle. Its levels are then mirrored or scaled, and
the peck depth and the clearances are not.

Chordal carries the cycle out with these levels. Cancel the mirror or the scaling of this axis before the cycle."#;

    SurfaceCode = 442, "surface-code", Error;
    "a code that may not come in polar or cylindrical interpolation";
    r#"Between G12.1 and G13.1 (Haas G112, G113) X and the letter of the rotary axis, or X and Y on a Haas, are coordinates on
the face of the part. After G7.1 with a radius (Haas G107) the rotary axis is a length on a cylinder. Straight cuts, arcs,
compensation, dwells and macro calls are allowed there. Most controls stop at rapids, reference returns, work offsets, tool
offsets, cycles and a change of the plane.

    G12.1
    G0 X60.             a rapid: PS0146 on a Fanuc

Rapids are shown on the surface all the same. Other blocks are skipped. Write such blocks before G12.1 or after G13.1."#;

    SurfaceMode = 443, "surface-mode", Error;
    "polar or cylindrical interpolation that cannot begin or end here";
    r#"G12.1 and G7.1 need the rotary axis, and begin without cutter compensation, without mirror, scaling or rotation of
coordinates, and outside of each other. Compensation begins and ends inside.

    G42
    G12.1               compensation is on: G40 first

On a cylinder an arc lies in the plane of the length along the axis and the rotary axis. On a lathe this is G18 or G19."#;

    RotarySpeed = 444, "rotary-speed", Warning;
    "the rotary axis cannot turn as fast as this feed needs";
    r#"In polar and cylindrical interpolation F is the speed on the surface. The rotary axis turns at F divided by the radius: at
1000 mm/min and 10 mm from the centre at 5730 degrees a minute. Near the centre of a face it would have to be infinitely fast.

Controls stop with an alarm, or slow down. Use a lower F, or keep the tool farther from the centre. The time of the program
counts the cut as slow as the axis needs."#;

    KinematicsNotKnown = 448, "kinematics-not-known", Note;
    "where the axes are under tool centre point control is not known";
    r#"With tool centre point control (G43.4, Haas G234, Sinumerik TRAORI) the program gives the tip of the tool on the part, and
the control moves X, Y and Z so that it stays there while the rotary axes turn. Where these axes are follows from the points
about which the rotary axes turn, and the machine file does not give all of them.

The tip is followed all the same. Travel and the limits of the axes are not checked, and the time is not verified. Give the
points, for example of a round table C on a tilting table A, in machine coordinates:

    [rotary.A]
    turns = "table"
    point = { Y = "-200 mm", Z = "-400 mm" }
    [rotary.C]
    turns = "table"
    point = { X = "-300 mm", Y = "-200 mm" }"#;

    TiltedPlane = 449, "tilted-plane", Error;
    "a tilted plane that cannot be defined, or to which the tool cannot turn";
    r#"G68.2 (Haas G268) makes a plane in space the plane of X and Y, by its origin and its angles; G53.1 (Haas G253) turns the
rotary axes so that the tool stands upright on it; G69 (Haas G269) ends it.

    G68.2 X50. Y0 Z0 I0 J30. K0
    G53.1
    G1 X10. Y5. Z2.
    G69

A plane is defined while none is in force, with cutter compensation off. G53.1 needs a plane, and a machine whose rotary
axes can bring the tool to that direction within their travel. With P2 and P3 several blocks define a plane together; they
follow each other, and the points do not lie on a line. G68.4 defines a plane in the one that is in force."#;

    ToolVector = 450, "tool-vector", Error;
    "a direction of the tool that cannot be carried out";
    r#"With tool centre point control by direction (G43.5) I, J and K are a vector from the tip of the tool to its holder, at the
end of the block. Letters that are left out are 0; without all three the direction stays.

    G43.5 H1 Z50.
    G1 X20. I0.5 J0 K0.866 F800.

A vector of length 0 is no direction. Words of rotary axes are not used while the vector gives them, and the axes must be
able to bring the tool to that direction within their travel."#;

    SwingingTool = 451, "swinging-tool", Warning;
    "the tool swings aside while it cuts from one direction to the next";
    r#"With tool centre point control by direction (G43.5) I, J and K say where the tool points at the end of a block. On the way
there the rotary axes turn evenly. The tool then stays near the plane of its two directions where each axis turns by little.
Where an axis would leave its travel, or where the tool passes near the pole of the first axis, the control takes another
position of the axes: the table may turn by half a turn within one block, and the tool swings aside in the cut.

    G1 X10. I0.34 J0 K0.94 F800.
    X12. I-0.34 J0 K0.94         A cannot tilt to the other side: C turns by 180 degrees while the tool cuts

Lift the tool off the part and turn by a rapid, or give more directions between, or clamp the part so that the axes have room."#;

    TipFeedTooFast = 452, "tip-feed-too-fast", Warning;
    "a rotary axis cannot turn as fast as the feed of the tip needs";
    r#"Under tool centre point control (G43.4, G43.5) F is the speed of the tip against the part, and every rotary axis of the block
turns in the same time. In a short block with a large angle, as next to the pole of a table, the axis would have to turn faster
than it can.

    F20000.
    X6.599 Y-31.809 C190.     10 degrees in 7 mm

Fanuc stops with alarm PS5422 where the speed is not clamped before. Use a lower F there, inverse time (G93), or shorter turns."#;

    LengthAlongTool = 453, "length-along-tool", Error;
    "five-axis length compensation that the control does not carry out so";
    r#"G143 of Haas adds the length of the tool along its direction, as the heads A and B stand. It is for machines whose both rotary
axes are heads, for G90, and for straight moves: G0 and G1. An axis that a block does not name stays where it is, even where the
heads have turned: blocks name all five.

    G90 G143 H2 X0. Y0. Z150. A0. B0.
    G1 X12.5 Y5.2 Z11.9 A1. B5.5 F500.
    G49"#;
}
