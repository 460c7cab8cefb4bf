//! Contacts of a body with stock along a move.

/// How deep a body reaches into stock on a move, along Z, mm; zero where nothing touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactDepth {
    /// Lower bound: its depth in what is certainly left.
    pub least: f64,
    /// Upper bound: its depth in what may be left.
    pub most: f64,
    /// Where the upper bound is reached: the middle of the cell, and the top of the stock there, mm.
    pub at: [f64; 3],
}

/// Whether a body reaches deeper into stock than a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TouchAnswer {
    /// It certainly does not.
    Clean,
    /// It certainly does, with this depth along Z, mm.
    Hit {
        /// Lower bound of the depth, mm.
        least: f64,
        /// Upper bound of the depth, mm.
        most: f64,
        /// Where it may be deepest, mm.
        at: [f64; 3],
    },
    /// The columns are too coarse to decide.
    Undecided {
        /// Upper bound of the depth along Z, mm.
        most: f64,
        /// Where it may be deepest, mm.
        at: [f64; 3],
    },
}

impl ContactDepth {
    /// No contact.
    pub const NONE: ContactDepth = ContactDepth { least: 0.0, most: 0.0, at: [0.0; 3] };

    /// The answer for a tolerance, mm. A body that slides over a face needs one above zero, since heights are known
    /// only to a hundredth of a micrometre at best.
    pub fn touch(&self, tolerance: f64) -> TouchAnswer {
        let ContactDepth { least, most, at } = *self;
        if most <= tolerance {
            TouchAnswer::Clean
        } else if least > tolerance {
            TouchAnswer::Hit { least, most, at }
        } else {
            TouchAnswer::Undecided { most, at }
        }
    }

    /// The deeper of two contacts, independent of their order.
    pub(crate) fn deeper(self, other: ContactDepth) -> ContactDepth {
        let first = self.most > other.most
            || (self.most == other.most && self.at.map(f64::to_bits) <= other.at.map(f64::to_bits));
        let deeper = if first { self } else { other };
        ContactDepth { least: self.least.max(other.least), ..deeper }
    }
}
