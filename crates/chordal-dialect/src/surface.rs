//! Polar and cylindrical interpolation: how a program gives the coordinates on the surface, what is not allowed
//! there, and the alarms of that.

use crate::settings::Certainty;

/// How the words of a program give the length around a surface.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SurfaceWord {
    /// The letter of the rotary axis, as a length (G12.1).
    RotaryLength,
    /// The letter of the rotary axis, as an angle (G7.1).
    RotaryAngle,
    /// The letter of the linear axis that the rotary one replaces, as a length (Haas).
    Linear,
}

/// The rules of one kind of surface on a control; an alarm is `None` where it is not known.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceRules {
    /// How the length around is written.
    pub word: SurfaceWord,
    /// Rapids are allowed on it.
    pub rapid: bool,
    /// The plane may be chosen on it.
    pub planes: bool,
    /// The centre of an arc may be given by I, J and K.
    pub centers: bool,
    /// The alarm where its code is not alone in its block.
    pub alone: Option<&'static str>,
    /// The alarm where the machine lacks its axis, or the block names another axis.
    pub axes: Option<&'static str>,
    /// The alarm of a code that is not allowed on it.
    pub code: Option<&'static str>,
    /// The alarm of a tool length code on it.
    pub length: Option<&'static str>,
    /// The alarm where it begins in a mode that excludes it: compensation, a frame, another surface.
    pub mode: Option<&'static str>,
    /// The alarm where it begins while one is active.
    pub nested: Option<&'static str>,
    /// F is per minute on it, and a feed per revolution from before does not apply.
    pub own_feed: bool,
    /// How certain these rules are.
    pub certainty: Certainty,
    /// Their source.
    pub source: &'static str,
}
