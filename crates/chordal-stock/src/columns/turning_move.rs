//! Moves of tools whose axis is not along Z, and turns.
//!
//! A move is divided into parts on which the tool hardly turns. What each element of the tool sweeps on a part lies
//! between two convex bodies. Over a cell the inner one certainly contains what its chords over the four corners have
//! in common; the outer one, grown by half the diagonal of the cell, has a chord over the middle that contains
//! everything that may be swept over it.

use chordal_geometry::Curve;

use super::ContactDepth;
use super::gaps::SolidColumn;
use super::grid::{BLOCK, BLOCKS, CELLS, StockGrid, TILE};
use super::tile::StockTile;
use crate::RemovedSpan;
use crate::oblique::{AxialSolid, ConvexElement, ElementMotion, SweptElement, ToolTurn};

/// The deviation of a part of a move that is cut, as a share of the side of a cell.
const DEVIATION_SHARE: f64 = 0.125;
/// Most parts of one move. With more needed, the bounds become wider.
const MAX_PARTS: u32 = 4096;
/// How often a part of a move is halved to decide a contact.
const MAX_HALVINGS: u32 = 12;
/// Parts into which a move is divided to find its tiles.
const TILE_PARTS: u32 = 8;
/// On a move that cuts and may touch, the tool moves by at most this many cells before it is asked again, and at most
/// this many times.
const CELLS_PER_STEP: f64 = 1.0;
const MAX_STEPS: u32 = 256;

/// What a tool that turns removes, and what must not touch.
#[derive(Clone, Copy, Debug)]
pub struct TurningTask<'a> {
    /// How the direction of the tool turns on each move of the task.
    pub turns: &'a [ToolTurn],
    /// What it removes; `None` for moves that only compare.
    pub removes: Option<&'a AxialSolid>,
    /// A larger body for the upper bound: what it sweeps may be removed.
    pub may: Option<&'a AxialSolid>,
    /// Bodies that are compared with the stock.
    pub bodies: &'a [AxialSolid],
}

impl TurningTask<'_> {
    /// The number of straight sweeps of a part of the tool that a move takes in columns with this side, mm.
    pub fn sweeps(&self, curve: &Curve, turn: &ToolTurn, resolution: f64) -> u64 {
        let motion = ElementMotion::new(curve, turn);
        let of = |solid: &AxialSolid| {
            let elements = solid.elements();
            let parts = motion.parts(elements, DEVIATION_SHARE * resolution, MAX_PARTS);
            u64::from(parts) * elements.len() as u64
        };
        self.removes.into_iter().chain(self.may).map(of).sum()
    }
}

/// A whole move of a tool that turns.
#[derive(Clone, Debug)]
pub(crate) struct TurningMove {
    pub curve: Curve,
    pub turn: ToolTurn,
    /// Index of the move in its list.
    pub number: u32,
    pub tag: u32,
    /// Bodies are compared on it.
    pub asks: bool,
}

/// The solids of a task with moves of tools that turn.
#[derive(Clone, Debug, Default)]
pub(crate) struct TurningSolids {
    pub removes: Option<AxialSolid>,
    pub may: Option<AxialSolid>,
    pub bodies: Vec<AxialSolid>,
    /// Depth below which a contact counts as none, mm.
    pub tolerance: f64,
}

impl TurningSolids {
    pub fn of(task: &TurningTask<'_>, tolerance: f64) -> TurningSolids {
        /// Where nothing is given, contacts are looked for down to this, mm.
        const USUAL_MM: f64 = 1e-3;
        let is_above_zero = tolerance > 0.0 && tolerance.is_finite();
        TurningSolids {
            removes: task.removes.cloned(),
            may: task.may.cloned(),
            bodies: task.bodies.to_vec(),
            tolerance: if is_above_zero { tolerance } else { USUAL_MM },
        }
    }

    fn all(&self, asks: bool) -> impl Iterator<Item = &ConvexElement> {
        let bodies = self.bodies.iter().filter(move |_| asks);
        let solids = self.removes.iter().chain(&self.may).chain(bodies);
        solids.flat_map(AxialSolid::elements)
    }

    /// The tiles that a move may meet, in ascending order.
    pub fn tiles(&self, grid: &StockGrid, turning: &TurningMove) -> Vec<u32> {
        let motion = ElementMotion::new(&turning.curve, &turning.turn);
        let (bounds, counts) = (grid.bounds(), grid.tile_counts());
        let width = grid.resolution() * TILE as f64;
        let mut met = std::collections::BTreeSet::new();
        for element in self.all(turning.asks) {
            for part in shares(TILE_PARTS) {
                let [low, high] = SweptElement::new(element, &motion, part).bounds();
                if !(low.z < bounds.max.z && high.z > bounds.min.z) {
                    continue;
                }
                let range = |from: f64, to: f64, origin: f64, count: u32| {
                    let most = f64::from(count);
                    let first = ((from - origin) / width).floor().clamp(0.0, most);
                    let last = ((to - origin) / width).floor().clamp(-1.0, most - 1.0);
                    first as i64..=last as i64
                };
                for row in range(low.y, high.y, bounds.min.y, counts[1]) {
                    for column in range(low.x, high.x, bounds.min.x, counts[0]) {
                        met.insert((row * i64::from(counts[0]) + column) as u32);
                    }
                }
            }
        }
        met.into_iter().collect()
    }
}

/// Equal parts of a move, as shares of it.
fn shares(count: u32) -> impl Iterator<Item = [f64; 2]> {
    let of = f64::from(count);
    (0..count).map(move |n| [f64::from(n) / of, f64::from(n + 1) / of])
}

/// A move of a tool that turns, on a tile.
pub(crate) struct TurningOnTile<'a> {
    pub grid: &'a StockGrid,
    pub number: usize,
    pub tile: &'a mut StockTile,
    pub turning: &'a TurningMove,
    pub solids: &'a TurningSolids,
    pub by_tag: bool,
    /// Whether the spans in the middles of cells are kept.
    pub keeps_middles: bool,
    /// Most bytes that the gaps of the tile may take.
    pub limit: usize,
    /// Number of cells that were examined.
    pub count: u64,
}

/// What an element removes from a cell, relative to the stock's top, mm.
struct ElementSpan {
    surely: Option<RemovedSpan>,
    maybe: RemovedSpan,
}

/// Which bounds of a contact are looked for.
#[derive(Clone, Copy, PartialEq)]
enum ContactSide {
    Both,
    Most,
    Least,
}

impl TurningOnTile<'_> {
    /// Compares the bodies and removes what is swept. Returns the contacts by body.
    pub fn run(&mut self) -> Vec<ContactDepth> {
        let (turning, solids) = (self.turning, self.solids);
        let motion = ElementMotion::new(&turning.curve, &turning.turn);
        let mut contacts = vec![ContactDepth::NONE; solids.bodies.len()];
        if !turning.asks {
            self.cut(&motion, [0.0, 1.0]);
            return contacts;
        }
        let cuts = solids.removes.is_some() || solids.may.is_some();
        let first = if cuts { ContactSide::Most } else { ContactSide::Both };
        self.compare_all(&motion, [0.0, 1.0], first, &mut contacts);
        if !cuts {
            return contacts;
        }
        if contacts.iter().all(|contact| contact.most <= solids.tolerance) {
            self.cut(&motion, [0.0, 1.0]);
            return contacts;
        }
        // What a body meets may be what the edges have removed before, or will remove: in short steps, what is left
        // after a step is certainly met, and what was left before it may be.
        contacts.fill(ContactDepth::NONE);
        let elements: Vec<&ConvexElement> = solids.all(true).collect();
        let far = elements.iter().map(|element| motion.travel(element)).fold(0.0, f64::max);
        let steps = (far / (CELLS_PER_STEP * self.grid.resolution())).ceil();
        let steps = steps.clamp(1.0, f64::from(MAX_STEPS)) as u32;
        for part in shares(steps) {
            self.compare_all(&motion, part, ContactSide::Most, &mut contacts);
            self.cut(&motion, part);
            self.compare_all(&motion, part, ContactSide::Least, &mut contacts);
        }
        for contact in &mut contacts {
            contact.least = contact.least.min(contact.most);
        }
        contacts
    }

    fn compare_all(
        &mut self,
        motion: &ElementMotion<'_>,
        part: [f64; 2],
        side: ContactSide,
        contacts: &mut [ContactDepth],
    ) {
        let solids = self.solids;
        for (body, contact) in solids.bodies.iter().zip(contacts) {
            for element in body.elements() {
                let found = self.compare(element, motion, part, side, MAX_HALVINGS);
                *contact = contact.deeper(found);
            }
        }
    }

    /// The contact of an element on a part of the move, which is halved until it is decided.
    fn compare(
        &mut self,
        element: &ConvexElement,
        motion: &ElementMotion<'_>,
        [from, to]: [f64; 2],
        side: ContactSide,
        halvings: u32,
    ) -> ContactDepth {
        let swept = SweptElement::new(element, motion, [from, to]);
        let bounds = self.grid.bounds();
        let (top, bottom) = (bounds.max.z, -bounds.size().z);
        let (cell, corner) = (self.grid.resolution(), self.grid.corner(self.number));
        let mut deepest = ContactDepth::NONE;
        let wants_least = side != ContactSide::Most;
        self.each(&swept, wants_least, |on, [block, at], spans| {
            let [outer, inner] = on.tile.heights([block, at]);
            let column = on.tile.gaps().of([block, at]);
            let [surely, maybe] =
                column.map_or([&[][..]; 2], |column| [&column.surely[..], &column.maybe[..]]);
            if let Some(span) = &spans.surely {
                let solid = SolidColumn { height: inner, gaps: maybe };
                deepest.least = deepest.least.max(solid.within(bottom, [span.floor, span.top]));
            }
            let span = &spans.maybe;
            let solid = SolidColumn { height: outer, gaps: surely };
            let most = solid.within(bottom, [span.floor, span.top]);
            if most > deepest.most {
                let x = block % BLOCKS * BLOCK + at % BLOCK;
                let y = block / BLOCKS * BLOCK + at / BLOCK;
                let [x, y] = [x, y].map(|n| (n as f64 + 0.5) * cell);
                deepest.most = most;
                let z = span.top.min(f64::from(outer));
                deepest.at = [corner[0] + x, corner[1] + y, top + z];
            }
        });
        let tolerance = self.solids.tolerance;
        let is_decided = deepest.most <= tolerance || deepest.least > tolerance;
        let is_fine = swept.deviation <= DEVIATION_SHARE * self.grid.resolution();
        if is_decided || is_fine || halvings == 0 {
            return match side {
                ContactSide::Both => deepest,
                ContactSide::Most => ContactDepth { least: 0.0, ..deepest },
                // What is left over is not more than what was there before, which is known.
                ContactSide::Least => ContactDepth { least: deepest.least, ..ContactDepth::NONE },
            };
        }
        let middle = 0.5 * (from + to);
        let first = self.compare(element, motion, [from, middle], side, halvings - 1);
        let second = self.compare(element, motion, [middle, to], side, halvings - 1);
        first.deeper(second)
    }

    /// Removes what is swept between two shares of the move.
    fn cut(&mut self, motion: &ElementMotion<'_>, [from, to]: [f64; 2]) {
        let solids = self.solids;
        let tolerance = DEVIATION_SHARE * self.grid.resolution();
        for (solid, is_sure) in [(&solids.removes, true), (&solids.may, false)] {
            let Some(solid) = solid else { continue };
            let all = f64::from(motion.parts(solid.elements(), tolerance, MAX_PARTS));
            let parts = (all * (to - from)).ceil().max(1.0) as u32;
            for part in shares(parts) {
                let part = part.map(|share| from + share * (to - from));
                // From above, so that what is removed is open at the top.
                for element in solid.elements().iter().rev() {
                    self.remove(&SweptElement::new(element, motion, part), is_sure);
                }
            }
        }
        self.tile.settle();
    }

    fn remove(&mut self, swept: &SweptElement<'_>, is_sure: bool) {
        let bottom = super::heights::bottom(self.grid);
        self.each(swept, is_sure, |on, place, spans| {
            if !on.changes(place, spans) {
                return;
            }
            if on.by_tag {
                on.tile.keep(on.turning.tag, place[0], on.grid, on.number);
            }
            // The middle of the cell: midway between the bounds, where something is certain.
            let middle = spans.surely.filter(|_| on.keeps_middles).map(|surely| RemovedSpan {
                floor: 0.5 * (surely.floor + spans.maybe.floor),
                top: 0.5 * (surely.top + spans.maybe.top),
            });
            let found =
                [spans.surely.as_slice(), core::slice::from_ref(&spans.maybe), middle.as_slice()];
            on.tile.hollow(place, found, bottom, on.limit);
        });
    }

    /// Whether spans remove something from a column that is not removed yet.
    fn changes(&self, place: [usize; 2], spans: &ElementSpan) -> bool {
        let [outer, inner] = self.tile.heights(place).map(f64::from);
        let column = self.tile.gaps().of(place);
        let is_new = |height: f64, gaps: &[[f32; 2]], span: &RemovedSpan| {
            let holds =
                |gap: &[f32; 2]| f64::from(gap[0]) <= span.floor && span.top <= f64::from(gap[1]);
            span.floor < height && !gaps.iter().any(holds)
        };
        let [surely, maybe] =
            column.map_or([&[][..]; 2], |column| [&column.surely[..], &column.maybe[..]]);
        is_new(inner, maybe, &spans.maybe)
            || spans.surely.as_ref().is_some_and(|span| is_new(outer, surely, span))
    }

    /// Calls `found` for each cell over which an element may sweep something below the top of the stock there.
    fn each(
        &mut self,
        swept: &SweptElement<'_>,
        wants_sure: bool,
        mut found: impl FnMut(&mut Self, [usize; 2], &ElementSpan),
    ) {
        let [low, high] = swept.bounds();
        let bounds = self.grid.bounds();
        let top = bounds.max.z;
        if !(low.z < top + f64::from(self.tile.top()) && high.z > bounds.min.z) {
            return;
        }
        let (cell, corner) = (self.grid.resolution(), self.grid.corner(self.number));
        let width = cell * BLOCK as f64;
        let range = |from: f64, to: f64, origin: f64| {
            let most = BLOCKS as f64;
            let first = ((from - origin) / width).floor().clamp(0.0, most) as usize;
            let end = (((to - origin) / width).floor() + 1.0).clamp(0.0, most) as usize;
            first..end
        };
        let (across, up) = (range(low.x, high.x, corner[0]), range(low.y, high.y, corner[1]));
        if across.is_empty() || up.is_empty() {
            return;
        }
        let [first_column, first_row] = self.grid.first_cell(self.number);
        let [columns, rows] = self.grid.cells();
        let diagonal = core::f64::consts::FRAC_1_SQRT_2;
        let around_block = swept.outer(width * diagonal);
        let around_cell = swept.outer(cell * diagonal);
        let inner = wants_sure.then(|| swept.inner());
        for row in up {
            for column in across.clone() {
                let block = row * BLOCKS + column;
                let origin = [corner[0] + column as f64 * width, corner[1] + row as f64 * width];
                let middle = origin.map(|at| at + 0.5 * width);
                let Some([floor, _]) = swept.span(&around_block, middle, 0.5 * width) else {
                    continue;
                };
                if floor - top >= f64::from(self.tile.range(block).outer[1]) {
                    continue;
                }
                let mut corners = BlockCorners::default();
                for at in 0..CELLS {
                    let (x, y) = (at % BLOCK, at / BLOCK);
                    let place = [(column * BLOCK + x) as u32, (row * BLOCK + y) as u32];
                    if place[0] + first_column >= columns || place[1] + first_row >= rows {
                        continue;
                    }
                    let middle = [x, y].map(|n| (n as f64 + 0.5) * cell);
                    let middle = [origin[0] + middle[0], origin[1] + middle[1]];
                    self.count += 1;
                    let Some(maybe) = swept.span(&around_cell, middle, 0.5 * cell) else {
                        continue;
                    };
                    let maybe = RemovedSpan {
                        floor: maybe[0].max(low.z) - top,
                        top: maybe[1].min(high.z) - top,
                    };
                    if maybe.floor >= f64::from(self.tile.heights([block, at])[0]) {
                        continue;
                    }
                    let surely = inner.as_ref().and_then(|inner| {
                        let mut chord = |x: usize, y: usize| {
                            corners.chord([x, y], || {
                                let [x, y] = [x, y].map(|n| n as f64 * cell);
                                let ends = inner.chord(origin[0] + x, origin[1] + y)?;
                                Some(ends.map(|end| end.z))
                            })
                        };
                        let all = [
                            chord(x, y)?,
                            chord(x + 1, y)?,
                            chord(x, y + 1)?,
                            chord(x + 1, y + 1)?,
                        ];
                        let floor =
                            all.iter().map(|ends| ends[0]).fold(f64::NEG_INFINITY, f64::max);
                        let over = all.iter().map(|ends| ends[1]).fold(f64::INFINITY, f64::min);
                        (floor < over)
                            .then_some(RemovedSpan { floor: floor - top, top: over - top })
                    });
                    found(self, [block, at], &ElementSpan { surely, maybe });
                }
            }
        }
    }
}

/// The chords over the corners of the cells of a block that were computed so far.
struct BlockCorners {
    known: [Option<Option<[f64; 2]>>; (BLOCK + 1) * (BLOCK + 1)],
}

impl Default for BlockCorners {
    fn default() -> BlockCorners {
        BlockCorners { known: [None; (BLOCK + 1) * (BLOCK + 1)] }
    }
}

impl BlockCorners {
    fn chord(
        &mut self,
        [x, y]: [usize; 2],
        find: impl FnOnce() -> Option<[f64; 2]>,
    ) -> Option<[f64; 2]> {
        *self.known[y * (BLOCK + 1) + x].get_or_insert_with(find)
    }
}
