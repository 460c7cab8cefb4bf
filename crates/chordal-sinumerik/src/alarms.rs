//! The alarms of the control by their number (Diagnostics Manual 03/2013).

/// The number of a problem that is no alarm of the control.
pub const NO_ALARM: u32 = 0;

/// The number and text of an alarm; `None` for numbers that are not listed.
pub fn text_of(alarm: u32) -> Option<&'static str> {
    TEXTS.iter().find(|(number, _)| *number == alarm).map(|(_, text)| *text)
}

/// The number and text of an alarm that is listed, for tables.
pub const fn listed_text(alarm: u32) -> &'static str {
    let mut index = 0;
    while TEXTS[index].0 != alarm {
        index += 1;
    }
    TEXTS[index].1
}

/// Rows of a number, and of the number with its text.
macro_rules! alarm_texts {
    ($($number:literal $text:literal,)*) => {
        &[$(($number, concat!($number, " ", $text))),*]
    };
}

/// What each alarm says, in our own words: the control adds channel and block.
const TEXTS: &[(u32, &str)] = alarm_texts! {
    10720 "programmed end point lies behind the software limit switch",
    10750 "tool radius compensation without tool number",
    10751 "danger of collision in tool radius compensation",
    10753 "tool radius compensation is only switched on in a linear block",
    10754 "tool radius compensation is only switched off in a linear block",
    10762 "too many empty blocks between two moves with tool radius compensation",
    10793 "angle and end point of a straight line contradict each other",
    10795 "end point of a straight line by its angle contradictory",
    10860 "feedrate not programmed",
    10900 "no S value programmed for constant cutting speed",
    12010 "address programmed too often",
    12060 "two G functions of the same group",
    12080 "syntax error",
    12090 "parameter not expected here",
    12110 "block cannot be interpreted",
    12120 "G function not alone in its block",
    12150 "operation and type of data do not fit",
    12340 "too many parameters",
    12400 "field does not exist, or wrong number of indices",
    12430 "size of an array not allowed",
    12470 "unknown G function",
    12550 "name not defined, or option not available",
    12640 "nesting of control structures is wrong",
    14011 "program does not exist or is not released",
    14012 "lowest subprogram level exceeded",
    14013 "number of subprogram passes not allowed",
    14020 "wrong number of parameters",
    14040 "error in the end point of the circle",
    14045 "error in tangential circle",
    14048 "wrong number of revolutions",
    14051 "arithmetic error in the part program",
    14080 "jump target not found",
    14091 "function not allowed here",
    14095 "radius of the circle too small",
    14400 "tool radius compensation active at transformation changeover",
    14401 "transformation not available",
    14200 "polar radius negative",
    14210 "polar angle too large",
    14270 "pole programmed wrongly",
    17020 "array index 1 out of range",
    17030 "array index 2 out of range",
    17180 "D number does not exist",
    17190 "T number not allowed",
    61000 "no tool offset active",
    61001 "lead of the thread defined wrongly",
    61002 "kind of machining programmed wrongly",
    61003 "no feedrate programmed in the cycle",
    61101 "reference plane defined wrongly",
    61184 "no solution possible with the angles that are given",
    61102 "no direction of the spindle programmed",
    61103 "number of holes is zero",
    61104 "slots or elongated holes cut into each other",
    61105 "tool radius too large",
    61106 "number or distance of circle elements",
    61107 "first drilling depth defined wrongly",
    61108 "values of _RAD1 and _DP1 not allowed",
    61109 "_CDIR defined wrongly",
    61110 "finishing allowance at the base larger than the infeed",
    61111 "stepover larger than the diameter of the tool",
    61113 "corner radius _CRAD too large",
    61117 "radius of the active tool is zero or negative",
    61118 "length or width is zero",
    61119 "nominal or core diameter programmed wrongly",
    61120 "internal or external thread not defined",
    61122 "safety distance in the plane defined wrongly",
    61128 "angle of insertion is zero",
    61815 "G40 is not active",
    62100 "no drilling cycle active",
};
