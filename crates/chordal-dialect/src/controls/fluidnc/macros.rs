//! Parameters, expressions and flow control of FluidNC.

use crate::vocabulary::*;

/// As LinuxCNC has them.
pub(super) static MACROS: MacroRules = super::super::linuxcnc::MACRO_RULES;
