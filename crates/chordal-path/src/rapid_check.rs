//! Compares rapids below the clearance plane with what was cut before them.
//!
//! The stock is not known. The region of a cut is the box of all moves from one rapid to the next, and it counts as
//! cleared down to its lowest point. A rapid through such a region is safe at that depth. A rapid goes into the part if
//! it is inside the region of the whole program where no earlier cut has cleared. Outside of that region nothing is
//! known to be in the way. The check is made at the end of the run, when the whole region is known.

use chordal_command::{Origin, Units};
use chordal_diagnostics::TextShift;
use chordal_geometry::{Aabb, Vec3};

/// The largest number of rapids that are remembered in a run.
const MAX_RAPIDS: usize = 1000;

/// The largest number of regions that are remembered in a run; later regions are merged into the last one.
const MAX_CUTS: usize = 4096;

/// The number of points of a rapid that are checked.
const PLACES: u32 = 16;

/// Depths and distances up to this count as zero, mm.
const NEGLIGIBLE_MM: f64 = 1e-6;

/// The direction of a rapid.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum RapidDirection {
    /// Sideways, from one cut to another.
    Sideways,
    /// Down at an angle.
    Slanting,
    /// Straight down.
    Down,
}

/// A rapid that ends below the clearance plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LowRapid {
    pub direction: RapidDirection,
    pub from: Vec3,
    pub to: Vec3,
    /// The clearance plane, mm.
    pub plane: f64,
    pub units: Units,
    pub origin: Origin,
}

#[derive(Clone, Debug)]
enum CheckEvent {
    /// The box of the moves from one rapid to the next.
    Cut(Aabb),
    Rapid(LowRapid),
}

/// What a run, or a part of it, has cut, and the rapids between the cuts.
#[derive(Clone, Debug)]
pub(crate) struct RapidLog {
    events: Vec<CheckEvent>,
    rapids: usize,
    /// The region of the current cut.
    open: Aabb,
    /// Whether the first motion of this part was a rapid, which ends a cut of the part before it. `None` before the first
    /// motion.
    begins: Option<bool>,
}

impl Default for RapidLog {
    fn default() -> RapidLog {
        RapidLog { events: Vec::new(), rapids: 0, open: Aabb::EMPTY, begins: None }
    }
}

impl RapidLog {
    /// Extends the current cut by a move between known positions.
    #[inline]
    pub fn cut(&mut self, region: impl FnOnce(Aabb) -> Aabb) {
        self.open = region(self.open);
        if self.begins.is_none() {
            self.begins = Some(false);
        }
    }

    /// Ends the current cut at a rapid.
    #[inline]
    pub fn end_cut(&mut self) {
        if self.begins.is_none() {
            self.begins = Some(true);
        }
        if self.open != Aabb::EMPTY {
            let region = std::mem::replace(&mut self.open, Aabb::EMPTY);
            self.push_cut(region);
        }
    }

    /// Adds a rapid that ends below the clearance plane.
    pub fn rapid(&mut self, rapid: LowRapid) {
        if self.rapids < MAX_RAPIDS {
            self.rapids += 1;
            self.events.push(CheckEvent::Rapid(rapid));
        }
    }

    fn push_cut(&mut self, region: Aabb) {
        if self.events.len() - self.rapids < MAX_CUTS {
            return self.events.push(CheckEvent::Cut(region));
        }
        let last = self.events.iter_mut().rev().find_map(|event| match event {
            CheckEvent::Cut(last) => Some(last),
            CheckEvent::Rapid(_) => None,
        });
        if let Some(last) = last {
            *last = last.union(region);
        }
    }

    /// Adds the log of the part of the run that follows.
    pub fn and(&mut self, next: &RapidLog) {
        match next.begins {
            // Without a known motion there may still be a rapid, which was logged at a cut at an unknown position.
            None if next.events.is_empty() => return,
            Some(true) => self.end_cut(),
            None | Some(false) => {}
        }
        if self.begins.is_none() {
            self.begins = next.begins;
        }
        for event in &next.events {
            match event {
                CheckEvent::Cut(region) => {
                    let region = self.open.union(*region);
                    self.open = Aabb::EMPTY;
                    self.push_cut(region);
                }
                CheckEvent::Rapid(rapid) => self.rapid(*rapid),
            }
        }
        self.open = self.open.union(next.open);
    }

    /// Moves the positions in the text after an edit of other text; `None` if one of them was in the edited text.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        for event in &mut self.events {
            if let CheckEvent::Rapid(rapid) = event {
                rapid.origin = rapid.origin.shifted(shift)?;
            }
        }
        Some(())
    }

    /// Reports the rapids that go into the part.
    pub fn judge(mut self, mut report: impl FnMut(LowRapid)) {
        self.end_cut();
        let whole = self.cuts(&self.events).fold(Aabb::EMPTY, Aabb::union);
        for (index, event) in self.events.iter().enumerate() {
            let CheckEvent::Rapid(rapid) = event else { continue };
            let (before, after) = self.events.split_at(index);
            // A plunge next to a contour is on the edge of the region of the cut that follows, not inside.
            let region = match rapid.direction {
                RapidDirection::Down => self.cuts(after).next().unwrap_or(whole),
                RapidDirection::Sideways | RapidDirection::Slanting => whole,
            };
            let cleared = |place: Vec3| self.cuts(before).any(|cut| clears(&cut, place));
            if rapid.places().any(|place| is_inside(&region, place) && !cleared(place)) {
                report(*rapid);
            }
        }
    }

    fn cuts<'e>(&self, events: &'e [CheckEvent]) -> impl Iterator<Item = Aabb> + use<'e> {
        events.iter().filter_map(|event| match event {
            CheckEvent::Cut(region) => Some(*region),
            CheckEvent::Rapid(_) => None,
        })
    }
}

impl LowRapid {
    /// How far below the clearance plane it goes, mm.
    pub fn depth(&self) -> f64 {
        self.plane - self.to.z
    }

    /// Points along it that are below the clearance plane, including its end.
    fn places(&self) -> impl Iterator<Item = Vec3> + '_ {
        let along =
            |step: u32| self.from + (self.to - self.from) * (f64::from(step) / f64::from(PLACES));
        let first = if self.direction == RapidDirection::Down { PLACES } else { 1 };
        (first..=PLACES)
            .map(move |step| if step == PLACES { self.to } else { along(step) })
            .filter(|place| place.z < self.plane - NEGLIGIBLE_MM)
    }
}

/// Whether a point is strictly inside a region, seen from above; along an axis in which the region has no width, whether
/// it is on it.
fn is_inside(region: &Aabb, place: Vec3) -> bool {
    let within = |place: f64, low: f64, high: f64| match high - low > NEGLIGIBLE_MM {
        true => place > low + NEGLIGIBLE_MM && place < high - NEGLIGIBLE_MM,
        false => (place - low).abs() <= NEGLIGIBLE_MM,
    };
    within(place.x, region.min.x, region.max.x) && within(place.y, region.min.y, region.max.y)
}

/// Whether a cut has cleared a point: its region contains it, seen from above, and is at least as deep.
fn clears(cut: &Aabb, place: Vec3) -> bool {
    let near = NEGLIGIBLE_MM;
    cut.min.z <= place.z + near
        && (cut.min.x - near..=cut.max.x + near).contains(&place.x)
        && (cut.min.y - near..=cut.max.y + near).contains(&place.y)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn v(x: f64, y: f64, z: f64) -> Vec3 {
        Vec3::new(x, y, z)
    }

    fn rapid(way: RapidDirection, from: Vec3, to: Vec3) -> LowRapid {
        LowRapid {
            direction: way,
            from,
            to,
            plane: 0.0,
            units: Units::Millimetre,
            origin: Origin::default(),
        }
    }

    /// A pocket from 0,0 to 10,10 cut to 5 deep, then a rapid, then a cut far away.
    fn log(then: LowRapid) -> RapidLog {
        let mut log = RapidLog::default();
        log.cut(|open| open.include(v(0.0, 0.0, 0.0)).include(v(10.0, 10.0, -5.0)));
        log.end_cut();
        log.rapid(then);
        log.cut(|open| open.include(v(40.0, 0.0, -5.0)).include(v(50.0, 10.0, -5.0)));
        log
    }

    fn found(log: RapidLog) -> usize {
        let mut count = 0;
        log.judge(|_| count += 1);
        count
    }

    #[test]
    fn a_rapid_within_what_is_cut_is_safe() {
        assert_eq!(
            found(log(rapid(RapidDirection::Sideways, v(1.0, 1.0, -5.0), v(9.0, 9.0, -5.0)))),
            0
        );
        // Deeper than the cut.
        assert_eq!(
            found(log(rapid(RapidDirection::Sideways, v(1.0, 1.0, -6.0), v(9.0, 9.0, -6.0)))),
            1
        );
    }

    #[test]
    fn a_rapid_along_a_slot_is_found() {
        let mut log = RapidLog::default();
        log.cut(|open| open.include(v(0.0, 0.0, 0.0)).include(v(0.0, 0.0, -1.0)));
        log.end_cut();
        log.rapid(rapid(RapidDirection::Sideways, v(0.0, 0.0, -1.0), v(1.0, 0.0, -1.0)));
        log.cut(|open| open.include(v(1.0, 0.0, -1.0)).include(v(2.0, 0.0, -1.0)));
        assert_eq!(found(log), 1);
    }

    #[test]
    fn a_rapid_beside_the_faces_is_safe() {
        let mut log = RapidLog::default();
        log.cut(|open| open.include(v(-10.0, 0.0, -1.0)).include(v(110.0, 0.0, -1.0)));
        log.end_cut();
        log.rapid(rapid(RapidDirection::Sideways, v(110.0, 0.0, -1.0), v(110.0, 10.0, -1.0)));
        log.cut(|open| open.include(v(110.0, 10.0, -1.0)).include(v(-10.0, 10.0, -1.0)));
        assert_eq!(found(log), 0);
    }

    #[test]
    fn a_rapid_from_pocket_to_pocket_is_found() {
        assert_eq!(
            found(log(rapid(RapidDirection::Sideways, v(9.0, 5.0, -5.0), v(45.0, 5.0, -5.0)))),
            1
        );
    }

    #[test]
    fn a_plunge_is_found_inside_what_is_cut_next_and_not_on_its_edge() {
        let down = |x: f64, y: f64| rapid(RapidDirection::Down, v(x, y, 5.0), v(x, y, -5.0));
        assert_eq!(found(log(down(45.0, 5.0))), 1);
        assert_eq!(found(log(down(40.0, 5.0))), 0, "where the contour begins");
        assert_eq!(found(log(down(5.0, 5.0))), 0, "cut before");
    }

    #[test]
    fn stretches_make_the_same_as_the_whole() {
        let mut first = RapidLog::default();
        first.cut(|open| open.include(v(0.0, 0.0, 0.0)));
        let mut second = RapidLog::default();
        second.cut(|open| open.include(v(10.0, 10.0, -5.0)));
        second.end_cut();
        second.rapid(rapid(RapidDirection::Sideways, v(9.0, 5.0, -5.0), v(45.0, 5.0, -5.0)));
        let mut third = RapidLog::default();
        third.cut(|open| open.include(v(40.0, 0.0, -5.0)).include(v(50.0, 10.0, -5.0)));
        first.and(&second);
        first.and(&third);
        let whole = log(rapid(RapidDirection::Sideways, v(9.0, 5.0, -5.0), v(45.0, 5.0, -5.0)));
        assert_eq!(format!("{first:?}"), format!("{whole:?}"));
    }

    #[test]
    fn a_stretch_with_nothing_but_a_rapid_counts() {
        // The rapid led to a cut at an unknown place, which is in no region.
        let way = rapid(RapidDirection::Sideways, v(9.0, 5.0, -5.0), v(45.0, 5.0, -5.0));
        let mut second = RapidLog::default();
        second.rapid(way);
        let mut first = RapidLog::default();
        first.cut(|open| open.include(v(0.0, 0.0, 0.0)).include(v(50.0, 10.0, -5.0)));
        first.end_cut();
        first.and(&second);
        assert_eq!(first.rapids, 1);
    }
}
