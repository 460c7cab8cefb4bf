//! Numbers for people, in the program's own units.

/// The units in which a summary speaks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SummaryUnits {
    /// Inches.
    Inch,
    /// Millimetres.
    Millimetre,
}

impl SummaryUnits {
    /// Of a program, as `Summary::inch` reports them.
    pub fn of(inch: bool) -> SummaryUnits {
        if inch { SummaryUnits::Inch } else { SummaryUnits::Millimetre }
    }

    /// Of a length.
    pub fn length_unit(self) -> &'static str {
        match self {
            SummaryUnits::Inch => "in",
            SummaryUnits::Millimetre => "mm",
        }
    }

    /// How long that is, mm.
    pub fn length_mm(self) -> f64 {
        match self {
            SummaryUnits::Inch => 25.4,
            SummaryUnits::Millimetre => 1.0,
        }
    }

    /// Of a feed.
    pub fn feed_unit(self) -> &'static str {
        match self {
            SummaryUnits::Inch => "in/min",
            SummaryUnits::Millimetre => "mm/min",
        }
    }

    /// A coordinate, with the digits of the control's display.
    pub fn coordinate(self, mm: f64) -> String {
        match self {
            SummaryUnits::Inch => fixed(mm / 25.4, 4),
            SummaryUnits::Millimetre => fixed(mm, 3),
        }
    }

    /// A length of way, with commas between the thousands: nobody reads the last digits.
    pub fn length(self, mm: f64) -> String {
        let text = match self {
            SummaryUnits::Inch => fixed(mm / 25.4, 2),
            SummaryUnits::Millimetre => fixed(mm, 1),
        };
        match text.split_once('.').map(|(whole, part)| (whole.parse::<u64>(), part)) {
            Some((Ok(whole), part)) => format!("{}.{part}", grouped(whole)),
            _ => text,
        }
    }

    /// A feed, as F would say it.
    pub fn feed(self, mm_per_s: f64) -> String {
        match self {
            SummaryUnits::Inch => short(mm_per_s / 25.4 * 60.0, 2),
            SummaryUnits::Millimetre => short(mm_per_s * 60.0, 1),
        }
    }
}

/// With so many decimals, and without the sign of a zero.
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|byte| matches!(byte, b'0' | b'.')) => digits.into(),
        _ => text,
    }
}

/// With at most so many decimals.
pub fn short(value: f64, decimals: usize) -> String {
    let text = fixed(value, decimals);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

/// A whole number with commas between the thousands.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// `1 arc`, `12 arcs`, `3 helices`.
pub fn counted(number: u64, one: &str, many: &str) -> String {
    format!("{} {}", grouped(number), if number == 1 { one } else { many })
}

/// `2 h 05 min`, `12 min 34 s`, `12.3 s`.
pub fn duration(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    if !seconds.is_finite() {
        "for ever".to_string()
    } else if seconds > 0.0 && seconds < 0.05 {
        "under 0.1 s".to_string()
    } else if seconds < 59.95 {
        format!("{} s", short(seconds, 1))
    } else if whole < 3600 {
        format!("{} min {:02} s", whole / 60, whole % 60)
    } else {
        format!("{} h {:02} min", grouped(whole / 3600), whole % 3600 / 60)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        assert_eq!(fixed(-0.00001, 4), "0.0000");
        assert_eq!(short(3.50, 2), "3.5");
        assert_eq!(short(100.0, 0), "100");
        assert_eq!(grouped(1_234_567), "1,234,567");
        assert_eq!(grouped(123), "123");
        assert_eq!(SummaryUnits::Inch.feed(25.4), "60");
        assert_eq!(duration(0.0), "0 s");
        assert_eq!(duration(0.04), "under 0.1 s");
        assert_eq!(duration(12.34), "12.3 s");
        assert_eq!(duration(59.97), "1 min 00 s");
        assert_eq!(duration(754.0), "12 min 34 s");
        assert_eq!(duration(7500.0), "2 h 05 min");
    }
}
