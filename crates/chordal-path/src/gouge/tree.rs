//! Implicit binary trees over a chain, in the order of the chain.
//!
//! Neighbours in the chain are also neighbours in space, so nothing needs to be sorted. A tree is one array in which node
//! `k` has the children `2k` and `2k + 1`.

use core::f64::consts::FRAC_PI_2;

use chordal_geometry::Vec2;

use super::shape::{GougeCurve, within, wrapped};

/// The number of elements in one leaf.
pub(super) const LEAF: usize = 8;

/// An axis-parallel box, mm. It is empty if `min` is above `max`.
#[derive(Clone, Copy, Debug)]
pub(super) struct TreeBox {
    pub(super) min: Vec2,
    pub(super) max: Vec2,
}

impl TreeBox {
    pub(super) const EMPTY: TreeBox = TreeBox {
        min: Vec2::new(f64::INFINITY, f64::INFINITY),
        max: Vec2::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    fn add(&mut self, p: Vec2) {
        self.min = Vec2::new(self.min.a.min(p.a), self.min.b.min(p.b));
        self.max = Vec2::new(self.max.a.max(p.a), self.max.b.max(p.b));
    }

    fn union(self, o: TreeBox) -> TreeBox {
        TreeBox {
            min: Vec2::new(self.min.a.min(o.min.a), self.min.b.min(o.min.b)),
            max: Vec2::new(self.max.a.max(o.max.a), self.max.b.max(o.max.b)),
        }
    }

    pub(super) fn of(curve: &GougeCurve) -> TreeBox {
        let mut bounds = TreeBox::EMPTY;
        match *curve {
            GougeCurve::Line { from, to } => {
                bounds.add(from);
                bounds.add(to);
            }
            GougeCurve::Arc { center, radius, start, sweep } => {
                bounds.add(curve.from());
                bounds.add(curve.to());
                let out = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
                for (k, (a, b)) in out.into_iter().enumerate() {
                    if within(start, sweep, FRAC_PI_2 * k as f64) {
                        bounds.add(center + Vec2::new(a, b) * radius);
                    }
                }
            }
        }
        bounds
    }

    /// The square of the distance between two boxes, mm²; infinite if one is empty.
    pub(super) fn gap_square(&self, o: &TreeBox) -> f64 {
        let a = (self.min.a - o.max.a).max(o.min.a - self.max.a).max(0.0);
        let b = (self.min.b - o.max.b).max(o.min.b - self.max.b).max(0.0);
        a * a + b * b
    }

    /// Half the perimeter of the box, mm: a measure of its size.
    pub(super) fn size(&self) -> f64 {
        (self.max.a - self.min.a) + (self.max.b - self.min.b)
    }
}

/// The boxes of a chain.
pub(super) struct BoxTree {
    /// Box of each element.
    pub(super) elements: Vec<TreeBox>,
    /// Box of each node; node 1 is the root.
    pub(super) nodes: Vec<TreeBox>,
    /// The number of leaves, a power of two; also the index of the first leaf in `nodes`.
    pub(super) leaves: usize,
}

/// The number of leaves for this number of elements.
fn leaves_over(count: usize) -> usize {
    count.div_ceil(LEAF).max(1).next_power_of_two()
}

/// Fills the nodes above the leaves.
fn raise<T: Copy>(nodes: &mut [T], join: impl Fn(T, T) -> T) {
    for k in (1..nodes.len() / 2).rev() {
        nodes[k] = join(nodes[2 * k], nodes[2 * k + 1]);
    }
}

impl BoxTree {
    pub(super) fn over<'a>(curves: impl ExactSizeIterator<Item = &'a GougeCurve>) -> BoxTree {
        let leaves = leaves_over(curves.len());
        let elements: Vec<TreeBox> = curves.map(TreeBox::of).collect();
        let mut nodes = vec![TreeBox::EMPTY; 2 * leaves];
        for (k, part) in elements.chunks(LEAF).enumerate() {
            nodes[leaves + k] = part.iter().fold(TreeBox::EMPTY, |all, b| all.union(*b));
        }
        raise(&mut nodes, TreeBox::union);
        BoxTree { elements, nodes, leaves }
    }

    pub(super) fn is_leaf(&self, node: usize) -> bool {
        node >= self.leaves
    }

    /// The range of the elements under a node: the first, and one past the last.
    pub(super) fn range(&self, node: usize) -> (usize, usize) {
        let depth = node.ilog2();
        let span = (self.leaves >> depth) * LEAF;
        let first = (node - (1 << depth)) * span;
        let count = self.elements.len();
        (first.min(count), (first + span).min(count))
    }
}

/// The range of the tangents in a part of the contour, unwrapped along the chain, rad.
#[derive(Clone, Copy, Debug)]
pub(super) struct TangentSpan {
    pub(super) least: f64,
    pub(super) most: f64,
    /// The chain is interrupted in it, or one of its blocks has no exact offset in the path.
    pub(super) broken: bool,
}

impl TangentSpan {
    const EMPTY: TangentSpan =
        TangentSpan { least: f64::INFINITY, most: f64::NEG_INFINITY, broken: false };

    fn join(self, o: TangentSpan) -> TangentSpan {
        TangentSpan {
            least: self.least.min(o.least),
            most: self.most.max(o.most),
            broken: self.broken | o.broken,
        }
    }
}

/// The tangent angles of a chain.
pub(super) struct TurnTree {
    nodes: Vec<TangentSpan>,
    leaves: usize,
}

/// The tangent angles at both ends of each element of a chain, unwrapped along the chain, rad.
pub(super) fn unwrapped_tangents<'a>(
    curves: impl Iterator<Item = &'a GougeCurve>,
) -> Vec<(f64, f64)> {
    let mut last = 0.0;
    curves
        .map(|curve| {
            let (start, end) = curve.tangent_angles();
            let first = last + wrapped(start - last);
            last = first + (end - start);
            (first, last)
        })
        .collect()
}

impl TurnTree {
    pub(super) fn over(tangents: &[(f64, f64)], broken: &[bool]) -> TurnTree {
        let leaves = leaves_over(tangents.len());
        let mut nodes = vec![TangentSpan::EMPTY; 2 * leaves];
        for (k, (part, breaks)) in tangents.chunks(LEAF).zip(broken.chunks(LEAF)).enumerate() {
            nodes[leaves + k] =
                part.iter().zip(breaks).fold(TangentSpan::EMPTY, |all, (&(s, e), &broken)| {
                    all.join(TangentSpan { least: s.min(e), most: s.max(e), broken })
                });
        }
        raise(&mut nodes, TangentSpan::join);
        TurnTree { nodes, leaves }
    }

    /// Whether no leaf over the elements `first..=last` is broken and their tangents span at most `cone`, rad.
    pub(super) fn is_within(&self, first: usize, last: usize, cone: f64) -> bool {
        let (mut low, mut high) = (self.leaves + first / LEAF, self.leaves + last / LEAF + 1);
        let mut all = TangentSpan::EMPTY;
        while low < high {
            if low & 1 == 1 {
                all = all.join(self.nodes[low]);
                low += 1;
            }
            if high & 1 == 1 {
                high -= 1;
                all = all.join(self.nodes[high]);
            }
            if all.broken || all.most - all.least > cone {
                return false;
            }
            low /= 2;
            high /= 2;
        }
        true
    }
}

/// The range of the blocks of the contour to which the moves in a part of the path belong.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockHull {
    pub(super) first: u32,
    pub(super) last: u32,
    /// One of the moves belongs to no block of the contour, or is not its exact offset.
    pub(super) foreign: bool,
}

impl BlockHull {
    const EMPTY: BlockHull = BlockHull { first: u32::MAX, last: 0, foreign: false };

    fn join(self, o: BlockHull) -> BlockHull {
        BlockHull {
            first: self.first.min(o.first),
            last: self.last.max(o.last),
            foreign: self.foreign | o.foreign,
        }
    }
}

/// The block ranges of the nodes of the path, with the indices of its [`BoxTree`].
pub(super) fn hulls(of_moves: &[BlockHull]) -> Vec<BlockHull> {
    let leaves = leaves_over(of_moves.len());
    let mut nodes = vec![BlockHull::EMPTY; 2 * leaves];
    for (k, part) in of_moves.chunks(LEAF).enumerate() {
        nodes[leaves + k] = part.iter().fold(BlockHull::EMPTY, |all, h| all.join(*h));
    }
    raise(&mut nodes, BlockHull::join);
    nodes
}
