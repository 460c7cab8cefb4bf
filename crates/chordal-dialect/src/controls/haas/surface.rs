//! Cylindrical mapping on a Haas (G107), and the face of its lathes (G112). No alarm number was at hand.

use crate::vocabulary::*;

/// The named linear axis becomes the rotary one; lengths of it are lengths on the shell.
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

/// X and Y of the face under G17, compensation as on a mill.
pub(in crate::controls) const FACE: SurfaceRules = SurfaceRules {
    certainty: Certainty::Trade,
    source: "Haas lathe, G112",
    ..CYLINDER
};
