//! Parameters, expressions and flow control of grblHAL, in builds with expressions.

use crate::vocabulary::*;

/// As LinuxCNC has them.
pub(super) static MACROS: MacroRules = super::super::linuxcnc::MACRO_RULES;
