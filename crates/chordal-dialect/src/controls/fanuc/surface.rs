//! Polar and cylindrical interpolation on a Fanuc (G12.1, G7.1), mills and lathes alike.

use crate::vocabulary::*;

/// Polar interpolation: allows G1, arcs, compensation, dwells and macro calls; Nos. 5460 and 5461 choose the axes.
pub(in crate::controls) const FACE: SurfaceRules = SurfaceRules {
    word: SurfaceWord::RotaryLength,
    rapid: false,
    planes: false,
    centers: true,
    alone: None,
    axes: Some("PS0145 ILLEGAL CONDITIONS IN POLAR COORDINATE INTERPOLATION"),
    code: Some("PS0146 IMPROPER G CODE"),
    length: Some("PS0146 IMPROPER G CODE"),
    mode: Some("PS0145 ILLEGAL CONDITIONS IN POLAR COORDINATE INTERPOLATION"),
    nested: Some("PS0146 IMPROPER G CODE"),
    own_feed: false,
    certainty: Certainty::Documented,
    source: "B-62764EN, polar coordinate interpolation; alarms from a list",
};

/// Cylindrical interpolation: no rapids. Arcs have R, in the plane that G18 or G19 chooses with the rotary axis in
/// place of X or Y (No. 1022).
pub(in crate::controls) const CYLINDER: SurfaceRules = SurfaceRules {
    word: SurfaceWord::RotaryAngle,
    rapid: false,
    planes: true,
    centers: false,
    alone: None,
    axes: Some("PS0175 ILLEGAL G07.1 AXIS"),
    code: Some("PS0176 IMPROPER G CODE(G07.1 G CODE)"),
    length: Some("PS0176 IMPROPER G CODE(G07.1 G CODE)"),
    mode: Some("PS0176 IMPROPER G CODE(G07.1 G CODE)"),
    nested: Some("PS0176 IMPROPER G CODE(G07.1 G CODE)"),
    own_feed: false,
    certainty: Certainty::Documented,
    source: "B-62754EN, cylindrical interpolation; alarms from a list",
};
