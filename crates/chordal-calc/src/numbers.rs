//! Numbers as people write them.

/// The unit in which lengths are reported.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnswerUnit {
    /// Inches, five decimals.
    Inch,
    /// Millimetres, four decimals.
    Millimetre,
}

impl AnswerUnit {
    /// Millimetres of one unit.
    pub const fn mm(self) -> f64 {
        match self {
            AnswerUnit::Inch => 25.4,
            AnswerUnit::Millimetre => 1.0,
        }
    }

    /// `in` or `mm`.
    pub const fn name(self) -> &'static str {
        match self {
            AnswerUnit::Inch => "in",
            AnswerUnit::Millimetre => "mm",
        }
    }

    /// Decimals of a length in a text.
    pub const fn decimals(self) -> usize {
        match self {
            AnswerUnit::Inch => 5,
            AnswerUnit::Millimetre => 4,
        }
    }

    /// Decimals of a coordinate word in a program: the least increment of a common machine.
    pub const fn word_decimals(self) -> usize {
        match self {
            AnswerUnit::Inch => 4,
            AnswerUnit::Millimetre => 3,
        }
    }

    /// A length without its unit.
    pub fn number(self, mm: f64) -> String {
        trimmed(mm / self.mm(), self.decimals())
    }

    /// A length with its unit.
    pub fn length(self, mm: f64) -> String {
        format!("{} {}", self.number(mm), self.name())
    }
}

/// An angle in degrees, as `30°`.
pub(crate) fn degrees(angle: f64) -> String {
    format!("{}°", trimmed(angle.to_degrees(), 4))
}

/// With at most so many decimals and no zeros at the end. What lies half way goes away from zero, as
/// on paper: 0.015625 is 0.01563.
pub(crate) fn trimmed(value: f64, decimals: usize) -> String {
    let last = 10f64.powi(-(decimals as i32));
    let steps = (value / last).abs();
    let half_path = (steps.fract() - 0.5).abs() < 1e-6;
    let shown = if half_path { value + (0.25 * last).copysign(value) } else { value };
    let text = format!("{shown:.decimals$}");
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text.as_str()
    };
    if text == "-0" { "0".into() } else { text.into() }
}

/// A number within a formula: in parentheses when it is negative.
pub(crate) fn factor(text: String) -> String {
    if text.starts_with('-') { format!("({text})") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_exact() {
        assert_eq!(AnswerUnit::Inch.length(25.4), "1 in");
        assert_eq!(AnswerUnit::Inch.number(6.35), "0.25");
        assert_eq!(AnswerUnit::Millimetre.length(-0.00001), "0 mm");
        assert_eq!(degrees(std::f64::consts::FRAC_PI_6), "30°");
        assert_eq!(trimmed(100.0, 0), "100");
        // An eighth of an eighth of an inch is 0.015625.
        assert_eq!(AnswerUnit::Inch.number(25.4 / 64.0), "0.01563");
        assert_eq!(trimmed(-0.015625, 5), "-0.01563");
        assert_eq!(trimmed(2.5, 0), "3");
    }
}
