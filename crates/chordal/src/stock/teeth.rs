//! The teeth of thread tools by ISO 68-1.

use chordal_stock::{CutterError, Undercut};

/// A thread's depth as a share of its pitch: 5/8 of the height of the sharp triangle, which is √3/2 of the
/// pitch (ISO 68-1).
const THREAD_DEPTH: f64 = 0.541_265_877_365_274_2;
/// The flat at the crest of a thread's tooth as a share of its pitch (ISO 68-1: P/8).
const CREST: f64 = 0.125;
/// The angle between a flank and the plane normal to the axis, rad: the flanks enclose 60°.
pub(super) const FLANK: f64 = std::f64::consts::FRAC_PI_6;

/// The diameter of a thread tool at the root of its teeth, mm.
pub(super) fn core(diameter: f64, pitch: f64) -> f64 {
    diameter - 2.0 * THREAD_DEPTH * pitch
}

/// Teeth one above the other on a core.
pub(super) struct ThreadMillTeeth {
    /// The core, then each tooth, with the height of its lower end above the tip, mm.
    pub undercuts: Vec<(f64, Undercut)>,
    /// One of the teeth.
    pub tooth: Undercut,
    /// The height to which the teeth reach, mm.
    pub top: f64,
}

impl ThreadMillTeeth {
    pub fn new(diameter: f64, pitch: f64, teeth: u32) -> Result<ThreadMillTeeth, CutterError> {
        let core = core(diameter, pitch);
        let tooth = Undercut::thread_disc(diameter, pitch * CREST, FLANK, core)?;
        let top = (pitch * f64::from(teeth)).max(tooth.height());
        let mut undercuts = vec![(0.0, Undercut::t_slot(core, top, core)?)];
        undercuts.extend((0..teeth).map(|n| (pitch * f64::from(n), tooth.clone())));
        Ok(ThreadMillTeeth { undercuts, tooth, top })
    }
}
