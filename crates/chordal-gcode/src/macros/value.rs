//! Values: numbers, vacant, and unknown ones.

/// A value of a variable or an expression.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum MacroValue {
    /// Vacant (null): the value of a variable that was never written.
    Vacant,
    /// A number.
    Number(f64),
    /// A value that neither the program nor the machine file gives. Everything computed from it is unknown as well.
    Unknown(UnknownCause),
}

/// The source of an unknown value, which a user could give.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum UnknownCause {
    /// A variable by its number.
    Variable(u32),
    /// A variable written with letters: the index in the list of the grammar, and its number.
    Letters(u8, u32),
    /// A named variable of the control: the index among the names that the run has used.
    Name(u32),
}

impl MacroValue {
    /// The number in arithmetic, with vacant as zero; the cause when it is unknown.
    #[inline]
    pub fn counted(self) -> Result<f64, UnknownCause> {
        match self {
            MacroValue::Vacant => Ok(0.0),
            MacroValue::Number(number) => Ok(number),
            MacroValue::Unknown(cause) => Err(cause),
        }
    }

    /// The number in arithmetic, with vacant as zero; `None` when it is unknown.
    #[inline]
    pub fn known(self) -> Option<f64> {
        self.counted().ok()
    }

    /// A number, or unknown by `cause` for `None`.
    pub fn or_unknown(number: Option<f64>, cause: UnknownCause) -> MacroValue {
        number.map_or(MacroValue::Unknown(cause), MacroValue::Number)
    }

    /// Equal bit for bit: 0 differs from −0, and NaN equals itself.
    pub fn is_same(self, other: MacroValue) -> bool {
        match (self, other) {
            (MacroValue::Number(a), MacroValue::Number(b)) => a.to_bits() == b.to_bits(),
            (a, b) => a == b,
        }
    }
}

/// Whether a condition holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Truth {
    Holds,
    Fails,
    /// It depends on a value that is not known.
    Unknown(UnknownCause),
}

impl From<MacroValue> for Truth {
    fn from(value: MacroValue) -> Truth {
        match value {
            MacroValue::Number(number) if number != 0.0 => Truth::Holds,
            MacroValue::Number(_) | MacroValue::Vacant => Truth::Fails,
            MacroValue::Unknown(cause) => Truth::Unknown(cause),
        }
    }
}

/// EQ: vacant equals only vacant, not zero (Mitsubishi M700V p. 389).
#[inline]
pub(crate) fn equal(a: MacroValue, b: MacroValue, tolerance: f64) -> bool {
    match (a, b) {
        (MacroValue::Number(a), MacroValue::Number(b)) => a == b || (a - b).abs() < tolerance,
        (a, b) => a == MacroValue::Vacant && b == MacroValue::Vacant,
    }
}
