//! The contour that a turning cycle cuts: lines and arcs of X and Z, and the coordinates (along the passes, across
//! them) in which every cycle cuts downwards.

use chordal_command::{ArcShape, Command, CommandKind, Origin};
use chordal_geometry::Plane;

use crate::kernel::Kernel;
use crate::statement::Statement;
use crate::turning::{COINCIDENT_MM, XZ};

/// A contour as its blocks program it.
#[derive(Clone, Debug, PartialEq)]
pub struct ContourProfile {
    /// The end of its first block: X (a radius) and Z, mm.
    pub start: [f64; 2],
    /// Its first block is a rapid.
    pub first_is_rapid: bool,
    /// The moves after it.
    pub edges: Vec<ContourEdge>,
}

/// A line or an arc of a contour, mm, in (x, z) or in (along, across) coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContourEdge {
    /// Its start.
    pub from: [f64; 2],
    /// Its end.
    pub to: [f64; 2],
    /// Centre and angle (rad) of an arc, positive from the first axis to the second; `None` for a line.
    pub arc: Option<([f64; 2], f64)>,
    /// Its block.
    pub origin: Origin,
}

impl ContourProfile {
    /// The contour of the commands of its blocks; `None` when they contain no move.
    pub fn of(commands: &[Command]) -> Option<ContourProfile> {
        let mut moves = commands.iter().filter(|command| command.kind.motion().is_some());
        let first = moves.next()?;
        let motion = first.kind.motion()?;
        let to = place(&motion.to);
        let edges = moves.filter_map(ContourEdge::of).collect();
        Some(ContourProfile {
            start: to,
            first_is_rapid: matches!(first.kind, CommandKind::Rapid { .. }),
            edges,
        })
    }

    /// All moves of commands, including the first.
    pub fn moves(commands: &[Command]) -> Vec<ContourEdge> {
        commands.iter().filter_map(ContourEdge::of).collect()
    }

    /// Removes the end of the contour that lies outside the stock, from the first edge that leads back towards the start
    /// of the cycle: it only returns the tool.
    pub fn without_return(&mut self, along_x: bool, start: [f64; 2]) {
        let axis = usize::from(!along_x);
        let cross = 1 - axis;
        let out = start[cross] - self.start[cross];
        let is_outside = |at: [f64; 2]| {
            out != 0.0 && (at[cross] - start[cross]) * out.signum() >= -COINCIDENT_MM
        };
        let is_cut = |edge: &ContourEdge| !(is_outside(edge.from) && is_outside(edge.to));
        let tail = self.edges.iter().rposition(is_cut).map_or(0, |last| last + 1);
        let first = self.start[axis];
        let goes_back = |edge: &ContourEdge| {
            (edge.to[axis] - edge.from[axis]) * (edge.from[axis] - first)
                < -COINCIDENT_MM * COINCIDENT_MM
        };
        if let Some(back) = self.edges[tail..].iter().position(goes_back) {
            self.edges.truncate(tail + back);
        }
    }

    /// Its end, mm.
    pub fn end(&self) -> [f64; 2] {
        self.edges.last().map_or(self.start, |edge| edge.to)
    }
}

fn place(position: &[f64]) -> [f64; 2] {
    [position[0], position[2]]
}

impl ContourEdge {
    fn of(command: &Command) -> Option<ContourEdge> {
        let motion = command.kind.motion()?;
        let (from, to) = (place(&motion.from), place(&motion.to));
        // In the ZX plane angles are positive from Z to X: from the second coordinate here to the first.
        let arc =
            command.kind.shape().map(|shape| ([shape.center[1], shape.center[0]], -shape.sweep));
        (from != to).then_some(ContourEdge { from, to, arc, origin: command.origin })
    }

    /// A straight edge.
    pub fn line(from: [f64; 2], to: [f64; 2], origin: Origin) -> ContourEdge {
        ContourEdge { from, to, arc: None, origin }
    }

    /// The edge in other coordinates; `turns` when these have the opposite orientation.
    pub(super) fn mapped(&self, map: impl Fn([f64; 2]) -> [f64; 2], turns: bool) -> ContourEdge {
        let arc = self.arc.map(|(center, sweep)| (map(center), if turns { -sweep } else { sweep }));
        ContourEdge { from: map(self.from), to: map(self.to), arc, origin: self.origin }
    }

    /// The piece between two fractions of its length, 0 to 1.
    pub fn piece(&self, first: f64, last: f64) -> ContourEdge {
        let from = if first <= 0.0 { self.from } else { self.at(first) };
        let to = if last >= 1.0 { self.to } else { self.at(last) };
        let arc = self.arc.map(|(center, sweep)| (center, sweep * (last - first)));
        ContourEdge { from, to, arc, origin: self.origin }
    }

    /// The point at a fraction of its length, 0 to 1.
    pub fn at(&self, share: f64) -> [f64; 2] {
        match self.arc {
            None => [0, 1].map(|i| self.from[i] + (self.to[i] - self.from[i]) * share),
            Some((center, sweep)) => {
                let from = [self.from[0] - center[0], self.from[1] - center[1]];
                let (sin, cos) = libm::sincos(sweep * share);
                [
                    center[0] + from[0] * cos - from[1] * sin,
                    center[1] + from[0] * sin + from[1] * cos,
                ]
            }
        }
    }

    /// The fractions at which its second coordinate is `level`, sorted, without its ends.
    pub fn crossings(&self, level: f64) -> Vec<f64> {
        let inside = |share: &f64| *share > 1e-12 && *share < 1.0 - 1e-12;
        let Some((center, sweep)) = self.arc else {
            let rise = self.to[1] - self.from[1];
            if rise.abs() <= COINCIDENT_MM {
                return Vec::new();
            }
            return Some((level - self.from[1]) / rise).filter(inside).into_iter().collect();
        };
        let from = [self.from[0] - center[0], self.from[1] - center[1]];
        let radius = libm::hypot(from[0], from[1]);
        let sine = (level - center[1]) / radius;
        if sine.abs() > 1.0 || sweep == 0.0 {
            return Vec::new();
        }
        let begin = libm::atan2(from[1], from[0]);
        let up = libm::asin(sine);
        let turn = 2.0 * std::f64::consts::PI;
        let mut shares: Vec<f64> = [up, std::f64::consts::PI - up]
            .into_iter()
            .flat_map(|angle| {
                [-1.0, 0.0, 1.0, 2.0, -2.0].map(|n| (angle + n * turn - begin) / sweep)
            })
            .filter(inside)
            .collect();
        shares.sort_by(f64::total_cmp);
        shares.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
        shares
    }

    /// The smallest value of its second coordinate.
    pub fn lowest(&self) -> f64 {
        let ends = self.from[1].min(self.to[1]);
        match self.arc {
            None => ends,
            Some((center, _)) => {
                let radius = libm::hypot(self.from[0] - center[0], self.from[1] - center[1]);
                let bottom = center[1] - radius;
                // The arc contains its lowest point if it crosses a level just above twice.
                let reached = self.crossings(bottom + radius * 1e-12).len() >= 2;
                if reached { bottom } else { ends }
            }
        }
    }
}

/// The coordinates of a cycle: along the passes, which run towards smaller numbers, and across them, with the part
/// below.
#[derive(Clone, Copy, Debug)]
pub(super) struct CycleView {
    /// The passes run along X.
    along_x: bool,
    along: f64,
    across: f64,
}

impl CycleView {
    /// The view of a cycle by its start and its contour.
    pub fn new(along_x: bool, start: [f64; 2], profile: &ContourProfile) -> CycleView {
        let (end, first) = (profile.end(), profile.start);
        let axis = usize::from(!along_x);
        let cross = 1 - axis;
        let sign = |value: f64| if value < 0.0 { -1.0 } else { 1.0 };
        // The passes begin on the side of the start; the part lies on the side where the contour begins.
        let along = sign(first[axis].max(start[axis]) - end[axis]);
        let along = if end[axis] == first[axis] { sign(start[axis] - end[axis]) } else { along };
        let across = if first[cross] == start[cross] {
            sign(
                start[cross]
                    - profile.edges.iter().map(|edge| edge.to[cross]).fold(first[cross], f64::min),
            )
        } else {
            sign(start[cross] - first[cross])
        };
        CycleView { along_x, along, across }
    }

    /// The view with the given signs of both coordinates.
    pub fn by_signs(along_x: bool, along: f64, across: f64) -> CycleView {
        CycleView { along_x, along, across }
    }

    /// An edge of X and Z in these coordinates.
    pub fn of(&self, edge: &ContourEdge) -> ContourEdge {
        edge.mapped(|at| self.seen(at), self.turns())
    }

    /// (x, z) as (along, across).
    pub fn seen(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        match self.along_x {
            true => [x * self.along, z * self.across],
            false => [z * self.along, x * self.across],
        }
    }

    /// Back to (x, z).
    pub fn place(&self, [along, across]: [f64; 2]) -> [f64; 2] {
        match self.along_x {
            true => [along * self.along, across * self.across],
            false => [across * self.across, along * self.along],
        }
    }

    fn turns(&self) -> bool {
        // Exchanging (x, z) to (z, x) reverses the orientation once more.
        (self.along * self.across < 0.0) == self.along_x
    }

    /// The edges of a contour in these coordinates, moved by a vector of (along, across).
    pub fn edges(&self, profile: &ContourProfile, by: [f64; 2]) -> Vec<ContourEdge> {
        let map = |at: [f64; 2]| {
            let [along, across] = self.seen(at);
            [along + by[0], across + by[1]]
        };
        profile.edges.iter().map(|edge| edge.mapped(map, self.turns())).collect()
    }

    /// An edge of these coordinates in X and Z.
    pub fn placed(&self, edge: &ContourEdge) -> ContourEdge {
        edge.mapped(|at| self.place(at), self.turns())
    }
}

impl Kernel<'_> {
    /// Cuts edges of X and Z, each reported with its own block.
    pub(super) fn turn_contour(
        &mut self,
        at: &dyn Statement,
        edges: impl Iterator<Item = ContourEdge>,
    ) {
        let cycle = self.origin;
        for edge in edges {
            self.origin = Origin { cycle: true, ..edge.origin };
            self.turn_edge(at, &edge);
        }
        self.origin = cycle;
    }

    /// Cuts an edge of X and Z from the present position.
    pub(super) fn turn_edge(&mut self, at: &dyn Statement, edge: &ContourEdge) {
        let Some((center, sweep)) = edge.arc else {
            return self.turn_cut(at, edge.to);
        };
        let target = self.place_at(edge.to);
        let motion = self.moved_to(target, XZ);
        let away = |place: [f64; 2]| libm::hypot(place[0] - center[0], place[1] - center[1]);
        let shape = ArcShape {
            plane: Plane::Zx,
            center: [center[1], center[0]],
            sweep: -sweep,
            radius_from: away([motion.from[0], motion.from[2]]),
            radius_to: away(edge.to),
        };
        let feed = self.feed_for(at, &motion, Some(&shape));
        self.emit(CommandKind::Arc { motion, shape, feed });
    }
}
