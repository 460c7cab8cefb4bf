//! A bounding volume hierarchy over the triangles of a mesh.

use chordal_geometry::{Aabb, Vec3};

use crate::mesh::Mesh;

/// Most triangles in a box that is not divided further.
const MAX_LEAF_TRIANGLES: usize = 4;

/// A box, and its content.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoxNode {
    pub bounds: Aabb,
    pub inside: NodeContent,
}

/// The content of a box.
#[derive(Clone, Copy, Debug)]
pub(super) enum NodeContent {
    /// Two child boxes, by their numbers.
    Boxes(usize, usize),
    /// Triangles: the index of the first in the order of the tree, and their number.
    Triangles(usize, usize),
}

/// A tree over the triangles of a mesh.
#[derive(Clone, Debug)]
pub(super) struct TriangleTree {
    nodes: Vec<BoxNode>,
    /// The numbers of the triangles, in the order of the boxes.
    order: Vec<u32>,
}

impl TriangleTree {
    /// The tree of a mesh with at least one triangle.
    pub(super) fn new(mesh: &Mesh) -> TriangleTree {
        let around = |triangle: u32| {
            let corners = mesh.corners(triangle as usize);
            corners.into_iter().fold(Aabb::EMPTY, |around, corner| around.include(corner))
        };
        // The number of triangles of a mesh fits 32 bits.
        let mut order: Vec<u32> = (0..mesh.triangles().len() as u32).collect();
        let bounds: Vec<Aabb> = order.iter().map(|triangle| around(*triangle)).collect();
        let mut tree = TriangleTree { nodes: Vec::new(), order: Vec::new() };
        tree.divide(&bounds, &mut order, 0);
        tree.order = order;
        tree
    }

    /// Makes the box of a part of the order, and returns its number. Both halves have the same number of triangles,
    /// so that the depth is logarithmic.
    fn divide(&mut self, bounds: &[Aabb], part: &mut [u32], first: usize) -> usize {
        let around = part
            .iter()
            .fold(Aabb::EMPTY, |around, triangle| around.union(bounds[*triangle as usize]));
        let node = self.nodes.len();
        let inside = NodeContent::Triangles(first, part.len());
        self.nodes.push(BoxNode { bounds: around, inside });
        if part.len() > MAX_LEAF_TRIANGLES {
            let Vec3 { x, y, z } = around.size();
            let axis = if x >= y && x >= z {
                0
            } else if y >= z {
                1
            } else {
                2
            };
            let middle = |triangle: u32| bounds[triangle as usize].center().component(axis);
            let half = part.len() / 2;
            // Ties are broken by number, so that the tree is the same everywhere.
            part.select_nth_unstable_by(half, |a, b| {
                middle(*a).total_cmp(&middle(*b)).then(a.cmp(b))
            });
            let (low, high) = part.split_at_mut(half);
            let low = self.divide(bounds, low, first);
            let high = self.divide(bounds, high, first + half);
            self.nodes[node].inside = NodeContent::Boxes(low, high);
        }
        node
    }

    /// The node with this number; the root is 0.
    pub(super) fn node(&self, number: usize) -> BoxNode {
        self.nodes[number]
    }

    /// The triangles of a box.
    pub(super) fn triangles(&self, first: usize, count: usize) -> impl Iterator<Item = usize> {
        self.order[first..first + count].iter().map(|triangle| *triangle as usize)
    }

    /// Calls `call` for every triangle in the boxes for which `passes` is true.
    pub(super) fn each(&self, passes: impl Fn(&Aabb) -> bool, mut call: impl FnMut(usize)) {
        let mut open = vec![0];
        while let Some(number) = open.pop() {
            let node = self.node(number);
            if !passes(&node.bounds) {
                continue;
            }
            match node.inside {
                NodeContent::Boxes(a, b) => open.extend([b, a]),
                NodeContent::Triangles(first, count) => {
                    self.triangles(first, count).for_each(&mut call)
                }
            }
        }
    }
}
