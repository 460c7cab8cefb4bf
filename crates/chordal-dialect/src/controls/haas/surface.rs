//! Cylindrical mapping on a Haas (G107), and polar interpolation on its lathes (G112). Their alarm numbers are not known.

use crate::vocabulary::*;

/// G107 names the linear axis that the rotary one replaces; its lengths are lengths around the cylinder.
pub(in crate::controls) const CYLINDER: SurfaceRules = SurfaceRules {
    word: SurfaceWord::Linear,
    rapid: true,
    planes: true,
    centers: true,
    alone: None,
    axes: None,
    code: None,
    length: None,
    mode: None,
    nested: None,
    own_feed: false,
    certainty: Certainty::Documented,
    source: "Haas mill operator's manual, G107",
};

/// X and Y on the face in G17, compensation as on a mill.
pub(in crate::controls) const FACE: SurfaceRules = SurfaceRules {
    certainty: Certainty::Practice,
    source: "Haas lathe, G112",
    ..CYLINDER
};
