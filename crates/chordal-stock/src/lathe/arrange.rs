//! The arrangement of two sets of loops, for boolean operations.
//!
//! Edges are divided where they meet, points that lie together become one vertex, coincident pieces are merged. The
//! winding numbers of both sets on the two sides of each piece decide whether it bounds a result. Of the first set
//! only the edges near the second are given; the others count by their contribution to winding numbers.

use chordal_geometry::Vec2;

use super::crossing::{EdgeSplit, crossings};
use super::edge::RegionEdge;
use super::hull::DirectionHull;
use super::weld::PointWeld;

/// The boolean operation: which points belong to the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RegionRule {
    /// In the first and not in the second.
    Difference,
    /// In both.
    Intersection,
    /// In the first or in the second.
    Union,
    /// Within an odd number of loops of the second.
    Odd,
}

impl RegionRule {
    fn holds(self, first: i32, second: i32) -> bool {
        match self {
            RegionRule::Difference => first > 0 && second <= 0,
            RegionRule::Intersection => first > 0 && second > 0,
            RegionRule::Union => first > 0 || second > 0,
            RegionRule::Odd => second % 2 != 0,
        }
    }
}

/// The edges of the first set that are not given.
pub(crate) trait UnlistedEdges {
    /// Their contribution to the winding number at a point.
    fn passages(&self, side: &WindingSide) -> i32;
}

/// For a first set whose edges are all given.
pub(crate) struct NoOthers;

impl UnlistedEdges for NoOthers {
    fn passages(&self, _: &WindingSide) -> i32 {
        0
    }
}

/// The two sets of an arrangement.
#[derive(Clone, Copy)]
pub(crate) struct ArrangementInput<'a> {
    /// Edges of the first set: all that may be near the second's.
    pub first: &'a [RegionEdge],
    /// Its other edges.
    pub others: &'a dyn UnlistedEdges,
    /// All edges of the second set.
    pub second: &'a [RegionEdge],
    /// Whether the second set is one loop that does not touch itself.
    pub simple: bool,
    /// The hull of the second set. Vertices of the first set within `margin` (mm) of it may be moved by the
    /// tolerance, since all their edges are given.
    pub hull: &'a DirectionHull,
    pub margin: f64,
    /// Points within this distance are merged, mm.
    pub tolerance: f64,
}

/// A part of an edge between two vertices.
#[derive(Clone, Copy, Debug)]
struct EdgePiece {
    edge: u32,
    from: u32,
    to: u32,
}

/// Coincident pieces, directed from the lower to the higher vertex number.
#[derive(Clone, Copy, Debug)]
struct EdgeGroup {
    low: u32,
    high: u32,
    /// The first of its edges, which gives its shape.
    edge: u32,
    /// Whether that edge goes from low to high.
    along: bool,
    middle: Vec2,
    /// For each set, how many edges go from low to high minus how many go back.
    times: [i32; 2],
    /// Winding numbers of both sets to the left of low → high.
    left: [i32; 2],
}

/// The arrangement, and work space that is reused between runs.
#[derive(Debug, Default)]
pub(crate) struct EdgeArrangement {
    weld: PointWeld,
    splits: Vec<(u32, u32)>,
    order: Vec<u32>,
    /// The vertices on one edge, with their distance along it.
    along: Vec<(f64, u32)>,
    pieces: Vec<EdgePiece>,
    /// Pieces sorted by their vertices: lower, higher, piece.
    keyed: Vec<(u32, u32, u32)>,
    /// The group of each piece.
    of_piece: Vec<u32>,
    /// A count for each vertex.
    tally: Vec<i32>,
    groups: Vec<EdgeGroup>,
    /// The index of the first piece of each edge.
    first_piece: Vec<u32>,
    count: usize,
    /// How many pairs of edges of one set properly cross.
    pub own_crossings: usize,
}

/// How an operation changes the edges of the first set.
#[derive(Debug, Default)]
pub(crate) struct ArrangementResult {
    /// The given edges that are removed, by their indices.
    pub gone: Vec<u32>,
    /// The edges that are added. Ends with a number below [`NEW`] are vertices of the first set.
    pub came: Vec<RegionEdge>,
}

/// Marks the number of a new vertex.
pub(crate) const NEW: u64 = 1 << 63;

impl EdgeArrangement {
    /// Computes the arrangement: divides, merges and classifies.
    pub fn lay(&mut self, input: &ArrangementInput<'_>) {
        self.count = input.first.len() + input.second.len();
        self.weld.clear();
        self.splits.clear();
        self.own_crossings = 0;
        for edge in input.first.iter().chain(input.second) {
            self.weld.push(edge.start);
            self.weld.push(edge.end);
        }
        self.cross(input);
        // A vertex of the first set may be merged only if all its edges are given; otherwise it must stay in place.
        let id = |at: u32| Some(input.first.get(at as usize / 2)?.ends[at as usize % 2]);
        let place = |at: u32| {
            let edge = input.first.get(at as usize / 2)?;
            Some(if at.is_multiple_of(2) { edge.start } else { edge.end })
        };
        let moves = |at: u32| place(at).is_none_or(|place| input.hull.holds(place, input.margin));
        let may = |one, other| {
            let same = id(one).is_some() && id(one) == id(other);
            same || (moves(one) && moves(other))
        };
        self.weld.join(input.tolerance, may);
        self.divide(input);
        self.group(input);
        self.classify(input);
    }

    fn edge<'a>(input: &ArrangementInput<'a>, at: u32) -> &'a RegionEdge {
        let at = at as usize;
        match at < input.first.len() {
            true => &input.first[at],
            false => &input.second[at - input.first.len()],
        }
    }

    /// Finds crossings by a sweep along z over edges whose boxes overlap.
    fn cross(&mut self, input: &ArrangementInput<'_>) {
        let Self { weld, splits, order, own_crossings, count, .. } = &mut *self;
        order.clear();
        order.extend(0..*count as u32);
        let least = |at: u32| {
            let edge = Self::edge(input, at);
            edge.start.a.min(edge.end.a)
        };
        order.sort_unstable_by(|x, y| least(*x).total_cmp(&least(*y)).then(x.cmp(y)));
        let firsts = input.first.len() as u32;
        for rank in 0..order.len() {
            let at = order[rank];
            let one = Self::edge(input, at);
            let bounds = one.bounds().grown(input.tolerance);
            for other in order[rank + 1..].iter().copied() {
                let two = Self::edge(input, other);
                let theirs = two.bounds();
                if theirs.min.a > bounds.max.a {
                    break;
                }
                let same_set = (at < firsts) == (other < firsts);
                if same_set && (at < firsts || input.simple) || !bounds.meets(&theirs) {
                    continue;
                }
                crossings(one, two, input.tolerance, |EdgeSplit { place, first, second }| {
                    let vertex = weld.push(place);
                    if first {
                        splits.push((at, vertex));
                    }
                    if second {
                        splits.push((other, vertex));
                    }
                    let ends = [one.start, one.end, two.start, two.end];
                    let inner = |end: &Vec2| end.distance(place) > input.tolerance;
                    if first && second && same_set && ends.iter().all(inner) {
                        *own_crossings += 1;
                    }
                });
            }
        }
        self.divide_by_neighbours(input);
        self.splits.sort_unstable();
    }

    /// A crossing that lies on a third edge divides that one, too, so that coincident edges are divided at the same
    /// points.
    fn divide_by_neighbours(&mut self, input: &ArrangementInput<'_>) {
        let Self { weld, splits, order, count, .. } = self;
        order.clear();
        order.extend(2 * *count as u32..weld.points.len() as u32);
        let z = |at: &u32| weld.points[*at as usize].a;
        order.sort_unstable_by(|x, y| z(x).total_cmp(&z(y)).then(x.cmp(y)));
        for at in 0..*count as u32 {
            let edge = Self::edge(input, at);
            let bounds = edge.bounds().grown(input.tolerance);
            let begin = order.partition_point(|vertex| z(vertex) < bounds.min.a);
            for vertex in order[begin..].iter().take_while(|vertex| z(vertex) <= bounds.max.a) {
                let place = weld.points[*vertex as usize];
                if bounds.holds(place) && edge.passes(place, input.tolerance) {
                    splits.push((at, *vertex));
                }
            }
        }
    }

    /// Divides every edge at its vertices.
    fn divide(&mut self, input: &ArrangementInput<'_>) {
        let Self { weld, splits, pieces, first_piece, along, .. } = self;
        pieces.clear();
        first_piece.clear();
        let mut next = 0;
        for at in 0..self.count as u32 {
            first_piece.push(pieces.len() as u32);
            let (start, end) = (weld.root(2 * at), weld.root(2 * at + 1));
            along.clear();
            while next < splits.len() && splits[next].0 == at {
                along.push((0.0, weld.root(splits[next].1)));
                next += 1;
            }
            let mut from = start;
            if !along.is_empty() {
                let edge = Self::edge(input, at);
                // Sorted along the chord, which is monotone on an arc within a quadrant.
                let chord = edge.end - edge.start;
                for (reach, vertex) in along.iter_mut() {
                    *reach = (weld.points[*vertex as usize] - edge.start).dot(chord);
                }
                along.sort_unstable_by(|x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
                for (_, vertex) in along.iter() {
                    if *vertex != from && *vertex != end && *vertex != start {
                        pieces.push(EdgePiece { edge: at, from, to: *vertex });
                        from = *vertex;
                    }
                }
            }
            if from != end {
                pieces.push(EdgePiece { edge: at, from, to: end });
            }
        }
        first_piece.push(pieces.len() as u32);
    }

    /// The middle of a piece between its merged ends.
    fn middle(&self, input: &ArrangementInput<'_>, edge: u32, from: u32, to: u32) -> Vec2 {
        let (from, to) = (self.weld.points[from as usize], self.weld.points[to as usize]);
        Self::edge(input, edge).between(from, to).middle()
    }

    /// Groups coincident pieces.
    fn group(&mut self, input: &ArrangementInput<'_>) {
        let mut keyed = core::mem::take(&mut self.keyed);
        keyed.clear();
        for (at, piece) in self.pieces.iter().enumerate() {
            keyed.push((piece.from.min(piece.to), piece.from.max(piece.to), at as u32));
        }
        keyed.sort_unstable();
        self.groups.clear();
        self.of_piece.clear();
        self.of_piece.resize(self.pieces.len(), 0);
        let firsts = input.first.len() as u32;
        let mut begin = 0;
        for rank in 0..keyed.len() {
            let (low, high, at) = keyed[rank];
            if rank > 0 && (keyed[rank - 1].0, keyed[rank - 1].1) != (low, high) {
                begin = self.groups.len();
            }
            let piece = self.pieces[at as usize];
            let middle = self.middle(input, piece.edge, low, high);
            let set = usize::from(piece.edge >= firsts);
            let times = if piece.from == low { 1 } else { -1 };
            let same = self.groups[begin..]
                .iter()
                .position(|group| group.middle.distance(middle) <= 2.0 * input.tolerance);
            let group = match same {
                Some(offset) => begin + offset,
                None => {
                    let (edge, along) = (piece.edge, piece.from == low);
                    let (times, left) = ([0; 2], [0; 2]);
                    self.groups.push(EdgeGroup { low, high, edge, along, middle, times, left });
                    self.groups.len() - 1
                }
            };
            self.groups[group].times[set] += times;
            self.of_piece[at as usize] = group as u32;
        }
        self.keyed = keyed;
    }

    /// Finds the winding numbers of both sets to the left of each group.
    fn classify(&mut self, input: &ArrangementInput<'_>) {
        self.reach_first(input);
        for at in 0..self.groups.len() {
            let group = self.groups[at];
            let second = match group.times[1] {
                1 if input.simple => 1,
                -1 if input.simple => 0,
                0 if !input.hull.holds(group.middle, input.margin) => 0,
                times => {
                    let side = self.side(&group);
                    side.to_left(self.passages(at, 1, input, &side), times)
                }
            };
            self.groups[at].left[1] = second;
        }
    }

    /// The winding number of the first set to the left of a group.
    fn count_first(&self, at: usize, input: &ArrangementInput<'_>) -> i32 {
        let side = self.side(&self.groups[at]);
        let counted = input.others.passages(&side) + self.passages(at, 0, input, &side);
        side.to_left(counted, self.groups[at].times[0])
    }

    /// Finds the winding numbers of the first set. Along the second set it changes only where the first is met.
    fn reach_first(&mut self, input: &ArrangementInput<'_>) {
        let mut met = core::mem::take(&mut self.tally);
        met.clear();
        met.resize(self.weld.points.len(), 0);
        for group in self.groups.iter_mut().filter(|group| group.times[0] != 0) {
            met[group.low as usize] = 1;
            met[group.high as usize] = 1;
            group.left[0] = i32::from(group.times[0] > 0);
        }
        // The end of the last piece, if the first set was not met there, and the winding number known there.
        let mut last: Option<(u32, i32)> = None;
        for piece in self.first_piece[input.first.len()] as usize..self.pieces.len() {
            let (EdgePiece { from, to, .. }, at) =
                (self.pieces[piece], self.of_piece[piece] as usize);
            if self.groups[at].times[0] != 0 {
                last = None;
                continue;
            }
            let first = match last {
                Some((vertex, known)) if vertex == from => known,
                _ => self.count_first(at, input),
            };
            self.groups[at].left[0] = first;
            last = (met[to as usize] == 0).then_some((to, first));
        }
        // Coincident edges of the first set.
        for at in 0..self.groups.len() {
            if self.groups[at].times[0].abs() > 1 {
                self.groups[at].left[0] = self.count_first(at, input);
            }
        }
        self.tally = met;
    }

    /// The point at which the winding number of a group is counted.
    fn side(&self, group: &EdgeGroup) -> WindingSide {
        let (low, high) = self.ends(group);
        let Vec2 { a: z, b: r } = group.middle;
        if (low.a < z && z < high.a) || (high.a < z && z < low.a) {
            return WindingSide { z, r, before: false, left: low.a < high.a };
        }
        // A vertical group: the point is next to it, towards −z if it goes up, which is to its left.
        let up = high.b > low.b;
        let z = if up { low.a.min(high.a) } else { low.a.max(high.a) };
        WindingSide { z, r, before: up, left: true }
    }

    /// The winding number of a set from the groups above a point, except for the group itself.
    fn passages(
        &self,
        own: usize,
        set: usize,
        input: &ArrangementInput<'_>,
        side: &WindingSide,
    ) -> i32 {
        let mut sum = 0;
        for (at, group) in self.groups.iter().enumerate() {
            if group.times[set] == 0 || at == own {
                continue;
            }
            let (low, high) = self.ends(group);
            if side.is_under(low.a, high.a) {
                // In the sense of its edge, which determines to which side an arc bulges.
                let edge = self.shape(input, group);
                let sign = if group.along { 1 } else { -1 };
                sum += sign * group.times[set] * passage(&edge, side);
            }
        }
        sum
    }

    /// Whether the pieces kept by a rule bound a closed region: at every vertex as many enter as leave. For a
    /// difference or a union, vertices where the given edges of the first set are open may stay open.
    pub fn closes(&mut self, rule: RegionRule) -> bool {
        let Self { tally, groups, weld, .. } = self;
        tally.clear();
        tally.resize(weld.points.len(), 0);
        let open = matches!(rule, RegionRule::Difference | RegionRule::Union);
        for group in groups.iter() {
            let times = group.kept(rule) - if open { group.times[0] } else { 0 };
            tally[group.low as usize] += times;
            tally[group.high as usize] -= times;
        }
        tally.iter().all(|excess| *excess == 0)
    }

    /// Emits the boundary of a result piece by piece, with vertex numbers of this arrangement.
    pub fn bounds(
        &self,
        input: &ArrangementInput<'_>,
        rule: RegionRule,
        mut found: impl FnMut(RegionEdge),
    ) {
        for group in &self.groups {
            let times = group.kept(rule);
            if times != 0 {
                found(self.directed(input, group, times > 0));
            }
        }
    }

    /// A group as an edge from low to high, or back.
    fn directed(
        &self,
        input: &ArrangementInput<'_>,
        group: &EdgeGroup,
        forward: bool,
    ) -> RegionEdge {
        let ends = [u64::from(group.low), u64::from(group.high)];
        let edge = self.shape(input, group);
        let edge = if group.along == forward { edge } else { edge.reversed() };
        RegionEdge { ends: if forward { ends } else { [ends[1], ends[0]] }, ..edge }
    }

    fn ends(&self, group: &EdgeGroup) -> (Vec2, Vec2) {
        (self.weld.points[group.low as usize], self.weld.points[group.high as usize])
    }

    /// The part of its first edge that a group represents, in the sense of that edge.
    fn shape(&self, input: &ArrangementInput<'_>, group: &EdgeGroup) -> RegionEdge {
        let (low, high) = self.ends(group);
        let edge = Self::edge(input, group.edge);
        if group.along { edge.between(low, high) } else { edge.between(high, low) }
    }

    fn vertex(&self, input: &ArrangementInput<'_>, at: u32) -> u64 {
        let edge = at as usize / 2;
        if edge < input.first.len() {
            input.first[edge].ends[at as usize % 2]
        } else {
            NEW | u64::from(at)
        }
    }

    /// Finds the edges that a difference or a union removes from the first set and adds to it. Adjoining pieces of
    /// one edge are joined.
    pub fn outcome(
        &mut self,
        input: &ArrangementInput<'_>,
        rule: RegionRule,
        outcome: &mut ArrangementResult,
    ) {
        outcome.gone.clear();
        outcome.came.clear();
        let mut degree = core::mem::take(&mut self.tally);
        degree.clear();
        degree.resize(self.weld.points.len(), 0);
        for group in self.groups.iter().filter(|group| group.kept(rule) != 0) {
            degree[group.low as usize] += 1;
            degree[group.high as usize] += 1;
        }
        for at in 0..self.count as u32 {
            let of_first = (at as usize) < input.first.len();
            let pieces = self.first_piece[at as usize]..self.first_piece[at as usize + 1];
            let mut run: Option<EdgeRun> = None;
            let came = outcome.came.len();
            for piece in pieces.clone() {
                let group = &self.groups[self.of_piece[piece as usize] as usize];
                let EdgePiece { from, to, .. } = self.pieces[piece as usize];
                let kept = group.kept(rule);
                if kept == 0 || group.edge != at {
                    self.finish(input, at, run.take(), outcome);
                    continue;
                }
                let forward = (kept > 0) == (from == group.low);
                run = match run {
                    Some(run)
                        if run.to == from
                            && run.forward == forward
                            && degree[from as usize] == 2 =>
                    {
                        Some(EdgeRun { to, ..run })
                    }
                    other => {
                        self.finish(input, at, other, outcome);
                        Some(EdgeRun { from, to, forward })
                    }
                };
            }
            self.finish(input, at, run, outcome);
            if of_first {
                let edge = &input.first[at as usize];
                // The edge is unchanged: one run covers all of it.
                if outcome.came.len() == came + 1 && outcome.came[came] == *edge {
                    outcome.came.pop();
                } else {
                    outcome.gone.push(at);
                }
            }
        }
        self.tally = degree;
    }

    fn finish(
        &self,
        input: &ArrangementInput<'_>,
        at: u32,
        run: Option<EdgeRun>,
        outcome: &mut ArrangementResult,
    ) {
        let Some(run) = run else { return };
        let place = |vertex: u32| self.weld.points[vertex as usize];
        let mut edge = Self::edge(input, at).between(place(run.from), place(run.to));
        edge.ends = [self.vertex(input, run.from), self.vertex(input, run.to)];
        outcome.came.push(if run.forward { edge } else { edge.reversed() });
    }
}

/// Adjoining pieces of an edge.
#[derive(Clone, Copy, Debug)]
struct EdgeRun {
    from: u32,
    to: u32,
    forward: bool,
}

impl EdgeGroup {
    /// 1 if a rule keeps it from low to high, −1 if from high to low, 0 if it bounds nothing.
    fn kept(&self, rule: RegionRule) -> i32 {
        let left = rule.holds(self.left[0], self.left[1]);
        let right = rule.holds(self.left[0] - self.times[0], self.left[1] - self.times[1]);
        i32::from(left) - i32::from(right)
    }
}

/// The point where winding numbers are counted: next to the middle of a group.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WindingSide {
    pub z: f64,
    pub r: f64,
    /// True if edges that end at z (coming from smaller z) count, instead of those that begin there.
    before: bool,
    /// True if the point is to the left of the group.
    left: bool,
}

impl WindingSide {
    /// The winding number to the left of the group, from the one counted at the point.
    fn to_left(self, counted: i32, times: i32) -> i32 {
        // Above a group that goes towards −z is its right side.
        if self.left { counted } else { counted + times }
    }

    /// Whether an edge between these z covers the point's z.
    fn is_under(&self, z0: f64, z1: f64) -> bool {
        let (low, high) = (z0.min(z1), z0.max(z1));
        if self.before { low < self.z && self.z <= high } else { low <= self.z && self.z < high }
    }
}

/// The contribution of an edge above a point to its winding number: 1 if it goes towards −z, −1 if towards +z.
pub(crate) fn passage(edge: &RegionEdge, side: &WindingSide) -> i32 {
    if !side.is_under(edge.start.a, edge.end.a) || !edge.is_above(side.z, side.r) {
        return 0;
    }
    if edge.end.a < edge.start.a { 1 } else { -1 }
}
