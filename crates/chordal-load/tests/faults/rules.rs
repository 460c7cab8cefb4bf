//! How faults are planted in a line. Each gives the line with the fault, or nothing where the line has no place
//! for it or it would be no fault there.

use super::{Line, Part, Word};

type Planted = Option<String>;

pub fn same_line(_: &Part, line: &Line) -> Option<usize> {
    Some(line.number)
}

fn axis(line: &Line) -> Option<&Word> {
    b"XYZ".iter().find_map(|letter| line.word(*letter))
}

/// A line that only moves: its axis words are places.
fn moves(line: &Line) -> bool {
    let special = [
        "4", "10", "28", "29", "30", "31", "38.2", "43", "50", "51", "52", "53", "65", "66", "68",
        "92",
    ];
    (line.done.rapid || line.done.cuts) && line.g(&special).is_none() && line.m(&["98"]).is_none()
}

fn last_number(word: &Word) -> String {
    word.value.trim_start_matches(['-', '+']).into()
}

// Slips of the fingers.

pub fn letter_o(_: &Part, line: &Line) -> Planted {
    let word = line.words.iter().find(|word| {
        b"XYZF".contains(&word.letter) && last_number(word).len() > 1 && word.value.contains('0')
    })?;
    let new = word.value.replacen('0', "O", 1);
    moves(line).then(|| line.with(word, &format!("{}{new}", word.letter as char)))
}

pub fn word_twice(_: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|_| moves(line))?;
    line.and(&format!(" {}1.5", word.letter as char))
}

pub fn bare_axis(part: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|_| moves(line))?;
    // `X R1` takes the number of a register there.
    if part.control == "fadal" && line.word(b'R').is_some() {
        return None;
    }
    Some(line.with(word, &format!("{} ", word.letter as char)))
}

pub fn two_points(_: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|word| moves(line) && word.value.contains('.'))?;
    Some(line.with(word, &format!("{}{}.5", word.letter as char, word.value)))
}

pub fn comma(_: &Part, line: &Line) -> Planted {
    let fraction = |word: &&Word| {
        word.value.split_once('.').is_some_and(|(whole, rest)| {
            whole.ends_with(|digit: char| digit.is_ascii_digit()) && !rest.is_empty()
        })
    };
    let word = axis(line).filter(|_| moves(line)).filter(fraction)?;
    Some(line.with(word, &format!("{}{}", word.letter as char, word.value.replace('.', ","))))
}

pub fn lost_letter(_: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|_| moves(line))?;
    // After another word its number would be a part of that one.
    let before = line.text[..word.range.start].trim_end_matches(' ');
    let apart = before.len() < word.range.start;
    apart.then(|| line.with(word, &word.value))
}

pub fn open_comment(_: &Part, line: &Line) -> Planted {
    let code = line.text.trim_end();
    // What a semicolon begins is a comment to the end of the line, with or without a parenthesis.
    let opens = code.split(';').next().is_some_and(|own| own.contains('('));
    (code.ends_with(')') && opens && code.matches('(').count() == 1 && !line.words.is_empty())
        .then(|| code[..code.len() - 1].into())
}

pub fn lost_point(part: &Part, line: &Line) -> Planted {
    let words = line.words.iter().filter(|word| b"XY".contains(&word.letter));
    // With G16 they may be angles, which have no least increment of length.
    let polar = part.lines.iter().any(|line| line.g(&["16"]).is_some());
    // Where a program has no points at all, the number is meant as it stands.
    let before = part.lines[..line.number - 1].iter().rev();
    let mut before = before.take_while(|line| line.word(b'O').is_none());
    let points = before.any(|line| line.words.iter().any(|word| word.value.contains('.')));
    let mut whole = words.filter(|word| {
        word.value.strip_suffix('.').is_some_and(|rest| rest.trim_start_matches('-') != "0")
    });
    let word = whole.next().filter(|_| moves(line) && points && !polar)?;
    Some(
        line.with(word, &format!("{}{}", word.letter as char, &word.value[..word.value.len() - 1])),
    )
}

// Codes.

pub fn unknown_g(_: &Part, line: &Line) -> Planted {
    let word = line.g(&["0", "1", "2", "3", "17", "54", "90"])?;
    Some(line.with(word, "G223"))
}

pub fn unknown_m(_: &Part, line: &Line) -> Planted {
    let word = line.m(&["3", "5", "8", "9"])?;
    Some(line.with(word, "M477"))
}

pub fn two_motions(_: &Part, line: &Line) -> Planted {
    let word = line.g(&["0", "1"]).filter(|_| moves(line))?;
    Some(line.with(word, "G0 G1"))
}

pub fn two_offsets(_: &Part, line: &Line) -> Planted {
    let word = line.g(&["54", "55", "56"])?;
    Some(line.with(word, "G54 G55"))
}

// Arcs.

/// An arc in XY with centre words, that ends elsewhere than it begins.
fn arc_of_xy(line: &Line) -> bool {
    let known = line.done.arc && !line.done.cycle && line.word(b'R').is_none();
    let centre =
        line.word(b'I').is_some() && line.word(b'J').is_some() && line.word(b'K').is_none();
    known && centre && line.word(b'P').is_none()
}

/// The line before in the program with the same end: a full circle.
fn is_full_circle(part: &Part, line: &Line) -> bool {
    let value =
        |line: &Line, letter| line.word(letter).and_then(|word| word.value.parse::<f64>().ok());
    let before = |letter| {
        let lines = part.lines[..line.number - 1].iter().rev();
        lines.filter(|line| line.done.ran).find_map(|line| value(line, letter))
    };
    let same = |letter| value(line, letter).is_none_or(|end| before(letter) == Some(end));
    same(b'X') && same(b'Y')
}

/// Along X and along Y: one of them goes away from the centre.
pub fn arc_end(_: &Part, line: &Line) -> Planted {
    let (x, y) = (line.word(b'X')?, line.word(b'Y')?);
    let (x_end, y_end): (f64, f64) = (x.value.parse().ok()?, y.value.parse().ok()?);
    if !arc_of_xy(line) || x.range.end > y.range.start {
        return None;
    }
    let (x_new, y_new) = (x_end + 0.35, y_end + 0.2);
    let text = line.with(y, &format!("Y{y_new:.3}"));
    Some(format!("{}X{x_new:.3}{}", &text[..x.range.start], &text[x.range.end..]))
}

pub fn short_radius(part: &Part, line: &Line) -> Planted {
    if !arc_of_xy(line) || is_full_circle(part, line) || line.done.incremental {
        return None;
    }
    let text = line.with(line.word(b'I')?, "R.01");
    let at = text.find(&line.text[line.word(b'J')?.range.clone()])?;
    let length = line.word(b'J')?.range.len();
    Some(format!("{}{}", &text[..at], &text[at + length..]))
}

pub fn no_centre(part: &Part, line: &Line) -> Planted {
    if !arc_of_xy(line) || is_full_circle(part, line) {
        return None;
    }
    let text = line.without(line.word(b'J')?);
    let range = line.word(b'I')?.range.clone();
    Some(format!("{}{}", &text[..range.start], &text[range.end..]))
}

pub fn other_plane(_: &Part, line: &Line) -> Planted {
    let word = line.word(b'J').filter(|_| arc_of_xy(line))?;
    // K0 is what the control assumes.
    let value: f64 = word.value.parse().ok()?;
    (value != 0.0).then(|| line.with(word, &format!("K{}", word.value)))
}

// Cutter compensation.

/// The program never compensates: a first G41 can be planted.
fn compensates(part: &Part) -> bool {
    part.lines.iter().any(|line| line.done.compensated || line.g(&["41", "42"]).is_some())
}

pub fn starts_in_arc(part: &Part, line: &Line) -> Planted {
    (arc_of_xy(line) && !compensates(part)).then(|| line.and(" G41 D1"))?
}

pub fn no_d(part: &Part, line: &Line) -> Planted {
    let first = part.lines.iter().find(|line| line.word(b'D').is_some())?;
    let word = line.word(b'D').filter(|_| line.number == first.number)?;
    line.g(&["41", "42"])?;
    Some(line.without(word))
}

pub fn no_g40(_: &Part, line: &Line) -> Planted {
    let word = line.g(&["40"])?;
    // Not those of the first line, where nothing is on.
    line.g(&["17", "80", "49", "99", "91.1"]).is_none().then(|| line.without(word))
}

/// The first line after it that returns in X or Y, changes the tool or ends.
pub fn end_of_compensation(part: &Part, line: &Line) -> Option<usize> {
    let ends = |line: &&Line| {
        let plane = line.word(b'X').is_some() || line.word(b'Y').is_some();
        line.g(&["28"]).is_some() && plane || line.m(&["2", "6", "30"]).is_some()
    };
    part.lines[line.number..].iter().find(ends).map(|line| line.number)
}

pub fn other_length(_: &Part, line: &Line) -> Planted {
    line.g(&["43"]).filter(|_| line.done.tool != 0)?;
    let word = line.word(b'H')?;
    let number: u32 = word.value.parse().ok()?;
    Some(line.with(word, &format!("H{}", number + 1)))
}

// Feed and spindle.

pub fn no_feed(part: &Part, line: &Line) -> Planted {
    let first = part.lines.iter().find(|line| line.word(b'F').is_some())?;
    // Blocks that may be deleted have one, too; that of a tap is its speed there.
    let deleted = part.lines[..line.number].iter().any(|line| line.text.starts_with('/'));
    let speed = part.control == "fadal" && line.g(&["84", "84.1"]).is_some();
    let computes = |line: &Line| line.text.contains(['#', '=']) && line.text.contains('F');
    let macros = part.lines.iter().any(computes);
    if deleted || speed || macros {
        return None;
    }
    let word = line.word(b'F').filter(|_| line.number == first.number && line.done.cuts)?;
    Some(line.without(word))
}

pub fn zero_feed(_: &Part, line: &Line) -> Planted {
    let word = line.word(b'F').filter(|_| line.done.cuts)?;
    Some(line.with(word, "F0"))
}

pub fn no_spindle(part: &Part, line: &Line) -> Planted {
    let starts = |line: &&Line| line.m(&["3", "4"]).is_some();
    let first = part.lines.iter().find(starts)?;
    let word = line.m(&["3", "4"]).filter(|_| line.number == first.number)?;
    Some(line.without(word))
}

/// The first line after it that cuts.
pub fn first_cut(part: &Part, line: &Line) -> Option<usize> {
    let lines = &part.lines[line.number - 1..];
    // Another start of the spindle comes first: the fault is mended there.
    let next = lines[1..].iter().find(|line| line.m(&["3", "4", "6"]).is_some());
    let cut = lines.iter().find(|line| line.done.cuts)?;
    // Rigid tapping turns the spindle itself.
    let codes = ["G74", "G84", "G33.1"];
    let until = lines.iter().take_while(|line| line.number <= cut.number);
    let taps = until.flat_map(|line| codes.map(|code| line.text.contains(code))).any(|tap| tap);
    (!taps && next.is_none_or(|next| cut.number < next.number)).then_some(cut.number)
}

/// Between two arcs at the same depth below zero: a rapid beside the part has corners.
pub fn rapid_cut(part: &Part, line: &Line) -> Planted {
    let word = line.g(&["1"]).filter(|_| line.done.cuts && !line.done.incremental)?;
    let level = line.done.place[2];
    let arc = |number: usize| {
        let line = part.lines.get(number - 1)?;
        (line.done.arc && !line.done.cycle && line.done.place[2] == level).then_some(line)
    };
    arc(line.number - 1)?;
    arc(line.number + 1)?.g(&["2", "3"])?;
    (level < 0.0 && line.word(b'Z').is_none()).then(|| line.with(word, "G0"))
}

// Cycles.

fn starts_cycle(line: &Line) -> bool {
    let cycles = ["73", "74", "76", "81", "82", "83", "84", "85", "86", "87", "88", "89"];
    line.g(&cycles).is_some()
}

/// The first cycle of the program: nothing is kept from another one.
fn first_cycle(part: &Part, line: &Line) -> bool {
    let first = part.lines.iter().find(|line| starts_cycle(line));
    first.is_some_and(|first| first.number == line.number) && line.done.cycle
}

pub fn cycle_no_r(part: &Part, line: &Line) -> Planted {
    let word = line.word(b'R').filter(|_| first_cycle(part, line))?;
    Some(line.without(word))
}

pub fn cycle_no_z(part: &Part, line: &Line) -> Planted {
    let word = line.word(b'Z').filter(|_| first_cycle(part, line))?;
    Some(line.without(word))
}

pub fn cycle_no_q(part: &Part, line: &Line) -> Planted {
    line.g(&["73", "83"])?;
    let word = line.word(b'Q').filter(|_| first_cycle(part, line))?;
    Some(line.without(word))
}

pub fn cycle_r_below(_: &Part, line: &Line) -> Planted {
    let word = line.word(b'R').filter(|_| starts_cycle(line) && line.done.cycle)?;
    line.word(b'Z').filter(|depth| depth.value.starts_with('-'))?;
    Some(line.with(word, "R-90."))
}

// Programs.

pub fn lost_program(_: &Part, line: &Line) -> Planted {
    let call = line.m(&["97", "98"]).is_some() || line.g(&["65"]).is_some();
    let word = line.word(b'P').filter(|_| call)?;
    Some(line.with(word, "P7654"))
}

pub fn call_without_number(_: &Part, line: &Line) -> Planted {
    let call = line.m(&["97", "98"]).is_some() || line.g(&["65"]).is_some();
    let word = line.word(b'P').filter(|_| call)?;
    Some(line.without(word))
}

pub fn no_end(part: &Part, line: &Line) -> Planted {
    let word = line.m(&["2", "30"])?;
    let after = &part.lines[line.number..];
    // A percent sign may end a program there.
    let by_percent =
        part.control.starts_with("linuxcnc") && after.iter().any(|line| line.text.contains('%'));
    let more = after.iter().any(|line| !line.words.is_empty());
    (!more && !by_percent).then(|| line.without(word))
}

/// The percent sign after it, or the last line with words.
pub fn last_line(part: &Part, line: &Line) -> Option<usize> {
    let after = part.lines[line.number..].iter().find(|line| line.text.trim() == "%");
    let words = |own: &&Line| {
        let left = own.number != line.number || own.text.trim_end().len() > 3;
        !own.text.trim().is_empty() && left
    };
    let last = || part.lines[..line.number].iter().rev().find(words);
    after.or_else(last).map(|line| line.number)
}

// Macros.

fn is_macro(line: &Line) -> bool {
    line.words.is_empty() && line.done.ran && !line.text.trim_start().starts_with(['(', ';', '%'])
}

pub fn lost_label(_: &Part, line: &Line) -> Planted {
    let at = line.text.find("GOTO").filter(|_| line.done.ran && !line.text.contains("IF"))?;
    let rest = &line.text[at + 4..];
    let digits = rest.trim_start().chars().take_while(char::is_ascii_digit).count();
    (digits > 0).then(|| format!("{}GOTO 7654", &line.text[..at]))
}

pub fn open_bracket(_: &Part, line: &Line) -> Planted {
    let code = line.text.split('(').next()?;
    let at = code.rfind(']').filter(|_| is_macro(line))?;
    Some(format!("{}{}", &line.text[..at], &line.text[at + 1..]))
}

pub fn division_by_zero(part: &Part, line: &Line) -> Planted {
    let code = line.text.split(['(', ';']).next()?.trim_end();
    let (target, value) = code.split_once('=').filter(|_| is_macro(line))?;
    if target.contains(['I', 'W']) || value.contains("GOTO") || value.trim().is_empty() {
        return None;
    }
    let (open, close) = if part.control == "fadal" { ('(', ')') } else { ('[', ']') };
    let divided = format!("{open}{}{close}/0", value.trim());
    Some(match part.control {
        // Operators stand in brackets there.
        "linuxcnc" | "linuxcnc-lathe" | "fluidnc" | "mach3" => format!("{target}=[{divided}]"),
        _ => format!("{target}={divided}"),
    })
}

pub fn open_loop(_: &Part, line: &Line) -> Planted {
    let code = line.text.trim();
    let digits = code.strip_prefix("END")?;
    digits.parse::<u32>().ok().map(|_| "(END)".into())
}

/// The WHILE of the loop that ends there.
pub fn loop_head(part: &Part, line: &Line) -> Option<usize> {
    let number = line.text.trim().strip_prefix("END")?;
    let head = format!("DO{number}");
    let mut before = part.lines[..line.number].iter().rev();
    before.find(|line| line.text.trim_end().ends_with(&head)).map(|line| line.number)
}

pub fn bad_variable(_: &Part, line: &Line) -> Planted {
    let at = line.text.find('#').filter(|_| is_macro(line))?;
    let rest = &line.text[at + 1..];
    let digits = rest.chars().take_while(char::is_ascii_digit).count();
    let assigns = rest[digits..].trim_start().starts_with('=');
    (at == 0 && digits > 0 && assigns).then(|| format!("#99999{}", &rest[digits..]))
}
