//! Divides a comment into tokens: numbers with their unit, words, signs.

/// The unit written after a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CommentUnit {
    Inch,
    Millimetre,
}

/// A number as written: `mantissa / (10^scale · over)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CommentNumber {
    mantissa: u64,
    scale: u32,
    over: u32,
    /// A decimal point was written.
    pub point: bool,
    pub unit: Option<CommentUnit>,
}

impl CommentNumber {
    /// The length in mm, rounded only once. A fraction without a unit is in inches: nobody writes fractions of a
    /// millimetre.
    pub fn mm(&self, inch: bool) -> f64 {
        let inch = match self.unit {
            Some(unit) => unit == CommentUnit::Inch,
            None => inch || self.is_fraction(),
        };
        let tens = |power: u32| 10f64.powi(power as i32) * f64::from(self.over);
        let mantissa = self.mantissa as f64;
        if inch { mantissa * 254.0 / tens(self.scale + 1) } else { mantissa / tens(self.scale) }
    }

    pub fn value(&self) -> f64 {
        self.mantissa as f64 / (10f64.powi(self.scale as i32) * f64::from(self.over))
    }

    /// The number where it is whole and written without a point or unit.
    pub fn whole(&self) -> Option<u32> {
        let plain = !self.point && !self.is_fraction() && self.unit.is_none();
        plain.then(|| u32::try_from(self.mantissa).ok()).flatten()
    }

    pub fn is_fraction(&self) -> bool {
        self.over != 1
    }

    /// Whether it looks like a size: a count has no decimal point, fraction or unit.
    pub fn is_size(&self) -> bool {
        self.point || self.is_fraction() || self.unit.is_some()
    }
}

/// The kind of a token.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum CommentTokenKind<'t> {
    Number(CommentNumber),
    /// Letters only, upper case.
    Word(&'t str),
    Sign(char),
}

/// A token, and whether no space separates it from the one before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CommentToken<'t> {
    pub kind: CommentTokenKind<'t>,
    pub glued: bool,
}

impl<'t> CommentToken<'t> {
    pub fn word(&self) -> Option<&'t str> {
        if let CommentTokenKind::Word(word) = self.kind { Some(word) } else { None }
    }

    pub fn number(&self) -> Option<CommentNumber> {
        if let CommentTokenKind::Number(number) = self.kind { Some(number) } else { None }
    }

    pub fn is_sign(&self, sign: char) -> bool {
        self.kind == CommentTokenKind::Sign(sign)
    }
}

/// The tokens of an upper-case text.
pub(super) fn tokens(text: &str) -> Vec<CommentToken<'_>> {
    let mut tokens: Vec<CommentToken<'_>> = Vec::new();
    let mut rest = text;
    let mut glued = false;
    while let Some(first) = rest.chars().next() {
        if first.is_whitespace() {
            rest = &rest[first.len_utf8()..];
            glued = false;
            continue;
        }
        let (kind, length) = match number_at(rest) {
            Some((number, length)) => (CommentTokenKind::Number(number), length),
            None if first.is_ascii_alphabetic() => {
                let length = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
                (CommentTokenKind::Word(&rest[..length]), length)
            }
            None => (CommentTokenKind::Sign(first), first.len_utf8()),
        };
        tokens.push(CommentToken { kind, glued });
        rest = &rest[length..];
        glued = true;
    }
    give_units(&mut tokens);
    tokens
}

/// The number at the start of a text (`12`, `.5`, `3.` or `1/2`) and its length in bytes.
fn number_at(text: &str) -> Option<(CommentNumber, usize)> {
    let digits = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(text);
    let after = &text[whole..];
    let decimals = after.strip_prefix('.').map(digits);
    if whole == 0 && decimals.unwrap_or(0) == 0 {
        return None;
    }
    let scale = decimals.unwrap_or(0);
    // A number with more digits is not the size of a tool.
    if whole + scale > 12 {
        return None;
    }
    let mut length = whole + decimals.map_or(0, |count| count + 1);
    let text_of_digits: String = text[..length].chars().filter(|c| *c != '.').collect();
    let mut number = CommentNumber {
        mantissa: text_of_digits.parse().ok()?,
        scale: scale as u32,
        over: 1,
        point: decimals.is_some(),
        unit: None,
    };
    if decimals.is_none()
        && let Some(below) = text[length..].strip_prefix('/')
        && let Ok(over @ (2 | 4 | 8 | 16 | 32 | 64)) = below[..digits(below)].parse::<u32>()
    {
        length += 1 + digits(below);
        number.over = over;
    }
    Some((number, length))
}

/// Gives each number the unit after it, and removes the token of the unit.
fn give_units(tokens: &mut Vec<CommentToken<'_>>) {
    let mut at = 1;
    while at < tokens.len() {
        let glued = tokens[at].glued;
        let sized = tokens[at - 1].number().is_some_and(|number| number.is_size());
        let unit = match tokens[at].kind {
            // `5 IN PART` is no length.
            CommentTokenKind::Word("IN") if !glued && !sized => None,
            CommentTokenKind::Word("MM" | "MILLIMETER" | "MILLIMETERS") => {
                Some(CommentUnit::Millimetre)
            }
            CommentTokenKind::Word("IN" | "INCH" | "INCHES") => Some(CommentUnit::Inch),
            // `TOOL 4 "10MM END MILL"` is in quotes.
            CommentTokenKind::Sign('"' | '”' | '″') if glued => Some(CommentUnit::Inch),
            _ => None,
        };
        match (&mut tokens[at - 1].kind, unit) {
            (CommentTokenKind::Number(number), Some(unit)) if number.unit.is_none() => {
                number.unit = Some(unit);
                tokens.remove(at);
            }
            _ => at += 1,
        }
    }
}

/// Joins `1-1/2` and `1 1/2` into one number.
pub(super) fn join_mixed(tokens: &mut Vec<CommentToken<'_>>) {
    let mut at = 0;
    while at + 1 < tokens.len() {
        let fraction_at = if tokens[at + 1].is_sign('-') { at + 2 } else { at + 1 };
        let whole = tokens[at].number().and_then(|number| number.whole());
        let fraction = tokens.get(fraction_at).and_then(CommentToken::number);
        let is_glued = |at: usize| tokens.get(at).is_some_and(|token| token.glued);
        let hugs = fraction_at == at + 1 || is_glued(at + 1) && is_glued(fraction_at);
        if let (Some(whole @ 1..=9), Some(fraction), true) = (whole, fraction, hugs)
            && fraction.is_fraction()
        {
            let mantissa = fraction.mantissa + u64::from(whole) * u64::from(fraction.over);
            tokens[at].kind = CommentTokenKind::Number(CommentNumber { mantissa, ..fraction });
            tokens.drain(at + 1..=fraction_at);
        }
        at += 1;
    }
}
