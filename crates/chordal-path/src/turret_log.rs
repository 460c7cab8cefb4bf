//! Compares the positions where the turret of a lathe indexes with everything that the program cuts.
//!
//! The region between a cut and the spindle axis is the part, or was part of it. The part turns about Z, so only the
//! distance from the axis matters for X. The check is made at the end of the run, when all cuts are known, and only
//! within one work coordinate system.

use chordal_command::{Origin, Position, Units, WorkName};
use chordal_diagnostics::TextShift;

/// The largest number of cuts that are remembered in a run; later cuts are ignored.
const MAX_CUTS: usize = 20_000;

/// The largest number of turns of the turret that are remembered in a run; later turns are ignored.
const MAX_TURNS: usize = 1000;

/// A tip inside the part by less is on its surface, mm.
const ON_SIDE_MM: f64 = 1e-6;

/// A work coordinate system, with X and Z of its zero, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct TurretSystem {
    name: WorkName,
    zero: [f64; 2],
}

impl TurretSystem {
    pub fn new(name: WorkName, work: &Position) -> TurretSystem {
        TurretSystem { name, zero: [work[0], work[2]] }
    }
}

/// A cut in (z, radius), mm. The region between it and the axis is the part, or was part of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct TurnedCut {
    from: [f64; 2],
    to: [f64; 2],
}

impl TurnedCut {
    /// A straight cut between two points (X as a radius, Z), mm.
    pub fn new(from: [f64; 2], to: [f64; 2]) -> TurnedCut {
        let seen = |[x, z]: [f64; 2]| [z, x.abs()];
        let (from, to) = (seen(from), seen(to));
        match from[0] <= to[0] {
            true => TurnedCut { from, to },
            false => TurnedCut { from: to, to: from },
        }
    }

    /// The distance of a point (X, Z) from the region between the cut and the axis, mm; inside, the negative depth
    /// along X.
    fn distance(&self, [x, z]: [f64; 2]) -> f64 {
        let place = [z, x.abs()];
        let [low, high] = [self.from, self.to];
        if low[0] < z && z < high[0] {
            let share = (z - low[0]) / (high[0] - low[0]);
            let depth = place[1] - (low[1] + (high[1] - low[1]) * share);
            if depth <= 0.0 {
                return depth;
            }
        }
        let side = |end: [f64; 2]| distance_to_segment(place, end, [end[0], 0.0]);
        distance_to_segment(place, low, high).min(side(low)).min(side(high))
    }
}

fn distance_to_segment(place: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let path = [to[0] - from[0], to[1] - from[1]];
    let off = [place[0] - from[0], place[1] - from[1]];
    let square = path[0] * path[0] + path[1] * path[1];
    let share = if square > 0.0 { (off[0] * path[0] + off[1] * path[1]) / square } else { 0.0 };
    let share = share.clamp(0.0, 1.0);
    libm::hypot(off[0] - path[0] * share, off[1] - path[1] * share)
}

/// A turn of the turret.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TurretTurn {
    pub system: TurretSystem,
    /// The previous tool and the position of its tip (X as a radius, Z), mm.
    pub from: (u32, [f64; 2]),
    /// The new tool, and the position of its tip, mm; `None` unless the offsets of both tools are known.
    pub to: (u32, Option<[f64; 2]>),
    pub units: Units,
    pub origin: Origin,
}

/// A turn of the turret close to the part.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NearTurn {
    pub turn: TurretTurn,
    /// The tool that is close to the part.
    pub tool: u32,
    /// The position of its tip (X as a radius, Z), mm.
    pub place: [f64; 2],
    /// Its distance from what is cut, mm; negative inside.
    pub distance: f64,
}

/// What a run, or a part of it, has cut, and where the turret turned.
#[derive(Clone, Debug, Default)]
pub(crate) struct TurretLog {
    cuts: Vec<(TurretSystem, TurnedCut)>,
    turns: Vec<TurretTurn>,
}

impl TurretLog {
    /// Adds a cut.
    pub fn cut(&mut self, system: TurretSystem, cut: TurnedCut) {
        if self.cuts.len() < MAX_CUTS && self.cuts.last() != Some(&(system, cut)) {
            self.cuts.push((system, cut));
        }
    }

    /// Adds a turn of the turret.
    pub fn turn(&mut self, turn: TurretTurn) {
        if self.turns.len() < MAX_TURNS {
            self.turns.push(turn);
        }
    }

    /// Adds the log of the part of the run that follows.
    pub fn and(&mut self, next: &TurretLog) {
        next.cuts.iter().for_each(|(system, cut)| self.cut(*system, *cut));
        next.turns.iter().for_each(|turn| self.turn(*turn));
    }

    /// Moves the positions in the text after an edit of other text; `None` if one of them was in the edited text.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        for turn in &mut self.turns {
            turn.origin = turn.origin.shifted(shift)?;
        }
        Some(())
    }

    /// Reports the turns inside of what is cut, or closer to it than the clearance, mm.
    pub fn judge(&self, clearance_mm: f64, mut report: impl FnMut(&NearTurn)) {
        for turn in &self.turns {
            let places = [(turn.from.0, Some(turn.from.1)), turn.to];
            let near = places.into_iter().find_map(|(tool, place)| {
                let place = place?;
                let distance = self.distance(turn.system, place);
                let is_near = distance < clearance_mm - ON_SIDE_MM || distance < -ON_SIDE_MM;
                is_near.then_some((tool, place, distance))
            });
            if let Some((tool, place, distance)) = near {
                report(&NearTurn { turn: *turn, tool, place, distance });
            }
        }
    }

    fn distance(&self, system: TurretSystem, place: [f64; 2]) -> f64 {
        let cuts = self.cuts.iter().filter(|(of, _)| *of == system);
        cuts.map(|(_, cut)| cut.distance(place)).fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_along_x_inside_and_the_shortest_outside() {
        // A cone from 20 mm at Z0 to 30 mm at Z-50.
        let cut = TurnedCut::new([20.0, 0.0], [-30.0, -50.0]);
        let slope = libm::hypot(50.0, 10.0);
        let cases = [
            ([25.0, -25.0], 0.0),
            ([10.0, -25.0], -15.0),
            ([-10.0, -25.0], -15.0),
            ([25.0 + slope / 50.0, -25.0], 1.0),
            ([10.0, 3.0], 3.0),
            ([24.0, 3.0], 5.0),
            ([30.0, -54.0], 4.0),
        ];
        for (place, expected) in cases {
            assert!((cut.distance(place) - expected).abs() < 1e-12, "{place:?}");
        }
    }
}
