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
        let depth = self.length(201);
        if depth > 0.0 {
            let message = format!("the depth Q201 is {depth}: it is negative downwards");
            return Err(KlartextCycleFault::BadValue(message));
        }
        Ok(Some(depth).filter(|depth| *depth != 0.0))
    }

    /// The retraction feed of Q208; 0 is the plunging feed.
    pub fn retraction(&self) -> CycleFeed {
        match self.feed(208) {
            CycleFeed::Active => self.feed(206),
            feed => feed,
        }
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
