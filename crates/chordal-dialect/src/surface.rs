//! Polar and cylindrical interpolation: how a control gives the coordinates of a surface, what may not come while one is
//! active, and what the control shows then.

use crate::settings::Certainty;

/// How the words of a program give the length across on a surface.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SurfaceWord {
    /// By the letter of the rotary axis, as a length (G12.1).
    RotaryLength,
    /// By the letter of the rotary axis, as an angle (G7.1).
    RotaryAngle,
    /// By the letter of the linear axis that the rotary one takes the place of, as a length (Haas).
    Linear,
}

/// One kind of surface on a control. Alarms are what it shows; nothing where that is not known.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceRules {
    /// The length across.
    pub word: SurfaceWord,
    /// Rapids may be used on it.
    pub rapid: bool,
    /// The plane may be chosen on it.
    pub planes: bool,
    /// The centre of an arc may be given by I, J and K.
    pub centers: bool,
    /// Its code must be alone in its block: the alarm where it is not.
    pub alone: Option<&'static str>,
    /// The machine lacks its axis, or the axis is another.
    pub axes: Option<&'static str>,
    /// A code that may not come on it.
    pub code: Option<&'static str>,
    /// A code of tool length on it.
    pub length: Option<&'static str>,
    /// It begins in a mode that it may not begin in: compensation, a frame, another surface.
    pub mode: Option<&'static str>,
    /// It begins while one is active.
    pub nested: Option<&'static str>,
    /// F is per minute on it, and one per revolution from before does not act.
    pub own_feed: bool,
    /// How sure this is.
    pub certainty: Certainty,
    /// Where it is from.
    pub source: &'static str,
}
