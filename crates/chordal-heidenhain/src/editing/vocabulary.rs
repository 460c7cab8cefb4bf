//! The words of the language and what they do, for editors.

/// Words with their meaning, in one line each.
pub const VOCABULARY: &[(&str, &str)] = &[
    ("L", "straight line to the coordinates"),
    ("LP", "straight line to a polar point: radius PR and angle PA about CC"),
    ("CC", "centre of circles and pole of polar coordinates; it moves nothing"),
    ("CP", "arc about CC by its angle; with Z a helix"),
    ("CR", "arc by its radius R: positive for less than half a circle"),
    ("CT", "arc that goes on in the direction of the element before"),
    ("CTP", "the same to a polar point"),
    ("RND", "rounds the corner between the elements before and after"),
    ("CHF", "chamfers the corner between two lines by this length on each"),
    ("APPR", "approaches a contour: LT, LN, CT or LCT"),
    ("DEP", "departs from a contour: LT, LN, CT or LCT"),
    ("DR", "direction of an arc: + counter-clockwise, - clockwise"),
    ("RL", "the tool is to the left of the contour"),
    ("RR", "the tool is to the right of the contour"),
    ("FMAX", "rapid, in this block"),
    ("FAUTO", "the feed of TOOL CALL"),
    ("TOOL", "TOOL CALL changes the tool, TOOL DEF gives its data"),
    ("LBL", "a label: of a subprogram, which LBL 0 ends, or of a part that is repeated"),
    ("CALL", "calls a label (CALL LBL) or a program (CALL PGM)"),
    ("REP", "how often the part before is run again"),
    ("CYCL", "CYCL DEF defines a cycle, CYCL CALL runs it"),
    ("SEL", "SEL TABLE names the datum table for cycle 7 and TRANS DATUM TABLE"),
    (
        "TRANS",
        "TRANS DATUM shifts the datum: AXIS by values, TABLE by a line of a table; RESET ends it",
    ),
    ("TABLINE", "the line of the datum table"),
    ("BLK", "BLK FORM: the blank"),
    ("FN", "calculates, compares, jumps or asks the control"),
    ("STOP", "the program waits"),
    ("PGM", "BEGIN PGM and END PGM enclose a program, CALL PGM runs another"),
    ("Q", "a parameter"),
    ("QL", "a parameter of this program alone"),
    ("QR", "a parameter that is kept when the control is switched off"),
    ("QS", "a text parameter"),
    ("PR", "polar radius about CC"),
    ("PA", "polar angle about CC"),
    ("IPA", "polar angle from the last one"),
    ("LEN", "length of a straight approach or departure"),
    ("CCA", "angle of the arc of an approach or departure"),
];

/// What a word does; `None` if it is not listed.
pub fn meaning_of(word: &str) -> Option<&'static str> {
    VOCABULARY.iter().find(|(own, _)| *own == word).map(|(_, meaning)| *meaning)
}
