//! What a signature of a cycle is made of.

/// A cycle with the names of its parameters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CycleSignature {
    /// The name in upper case.
    pub name: &'static str,
    /// What it does, in a few words.
    pub title: &'static str,
    /// The parameters in order.
    pub parameters: &'static [CycleParameter],
    /// This model carries the cycle out; otherwise it is recognized only, and its parameters are not checked.
    pub is_carried_out: bool,
    /// Where the parameters are described.
    pub source: &'static str,
}

/// A parameter of a cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CycleParameter {
    /// As in the manuals, in upper case.
    pub name: &'static str,
    /// In one line.
    pub meaning: &'static str,
    /// The unit; empty for a number without one.
    pub unit: &'static str,
}

pub(super) const fn parameter(
    name: &'static str,
    meaning: &'static str,
    unit: &'static str,
) -> CycleParameter {
    CycleParameter { name, meaning, unit }
}

/// A cycle that is carried out.
pub(super) const fn carried_out(
    name: &'static str,
    title: &'static str,
    parameters: &'static [CycleParameter],
    source: &'static str,
) -> CycleSignature {
    CycleSignature { name, title, parameters, is_carried_out: true, source }
}

/// The Cycles manual.
pub(super) const PGZ: &str = "Cycles, Programming Guide 11/2006 (PGZ)";

/// The manual that describes later parameters.
pub(super) const ONE: &str = "NC Programming 12/2019, 6FC5398-2EP40";

/// The parameters with which every drilling cycle begins, and more.
macro_rules! from_depth {
    ($($more:expr),* $(,)?) => {
        &[
            parameter("RTP", "retract plane, absolute", "mm"),
            parameter("RFP", "reference plane (surface), absolute", "mm"),
            parameter("SDIS", "safety distance above the reference plane, without sign", "mm"),
            parameter("DP", "final depth, absolute", "mm"),
            parameter("DPR", "final depth below the reference plane, without sign; wins over DP", "mm"),
            $($more),*
        ]
    };
}
pub(super) use from_depth;
