//! Makes triangles of tops, undersides and the walls between them.

use chordal_geometry::Vec3;

use super::super::build::{fill, sides};
use super::super::cover::CellRectangle;
use super::super::node::FaceKind;
use super::super::{PlanGrid, TouchingVertex};
use super::LayerField;
use super::corner::{LayerCell, LayerCorner, is_passed};
use super::cover::LayerCover;
use crate::mesh::Mesh;

/// A corner without vertices.
const NO_CORNER: u32 = u32::MAX;

pub(super) struct LayerBuilder<'a> {
    field: &'a LayerField<'a>,
    plan: PlanGrid,
    cover: &'a LayerCover,
    /// For each corner of cells its index in `corners`, or [`NO_CORNER`].
    numbers: Vec<u32>,
    corners: Vec<LayerCorner>,
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    touching: Vec<TouchingVertex>,
}

impl<'a> LayerBuilder<'a> {
    pub fn new(field: &'a LayerField<'a>, cover: &'a LayerCover) -> LayerBuilder<'a> {
        let numbers = Vec::with_capacity((field.columns + 1) * (field.rows + 1));
        let (corners, vertices) = (Vec::new(), Vec::new());
        let (triangles, touching) = (Vec::new(), Vec::new());
        let plan = field.plan();
        let mut builder =
            LayerBuilder { field, plan, cover, numbers, corners, vertices, triangles, touching };
        for row in 0..=field.rows {
            for column in 0..=field.columns {
                builder.number([column, row]);
            }
        }
        builder
    }

    pub fn mesh(mut self) -> (Mesh, Vec<TouchingVertex>) {
        let cover = self.cover;
        for rectangle in &cover.tops {
            self.face(rectangle, true);
        }
        for rectangle in &cover.undersides {
            self.face(rectangle, false);
        }
        let LayerField { columns, rows, .. } = *self.field;
        for row in 0..=rows {
            self.walls((0..=columns).map(|column| [column, row]), CornerLine::X);
        }
        for column in 0..=columns {
            self.walls((0..=rows).map(|row| [column, row]), CornerLine::Y);
        }
        (Mesh { vertices: self.vertices, triangles: self.triangles }, self.touching)
    }

    /// Numbers the vertices of a corner.
    fn number(&mut self, at: [usize; 2]) {
        let cells = self.cells(at);
        if is_passed(&cells) {
            self.numbers.push(NO_CORNER);
            return;
        }
        // [`LayerField::check`] has limited the count to 32 bits.
        let corner = LayerCorner::new(&cells, self.vertices.len() as u32);
        for level in &corner.levels {
            for &path in &level.meeting.directions[..level.meeting.count] {
                if path != [0, 0] {
                    self.touching
                        .push(TouchingVertex { vertex: self.vertices.len() as u32, toward: path });
                }
                self.vertices.push(self.point(at, level.height));
            }
        }
        self.numbers.push(self.corners.len() as u32);
        self.corners.push(corner);
    }

    fn point(&self, at: [usize; 2], height: f64) -> Vec3 {
        self.plan.point(at, height)
    }

    /// The four cells around a corner, counter-clockwise from the one with higher x and y; empty outside.
    fn cells(&self, [column, row]: [usize; 2]) -> [LayerCell<'a>; 4] {
        let LayerField { columns, rows, .. } = *self.field;
        let cover = self.cover;
        [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[left, down]| {
            let (Some(column), Some(row)) = (column.checked_sub(left), row.checked_sub(down))
            else {
                return LayerCell::default();
            };
            if column >= columns || row >= rows {
                return LayerCell::default();
            }
            let cell = row * columns + column;
            LayerCell { intervals: cover.intervals.of(cell), rectangles: cover.rectangles(cell) }
        })
    }

    fn corner(&self, [column, row]: [usize; 2]) -> Option<&LayerCorner> {
        let number = self.numbers[row * (self.field.columns + 1) + column];
        (number != NO_CORNER).then(|| &self.corners[number as usize])
    }

    /// Adds a top or an underside.
    fn face(&mut self, rectangle: &CellRectangle, is_top: bool) {
        let mut around: Vec<u32> = Vec::new();
        for side in sides(rectangle) {
            for cells in 0..side.cells {
                let corner = self.corner(side.corner(cells));
                let face = FaceKind::Flat(side.cell);
                around.extend(corner.and_then(|corner| corner.vertex(rectangle.height, face)));
            }
        }
        if !is_top {
            around.reverse();
        }
        let ends = rectangle.ends().map(|at| self.point(at, rectangle.height));
        fill(&around, ends, &mut self.vertices, &mut self.triangles);
    }

    /// Adds the walls along a line of corners.
    fn walls(&mut self, line: impl Iterator<Item = [usize; 2]>, along: CornerLine) {
        let mut begin: Option<[usize; 2]> = None;
        for at in line {
            if self.corner(at).is_none() {
                continue;
            }
            if let Some(from) = begin {
                // Between two consecutive corners with vertices the cells on both sides do not change.
                let cells = self.cells(from);
                let [left, right] = along.cells().map(|cell| cells[cell].intervals);
                for (span, is_left) in differences(left, right) {
                    self.wall([from, at], along, span, is_left);
                }
            }
            begin = Some(at);
        }
    }

    /// Adds a wall between two corners, of the cell on the left of the line or of that on its right.
    fn wall(
        &mut self,
        [from, to]: [[usize; 2]; 2],
        along: CornerLine,
        span: [f64; 2],
        is_left: bool,
    ) {
        let (mut begin, mut end) = (Vec::new(), Vec::new());
        let [ahead, back] = along.walls();
        if let Some(corner) = self.corner(from) {
            corner.line(ahead, span, &mut begin);
        }
        if let Some(corner) = self.corner(to) {
            corner.line(back, span, &mut end);
        }
        // With the material on the left of the line, the line goes to the right as seen from outside.
        let (left, right) = if is_left { (begin, end) } else { (end, begin) };
        self.strip(&left, &right);
    }

    /// Adds triangles between two vertical lines of vertices; left and right are as seen from outside.
    fn strip(&mut self, left: &[(f64, u32)], right: &[(f64, u32)]) {
        let (mut l, mut r) = (0, 0);
        while l + 1 < left.len() || r + 1 < right.len() {
            let is_left = match (left.get(l + 1), right.get(r + 1)) {
                (Some(a), Some(b)) => a.0 < b.0,
                (next, _) => next.is_some(),
            };
            let (from, to) = (left[l].1, right[r].1);
            let next = if is_left {
                l += 1;
                left[l].1
            } else {
                r += 1;
                right[r].1
            };
            self.triangles.push([from, to, next]);
        }
    }
}

/// The direction of a line of corners.
#[derive(Clone, Copy)]
enum CornerLine {
    X,
    Y,
}

impl CornerLine {
    /// The numbers around its first corner of the cells on the left and on the right of the line.
    fn cells(self) -> [usize; 2] {
        match self {
            CornerLine::X => [0, 3],
            CornerLine::Y => [1, 0],
        }
    }

    /// The numbers of a wall on the line around its first and its last corner.
    fn walls(self) -> [usize; 2] {
        match self {
            CornerLine::X => [3, 1],
            CornerLine::Y => [0, 2],
        }
    }
}

/// The intervals in which only one of two cells is solid, from the lowest, and whether that is the left one.
fn differences(left: &[[f64; 2]], right: &[[f64; 2]]) -> Vec<([f64; 2], bool)> {
    let ends = |cell: &[[f64; 2]], is_left: bool| {
        let ends = cell.iter().flat_map(move |[from, to]| [(*from, is_left), (*to, is_left)]);
        ends.collect::<Vec<_>>()
    };
    let mut all = ends(left, true);
    all.extend(ends(right, false));
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut found = Vec::new();
    let (mut solid, mut from) = ([false; 2], 0.0);
    for (height, is_left) in all {
        if solid[0] != solid[1] && height > from {
            found.push(([from, height], solid[0]));
        }
        let own = &mut solid[usize::from(!is_left)];
        *own = !*own;
        from = height;
    }
    found
}
