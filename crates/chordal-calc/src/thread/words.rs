//! The words of a thread's name, and the numbers in them.

/// The words of a name: separators go, `M20` and `G1/2` become two. `None` when a separator has
/// nothing on one side.
pub(super) fn words(text: &str) -> Option<Vec<String>> {
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
pub(super) fn leading_number(word: &str) -> Option<(&str, &str)> {
    let end = word.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(word.len());
    let (number, tail) = word.split_at(end);
    let series = tail.is_empty() || tail.starts_with(['U', 'u', 'N', 'n', 'T', 't']);
    (series && !number.is_empty()).then_some((number, tail))
}

/// `UNC2A` is two words; a word that begins with a digit is one.
pub(super) fn after_letters(word: &str) -> [&str; 2] {
    let letters = word.find(|c: char| c.is_ascii_digit()).unwrap_or(word.len());
    let (letters, rest) = word.split_at(letters);
    [letters, rest]
}
