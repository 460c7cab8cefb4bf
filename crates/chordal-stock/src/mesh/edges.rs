//! Checks whether a surface is closed: each edge has two triangles that run along it in opposite directions.

use chordal_geometry::Vec3;

use super::Mesh;

/// How the triangles of a mesh meet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Edges {
    /// How many edges there are.
    pub count: usize,
    /// How many have more triangles in one direction than in the other: there the surface ends, or a triangle is
    /// turned inside out.
    pub open: usize,
    /// How many of these have two triangles in the same direction.
    pub turned: usize,
    /// How many have more than two triangles, equally many in both directions: two bodies touch there.
    pub crowded: usize,
    /// The ends of the open edge with the lowest vertex number, mm; `None` where no edge is open.
    pub first_open: Option<[Vec3; 2]>,
}

impl Edges {
    /// Whether the surface encloses a volume.
    pub const fn are_closed(&self) -> bool {
        self.open == 0 && self.count > 0
    }

    /// Whether each edge has exactly two triangles, in opposite directions.
    pub const fn are_paired(&self) -> bool {
        self.are_closed() && self.crowded == 0
    }

    pub(super) fn of(mesh: &Mesh) -> Edges {
        // The edges by their lower and higher vertex, one sorted list for each direction. Without hashing the first
        // open edge is the same on every machine.
        let mut up = Vec::with_capacity(mesh.triangles.len() * 2);
        let mut down = Vec::with_capacity(mesh.triangles.len() * 2);
        for &[a, b, c] in &mesh.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                match from.cmp(&to) {
                    std::cmp::Ordering::Less => up.push(key(from, to)),
                    std::cmp::Ordering::Greater => down.push(key(to, from)),
                    std::cmp::Ordering::Equal => {}
                }
            }
        }
        up.sort_unstable();
        down.sort_unstable();
        let mut edges = Edges::default();
        let (mut ups, mut downs) = (up.as_slice(), down.as_slice());
        while let Some(&edge) = match (ups.first(), downs.first()) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        } {
            let there = take(&mut ups, edge);
            let back = take(&mut downs, edge);
            edges.count += 1;
            if there != back {
                edges.open += 1;
                edges.turned += usize::from(there + back == 2);
                edges.first_open.get_or_insert_with(|| {
                    [edge >> 32, edge & u64::from(u32::MAX)]
                        .map(|vertex| mesh.vertices[vertex as usize])
                });
            } else if there > 1 {
                edges.crowded += 1;
            }
        }
        edges
    }
}

fn key(low: u32, high: u32) -> u64 {
    u64::from(low) << 32 | u64::from(high)
}

/// Removes an edge from the beginning of a sorted list, and returns how often it was there.
fn take(list: &mut &[u64], edge: u64) -> usize {
    let count = list.iter().take_while(|&&other| other == edge).count();
    *list = &list[count..];
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tetrahedron() -> (Vec<Vec3>, Vec<[u32; 3]>) {
        (
            vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z],
            vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
        )
    }

    #[test]
    fn closed_open_and_turned() {
        let (vertices, triangles) = tetrahedron();
        let whole = Mesh::new(vertices.clone(), triangles.clone()).unwrap();
        let edges = whole.edges();
        assert!(edges.are_paired() && edges.count == 6 && edges.first_open.is_none());
        assert!((whole.volume() - 1.0 / 6.0).abs() < 1e-15);
        assert!((whole.clone().turned().volume() + 1.0 / 6.0).abs() < 1e-15);
        assert!(whole.turned().edges().are_paired());

        let open = Mesh::new(vertices.clone(), triangles[..3].to_vec()).unwrap().edges();
        assert_eq!((open.open, open.turned), (3, 0));
        assert_eq!(open.first_open, Some([Vec3::ZERO, Vec3::Y]));

        let mut one_turned = triangles.clone();
        one_turned[2].swap(0, 1);
        let turned = Mesh::new(vertices.clone(), one_turned).unwrap().edges();
        assert_eq!((turned.open, turned.turned), (3, 3));

        let twice = Mesh::new(vertices, [triangles.clone(), triangles].concat()).unwrap().edges();
        assert!(twice.are_closed() && !twice.are_paired() && twice.crowded == 6);
        assert!(!Mesh::default().edges().are_closed());
    }
}
