//! The parameters of the standard cycles.

use super::cycle_parameters::{
    CycleParameter, CycleSignature, ONE, PGZ, carried_out, from_depth, parameter,
};
use super::milling_signatures::{
    CONTOUR_CUTTING, FACE_MILLING, HIGH_SPEED, LONG_HOLES, POCKETS, SLOTS, SPIGOTS, STOCK_REMOVAL,
    SWIVEL, THREADS,
};

const DTB: CycleParameter =
    parameter("DTB", "dwell at depth; revolutions when negative", "s or rev");
const SDIR: CycleParameter = parameter("SDIR", "direction of the spindle: 3 or 4", "");
const SDAC: CycleParameter = parameter("SDAC", "spindle after the cycle: 3, 4 or 5", "");
const MPIT: CycleParameter =
    parameter("MPIT", "lead as the size of a metric thread, 3 to 48; negative is left-hand", "");
const PIT: CycleParameter = parameter("PIT", "lead of the thread; negative is left-hand", "mm/rev");
const AXN: CycleParameter =
    parameter("_AXN", "drilling axis: 1 and 2 in the plane, 3 its normal (default)", "");
const PITA: CycleParameter = parameter(
    "_PITA",
    "unit of PIT: 0 as the program, 1 mm, 2 threads an inch, 3 inches, 4 module",
    "",
);
const PITM: CycleParameter = parameter("_PITM", "lead as text, for the editor", "");
const PTAB: CycleParameter = parameter("_PTAB", "table of threads (text), for the editor", "");
const PTABA: CycleParameter = parameter("_PTABA", "entry of the table (text), for the editor", "");
const TECHNO: CycleParameter =
    parameter("_TECHNO", "digits: exact stop, feedforward, acceleration, spindle mode", "");
const VRT: CycleParameter =
    parameter("_VRT", "lift that breaks the chip; 1 mm when 0 or negative", "mm");
const GMODE: CycleParameter = parameter("_GMODE", "digits: what the depth refers to", "");
const DMODE: CycleParameter = parameter("_DMODE", "digits: plane and display", "");
const AMODE: CycleParameter = parameter(
    "_AMODE",
    "digits from the last: depth by DPR (1) or DP (2), DTB in s (1) or rev (2); 0 as older versions",
    "",
);
const VARI_PATTERN: CycleParameter = parameter("_VARI", "variant of the pattern", "");
const UMODE: CycleParameter = parameter("_UMODE", "reserved", "");
const HIDE: CycleParameter = parameter("_HIDE", "points that are left out (text)", "");
const NSP: CycleParameter = parameter("_NSP", "reserved", "");

const DRILLING: [CycleSignature; 10] = [
    carried_out("CYCLE81", "centring, drilling", from_depth![DTB, GMODE, DMODE, AMODE], ONE),
    carried_out(
        "CYCLE82",
        "drilling with dwell, counterboring",
        from_depth![
            DTB,
            GMODE,
            DMODE,
            AMODE,
            parameter("_VARI", "predrilling and through drilling", ""),
            parameter("S_ZA", "depth of predrilling", "mm"),
            parameter("S_FA", "feed of predrilling", "mm/min or %"),
            parameter("S_ZD", "depth of through drilling", "mm"),
            parameter("S_FD", "feed of through drilling", "mm/min or %"),
        ],
        ONE,
    ),
    carried_out(
        "CYCLE83",
        "deep-hole drilling",
        from_depth![
            parameter("FDEP", "first depth, absolute", "mm"),
            parameter("FDPR", "first depth below the reference plane; wins over FDEP", "mm"),
            parameter("DAM", "degression: amount, or factor when negative; 0 equal pecks", "mm"),
            DTB,
            parameter("DTS", "dwell at the start plane; revolutions when negative", "s or rev"),
            parameter("FRF", "feed factor of the first peck, 0.001 to 1", ""),
            parameter("VARI", "0 break chips, 1 remove chips", ""),
            AXN,
            parameter("_MDEP", "smallest peck with a degression factor", "mm"),
            VRT,
            parameter("_DTD", "dwell at the final depth; as DTB when 0", "s or rev"),
            parameter("_DIS1", "distance above the last depth for the next peck; 0 computed", "mm"),
            GMODE,
            DMODE,
            AMODE,
        ],
        PGZ,
    ),
    carried_out(
        "CYCLE84",
        "tapping with the spindle in position control",
        from_depth![
            DTB,
            SDAC,
            MPIT,
            PIT,
            parameter("POSS", "angle at which the spindle stops before", "degrees"),
            parameter("SST", "speed of tapping", "rpm"),
            parameter("SST1", "speed of retraction; as SST when 0", "rpm"),
            AXN,
            PITA,
            TECHNO,
            parameter("_VARI", "0 in one go, 1 break chips, 2 remove chips", ""),
            parameter("_DAM", "peck", "mm"),
            VRT,
            PITM,
            PTAB,
            PTABA,
            GMODE,
            DMODE,
            AMODE,
        ],
        PGZ,
    ),
    carried_out(
        "CYCLE840",
        "tapping with a compensating chuck",
        from_depth![
            DTB,
            parameter("SDR", "direction of the spindle for retraction: 0 reverses, 3, 4", ""),
            SDAC,
            parameter("ENC", "0 and 20 with encoder, 11 without; 1 the feed makes the lead", ""),
            MPIT,
            PIT,
            AXN,
            PITA,
            TECHNO,
            PITM,
            PTAB,
            PTABA,
            GMODE,
            DMODE,
            AMODE,
        ],
        PGZ,
    ),
    carried_out(
        "CYCLE85",
        "reaming",
        from_depth![
            DTB,
            parameter("FFR", "feed", "mm/min"),
            parameter("RFF", "feed of retraction", "mm/min"),
            GMODE,
            DMODE,
            AMODE,
        ],
        PGZ,
    ),
    carried_out(
        "CYCLE86",
        "boring with oriented spindle stop",
        from_depth![
            DTB,
            SDIR,
            parameter("RPA", "lift-off along the first axis of the plane, incremental", "mm"),
            parameter("RPO", "lift-off along the second axis of the plane, incremental", "mm"),
            parameter("RPAP", "lift-off along the drilling axis, incremental", "mm"),
            parameter("POSS", "angle at which the spindle stops", "degrees"),
            GMODE,
            DMODE,
            AMODE,
        ],
        PGZ,
    ),
    carried_out("CYCLE87", "boring with stop", from_depth![SDIR], PGZ),
    carried_out("CYCLE88", "boring with dwell and stop", from_depth![DTB, SDIR], PGZ),
    carried_out(
        "CYCLE89",
        "boring with retraction at feed",
        from_depth![DTB, GMODE, DMODE, AMODE],
        PGZ,
    ),
];

const PATTERNS: [CycleSignature; 4] = [
    carried_out(
        "HOLES1",
        "row of holes",
        &[
            parameter("SPCA", "reference point along the first axis of the plane", "mm"),
            parameter("SPCO", "reference point along the second axis of the plane", "mm"),
            parameter("STA1", "angle of the row to the first axis", "degrees"),
            parameter("FDIS", "distance of the first hole from the reference point", "mm"),
            parameter("DBH", "distance between holes", "mm"),
            parameter("NUM", "number of holes", ""),
            VARI_PATTERN,
            UMODE,
            HIDE,
            NSP,
            DMODE,
        ],
        PGZ,
    ),
    carried_out(
        "HOLES2",
        "circle of holes",
        &[
            parameter("CPA", "center along the first axis of the plane", "mm"),
            parameter("CPO", "center along the second axis of the plane", "mm"),
            parameter("RAD", "radius of the circle", "mm"),
            parameter("STA1", "angle of the first hole", "degrees"),
            parameter("INDA", "angle between holes; 0 divides the full circle", "degrees"),
            parameter("NUM", "number of holes", ""),
            VARI_PATTERN,
            UMODE,
            HIDE,
            NSP,
            DMODE,
        ],
        PGZ,
    ),
    carried_out(
        "CYCLE801",
        "grid of holes",
        &[
            parameter("_SPCA", "reference point along the first axis of the plane", "mm"),
            parameter("_SPCO", "reference point along the second axis of the plane", "mm"),
            parameter("_STA", "angle of the grid to the first axis", "degrees"),
            parameter("_DIS1", "distance of columns", "mm"),
            parameter("_DIS2", "distance of rows", "mm"),
            parameter("_NUM1", "number of columns", ""),
            parameter("_NUM2", "number of rows", ""),
            parameter("_VARI", "0 grid, 1 frame", ""),
            UMODE,
            parameter("_ANG1", "shear of the rows", "degrees"),
            parameter("_ANG2", "shear of the columns", "degrees"),
            HIDE,
            NSP,
            DMODE,
        ],
        PGZ,
    ),
    carried_out(
        "CYCLE802",
        "list of points",
        &[
            parameter("_XA", "a digit for each point: 1 _Xn absolute, 2 incremental", ""),
            parameter("_YA", "a digit for each point: 1 _Yn absolute, 2 incremental", ""),
            parameter("_X0", "point 1, first axis of the plane", "mm"),
            parameter("_Y0", "point 1, second axis of the plane", "mm"),
            parameter("_X1", "point 2, first axis of the plane", "mm"),
            parameter("_Y1", "point 2, second axis of the plane", "mm"),
            parameter("_X2", "point 3, first axis of the plane", "mm"),
            parameter("_Y2", "point 3, second axis of the plane", "mm"),
            parameter("_X3", "point 4, first axis of the plane", "mm"),
            parameter("_Y3", "point 4, second axis of the plane", "mm"),
            parameter("_X4", "point 5, first axis of the plane", "mm"),
            parameter("_Y4", "point 5, second axis of the plane", "mm"),
            parameter("_X5", "point 6, first axis of the plane", "mm"),
            parameter("_Y5", "point 6, second axis of the plane", "mm"),
            parameter("_X6", "point 7, first axis of the plane", "mm"),
            parameter("_Y6", "point 7, second axis of the plane", "mm"),
            parameter("_X7", "point 8, first axis of the plane", "mm"),
            parameter("_Y7", "point 8, second axis of the plane", "mm"),
            parameter("_X8", "point 9, first axis of the plane", "mm"),
            parameter("_Y8", "point 9, second axis of the plane", "mm"),
            VARI_PATTERN,
            UMODE,
            DMODE,
        ],
        ONE,
    ),
];

/// The number of standard cycles in the table.
const CYCLE_COUNT: usize = DRILLING.len()
    + PATTERNS.len()
    + POCKETS.len()
    + SLOTS.len()
    + LONG_HOLES.len()
    + FACE_MILLING.len()
    + CONTOUR_CUTTING.len()
    + SPIGOTS.len()
    + THREADS.len()
    + STOCK_REMOVAL.len()
    + SWIVEL.len()
    + HIGH_SPEED.len();

/// The standard cycles: those that drill, patterns of holes, those that mill, and those that are recognized only.
pub const CYCLES: &[CycleSignature] = &joined([
    &DRILLING,
    &PATTERNS,
    &POCKETS,
    &SLOTS,
    &LONG_HOLES,
    &FACE_MILLING,
    &CONTOUR_CUTTING,
    &SPIGOTS,
    &THREADS,
    &STOCK_REMOVAL,
    &SWIVEL,
    &HIGH_SPEED,
]);

const fn joined<const GROUPS: usize>(
    groups: [&[CycleSignature]; GROUPS],
) -> [CycleSignature; CYCLE_COUNT] {
    let mut all = [DRILLING[0]; CYCLE_COUNT];
    let (mut group, mut filled) = (0, 0);
    while group < GROUPS {
        let mut entry = 0;
        while entry < groups[group].len() {
            all[filled] = groups[group][entry];
            (entry, filled) = (entry + 1, filled + 1);
        }
        group += 1;
    }
    all
}

/// A standard cycle by its name in any case. `None` when there is none.
pub fn cycle_signature(name: &str) -> Option<&'static CycleSignature> {
    CYCLES.iter().find(|cycle| cycle.name.eq_ignore_ascii_case(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique() {
        for (index, cycle) in CYCLES.iter().enumerate() {
            assert!(!CYCLES[..index].iter().any(|other| other.name == cycle.name));
            for (index, parameter) in cycle.parameters.iter().enumerate() {
                let before = &cycle.parameters[..index];
                assert!(!before.iter().any(|other| other.name == parameter.name), "{cycle:?}");
                assert!(!parameter.meaning.is_empty());
            }
        }
    }

    #[test]
    fn the_table_is_complete() {
        let carried_out = CYCLES.iter().filter(|cycle| cycle.is_carried_out).count();
        assert_eq!((CYCLES.len(), carried_out), (32, 29));
        let count = |name| cycle_signature(name).map(|cycle| cycle.parameters.len());
        // Counted in the lists of the manuals.
        assert_eq!(count("CYCLE82"), Some(14));
        assert_eq!(count("cycle83"), Some(20));
        assert_eq!(count("POCKET3"), Some(29));
        assert_eq!(count("SLOT1"), Some(31));
        assert_eq!(count("CYCLE97"), Some(20));
        assert_eq!(count("CYCLE800"), Some(16));
        assert_eq!(count("CYCLE9"), None);
    }
}
