//! Names of threads as people write them.

use super::Thread;
use super::class::{self, Class};
use super::pipe::{self, PipeSize};
use super::series::{Series, coarse};
use crate::error::CalcError;
use crate::mill::Hand;
use crate::numbers::{Units, trimmed};

/// What kind of thread a name means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// 60°, inches (ASME B1.1).
    Unified,
    /// 60°, millimetres (ISO 68-1).
    Metric,
    /// 60°, taper 1:16 (ASME B1.20.1).
    Npt,
    /// The same, sealed by its crests and roots (ASME B1.20.3).
    Nptf,
    /// 55°, parallel pipe thread (ISO 228-1), BSPP.
    G,
    /// 55°, taper 1:16 (ISO 7-1), BSPT.
    R,
}

/// What a thread's name says: `M30x2-6g`, `1 1/16-28 UN-2A LH`, `G 1/2`.
#[derive(Clone, Debug, PartialEq)]
pub struct Designation {
    /// Nominal diameter, mm; outside diameter of the pipe for NPT.
    pub major: f64,
    /// Pitch, mm.
    pub pitch: f64,
    /// The unit it is named in.
    pub units: Units,
    /// Its profile and taper.
    pub form: Form,
    /// The classes of fit in the name: none, one, or one outside and one inside.
    pub classes: Vec<Class>,
    /// LH or RH, where the name says it.
    pub hand: Option<Hand>,
    /// What to know about the name: another series, or a number that was left out.
    pub notes: Vec<String>,
    pub(super) pipe: Option<&'static PipeSize>,
}

impl Designation {
    /// Reads a name, in capital or small letters: `M` diameter `x` pitch in millimetres, inches `-`
    /// threads per inch, or a pipe thread by its size; then series, classes and `LH`.
    ///
    /// # Errors
    /// When it is no thread, or names a class or a pitch that does not exist.
    pub fn read(text: &str) -> Result<Designation, CalcError> {
        let words = words(text).ok_or_else(|| no_thread(text))?;
        let mut name = match words.first().map(|word| word.to_ascii_uppercase()).as_deref() {
            None => return Err(no_thread(text)),
            Some("MJ") => return Err(unknown_form(text, "MJ threads (ISO 5855)")),
            _ if pipe::form(&words).is_some() => return pipe::read(text, &words),
            Some("M") => metric(text, &words[1..])?,
            Some(_) => inch(text, &words)?,
        };
        let size = |value: f64| value > 0.0 && value.is_finite();
        if !size(name.major) || !size(name.pitch) {
            return Err(no_thread(text));
        }
        name.classes.sort_by_key(|class| class.place() == super::Where::Inside);
        Ok(name)
    }

    /// The thread with so many starts, for what needs the 60° profile.
    ///
    /// # Errors
    /// When it is a pipe thread.
    pub fn thread(&self, starts: u32) -> Result<Thread, CalcError> {
        let Designation { major, pitch, .. } = *self;
        match self.form {
            Form::Unified | Form::Metric => Ok(Thread { major, pitch, starts }),
            Form::G => Err(CalcError::new(
                "a G thread has the 55° profile; programs are written for 60° threads",
                "calc thread gives its sizes",
            )),
            Form::Npt | Form::Nptf | Form::R => Err(CalcError::new(
                "a pipe thread with a taper of 1:16 needs a path that becomes wider with every turn; \
                 programs are written for parallel threads",
                "calc thread gives its sizes",
            )),
        }
    }

    pub(super) fn new(major: f64, pitch: f64, units: Units, form: Form) -> Designation {
        Designation {
            major,
            pitch,
            units,
            form,
            classes: Vec::new(),
            hand: None,
            notes: Vec::new(),
            pipe: None,
        }
    }
}

pub(super) fn no_thread(text: &str) -> CalcError {
    CalcError::new(
        format!("`{text}` is not a thread"),
        "write it like M30x2, 1.5-8, 1 1/16-28, #10-24, 1/2 NPT or G 1/2; inch threads need the threads \
         per inch",
    )
}

fn unknown_form(text: &str, form: &str) -> CalcError {
    CalcError::new(
        format!("`{text}`: {form} have a special root, which Chordal does not calculate"),
        "give M, UN, NPT, G or R",
    )
}

/// The words of a name: separators go, `M20` and `G1/2` become two. `None` when a separator has
/// nothing on one side.
fn words(text: &str) -> Option<Vec<String>> {
    let plain = plain(text);
    let tight: String = plain.split_whitespace().collect();
    let separator = |c: char| matches!(c, '-' | 'x' | 'X');
    let letters = tight.trim_start_matches(|c: char| c.is_ascii_alphabetic() && !separator(c));
    let doubled =
        tight.chars().zip(tight.chars().skip(1)).any(|(a, b)| separator(a) && separator(b));
    if tight.is_empty()
        || tight.starts_with(separator)
        || tight.ends_with(separator)
        || letters.starts_with(separator)
        || doubled
    {
        return None;
    }
    let mut words = Vec::new();
    for word in plain.split(|c: char| c.is_whitespace() || separator(c)) {
        let lead = word.find(|c: char| !c.is_ascii_alphabetic() && c != '#').unwrap_or(word.len());
        let (letters, rest) = word.split_at(lead);
        words.extend([letters, rest].into_iter().filter(|part| !part.is_empty()).map(String::from));
    }
    Some(words)
}

/// The signs that people use, as one: inch marks go, a decimal comma is a point, `No.` is `#`.
fn plain(text: &str) -> String {
    let signs: Vec<char> = text.trim().chars().collect();
    let digit = |at: Option<&char>| at.is_some_and(char::is_ascii_digit);
    let mut plain = String::new();
    for (at, sign) in signs.iter().enumerate() {
        plain.push(match sign {
            '×' | '*' => 'x',
            '–' | '—' | '−' => '-',
            '"' | '″' | '“' | '”' | ';' => ' ',
            ',' if at > 0 && digit(signs.get(at - 1)) && digit(signs.get(at + 1)) => '.',
            ',' => ' ',
            other => *other,
        });
    }
    for number in ["No.", "NO.", "no.", "Nr.", "NR.", "nr."] {
        if let Some(rest) = plain.strip_prefix(number) {
            return format!("#{rest}");
        }
    }
    match plain.get(..2) {
        Some(lead) if lead.eq_ignore_ascii_case("no") => format!("#{}", &plain[2..]),
        _ => plain,
    }
}

fn metric(text: &str, words: &[String]) -> Result<Designation, CalcError> {
    let (first, mut rest) = words.split_first().ok_or_else(|| no_thread(text))?;
    let major = number(first).ok_or_else(|| no_thread(text))?;
    let mut notes = Vec::new();
    let pitch = match rest.first().and_then(|word| number(word)) {
        Some(pitch) => {
            rest = &rest[1..];
            pitch
        }
        None => {
            let pitch = coarse(major).ok_or_else(|| {
                CalcError::new(
                    format!("`{text}` has no pitch, and ISO 261 has no coarse pitch for M{first}"),
                    format!("write the pitch: M{first}x1.5"),
                )
            })?;
            notes.push(format!("M{first} without a pitch is M{first}x{pitch}, coarse (ISO 261)."));
            pitch
        }
    };
    let mut name = Designation::new(major, pitch, Units::Millimetre, Form::Metric);
    name.notes = notes;
    for word in rest {
        if hand(&mut name, word)? {
            continue;
        }
        for part in word.split('/') {
            let class = class::metric(part)
                .ok_or_else(|| unknown(part, "metric", class::METRIC, "a hand is LH or RH"))?;
            class::add(&mut name.classes, class)?;
            name.notes.extend(doubtful_case(text, part));
        }
    }
    Ok(name)
}

/// A name in one case may have lost the difference of 6g and 6G, or of 6h and 6H.
fn doubtful_case(text: &str, class: &str) -> Option<String> {
    let small = |text: &str| text.chars().any(|c| c.is_ascii_lowercase());
    let capital = text.chars().any(|c| c.is_ascii_uppercase());
    if class.contains('G') && !small(text) {
        let other = class.to_ascii_lowercase();
        return Some(format!(
            "{class} is for inside threads; outside is {other}, with a small letter."
        ));
    }
    if class.contains('h') && !capital {
        let other = class.to_ascii_uppercase();
        return Some(format!(
            "{class} is for outside threads; inside is {other}, with a capital letter."
        ));
    }
    None
}

fn inch(text: &str, words: &[String]) -> Result<Designation, CalcError> {
    let wrong = || no_thread(text);
    let marked = words[0] == "#";
    let words = if marked { &words[1..] } else { words };
    let (size, used) = diameter(words).ok_or_else(wrong)?;
    let (threads, tail) =
        words.get(used).and_then(|word| leading_number(word)).ok_or_else(wrong)?;
    let tpi = number(threads).filter(|tpi| *tpi > 0.0).ok_or_else(wrong)?;
    let rest: Vec<&str> = std::iter::once(tail)
        .chain(words[used + 1..].iter().map(String::as_str))
        .flat_map(after_letters)
        .filter(|word| !word.is_empty())
        .collect();

    let mut notes = Vec::new();
    let by_number = marked || (used == 1 && means_number(&words[0], tpi));
    let inches = if by_number { numbered(text, size)? } else { size };
    if by_number && !marked {
        notes.push(format!(
            "{} is read as number {}: {} in.",
            words[0],
            words[0],
            trimmed(inches, 3)
        ));
    }
    let mut name = Designation::new(inches * 25.4, 25.4 / tpi, Units::Inch, Form::Unified);
    name.notes = notes;
    inch_rest(&mut name, &rest, inches, tpi)?;
    Ok(name)
}

/// Series, classes and hand after the threads per inch.
fn inch_rest(
    name: &mut Designation,
    rest: &[&str],
    inches: f64,
    tpi: f64,
) -> Result<(), CalcError> {
    let mut constant = None;
    for word in rest {
        let upper = word.to_ascii_uppercase();
        if upper == "TPI" || hand(name, &upper)? {
            continue;
        }
        if upper.starts_with("UNJ") {
            return Err(unknown_form(&upper, "UNJ threads (ASME B1.15)"));
        }
        // `8-UN`: the number before the series.
        if let Some(own) = number(&upper) {
            constant = Some(own);
            continue;
        }
        let letters = upper.trim_start_matches(|c: char| c.is_ascii_digit() || c == '.');
        if let Some(series) = Series::read(letters) {
            let own = number(&upper[..upper.len() - letters.len()]).or(constant.take());
            if own.is_some_and(|own| (own - tpi).abs() > 1e-9) {
                return Err(CalcError::new(
                    format!(
                        "{letters} has {} threads per inch, but the thread has {tpi}",
                        trimmed(own.unwrap_or(0.0), 3)
                    ),
                    "give one pitch",
                ));
            }
            name.notes.extend(series.misnamed(inches, tpi));
            continue;
        }
        for part in upper.split('/') {
            let class = class::unified(part).ok_or_else(|| {
                unknown(
                    part,
                    "unified",
                    class::UNIFIED,
                    "a series is UNC, UNF, UNEF, UN or UNS, a hand LH or RH",
                )
            })?;
            class::add(&mut name.classes, class)?;
        }
    }
    match constant {
        Some(own) => Err(unknown(
            &trimmed(own, 3),
            "unified",
            class::UNIFIED,
            "a series is UNC, UNF, UNEF, UN or UNS, a hand LH or RH",
        )),
        None => Ok(()),
    }
}

/// A word that is no class: what begins with a digit was meant as one.
fn unknown(word: &str, kind: &str, classes: &str, others: &str) -> CalcError {
    let what = if word.starts_with(|c: char| c.is_ascii_digit()) {
        format!("`{word}` is not a class of a {kind} thread")
    } else {
        format!("`{word}` is not part of the name of a {kind} thread")
    };
    CalcError::new(what, format!("the classes are {classes}; {others}"))
}

/// Takes LH or RH; true when the word was one.
pub(super) fn hand(name: &mut Designation, word: &str) -> Result<bool, CalcError> {
    let own = match word.to_ascii_uppercase().as_str() {
        "LH" | "LEFT" => Hand::Left,
        "RH" | "RIGHT" => Hand::Right,
        "HAND" if name.hand.is_some() => return Ok(true),
        _ => return Ok(false),
    };
    if name.hand.is_some_and(|other| other != own) {
        return Err(CalcError::new(
            "a thread cannot be both left and right hand",
            "give one of LH and RH",
        ));
    }
    name.hand = Some(own);
    Ok(true)
}

/// A diameter and how many words it takes: `1.5`, `3/8`, or `1` with `1/16`.
pub(super) fn diameter(words: &[String]) -> Option<(f64, usize)> {
    let first = fraction(words.first()?)?;
    let whole = words[0].bytes().all(|byte| byte.is_ascii_digit());
    match words.get(1) {
        Some(next) if whole && next.contains('/') => match fraction(next) {
            Some(part) => Some((first + part, 2)),
            None => Some((first, 1)),
        },
        _ => Some((first, 1)),
    }
}

/// `5` or `3/8`.
fn fraction(word: &str) -> Option<f64> {
    match word.split_once('/') {
        Some((above, below)) => {
            let below = number(below)?;
            if below > 0.0 { Some(number(above)? / below) } else { None }
        }
        None => number(word),
    }
}

pub(super) fn number(text: &str) -> Option<f64> {
    let digits = text.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    if text.is_empty() || !digits {
        return None;
    }
    text.parse().ok().filter(|value: &f64| value.is_finite())
}

/// `20UNC`: the number, and the letters when a series can begin with them.
fn leading_number(word: &str) -> Option<(&str, &str)> {
    let end = word.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(word.len());
    let (number, tail) = word.split_at(end);
    let series = tail.is_empty() || tail.starts_with(['U', 'u', 'N', 'n', 'T', 't']);
    (series && !number.is_empty()).then_some((number, tail))
}

/// `UNC2A` is two words; a word that begins with a digit is one.
fn after_letters(word: &str) -> [&str; 2] {
    let letters = word.find(|c: char| c.is_ascii_digit()).unwrap_or(word.len());
    let (letters, rest) = word.split_at(letters);
    [letters, rest]
}

/// True when a whole number is the number of a screw, not inches: the standard series have no thread so
/// fine on so many inches, where the screws have it.
fn means_number(word: &str, tpi: f64) -> bool {
    match word {
        "0" => true,
        "1" | "2" | "3" | "4" => tpi >= 36.0,
        "5" | "6" | "8" | "10" | "12" => tpi >= 24.0,
        _ => false,
    }
}

/// The diameter of a screw's number, in: 0.060 and 0.013 for each (ASME B1.1).
fn numbered(text: &str, number: f64) -> Result<f64, CalcError> {
    if number.fract() == 0.0 && (0.0..=12.0).contains(&number) {
        // Whole thousandths, so that #10 is 0.19 to the last digit.
        return Ok((60.0 + 13.0 * number) / 1000.0);
    }
    Err(CalcError::new(
        format!("`{text}`: there is no screw size number {number}"),
        "the numbers go from 0 to 12; larger threads are named by inches",
    ))
}
