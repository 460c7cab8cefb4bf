//! A pocket with islands: the border of what a tool's centre may reach, and rings that clear it.

use chordal_geometry::Vec2;

use super::inset::{WalledRegion, borders};
use super::outline::{COINCIDENT_POINT_MM, Outline, OutlineElement};

/// Why outlines are not a pocket with islands.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum IslandError {
    /// Two outlines cross or touch at a point.
    Crossing(Vec2),
    /// An island lies outside of the pocket or in another island; one of its points.
    Misplaced(Vec2),
}

/// A pocket with islands.
#[derive(Clone, Debug)]
pub struct IslandPocket {
    outline: Outline,
    islands: Vec<Outline>,
}

impl WalledRegion for IslandPocket {
    fn walls(&self) -> Vec<OutlineElement> {
        let islands = self.islands.iter().flat_map(|island| island.elements().iter().rev());
        let around = islands.map(OutlineElement::reversed);
        self.outline.elements().iter().copied().chain(around).collect()
    }

    fn distance(&self, p: Vec2) -> f64 {
        let islands = self.islands.iter().map(|island| island.distance(p));
        islands.fold(self.outline.distance(p), f64::min)
    }

    fn contains(&self, p: Vec2) -> bool {
        self.outline.contains(p) && !self.islands.iter().any(|island| island.contains(p))
    }
}

/// A point where two outlines meet.
pub fn outlines_meet(first: &Outline, second: &Outline) -> Option<Vec2> {
    let crossings = |a: &OutlineElement| {
        let points = second.elements().iter().flat_map(|b| a.crossings(b, COINCIDENT_POINT_MM));
        points.into_iter().next()
    };
    first.elements().iter().find_map(crossings)
}

impl IslandPocket {
    /// A pocket with islands that lie apart from each other and from its wall.
    ///
    /// # Errors
    /// Where they do not.
    pub fn new(outline: Outline, islands: Vec<Outline>) -> Result<IslandPocket, IslandError> {
        let begin = |own: &Outline| own.elements().first().map(OutlineElement::from);
        for (index, island) in islands.iter().enumerate() {
            let others = islands[..index].iter().chain([&outline]);
            if let Some(point) = others.filter_map(|other| outlines_meet(island, other)).next() {
                return Err(IslandError::Crossing(point));
            }
            let Some(point) = begin(island) else { continue };
            let is_nested = islands
                .iter()
                .enumerate()
                .any(|(other, own)| other != index && own.contains(point));
            if is_nested || !outline.contains(point) {
                return Err(IslandError::Misplaced(point));
            }
        }
        Ok(IslandPocket { outline, islands })
    }

    /// Its wall.
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// The border of the points at least a distance (zero or more, mm) from the walls, with these on its left.
    pub fn borders(&self, distance: f64) -> Vec<Outline> {
        if distance <= COINCIDENT_POINT_MM {
            let around = |island: &Outline| {
                Outline::of_loop(
                    island.elements().iter().rev().map(OutlineElement::reversed).collect(),
                )
            };
            return [self.outline.clone()]
                .into_iter()
                .chain(self.islands.iter().map(around))
                .collect();
        }
        borders(self, distance)
    }

    /// The borders at a distance, at that and a step more, and so on, mm; `None` for more than the limit.
    pub fn rings(&self, distance: f64, step: f64, limit: usize) -> Option<Vec<Vec<Outline>>> {
        let mut found = Vec::new();
        loop {
            let ring = self.borders(distance + step * found.len() as f64);
            if ring.is_empty() {
                return Some(found);
            }
            found.push(ring);
            if found.len() > limit {
                return None;
            }
        }
    }

    /// Whether a point lies inside and at least a distance from the walls, mm.
    pub fn has_room(&self, p: Vec2, distance: f64) -> bool {
        self.contains(p) && self.distance(p) >= distance - COINCIDENT_POINT_MM
    }

    /// Whether a straight line stays at least a distance from the walls; its ends may lie on the border.
    pub fn is_clear(&self, distance: f64, from: Vec2, to: Vec2) -> bool {
        let line = OutlineElement::Line { from, to };
        if line.length() <= COINCIDENT_POINT_MM {
            return true;
        }
        // Its nearest point to a wall is at an end of one of the two, or where they cross.
        let far = distance - 10.0 * COINCIDENT_POINT_MM;
        let walls = self.walls();
        let keeps = |wall: &OutlineElement| {
            let crosses = !line.crossings(wall, COINCIDENT_POINT_MM).is_empty();
            let nearest = match *wall {
                OutlineElement::Arc { center, .. } => {
                    // The foot of the centre on the line is where an arc comes nearest.
                    let foot = line.fraction(center, 0.0).map(|t| line.point(t));
                    let foot = foot.map_or(f64::INFINITY, |foot| wall.distance(foot));
                    foot.min(line.distance(wall.from()))
                }
                OutlineElement::Line { .. } => line.distance(wall.from()),
            };
            let ends = wall.distance(from).min(wall.distance(to));
            !crosses && nearest.min(ends) >= far
        };
        walls.iter().all(keeps) && self.contains(line.point(0.5))
    }

    /// The point of the walls farthest from a border that is out of reach by more than a tolerance, with the distance
    /// that is left, mm; `None` where all is reached.
    pub fn unreached(
        &self,
        borders: &[Outline],
        distance: f64,
        tolerance: f64,
    ) -> Option<(f64, Vec2)> {
        let middles = self.walls().into_iter().map(|wall| wall.point(0.5));
        let left = middles.map(|middle| {
            let near = borders.iter().map(|border| border.distance(middle));
            (near.fold(f64::INFINITY, f64::min) - distance, middle)
        });
        left.filter(|(left, _)| *left > tolerance).max_by(|a, b| a.0.total_cmp(&b.0))
    }
}

impl Outline {
    /// Its elements from the start that is nearest to a point.
    pub fn begun_near(&self, p: Vec2) -> Vec<OutlineElement> {
        let elements = self.elements();
        let near = |index: &usize| elements[*index].from().distance(p);
        let first = (0..elements.len()).min_by(|a, b| near(a).total_cmp(&near(b))).unwrap_or(0);
        elements[first..].iter().chain(&elements[..first]).copied().collect()
    }

    /// Its elements from the middle of the longest one.
    pub fn begun_in_middle(&self) -> Vec<OutlineElement> {
        let elements = self.elements();
        let long = |index: &usize| elements[*index].length();
        let Some(first) = (0..elements.len()).max_by(|a, b| long(a).total_cmp(&long(b))) else {
            return Vec::new();
        };
        let [begin, end] = [elements[first].part(0.5, 1.0), elements[first].part(0.0, 0.5)];
        let rest = elements[first + 1..].iter().chain(&elements[..first]).copied();
        [begin].into_iter().chain(rest).chain([end]).collect()
    }
}
