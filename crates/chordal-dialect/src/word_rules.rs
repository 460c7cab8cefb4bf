//! What a control asks of the words of a code, beyond which letters it takes.

/// One condition on the words of a code.
#[derive(Clone, Copy, Debug)]
pub struct WordRule {
    /// Letter of the code and ten times its number.
    pub code: (u8, u16),
    /// What has to hold.
    pub test: WordTest,
    /// What is wrong otherwise, for people, after the name of the code.
    pub message: &'static str,
    /// What to do.
    pub help: &'static str,
    /// What the control shows; nothing where it goes on.
    pub alarm: Option<&'static str>,
    /// The control does something that is not followed: from here on the path is not known.
    pub loses_path: bool,
}

/// What has to hold for the words of a block.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum WordTest {
    /// One of these letters is written, and each that is written is not below zero.
    OneOf(&'static str),
    /// The letter is written, with any value.
    Written(u8),
    /// None of these letters is written.
    Absent(&'static str),
    /// The two letters are not both written.
    NotBoth(u8, u8),
    /// A letter that is written has a value in this range.
    Within(u8, f64, f64),
    /// A letter that is written is a whole number.
    Whole(u8),
    /// Where the first letter is not zero, the second is above zero.
    WithPositive(u8, u8),
    /// Where the first letter is not zero, the second is not written.
    Without(u8, u8),
}

impl WordTest {
    /// Whether it holds; `value` gives the value of a letter that is written.
    pub fn holds(self, value: impl Fn(u8) -> Option<f64>) -> bool {
        let is_zero = |letter| value(letter).is_none_or(|value| value == 0.0);
        match self {
            WordTest::OneOf(letters) => {
                let mut values = letters.bytes().filter_map(&value).peekable();
                values.peek().is_some() && values.all(|value| value >= 0.0)
            }
            WordTest::Written(letter) => value(letter).is_some(),
            WordTest::Absent(letters) => letters.bytes().all(|letter| value(letter).is_none()),
            WordTest::NotBoth(first, second) => value(first).is_none() || value(second).is_none(),
            WordTest::Within(letter, least, most) => {
                value(letter).is_none_or(|value| (least..=most).contains(&value))
            }
            WordTest::Whole(letter) => value(letter).is_none_or(|value| value.fract() == 0.0),
            WordTest::WithPositive(first, second) => {
                is_zero(first) || value(second).is_some_and(|value| value > 0.0)
            }
            WordTest::Without(first, second) => is_zero(first) || value(second).is_none(),
        }
    }
}
