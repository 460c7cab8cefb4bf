//! What stands in the expectations of a suite program.
//!
//! `(= rapid to X1.5 Y-2 | arc ccw radius 2 sweep 90 x3 | ! CH401 "0.1683 in")` on a line
//! lists the motions of that line in order and the diagnostics that point at it. `dwell .5`
//! (seconds), `spindle cw|ccw|off|oriented` and `stop` between the motions are events: a line
//! that names one names all of them, each at its place; elsewhere they are free. A line with
//! `> "X1.5000"` is a line that the program prints. A line with
//! nothing but such a comment goes on with the expectations of the line above.
//!
//! `corner stop`, `corner exact`, `corner round .05` on a motion is the path mode that its control
//! passes the end of the block in: at rest, exactly, or within a distance, which is not there
//! where the control names none.
//!
//! Motions are those of the program; with `(show: path)` at the head they are those of the tool
//! centre, after cutter compensation.
//!
//! Ends, starts and feeds are what the program says, so they are compared exactly (1e-6);
//! centres, radii, sweeps and lengths are computed, so they agree when what is written is the
//! correctly rounded number, of two decimals at least.

use std::collections::BTreeMap;

use chordal::machine::AXIS_LETTERS;

use crate::runner::short;

/// A number and the unit of its last digit: the real one is off by half of it at most.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    pub value: f64,
    pub step: f64,
}

/// Values by axis letter.
pub type Place = BTreeMap<char, Number>;

/// What a motion is expected to be; what is not named is free.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    pub text: String,
    pub kind: String,
    pub ccw: Option<bool>,
    pub from: Place,
    pub to: Place,
    pub center: Place,
    pub plane: Option<String>,
    pub along: Option<String>,
    pub radius: Option<(Number, Number)>,
    pub sweep: Option<Number>,
    pub length: Option<Number>,
    pub feed: Option<Number>,
    pub tangent: Option<Number>,
    /// How corners are passed in its path mode: the word, and the distance (0: none named).
    pub corner: Option<(String, Number)>,
}

/// A diagnostic that must occur on the line.
#[derive(Clone, Debug)]
pub struct Problem {
    pub code: String,
    pub texts: Vec<String>,
}

/// The expectations of one line.
#[derive(Clone, Debug, Default)]
pub struct Line {
    /// `None`: the line's motions are free.
    pub motions: Option<Vec<Motion>>,
    /// Dwells, changes of the spindle and stops, each with the number of the line's motions
    /// before it; none: free.
    pub events: Vec<(usize, String)>,
    pub problems: Vec<Problem>,
    /// What the line prints, in order; `None`: free.
    pub prints: Option<Vec<String>>,
}

/// A suite program: its text, its machine and its expectations.
#[derive(Clone, Debug, Default)]
pub struct Program {
    pub text: String,
    pub machine: String,
    pub set: Vec<String>,
    pub block_delete: bool,
    /// The expectations are of the tool centre, after compensation.
    pub of_path: bool,
    pub units: Option<String>,
    pub same_on: Vec<String>,
    pub total: BTreeMap<String, Number>,
    pub ends_at: Place,
    /// Codes that may occur anywhere, for examples that show a problem.
    pub expect: Vec<String>,
    pub lines: BTreeMap<u32, Line>,
}

/// Reads a program and its expectations.
pub fn read(text: &str) -> Result<Program, String> {
    let mut program = Program { text: text.to_string(), ..Program::default() };
    let mut last = 1;
    for (index, line) in text.lines().enumerate() {
        let number = index as u32 + 1;
        let line = line.trim_start_matches('\r').trim_end_matches([';', ' ', '\t', '\r']);
        let at = |message: String| format!("line {number}: {message}");
        if let Some((before, items)) = line.split_once("(=") {
            let items = items.strip_suffix(')').ok_or_else(|| at("no `)` at the end".into()))?;
            if !before.trim_matches([';', ' ', '\t']).is_empty() {
                last = number;
            }
            read_items(items, program.lines.entry(last).or_default()).map_err(at)?;
        } else {
            // Where parentheses are no comment, a semicolon stands before them.
            if let Some(comment) = line.trim_start_matches([';', ' ']).strip_prefix('(') {
                let comment = comment.strip_suffix(')').unwrap_or(comment);
                read_directive(comment, &mut program).map_err(at)?;
            }
            last = number;
        }
    }
    if program.machine.is_empty() { Err("no `(machine: …)`".into()) } else { Ok(program) }
}

fn read_directive(comment: &str, program: &mut Program) -> Result<(), String> {
    let Some((key, value)) = comment.split_once(": ") else { return Ok(()) };
    let plain = |c: char| c.is_ascii_lowercase() || c == '-' || c == ' ';
    if !key.chars().all(plain) {
        return Ok(());
    }
    let value = value.trim();
    let words = || value.split_whitespace().map(String::from).collect();
    match key {
        "machine" => program.machine = value.into(),
        "set" => program.set.push(value.into()),
        "block-delete" => program.block_delete = one_of(value, &["on", "off"])? == "on",
        "show" => program.of_path = one_of(value, &["commands", "path"])? == "path",
        "units" => program.units = Some(one_of(value, &["inch", "mm"])?),
        "same motion on" => program.same_on = words(),
        "expect" => program.expect = words(),
        "ends at" => program.ends_at = exact(Tokens::of(value).place()?),
        "total" => {
            let mut tokens = Tokens::of(value);
            while let Some(name) = tokens.next() {
                one_of(name, &TOTALS)?;
                program.total.insert(name.into(), tokens.number()?);
            }
        }
        _ => return Err(format!("unknown directive `{key}`")),
    }
    Ok(())
}

const TOTALS: [&str; 9] = [
    "rapids",
    "lines",
    "arcs",
    "helices",
    "spirals",
    "splines",
    "dwells",
    "feed_length",
    "rapid_length",
];

fn one_of(value: &str, allowed: &[&str]) -> Result<String, String> {
    if allowed.contains(&value) {
        return Ok(value.to_string());
    }
    Err(format!("`{value}` is none of {}", allowed.join(", ")))
}

fn read_items(text: &str, line: &mut Line) -> Result<(), String> {
    for item in text.split('|').map(str::trim) {
        if let Some(problem) = item.strip_prefix('!') {
            let mut parts = problem.split('"');
            let code = parts.next().unwrap_or("").trim().to_string();
            if code.len() != 5 || !code.starts_with("CH") {
                return Err(format!("`{code}` is no code of a diagnostic"));
            }
            let texts = parts.step_by(2).filter(|t| !t.is_empty()).map(String::from).collect();
            line.problems.push(Problem { code, texts });
        } else if let Some(printed) = item.strip_prefix('>') {
            let text = printed.trim().strip_prefix('"').and_then(|text| text.strip_suffix('"'));
            let text = text.ok_or_else(|| format!("`{printed}` is no text in quotes"))?;
            line.prints.get_or_insert_default().push(text.to_string());
        } else if item == "none" {
            line.motions.get_or_insert_default();
        } else if let Some(event) = read_event(item)? {
            let motions = line.motions.get_or_insert_default();
            line.events.push((motions.len(), event));
        } else {
            let (motion, times) = read_motion(item)?;
            let motions = line.motions.get_or_insert_default();
            motions.extend(std::iter::repeat_n(motion, times));
        }
    }
    Ok(())
}

/// An item that is no motion, as `runner::event_of` words it.
fn read_event(item: &str) -> Result<Option<String>, String> {
    let mut tokens = Tokens::of(item);
    let event = match tokens.next() {
        Some("dwell") => format!("dwell {}", short(tokens.number()?.value)),
        Some("spindle") => {
            format!("spindle {}", one_of(tokens.word()?, &["cw", "ccw", "off", "oriented"])?)
        }
        Some("stop") => "stop".into(),
        _ => return Ok(None),
    };
    match tokens.next() {
        Some(word) => Err(format!("unknown word `{word}` in `{item}`")),
        None => Ok(Some(event)),
    }
}

fn read_motion(item: &str) -> Result<(Motion, usize), String> {
    let mut tokens = Tokens::of(item);
    let mut motion = Motion { text: item.to_string(), ..Motion::default() };
    let mut times = 1;
    let kind = tokens.next().unwrap_or("");
    motion.kind = one_of(kind, &["rapid", "line", "arc", "helix", "spiral", "spline"])?;
    while let Some(key) = tokens.next() {
        match key {
            "cw" => motion.ccw = Some(false),
            "ccw" => motion.ccw = Some(true),
            "from" => motion.from = exact(tokens.place()?),
            "to" => motion.to = exact(tokens.place()?),
            "center" => motion.center = tokens.place()?,
            "plane" => motion.plane = Some(one_of(tokens.word()?, &["xy", "zx", "yz"])?),
            "along" => motion.along = Some(one_of(tokens.word()?, &["path", "plane"])?),
            "radius" => motion.radius = Some(tokens.range()?),
            "sweep" => motion.sweep = Some(tokens.number()?),
            "length" => motion.length = Some(tokens.number()?),
            "feed" => motion.feed = Some(tokens.number()?.exact()),
            "tangent" => motion.tangent = Some(tokens.number()?),
            "corner" => {
                let word = one_of(tokens.word()?, &["stop", "exact", "round"])?;
                let digit = |w: &&str| w.starts_with(|c: char| c.is_ascii_digit() || c == '.');
                let distance = tokens.words.next_if(digit).unwrap_or("0");
                motion.corner = Some((word, number(distance)?.exact()));
            }
            _ => {
                let count = key.strip_prefix('x').and_then(|count| count.parse().ok());
                times = count.ok_or_else(|| format!("unknown word `{key}` in `{item}`"))?;
            }
        }
    }
    Ok((motion, times))
}

struct Tokens<'a> {
    words: std::iter::Peekable<std::str::SplitWhitespace<'a>>,
}

impl<'a> Tokens<'a> {
    fn of(text: &'a str) -> Tokens<'a> {
        Tokens { words: text.split_whitespace().peekable() }
    }

    fn next(&mut self) -> Option<&'a str> {
        self.words.next()
    }

    fn word(&mut self) -> Result<&'a str, String> {
        self.next().ok_or_else(|| "a word is missing".to_string())
    }

    fn number(&mut self) -> Result<Number, String> {
        number(self.word()?)
    }

    fn range(&mut self) -> Result<(Number, Number), String> {
        let word = self.word()?;
        let (from, to) = word.split_once("..").unwrap_or((word, word));
        Ok((number(from)?, number(to)?))
    }

    fn place(&mut self) -> Result<Place, String> {
        let mut place = Place::new();
        while let Some(word) = self.words.next_if(|w| w.starts_with(|c| AXIS_LETTERS.contains(c))) {
            let (letter, value) = word.split_at(1);
            place.insert(letter.chars().next().unwrap_or('X'), number(value)?);
        }
        if place.is_empty() { Err("no axis words".into()) } else { Ok(place) }
    }
}

fn number(text: &str) -> Result<Number, String> {
    let value = text.parse().map_err(|_| format!("`{text}` is no number"))?;
    // Without decimals a number is meant exactly: `X2` is not 2.3.
    let step = match text.split_once('.') {
        Some((_, decimals)) if !decimals.is_empty() => 10f64.powi(-(decimals.len() as i32)),
        _ => EXACT,
    };
    Ok(Number { value, step: step.clamp(1e-9, 0.01) })
}

/// How far a number may be off that is not computed.
const EXACT: f64 = 1e-6;

impl Number {
    fn exact(self) -> Number {
        Number { step: self.step.min(EXACT), ..self }
    }
}

fn exact(place: Place) -> Place {
    place.into_iter().map(|(letter, number)| (letter, number.exact())).collect()
}
