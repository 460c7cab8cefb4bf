//! Jobs to write out.

use chordal::{Job, Machine, Source, SourceMap};

/// Every kind of move and most other commands, in inches.
pub const SMALL: &[u8] = b"%
O100 (ALL KINDS)
G20 G17 G90 G94
T1 M6
S900 M3
G0 X0 Y0
Z1.
M8
G1 Z-.1 F10.
G1 X1.
G3 X2. Y1. I0 J1.
G2 X2. Y1. I0 J-.5 Z-.2
G18 G2 X3. Z-.2 I.5 K0
G17 G4 P500
G93 G1 X0 F2.
G94
G0 Z1.
M5
M30
%
";

/// What Haas and others alarm at.
pub const WRONG: &[u8] = b"%
O100 (WRONG)
G20 G90 S900 M3
G1 X0 Y0 F10.
G3 X1. Y1.2 I0. J1.
G2 X3. Y1. R0.5
M98 P200
M30
%
";

/// A job of one text.
pub fn job<'a>(machine: &str, name: &str, text: &'a [u8]) -> Job<'a> {
    let mut sources = SourceMap::new();
    sources.add(Source::new(name, text));
    Job::new(sources, Machine::from_builtin(machine).unwrap()).unwrap()
}
