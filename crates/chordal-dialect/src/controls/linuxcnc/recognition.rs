//! Signs by which programs of LinuxCNC and of controls that read programs as it does are recognized.

use crate::vocabulary::*;

const NAMES: &[&str] =
    &["LINUXCNC", "EMC2", "EMC", "MACHINEKIT", "RS274NGC", "RS274", "PATHPILOT", "TORMACH", "LINUXCNC POST"];

/// Names of machines with PathPilot, which is based on LinuxCNC.
const PATHPILOT: &[&str] = &["PATHPILOT", "TORMACH"];

/// Other controls whose programs LinuxCNC reads best.
const RELATED_CONTROLS: &[&str] = &["MACH4", "MASSO", "PLANETCNC"];

pub(super) const EVIDENCE: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Header(NAMES), 12, "the header names LinuxCNC"),
    evidence(RecognitionSign::Comment(NAMES), 7, "a comment names LinuxCNC"),
    evidence(RecognitionSign::Header(RELATED_CONTROLS), 9, "the header names a control that reads as LinuxCNC"),
    evidence(RecognitionSign::Comment(RELATED_CONTROLS), 6, "a comment names a control that reads as LinuxCNC"),
    evidence(RecognitionSign::Form(TextForm::OWord), 10, "O words are flow control"),
    evidence(RecognitionSign::Form(TextForm::NamedParameter), 10, "variables have names"),
    evidence(RecognitionSign::Code(&["EXISTS["]), 8, "EXISTS asks for a variable"),
    evidence(RecognitionSign::Comment(&["MSG,", "DEBUG,", "PRINT,", "PROBEOPEN", "LOGOPEN", "LOG,"]), 6, "(MSG, …) speaks to the operator"),
    evidence(RecognitionSign::Form(TextForm::SemicolonComments), 1, "comments after semicolons"),
    evidence(RecognitionSign::Block("G64 P"), 6, "G64 P is a tolerance"),
    evidence(RecognitionSign::Block("G38.2|G38.3|G38.4|G38.5"), 4, "G38.2 probes"),
    evidence(RecognitionSign::Block("G90.1"), 5, "G90.1 sets absolute arc centres"),
    evidence(RecognitionSign::Block("G91.1"), 4, "G91.1 sets incremental arc centres"),
    evidence(RecognitionSign::Block("G33.1"), 6, "G33.1 taps"),
    evidence(RecognitionSign::Block("G5.2|G5.3"), 5, "G5.2 cuts a spline"),
    evidence(RecognitionSign::Block("G43 !H !P !X"), 3, "G43 without H takes the tool in the spindle"),
    evidence(RecognitionSign::Block("G92.2|G92.3"), 4, "G92.2 switches an offset off"),
    evidence(RecognitionSign::Block("G59.1|G59.2|G59.3"), 3, "G59.1 to G59.3 choose a work offset"),
    evidence(RecognitionSign::Block("G10 L20|L11|L10"), 1, "G10 L20 sets an offset from here"),
    evidence(RecognitionSign::Block("M64|M65|M66|M67|M68 P|E"), 4, "M64 to M68 are inputs and outputs"),
    evidence(RecognitionSign::Block("M61 Q"), 4, "M61 says the tool number"),
    evidence(RecognitionSign::Block("M70|M72|M73"), 2, "M70 keeps the modes"),
    evidence(RecognitionSign::Block("G28.1|G30.1"), 2, "G28.1 keeps a position"),
    evidence(RecognitionSign::Block("G76 P I J K"), 6, "G76 with P, I, J and K cuts a thread"),
    evidence(RecognitionSign::Block("G96 D"), 4, "G96 D limits the spindle speed"),
    evidence(RecognitionSign::Block("G7 !X !Y"), 4, "G7 programs diameters"),
    evidence(RecognitionSign::Block("M2"), 1, "M2 ends the program"),
    evidence(RecognitionSign::Comment(PATHPILOT), 8, "a comment names PathPilot").on("tormach-pathpilot"),
    evidence(RecognitionSign::Block("G17 G40 G49 G50 G54 G64 G80 G90 G91.1 G94"), 9, "the modes as PathPilot's post writes them")
        .on("tormach-pathpilot"),
    evidence(RecognitionSign::Codes(&["G17G54G40G49G80G90"]), 5, "the modes as FreeCAD's post for LinuxCNC writes them"),
    evidence(RecognitionSign::Comment(&["PYCAM-META-DATA"]), 5, "PyCAM writes for LinuxCNC"),
    evidence(RecognitionSign::Form(TextForm::LengthWithoutTape), 2, "G43 in a text without % and O number"),
];
