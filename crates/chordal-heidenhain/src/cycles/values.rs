//! The parameters of a cycle, in mm and mm/s.

use std::collections::BTreeMap;

use super::step::{CycleFeed, KlartextCycleFault};

/// The values of a cycle's parameters.
#[derive(Clone, Debug)]
pub struct CycleValues {
    numbers: BTreeMap<u32, f64>,
    feeds: BTreeMap<u32, CycleFeed>,
    unit_mm: f64,
    feed_unit: f64,
}

/// The levels at which a cycle with its surface in Q203 works, mm.
#[derive(Clone, Copy, Debug)]
pub struct CycleLevels {
    /// Q200 above the surface: where the tool goes by a rapid first.
    pub clearance: f64,
    /// Where the cut begins.
    pub surface: f64,
    /// Where it ends.
    pub bottom: f64,
    /// Q204 above the surface, or the clearance: where the tool is after the cycle.
    pub end: f64,
}

/// A depth Q201, mm; `None` for zero, with which a cycle does nothing.
///
/// # Errors
/// For a positive one where it is refused.
pub fn checked_depth(
    depth: f64,
    refuses_positive: bool,
) -> Result<Option<f64>, KlartextCycleFault> {
    if depth > 0.0 && refuses_positive {
        let message = format!("the depth Q201 is {depth}: it is negative downwards");
        return Err(KlartextCycleFault::BadValue(message));
    }
    Ok(Some(depth).filter(|depth| *depth != 0.0))
}

impl CycleValues {
    /// Values in a unit of length (mm) and of feed (mm/s).
    pub fn new(
        numbers: BTreeMap<u32, f64>,
        feeds: BTreeMap<u32, CycleFeed>,
        unit_mm: f64,
        feed_unit: f64,
    ) -> CycleValues {
        CycleValues { numbers, feeds, unit_mm, feed_unit }
    }

    /// Whether a parameter has a value.
    pub fn has(&self, number: u32) -> bool {
        self.numbers.contains_key(&number) || self.feeds.contains_key(&number)
    }

    /// A number as written; 0 without one.
    pub fn number(&self, number: u32) -> f64 {
        self.numbers.get(&number).copied().unwrap_or(0.0)
    }

    /// A length, mm; 0 without one.
    pub fn length(&self, number: u32) -> f64 {
        self.number(number) * self.unit_mm
    }

    /// A feed; the active one of the program without it.
    pub fn feed(&self, number: u32) -> CycleFeed {
        match self.feeds.get(&number) {
            Some(feed) => *feed,
            None if self.number(number) > 0.0 => {
                CycleFeed::Speed(self.number(number) * self.feed_unit)
            }
            None => CycleFeed::Active,
        }
    }

    /// The depth Q201 of a cycle that works downwards alone, mm, negative; `None` for zero, with which it does nothing.
    ///
    /// # Errors
    /// For a positive one.
    pub fn downward_depth(&self) -> Result<Option<f64>, KlartextCycleFault> {
        checked_depth(self.length(201), true)
    }

    /// The levels of a cycle with a depth, mm, below its surface Q203.
    pub fn levels(&self, depth: f64) -> CycleLevels {
        let surface = self.length(203);
        let clearance = surface + self.length(200);
        CycleLevels {
            clearance,
            surface,
            bottom: surface + depth,
            end: clearance.max(surface + self.length(204)),
        }
    }

    /// A feed; another one without it.
    pub fn feed_or(&self, number: u32, other: CycleFeed) -> CycleFeed {
        match self.feed(number) {
            CycleFeed::Active => other,
            feed => feed,
        }
    }

    /// The retraction feed of Q208; 0 is the plunging feed.
    pub fn retraction(&self) -> CycleFeed {
        self.feed_or(208, self.feed(206))
    }

    /// A copy with other values: those that a pattern gives to the cycle before it.
    pub fn with(&self, other: &CycleValues, numbers: &[u32]) -> CycleValues {
        let mut new = self.clone();
        for number in numbers {
            if let Some(value) = other.numbers.get(number) {
                new.numbers.insert(*number, *value);
            }
        }
        new
    }

    /// A copy whose surface is at another level, mm.
    pub fn with_surface(&self, surface_mm: f64) -> CycleValues {
        let mut new = self.clone();
        new.numbers.insert(203, surface_mm / self.unit_mm);
        new
    }
}
