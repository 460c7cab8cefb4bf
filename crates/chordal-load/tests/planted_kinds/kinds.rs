//! The table of kinds: how each is planted, on which controls, and what must be said. An error is what the control alarms
//! for; a warning is what it runs otherwise than the text looks. The table was written before anything was measured, from
//! the manuals and, where none says it, from what the trade knows. Rows that measuring has changed say why in their comment.

use chordal::Severity::{self, Error, Warning};

use super::faults::{Line, Part};
use super::plants::*;

/// A fault in a program.
pub struct Plant {
    /// The line that is replaced, from 1.
    pub line: usize,
    /// The new text; it may be several lines.
    pub new: String,
    /// The line of the new program in which it must be reported.
    pub place: usize,
}

/// What a check must say.
#[derive(Clone, Copy)]
pub struct Expected {
    pub controls: &'static [&'static str],
    /// At least.
    pub severity: Severity,
    /// One of these.
    pub codes: &'static [&'static str],
}

/// A kind of fault.
pub struct Kind {
    pub name: &'static str,
    /// The fault in this line; nothing where it has no place or would be no fault.
    pub plant: fn(&Part, &Line) -> Option<Plant>,
    pub expected: &'static [Expected],
}

const fn kind(
    name: &'static str,
    plant: fn(&Part, &Line) -> Option<Plant>,
    expected: &'static [Expected],
) -> Kind {
    Kind { name, plant, expected }
}

const fn on(
    controls: &'static [&'static str],
    severity: Severity,
    codes: &'static [&'static str],
) -> Expected {
    Expected { controls, severity, codes }
}

const FANUC_ONLY: &[&str] = &["fanuc", "fanuc-lathe"];
/// Mitsubishi's manuals follow Fanuc's in what the kinds below plant.
const FANUC: &[&str] = &["fanuc", "mitsubishi"];
const FANUC_ALL: &[&str] = &["fanuc", "mitsubishi", "fanuc-lathe", "mitsubishi-lathe"];
const HAAS: &[&str] = &["haas"];
const HAAS_ALL: &[&str] = &["haas", "haas-lathe"];
const ISO: &[&str] = &["fanuc", "mitsubishi", "haas"];
const ISO_ALL: &[&str] =
    &["fanuc", "mitsubishi", "haas", "fanuc-lathe", "mitsubishi-lathe", "haas-lathe"];
/// RS274/NGC: LinuxCNC, and Mach3, whose interpreter came from the same source.
const NGC: &[&str] = &["linuxcnc", "linuxcnc-lathe", "mach3"];
const LINUXCNC: &[&str] = &["linuxcnc", "linuxcnc-lathe"];
/// Their firmware judges a block as a whole (CH313).
const FIRMWARE: &[&str] = &["grbl", "grblhal", "fluidnc"];
const MARLIN: &[&str] = &["marlin"];
const FADAL: &[&str] = &["fadal"];
/// Every control but Marlin, whose firmware skips what it cannot read.
const STRICT: &[&str] = &[
    "fadal",
    "fanuc",
    "mitsubishi",
    "haas",
    "fanuc-lathe",
    "mitsubishi-lathe",
    "haas-lathe",
    "linuxcnc",
    "linuxcnc-lathe",
    "mach3",
    "grbl",
    "grblhal",
    "fluidnc",
];
const STRICT_MILLS: &[&str] =
    &["fadal", "fanuc", "mitsubishi", "haas", "linuxcnc", "mach3", "grbl", "grblhal", "fluidnc"];
/// Their spindle turns only by M3 and S; routers of hobbyists often have one with a switch.
const SPINDLES: &[&str] = &["fadal", "fanuc", "mitsubishi", "haas", "linuxcnc", "mach3"];

/// What an unreadable number is: PS0006 and PS0007 of Fanuc, "Bad number format" of LinuxCNC, error 2 of GRBL.
const NUMBER: &[&str] = &["CH101", "CH102", "CH103", "CH105", "CH109", "CH313"];
/// What a sentence between the words is.
const SENTENCE: &[&str] =
    &["CH111", "CH101", "CH102", "CH103", "CH105", "CH106", "CH109", "CH301", "CH313"];
/// What a number outside of its range is: PS0003 and PS0030 of Fanuc, P35 and P170 of Mitsubishi, error 27 and 29.
const RANGE: &[&str] = &["CH303", "CH311", "CH313", "CH740"];
/// What an arc is whose ends lie at different distances from its centre.
const MISMATCH: &[&str] = &["CH401", "CH313"];
/// What an arc is that has no usable centre in its plane.
const CENTER: &[&str] = &["CH401", "CH404", "CH405", "CH412", "CH313"];
const GROUP: &[&str] = &["CH302", "CH307", "CH313"];
/// An unused word is an error of LinuxCNC and error 36 of GRBL; how strict Mach3 is, is not known.
const UNUSED_WORD: &[Expected] = &[
    on(LINUXCNC, Error, UNUSED),
    on(&["mach3"], Warning, UNUSED),
    on(FIRMWARE, Error, UNUSED),
    on(ISO, Warning, UNUSED),
    on(MARLIN, Warning, UNUSED),
];
const UNUSED: &[&str] = &["CH304", "CH313"];
/// A function that the control does not have is CH703 as a macro form that is not there: as right as the others.
const EXPRESSION: &[&str] = &["CH700", "CH703", "CH704"];

pub const KINDS: &[Kind] = &[
    // Slips of the fingers. Marlin reads what it cannot read as 0, or skips it, without a word.
    kind("letter l for one", letter_l, &[on(STRICT, Error, NUMBER), on(MARLIN, Warning, NUMBER)]),
    // LinuxCNC takes a sign before any value (`read_real_value`), so `--5` is 5; for Mach3 nothing says otherwise.
    kind(
        "two signs",
        two_signs,
        &[
            on(ISO_ALL, Error, NUMBER),
            on(FADAL, Error, NUMBER),
            on(FIRMWARE, Error, NUMBER),
            on(MARLIN, Warning, NUMBER),
        ],
    ),
    kind(
        "sign after the number",
        sign_after,
        &[on(STRICT, Error, NUMBER), on(MARLIN, Warning, NUMBER)],
    ),
    kind(
        "dash of a text processor for minus",
        dash,
        &[on(STRICT, Error, NUMBER), on(MARLIN, Warning, NUMBER)],
    ),
    kind(
        "foreign character in a number",
        foreign,
        &[on(STRICT, Error, NUMBER), on(MARLIN, Warning, NUMBER)],
    ),
    kind("sentence without its brackets", bare_sentence, &[on(STRICT, Error, SENTENCE)]),
    // `;` ends the block there, and a new one begins.
    kind("sentence after a semicolon", semicolon, &[on(ISO_ALL, Error, SENTENCE)]),
    // `)` is a bad character in RS274/NGC and error 1 of GRBL; FluidNC drops one that follows no `(`, and so do Fanuc,
    // Haas and Mitsubishi.
    kind(
        "bracket of a comment closed twice",
        closed_twice,
        &[
            on(NGC, Error, &["CH105"]),
            on(&["grbl", "grblhal"], Error, &["CH105", "CH313"]),
            on(ISO_ALL, Warning, &["CH105"]),
        ],
    ),
    kind("bracket of a comment opened twice", opened_twice, &[on(NGC, Error, &["CH110"])]),
    // LinuxCNC and the firmwares refuse the letter (error 20); the alarm lists at hand
    // of the others have nothing for it, so that a warning is enough there.
    kind(
        "axis that a mill does not have",
        axis_v,
        &[
            on(&["linuxcnc"], Error, &["CH309", "CH304"]),
            on(FIRMWARE, Error, &["CH309", "CH304", "CH313"]),
            on(&["fadal", "fanuc", "mitsubishi", "haas", "mach3"], Warning, &["CH309", "CH304"]),
            on(MARLIN, Warning, &["CH309", "CH304"]),
        ],
    ),
    // Numbers.
    // PS0003. The digits of the other controls are in no manual at hand.
    kind("coordinate of nine digits", nine_digits, &[on(FANUC_ONLY, Error, &["CH311"])]),
    kind(
        "block number of nine digits",
        block_number,
        &[on(ISO_ALL, Error, RANGE), on(FADAL, Error, RANGE), on(FIRMWARE, Error, RANGE)],
    ),
    kind(
        "program number of ten digits",
        program_number,
        &[on(ISO_ALL, Error, RANGE), on(FADAL, Error, RANGE)],
    ),
    // PS0030, P170; Haas has 200 (its manual says so of D), Fadal 99.
    kind(
        "length offset that is not there",
        length_number,
        &[on(ISO, Error, RANGE), on(FADAL, Error, RANGE)],
    ),
    kind(
        "radius offset that is not there",
        radius_number,
        &[on(ISO, Error, RANGE), on(FADAL, Error, RANGE)],
    ),
    // Fanuc and Mitsubishi give T to the machine builder; 255 is the last of GRBL and FluidNC.
    kind(
        "tool number beyond the last",
        tool_number,
        &[on(HAAS, Error, RANGE), on(&["grbl"], Error, RANGE)],
    ),
    kind(
        "negative tool number",
        negative_tool,
        &[on(STRICT_MILLS, Error, &["CH101", "CH303", "CH313", "CH740"])],
    ),
    kind(
        "negative feed",
        negative_feed,
        &[
            on(STRICT, Error, &["CH101", "CH303", "CH313", "CH406", "CH740"]),
            on(MARLIN, Warning, &["CH101", "CH303", "CH406", "CH740"]),
        ],
    ),
    kind(
        "speed above that of the spindle",
        high_speed,
        &[on(&["fadal", "fanuc", "mitsubishi", "haas"], Warning, &["CH606"])],
    ),
    // Haas and Fadal alarm; the others run at their largest.
    kind(
        "feed above that of the machine",
        high_feed,
        &[
            on(&["haas", "fadal"], Error, &["CH407"]),
            on(&["fanuc", "mitsubishi"], Warning, &["CH407"]),
        ],
    ),
    kind(
        "point of a feed forgotten to the left",
        low_feed,
        &[on(STRICT_MILLS, Warning, &["CH607"])],
    ),
    // Where no work offset is known the whole program is held against the travel, in the line of its head.
    kind("end far outside of the travel", far_end, &[on(STRICT_MILLS, Error, &["CH601"])]),
    // Codes.
    // Haas has one M code in a block; RS274/NGC and GRBL (error 21) one of a group; Fanuc takes up to three.
    kind(
        "two M codes of the spindle",
        two_m_codes,
        &[
            on(NGC, Error, GROUP),
            on(FIRMWARE, Error, GROUP),
            on(HAAS_ALL, Error, GROUP),
            on(FANUC_ALL, Warning, GROUP),
        ],
    ),
    // "Cannot use two G codes that both use axis values", error 24; Fadal: G92 must be alone.
    kind(
        "two codes that take the axis words",
        two_axis_codes,
        &[on(NGC, Error, GROUP), on(FIRMWARE, Error, GROUP), on(FADAL, Error, GROUP)],
    ),
    // "Must use G0 or G1 with G53", error 30.
    kind(
        "G53 beside an arc",
        arc_with_g53,
        &[
            on(NGC, Error, &["CH302", "CH303", "CH307", "CH308"]),
            on(FIRMWARE, Error, &["CH303", "CH307", "CH313"]),
            on(FADAL, Error, &["CH302", "CH307"]),
        ],
    ),
    // Fadal keeps the direction of the arc before.
    kind("G1 for G2", straight_arc, UNUSED_WORD),
    kind("word without its code", stray_word, UNUSED_WORD),
    kind(
        "dwell without its time",
        dwell_without_time,
        &[on(LINUXCNC, Error, &["CH308", "CH803"]), on(FIRMWARE, Error, &["CH308", "CH313"])],
    ),
    kind(
        "negative dwell",
        negative_dwell,
        &[on(NGC, Error, &["CH303"]), on(FIRMWARE, Error, &["CH303", "CH313"])],
    ),
    // P0 to P6 (Haas P1 to P6, LinuxCNC P0 to P9, Fadal P1 to P48; error 29).
    kind(
        "work offset beyond the last",
        offset_beyond,
        &[
            on(ISO_ALL, Error, RANGE),
            on(LINUXCNC, Error, RANGE),
            on(FIRMWARE, Error, RANGE),
            on(FADAL, Error, RANGE),
        ],
    ),
    // Fanuc has 48 or 300, Mitsubishi up to 300, Haas 99.
    kind("further work offset beyond the last", further_offset, &[on(ISO, Error, RANGE)]),
    kind(
        "inverse time without F",
        inverse_time,
        &[
            on(&["linuxcnc", "mach3", "haas"], Error, &["CH308", "CH406"]),
            on(FIRMWARE, Error, &["CH308", "CH406", "CH313"]),
            on(FANUC, Warning, &["CH308", "CH406"]),
        ],
    ),
    kind(
        "G95 with a feed per minute",
        per_revolution,
        &[on(HAAS, Error, &["CH407"]), on(FANUC, Warning, &["CH407"])],
    ),
    // Arcs. Marlin does not compare the ends.
    kind(
        "centre on the other side",
        other_side,
        &[on(STRICT_MILLS, Error, MISMATCH), on(MARLIN, Warning, MISMATCH)],
    ),
    kind(
        "I and J exchanged",
        exchanged,
        &[on(STRICT_MILLS, Error, MISMATCH), on(MARLIN, Warning, MISMATCH)],
    ),
    kind(
        "centre at the start",
        centre_at_start,
        &[on(STRICT_MILLS, Error, CENTER), on(MARLIN, Warning, CENTER)],
    ),
    // Fanuc does not move, and says nothing.
    kind(
        "full circle by its radius",
        full_by_radius,
        &[
            on(&["fadal", "haas", "mitsubishi", "linuxcnc", "mach3"], Error, &["CH403"]),
            on(FIRMWARE, Error, &["CH403", "CH313"]),
            on(&["fanuc", "marlin"], Warning, &["CH403", "CH405"]),
        ],
    ),
    // "Mixed radius ijk format for arc", error 36; R wins on a Fanuc.
    kind(
        "both centre and radius",
        centre_and_radius,
        &[
            on(NGC, Error, &["CH409"]),
            on(FIRMWARE, Error, &["CH409", "CH313"]),
            on(ISO, Warning, &["CH304", "CH409"]),
        ],
    ),
    kind("G18 for G17", other_plane, &[on(STRICT_MILLS, Error, CENTER)]),
    // Cutter compensation: PS0037, P112, alarm 344, "Cannot change planes with cutter radius compensation on".
    kind(
        "G18 in compensation",
        plane_in_compensation,
        &[on(&["fanuc", "mitsubishi", "haas", "linuxcnc", "fadal"], Error, &["CH504"])],
    ),
    kind(
        "tool change in compensation",
        tool_in_compensation,
        &[on(&["linuxcnc", "fadal"], Error, &["CH523"]), on(ISO, Warning, &["CH523"])],
    ),
    kind("cycle in compensation", cycle_in_compensation, &[on(&["linuxcnc"], Error, &["CH806"])]),
    // Cycles. Fanuc, Haas and Mitsubishi would drill upwards.
    kind(
        "depth without its sign",
        depth_without_sign,
        &[
            on(&["linuxcnc", "mach3", "grblhal", "fadal"], Error, &["CH805", "CH313"]),
            on(ISO, Warning, &["CH805"]),
        ],
    ),
    kind(
        "pecks of zero",
        zero_pecks,
        &[
            on(&["linuxcnc", "mach3", "grblhal", "fanuc"], Error, &["CH802", "CH313"]),
            on(&["haas", "mitsubishi", "fadal"], Warning, &["CH802"]),
        ],
    ),
    // "Dwell time p word missing"; on Mach3 one that is left out is none.
    kind(
        "cycle without its dwell",
        cycle_without_dwell,
        &[on(&["linuxcnc", "grblhal"], Error, &["CH803", "CH313"])],
    ),
    kind("no repeat of a cycle", no_repeat, &[on(&["linuxcnc"], Error, &["CH808"])]),
    // Programs.
    kind("program that calls itself", calls_itself, &[on(ISO_ALL, Error, &["CH203", "CH211"])]),
    kind("two programs of one number", same_number, &[on(ISO_ALL, Warning, &["CH209"])]),
    kind("percent sign in the middle", percent, &[on(ISO_ALL, Warning, &["CH205"])]),
    kind("jump to its own block", own_block, &[on(ISO_ALL, Warning, &["CH204", "CH211"])]),
    // Spindle.
    kind("M5 for M8", stop_for_coolant, &[on(SPINDLES, Warning, &["CH413", "CH814"])]),
    // S stands at zero after power-on; on Mach3 it may be set by hand.
    kind(
        "spindle without a speed",
        no_speed,
        &[on(&["fadal", "fanuc", "mitsubishi", "haas", "linuxcnc"], Warning, &["CH413", "CH814"])],
    ),
    // Corners and frames: PS0055, PS0142, P35.
    kind("rounding larger than its moves", large_rounding, &[on(ISO, Error, &["CH437"])]),
    kind("scale factor of zero", zero_scale, &[on(ISO, Error, &["CH430", "CH435"])]),
    // Macros: PS0119, P282; PS0126 (Mitsubishi has 127 numbers); PS0124; PS0114, PS0125; PS0116; PS0127.
    kind(
        "square root of a negative number",
        negative_root,
        &[on(ISO_ALL, Error, &["CH708"]), on(LINUXCNC, Error, &["CH708"])],
    ),
    kind(
        "function with a wrong name",
        wrong_function,
        &[on(ISO_ALL, Error, EXPRESSION), on(LINUXCNC, Error, EXPRESSION)],
    ),
    kind(
        "loop number four",
        loop_four,
        &[on(&["fanuc", "fanuc-lathe", "haas", "haas-lathe"], Error, &["CH711"])],
    ),
    // In a loop, before its count: the loop never ends.
    kind("END without its DO", end_without_do, &[on(ISO_ALL, Error, &["CH712", "CH211"])]),
    kind("condition without an action", idle_condition, &[on(ISO_ALL, Error, EXPRESSION)]),
    kind(
        "value for #0",
        null_set,
        &[on(ISO_ALL, Error, &["CH705", "CH706"]), on(LINUXCNC, Error, &["CH705", "CH706"])],
    ),
    kind(
        "assignment beside words",
        mixed_block,
        &[on(&["fanuc", "fanuc-lathe"], Error, &["CH715"])],
    ),
    kind("name that was never set", unset_name, &[on(LINUXCNC, Error, &["CH721"])]),
    kind(
        "variable on a control without any",
        variable,
        &[
            on(&["grbl"], Error, &["CH703", "CH105", "CH101", "CH313"]),
            on(MARLIN, Warning, &["CH703", "CH105", "CH301"]),
        ],
    ),
    // Lines: 255 characters of LinuxCNC, 79 to 256 of the firmwares.
    kind(
        "line of 300 digits",
        long_line,
        &[on(LINUXCNC, Error, &["CH140"]), on(FIRMWARE, Error, &["CH140", "CH313"])],
    ),
    // GRBL leaves a slash out; FluidNC keeps it.
    kind(
        "slash in the middle of a block",
        late_slash,
        &[
            on(LINUXCNC, Error, &["CH105", "CH141"]),
            on(&["fluidnc"], Error, &["CH105", "CH141", "CH313"]),
        ],
    ),
];
