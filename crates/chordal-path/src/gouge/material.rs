//! Which of the programmed blocks are the contour of the part.

use core::f64::consts::{PI, TAU};

use chordal_geometry::Vec2;

use super::shape::{PlaneCurve, wrapped};
use super::{Block, Contour, Options, Role, distance};

/// So many blocks at either end may be the run up to the contour or away from it. A vertex that a
/// longer tail leaves is a loop of the contour, not its closing point.
const LONGEST_TAIL: usize = 3;

/// The contour of the part, and what was taken away to find it.
#[derive(Clone, Debug, Default)]
pub struct Material {
    /// The curves in the order of the chain, each once.
    pub curves: Vec<PlaneCurve>,
    /// The block of each curve.
    pub tags: Vec<u32>,
    /// Whether the curve does not begin where the one before it ends.
    pub breaks: Vec<bool>,
    /// The ends of an open chain, mm; none when it closes.
    pub open_ends: Vec<Vec2>,
    /// Pairs of blocks that run along the same curve in opposite directions: a slit, of which no
    /// side is the part.
    pub ambiguous: Vec<(u32, u32)>,
    /// Arcs at the ends that only lead the tool to the contour and away.
    pub lead_arcs: Vec<Block>,
    /// Every block of the part with the curve that stands for it, in the order of tags; repeats
    /// of a curve name its first place.
    places: Vec<(u32, u32)>,
}

/// No curve stands for the tag, or several do.
const NOWHERE: u32 = u32::MAX;

impl Material {
    /// Takes the contour of the part out of the programmed blocks.
    ///
    /// Blocks marked [`Role::Part`] are the part and nothing else is. Without marks: a chain that
    /// comes back to a vertex is the part from the first to the last visit; from an open chain go
    /// a first and last arc that is tangent to its neighbour, has the tool inside and sweeps no more
    /// than half a turn, and what runs off beyond the chain's crossing with itself.
    #[must_use]
    pub fn of(contour: &Contour, options: &Options) -> Material {
        let usable = |b: &&Block| b.curve.is_finite() && b.curve.length() > 0.0;
        let marked = contour.blocks.iter().any(|b| b.role == Role::Part);
        let wanted = if marked { Role::Part } else { Role::Offset };
        let mut chain: Vec<Block> =
            contour.blocks.iter().filter(usable).filter(|b| b.role == wanted).copied().collect();
        let mut material = Material::default();
        if !marked {
            keep_between_visits(&mut chain, options.vertex);
            if !closes(&chain, options.vertex) {
                material.strip_lead_arcs(&mut chain, contour, options.tangent);
                strip_run_off(&mut chain, contour.radius);
            }
        }
        if let (false, Some(first), Some(last)) =
            (closes(&chain, options.vertex), chain.first(), chain.last())
        {
            material.open_ends = vec![first.curve.from(), last.curve.to()];
        }
        material.enter(&chain, options.vertex);
        material
    }

    fn strip_lead_arcs(&mut self, chain: &mut Vec<Block>, contour: &Contour, tangent: f64) {
        let leads = |block: &Block| match block.curve {
            PlaneCurve::Arc { sweep, .. } => {
                sweep * contour.side.sign() > 0.0 && sweep.abs() <= PI + 1e-6
            }
            PlaneCurve::Line { .. } => false,
        };
        let smooth =
            |before: &Block, after: &Block| turn(&before.curve, &after.curve).abs() <= tangent;
        if let [first, second, ..] = chain[..]
            && leads(&first)
            && smooth(&first, &second)
        {
            self.lead_arcs.push(first);
            chain.remove(0);
        }
        if let [.., second, last] = chain[..]
            && leads(&last)
            && smooth(&second, &last)
        {
            self.lead_arcs.push(last);
            chain.pop();
        }
    }

    /// Enters the curves once each, and notes those that are run both ways.
    fn enter(&mut self, chain: &[Block], grain: f64) {
        let mut seen = Seen::with_room(chain.len());
        let mut places = Vec::with_capacity(chain.len());
        let mut last: Option<Vec2> = None;
        for block in chain {
            let (from, to) = (block.curve.from(), block.curve.to());
            let place = self.curves.len() as u32;
            let curves = &self.curves;
            let key_at = |at: u32| {
                let curve = &curves[at as usize];
                Key::of(curve, curve.from(), curve.to(), grain)
            };
            match seen.find_or_enter(Key::of(&block.curve, from, to, grain), place, key_at) {
                None => {
                    self.breaks.push(last.is_some_and(|p| p.distance(from) > grain));
                    self.curves.push(block.curve);
                    self.tags.push(block.tag);
                    places.push((block.tag, place));
                    last = Some(to);
                }
                Some((before, same_way)) => {
                    if !same_way {
                        self.ambiguous.push((self.tags[before as usize], block.tag));
                    }
                    places.push((block.tag, before));
                }
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

    /// The curve that stands for a block, tried first at `guess` and after it: the tags of a path
    /// come in order.
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

    /// Whether the block is of the part's contour.
    #[must_use]
    pub fn has(&self, tag: u32) -> bool {
        self.places.binary_search_by_key(&tag, |p| p.0).is_ok()
    }

    /// Whether the chain closes on itself.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.open_ends.is_empty()
    }
}

/// The turn from the end of one curve to the start of the next, rad, in −π..=π.
pub(super) fn turn(before: &PlaneCurve, after: &PlaneCurve) -> f64 {
    wrapped(after.tangent_angles().0 - before.tangent_angles().1)
}

fn closes(chain: &[Block], vertex: f64) -> bool {
    match (chain.first(), chain.last()) {
        (Some(first), Some(last)) => first.curve.from().distance(last.curve.to()) <= vertex,
        _ => true,
    }
}

/// Of a chain that comes back to a vertex, keeps the longest stretch between two visits.
fn keep_between_visits(chain: &mut Vec<Block>, vertex: f64) {
    let count = chain.len();
    let mut best: Option<(usize, usize)> = None;
    for first in 0..count.min(LONGEST_TAIL + 1) {
        let from = chain[first].curve.from();
        for dropped in 0..=LONGEST_TAIL.min(count - 1 - first) {
            let end = count - dropped;
            if end <= first || chain[end - 1].curve.to().distance(from) > vertex {
                continue;
            }
            if best.is_none_or(|(f, e)| end - first > e - f) {
                best = Some((first, end));
            }
        }
    }
    if let Some((first, end)) = best {
        chain.truncate(end);
        chain.drain(..first);
    }
}

/// Cuts an open chain where its first and last line cross, each prolonged by the tool radius: what
/// lies beyond only takes the tool off the part.
fn strip_run_off(chain: &mut [Block], radius: f64) {
    let count = chain.len();
    if count < 3 {
        return;
    }
    let (first, last) = (chain[0].curve, chain[count - 1].curve);
    let (PlaneCurve::Line { from: a, to: b }, PlaneCurve::Line { from: c, to: d }) = (first, last)
    else {
        return;
    };
    let (Some(t), Some(u)) = ((b - a).normalized(), (d - c).normalized()) else { return };
    let before = PlaneCurve::line(a - t * radius, b);
    let beyond = PlaneCurve::line(c, d + u * radius);
    let near = distance::nearest(&before, &beyond);
    if near.square > 0.0 || near.first == b || near.first == c {
        return;
    }
    let cross = near.first;
    let runs_on = (d - cross).dot(u);
    let begins_before = (cross - a).dot(t);
    // One of the two must really pass the crossing; two walls that stop short have no run-off.
    if runs_on <= 0.0 && begins_before <= 0.0 {
        return;
    }
    if begins_before > 0.0 {
        chain[0].curve = PlaneCurve::line(cross, b);
    }
    if runs_on > 0.0 {
        chain[count - 1].curve = PlaneCurve::line(c, cross);
    }
}

/// A curve by its quantised ends and centre, the same for both directions.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Key {
    low: (i64, i64),
    high: (i64, i64),
    center: (i64, i64),
    forward: bool,
}

impl Key {
    fn of(curve: &PlaneCurve, from: Vec2, to: Vec2, grain: f64) -> Key {
        // Off the round numbers, at which two roundings of one point would part.
        let cells = 1.0 / grain;
        let cell = |p: Vec2| ((p.a * cells + 0.37) as i64, (p.b * cells + 0.37) as i64);
        let (first, second) = (cell(from), cell(to));
        let (center, whole) = match *curve {
            PlaneCurve::Line { .. } => ((i64::MAX, 0), None),
            PlaneCurve::Arc { center, sweep, .. } => {
                (cell(center), (sweep.abs() > TAU - 1e-9).then_some(sweep > 0.0))
            }
        };
        let arc_way = match *curve {
            PlaneCurve::Arc { sweep, .. } if whole.is_none() => Some(sweep > 0.0),
            _ => None,
        };
        let forward = whole.unwrap_or(first <= second);
        // The two arcs of one circle between the same ends differ in their way round: put it into
        // the key as seen from the lower end.
        let round = arc_way.map_or(0, |left| if left == forward { 1 } else { 2 });
        let center = (center.0, center.1.wrapping_mul(3).wrapping_add(round));
        let (low, high) = if first <= second { (first, second) } else { (second, first) };
        Key { low, high, center, forward }
    }

    fn hash(&self) -> u64 {
        let mut h = 0u64;
        for v in [self.low.0, self.low.1, self.high.0, self.high.1, self.center.0, self.center.1] {
            h = (h.rotate_left(5) ^ v as u64).wrapping_mul(0x517c_c1b7_2722_0a95);
        }
        h ^ (h >> 29)
    }
}

/// The curves entered so far: a table by hash, filled to one half at most. A slot holds the upper half
/// of the hash and the place; the key itself is made again from the curve when these agree.
struct Seen {
    slots: Vec<u64>,
}

/// No curve in the slot.
const FREE: u64 = u64::MAX;

impl Seen {
    fn with_room(count: usize) -> Seen {
        Seen { slots: vec![FREE; (2 * count + 2).next_power_of_two()] }
    }

    /// The place of an equal curve and whether it runs the same way, or enters this one.
    fn find_or_enter(
        &mut self,
        key: Key,
        place: u32,
        key_at: impl Fn(u32) -> Key,
    ) -> Option<(u32, bool)> {
        let mask = self.slots.len() - 1;
        let hash = key.hash();
        let mut slot = hash as usize & mask;
        while self.slots[slot] != FREE {
            let (mark, at) = (self.slots[slot] >> 32, self.slots[slot] as u32);
            if mark == hash >> 32 {
                let other = key_at(at);
                if (other.low, other.high, other.center) == (key.low, key.high, key.center) {
                    return Some((at, other.forward == key.forward));
                }
            }
            slot = (slot + 1) & mask;
        }
        self.slots[slot] = hash >> 32 << 32 | u64::from(place);
        None
    }
}
