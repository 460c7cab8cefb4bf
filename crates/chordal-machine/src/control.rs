//! The names of the controls.

use std::fmt;
use std::str::FromStr;
use std::sync::{PoisonError, RwLock};

/// The names of controls that are not built in.
static REGISTERED_NAMES: RwLock<Vec<&'static str>> = RwLock::new(Vec::new());

/// The name of a control that is not built in; made by [`ControlName::register`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RegisteredControl(&'static str);

macro_rules! names {
    ($($name:ident $folder:ident $word:literal,)* ; $($other:ident $other_word:literal,)*) => {
        /// The control of a machine, by whose rules its programs are run.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[allow(missing_docs, reason = "each is the control of its folder")]
        pub enum ControlName {
            $($name,)*
            $($other,)*
            /// A control of a language that the application has registered.
            Registered(RegisteredControl),
        }

        impl ControlName {
            /// Every built-in control.
            pub const ALL: &'static [ControlName] = &[$(ControlName::$name,)* $(ControlName::$other,)*];

            /// The name in machine files, lower case.
            pub const fn as_str(self) -> &'static str {
                match self {
                    $(ControlName::$name => $word,)*
                    $(ControlName::$other => $other_word,)*
                    ControlName::Registered(RegisteredControl(word)) => word,
                }
            }
        }
    };
}

crate::controls!(names);

impl ControlName {
    /// Makes a name known to machine files, which is not that of a built-in control. From then on `control = "…"`
    /// takes it. Registering a name twice does nothing.
    pub fn register(name: &'static str) -> ControlName {
        if let Ok(known) = name.parse() {
            return known;
        }
        REGISTERED_NAMES.write().unwrap_or_else(PoisonError::into_inner).push(name);
        ControlName::Registered(RegisteredControl(name))
    }

    /// The names of all controls, those of registered languages last.
    pub fn all() -> Vec<ControlName> {
        let registered = REGISTERED_NAMES.read().unwrap_or_else(PoisonError::into_inner);
        let registered =
            registered.iter().map(|name| ControlName::Registered(RegisteredControl(name)));
        ControlName::ALL.iter().copied().chain(registered).collect()
    }
}

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
        ControlName::all()
            .into_iter()
            .find(|control| control.as_str().eq_ignore_ascii_case(text))
            .ok_or_else(|| UnknownControl(text.to_string()))
    }
}
