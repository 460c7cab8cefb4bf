//! Programs of SINUMERIK 840D and 828D, which `chordal-sinumerik` reads.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const SINUMERIK: NotRead = NotRead {
    name: "sinumerik",
    what: "a program for a Sinumerik",
    why: "",
    signs: SIGNS,
    needed: 7,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Sinumerik,
};

pub(super) const SINUMERIK_LATHE: NotRead = NotRead {
    name: "sinumerik-lathe",
    what: "a lathe program for a Sinumerik",
    own: TURNING_SIGNS,
    needs_own: true,
    shown_on: ControlName::SinumerikLathe,
    ..SINUMERIK
};

/// What only lathes have.
const TURNING_SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Code(&["DIAMON", "DIAM90"]), 10, "DIAMON: X is a diameter"),
    evidence(RecognitionSign::Code(&["LIMS="]), 6, "LIMS= limits the speed of a cutting speed"),
    evidence(
        RecognitionSign::Code(&[
            "CYCLE95(",
            "CYCLE97(",
            "CYCLE93(",
            "CYCLE94(",
            "CYCLE96(",
            "CYCLE98(",
            "CYCLE930(",
            "CYCLE951(",
            "CYCLE952(",
            "CYCLE99(",
        ]),
        10,
        "a turning cycle is called",
    ),
    evidence(
        RecognitionSign::Code(&["=DAC(", "=DIC(", "=RAC(", "=RIC("]),
        8,
        "X=DAC(…) is a diameter",
    ),
];

const NAMES: &[&str] = &["SINUMERIK", "SIEMENS", "840D", "828D", "810D", "SHOPMILL", "840DSL"];

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Code(&["%_N_"]), 20, "%_N_ heads the program"),
    evidence(RecognitionSign::Comment(&["$PATH=/"]), 20, ";$PATH says its folder"),
    evidence(RecognitionSign::Header(NAMES), 10, "the header names a Sinumerik"),
    evidence(RecognitionSign::Comment(NAMES), 7, "a comment names a Sinumerik"),
    evidence(
        RecognitionSign::Code(&["=AC(", "=IC(", "=DC(", "=ACP(", "=ACN("]),
        8,
        "X=AC(…) is one absolute word",
    ),
    evidence(RecognitionSign::Code(&["CR="]), 7, "CR= is a radius"),
    evidence(RecognitionSign::Code(&["TURN="]), 5, "TURN= counts turns"),
    evidence(RecognitionSign::Code(&["MCALL"]), 8, "MCALL calls a cycle at each position"),
    evidence(
        RecognitionSign::Code(&[
            "CYCLE8", "CYCLE7", "CYCLE6", "CYCLE9", "POCKET3(", "POCKET4(", "HOLES1(", "HOLES2(",
            "SLOT1(",
        ]),
        8,
        "a cycle is called by its name",
    ),
    evidence(RecognitionSign::Code(&["GOTOF", "GOTOB"]), 8, "GOTOF and GOTOB jump"),
    evidence(RecognitionSign::Code(&["SUPA"]), 7, "SUPA switches frames off"),
    evidence(RecognitionSign::Code(&["T=\""]), 8, "a tool is called by its name"),
    evidence(RecognitionSign::Code(&["MSG(\"", "MSG (\""]), 8, "MSG(\"…\") speaks to the operator"),
    evidence(
        RecognitionSign::Code(&["DEF REAL", "DEF INT", "DEF BOOL", "DEF STRING", "DEF AXIS"]),
        8,
        "DEF declares a variable",
    ),
    evidence(
        RecognitionSign::Code(&["TRAFOOF", "TRAORI", "TRANSMIT", "TRACYL"]),
        8,
        "TRAORI and TRAFOOF",
    ),
    evidence(
        RecognitionSign::Code(&["WORKPIECE(", "GROUP_BEGIN", "GROUP_END"]),
        8,
        "WORKPIECE(…) and GROUP_BEGIN",
    ),
    evidence(
        RecognitionSign::Code(&[
            "COMPCAD", "COMPOF", "COMPCURV", "FFWON", "FFWOF", "SOFT", "BRISK", "CFTCP", "STOPRE",
            "ORIWKS",
        ]),
        5,
        "words as FFWON and STOPRE",
    ),
    evidence(
        RecognitionSign::Code(&["DIAMON", "DIAMOF", "LIMS=", "SETMS"]),
        7,
        "words as DIAMON and LIMS",
    ),
    evidence(
        RecognitionSign::Code(&[
            "ATRANS", "AROT ", "TRANS X", "TRANS Z", "ROT Z", "ROT RPL", "MIRROR X",
        ]),
        5,
        "TRANS and ROT move the frame",
    ),
    evidence(
        RecognitionSign::Code(&["$TC_DP", "$P_", "$AA_", "$MC_", "$A_"]),
        8,
        "system variables begin with $",
    ),
    evidence(RecognitionSign::Form(TextForm::ParameterIsSet), 4, "R1= sets a parameter"),
    evidence(RecognitionSign::Form(TextForm::EqualsAddress), 3, "words have an equals sign"),
    evidence(RecognitionSign::Code(&["AP=", "RP="]), 6, "AP= and RP= are polar coordinates"),
    evidence(
        RecognitionSign::Code(&["RND=", "RNDM=", "CHF=", "CHR="]),
        6,
        "RND= and CHR= round and chamfer corners",
    ),
    evidence(RecognitionSign::Code(&["ANG=", "AR=", "RPL="]), 5, "ANG= and AR= are angles"),
    evidence(
        RecognitionSign::Code(&["CIP X", "CT X", "GOTOC", "SETAL(", "REPEATB"]),
        6,
        "words as CIP and SETAL",
    ),
    evidence(RecognitionSign::Code(&["SPOS="]), 4, "SPOS= positions the spindle"),
    evidence(RecognitionSign::Block("G700|G710"), 4, "G700 and G710 choose the units"),
    evidence(RecognitionSign::Block("G331|G332"), 4, "G331 and G332 tap"),
    evidence(RecognitionSign::Block("G500|G505..599"), 3, "G500 to G599 choose a work offset"),
    evidence(RecognitionSign::Block("G450|G451"), 4, "G450 and G451 are corners of compensation"),
    evidence(RecognitionSign::Block("G641|G642"), 3, "G642 rounds corners"),
    evidence(RecognitionSign::Form(TextForm::SemicolonComments), 2, "comments after semicolons"),
    evidence(
        RecognitionSign::Code(&["ENDIF", "ENDWHILE", "ENDFOR", "ENDLOOP"]),
        1,
        "ENDIF ends a branch",
    ),
    evidence(RecognitionSign::Form(TextForm::OWord), -20, "O words are flow control"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -4, "variables are numbered"),
];
