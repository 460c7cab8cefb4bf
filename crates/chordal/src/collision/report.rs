//! The result of a check for collisions, as plain data.

use chordal_diagnostics::Code;

use crate::report::Report;

/// The verdict on the collisions of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CollisionVerdict {
    /// No two bodies that are given touch on any move, which is proved.
    Clean,
    /// Two bodies touch, or the program has errors.
    Problems,
    /// No collision was found, but not all of them can be excluded.
    NotProved,
}

impl CollisionVerdict {
    /// Its word in tables and JSON.
    pub const fn as_str(self) -> &'static str {
        match self {
            CollisionVerdict::Clean => "clean",
            CollisionVerdict::Problems => "problems",
            CollisionVerdict::NotProved => "not-proved",
        }
    }
}

/// Two bodies that touch, or for which it is not proved that they do not.
#[derive(Clone, Debug, PartialEq)]
pub struct CollisionProblem {
    /// [`Code::MachineCollision`] or [`Code::CollisionNotProved`].
    pub code: Code,
    /// The file of the block.
    pub file: String,
    /// Its line, from 1.
    pub line: u32,
    /// The two bodies, as messages name them.
    pub bodies: [String; 2],
    /// How deep they are in each other at least, mm; zero if they may only be near.
    pub depth_mm: f64,
    /// How far apart they are at most where they are nearest, mm.
    pub distance_mm: f64,
    /// The positions of X, Y, Z, A, B and C there, machine coordinates, mm and rad; `None` for axes that the machine does
    /// not have.
    pub axes: [Option<f64>; 6],
}

/// The result of a check for collisions.
#[derive(Clone, Debug)]
pub struct CollisionReport {
    /// Bodies that touch are found; bodies that stay so far apart are not reported, mm.
    pub tolerance_mm: f64,
    /// The verdict.
    pub verdict: CollisionVerdict,
    /// The bodies that were compared, as messages name them, in the order of the run.
    pub bodies: Vec<String>,
    /// Tools without a holder.
    pub without_holder: Vec<u32>,
    /// Number of pairs of bodies that must not touch.
    pub pairs: usize,
    /// Number of moves that were followed.
    pub moves: u64,
    /// Number of positions of two bodies that were looked at.
    pub positions: u64,
    /// Every pair of bodies and block, in the order of the run.
    pub problems: Vec<CollisionProblem>,
    /// Problems that are not in the list because there are too many.
    pub more_problems: u64,
    /// The report of the run, with the problems as diagnostics among the others.
    pub report: Report,
}
