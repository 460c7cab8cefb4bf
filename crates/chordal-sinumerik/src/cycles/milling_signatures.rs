//! The parameters of the cycles that mill, and of those that are recognized and not carried out: a contour, turning,
//! swivelling, path modes.
//!
//! The parameters of milling cycles up to those of PGZ stand first; those from `_UMODE`, `_FS` or `_GMODE` on were added later
//! (NC Programming 12/2019).

use super::cycle_parameters::{
    CycleParameter, CycleSignature, ONE, PGZ, carried_out, from_depth, parameter,
};

const UMODE: CycleParameter = parameter("_UMODE", "reserved", "");
const FS: CycleParameter = parameter("_FS", "width of a chamfer", "mm");
const ZFS: CycleParameter = parameter("_ZFS", "depth of the tip in a chamfer", "mm");
const GMODE: CycleParameter = parameter(
    "_GMODE",
    "digits from the hundreds: machining or start point, reference point, whether the blank counts",
    "",
);
const DMODE: CycleParameter = parameter("_DMODE", "digits: plane and display", "");
const AMODE: CycleParameter = parameter(
    "_AMODE",
    "digits from the last: depth 1 incremental, 2 absolute, 0 as older versions; stepover in mm (0) or % (1)",
    "",
);

/// A cycle that is recognized only.
const fn recognized(
    name: &'static str,
    title: &'static str,
    parameters: &'static [CycleParameter],
    source: &'static str,
) -> CycleSignature {
    CycleSignature { name, title, parameters, is_carried_out: false, source }
}

macro_rules! p {
    ($name:literal, $meaning:literal) => {
        parameter($name, $meaning, "")
    };
    ($name:literal, $meaning:literal, $unit:literal) => {
        parameter($name, $meaning, $unit)
    };
}

pub(super) const POCKETS: [CycleSignature; 4] = [
    carried_out(
        "POCKET1",
        "rectangular pocket with a face cutter",
        from_depth![
            p!("LENG", "length", "mm"),
            p!("WID", "width", "mm"),
            p!("CRAD", "corner radius", "mm"),
            p!("CPA", "center along the first axis of the plane", "mm"),
            p!("CPO", "center along the second axis of the plane", "mm"),
            p!("STA1", "angle of the length to the first axis", "degrees"),
            p!("FFD", "feed of infeed", "mm/min"),
            p!("FFP1", "feed in the plane", "mm/min"),
            p!("MID", "largest infeed", "mm"),
            p!("CDIR", "direction of milling: 2 G2, 3 G3"),
            p!("FAL", "finishing allowance at the edge", "mm"),
            p!("VARI", "0 complete, 1 rough, 2 finish"),
            p!("MIDF", "largest infeed of finishing", "mm"),
            p!("FFP2", "feed of finishing", "mm/min"),
            p!("SSF", "speed of finishing", "rpm"),
        ],
        PGZ,
    ),
    carried_out(
        "POCKET2",
        "circular pocket with a face cutter",
        from_depth![
            p!("PRAD", "radius", "mm"),
            p!("CPA", "center along the first axis of the plane", "mm"),
            p!("CPO", "center along the second axis of the plane", "mm"),
            p!("FFD", "feed of infeed", "mm/min"),
            p!("FFP1", "feed in the plane", "mm/min"),
            p!("MID", "largest infeed", "mm"),
            p!("CDIR", "direction of milling: 2 G2, 3 G3"),
            p!("FAL", "finishing allowance at the edge", "mm"),
            p!("VARI", "0 complete, 1 rough, 2 finish"),
            p!("MIDF", "largest infeed of finishing", "mm"),
            p!("FFP2", "feed of finishing", "mm/min"),
            p!("SSF", "speed of finishing", "rpm"),
        ],
        PGZ,
    ),
    carried_out(
        "POCKET3",
        "rectangular pocket",
        &[
            p!("_RTP", "retract plane, absolute", "mm"),
            p!("_RFP", "reference plane, absolute", "mm"),
            p!("_SDIS", "safety distance, without sign", "mm"),
            p!("_DP", "depth, absolute", "mm"),
            p!("_LENG", "length; signs choose the corner of reference", "mm"),
            p!("_WID", "width; signs choose the corner of reference", "mm"),
            p!("_CRAD", "corner radius", "mm"),
            p!("_PA", "reference point along the first axis of the plane", "mm"),
            p!("_PO", "reference point along the second axis of the plane", "mm"),
            p!("_STA", "angle of the length to the first axis", "degrees"),
            p!("_MID", "largest infeed", "mm"),
            p!("_FAL", "finishing allowance at the edge", "mm"),
            p!("_FALD", "finishing allowance at the base", "mm"),
            p!("_FFP1", "feed in the plane", "mm/min"),
            p!("_FFD", "feed of infeed", "mm/min"),
            p!("_CDIR", "direction of milling: 0 climb, 1 conventional, 2 G2, 3 G3"),
            p!("_VARI", "ones 1 rough, 2 finish; tens infeed: 0 and 1 straight, 2 helix, 3 ramp"),
            p!("_MIDA", "largest stepover; 0.8 of the diameter when 0", "mm"),
            p!("_AP1", "length of the blank", "mm"),
            p!("_AP2", "width of the blank", "mm"),
            p!("_AD", "depth of the blank", "mm"),
            p!("_RAD1", "radius of the helix or largest angle of the ramp", "mm or degrees"),
            p!("_DP1", "depth of a turn of the helix", "mm"),
            UMODE,
            FS,
            ZFS,
            GMODE,
            DMODE,
            AMODE,
        ],
        PGZ,
    ),
    carried_out(
        "POCKET4",
        "circular pocket",
        &[
            p!("_RTP", "retract plane, absolute", "mm"),
            p!("_RFP", "reference plane, absolute", "mm"),
            p!("_SDIS", "safety distance, without sign", "mm"),
            p!("_DP", "depth, absolute", "mm"),
            p!("_PRAD", "radius", "mm"),
            p!("_PA", "center along the first axis of the plane", "mm"),
            p!("_PO", "center along the second axis of the plane", "mm"),
            p!("_MID", "largest infeed", "mm"),
            p!("_FAL", "finishing allowance at the edge", "mm"),
            p!("_FALD", "finishing allowance at the base", "mm"),
            p!("_FFP1", "feed in the plane", "mm/min"),
            p!("_FFD", "feed of infeed", "mm/min"),
            p!("_CDIR", "direction of milling: 0 climb, 1 conventional, 2 G2, 3 G3"),
            p!("_VARI", "ones 1 rough, 2 finish; tens infeed: 0 and 1 straight, 2 helix"),
            p!("_MIDA", "largest stepover; 0.8 of the diameter when 0", "mm"),
            p!("_AP1", "radius of the blank", "mm"),
            p!("_AD", "depth of the blank", "mm"),
            p!("_RAD1", "radius of the helix", "mm"),
            p!("_DP1", "depth of a turn of the helix", "mm"),
            UMODE,
            FS,
            ZFS,
            GMODE,
            DMODE,
            AMODE,
        ],
        PGZ,
    ),
];

/// The parameters of slots on a circle, which differ in the size of a slot.
macro_rules! slots {
    ($size:expr, $($more:expr),*) => {
        from_depth![
            p!("NUM", "number of slots"),
            $size,
            p!("WID", "width of a slot", "mm"),
            p!("CPA", "center along the first axis of the plane", "mm"),
            p!("CPO", "center along the second axis of the plane", "mm"),
            p!("RAD", "radius of the circle", "mm"),
            p!("STA1", "angle of the first slot", "degrees"),
            p!("INDA", "angle between slots", "degrees"),
            p!("FFD", "feed of infeed", "mm/min"),
            p!("FFP1", "feed in the plane", "mm/min"),
            p!("MID", "largest infeed", "mm"),
            p!("CDIR", "direction of milling: 2 G2, 3 G3"),
            p!("FAL", "finishing allowance at the edge", "mm"),
            p!("VARI", "0 complete, 1 rough, 2 finish"),
            p!("MIDF", "largest infeed of finishing", "mm"),
            p!("FFP2", "feed of finishing", "mm/min"),
            p!("SSF", "speed of finishing", "rpm"),
            $($more,)*
            UMODE,
            FS,
            ZFS,
            GMODE,
            DMODE,
            AMODE,
        ]
    };
}

pub(super) const SLOTS: [CycleSignature; 2] = [
    carried_out(
        "SLOT1",
        "radial slots on a circle",
        slots!(
            p!("LENG", "length", "mm"),
            p!("_FALD", "finishing allowance at the base", "mm"),
            p!("_STA2", "largest angle of insertion to and fro", "degrees"),
            p!("_DP1", "depth of a turn of the helix", "mm")
        ),
        PGZ,
    ),
    carried_out(
        "SLOT2",
        "slots along a circle",
        slots!(
            p!("AFSL", "angle that a slot covers", "degrees"),
            p!("_FFCP", "feed between slots along the circle", "mm/min")
        ),
        PGZ,
    ),
];

pub(super) const LONG_HOLES: [CycleSignature; 1] = [carried_out(
    "LONGHOLE",
    "radial slots as wide as the tool on a circle",
    from_depth![
        p!("NUM", "number of slots"),
        p!("LENG", "length", "mm"),
        p!("CPA", "center along the first axis of the plane", "mm"),
        p!("CPO", "center along the second axis of the plane", "mm"),
        p!("RAD", "radius of the circle", "mm"),
        p!("STA1", "angle of the first slot", "degrees"),
        p!("INDA", "angle between slots", "degrees"),
        p!("FFD", "feed of infeed", "mm/min"),
        p!("FFP1", "feed in the plane", "mm/min"),
        p!("MID", "largest infeed", "mm"),
        p!("_VARI", "kind of insertion"),
        UMODE,
        GMODE,
        DMODE,
        AMODE,
    ],
    PGZ,
)];

pub(super) const FACE_MILLING: [CycleSignature; 2] = [
    carried_out(
        "CYCLE61",
        "face milling",
        &[
            p!("_RTP", "retract plane, absolute", "mm"),
            p!("_Z0", "height of the blank, absolute", "mm"),
            p!("_SDIS", "safety distance, without sign", "mm"),
            p!("_Z1", "height of the finished part", "mm"),
            p!("_X0", "corner 1 along the first axis of the plane", "mm"),
            p!("_Y0", "corner 1 along the second axis of the plane", "mm"),
            p!("_X1", "corner 2 along the first axis of the plane", "mm"),
            p!("_Y1", "corner 2 along the second axis of the plane", "mm"),
            p!("_MID", "largest infeed", "mm"),
            p!("_MIDA", "largest stepover", "mm"),
            p!("_FALD", "finishing allowance at the base", "mm"),
            p!("_FFP1", "feed", "mm/min"),
            p!("_VARI", "ones 1 rough, 2 finish; tens 1 and 2 one direction, 3 and 4 zigzag"),
            p!("_LIM", "edges that limit the area"),
            p!("_DMODE", "digits: plane and display"),
            p!("_AMODE", "digits: which values are incremental"),
        ],
        ONE,
    ),
    carried_out(
        "CYCLE71",
        "face milling",
        &[
            p!("_RTP", "retract plane, absolute", "mm"),
            p!("_RFP", "reference plane, absolute", "mm"),
            p!("_SDIS", "safety distance, without sign", "mm"),
            p!("_DP", "depth, absolute", "mm"),
            p!("_PA", "corner along the first axis of the plane", "mm"),
            p!("_PO", "corner along the second axis of the plane", "mm"),
            p!("_LENG", "length along the first axis of the plane", "mm"),
            p!("_WID", "width along the second axis of the plane", "mm"),
            p!("_STA", "angle of the length to the first axis", "degrees"),
            p!("_MID", "largest infeed", "mm"),
            p!("_MIDA", "largest stepover", "mm"),
            p!("_FDP", "distance beyond the edge for the infeed", "mm"),
            p!("_FALD", "finishing allowance at the base", "mm"),
            p!("_FFP1", "feed", "mm/min"),
            p!("_VARI", "ones 1 rough, 2 finish; tens 1 and 2 one direction, 3 and 4 zigzag"),
            p!("_FDP1", "overrun beyond the edge", "mm"),
        ],
        PGZ,
    ),
];

pub(super) const CONTOUR_CUTTING: [CycleSignature; 1] = [carried_out(
    "CYCLE72",
    "contour milling",
    &[
        p!("_KNAME", "subprogram of the contour (text)"),
        p!("_RTP", "retract plane, absolute", "mm"),
        p!("_RFP", "reference plane, absolute", "mm"),
        p!("_SDIS", "safety distance, without sign", "mm"),
        p!("_DP", "depth, absolute", "mm"),
        p!("_MID", "largest infeed", "mm"),
        p!("_FAL", "finishing allowance at the contour", "mm"),
        p!("_FALD", "finishing allowance at the base", "mm"),
        p!("_FFP1", "feed in the plane", "mm/min"),
        p!("_FFD", "feed of infeed", "mm/min"),
        p!("_VARI", "ones 1 rough, 2 finish"),
        p!("_RL", "side of the tool: 40, 41 or 42"),
        p!("_AS1", "approach: straight, quarter circle or semicircle"),
        p!("_LP1", "length or radius of the approach", "mm"),
        p!("_FF3", "feed of intermediate positioning", "mm/min"),
        p!("_AS2", "retraction: straight, quarter circle or semicircle"),
        p!("_LP2", "length or radius of the retraction", "mm"),
    ],
    PGZ,
)];

pub(super) const SPIGOTS: [CycleSignature; 2] = [
    carried_out(
        "CYCLE76",
        "rectangular spigot",
        &[
            p!("_RTP", "retract plane, absolute", "mm"),
            p!("_RFP", "reference plane, absolute", "mm"),
            p!("_SDIS", "safety distance, without sign", "mm"),
            p!("_DP", "depth, absolute", "mm"),
            p!("_DPR", "depth below the reference plane, without sign", "mm"),
            p!("_LENG", "length", "mm"),
            p!("_WID", "width", "mm"),
            p!("_CRAD", "corner radius", "mm"),
            p!("_PA", "reference point along the first axis of the plane", "mm"),
            p!("_PO", "reference point along the second axis of the plane", "mm"),
            p!("_STA", "angle of the length to the first axis", "degrees"),
            p!("_MID", "largest infeed", "mm"),
            p!("_FAL", "finishing allowance at the edge", "mm"),
            p!("_FALD", "finishing allowance at the base", "mm"),
            p!("_FFP1", "feed in the plane", "mm/min"),
            p!("_FFD", "feed of infeed", "mm/min"),
            p!("_CDIR", "direction of milling: 0 climb, 1 conventional, 2 G2, 3 G3"),
            p!("_VARI", "1 rough, 2 finish"),
            p!("_AP1", "length of the blank", "mm"),
            p!("_AP2", "width of the blank", "mm"),
            FS,
            ZFS,
            GMODE,
            DMODE,
            AMODE,
        ],
        PGZ,
    ),
    carried_out(
        "CYCLE77",
        "circular spigot",
        &[
            p!("_RTP", "retract plane, absolute", "mm"),
            p!("_RFP", "reference plane, absolute", "mm"),
            p!("_SDIS", "safety distance, without sign", "mm"),
            p!("_DP", "depth, absolute", "mm"),
            p!("_DPR", "depth below the reference plane, without sign", "mm"),
            p!("_PRAD", "diameter", "mm"),
            p!("_PA", "center along the first axis of the plane", "mm"),
            p!("_PO", "center along the second axis of the plane", "mm"),
            p!("_MID", "largest infeed", "mm"),
            p!("_FAL", "finishing allowance at the edge", "mm"),
            p!("_FALD", "finishing allowance at the base", "mm"),
            p!("_FFP1", "feed in the plane", "mm/min"),
            p!("_FFD", "feed of infeed", "mm/min"),
            p!("_CDIR", "direction of milling: 0 climb, 1 conventional, 2 G2, 3 G3"),
            p!("_VARI", "1 rough, 2 finish"),
            p!("_AP1", "diameter of the blank", "mm"),
            FS,
            ZFS,
            GMODE,
            DMODE,
            AMODE,
        ],
        PGZ,
    ),
];

pub(super) const THREADS: [CycleSignature; 2] = [
    carried_out(
        "CYCLE90",
        "thread milling",
        from_depth![
            p!("DIATH", "nominal diameter", "mm"),
            p!("KDIAM", "core diameter", "mm"),
            p!("PIT", "lead of the thread", "mm/rev"),
            p!("FFR", "feed", "mm/min"),
            p!("CDIR", "direction of milling: 2 G2, 3 G3"),
            p!("TYPTH", "0 internal, 1 external"),
            p!("CPA", "center along the first axis of the plane", "mm"),
            p!("CPO", "center along the second axis of the plane", "mm"),
        ],
        PGZ,
    ),
    carried_out(
        "CYCLE97",
        "thread turning",
        &[
            p!("PIT", "lead of the thread", "mm/rev"),
            p!("MPIT", "lead as the size of a metric thread"),
            p!("SPL", "start of the thread, longitudinal", "mm"),
            p!("FPL", "end of the thread, longitudinal", "mm"),
            p!("DM1", "diameter at the start", "mm"),
            p!("DM2", "diameter at the end", "mm"),
            p!("APP", "run-in, without sign", "mm"),
            p!("ROP", "run-out, without sign", "mm"),
            p!("TDEP", "depth of the thread, without sign", "mm"),
            p!("FAL", "finishing allowance, without sign", "mm"),
            p!("IANG", "infeed angle", "degrees"),
            p!("NSP", "start angle", "degrees"),
            p!("NRC", "number of roughing cuts"),
            p!("NID", "number of cuts without infeed"),
            p!("VARI", "1 and 2 equal infeeds, 3 and 4 equal sections; odd is external"),
            p!("NUMT", "number of starts"),
            p!("_VRT", "retraction", "mm"),
            p!("_PITA", "unit of PIT"),
            p!("_PITM", "size of the thread (text)"),
            p!("_PTAB", "table of threads (text)"),
        ],
        PGZ,
    ),
];

pub(super) const STOCK_REMOVAL: [CycleSignature; 2] = [
    carried_out(
        "CYCLE95",
        "stock removal along a contour",
        &[
            p!("NPP", "subprogram of the contour (text)"),
            p!("MID", "largest infeed", "mm"),
            p!("FALZ", "finishing allowance, longitudinal", "mm"),
            p!("FALX", "finishing allowance, transverse", "mm"),
            p!("FAL", "finishing allowance along the contour", "mm"),
            p!("FF1", "feed of roughing", "mm/rev"),
            p!("FF2", "feed of plunging into relief cuts", "mm/rev"),
            p!("FF3", "feed of finishing", "mm/rev"),
            p!("VARI", "1 to 12: direction, side, roughing, finishing"),
            p!("DT", "dwell for chip breaking", "s"),
            p!("DAM", "path after which a roughing cut is interrupted", "mm"),
            p!("_VRT", "lift from the contour", "mm"),
        ],
        PGZ,
    ),
    // Its 34 parameters end with more that no source of this table explains.
    recognized(
        "CYCLE952",
        "contour turning and grooving",
        &[
            p!("_PRG", "program of the generated cuts (text)"),
            p!("_CON", "contour (text)"),
            p!("_CONR", "contour of the blank (text)"),
            p!("_VARI", "digits: kind of machining"),
            p!("_F", "feed", "mm/rev"),
            p!("_FR", "feed of plunging", "mm/rev"),
        ],
        ONE,
    ),
];

pub(super) const SWIVEL: [CycleSignature; 1] = [recognized(
    "CYCLE800",
    "swivel plane",
    &[
        p!("_FR", "retraction before: 0 none, 1 Z, 2 Z then XY, 4 along the tool, 5 by _FR_I"),
        p!("_TC", "name of the swivel data (text)"),
        p!("_ST", "ones 0 new, 1 additive"),
        p!("_MODE", "bits: kind and order of the angles"),
        p!("_X0", "reference point before the rotation, X", "mm"),
        p!("_Y0", "reference point before the rotation, Y", "mm"),
        p!("_Z0", "reference point before the rotation, Z", "mm"),
        p!("_A", "first angle", "degrees"),
        p!("_B", "second angle", "degrees"),
        p!("_C", "third angle", "degrees"),
        p!("_X1", "zero after the rotation, X", "mm"),
        p!("_Y1", "zero after the rotation, Y", "mm"),
        p!("_Z1", "zero after the rotation, Z", "mm"),
        p!("_DIR", "direction of the rotary axis: -1, 0 no swivelling, 1"),
        p!("_FR_I", "incremental retraction along the tool", "mm"),
        p!("_DMODE", "digits: plane and display"),
    ],
    ONE,
)];

/// A path mode rather than a cycle: the interpreter says what it does.
pub(super) const HIGH_SPEED: [CycleSignature; 1] = [recognized(
    "CYCLE832",
    "high-speed settings",
    &[
        p!("S_TOL", "tolerance of the contour", "mm"),
        p!(
            "S_TOLM",
            "0 off, 1 finish, 2 semifinish, 3 rough; plus 10 with a tolerance of orientation"
        ),
        p!("S_OTOL", "tolerance of the orientation", "degrees"),
    ],
    ONE,
)];
