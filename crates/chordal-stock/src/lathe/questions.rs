//! Queries on a region: radii at a position, walls between grooves, a neck, separate bodies.

use core::cmp::Ordering;

use chordal_geometry::Vec2;

use super::edge::RegionEdge;
use super::loops::loops;
use super::region::Region;

impl Region {
    /// The filled intervals of radius at `z`, from the axis outwards, mm. `towards` chooses the side of a wall at
    /// `z`.
    #[must_use]
    pub fn radii_at(&self, z: f64, towards: PlaceSide) -> Vec<(f64, f64)> {
        filled(self.edges(), z, towards)
    }

    /// The largest radius at `z`, on either side, mm; `None` where nothing is filled.
    #[must_use]
    pub fn highest_at(&self, z: f64) -> Option<f64> {
        let sides = [PlaceSide::Lower, PlaceSide::Higher];
        let tops = sides.iter().filter_map(|side| Some(self.radii_at(z, *side).last()?.1));
        tops.max_by(f64::total_cmp)
    }

    /// The least radius at `z`, on either side, mm; `None` where nothing is filled.
    #[must_use]
    pub fn lowest_at(&self, z: f64) -> Option<f64> {
        let sides = [PlaceSide::Lower, PlaceSide::Higher];
        let bottoms = sides.iter().filter_map(|side| Some(self.radii_at(z, *side).first()?.0));
        bottoms.min_by(f64::total_cmp)
    }

    /// The filled intervals of z at the radius `r`, towards +z, mm: these are walls, with grooves between them.
    /// `towards` chooses the side of a step at `r`.
    #[must_use]
    pub fn spans_at(&self, r: f64, towards: PlaceSide) -> Vec<(f64, f64)> {
        let turned: Vec<RegionEdge> = self.edges().iter().map(RegionEdge::transposed).collect();
        filled(&turned, r, towards)
    }

    /// The minimum over a range of z of the largest radius, and its place, as (z, r), mm. After a part-off in this
    /// range, r is the radius of the remaining link, or 0 where there is none. `None` for an empty range.
    #[must_use]
    pub fn neck(&self, from: f64, to: f64) -> Option<(f64, f64)> {
        let (low, high) = (from.min(to), from.max(to));
        let corners = self.edges().iter().map(|edge| edge.start.a);
        let inner = corners.filter(|z| low < *z && *z < high);
        // Edges are monotone, so the minimum is at a corner or an end.
        let mut places: Vec<(f64, PlaceSide)> = inner
            .flat_map(|z| [(z, PlaceSide::Lower), (z, PlaceSide::Higher)])
            .chain([(low, PlaceSide::Higher), (high, PlaceSide::Lower)])
            .collect();
        places.sort_by(|x, y| x.0.total_cmp(&y.0));
        places.dedup();
        if low.partial_cmp(&high) != Some(Ordering::Less) {
            return None;
        }
        let tops = places.iter().map(|(z, side)| {
            let top = self.radii_at(*z, *side).last().map_or(0.0, |interval| interval.1);
            (*z, top)
        });
        tops.min_by(|x, y| x.1.total_cmp(&y.1))
    }

    /// The connected parts as separate regions, the largest first. Parts that touch only in a point are separate.
    #[must_use]
    pub fn bodies(&self) -> Vec<Region> {
        let chains = loops(self.edges());
        let area = |chain: &[RegionEdge]| -> f64 {
            let origin = chain[0].start;
            chain.iter().map(|edge| edge.area(origin)).sum()
        };
        let (mut outer, mut holes) = (Vec::new(), Vec::new());
        for chain in chains {
            let area = area(&chain);
            if area > 0.0 { outer.push((area, chain)) } else { holes.push(chain) }
        }
        outer.sort_by(|x, y| y.0.total_cmp(&x.0));
        let mut bodies: Vec<(Vec<RegionEdge>, Vec<RegionEdge>)> =
            outer.into_iter().map(|(_, chain)| (chain, Vec::new())).collect();
        for hole in holes {
            // The hole belongs to the smallest part around it.
            let inside = hole[0].middle();
            let around = bodies.iter().rposition(|(chain, _)| surrounds(chain, inside));
            if let Some(at) = around.or((!bodies.is_empty()).then_some(0)) {
                bodies[at].1.extend(hole);
            }
        }
        let whole = |(mut chain, holes): (Vec<RegionEdge>, Vec<RegionEdge>)| {
            chain.extend(holes);
            Region::of(chain)
        };
        bodies.into_iter().map(whole).collect()
    }

    /// Whether a point is inside; undefined for points on the outline.
    #[must_use]
    pub fn holds(&self, point: Vec2) -> bool {
        surrounds(self.edges(), point)
    }
}

/// On which side of a coordinate a query looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaceSide {
    /// Just below it: towards −z, or towards the axis.
    Lower,
    /// Just above it: towards +z, or away from the axis.
    Higher,
}

fn reaches(edge: &RegionEdge, z: f64, towards: PlaceSide) -> bool {
    let (low, high) = (edge.start.a.min(edge.end.a), edge.start.a.max(edge.end.a));
    match towards {
        PlaceSide::Lower => low < z && z <= high,
        PlaceSide::Higher => low <= z && z < high,
    }
}

/// The filled intervals on a line of constant z.
fn filled(edges: &[RegionEdge], z: f64, towards: PlaceSide) -> Vec<(f64, f64)> {
    let crossed = edges.iter().filter(|edge| reaches(edge, z, towards));
    let mut passages: Vec<(f64, i32)> = crossed
        .map(|edge| (edge.radius_at(z), if edge.end.a > edge.start.a { 1 } else { -1 }))
        .collect();
    // At equal radii openings come first, so that touching intervals are merged.
    passages.sort_by(|x, y| x.0.total_cmp(&y.0).then(y.1.cmp(&x.1)));
    let (mut found, mut depth, mut begin) = (Vec::new(), 0, 0.0);
    for (r, step) in passages {
        if depth == 0 && step > 0 {
            begin = r;
        }
        depth += step;
        if depth == 0 && step < 0 && r > begin {
            found.push((begin, r));
        }
    }
    found
}

/// Whether a point is inside closed edges, by the winding number from the edges above it.
fn surrounds(edges: &[RegionEdge], p: Vec2) -> bool {
    let over = edges.iter().filter(|edge| reaches(edge, p.a, PlaceSide::Higher));
    let above = over.filter(|edge| edge.is_above(p.a, p.b));
    above.map(|edge| if edge.end.a < edge.start.a { 1 } else { -1 }).sum::<i32>() > 0
}
