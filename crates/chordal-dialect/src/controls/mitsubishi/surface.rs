//! Polar and cylindrical interpolation on a Mitsubishi M700 (G12.1, G7.1); #1516 and #1517 choose the axes.

use crate::vocabulary::*;

pub(in crate::controls) const FACE: SurfaceRules = SurfaceRules {
    word: SurfaceWord::RotaryLength,
    rapid: false,
    planes: false,
    centers: true,
    alone: None,
    axes: None,
    code: Some("P481"),
    length: Some("P481"),
    mode: Some("P485"),
    nested: Some("P486"),
    own_feed: true,
    certainty: Certainty::Documented,
    source: "M700 programming manual p. 73 to 77",
};

pub(in crate::controls) const CYLINDER: SurfaceRules = SurfaceRules {
    word: SurfaceWord::RotaryAngle,
    rapid: false,
    planes: true,
    centers: false,
    alone: Some("P33"),
    axes: None,
    code: Some("P481"),
    length: Some("P481"),
    mode: Some("P485"),
    nested: Some("P486"),
    own_feed: true,
    certainty: Certainty::Documented,
    source: "M700 programming manual p. 65 to 68",
};
