//! Frames of coordinates: mirror, scaling, rotation, polar coordinates.

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

    FrameBesideReference = 433, "frame-beside-reference", Warning;
    "a reference return or a work offset while coordinates are mirrored, scaled or rotated";
    r#"Manuals ask to cancel G68, G51 and G51.1 before G27 to G30, G52 to G59 and G92. Controls carry the block out, but
what becomes of the centre of a rotation or a scaling differs from one to the next.

Chordal carries the block out: the point of G28 goes through the frames, G53 does not."#;

    FrameInCompensation = 434, "frame-in-compensation", Error;
    "mirror, scaling or rotation starts while cutter compensation is on";
    r#"The contour jumps into other coordinates while the control is looking ahead along it, so the tool leaves the
contour or cuts into it. Write the frame first, then G41 or G42; end in reverse order: G40, then G69, G50 or G50.1."#;
}
