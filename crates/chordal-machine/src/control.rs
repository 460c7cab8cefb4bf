//! The controls by name.

use std::fmt;
use std::str::FromStr;

/// The control of a machine: whose rules its programs are read by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ControlName {
    /// Fadal CNC 88.
    Fadal,
    /// Haas mill (NGC).
    Haas,
    /// Fanuc M series.
    Fanuc,
    /// Mitsubishi M700/M800.
    Mitsubishi,
    /// LinuxCNC.
    Linuxcnc,
}

/// The name of no control.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not a control")]
pub struct UnknownControl(pub String);

impl ControlName {
    /// Every control.
    pub const ALL: [ControlName; 5] = [
        ControlName::Fadal,
        ControlName::Haas,
        ControlName::Fanuc,
        ControlName::Mitsubishi,
        ControlName::Linuxcnc,
    ];

    /// The name, lower case, as a machine file writes it.
    pub const fn as_str(self) -> &'static str {
        match self {
            ControlName::Fadal => "fadal",
            ControlName::Haas => "haas",
            ControlName::Fanuc => "fanuc",
            ControlName::Mitsubishi => "mitsubishi",
            ControlName::Linuxcnc => "linuxcnc",
        }
    }
}

impl fmt::Display for ControlName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

impl FromStr for ControlName {
    type Err = UnknownControl;

    /// Reads a name in either case.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        ControlName::ALL
            .into_iter()
            .find(|control| control.as_str().eq_ignore_ascii_case(text))
            .ok_or_else(|| UnknownControl(text.to_string()))
    }
}
