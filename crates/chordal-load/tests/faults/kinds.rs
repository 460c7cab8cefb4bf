//! The kinds of faults: how each is planted, what must be reported, and where.

use super::rules::*;
use super::{Line, Part};

/// A kind of fault.
pub struct Kind {
    pub name: &'static str,
    /// The line with the fault in it; nothing where it cannot be planted there, or would be none.
    pub plant: fn(&Part, &Line) -> Option<String>,
    /// The line in which it must be reported.
    pub place: fn(&Part, &Line) -> Option<usize>,
    /// One of these codes.
    pub codes: &'static [&'static str],
    /// Controls on which it is no fault, or another one.
    pub not_on: &'static [&'static str],
    /// It is found where the program is read, whether the line is run or not.
    pub anywhere: bool,
}

const fn kind(
    name: &'static str,
    plant: fn(&Part, &Line) -> Option<String>,
    codes: &'static [&'static str],
) -> Kind {
    Kind { name, plant, place: same_line, codes, not_on: &[], anywhere: false }
}

impl Kind {
    const fn not_on(self, not_on: &'static [&'static str]) -> Kind {
        Kind { not_on, ..self }
    }

    const fn at(self, place: fn(&Part, &Line) -> Option<usize>) -> Kind {
        Kind { place, ..self }
    }
}

/// Their G73 to G76 are other cycles; `turning.rs` has their faults.
const LATHES: &[&str] = &["fanuc-lathe", "haas-lathe", "linuxcnc-lathe", "mitsubishi-lathe"];

/// Many of their machines have a spindle that is switched by hand, and their programs need no end.
const SMALL: &[&str] = &["grbl", "grblhal", "fluidnc", "marlin"];

/// Controls whose programs need no end.
const NO_END: &[&str] =
    &["grbl", "grblhal", "fluidnc", "marlin", "sinumerik", "sinumerik-lathe", "heidenhain"];

/// The feed of a hole begins where the tool is.
const NO_R: &[&str] =
    &["fadal", "haas", "fanuc-lathe", "haas-lathe", "linuxcnc-lathe", "mitsubishi-lathe"];

pub const KINDS: &[Kind] = &[
    // Slips of the fingers.
    kind("letter O for zero", letter_o, &["CH103"]),
    kind("a word twice", word_twice, &["CH106"]),
    kind("an axis without its number", bare_axis, &["CH109"]),
    kind("two decimal points", two_points, &["CH101"]),
    kind("comma for the decimal point", comma, &["CH102", "CH105", "CH109"]),
    // With blanks in its numbers, `G0 15.` is G15 there.
    kind("an axis letter lost", lost_letter, &["CH102"]).not_on(&[
        "linuxcnc",
        "linuxcnc-lathe",
        "grbl",
        "grblhal",
        "fluidnc",
        "mach3",
    ]),
    kind("comment not closed", open_comment, &["CH104"]).not_on(&["fadal", "marlin"]),
    kind("decimal point forgotten", lost_point, &["CH305"]).not_on(&[
        "fadal",
        "linuxcnc",
        "linuxcnc-lathe",
        "grbl",
        "grblhal",
        "fluidnc",
        "mach3",
        "marlin",
    ]),
    // Codes.
    kind("unknown G code", unknown_g, &["CH301"]),
    // Where M codes are the machine builder's, an unknown one is a note.
    kind("unknown M code", unknown_m, &["CH301"]).not_on(&[
        "fanuc",
        "fanuc-lathe",
        "mitsubishi",
        "mitsubishi-lathe",
        "mach3",
        "sinumerik",
        "sinumerik-lathe",
        "heidenhain",
    ]),
    kind("G0 and G1 in one block", two_motions, &["CH302", "CH307"]),
    kind("G54 and G55 in one block", two_offsets, &["CH302"]).not_on(&["fadal"]),
    // Arcs.
    kind("end of an arc moved", arc_end, &["CH401"]),
    kind("radius that does not reach", short_radius, &["CH402"]),
    kind("neither centre nor radius", no_centre, &["CH405"]),
    kind("centre letter of another plane", other_plane, &["CH404"]),
    // Cutter compensation.
    kind("compensation starts in an arc", starts_in_arc, &["CH501"]).not_on(&[
        "linuxcnc",
        "linuxcnc-lathe",
        "mach3",
        "marlin",
    ]),
    kind("compensation without D", no_d, &["CH503"]).not_on(&["fadal", "linuxcnc", "mach3"]),
    kind("G40 forgotten", no_g40, &["CH505", "CH522", "CH523"]).at(end_of_compensation),
    kind("length of another tool", other_length, &["CH604"]),
    // Feed and spindle.
    kind("no feed", no_feed, &["CH406", "CH745"]),
    kind("feed of zero", zero_feed, &["CH303", "CH406", "CH745", "CH814"]),
    // Many GRBL machines have a spindle that is switched by hand, and its programs need no end.
    kind("spindle not started", no_spindle, &["CH413", "CH814"]).at(first_cut).not_on(SMALL),
    kind("rapid instead of feed in a contour", rapid_cut, &["CH602"]),
    // Cycles.
    // There the feed begins where the tool is.
    kind("cycle without R", cycle_no_r, &["CH800"]).not_on(NO_R),
    kind("cycle without Z", cycle_no_z, &["CH801"]).not_on(LATHES),
    // Without Q a lathe drills in one cut.
    kind("pecks without Q", cycle_no_q, &["CH802"]).not_on(LATHES),
    kind("R below Z", cycle_r_below, &["CH805"]).not_on(LATHES),
    // Programs.
    kind("called program is not there", lost_program, &["CH201", "CH202"]),
    kind("call without its number", call_without_number, &["CH202", "CH308"]),
    // The end of the text is the end of a Sinumerik program, END PGM that of a conversational one.
    kind("no end of program", no_end, &["CH205"]).at(last_line).not_on(NO_END),
    // Macros.
    kind("jump to a number that is not there", lost_label, &["CH202"]),
    kind("bracket not closed", open_bracket, &["CH701", "CH700", "CH704"]),
    // It is planted with square brackets, which conversational programs do not have.
    kind("division by zero", division_by_zero, &["CH707"]).not_on(&["heidenhain"]),
    kind("loop without its end", open_loop, &["CH712"]).at(loop_head),
    kind("variable that there is not", bad_variable, &["CH705"]),
];
