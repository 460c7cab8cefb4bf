//! Makes triangles of rectangles and the walls between them.

use chordal_geometry::Vec3;

use super::cover::{CellRectangle, NONE, RectangleCover};
use super::node::{CornerNode, FaceKind};
use super::{HeightField, PlanGrid, TouchingVertex};
use crate::mesh::Mesh;

/// No vertex at this corner.
const NO_VERTEX: u32 = u32::MAX;

/// A side of a rectangle, run through counter-clockwise.
pub(super) struct RectangleSide {
    /// Its first corner.
    from: [usize; 2],
    /// The step to the next cell.
    step: [isize; 2],
    /// How many cells it has.
    pub(super) cells: usize,
    /// The number of the rectangle's cell around a corner of the side (not its last one), as in [`CornerNode`].
    pub(super) cell: usize,
    /// The number of the wall that runs along the side from a corner.
    ahead: usize,
}

pub(super) fn sides(rectangle: &CellRectangle) -> [RectangleSide; 4] {
    let CellRectangle { columns: [left, right], rows: [low, high], .. } = *rectangle;
    let (width, depth) = (right - left, high - low);
    [
        RectangleSide { from: [left, low], step: [1, 0], cells: width, cell: 0, ahead: 3 },
        RectangleSide { from: [right, low], step: [0, 1], cells: depth, cell: 1, ahead: 0 },
        RectangleSide { from: [right, high], step: [-1, 0], cells: width, cell: 2, ahead: 1 },
        RectangleSide { from: [left, high], step: [0, -1], cells: depth, cell: 3, ahead: 2 },
    ]
}

impl RectangleSide {
    /// The corner after this many cells.
    pub(super) fn corner(&self, cells: usize) -> [usize; 2] {
        [0, 1].map(|axis| self.from[axis].wrapping_add_signed(self.step[axis] * cells as isize))
    }
}

/// Which faces have a vertex at a corner.
#[derive(Clone, Copy, PartialEq, Eq)]
struct UsedFaces {
    tops: bool,
    bottom: bool,
}

pub(super) struct StepBuilder<'a> {
    field: &'a HeightField<'a>,
    plan: PlanGrid,
    tops: &'a RectangleCover,
    bottoms: &'a RectangleCover,
    /// The height of each cell and of a border of one cell: that of its rectangle, or the bottom.
    heights: Vec<f64>,
    /// For each corner of cells its first vertex; `used` says which faces have one there.
    first: Vec<u32>,
    used: Vec<UsedFaces>,
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    touching: Vec<TouchingVertex>,
    /// The vertices around a face; a buffer that is reused.
    around: Vec<u32>,
}

impl<'a> StepBuilder<'a> {
    pub(super) fn new(
        field: &'a HeightField<'a>,
        tops: &'a RectangleCover,
        bottoms: &'a RectangleCover,
    ) -> StepBuilder<'a> {
        let corners = (field.columns + 1) * (field.rows + 1);
        let (first, used) = (Vec::with_capacity(corners), Vec::with_capacity(corners));
        let heights = bordered(field, tops);
        let (vertices, triangles, touching) = (Vec::new(), Vec::new(), Vec::new());
        let mut builder = StepBuilder {
            field,
            plan: field.plan(),
            tops,
            bottoms,
            heights,
            first,
            used,
            vertices,
            triangles,
            touching,
            around: Vec::new(),
        };
        builder.number();
        builder
    }

    pub(super) fn mesh(mut self) -> (Mesh, Vec<TouchingVertex>) {
        for rectangle in &self.tops.rectangles {
            self.face(rectangle, true);
            for side in sides(rectangle) {
                self.walls(rectangle, &side);
            }
        }
        for rectangle in &self.bottoms.rectangles {
            self.face(rectangle, false);
        }
        (Mesh { vertices: self.vertices, triangles: self.triangles }, self.touching)
    }

    /// Numbers the vertices of all corners.
    fn number(&mut self) {
        for row in 0..=self.field.rows {
            for column in 0..=self.field.columns {
                let at = [column, row];
                let used = self.used(at);
                self.used.push(used);
                if !used.tops && !used.bottom {
                    self.first.push(NO_VERTEX);
                    continue;
                }
                // [`HeightField::check`] has limited the count to 32 bits.
                self.first.push(self.vertices.len() as u32);
                let node = self.node(at, used);
                for (height, &path) in node.vertices().zip(node.directions()) {
                    if path != [0, 0] {
                        self.touching.push(TouchingVertex {
                            vertex: self.vertices.len() as u32,
                            toward: path,
                        });
                    }
                    self.vertices.push(self.point(at, height));
                }
            }
        }
    }

    fn point(&self, at: [usize; 2], height: f64) -> Vec3 {
        self.plan.point(at, height)
    }

    /// The four cells around a corner, counter-clockwise from the one with higher x and y; `None` outside.
    fn cells(&self, [column, row]: [usize; 2]) -> [Option<usize>; 4] {
        let HeightField { columns, rows, .. } = *self.field;
        [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[left, down]| {
            let (column, row) = (column.checked_sub(left)?, row.checked_sub(down)?);
            (column < columns && row < rows).then_some(row * columns + column)
        })
    }

    /// Whether a corner is an end of an edge of some rectangle. Next to a hole, tops and bottoms share the wall, and
    /// so its ends.
    fn used(&self, at: [usize; 2]) -> UsedFaces {
        let cells = self.cells(at);
        let ends = |cover: &RectangleCover| {
            let [a, b, c, d] = cells.map(|cell| cell.map_or(NONE, |cell| cover.of[cell]));
            let straight = (a == b && c == d) || (b == c && d == a);
            let whole = a == b && b == c && c == d;
            !(straight || whole)
        };
        let (tops, bottom) = (ends(self.tops), ends(self.bottoms));
        let hole = cells.iter().any(|cell| cell.is_none_or(|cell| self.tops.of[cell] == NONE));
        if hole {
            let either = tops || bottom;
            UsedFaces { tops: either, bottom: either }
        } else {
            UsedFaces { tops, bottom }
        }
    }

    fn floor(&self) -> f64 {
        f64::from(self.field.floor)
    }

    fn node(&self, at: [usize; 2], used: UsedFaces) -> CornerNode {
        CornerNode::new(self.heights_at(at), self.floor(), used.tops, used.bottom)
    }

    /// The heights of the four cells around a corner.
    fn heights_at(&self, [column, row]: [usize; 2]) -> [f64; 4] {
        let width = self.field.columns + 2;
        let low = row * width + column;
        let high = low + width;
        [self.heights[high + 1], self.heights[high], self.heights[low], self.heights[low + 1]]
    }

    /// The first vertex of a corner, and its node; `None` where no edge ends.
    fn corner(&self, at: [usize; 2], tops: bool) -> Option<(u32, CornerNode)> {
        let corner = at[1] * (self.field.columns + 1) + at[0];
        let used = self.used[corner];
        let here = if tops { used.tops } else { used.bottom };
        here.then(|| (self.first[corner], self.node(at, used)))
    }

    /// Adds the top or the bottom of a rectangle.
    fn face(&mut self, rectangle: &CellRectangle, tops: bool) {
        let height = if tops { rectangle.height } else { self.floor() };
        let mut around = std::mem::take(&mut self.around);
        around.clear();
        for side in sides(rectangle) {
            for cells in 0..side.cells {
                if let Some((first, node)) = self.corner(side.corner(cells), tops) {
                    let vertex = node.vertex(node.level(height), FaceKind::Flat(side.cell));
                    around.push(first + vertex as u32);
                }
            }
        }
        if !tops {
            around.reverse();
        }
        let ends = rectangle.ends().map(|at| self.point(at, height));
        fill(&around, ends, &mut self.vertices, &mut self.triangles);
        self.around = around;
    }

    /// Adds the walls below a side of a rectangle, where its neighbours are lower.
    fn walls(&mut self, rectangle: &CellRectangle, side: &RectangleSide) {
        let mut begin: Option<(u32, CornerNode)> = None;
        for cells in 0..=side.cells {
            let at = side.corner(cells);
            let Some((first, node)) = self.corner(at, true) else { continue };
            if let Some((from, before)) = &begin {
                // The neighbour has been the same since the last corner, so the one of the last cell is used.
                let low = self.across(side, cells - 1);
                if low < rectangle.height {
                    let span = [low, rectangle.height];
                    let back = (side.ahead + 2) % 4;
                    let left = WallLine::new(*from, before, side.ahead, span);
                    let right = WallLine::new(first, &node, back, span);
                    self.strip(left, right);
                }
            }
            begin = Some((first, node));
        }
    }

    /// The height of the neighbour across a side of a rectangle, after this many cells.
    fn across(&self, side: &RectangleSide, cells: usize) -> f64 {
        // Seen from the corner, the wall ahead has the rectangle on its left and the neighbour on its right.
        self.heights_at(side.corner(cells))[side.ahead]
    }

    /// Adds triangles between two vertical lines of vertices; left and right are as seen from outside.
    fn strip<'b>(&mut self, mut left: WallLine<'b>, mut right: WallLine<'b>) {
        while left.level < left.top || right.level < right.top {
            let on_the_left = left.level < left.top
                && (right.level >= right.top || left.next_height() < right.next_height());
            let (l, r) = (left.vertex(), right.vertex());
            let line = if on_the_left { &mut left } else { &mut right };
            line.level += 1;
            let next = line.vertex();
            self.triangles.push([l, r, next]);
        }
    }
}

/// Adds the triangles of a rectangle, given the vertices around it and two opposite corners.
pub(super) fn fill(
    around: &[u32],
    [a, b]: [Vec3; 2],
    vertices: &mut Vec<Vec3>,
    triangles: &mut Vec<[u32; 3]>,
) {
    if let [a, b, c, d] = *around {
        triangles.extend([[a, b, c], [a, c, d]]);
        return;
    }
    // Corners of neighbours lie on its sides. A fan from the middle has no degenerate triangles.
    let middle = vertices.len() as u32;
    vertices.push(a.lerp(b, 0.5));
    let next = around.iter().cycle().skip(1);
    triangles.extend(around.iter().zip(next).map(|(&a, &b)| [middle, a, b]));
}

/// The vertices of a wall at a corner, from the lowest.
struct WallLine<'a> {
    first: u32,
    node: &'a CornerNode,
    wall: usize,
    level: usize,
    top: usize,
}

impl WallLine<'_> {
    /// The line between two heights, mm.
    fn new(first: u32, node: &CornerNode, wall: usize, [low, high]: [f64; 2]) -> WallLine<'_> {
        WallLine { first, node, wall, level: node.level(low), top: node.level(high) }
    }

    fn vertex(&self) -> u32 {
        let below_top = self.level < self.top;
        let face = if below_top { FaceKind::Up(self.wall) } else { FaceKind::Down(self.wall) };
        self.first + self.node.vertex(self.level, face) as u32
    }

    fn next_height(&self) -> f64 {
        self.node.levels()[self.level + 1]
    }
}

/// The height of each cell by its rectangle; that of the bottom for a hole and for a border of one cell.
fn bordered(field: &HeightField, tops: &RectangleCover) -> Vec<f64> {
    let width = field.columns + 2;
    let mut heights = vec![f64::from(field.floor); width * (field.rows + 2)];
    for rectangle in &tops.rectangles {
        let [left, right] = rectangle.columns;
        for row in rectangle.rows[0]..rectangle.rows[1] {
            let from = (row + 1) * width + 1;
            heights[from + left..from + right].fill(rectangle.height);
        }
    }
    heights
}
