//! Reads what one comment says about a tool.

use chordal_machine::ToolShape;

use super::CommentedTool;
use super::drills::{letter_drill, number_drill, number_screw};
use super::tokens::{CommentToken, CommentTokenKind, join_mixed, tokens};
use super::turning::read_turning;

/// Words that name a tool.
const TOOL_WORDS: &[&str] = &[
    "MILL",
    "ENDMILL",
    "FACEMILL",
    "SHELLMILL",
    "EM",
    "FEM",
    "BEM",
    "DRILL",
    "SPOTDRILL",
    "CENTERDRILL",
    "TAP",
    "REAMER",
    "REAM",
    "THREADMILL",
    "CHAMFER",
    "CHAMF",
    "COUNTERSINK",
    "CSINK",
    "CSK",
    "CUTTER",
    "ENGRAVER",
    "KEYCUTTER",
    "BALLMILL",
    "BALLNOSE",
    "BULLNOSE",
    "SLOTMILL",
    "LOLLIPOP",
    "DOVETAIL",
    "COMPRESSION",
    "ROUGHER",
    "BIT",
    "VBIT",
];

/// Words within the name of a tool.
const INNER_WORDS: &[&str] = &[
    "END", "FACE", "SHELL", "FLAT", "SQUARE", "BALL", "BULL", "NOSE", "SPOT", "CENTER", "STUB",
    "THREAD",
];

/// Words of a sentence about a tool, whose numbers may mean anything.
const SENTENCE: &[&str] = &[
    "BROKEN", "WORN", "CHANGE", "CHANGED", "REPLACE", "REPLACED", "NEXT", "CHECK", "AFTER",
    "BEFORE", "REMOVE", "INSPECT", "TOUCH", "INSTALL", "INSTEAD", "NOT", "IF", "PARTS", "PCS",
];

/// Sizes above this are not those of a tool, mm.
const MAX_TOOL_MM: f64 = 500.0;

/// Reads a comment without its delimiters. `inch`: numbers without a unit are in inches, not mm. `called`: the tool
/// that the block of the comment calls, for a comment that names none. `turns`: the machine is a lathe, so inserts
/// and holders may be named. Returns `None` where the comment says nothing about a tool.
pub fn read_tool_comment(
    text: &str,
    inch: bool,
    called: Option<u32>,
    turns: bool,
) -> Option<CommentedTool> {
    let text = plain(text);
    let all = tokens(&text);
    let (number, rest) = tool_number(&all, called)?;
    let (commented, is_keyed) = described(&text, rest, inch, turns);
    let commented = CommentedTool { number, ..commented };
    let sentence = is_sentence(&all);
    let says = commented.diameter_mm.is_some()
        || commented.shape.is_some()
        || commented.tip.is_some()
        || commented.nose_radius_mm.is_some();
    (says && (is_keyed || !sentence)).then_some(commented)
}

/// Reads the description of a tool after a key; its number is 0. `None` without a diameter.
pub(super) fn read_description(text: &str, inch: bool) -> Option<CommentedTool> {
    let text = plain(text);
    let all = tokens(&text);
    let sentence = is_sentence(&all);
    let (commented, is_keyed) = described(&text, all, inch, false);
    (commented.diameter_mm.is_some() && (is_keyed || !sentence)).then_some(commented)
}

/// Whether words of a sentence are among the tokens.
fn is_sentence(tokens: &[CommentToken<'_>]) -> bool {
    tokens.iter().filter_map(CommentToken::word).any(|word| SENTENCE.contains(&word))
}

/// The text in upper case without parts that would be misread: the name of a holder, the suffixes of FeatureCAM.
fn plain(text: &str) -> String {
    let mut text = text.to_ascii_uppercase();
    if let Some(holder) = text.find("HOLDER=") {
        text.truncate(holder);
    }
    if let Some(at) = text.find("ENDMILLM").filter(|_| text.ends_with(":REG")) {
        text.truncate(at + "ENDMILL".len());
    }
    // BlenderCAM writes `type: end` for a flat end mill.
    text.replace("TYPE END ", "TYPE ENDMILL ")
}

/// The tool of a description, and whether a key announces its diameter.
fn described(
    text: &str,
    mut rest: Vec<CommentToken<'_>>,
    inch: bool,
    turns: bool,
) -> (CommentedTool, bool) {
    // `TOOL 1 = 12MM ENDMILL`: the sign belongs to the number of the tool.
    let is_list_sign = |token: &CommentToken<'_>| {
        matches!(token.kind, CommentTokenKind::Sign('=' | '-' | ':' | ','))
    };
    let signs = rest.iter().take_while(|token| is_list_sign(token)).count();
    rest.drain(..signs);
    join_mixed(&mut rest);
    let reader = CommentReader { tokens: rest, inch, shape: shape_of(text) };
    let mut commented = reader.read();
    if turns {
        read_turning(text, &reader.tokens, inch, &mut commented);
    }
    let is_keyed = reader.keyed_diameter().is_some();
    (commented, is_keyed)
}

/// The shape that the text names, preferably before a colon: after it comes the purpose of the tool.
fn shape_of(text: &str) -> Option<ToolShape> {
    let before = text.split(": ").next().unwrap_or(text);
    ToolShape::from_words(before).or_else(|| ToolShape::from_words(text))
}

/// The number of the tool, and the other tokens; `None` where the comment is about no tool.
fn tool_number<'t>(
    all: &[CommentToken<'t>],
    called: Option<u32>,
) -> Option<(u32, Vec<CommentToken<'t>>)> {
    let start = all.iter().position(|token| !matches!(token.kind, CommentTokenKind::Sign(_)))?;
    let number_at = |at: usize| {
        let whole = all.get(at)?.number()?.whole().filter(|number| (1..=999).contains(number))?;
        // `TOOL 3-FLUTE` and `T1A` do not give a number.
        let hugged = all.get(at + 1).is_some_and(|next| next.glued && next.word().is_some());
        (!hugged).then_some(whole)
    };
    if all[start].word() == Some("T") && all.get(start + 1).is_some_and(|next| next.glued) {
        return number_at(start + 1).map(|number| (number, all[start + 2..].to_vec()));
    }
    // `TO2 = …` has the letter O for a zero.
    let with_letter = all[start].word() == Some("TO")
        && all.get(start + 1).is_some_and(|next| next.glued)
        && all.get(start + 2).is_some_and(|next| next.is_sign('='));
    if with_letter {
        return number_at(start + 1).map(|number| (number, all[start + 2..].to_vec()));
    }
    // `TOOL 3`, `TOOL #3`, `TOOL NO. 3` at the start; within the text only with a sign, as `TOOL - 3`.
    for at in start..all.len() {
        if all[at].word() != Some("TOOL") {
            continue;
        }
        let passed = |token: &&CommentToken<'_>| {
            matches!(token.kind, CommentTokenKind::Sign('#' | '-' | ':' | '=' | '.' | '<'))
                || matches!(token.word(), Some("NO" | "NUM" | "NUMBER"))
        };
        let after = at + 1 + all[at + 1..].iter().take_while(passed).count();
        let dashed =
            all[at + 1..after].iter().any(|token| token.is_sign('-') || token.is_sign('#'));
        if let Some(number) = number_at(after).filter(|_| at == start || dashed) {
            let rest = [&all[..at], &all[after + 1..]].concat();
            return Some((number, rest));
        }
    }
    called.map(|number| (number, all.to_vec()))
}

struct CommentReader<'t> {
    tokens: Vec<CommentToken<'t>>,
    inch: bool,
    shape: Option<ToolShape>,
}

impl CommentReader<'_> {
    fn read(&self) -> CommentedTool {
        let (thread_mm, pitch_mm) = self.thread();
        // The thread that a mill cuts is not the diameter of the mill.
        let thread_mm = thread_mm.filter(|_| self.shape != Some(ToolShape::ThreadMill));
        let diameter_mm = self
            .keyed_diameter()
            .or(thread_mm)
            .or_else(|| self.named_size())
            .or_else(|| self.size());
        CommentedTool {
            diameter_mm: diameter_mm.filter(|mm| (0.0..=MAX_TOOL_MM).contains(mm) && *mm > 0.0),
            corner_radius_mm: self.corner_radius(),
            point_angle_rad: self.point_angle(),
            pitch_mm: pitch_mm.or_else(|| self.keyed_pitch()),
            shape: self.shape.or_else(|| self.mill_with_corners()),
            ..CommentedTool::of(0)
        }
    }

    /// `MILL DIA 10.0 R 0.5`: a mill with rounded corners.
    fn mill_with_corners(&self) -> Option<ToolShape> {
        let is_mill = (0..self.tokens.len()).any(|at| self.word(at) == Some("MILL"));
        let is_round = self.corner_radius().is_some_and(|corner| corner > 0.0);
        (is_mill && is_round).then_some(ToolShape::Bull)
    }

    fn word(&self, at: usize) -> Option<&str> {
        self.tokens.get(at)?.word()
    }

    /// The index of the first token from `at` on that is not a separator.
    fn past_signs(&self, at: usize) -> usize {
        let is_sign = |token: &&CommentToken<'_>| {
            matches!(token.kind, CommentTokenKind::Sign('.' | '-' | '=' | ':'))
        };
        at + self.tokens.get(at..).unwrap_or(&[]).iter().take_while(is_sign).count()
    }

    /// The index of the number after a key, separators skipped.
    fn number_after(&self, at: usize) -> Option<usize> {
        let at = self.past_signs(at + 1);
        self.tokens.get(at)?.number().map(|_| at)
    }

    fn mm(&self, at: usize) -> Option<f64> {
        Some(self.tokens.get(at)?.number()?.mm(self.inch))
    }

    /// `D=12.`, `DIA. - .5`, `.25 DIA`, `Ø12`.
    fn keyed_diameter(&self) -> Option<f64> {
        (0..self.tokens.len()).find_map(|at| match self.tokens[at].kind {
            CommentTokenKind::Word("DIA" | "DIAM" | "DIAMETER")
            | CommentTokenKind::Sign('Ø' | '⌀' | 'ø') => {
                let is_size =
                    |at: &usize| self.tokens[*at].number().is_some_and(|number| number.is_size());
                let following = self.number_after(at);
                let before = at.checked_sub(1).filter(is_size);
                // `LEN. - 3 DIA. - .375`, and `.25 DIA. 2 FLUTE`.
                self.mm(following.filter(is_size).or(before).or(following)?)
            }
            // `D3` without a sign or point is an offset number.
            CommentTokenKind::Word("D") => {
                let keyed = self.tokens.get(at + 1)?.is_sign('=');
                let value = self.number_after(at)?;
                let point = self.tokens[value].number()?.point && self.tokens[at + 1].glued;
                (keyed || point).then(|| self.mm(value)).flatten()
            }
            // `End Mill {6 mm}`.
            CommentTokenKind::Sign('{') => {
                let size = (at + 1..self.tokens.len())
                    .take_while(|at| !self.tokens[*at].is_sign('}'))
                    .find(|at| self.is_size(*at, false))?;
                self.mm(size)
            }
            _ => None,
        })
    }

    /// `CR=0.5`, `CORNER RAD .03`, `R0.5`, `.06R`.
    fn corner_radius(&self) -> Option<f64> {
        (0..self.tokens.len()).find_map(|at| {
            let word = self.word(at)?;
            let rad = matches!(word, "CR" | "RAD" | "RADIUS" | "R" | "CRAD");
            // A nose radius is that of an insert.
            let of_nose = at.checked_sub(1).is_some_and(|at| self.word(at) == Some("NOSE"));
            if !rad || of_nose {
                return None;
            }
            let following = self.number_after(at).filter(|place| {
                let number = self.tokens[*place].number();
                // `DIA 10.0 R 0.5`; elsewhere `R .1` may be a level.
                let after_diameter = || (0..at).any(|at| self.word(at) == Some("DIA"));
                let is_near = self.tokens[at + 1].glued || after_diameter();
                word != "R" || number.is_some_and(|number| number.point) && is_near
            });
            let before = at.checked_sub(1).filter(|before| {
                let hugs = word != "R" || self.tokens[at].glued;
                hugs && self.tokens[*before].number().is_some_and(|number| number.is_size())
            });
            self.mm(following.or(before)?)
        })
    }

    /// The included angle of the point, rad: `118 DEG`, or `TAPER=` of a post processor, which for a chamfer mill is
    /// the angle of one side.
    fn point_angle(&self) -> Option<f64> {
        let number = |at: usize| self.tokens.get(at)?.number().map(|number| number.value());
        let pointed = matches!(self.shape, Some(ToolShape::Drill | ToolShape::Chamfer));
        let degrees = (0..self.tokens.len()).find_map(|at| match self.tokens[at].kind {
            CommentTokenKind::Word("TAPER") => {
                let side = number(self.number_after(at)?)?;
                Some(if self.shape == Some(ToolShape::Chamfer) { 2.0 * side } else { side })
            }
            CommentTokenKind::Word("DEG" | "DEGREE" | "DEGREES") | CommentTokenKind::Sign('°') => {
                number(at.checked_sub(1)?)
            }
            _ => None,
        });
        degrees.filter(|degrees| pointed && (10.0..=180.0).contains(degrees)).map(f64::to_radians)
    }

    /// `PITCH=1.5`, `TPI 20`, `20 TPI`.
    fn keyed_pitch(&self) -> Option<f64> {
        let number = |at: usize| self.tokens.get(at)?.number().map(|number| number.value());
        (0..self.tokens.len()).find_map(|at| match self.word(at)? {
            "PITCH" => self.mm(self.number_after(at)?),
            "TPI" => {
                let following = self.number_after(at).and_then(number);
                let per_inch = following.or_else(|| number(at.checked_sub(1)?))?;
                (per_inch > 0.0).then(|| 25.4 / per_inch)
            }
            _ => None,
        })
    }

    /// The diameter and the pitch of `M6X1`, `1/4-20`, `#10-32`, mm.
    fn thread(&self) -> (Option<f64>, Option<f64>) {
        let threads = matches!(self.shape, Some(ToolShape::Tap | ToolShape::ThreadMill));
        if !threads {
            return (None, None);
        }
        let found =
            (0..self.tokens.len()).find_map(|at| self.metric(at).or_else(|| self.unified(at)));
        found.map_or((None, None), |(diameter, pitch)| (Some(diameter), pitch))
    }

    fn metric(&self, at: usize) -> Option<(f64, Option<f64>)> {
        let size =
            self.tokens.get(at + 1).filter(|next| next.glued && self.word(at) == Some("M"))?;
        let number = |at: usize| self.tokens.get(at)?.number().map(|number| number.value());
        let pitch = number(at + 3).filter(|_| self.word(at + 2) == Some("X"));
        Some((size.number()?.value(), pitch.filter(|pitch| *pitch > 0.0)))
    }

    fn unified(&self, at: usize) -> Option<(f64, Option<f64>)> {
        let size = self.tokens[at].number()?;
        let dash = self.tokens.get(at + 1)?.is_sign('-');
        let per_inch =
            self.tokens.get(at + 2)?.number()?.whole().filter(|n| (4..=80).contains(n))?;
        let diameter = match size.whole() {
            Some(number) => number_screw(number)?,
            None => size.mm(true),
        };
        dash.then(|| (diameter, Some(25.4 / f64::from(per_inch))))
    }

    /// `#7 DRILL`, `F DRILL`, `DRILL LETTER F`.
    fn named_size(&self) -> Option<f64> {
        if self.shape != Some(ToolShape::Drill) {
            return None;
        }
        (0..self.tokens.len()).find_map(|at| {
            if self.tokens[at].is_sign('#') {
                return number_drill(self.tokens.get(at + 1)?.number()?.whole()?);
            }
            let word = self.word(at)?;
            match self.word(at + 1) {
                // `IS A DRILL` does not mean an A drill.
                Some("DRILL") if word != "A" => letter_drill(word),
                Some(letter) if word == "LETTER" => letter_drill(letter),
                _ => None,
            }
        })
    }

    /// A size before the name of the tool, or else after it, mm.
    fn size(&self) -> Option<f64> {
        let is = |list: &[&str], at: usize| self.word(at).is_some_and(|word| list.contains(&word));
        let named = (0..self.tokens.len()).find(|at| is(TOOL_WORDS, *at));
        // `3/8 BALL`.
        let round = || (0..self.tokens.len()).find(|at| is(&["BALL", "BULL"], *at));
        let named = named.or_else(round)?;
        let in_name = |at: &usize| is(TOOL_WORDS, *at) || is(INNER_WORDS, *at);
        let first = (0..named).rev().take_while(in_name).last().unwrap_or(named);
        let last = (named..self.tokens.len()).take_while(in_name).last().unwrap_or(named);
        let before = (0..first).rev().find(|at| self.is_size(*at, *at + 1 == first));
        let following = || (last + 1..self.tokens.len()).find(|at| self.is_size(*at, false));
        self.mm(before.or_else(following)?)
    }

    /// Whether a number may be a size: not an offset number, a height, a number of flutes or an angle. A whole number
    /// without a unit is a size only next to the name, and only in millimetres.
    fn is_size(&self, at: usize, adjacent_name: bool) -> bool {
        let Some(number) = self.tokens[at].number() else { return false };
        let before = at.checked_sub(1).map(|before| &self.tokens[before]);
        // `H3`, `R0.5`; `ZMIN=-8.`
        let keyed = before.is_some_and(|before| self.tokens[at].glued && before.word().is_some());
        let dash = before.is_some_and(|before| before.is_sign('-'));
        let equals_at = if dash { at.checked_sub(2) } else { at.checked_sub(1) };
        let equals = equals_at.is_some_and(|at| self.tokens[at].is_sign('='));
        let is_other = matches!(
            self.word(at + 1),
            Some(
                "FLUTE"
                    | "FLUTES"
                    | "FLT"
                    | "FL"
                    | "F"
                    | "DEG"
                    | "DEGREE"
                    | "DEGREES"
                    | "R"
                    | "RAD"
            ) | Some("CR" | "RADIUS" | "LOC" | "LONG" | "OAL" | "DEEP" | "TPI" | "PITCH" | "HOLES")
        ) || self.tokens.get(at + 1).is_some_and(|next| next.is_sign('°'));
        let sized = number.is_size() || adjacent_name && !self.inch;
        let is_thread = self.unified(at).is_some();
        sized && !keyed && !equals && !is_other && !is_thread
    }
}
