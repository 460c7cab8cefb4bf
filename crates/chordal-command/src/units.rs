//! Units of a program, and numbers as text for users.

/// Units of the program text.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Units {
    /// G20.
    Inch,
    /// G21.
    Millimetre,
}

impl Units {
    /// The length of one unit, mm.
    pub fn mm(self) -> f64 {
        match self {
            Units::Inch => 25.4,
            Units::Millimetre => 1.0,
        }
    }

    /// A length given in mm as text in these units, rounded to 0.0001 in or 0.001 mm.
    pub fn length_text(self, mm: f64) -> String {
        match self {
            Units::Inch => format!("{} in", number_text(mm / 25.4, 4)),
            Units::Millimetre => format!("{} mm", number_text(mm, 3)),
        }
    }
}

/// A number rounded to `decimals`, without trailing zeros.
pub fn number_text(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    if !text.contains('.') {
        return text;
    }
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// A number rounded to `decimals`, or to as many more as it takes to show two significant digits.
pub fn telling_number(value: f64, decimals: usize) -> String {
    let mut decimals = decimals;
    while decimals < 9 && value != 0.0 && value.abs() < 10f64.powi(1 - decimals as i32) {
        decimals += 1;
    }
    number_text(value, decimals)
}
