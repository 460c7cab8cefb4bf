//! FluidNC: a relative of GRBL for the ESP32.

mod codes;
mod firmware;
mod recognition;
mod rules;
mod settings;

use super::grbl::{FAMILY, LEXICON_OF_EXPRESSIONS};
use crate::vocabulary::*;

/// FluidNC.
pub static TABLE: ControlTable = ControlTable {
    name: "fluidnc",
    title: "FluidNC",
    source: "FluidNC, its source and its list of error codes",
    lexicon: LEXICON_OF_EXPRESSIONS,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    arc_turns: ArcTurns::Total,
    firmware: Some(&firmware::FIRMWARE),
    macros: &super::linuxcnc::MACROS,
    kind: Some(&recognition::KIND),
    evidence: recognition::EVIDENCE,
    default_machine: "fluidnc",
    ..FAMILY
};
