//! Closed meshes by formula, and what is inside them by another way than the crate's.

#![allow(dead_code, reason = "each test uses some of it")]

use std::f64::consts::{PI, TAU};

use chordal_geometry::{Transform, Vec3};
use chordal_stock::Mesh;

/// A grid of vertices around both ways, as triangles.
fn closed_grid(around: usize, along: usize, point: impl Fn(f64, f64) -> Vec3) -> Mesh {
    let mut vertices = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..around {
        for j in 0..along {
            let [u, v] = [i as f64 / around as f64, j as f64 / along as f64];
            vertices.push(point(u * TAU, v * TAU));
            let at = |i: usize, j: usize| ((i % around) * along + j % along) as u32;
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    Mesh::new(vertices, triangles).unwrap()
}

/// A ring of two radii about Z, moved as a whole.
pub fn torus(ring: f64, tube: f64, counts: [usize; 2], place: &Transform) -> Mesh {
    closed_grid(counts[0], counts[1], |u, v| {
        let out = ring + tube * v.cos();
        place.apply_point(Vec3::new(out * u.cos(), out * u.sin(), tube * v.sin()))
    })
}

/// A ball with dents: radius times 1 + `dent` cos(3u) sin³v.
pub fn ball(radius: f64, dent: f64, counts: [usize; 2], place: &Transform) -> Mesh {
    let [around, rings] = counts;
    let point = |u: f64, v: f64| {
        let reach = radius * (1.0 + dent * (3.0 * u).cos() * v.sin().powi(3));
        place.apply_point(Vec3::new(v.sin() * u.cos(), v.sin() * u.sin(), -v.cos()) * reach)
    };
    let mut vertices = vec![point(0.0, 0.0), point(0.0, PI)];
    let at = |i: usize, ring: usize| match ring {
        0 => 0,
        ring if ring == rings => 1,
        ring => (2 + (ring - 1) * around + i % around) as u32,
    };
    let mut triangles = Vec::new();
    for ring in 0..rings {
        for i in 0..around {
            if ring > 0 {
                let [u, v] = [i as f64 / around as f64 * TAU, ring as f64 / rings as f64 * PI];
                vertices.push(point(u, v));
                triangles.push([at(i, ring), at(i + 1, ring), at(i + 1, ring + 1)]);
            }
            if ring + 1 < rings {
                triangles.push([at(i, ring), at(i + 1, ring + 1), at(i, ring + 1)]);
            }
        }
    }
    // The last row of the first kind has its third corner at the pole.
    triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    let mesh = Mesh::new(vertices, triangles).unwrap();
    assert!(mesh.edges().are_paired(), "{:?}", mesh.edges());
    mesh
}

/// A box as twelve triangles.
pub fn cuboid(low: Vec3, high: Vec3) -> Mesh {
    let vertices = (0..8)
        .map(|corner| {
            let at = |bit: usize, axis: usize| {
                if corner >> bit & 1 == 0 { low.component(axis) } else { high.component(axis) }
            };
            Vec3::new(at(0, 0), at(1, 1), at(2, 2))
        })
        .collect();
    let faces: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Mesh::new(vertices, triangles).unwrap()
}

/// How often the surface goes around a place: the sum of the solid angles (van Oosterom, Strackee 1983).
pub fn winding(mesh: &Mesh, place: Vec3) -> f64 {
    let angles: f64 = (0..mesh.triangles().len())
        .map(|triangle| {
            let [a, b, c] = mesh.corners(triangle).map(|corner| corner - place);
            let [la, lb, lc] = [a, b, c].map(Vec3::length);
            let over = a.dot(b.cross(c));
            let under = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
            2.0 * over.atan2(under)
        })
        .sum();
    angles / (2.0 * TAU)
}
