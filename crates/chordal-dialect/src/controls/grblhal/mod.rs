//! grblHAL: a relative of GRBL for 32-bit boards.

mod codes;
mod firmware;
mod recognition;
mod rules;
mod settings;

use super::grbl::{FAMILY, LEXICON_OF_EXPRESSIONS};
use crate::vocabulary::*;

/// grblHAL.
pub static TABLE: ControlTable = ControlTable {
    name: "grblhal",
    title: "grblHAL",
    source: "grblHAL, its source and its list of error codes",
    lexicon: LEXICON_OF_EXPRESSIONS,
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    arc_turns: ArcTurns::Total,
    set_data: SET_DATA,
    firmware: Some(&firmware::FIRMWARE),
    macros: &super::linuxcnc::MACROS,
    kind: Some(&recognition::KIND),
    evidence: recognition::EVIDENCE,
    default_machine: "grblhal",
    ..FAMILY
};

const SET_DATA: &[(u16, DataTarget)] = &[
    (0, DataTarget::Reload),
    (1, DataTarget::ToolTable),
    (2, DataTarget::WorkOffset),
    (10, DataTarget::ToolFromPosition),
    (11, DataTarget::ToolFromFixture),
    (20, DataTarget::WorkOffsetFromPosition),
];
