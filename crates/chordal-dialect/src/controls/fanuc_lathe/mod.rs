//! Fanuc 0i-T, 18i-T, 31i-T and controls that read programs as they do: lathes with X as a diameter.

mod alarms;
mod codes;
mod post;
mod recognition;
mod rules;
pub(in crate::controls) mod settings;
mod systems;

pub(in crate::controls) use self::codes::CYCLE_WORDS;
pub(in crate::controls) use self::rules::PARAMETERS;

use crate::vocabulary::*;

/// Fanuc 0i-T, 18i-T, 31i-T, G code system A.
pub static TABLE: ControlTable = FANUC;

/// The table that the lathes of other makers are based on.
pub(in crate::controls) const FANUC: ControlTable = ControlTable {
    name: "fanuc-lathe",
    title: "Fanuc lathe",
    source: "Fanuc manuals for lathes B-62754EN, B-63604EN, B-63944EN",
    g_codes: codes::G_CODES,
    m_codes: codes::M_CODES,
    parameters: PARAMETERS,
    settings: settings::SETTINGS,
    alarms: super::fanuc::ALARMS,
    scale_unit: 0.001,
    set_data: SET_DATA,
    dwell: DWELL,
    dwell_alone_stops: true,
    open_m_codes: true,
    last_of_group_counts: true,
    face: Some(&super::fanuc::surface::FACE),
    cylinder: Some(&super::fanuc::surface::CYLINDER),
    call_start_label: Some(b'Q'),
    macros: &super::fanuc::MACROS,
    turning_alarms: alarms::TURNING,
    systems: systems::SYSTEMS,
    radial_cycles: &[870, 880, 890],
    kind: Some(&crate::lathe_signs::LATHE),
    evidence: recognition::EVIDENCE,
    post: &post::POST,
    default_machine: "fanuc-lathe",
    ..ControlTable::COMMON
};

const SET_DATA: &[(u16, DataTarget)] = &[
    (2, DataTarget::WorkOffset),
    (20, DataTarget::ExtendedWorkOffset),
    (50, DataTarget::Lines),
    (52, DataTarget::Lines),
];

const DWELL: &[DwellWord] = &[
    DwellWord { letter: b'P', integer_s: 0.001, point_s: 0.001, takes_point: false },
    DwellWord { letter: b'X', integer_s: 0.001, point_s: 1.0, takes_point: true },
    DwellWord { letter: b'U', integer_s: 0.001, point_s: 1.0, takes_point: true },
];
