//! Insets of cutters: where the inset by a depth touches a part, the cutter is at least that deep in it.

use chordal_stock::{CutterError, CutterProfile, RevolvedBody, Undercut};

use super::teeth::{FLANK, ThreadMillTeeth, core};

/// The dimensions of a cutter whose inset is known, mm and rad.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum CutterDimensions {
    Flat {
        diameter: f64,
    },
    Ball {
        diameter: f64,
    },
    Bull {
        diameter: f64,
        corner: f64,
    },
    Pointed {
        diameter: f64,
        tip: f64,
        angle: f64,
    },
    /// An undercut: a disc of a thickness.
    Disc {
        diameter: f64,
        thickness: f64,
    },
    /// An undercut: a whole ball.
    Lollipop {
        diameter: f64,
    },
    /// The points of its outline: height and radius.
    Outline(Vec<[f64; 2]>),
    /// Undercuts: teeth one above the other on a core.
    Threads {
        diameter: f64,
        pitch: f64,
        teeth: u32,
    },
    /// A core with a thread, of which only the diameter counts.
    Tap {
        diameter: f64,
        pitch: f64,
    },
}

/// The inset of a cutter.
pub(super) struct InnerCutter {
    /// A body that contains the inset.
    pub holds: RevolvedBody,
    pub sure: InnerCertainty,
    /// How much higher than the tip of the cutter the tips of both are, mm.
    pub lift: f64,
}

/// What is certainly in the inset.
pub(super) enum InnerCertainty {
    /// All of [`InnerCutter::holds`].
    Same,
    Body(RevolvedBody),
    Nothing,
}

impl CutterDimensions {
    /// The profile of its lower side.
    pub fn cutter(&self) -> Result<CutterProfile, CutterError> {
        match *self {
            CutterDimensions::Disc { diameter, .. }
            | CutterDimensions::Threads { diameter, .. } => CutterProfile::flat(diameter),
            CutterDimensions::Lollipop { diameter } => CutterProfile::ball(diameter),
            CutterDimensions::Flat { diameter } | CutterDimensions::Tap { diameter, .. } => {
                CutterProfile::flat(diameter)
            }
            CutterDimensions::Ball { diameter } => CutterProfile::ball(diameter),
            CutterDimensions::Bull { diameter, corner } => CutterProfile::bull(diameter, corner),
            CutterDimensions::Pointed { diameter, tip, angle } => {
                CutterProfile::pointed(diameter, tip, angle)
            }
            CutterDimensions::Outline(ref points) => CutterProfile::outline(points),
        }
    }

    /// What it certainly removes, where that is less than what it may remove: the ridges of the thread stay in the
    /// hole of a tap. `None` for all other cutters.
    pub fn core(&self) -> Option<CutterProfile> {
        match *self {
            CutterDimensions::Tap { diameter, pitch } => {
                CutterProfile::flat(core(diameter, pitch)).ok()
            }
            CutterDimensions::Flat { .. }
            | CutterDimensions::Ball { .. }
            | CutterDimensions::Bull { .. }
            | CutterDimensions::Pointed { .. }
            | CutterDimensions::Disc { .. }
            | CutterDimensions::Lollipop { .. }
            | CutterDimensions::Outline(_)
            | CutterDimensions::Threads { .. } => None,
        }
    }

    /// The inset of the cutter by `depth` as a cutter itself, and by how much its tip is higher, mm; `None` where nothing
    /// is left of it, or it is no cutter of one profile.
    pub fn inset_profile(&self, depth: f64) -> Option<(CutterProfile, f64)> {
        let less = |diameter: f64| diameter - 2.0 * depth;
        match *self {
            CutterDimensions::Bull { diameter, corner } if corner > depth => {
                Some((CutterProfile::bull(less(diameter), corner - depth).ok()?, depth))
            }
            CutterDimensions::Flat { diameter } | CutterDimensions::Bull { diameter, .. } => {
                Some((CutterProfile::flat(less(diameter)).ok()?, depth))
            }
            CutterDimensions::Ball { diameter } => {
                Some((CutterProfile::ball(less(diameter)).ok()?, depth))
            }
            CutterDimensions::Pointed { diameter, tip, angle } => {
                // The side of the cone moves inward by depth/cos, measured across the axis.
                let (sine, cosine) = libm::sincos(angle / 2.0);
                let rise = sine / cosine;
                let at_lift = |lift: f64| tip / 2.0 + lift * rise - depth / cosine;
                let lift =
                    if at_lift(depth) < 0.0 { (depth / cosine - tip / 2.0) / rise } else { depth };
                let tip = 2.0 * at_lift(lift).max(0.0);
                Some((CutterProfile::pointed(less(diameter), tip, angle).ok()?, lift))
            }
            CutterDimensions::Disc { .. }
            | CutterDimensions::Lollipop { .. }
            | CutterDimensions::Outline(_)
            | CutterDimensions::Threads { .. }
            | CutterDimensions::Tap { .. } => None,
        }
    }

    /// The inset of the cutter by `depth`, mm; `None` where nothing is left of it.
    pub fn inside(&self, depth: f64) -> Option<InnerCutter> {
        let less = |diameter: f64| diameter - 2.0 * depth;
        // The neck above it is a part of the shank.
        let of_undercut = |undercut: Result<Undercut, CutterError>| {
            let holds = RevolvedBody::of_undercuts(&[(0.0, undercut.ok()?)]);
            Some(InnerCutter { holds, sure: InnerCertainty::Same, lift: depth })
        };
        match *self {
            CutterDimensions::Bull { .. }
            | CutterDimensions::Flat { .. }
            | CutterDimensions::Ball { .. }
            | CutterDimensions::Pointed { .. } => {
                let (cutter, lift) = self.inset_profile(depth)?;
                let holds = RevolvedBody::of_cutter(&cutter);
                Some(InnerCutter { holds, sure: InnerCertainty::Same, lift })
            }
            CutterDimensions::Disc { diameter, thickness } => {
                of_undercut(disc(less(diameter), thickness - 2.0 * depth))
            }
            CutterDimensions::Lollipop { diameter } => {
                of_undercut(Undercut::lollipop(less(diameter), 0.5 * less(diameter)))
            }
            CutterDimensions::Outline(ref points) => {
                let [holds, within] = CutterProfile::outline_inside(points, depth).ok()??;
                let sure = InnerCertainty::Body(RevolvedBody::of_cutter(&within));
                Some(InnerCutter { holds: RevolvedBody::of_cutter(&holds), sure, lift: 0.0 })
            }
            CutterDimensions::Threads { diameter, pitch, teeth } => {
                inside_threads(diameter, pitch, teeth, depth)
            }
            CutterDimensions::Tap { diameter, pitch } => {
                let holds = RevolvedBody::of_cutter(&CutterProfile::flat(less(diameter)).ok()?);
                let sure = match CutterProfile::flat(less(core(diameter, pitch))) {
                    Ok(cutter) => InnerCertainty::Body(RevolvedBody::of_cutter(&cutter)),
                    Err(_) => InnerCertainty::Nothing,
                };
                Some(InnerCutter { holds, sure, lift: depth })
            }
        }
    }
}

fn disc(diameter: f64, thickness: f64) -> Result<Undercut, CutterError> {
    Undercut::t_slot(diameter, thickness, 0.5 * diameter)
}

/// The inset of a thread mill. Outside the core only the flanks and the crest of a tooth bound it, so the inset is
/// exact there. Inside the core, points near a tooth are deeper in the tool than in the core alone: `holds` contains
/// all of the core, `sure` only the core's own inset.
fn inside_threads(diameter: f64, pitch: f64, teeth: u32, depth: f64) -> Option<InnerCutter> {
    let core = core(diameter, pitch);
    let ThreadMillTeeth { tooth, top, .. } = ThreadMillTeeth::new(diameter, pitch, teeth).ok()?;
    let (rise, cosine) = (libm::tan(FLANK), libm::cos(FLANK));
    // Half the width of a tooth at a radius, and that of its inset.
    let half = 0.5 * tooth.height();
    let width = |radius: f64| half - (radius - 0.5 * core).max(0.0) * rise;
    /// Where the flanks of the inset meet below its crest, it ends in a crest of this half width, mm.
    const SHARP: f64 = 1e-6;
    let rim = 0.5 * diameter - depth;
    let crest = width(rim) - depth / cosine;
    // The inset reaches to the radius where its flanks are no closer than that.
    let (rim, crest) = match crest > SHARP {
        true => (rim, crest),
        false => (rim - (SHARP - crest) / rise, SHARP),
    };
    let height = top - 2.0 * depth;
    // The radius below which the inset of the tooth would be higher than the tooth is at the core.
    let root = 0.5 * core - depth * (1.0 / cosine - 1.0) / rise;
    let mut holds = vec![(depth, disc(core, height).ok()?)];
    let mut sure = Vec::new();
    if let Ok(own) = disc(core - 2.0 * depth, height) {
        sure.push((depth, own));
    }
    if rim > root.max(0.0) && root > 0.0 {
        let own = Undercut::thread_disc(2.0 * rim, 2.0 * crest, FLANK, 2.0 * root).ok()?;
        let lift = half - 0.5 * own.height();
        let all = (0..teeth).map(|n| (pitch * f64::from(n) + lift, own.clone()));
        holds.extend(all.clone());
        sure.extend(all);
    }
    let sure = match sure[..] {
        [] => InnerCertainty::Nothing,
        _ => InnerCertainty::Body(RevolvedBody::of_undercuts(&sure)),
    };
    Some(InnerCutter { holds: RevolvedBody::of_undercuts(&holds), sure, lift: 0.0 })
}
