//! Fanuc 0i, 16i, 30i and, by settings, the 6M.

mod alarms;
mod codes;
mod macros;
mod post;
pub(crate) mod recognition;
mod rules;
mod settings;
pub(in crate::controls) mod surface;

pub(super) use alarms::ALARMS;
pub(super) use macros::{MACROS, MODAL_GROUPS};
pub(super) use post::POST;

use crate::vocabulary::*;

/// Fanuc 0i, 16i, 30i and, by settings, the 6M.
pub static TABLE: ControlTable = ControlTable {
    name: "fanuc",
    title: "Fanuc",
    source: "Fanuc manuals B-63944EN, B-63534EN, B-63324EN",
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: rules::PARAMETERS,
    settings: settings::SETTINGS,
    alarms: ALARMS,
    scale_unit: 0.001,
    set_data: SET_DATA,
    dwell: DWELL,
    dwell_alone_stops: true,
    open_m_codes: true,
    last_of_group_counts: true,
    spatial: Some(&rules::SPATIAL),
    tilted_plane: rules::TILTED_PLANE,
    face: Some(&surface::FACE),
    cylinder: Some(&surface::CYLINDER),
    call_start_label: Some(b'Q'),
    macros: &MACROS,
    evidence: recognition::EVIDENCE,
    post: &POST,
    default_machine: "fanuc-30i",
    ..ControlTable::COMMON
};

const SET_DATA: &[(u16, DataTarget)] = &[
    (2, DataTarget::WorkOffset),
    (10, DataTarget::Tool(ToolValue::Length)),
    (11, DataTarget::Tool(ToolValue::LengthWear)),
    (12, DataTarget::Tool(ToolValue::Radius)),
    (13, DataTarget::Tool(ToolValue::RadiusWear)),
    (20, DataTarget::ExtendedWorkOffset),
    (50, DataTarget::Lines),
    (52, DataTarget::Lines),
    (85, DataTarget::Other),
];

const DWELL: &[DwellWord] = &[
    DwellWord { letter: b'P', integer_s: 0.001, point_s: 0.001, takes_point: false },
    DwellWord { letter: b'X', integer_s: 0.001, point_s: 1.0, takes_point: true },
    DwellWord { letter: b'U', integer_s: 0.001, point_s: 1.0, takes_point: true },
];
