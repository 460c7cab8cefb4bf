//! Whether a body touches stock on its way.

/// How deep a body may reach into stock on a move, along Z, mm. Nothing touches where it is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactDepth {
    /// The body reaches at least so deep into what is surely left.
    pub least: f64,
    /// It reaches nowhere deeper into what may be left.
    pub most: f64,
    /// Where that is: the middle of the cell, and the top of the stock there, mm.
    pub at: [f64; 3],
}

/// The answer to the question whether a body reaches deeper into stock than a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TouchAnswer {
    /// It surely does not.
    Clean,
    /// It surely does, by so much (along Z, mm).
    Hit {
        /// At least.
        least: f64,
        /// At most.
        most: f64,
        /// Where it may be deepest, mm.
        at: [f64; 3],
    },
    /// The columns are too coarse to say.
    Undecided {
        /// At most so deep, along Z, mm.
        most: f64,
        /// Where it may be deepest, mm.
        at: [f64; 3],
    },
}

impl ContactDepth {
    /// No contact.
    pub const NONE: ContactDepth = ContactDepth { least: 0.0, most: 0.0, at: [0.0; 3] };

    /// The answer for a tolerance, mm: heights themselves are known to a hundredth of a micrometre at best, so
    /// a body that only slides over a face needs one.
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

    /// The deeper of two, whichever comes first.
    pub(crate) fn deeper(self, other: ContactDepth) -> ContactDepth {
        let first = self.most > other.most
            || (self.most == other.most && self.at.map(f64::to_bits) <= other.at.map(f64::to_bits));
        let deeper = if first { self } else { other };
        ContactDepth { least: self.least.max(other.least), ..deeper }
    }
}
