//! What distinguishes programs of lathes from those of mills. The weights were measured on 1,102 files, 261 of them
//! for lathes: with a sum of five as the limit, one program of a lathe is missed and none of 246 mill programs is
//! taken for one.

use crate::recognition::{MachineKind, RecognitionEvidence, RecognitionSign, TextForm, evidence};

/// The sum of weights from which on a program is for a lathe.
const NEEDED: i32 = 5;

/// The signs of lathes in general.
pub(crate) const LATHE: MachineKind = MachineKind { turns: true, signs: SIGNS, needed: NEEDED };

/// The signs of a lathe with LinuxCNC, whose programs have M6, G43 and G17, which on other controls only mill
/// programs have.
pub(crate) const LINUXCNC_LATHE: MachineKind =
    MachineKind { turns: true, signs: LINUXCNC_SIGNS, needed: 6 };

const LINUXCNC_SIGNS: &[RecognitionEvidence] = &[
    evidence(
        RecognitionSign::Letters { used: "XZ", unused: "Y", least: 2 },
        4,
        "X and Z, and never Y",
    ),
    evidence(RecognitionSign::Block("G76 P I J K"), 5, "G76 with P, I, J and K cuts a thread"),
    evidence(RecognitionSign::Block("G70..72 Q !P !X"), 5, "G70 to G72 with Q"),
    evidence(RecognitionSign::Block("G71.1|G71.2|G72.1|G72.2 Q"), 5, "G71.1 roughs"),
    evidence(RecognitionSign::Block("G7 !X !Y"), 4, "G7 programs diameters"),
    evidence(RecognitionSign::Block("G33 Z K"), 3, "G33 cuts a thread"),
    evidence(RecognitionSign::Block("G96 D S"), 3, "G96 D limits the spindle speed"),
    evidence(RecognitionSign::Block("G8 !X !Y"), 2, "G8 programs radii"),
    evidence(RecognitionSign::Block("G95"), 1, "G95 is feed per revolution"),
    evidence(RecognitionSign::Block("G18"), 1, "G18 is the plane of a lathe"),
    evidence(RecognitionSign::Comment(INSERTS), 2, "a comment names turning tools"),
    evidence(RecognitionSign::Comment(CUTTERS), -2, "a comment names milling cutters"),
    evidence(
        RecognitionSign::Share { of: "X Y", among: "X", percent: (21, 100) },
        -4,
        "moves in X and Y",
    ),
    // Words that LinuxCNC does not read.
    evidence(RecognitionSign::Block("U|W !G65 !G66"), -20, "U and W are increments"),
    evidence(RecognitionSign::Block("G50 S"), -20, "G50 S limits the spindle speed"),
    evidence(RecognitionSign::Block("G71..73 P Q"), -20, "G71 with P and Q"),
    evidence(RecognitionSign::Block("T:3-6 !M6"), -12, "T chooses tool and offset"),
];

pub(crate) const MODELS: &[&str] = &[
    "ST-10", "ST-15", "ST-20", "ST-25", "ST-30", "ST-35", "ST-20Y", "ST-10Y", "ST-30Y", "DS-30",
    "DS-30Y", "SL-10", "SL-20", "SL-30", "TL-1", "TL-2", "CL-1", "ST10", "ST20", "ST30", "SL20",
];

pub(crate) const BUILDERS: &[&str] = &[
    "PUMA", "LYNX", "NAKAMURA", "MORI", "TSUGAMI", "CITIZEN", "MIYANO", "STAR", "HARDINGE",
    "GANESH", "TAKISAWA", "VIPER",
];

const INSERTS: &[&str] = &[
    "CNMG",
    "DNMG",
    "VNMG",
    "WNMG",
    "TNMG",
    "CCMT",
    "DCMT",
    "VBMT",
    "TCMT",
    "CNMP",
    "BORING BAR",
    "TURNING",
    "TURN",
    "OD TURN",
    "CHUCK",
    "ROUGH TURN",
    "FINISH TURN",
    "OD ROUGH",
    "OD FINISH",
    "CUT OFF",
    "CUTOFF",
    "PART OFF",
    "PARTING",
    "SOFT JAWS",
    "BAR PULL",
    "BAR FEED",
    "GROOVING",
    "OD GROOVE",
    "LATHE",
    "TURRET",
    "TAILSTOCK",
    "80 DEG",
    "55 DEG",
    "35 DEG",
];

const CUTTERS: &[&str] = &[
    "END MILL",
    "ENDMILL",
    "FACE MILL",
    "FACEMILL",
    "BALL MILL",
    "BALL NOSE",
    "BALLNOSE",
    "BULL NOSE",
    "CHAMFER MILL",
    "FLAT END",
    "EM",
    "BULL MILL",
    "SHELL MILL",
];

const SIGNS: &[RecognitionEvidence] = &[
    evidence(
        RecognitionSign::Letters { used: "XZ", unused: "Y", least: 2 },
        4,
        "X and Z, and never Y",
    ),
    evidence(RecognitionSign::Block("G50 S"), 4, "G50 S limits the spindle speed"),
    evidence(RecognitionSign::Block("G92 S"), 3, "G92 S limits the spindle speed"),
    evidence(RecognitionSign::Block("G28|G30 U|W"), 4, "G28 with U or W"),
    evidence(RecognitionSign::Block("G70..73 P Q !Z !R"), 4, "G70 to G73 with P and Q"),
    evidence(RecognitionSign::Block("G71..73 U|W R"), 4, "G71 to G73 with U or W, and R"),
    evidence(
        RecognitionSign::Share { of: "F<1", among: "F", percent: (60, 100) },
        3,
        "feeds are per revolution",
    ),
    evidence(RecognitionSign::Block("G96 S"), 3, "G96 keeps the cutting speed"),
    evidence(RecognitionSign::Block("G74|G75 R !X !Y !Z"), 3, "G74 and G75 peck and groove"),
    evidence(RecognitionSign::Block("G74|G75 X P"), 3, "G74 and G75 peck and groove"),
    evidence(RecognitionSign::Block("G74|G75 X I"), 3, "G74 and G75 peck and groove"),
    evidence(RecognitionSign::Block("G32 Z F"), 3, "G32 cuts a thread"),
    evidence(RecognitionSign::Block("G92 X F !Y"), 3, "G92 cuts a thread"),
    evidence(RecognitionSign::Block("G76 P:6"), 3, "G76 cuts a thread"),
    evidence(RecognitionSign::Block("G76 X K !Y"), 3, "G76 cuts a thread"),
    evidence(
        RecognitionSign::Block("U|W !G4 !G10 !G28 !G30 !G65 !G66 !G70..73 !M98 !G92 !G50 !G52"),
        2,
        "U and W are increments",
    ),
    evidence(RecognitionSign::Block("T:3-6 !M6"), 2, "T chooses tool and offset"),
    evidence(
        RecognitionSign::Block("G99 !G73 !G74 !G76 !G81..89"),
        2,
        "G99 is feed per revolution",
    ),
    evidence(
        RecognitionSign::Block("G98 !G73 !G74 !G76 !G81..89 !G80 !G90"),
        1,
        "G98 is feed per minute",
    ),
    evidence(RecognitionSign::Comment(MODELS), 3, "a comment names a lathe"),
    evidence(
        RecognitionSign::Comment(&["PUMA", "LYNX", "NAKAMURA", "TSUGAMI", "MIYANO"]),
        3,
        "a comment names a lathe",
    ),
    evidence(RecognitionSign::Comment(INSERTS), 2, "a comment names turning tools"),
    evidence(RecognitionSign::Block("G97"), 1, "G97 keeps the spindle speed"),
    evidence(RecognitionSign::Block("G18"), 1, "G18 is the plane of a lathe"),
    evidence(RecognitionSign::Block("G41|G42 !D !H !P"), 1, "G41 without D"),
    evidence(
        RecognitionSign::Letters { used: "K", unused: "J", least: 1 },
        1,
        "arcs with K, never J",
    ),
    evidence(
        RecognitionSign::Share { of: "X Y", among: "X", percent: (21, 100) },
        -4,
        "moves in X and Y",
    ),
    evidence(RecognitionSign::Block("G43"), -4, "G43 applies the tool length"),
    evidence(RecognitionSign::Block("G17"), -3, "G17 is the plane of a mill"),
    evidence(RecognitionSign::Block("G41|G42 D"), -3, "G41 with D"),
    evidence(
        RecognitionSign::Share { of: "F>0.999", among: "F", percent: (100, 100) },
        -2,
        "feeds are per minute",
    ),
    evidence(RecognitionSign::Comment(CUTTERS), -2, "a comment names milling cutters"),
    evidence(RecognitionSign::Block("M6"), -1, "M6 changes the tool"),
    // LinuxCNC turns in X and Z too; its lathe programs have signs of their own.
    evidence(RecognitionSign::Form(TextForm::OWord), -20, "O words are flow control"),
    evidence(RecognitionSign::Form(TextForm::NamedParameter), -20, "variables have names"),
    evidence(RecognitionSign::Block("G64 P"), -12, "G64 P is a tolerance"),
    evidence(RecognitionSign::Block("G7 !X !Y"), -12, "G7 programs diameters"),
    evidence(RecognitionSign::Block("G76 P I J K"), -12, "G76 with P, I, J and K cuts a thread"),
    evidence(RecognitionSign::Block("G96 D"), -12, "G96 D limits the spindle speed"),
    evidence(RecognitionSign::Block("G33.1"), -12, "G33.1 taps"),
    evidence(
        RecognitionSign::Comment(&["LINUXCNC", "EMC2", "PATHPILOT"]),
        -12,
        "a comment names LinuxCNC",
    ),
];
