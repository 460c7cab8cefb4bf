//! Cycles of lathes.

/// A cycle of a lathe.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum TurnCycle {
    /// The contour once (G70).
    Finish,
    /// Passes along Z, down to the contour (G71).
    Rough,
    /// Passes along X (G72).
    RoughFace,
    /// The contour itself, again and again, ever nearer (G73).
    Pattern,
    /// Pecks along Z, one plunge after the other along X (G74).
    PeckZ,
    /// Pecks along X, one plunge after the other along Z (G75).
    PeckX,
    /// A thread in many passes (G76).
    Thread,
    /// The contour of a subroutine, in passes at decreasing distances (LinuxCNC G70).
    FinishSubroutine,
    /// Passes along Z, down to the contour of a subroutine (LinuxCNC G71).
    RoughSubroutine(PocketHandling),
    /// Passes along X (LinuxCNC G72).
    RoughFaceSubroutine(PocketHandling),
    /// A thread measured from the line that the tool drives along (LinuxCNC G76).
    LineThread,
}

/// What sort of cycle of a lathe it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum TurnFamily {
    /// A contour between two block numbers, once.
    Finish,
    /// The same in passes, down to it.
    Rough,
    /// The same, again and again, ever nearer.
    Pattern,
    /// Plunges in pecks.
    Peck,
    /// A thread in many passes.
    Thread,
    /// A contour of a subroutine.
    Subroutine,
    /// A thread measured from the line that the tool drives along.
    LineThread,
}

impl TurnCycle {
    /// What sort of cycle it is.
    pub const fn family(self) -> TurnFamily {
        match self {
            TurnCycle::Finish => TurnFamily::Finish,
            TurnCycle::Rough | TurnCycle::RoughFace => TurnFamily::Rough,
            TurnCycle::Pattern => TurnFamily::Pattern,
            TurnCycle::PeckZ | TurnCycle::PeckX => TurnFamily::Peck,
            TurnCycle::Thread => TurnFamily::Thread,
            TurnCycle::FinishSubroutine
            | TurnCycle::RoughSubroutine(_)
            | TurnCycle::RoughFaceSubroutine(_) => TurnFamily::Subroutine,
            TurnCycle::LineThread => TurnFamily::LineThread,
        }
    }
}

/// What becomes of the pockets of a contour.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum PocketHandling {
    /// They are cut.
    Cut,
    /// They are left (LinuxCNC G71.1).
    Left,
    /// They alone are cut, where the cycle without them ended (LinuxCNC G71.2).
    Only,
}

/// Where the levels of roughing begin.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FirstLevel {
    /// At the start, moved away by the finishing allowance.
    Allowance,
    /// At the start itself.
    Start,
}

/// How the cycles of a lathe run. Depths are measured on the radius.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TurningRules {
    /// Depth of a roughing pass before a program gives one, mm (Fanuc No. 5132).
    pub rough_depth_mm: f64,
    /// How far a roughing pass backs off, mm (No. 5133).
    pub rough_retract_mm: f64,
    /// Where the levels of roughing begin.
    pub first_level: FirstLevel,
    /// How far a peck backs off, mm (No. 5139).
    pub peck_retract_mm: f64,
    /// Finishing passes of a thread (No. 5142).
    pub thread_finish_passes: u32,
    /// Length of the exit of a thread, in leads (No. 5130).
    pub thread_exit_leads: f64,
    /// Angle of the thread tool, degrees (No. 5143).
    pub thread_angle_deg: f64,
    /// Least depth of a pass, mm (No. 5140).
    pub thread_least_mm: f64,
    /// Depth of the finishing pass, mm (No. 5141).
    pub thread_finish_mm: f64,
    /// The letter of G71 and G72 that says whether pockets are cut (Yasnac R, Mitsubishi H); without one it is said by the axes
    /// of the contour's first block.
    pub pockets_by: Option<u8>,
    /// A names the program that holds the contour (Mitsubishi).
    pub contour_program: bool,
    /// What a contour of G71 and G72 has at its end outside the stock, back towards the start of the cycle, is no part of the
    /// shape (Haas).
    pub return_left_out: bool,
    /// A first block without P and Q gives depth and retract; else all is in one block (Haas).
    pub two_blocks: bool,
    /// P and Q of a thread in many passes may have a decimal point; otherwise they count least increments (Fanuc).
    pub thread_words_take_point: bool,
    /// How its programs limit the spindle where they keep a cutting speed.
    pub speed_limit_example: &'static str,
    /// In the subroutine of a contour U and W are increments of X and Z, A is a rounding and C a chamfer at the end of the
    /// move, whichever axes there are; nothing else but moves is read of it (LinuxCNC).
    pub contour_words: bool,
    /// Tip numbers count with X turned round: 2 is the tool for turning outside, not 3 (LinuxCNC).
    pub tips_mirrored: bool,
}

impl TurningRules {
    /// What most controls share.
    pub const COMMON: TurningRules = TurningRules {
        rough_depth_mm: 0.0,
        rough_retract_mm: 0.5,
        first_level: FirstLevel::Allowance,
        peck_retract_mm: 0.5,
        thread_finish_passes: 1,
        thread_exit_leads: 1.0,
        thread_angle_deg: 60.0,
        thread_least_mm: 0.0,
        thread_finish_mm: 0.0,
        pockets_by: None,
        contour_program: false,
        return_left_out: false,
        two_blocks: true,
        thread_words_take_point: true,
        speed_limit_example: "G50 S2500",
        contour_words: false,
        tips_mirrored: false,
    };
}
