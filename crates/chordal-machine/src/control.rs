//! The names of the controls.

use std::fmt;
use std::str::FromStr;

macro_rules! names {
    ($($name:ident $folder:ident $word:literal,)*) => {
        /// The control of a machine, by whose rules its programs are run.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[allow(missing_docs, reason = "each is the control of its folder")]
        pub enum ControlName {
            $($name,)*
        }

        impl ControlName {
            /// Every control.
            pub const ALL: &'static [ControlName] = &[$(ControlName::$name),*];

            /// The name in machine files, lower case.
            pub const fn as_str(self) -> &'static str {
                match self {
                    $(ControlName::$name => $word,)*
                }
            }
        }
    };
}

crate::controls!(names);

/// The error for a text that is not the name of a control.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not a control")]
pub struct UnknownControl(pub String);

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
            .iter()
            .copied()
            .find(|control| control.as_str().eq_ignore_ascii_case(text))
            .ok_or_else(|| UnknownControl(text.to_string()))
    }
}
