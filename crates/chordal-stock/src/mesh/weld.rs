//! Merges corners at the same place into one vertex.

use std::collections::HashMap;

use chordal_geometry::Vec3;

/// Merges corners into vertices.
///
/// The maps are only looked up, never iterated, so that nothing depends on the order of hashing.
pub(super) struct VertexWelder {
    vertices: Vec<Vec3>,
    /// How far corners of one vertex may be apart, mm; with zero only equal coordinates are merged.
    distance: f64,
    same: HashMap<[u64; 3], u32>,
    /// The last vertex in each cell with a side of twice the distance; `before` links each vertex to the previous one
    /// in its cell.
    cells: HashMap<[i64; 3], u32>,
    before: Vec<Option<u32>>,
}

impl VertexWelder {
    pub(super) fn new(distance: f64) -> VertexWelder {
        let (same, cells) = (HashMap::new(), HashMap::new());
        VertexWelder { vertices: Vec::new(), distance, same, cells, before: Vec::new() }
    }

    pub(super) fn into_vertices(self) -> Vec<Vec3> {
        self.vertices
    }

    /// The vertex of a corner, mm: an earlier one within the distance, or a new one there.
    pub(super) fn vertex(&mut self, corner: Vec3) -> u32 {
        // Adding zero turns −0.0 into 0.0.
        let key = corner.to_array().map(|value| (value + 0.0).to_bits());
        if let Some(&vertex) = self.same.get(&key) {
            return vertex;
        }
        let vertex = self.near(corner).unwrap_or_else(|| self.add(corner));
        self.same.insert(key, vertex);
        vertex
    }

    fn add(&mut self, corner: Vec3) -> u32 {
        // The limit of the reader keeps the count far below 2³².
        let vertex = self.vertices.len() as u32;
        self.vertices.push(corner);
        if self.distance > 0.0 {
            let cell = corner.to_array().map(|value| self.place(value).floor() as i64);
            self.before.push(self.cells.insert(cell, vertex));
        }
        vertex
    }

    /// A coordinate in units of twice the distance: a point within the distance is in the same cell or in the
    /// neighbour beyond the nearer side.
    fn place(&self, value: f64) -> f64 {
        value / (2.0 * self.distance)
    }

    /// The earliest vertex within the distance; `None` where there is none.
    fn near(&self, corner: Vec3) -> Option<u32> {
        if self.distance <= 0.0 {
            return None;
        }
        let sides = corner.to_array().map(|value| {
            let place = self.place(value);
            let cell = place.floor();
            [cell as i64, if place - cell < 0.5 { cell as i64 - 1 } else { cell as i64 + 1 }]
        });
        let mut nearest: Option<u32> = None;
        for choice in 0..8 {
            let cell = [0, 1, 2].map(|axis| sides[axis][choice >> axis & 1]);
            let mut next = self.cells.get(&cell).copied();
            while let Some(vertex) = next {
                if self.vertices[vertex as usize].distance(corner) <= self.distance {
                    nearest = Some(nearest.map_or(vertex, |other| other.min(vertex)));
                }
                next = self.before[vertex as usize];
            }
        }
        nearest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_numbers_and_near_ones() {
        let mut exact = VertexWelder::new(0.0);
        assert_eq!(exact.vertex(Vec3::new(0.0, 1.0, 2.0)), 0);
        assert_eq!(exact.vertex(Vec3::new(-0.0, 1.0, 2.0)), 0);
        assert_eq!(exact.vertex(Vec3::new(1e-9, 1.0, 2.0)), 1);
        let mut near = VertexWelder::new(0.01);
        for step in 0..100 {
            // Across many borders of cells.
            let at = f64::from(step) * 0.1;
            assert_eq!(near.vertex(Vec3::new(at, -at, at)), step as u32);
            assert_eq!(near.vertex(Vec3::new(at + 0.005, -at - 0.005, at - 0.006)), step as u32);
        }
        assert_eq!(near.vertex(Vec3::new(0.011, 0.0, 0.0)), 100);
        assert_eq!(near.into_vertices().len(), 101);
    }
}
