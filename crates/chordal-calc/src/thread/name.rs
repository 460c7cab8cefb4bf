//! Names of threads as people write them.

use super::class;
use super::designation::{ThreadDesignation, ThreadForm, no_thread};
use super::pipe;
use super::series::{UnifiedSeries, coarse};
use super::words::{after_letters, diameter, leading_number, number, words};
use crate::error::CalcError;
use crate::numbers::{AnswerUnit, trimmed};

impl ThreadDesignation {
    /// Reads a name, in capital or small letters: `M` diameter `x` pitch in millimetres, inches `-`
    /// threads per inch, or a pipe thread by its size; then series, classes and `LH`.
    ///
    /// # Errors
    /// When it is no thread, or names a class or a pitch that does not exist.
    pub fn read(text: &str) -> Result<ThreadDesignation, CalcError> {
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
        name.classes.sort_by_key(|class| class.place() == super::ThreadLocation::Inside);
        Ok(name)
    }
}

fn unknown_form(text: &str, form: &str) -> CalcError {
    CalcError::new(
        format!("`{text}`: {form} have a special root, which Chordal does not calculate"),
        "give M, UN, NPT, G or R",
    )
}

fn metric(text: &str, words: &[String]) -> Result<ThreadDesignation, CalcError> {
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
    let mut name = ThreadDesignation::new(major, pitch, AnswerUnit::Millimetre, ThreadForm::Metric);
    name.notes = notes;
    for word in rest {
        if name.take_hand(word)? {
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

fn inch(text: &str, words: &[String]) -> Result<ThreadDesignation, CalcError> {
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
    let mut name =
        ThreadDesignation::new(inches * 25.4, 25.4 / tpi, AnswerUnit::Inch, ThreadForm::Unified);
    name.notes = notes;
    inch_rest(&mut name, &rest, inches, tpi)?;
    Ok(name)
}

/// Series, classes and hand after the threads per inch.
fn inch_rest(
    name: &mut ThreadDesignation,
    rest: &[&str],
    inches: f64,
    tpi: f64,
) -> Result<(), CalcError> {
    let mut constant = None;
    for word in rest {
        let upper = word.to_ascii_uppercase();
        if upper == "TPI" || name.take_hand(&upper)? {
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
        if let Some(series) = UnifiedSeries::read(letters) {
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
