//! The words of the language and what they do, for editors, and those that a program may use as they are.

use crate::cycles::CYCLES;

/// Words and their meaning in one line.
const WORDS: &[(&str, &str)] = &[
    ("G0", "rapid"),
    ("G1", "straight cut"),
    ("G2", "arc clockwise"),
    ("G3", "arc counterclockwise"),
    ("G4", "dwell: F seconds, S revolutions of the spindle"),
    ("G9", "exact stop in this block"),
    ("G17", "plane XY"),
    ("G18", "plane ZX"),
    ("G19", "plane YZ"),
    ("G40", "tool radius compensation off"),
    ("G41", "tool radius compensation left of the contour"),
    ("G42", "tool radius compensation right of the contour"),
    ("G53", "without settable and programmable frame, this block"),
    ("G54", "first settable work offset"),
    ("G55", "second settable work offset"),
    ("G56", "third settable work offset"),
    ("G57", "fourth settable work offset"),
    ("G60", "exact stop"),
    ("G64", "continuous path"),
    ("G70", "inch, for lengths"),
    ("G71", "millimetres, for lengths"),
    ("G90", "coordinates"),
    ("G91", "distances"),
    ("G94", "feed per minute"),
    ("G95", "feed per revolution"),
    ("G96", "constant cutting speed, feed per revolution"),
    ("G97", "constant spindle speed"),
    ("G110", "pole from the last position"),
    ("G111", "pole from the workpiece zero"),
    ("G112", "pole from the last pole"),
    ("G153", "without all frames, this block"),
    ("G450", "arc round outside corners"),
    ("G451", "intersection at outside corners"),
    ("G500", "no settable work offset"),
    ("G601", "exact stop fine"),
    ("G602", "exact stop coarse"),
    ("G603", "exact stop when the interpolation ends"),
    ("G641", "continuous path, corners rounded within ADIS"),
    ("G642", "continuous path, corners rounded within the axes' tolerance"),
    ("G700", "inch, for lengths and feeds"),
    ("G710", "millimetres, for lengths and feeds"),
    ("M0", "stop"),
    ("M1", "optional stop"),
    ("M2", "end of the program"),
    ("M3", "spindle clockwise"),
    ("M4", "spindle counterclockwise"),
    ("M5", "spindle stop"),
    ("M6", "tool change"),
    ("M7", "mist"),
    ("M8", "flood"),
    ("M9", "coolant off"),
    ("M17", "end of the subprogram"),
    ("M19", "spindle oriented"),
    ("M30", "end of the program"),
    ("TRANS", "shift, replaces the programmable frame"),
    ("ATRANS", "shift, added to the programmable frame"),
    ("ROT", "rotation, replaces the programmable frame"),
    ("AROT", "rotation, added to the programmable frame"),
    ("SCALE", "scale factors, replace the programmable frame"),
    ("ASCALE", "scale factors, added to the programmable frame"),
    ("MIRROR", "mirror, replaces the programmable frame"),
    ("AMIRROR", "mirror, added to the programmable frame"),
    ("SUPA", "without frames and shifts, this block"),
    ("CR", "radius of the arc; negative for more than half a circle"),
    ("AR", "angle of the arc"),
    ("TURN", "full circles in addition to the arc"),
    ("CIP", "arc through a point between"),
    ("CT", "arc tangent to the move before"),
    ("AP", "polar angle"),
    ("RP", "polar radius"),
    ("CHF", "length of the chamfer"),
    ("CHR", "legs of the chamfer"),
    ("RND", "radius of the rounding"),
    ("RNDM", "radius of the rounding, modal"),
    ("AC", "this value is a coordinate"),
    ("IC", "this value is a distance"),
    ("DC", "rotary axis on the short way"),
    ("NORM", "compensation begins perpendicular to the contour"),
    ("KONT", "compensation begins round the start of the contour"),
    ("MCALL", "calls a cycle after each move"),
    ("MSG", "shows a text"),
    ("STOPRE", "stops reading ahead"),
    ("IF", "a condition"),
    ("ELSE", "the other branch"),
    ("ENDIF", "the end of the branches"),
    ("FOR", "a counted loop"),
    ("WHILE", "a loop with its condition at the start"),
    ("REPEAT", "a loop with its condition at the end, or a part again"),
    ("UNTIL", "the end of a REPEAT"),
    ("LOOP", "a loop without end"),
    ("GOTOF", "jump towards the end"),
    ("GOTOB", "jump towards the start"),
    ("GOTO", "jump to a label"),
    ("CASE", "jump by a value"),
    ("DEF", "defines variables"),
    ("PROC", "head of a program with parameters"),
    ("RET", "return"),
    ("DIAMON", "X is a diameter"),
    ("DIAMOF", "X is a radius"),
];

/// Names without a value that change neither the path nor the position.
const WITHOUT_PATH: &[&str] = &[
    "NORM",
    "CFC",
    "CFTCP",
    "CFIN",
    "SOFT",
    "BRISK",
    "DRIVE",
    "FFWON",
    "FFWOF",
    "COMPOF",
    "COMPON",
    "COMPCURV",
    "COMPCAD",
    "COMPSURF",
    "CDON",
    "CDOF",
    "CDOF2",
    "TRAFOOF",
    "STOPRE",
    "DIAMOF",
    "ORIWKS",
    "ORIMKS",
    "ORIAXES",
    "ORIVECT",
    "ORIEULER",
    "ORIRPY",
    "UPATH",
    "SPATH",
    "FIFOCTRL",
    "DYNNORM",
    "DYNPOS",
    "DYNROUGH",
    "DYNSEMIFIN",
    "DYNFINISH",
    "FENDNORM",
    "FNORM",
    "FLIN",
    "FCUB",
    "FPO",
    "FGREF",
    "RTLIOF",
    "RTLION",
    "BLSYNC",
    "CUT2D",
    "CUT2DF",
    "DISPLOF",
    "DISPLON",
    "SBLOF",
    "SBLON",
    "WALIMON",
    "WALIMOF",
    "SPOS",
    "SPOF",
    "SPCOF",
    "GROUP_END",
    "GROUP_BEGIN",
    "CPRECON",
    "CPRECOF",
    "FGROUP",
    "SAVE",
    "ENDPROC",
    "FXS",
    "STARTFIFO",
    "STOPFIFO",
];

/// Names without a value that act on the path or the position.
const WITH_EFFECT: &[&str] = &[
    "TRANS", "ATRANS", "ROT", "AROT", "SCALE", "ASCALE", "MIRROR", "AMIRROR", "SUPA", "CIP", "CT",
    "KONT", "KONTC", "KONTT", "RET", "DIAMON", "DIAM90", "ASPLINE", "BSPLINE", "CSPLINE", "POLY",
    "INVCW", "INVCCW", "TRAORI", "G58", "G59",
];

/// Names of calls that change neither the path nor the position.
pub const IGNORED_CALLS: &[&str] = &[
    "MSG",
    "STOPRE",
    "WAITM",
    "WAITMC",
    "WAITE",
    "INIT",
    "START",
    "SETINT",
    "CLRINT",
    "WRITE",
    "DELETE",
    "WORKPIECE",
    "GROUP_BEGIN",
    "GROUP_END",
    "SETMS",
    "FGROUP",
    "CYCLE832",
    "GETT",
    "NEWCONF",
    "DRIVE",
    "ORIRESET",
    "CPROT",
    "EXTOPEN",
    "EXTCLOSE",
    "CANCEL",
    "LOCK",
    "UNLOCK",
    "RESET",
    "MMC",
    "STOPREOF",
    "ENABLE",
    "DISABLE",
    "CANCELSUB",
    "WAITP",
    "RELEASE",
    "GETD",
];

/// Whether a name without a value is a word of the language.
pub fn is_known_name(name: &str) -> bool {
    WITHOUT_PATH.contains(&name) || WITH_EFFECT.contains(&name)
}

/// The names without a value that are words of the language, and those that editors explain.
pub fn known_names() -> impl Iterator<Item = &'static str> {
    let words = WORDS.iter().map(|(word, _)| *word);
    WITHOUT_PATH.iter().chain(WITH_EFFECT).chain(IGNORED_CALLS).copied().chain(words)
}

/// The words and what they do.
pub fn words() -> impl Iterator<Item = (&'static str, &'static str)> {
    WORDS.iter().copied()
}

/// What a word does, in one line; `None` for words that are not listed.
pub fn meaning_of(word: &str) -> Option<String> {
    let bare = word.split(['=', '(']).next().unwrap_or(word).trim();
    let code = match bare.strip_prefix(['G', 'M']) {
        Some(number) => number.trim_start_matches('0'),
        None => "",
    };
    let code = if code.is_empty() && bare.len() > 1 && bare.ends_with('0') { "0" } else { code };
    let name = match bare.chars().next() {
        Some(letter @ ('G' | 'M'))
            if code.bytes().all(|byte| byte.is_ascii_digit()) && !code.is_empty() =>
        {
            format!("{letter}{code}")
        }
        _ => bare.to_string(),
    };
    let word = WORDS
        .iter()
        .find(|(own, _)| *own == name)
        .map(|(own, meaning)| format!("{own}: {meaning}"));
    let cycle = || CYCLES.iter().find(|cycle| cycle.name == name);
    word.or_else(|| {
        let cycle = cycle()?;
        let names: Vec<&str> = cycle.parameters.iter().map(|parameter| parameter.name).collect();
        Some(format!("{}({}): {}", cycle.name, names.join(", "), cycle.title))
    })
}
