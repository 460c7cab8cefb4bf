//! Finds which of the programmed blocks are the contour of the part.

use core::f64::consts::TAU;

use chordal_geometry::Vec2;

use super::chain::closes;
use super::shape::GougeCurve;
use super::{Contour, ContourBlock, GougeOptions, GougeRole, closing, walls};

/// The contour of the part, and the blocks that were found not to belong to it.
#[derive(Clone, Debug, Default)]
pub struct PartContour {
    /// The curves in the order of the chain, without repetitions.
    pub curves: Vec<GougeCurve>,
    /// The tag of the block of each curve.
    pub tags: Vec<u32>,
    /// True for a curve that does not begin where the one before it ends.
    pub breaks: Vec<bool>,
    /// The ends of an open chain, mm; empty if it closes.
    pub open_ends: Vec<Vec2>,
    /// Pairs of tags of blocks that follow the same curve in opposite directions: neither side of it is known to be the
    /// part.
    pub ambiguous: Vec<(u32, u32)>,
    /// Arcs at the ends that only lead the tool to the contour and away from it.
    pub lead_arcs: Vec<ContourBlock>,
    /// For the tag of every block of the part the index of its curve, in the order of tags. Blocks that repeat a curve
    /// have the same index.
    places: Vec<(u32, u32)>,
}

/// The tag has no curve, or more than one.
const NOWHERE: u32 = u32::MAX;

impl PartContour {
    /// Finds the contour of the part in the programmed blocks: see [`walls`].
    ///
    /// If there are blocks marked [`GougeRole::Part`], only they are the part.
    #[must_use]
    pub fn of(contour: &Contour, options: &GougeOptions) -> PartContour {
        if let Some(marked) = PartContour::marked(contour, options) {
            return marked;
        }
        let chain = chain(contour, GougeRole::Offset);
        let walls = walls::of(contour, chain.clone(), options);
        let mut material = PartContour { lead_arcs: walls.lead_arcs, ..PartContour::default() };
        if let (false, Some(first), Some(last)) =
            (walls.closed, walls.blocks.first(), walls.blocks.last())
        {
            material.open_ends = vec![first.curve.from(), last.curve.to()];
        }
        material.enter(&walls.blocks, &chain, options.vertex);
        material
    }

    /// All blocks that could be the contour: only those at the ends of the chain that are certainly leads are dropped. If
    /// nothing cuts into this contour, nothing cuts into the part.
    #[must_use]
    pub fn at_most(contour: &Contour, options: &GougeOptions) -> PartContour {
        if let Some(marked) = PartContour::marked(contour, options) {
            return marked;
        }
        let mut chain = chain(contour, GougeRole::Offset);
        if let Some((first, end)) = closing::at_ends(&chain, contour.side.sign(), options) {
            chain.truncate(end);
            chain.drain(..first);
        }
        let mut material = PartContour::default();
        if let (false, Some(first), Some(last)) =
            (closes(&chain, options.vertex), chain.first(), chain.last())
        {
            material.open_ends = vec![first.curve.from(), last.curve.to()];
        }
        material.enter(&chain, &[], options.vertex);
        material
    }

    /// The blocks that the user marked as the part; `None` without marks.
    fn marked(contour: &Contour, options: &GougeOptions) -> Option<PartContour> {
        let chain = chain(contour, GougeRole::Part);
        let mut material = PartContour::default();
        if !closes(&chain, options.vertex) {
            material.open_ends = vec![chain.first()?.curve.from(), chain.last()?.curve.to()];
        }
        material.enter(&chain, &[], options.vertex);
        (!chain.is_empty()).then_some(material)
    }

    /// Enters each curve once, and records those that are followed in both directions. Blocks of `again` that are not in
    /// the chain but follow one of its curves get the index of that curve.
    fn enter(&mut self, chain: &[ContourBlock], again: &[ContourBlock], grain: f64) {
        let mut seen = CurveSet::with_room(chain.len());
        let mut places = Vec::with_capacity(chain.len());
        let mut last: Option<Vec2> = None;
        for block in chain {
            let (from, to) = (block.curve.from(), block.curve.to());
            let place = self.curves.len() as u32;
            let curves = &self.curves;
            let key_at = |at: u32| {
                let curve = &curves[at as usize];
                CurveKey::of(curve, curve.from(), curve.to(), grain)
            };
            match seen.find_or_enter(CurveKey::of(&block.curve, from, to, grain), place, key_at) {
                None => {
                    self.breaks.push(last.is_some_and(|p| p.distance(from) > grain));
                    self.curves.push(block.curve);
                    self.tags.push(block.tag);
                    places.push((block.tag, place));
                    last = Some(to);
                }
                Some((before, same_direction)) => {
                    if !same_direction {
                        self.ambiguous.push((self.tags[before as usize], block.tag));
                    }
                    places.push((block.tag, before));
                }
            }
        }
        let mut entered = chain.iter().map(|block| block.tag).peekable();
        for block in again {
            if entered.next_if_eq(&block.tag).is_some() {
                continue;
            }
            let key = CurveKey::of(&block.curve, block.curve.from(), block.curve.to(), grain);
            let key_at = |at: u32| {
                let curve = &self.curves[at as usize];
                CurveKey::of(curve, curve.from(), curve.to(), grain)
            };
            if let Some((before, true)) = seen.find(key, key_at) {
                places.push((block.tag, before));
            }
        }
        places.sort_unstable();
        places.dedup();
        let mut k = 0;
        while k < places.len() {
            let same = places[k..].iter().take_while(|p| p.0 == places[k].0).count();
            if same > 1 {
                places[k..k + same].iter_mut().for_each(|p| p.1 = NOWHERE);
            }
            k += same;
        }
        self.places = places;
    }

    /// The index of the curve of a block. The search starts at `guess`, because the tags of a path are mostly in order.
    pub(super) fn place(&self, tag: u32, guess: &mut usize) -> Option<usize> {
        for at in [*guess, *guess + 1] {
            if let Some(&(found, place)) = self.places.get(at)
                && found == tag
            {
                *guess = at;
                return (place != NOWHERE).then_some(place as usize);
            }
        }
        let at = self.places.partition_point(|p| p.0 < tag);
        let &(found, place) = self.places.get(at)?;
        if found != tag {
            return None;
        }
        *guess = at;
        (place != NOWHERE).then_some(place as usize)
    }

    /// Whether the block belongs to the contour of the part.
    #[must_use]
    pub fn has(&self, tag: u32) -> bool {
        self.places.binary_search_by_key(&tag, |p| p.0).is_ok()
    }

    /// Whether the chain is closed.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.open_ends.is_empty()
    }
}

/// The blocks of a role that have a length, in order.
fn chain(contour: &Contour, role: GougeRole) -> Vec<ContourBlock> {
    let usable = |b: &&ContourBlock| b.curve.is_finite() && b.curve.length() > 0.0;
    contour.blocks.iter().filter(usable).filter(|b| b.role == role).copied().collect()
}

/// Identifies a curve by its quantised ends and centre; apart from `forward`, it is the same for both directions.
#[derive(Clone, Copy, PartialEq, Eq)]
struct CurveKey {
    low: (i64, i64),
    high: (i64, i64),
    center: (i64, i64),
    forward: bool,
}

impl CurveKey {
    fn of(curve: &GougeCurve, from: Vec2, to: Vec2, grain: f64) -> CurveKey {
        // The offset keeps cell borders away from round numbers, where roundings of one point could fall into two cells.
        let cells = 1.0 / grain;
        let cell = |p: Vec2| ((p.a * cells + 0.37) as i64, (p.b * cells + 0.37) as i64);
        let (first, second) = (cell(from), cell(to));
        let (center, whole) = match *curve {
            GougeCurve::Line { .. } => ((i64::MAX, 0), None),
            GougeCurve::Arc { center, sweep, .. } => {
                (cell(center), (sweep.abs() > TAU - 1e-9).then_some(sweep > 0.0))
            }
        };
        let arc_path = match *curve {
            GougeCurve::Arc { sweep, .. } if whole.is_none() => Some(sweep > 0.0),
            _ => None,
        };
        let forward = whole.unwrap_or(first <= second);
        // The two arcs of one circle between the same ends differ in direction, seen from the lower end: this goes into
        // the key.
        let round = arc_path.map_or(0, |left| if left == forward { 1 } else { 2 });
        let center = (center.0, center.1.wrapping_mul(3).wrapping_add(round));
        let (low, high) = if first <= second { (first, second) } else { (second, first) };
        CurveKey { low, high, center, forward }
    }

    fn hash(&self) -> u64 {
        let mut h = 0u64;
        for v in [self.low.0, self.low.1, self.high.0, self.high.1, self.center.0, self.center.1] {
            h = (h.rotate_left(5) ^ v as u64).wrapping_mul(0x517c_c1b7_2722_0a95);
        }
        h ^ (h >> 29)
    }
}

/// The curves entered so far: a hash table, at most half full. A slot holds the upper half of the hash and the index of
/// the curve; if the hash matches, the key is computed from the curve again.
struct CurveSet {
    slots: Vec<u64>,
}

/// An empty slot.
const FREE: u64 = u64::MAX;

impl CurveSet {
    fn with_room(count: usize) -> CurveSet {
        CurveSet { slots: vec![FREE; (2 * count + 2).next_power_of_two()] }
    }

    /// The index of an equal curve and whether it has the same direction; if there is none, enters this one.
    fn find_or_enter(
        &mut self,
        key: CurveKey,
        place: u32,
        key_at: impl Fn(u32) -> CurveKey,
    ) -> Option<(u32, bool)> {
        let found = self.slot_of(key, key_at);
        if let Err(slot) = found {
            self.slots[slot] = key.hash() >> 32 << 32 | u64::from(place);
        }
        found.ok()
    }

    /// The index of an equal curve and whether it has the same direction.
    fn find(&self, key: CurveKey, key_at: impl Fn(u32) -> CurveKey) -> Option<(u32, bool)> {
        self.slot_of(key, key_at).ok()
    }

    /// The equal curve, or else the free slot for it.
    #[inline]
    fn slot_of(
        &self,
        key: CurveKey,
        key_at: impl Fn(u32) -> CurveKey,
    ) -> Result<(u32, bool), usize> {
        let mask = self.slots.len() - 1;
        let hash = key.hash();
        let mut slot = hash as usize & mask;
        while self.slots[slot] != FREE {
            let (mark, at) = (self.slots[slot] >> 32, self.slots[slot] as u32);
            if mark == hash >> 32 {
                let other = key_at(at);
                if (other.low, other.high, other.center) == (key.low, key.high, key.center) {
                    return Ok((at, other.forward == key.forward));
                }
            }
            slot = (slot + 1) & mask;
        }
        Err(slot)
    }
}
