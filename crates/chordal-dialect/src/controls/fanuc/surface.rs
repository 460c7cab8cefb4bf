//! Polar and cylindrical interpolation on a Fanuc (G12.1, G7.1), mills and lathes alike.

use crate::vocabulary::*;

/// Straight cuts and arcs, compensation, dwells and macro calls; the axes are those of Nos. 5460 and 5461.
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

/// No rapids; arcs by R in the plane that G18 or G19 chooses with the rotary axis in place of X or Y (No. 1022).
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
