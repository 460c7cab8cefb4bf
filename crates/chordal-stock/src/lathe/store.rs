//! The edges of stock, indexed by position: in blocks of neighbours, each with its bounding box.

use super::arrange::{WindingSide, passage};
use super::edge::{Box2, RegionEdge};
use super::hull::DirectionHull;

/// Edges in a block: as many boxes are compared where a block is hit.
const BLOCK: usize = 32;

/// Edges in numbered slots.
#[derive(Clone, Debug, Default)]
pub(crate) struct EdgeStore {
    slots: Vec<Option<RegionEdge>>,
    boxes: Vec<Box2>,
    blocks: Vec<Box2>,
    free: Vec<u32>,
    changed: Vec<u32>,
    count: usize,
}

impl EdgeStore {
    pub fn of(edges: &[RegionEdge]) -> EdgeStore {
        let mut store = EdgeStore::default();
        edges.iter().for_each(|edge| store.insert(*edge));
        store
    }

    pub fn len(&self) -> usize {
        self.count
    }

    pub fn iter(&self) -> impl Iterator<Item = &RegionEdge> {
        self.slots.iter().flatten()
    }

    /// Inserts an edge. Slots that were freed last are filled first, since they belong to neighbours.
    pub fn insert(&mut self, edge: RegionEdge) {
        let bounds = edge.bounds();
        self.count += 1;
        let at = match self.free.pop() {
            Some(at) => {
                self.slots[at as usize] = Some(edge);
                self.boxes[at as usize] = bounds;
                at as usize
            }
            None => {
                self.slots.push(Some(edge));
                self.boxes.push(bounds);
                self.slots.len() - 1
            }
        };
        match self.blocks.get_mut(at / BLOCK) {
            Some(block) => *block = block.with(&bounds),
            None => self.blocks.push(bounds),
        }
    }

    pub fn remove(&mut self, at: u32) {
        if self.slots[at as usize].take().is_some() {
            self.boxes[at as usize] = Box2::EMPTY;
            self.free.push(at);
            self.changed.push(at / BLOCK as u32);
            self.count -= 1;
        }
    }

    /// Shrinks the boxes of blocks that lost edges.
    pub fn settle(&mut self) {
        self.changed.sort_unstable();
        self.changed.dedup();
        for block in self.changed.drain(..) {
            let from = block as usize * BLOCK;
            let to = (from + BLOCK).min(self.boxes.len());
            let boxes = self.boxes[from..to].iter();
            self.blocks[block as usize] = boxes.fold(Box2::EMPTY, |all, one| all.with(one));
        }
    }

    /// Finds the edges that may be within `margin` (mm) of a hull in `area`, in the order of their slots.
    pub fn near(
        &self,
        area: &Box2,
        hull: &DirectionHull,
        margin: f64,
        mut found: impl FnMut(u32, &RegionEdge),
    ) {
        let mut tried = 0;
        let mut comes_near =
            |bounds: &Box2| bounds.meets(area) && !hull.parts(bounds, margin, &mut tried);
        for (block, bounds) in self.blocks.iter().enumerate() {
            if !comes_near(bounds) {
                continue;
            }
            let from = block * BLOCK;
            let to = (from + BLOCK).min(self.boxes.len());
            for at in from..to {
                if comes_near(&self.boxes[at])
                    && let Some(edge) = &self.slots[at]
                {
                    found(at as u32, edge);
                }
            }
        }
    }

    /// The contribution of the edges to the winding number at a point, except for those in some slots.
    pub fn passages(&self, side: &WindingSide, without: &[u32]) -> i32 {
        let over = |bounds: &Box2| {
            bounds.min.a <= side.z && side.z <= bounds.max.a && bounds.max.b >= side.r
        };
        let mut sum = 0;
        for (block, bounds) in self.blocks.iter().enumerate() {
            if !over(bounds) {
                continue;
            }
            let from = block * BLOCK;
            let to = (from + BLOCK).min(self.boxes.len());
            for at in from..to {
                if over(&self.boxes[at])
                    && let Some(edge) = &self.slots[at]
                    && without.binary_search(&(at as u32)).is_err()
                {
                    sum += passage(edge, side);
                }
            }
        }
        sum
    }
}
