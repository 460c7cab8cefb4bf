//! Programs of controls with an ISG kernel, which many woodworking and laser machines have.

use super::NotRead;
use crate::recognition::{RecognitionEvidence, RecognitionSign, TextForm, evidence};
use chordal_machine::ControlName;

pub(super) const ISG: NotRead = NotRead {
    name: "isg",
    what: "a program for an ISG kernel",
    why: "programs of ISG kernels are not read yet",
    signs: SIGNS,
    needed: 7,
    own: &[],
    needs_own: false,
    shown_on: ControlName::Fanuc,
};

const SIGNS: &[RecognitionEvidence] = &[
    evidence(RecognitionSign::Comment(&["ISG", "ISG-STUTTGART"]), 4, "a comment names ISG"),
    evidence(
        RecognitionSign::Begins(&[
            "$IF ",
            "$ELSE",
            "$ENDIF",
            "$WHILE ",
            "$ENDWHILE",
            "$FOR ",
            "$ENDFOR",
            "$GOTO ",
            "$SWITCH ",
            "$CASE ",
            "$ENDSWITCH",
            "$DO",
        ]),
        8,
        "statements begin with $, as $IF",
    ),
    evidence(
        RecognitionSign::Line(&["#VAR", "#ENDVAR", "#VAR ", "#ENDVAR "]),
        9,
        "#VAR declares variables",
    ),
    evidence(
        RecognitionSign::Code(&["V.L.", "V.P.", "V.S.", "V.G.", "V.A.", "V.E.", "V.CYC."]),
        8,
        "variables as V.P.NAME",
    ),
    evidence(RecognitionSign::Begins(&["%L "]), 7, "%L heads a subprogram"),
    evidence(
        RecognitionSign::Code(&["L CYCLE [", "L CYCLE[", "LL CYCLE"]),
        10,
        "L CYCLE [NAME=…] calls a cycle",
    ),
    evidence(
        RecognitionSign::Code(&[
            "#COMMENT BEGIN",
            "#COMMENT END",
            "#CONTOUR MODE",
            "#SLOPE [",
            "#HSC [",
            "#HSC ON",
            "#TRAFO O",
            "#CS ON",
            "#MSG ",
            "#TIME ",
            "#FLUSH",
        ]),
        6,
        "commands begin with #, as #CONTOUR MODE",
    ),
    evidence(RecognitionSign::Form(TextForm::OWord), -8, "O words are flow control"),
    evidence(RecognitionSign::Form(TextForm::MacroStatement), -6, "variables are numbered"),
];
