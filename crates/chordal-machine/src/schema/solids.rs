//! The rows of the bodies of a machine, and of what carries its linear axes.

use super::rows::{length, word, words};
use super::{PlaceholderKeys, SchemaRow, SchemaSlot, SignRule};
use crate::machine::{Machine, RotaryTarget};
use crate::solid::{LinearOrder, MachineSolid, MachineSolidShape, SolidLink};

fn solid<'m>(machine: &'m mut Machine, keys: &PlaceholderKeys) -> &'m mut MachineSolid {
    machine.solids.entry(keys.name.clone()).or_default()
}

fn along<'b>(values: &'b mut [Option<f64>; 3], keys: &PlaceholderKeys) -> &'b mut Option<f64> {
    &mut values[keys.axis.map_or(2, |axis| axis as usize % 3)]
}

const SIDE: &str = "whether X moves the part (`table`) or the tool (`head`), for collisions with bodies on the base and on linear axes; otherwise it is not known";

pub(super) static LINEAR: [SchemaRow; 4] = [
    word(
        "kinematics.X",
        "what an axis moves",
        words!(RotaryTarget),
        |m, _| &mut m.linear.sides[0],
        SIDE,
    ),
    word(
        "kinematics.Y",
        "what an axis moves",
        words!(RotaryTarget),
        |m, _| &mut m.linear.sides[1],
        "the same for Y; otherwise it is not known",
    ),
    word(
        "kinematics.Z",
        "what an axis moves",
        words!(RotaryTarget),
        |m, _| &mut m.linear.sides[2],
        "the same for Z; otherwise it is not known",
    ),
    word(
        "kinematics.order",
        "order of the linear axes",
        words!(LinearOrder),
        |m, _| &mut m.linear.order,
        "which linear axis carries which, from the base outwards: with `YXZ`, where X and Y both move the part, Y carries X; otherwise `YXZ`",
    ),
];

pub(super) static SOLIDS: [SchemaRow; 8] = [
    SchemaRow {
        path: "solids.<name>",
        slot: SchemaSlot::Table(|m, k| {
            solid(m, k);
        }),
        doc: "a body of the machine that must not touch another one, by any name: a table, a cradle, the spindle head. It is convex, in machine coordinates with every axis at zero, where the gauge point of the spindle is at zero",
    },
    word(
        "solids.<name>.on",
        "part of the machine",
        words!(SolidLink),
        |m, k| &mut solid(m, k).on,
        "what it is fixed to: the base, what an axis moves, or what holds the tool (`spindle`)",
    ),
    word(
        "solids.<name>.shape",
        "shape of a solid",
        words!(MachineSolidShape),
        |m, k| &mut solid(m, k).shape,
        "what it is. A `box` needs `from` and `to`, a `cylinder` also the diameter",
    ),
    length(
        "solids.<name>.from.<axis>",
        SignRule::Any,
        |m, k| along(&mut solid(m, k).from, k),
        "a corner of a box, or the middle of an end of a cylinder; otherwise 0 mm (of a cylinder)",
    ),
    length(
        "solids.<name>.to.<axis>",
        SignRule::Any,
        |m, k| along(&mut solid(m, k).to, k),
        "the opposite corner or end; otherwise 0 mm (of a cylinder)",
    ),
    length(
        "solids.<name>.diameter",
        SignRule::Positive,
        |m, k| &mut solid(m, k).diameter_mm,
        "the diameter of a cylinder, of a cone that at `from`",
    ),
    length(
        "solids.<name>.end_diameter",
        SignRule::NotNegative,
        |m, k| &mut solid(m, k).end_diameter_mm,
        "the diameter of a cone at `to`; otherwise that at `from`",
    ),
    SchemaRow {
        path: "solids.<name>.may_touch",
        slot: SchemaSlot::TextList(|m, k| &mut solid(m, k).may_touch),
        doc: "the names of other bodies that it may touch: of `[solids]`, of `[fixtures]`, `stock`, `target`, `tool`; otherwise none but those that an axis moves on it",
    },
];
