//! What is asked of a region: radii at a place, walls between grooves, a neck, loose parts.

use core::cmp::Ordering;

use chordal_geometry::Vec2;

use super::edge::RegionEdge;
use super::loops::loops;
use super::region::Region;

impl Region {
    /// The intervals of radius that are filled at `z`, from the axis outward, mm. At a wall it is what lies on
    /// the side that is asked for: −z of it or +z.
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

    /// The intervals of z that are filled at radius `r`, towards +z, mm: walls. What lies between two of them
    /// is a groove. At the radius of a step it is what lies on the side that is asked for.
    #[must_use]
    pub fn spans_at(&self, r: f64, towards: PlaceSide) -> Vec<(f64, f64)> {
        let turned: Vec<RegionEdge> = self.edges().iter().map(RegionEdge::transposed).collect();
        filled(&turned, r, towards)
    }

    /// The least of the largest radii between two z, and where it is: (z, r), mm. After a part-off along this
    /// stretch r is the radius of what still holds; 0 where nothing does. `None` of no stretch.
    #[must_use]
    pub fn neck(&self, from: f64, to: f64) -> Option<(f64, f64)> {
        let (low, high) = (from.min(to), from.max(to));
        let corners = self.edges().iter().map(|edge| edge.start.a);
        let inner = corners.filter(|z| low < *z && *z < high);
        // Edges rise or fall all along, so the largest radius is least at a corner or an end.
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

    /// The parts that hang together, each a region of its own, the largest first. Parts that touch in a point
    /// are apart.
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
            // In the smallest part around it.
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

    /// Whether a point lies within it; of points on its edges either.
    #[must_use]
    pub fn holds(&self, point: Vec2) -> bool {
        surrounds(self.edges(), point)
    }
}

/// The side of a place that is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaceSide {
    /// Just before it: towards −z, or the axis.
    Lower,
    /// Just after it: towards +z, or away from the axis.
    Higher,
}

fn reaches(edge: &RegionEdge, z: f64, towards: PlaceSide) -> bool {
    let (low, high) = (edge.start.a.min(edge.end.a), edge.start.a.max(edge.end.a));
    match towards {
        PlaceSide::Lower => low < z && z <= high,
        PlaceSide::Higher => low <= z && z < high,
    }
}

/// What is filled along a vertical, between edges with the region above and edges with it below.
fn filled(edges: &[RegionEdge], z: f64, towards: PlaceSide) -> Vec<(f64, f64)> {
    let crossed = edges.iter().filter(|edge| reaches(edge, z, towards));
    let mut passages: Vec<(f64, i32)> = crossed
        .map(|edge| (edge.radius_at(z), if edge.end.a > edge.start.a { 1 } else { -1 }))
        .collect();
    // At one radius what opens comes first: intervals that touch are one.
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

/// Whether a point lies within closed edges, by what passes above it.
fn surrounds(edges: &[RegionEdge], p: Vec2) -> bool {
    let over = edges.iter().filter(|edge| reaches(edge, p.a, PlaceSide::Higher));
    let above = over.filter(|edge| edge.is_above(p.a, p.b));
    above.map(|edge| if edge.end.a < edge.start.a { 1 } else { -1 }).sum::<i32>() > 0
}
