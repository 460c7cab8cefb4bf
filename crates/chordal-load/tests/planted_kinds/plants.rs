//! How faults are planted in a line. Each gives the fault, or nothing where the line has no place for it or it would be
//! no fault there.

use super::faults::{Line, Part, Word};
use super::kinds::Plant;

type Planted = Option<Plant>;

/// Positions that differ by less are the same, mm.
const SAME_PLACE_MM: f64 = 0.001;

/// Ends of an arc that differ by more from its radius are refused by every control, mm.
const REFUSED_MM: f64 = 0.6;

/// A cut of this length takes hours at the feed of `low_feed`, mm.
const LONG_CUT_MM: f64 = 10.0;

/// A feed from here on is one per minute, and above what any machine runs per revolution.
const FEED_PER_MINUTE: f64 = 100.0;

/// Where a problem of a whole program is reported, in a file of one program.
const HEAD_LINE: usize = 1;

/// Words of these codes are no places.
const NO_PLACES: &[&str] = &[
    "4", "10", "28", "29", "30", "31", "33", "38.2", "43", "50", "51", "52", "53", "65", "66",
    "68", "76", "92",
];

/// The line is replaced.
fn here(line: &Line, new: String) -> Planted {
    Some(Plant { line: line.number, new, place: line.number })
}

/// A new line stands before it, and the fault in the new one.
fn before(line: &Line, inserted: &str) -> Planted {
    here(line, format!("{inserted}\n{}", line.text))
}

/// A new line stands before it, and the fault in the old one.
fn after_line(line: &Line, inserted: &str) -> Planted {
    let plant = before(line, inserted)?;
    Some(Plant { place: line.number + 1, ..plant })
}

/// A line that only moves, with axis words that are places.
fn moves(line: &Line) -> bool {
    (line.done.rapid || line.done.cuts)
        && !line.done.cycle
        && line.g(NO_PLACES).is_none()
        && line.m(&["6", "97", "98"]).is_none()
}

fn cuts(line: &Line) -> bool {
    moves(line) && line.done.cuts
}

fn axis(line: &Line) -> Option<&Word> {
    b"XYZ".iter().find_map(|letter| line.word(*letter)).filter(|_| moves(line))
}

fn number(line: &Line, letter: u8) -> Option<f64> {
    line.word(letter)?.value.parse().ok()
}

fn digits(word: &Word) -> &str {
    word.value.trim_start_matches(['-', '+'])
}

/// The line carried out before it.
fn previous<'p>(part: &'p Part, line: &Line) -> Option<&'p Line> {
    part.lines[..line.number - 1].iter().rev().find(|line| line.done.ran)
}

/// How far X and Y go in it, mm.
fn way(part: &Part, line: &Line) -> Option<[f64; 2]> {
    let from = previous(part, line)?.done.place;
    Some([line.done.place[0] - from[0], line.done.place[1] - from[1]])
}

// Slips of the fingers.

pub fn letter_l(_: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|word| digits(word).starts_with('1'))?;
    here(
        line,
        line.with(word, &format!("{}{}", word.letter as char, word.value.replacen('1', "l", 1))),
    )
}

pub fn two_signs(_: &Part, line: &Line) -> Planted {
    let word = axis(line)?;
    here(line, line.with(word, &format!("{}--{}", word.letter as char, digits(word))))
}

pub fn sign_after(_: &Part, line: &Line) -> Planted {
    let word = axis(line)?;
    here(line, line.with(word, &format!("{}{}-", word.letter as char, digits(word))))
}

pub fn dash(_: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|word| word.value.starts_with('-'))?;
    here(line, line.with(word, &format!("{}\u{2013}{}", word.letter as char, digits(word))))
}

pub fn foreign(_: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|word| digits(word).len() > 1)?;
    here(line, line.with(word, &format!("{}&", &line.text[word.range.clone()])))
}

/// The text of a line that is a comment of several words, and nothing else.
fn sentence(line: &Line) -> Option<&str> {
    let text = line.text.trim().strip_prefix('(')?.strip_suffix(')')?;
    let words = |text: &str| text.split(' ').filter(|word| word.len() > 2).count() > 1;
    let plain = text.chars().all(|each| each.is_ascii_alphabetic() || each == ' ');
    (plain && words(text)).then_some(text)
}

pub fn bare_sentence(_: &Part, line: &Line) -> Planted {
    here(line, sentence(line)?.into())
}

pub fn semicolon(_: &Part, line: &Line) -> Planted {
    here(line, format!("; {}", sentence(line)?))
}

/// A line with one comment.
fn has_comment(line: &Line) -> bool {
    let one = |bracket| line.text.matches(bracket).count() == 1;
    one('(') && one(')') && line.text.trim_end().ends_with(')') && !line.text.contains(';')
}

pub fn closed_twice(_: &Part, line: &Line) -> Planted {
    has_comment(line).then(|| here(line, format!("{})", line.text.trim_end())))?
}

pub fn opened_twice(_: &Part, line: &Line) -> Planted {
    has_comment(line).then(|| here(line, line.text.replace('(', "((")))?
}

pub fn axis_v(_: &Part, line: &Line) -> Planted {
    axis(line).filter(|_| cuts(line))?;
    here(line, line.and(" V5.")?)
}

// Numbers.

pub fn nine_digits(_: &Part, line: &Line) -> Planted {
    let word = axis(line)?;
    here(line, line.with(word, &format!("{}123456789.", word.letter as char)))
}

pub fn block_number(_: &Part, line: &Line) -> Planted {
    axis(line).filter(|_| cuts(line))?;
    match line.word(b'N') {
        Some(word) => here(line, line.with(word, "N123456789")),
        None => here(line, format!("N123456789 {}", line.text)),
    }
}

/// The word that is the number of the program, where it stands first in its line.
fn own_number(line: &Line) -> Option<&Word> {
    line.words.first().filter(|word| word.letter == b'O')
}

pub fn program_number(part: &Part, line: &Line) -> Planted {
    // A macro alone is not run.
    part.lines.iter().find(|line| cuts(line))?;
    here(line, line.with(own_number(line)?, "O1234567890"))
}

pub fn length_number(_: &Part, line: &Line) -> Planted {
    line.g(&["43"]).filter(|_| line.done.ran)?;
    here(line, line.with(line.word(b'H')?, "H9999"))
}

pub fn radius_number(_: &Part, line: &Line) -> Planted {
    line.g(&["41", "42"]).filter(|_| line.done.ran)?;
    here(line, line.with(line.word(b'D')?, "D9999"))
}

fn tool(line: &Line) -> Option<&Word> {
    line.word(b'T').filter(|_| line.done.ran && line.m(&["97", "98"]).is_none())
}

pub fn tool_number(_: &Part, line: &Line) -> Planted {
    here(line, line.with(tool(line)?, "T999"))
}

pub fn negative_tool(_: &Part, line: &Line) -> Planted {
    let word = tool(line)?;
    here(line, line.with(word, &format!("T-{}", word.value)))
}

pub fn negative_feed(_: &Part, line: &Line) -> Planted {
    let word = line.word(b'F').filter(|_| cuts(line))?;
    here(line, line.with(word, &format!("F-{}", word.value)))
}

pub fn high_speed(_: &Part, line: &Line) -> Planted {
    line.m(&["3", "4"]).filter(|_| line.done.ran)?;
    here(line, line.with(line.word(b'S')?, "S99999"))
}

pub fn high_feed(_: &Part, line: &Line) -> Planted {
    here(line, line.with(line.word(b'F').filter(|_| cuts(line))?, "F99999."))
}

/// X and Y were named before, so that it is known where the line begins.
fn begins_at_known_place(part: &Part, line: &Line) -> bool {
    let before = &part.lines[..line.number - 1];
    let named = |letter| before.iter().any(|line| moves(line) && line.word(letter).is_some());
    named(b'X') && named(b'Y')
}

pub fn low_feed(part: &Part, line: &Line) -> Planted {
    let [x, y] = way(part, line)?;
    let long = x.hypot(y) > LONG_CUT_MM && begins_at_known_place(part, line);
    here(line, line.with(line.word(b'F').filter(|_| cuts(line) && long)?, "F.01"))
}

pub fn far_end(_: &Part, line: &Line) -> Planted {
    let word =
        line.word(b'X').filter(|_| moves(line) && !line.done.arc && !line.done.compensated)?;
    // E0 are the coordinates of the machine, where each move is judged by itself.
    if line.word(b'E').is_some() {
        return None;
    }
    Some(Plant { place: HEAD_LINE, ..here(line, line.with(word, "X9999."))? })
}

// Codes.

pub fn two_m_codes(_: &Part, line: &Line) -> Planted {
    let word = line.m(&["3"]).filter(|_| line.done.ran)?;
    here(line, line.with(word, "M3 M5"))
}

pub fn two_axis_codes(_: &Part, line: &Line) -> Planted {
    let word = line.g(&["1"]).filter(|_| cuts(line) && line.word(b'X').is_some())?;
    here(line, line.with(word, "G1 G92"))
}

/// An arc with its code and centre words.
fn arc(line: &Line) -> Option<&Word> {
    let centre = line.word(b'I').is_some() && line.word(b'J').is_some();
    let known = line.done.arc && !line.done.cycle && line.word(b'P').is_none();
    line.g(&["2", "3"]).filter(|_| known && centre && line.word(b'R').is_none())
}

pub fn arc_with_g53(_: &Part, line: &Line) -> Planted {
    let code = &line.text[arc(line)?.range.clone()];
    here(line, line.with(arc(line)?, &format!("G53 {code}")))
}

pub fn straight_arc(_: &Part, line: &Line) -> Planted {
    here(line, line.with(arc(line)?, "G1"))
}

pub fn stray_word(_: &Part, line: &Line) -> Planted {
    axis(line).filter(|_| cuts(line) && !line.done.arc)?;
    here(line, line.and(" Q5.")?)
}

/// A straight cut: what stands before it can be a block of its own.
fn straight_cut(line: &Line) -> bool {
    cuts(line) && !line.done.arc && !line.words.is_empty()
}

pub fn dwell_without_time(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "G4"))?
}

pub fn negative_dwell(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "G4 P-2."))?
}

pub fn offset_beyond(_: &Part, line: &Line) -> Planted {
    let first = line.g(&["54", "90", "17"]).is_some() && line.done.ran;
    first.then(|| before(line, "G10 L2 P199 X0. Z0."))?
}

pub fn further_offset(part: &Part, line: &Line) -> Planted {
    let word = line.g(&["54"]).filter(|_| line.done.ran && line.word(b'P').is_none())?;
    let code = if part.control == "haas" { "G154 P900" } else { "G54.1 P900" };
    here(line, line.with(word, code))
}

pub fn inverse_time(_: &Part, line: &Line) -> Planted {
    (straight_cut(line) && line.word(b'F').is_none()).then(|| after_line(line, "G93"))?
}

pub fn per_revolution(part: &Part, line: &Line) -> Planted {
    let turns = part.lines[..line.number].iter().any(|line| line.m(&["3", "4"]).is_some());
    let per_minute = number(line, b'F').is_some_and(|feed| feed >= FEED_PER_MINUTE);
    (straight_cut(line) && turns && per_minute).then(|| after_line(line, "G95"))?
}

// Arcs.

/// Centre from the start and way to the end of an arc in XY, mm or in, by the words of a line that has its end in both.
fn arc_in_millimetres(part: &Part, line: &Line) -> Option<([f64; 2], [f64; 2])> {
    arc(line)?;
    let [x, y] = way(part, line)?;
    let centre = [number(line, b'I')?, number(line, b'J')?];
    // The unit is that in which the words are a centre: the same distance of both ends.
    let fits = |unit: f64| {
        let [i, j] = centre.map(|word| word * unit);
        (i.hypot(j) - (x - i).hypot(y - j)).abs() < 0.02
    };
    let unit = [1.0, 25.4].into_iter().find(|unit| fits(*unit))?;
    Some((centre.map(|word| word * unit), [x, y]))
}

/// How far the end of an arc about a centre lies off its circle, mm.
fn off_circle([i, j]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    (i.hypot(j) - (x - i).hypot(y - j)).abs()
}

pub fn other_side(part: &Part, line: &Line) -> Planted {
    let ([i, j], way) = arc_in_millimetres(part, line)?;
    let word = line.word(b'I')?;
    let sign = if word.value.starts_with('-') { "" } else { "-" };
    (off_circle([-i, j], way) > REFUSED_MM)
        .then(|| here(line, line.with(word, &format!("I{sign}{}", digits(word)))))?
}

pub fn exchanged(part: &Part, line: &Line) -> Planted {
    let ([i, j], way) = arc_in_millimetres(part, line)?;
    let (first, second) = (line.word(b'I')?, line.word(b'J')?);
    if first.range.end > second.range.start || off_circle([j, i], way) <= REFUSED_MM {
        return None;
    }
    let text = line.with(second, &format!("J{}", first.value));
    here(
        line,
        format!("{}I{}{}", &text[..first.range.start], second.value, &text[first.range.end..]),
    )
}

pub fn centre_at_start(part: &Part, line: &Line) -> Planted {
    let (_, [x, y]) = arc_in_millimetres(part, line)?;
    let (first, second) = (line.word(b'I')?, line.word(b'J')?);
    if first.range.end > second.range.start || x.hypot(y) <= REFUSED_MM {
        return None;
    }
    let text = line.with(second, "J0.");
    here(line, format!("{}I0.{}", &text[..first.range.start], &text[first.range.end..]))
}

pub fn full_by_radius(part: &Part, line: &Line) -> Planted {
    let known = line.done.arc && !line.done.cycle && line.g(&["2", "3"]).is_some();
    let [x, y] = way(part, line)?;
    let mut centre = line.words.iter().filter(|word| b"IJK".contains(&word.letter));
    let first = centre.next().filter(|_| known && x.hypot(y) <= SAME_PLACE_MM)?;
    let text = match centre.next() {
        Some(second) if centre.next().is_none() => line.without(second),
        Some(_) => return None,
        None => line.text.clone(),
    };
    here(line, format!("{}R5.{}", &text[..first.range.start], &text[first.range.end..]))
}

pub fn centre_and_radius(part: &Part, line: &Line) -> Planted {
    let (_, [x, y]) = arc_in_millimetres(part, line)?;
    (x.hypot(y) > REFUSED_MM).then(|| here(line, line.and(" R900.")?))?
}

/// G17, and the next arc that stands in XY by it alone.
pub fn other_plane(part: &Part, line: &Line) -> Planted {
    let word = line.g(&["17"]).filter(|_| line.done.ran)?;
    let mut after = part.lines[line.number..].iter();
    let next = after.find(|line| line.done.arc || line.g(&["17", "18", "19"]).is_some())?;
    arc(next).filter(|_| next.g(&["17", "18", "19"]).is_none())?;
    // A helix and an arc without I along X could be one in ZX, too.
    let (centre, way) = arc_in_millimetres(part, next)?;
    let crooked =
        centre[1].abs() > REFUSED_MM && off_circle([centre[0], 0.0], [way[0], 0.0]) > REFUSED_MM;
    let plant = here(line, line.with(word, "G18"))?;
    (crooked && next.word(b'Z').is_none()).then_some(Plant { place: next.number, ..plant })
}

// Cutter compensation.

/// A straight cut with compensation on, that neither begins nor ends it.
fn compensated(part: &Part, line: &Line) -> bool {
    let on = previous(part, line).is_some_and(|line| line.done.compensated);
    on && line.done.compensated && straight_cut(line)
}

pub fn plane_in_compensation(part: &Part, line: &Line) -> Planted {
    compensated(part, line).then(|| before(line, "G18"))?
}

pub fn tool_in_compensation(part: &Part, line: &Line) -> Planted {
    compensated(part, line).then(|| before(line, "T9 M6"))?
}

pub fn cycle_in_compensation(part: &Part, line: &Line) -> Planted {
    compensated(part, line).then(|| before(line, "G81 X0. Y0. Z-1. R1. F50."))?
}

// Cycles.

/// The first cycle of the program, in G90: nothing is kept from another one.
fn first_cycle(part: &Part, line: &Line, codes: &[&str]) -> bool {
    let all = ["73", "81", "82", "83", "85", "86", "89"];
    let first = part.lines.iter().find(|line| line.g(&all).is_some());
    first.is_some_and(|first| first.number == line.number)
        && line.g(codes).is_some()
        && line.done.cycle
        && !line.done.incremental
}

pub fn depth_without_sign(part: &Part, line: &Line) -> Planted {
    let word = line.word(b'Z').filter(|word| word.value.starts_with('-'))?;
    let above = number(line, b'Z')?.abs() > number(line, b'R')?;
    let first = first_cycle(part, line, &["73", "81", "82", "83", "85"]);
    (first && above).then(|| here(line, line.with(word, &format!("Z{}", digits(word)))))?
}

pub fn zero_pecks(part: &Part, line: &Line) -> Planted {
    let word = line.word(b'Q').filter(|_| first_cycle(part, line, &["73", "83"]))?;
    here(line, line.with(word, "Q0."))
}

pub fn cycle_without_dwell(part: &Part, line: &Line) -> Planted {
    let word = line.word(b'P').filter(|_| first_cycle(part, line, &["82", "89"]))?;
    here(line, line.without(word))
}

pub fn no_repeat(part: &Part, line: &Line) -> Planted {
    let first = first_cycle(part, line, &["73", "81", "82", "83", "85"]);
    (first && line.word(b'L').is_none()).then(|| here(line, line.and(" L0")?))?
}

// Programs.

/// The end of the main program.
fn end(line: &Line) -> bool {
    line.m(&["30", "2"]).is_some() && line.done.ran
}

/// The number of the program at the head of the file.
fn head(part: &Part) -> Option<&str> {
    part.lines.iter().find_map(own_number).map(|word| word.value.as_str())
}

pub fn calls_itself(part: &Part, line: &Line) -> Planted {
    before(line, &format!("M98 P{}", head(part).filter(|_| end(line))?))
}

pub fn same_number(part: &Part, line: &Line) -> Planted {
    let own = head(part).filter(|_| end(line))?;
    let plant = here(line, format!("{}\nO{own}\nM99", line.text))?;
    Some(Plant { place: line.number + 1, ..plant })
}

pub fn percent(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "%"))?
}

pub fn own_block(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "N9876 GOTO 9876"))?
}

// Spindle.

/// The first cut after a line, where nothing starts the spindle or taps before it.
fn cut_after<'p>(part: &'p Part, line: &Line) -> Option<&'p Line> {
    let stays = |line: &Line| {
        line.m(&["3", "4", "6", "30", "2"]).is_some()
            || line.word(b'S').is_some()
            || line.g(&["74", "84", "33.1", "84.1", "74.1"]).is_some()
    };
    let next = part.lines[line.number..].iter().find(|line| line.done.cuts || stays(line))?;
    (next.done.cuts && !stays(next)).then_some(next)
}

pub fn stop_for_coolant(part: &Part, line: &Line) -> Planted {
    let turns = part.lines[..line.number].iter().any(|line| line.m(&["3", "4"]).is_some());
    let word =
        line.m(&["8"]).filter(|_| line.done.ran && turns && line.m(&["3", "4"]).is_none())?;
    let place = cut_after(part, line)?.number;
    Some(Plant { place, ..here(line, line.with(word, "M5"))? })
}

pub fn no_speed(part: &Part, line: &Line) -> Planted {
    let first = part.lines.iter().find(|line| line.word(b'S').is_some())?;
    let word = line.word(b'S').filter(|_| line.number == first.number)?;
    line.m(&["3", "4"])?;
    let place = cut_after(part, line)?.number;
    Some(Plant { place, ..here(line, line.without(word))? })
}

// Corners and frames.

/// A straight cut in XY in G90 with another one across it behind.
pub fn large_rounding(part: &Part, line: &Line) -> Planted {
    let next = part.lines.get(line.number).filter(|next| straight_cut(next))?;
    let plane =
        |line: &Line| straight_cut(line) && line.word(b'Z').is_none() && !line.done.compensated;
    let ([x, y], [u, v]) = (way(part, line)?, way(part, next)?);
    let across = (x * v - y * u).abs() > 0.1 * x.hypot(y) * u.hypot(v);
    (plane(line) && plane(next) && across).then(|| here(line, line.and(" ,R900.")?))?
}

pub fn zero_scale(_: &Part, line: &Line) -> Planted {
    let free = straight_cut(line) && !line.done.compensated;
    free.then(|| before(line, "G51 X0. Y0. P0"))?
}

// Macros.

pub fn negative_root(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "#100=SQRT[0-4]"))?
}

pub fn wrong_function(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "#100=SINUS[30]"))?
}

pub fn loop_four(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "WHILE[1 EQ 2]DO4\nEND4"))?
}

pub fn end_without_do(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "END1"))?
}

pub fn idle_condition(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "IF[1 EQ 1]"))?
}

pub fn null_set(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "#0=5"))?
}

pub fn mixed_block(_: &Part, line: &Line) -> Planted {
    let last = line.words.last().filter(|_| straight_cut(line))?;
    here(line, format!("{} #100=5", &line.text[..last.range.end]))
}

pub fn unset_name(_: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|_| straight_cut(line))?;
    here(line, line.with(word, &format!("{}#<depth_of_part>", word.letter as char)))
}

pub fn variable(_: &Part, line: &Line) -> Planted {
    straight_cut(line).then(|| before(line, "#100=5"))?
}

// Lines.

pub fn long_line(_: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|word| straight_cut(line) && word.value.contains('.'))?;
    here(line, line.with(word, &format!("{}{}", &line.text[word.range.clone()], "0".repeat(300))))
}

pub fn late_slash(_: &Part, line: &Line) -> Planted {
    let word = axis(line).filter(|word| straight_cut(line) && word.range.start > 0)?;
    here(line, line.with(word, &format!("/{}", &line.text[word.range.clone()])))
}
