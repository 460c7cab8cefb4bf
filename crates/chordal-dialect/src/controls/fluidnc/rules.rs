//! How FluidNC moves and cuts.

use super::super::grbl::rules::PARAMETERS as FAMILY;
use crate::vocabulary::*;

/// As GRBL 1.1, with parameters and expressions, and with M6.
pub(super) const PARAMETERS: Parameters = Parameters {
    tool_change: ToolChanger::Machine,
    build: FirmwareBuild { expressions: true, ..FAMILY.build },
    nesting: 10,
    ..FAMILY
};
