//! The rows of stock, fixtures and target, which have the same keys.

use super::rows::{length, word, words};
use super::{PlaceholderKeys, SchemaRow, SchemaSlot, SignRule};
use crate::axis::Axis;
use crate::machine::Machine;
use crate::quantity::QuantityDimension;
use crate::setup::{Body, BodyShape, CuttingForce, MeshUnit};

const AXES: &[&str] = &["X", "Y", "Z"];

fn stock<'m>(machine: &'m mut Machine, _: &PlaceholderKeys) -> &'m mut Body {
    machine.setup.stock.get_or_insert_default()
}

fn fixture<'m>(machine: &'m mut Machine, keys: &PlaceholderKeys) -> &'m mut Body {
    machine.setup.fixtures.entry(keys.name.clone()).or_default()
}

fn target<'m>(machine: &'m mut Machine, _: &PlaceholderKeys) -> &'m mut Body {
    machine.setup.target.get_or_insert_default()
}

fn along<'b>(values: &'b mut [Option<f64>; 3], keys: &PlaceholderKeys) -> &'b mut Option<f64> {
    &mut values[keys.axis.map_or(2, |axis| axis as usize % 3)]
}

/// The field of an end that is given only by its coordinate on the axis of the body.
fn end_on_axis(
    body: &mut Body,
    end: impl FnOnce(&mut Body) -> &mut [Option<f64>; 3],
) -> &mut Option<f64> {
    let axis = body.axis.unwrap_or(Axis::Z) as usize % 3;
    &mut end(body)[axis]
}

/// The rows of one table.
macro_rules! body_rows {
    ($name:ident, $table:literal, $body:ident, $doc:literal) => {
        pub(super) static $name: [SchemaRow; 15] = [
            SchemaRow { path: $table, slot: SchemaSlot::Body($body), doc: $doc },
            word(concat!($table, ".shape"), "body shape", words!(BodyShape), |m, k| &mut $body(m, k).shape, "what it is. A `box` needs `from` and `to`, a `cylinder` also the diameter, a `tube` also the bore, an `stl` or `dxf` the file, a `contour` its points. On a lathe a half section is a `cylinder`, `tube`, `contour` or `dxf`"),
            SchemaRow {
                path: concat!($table, ".work_offset"),
                slot: SchemaSlot::OptionalText(|m, k| &mut $body(m, k).work_offset),
                doc: "the work offset in whose coordinates it is given; otherwise that of the first cut",
            },
            length(
                concat!($table, ".from"),
                SignRule::Any,
                |m, k| end_on_axis($body(m, k), |body| &mut body.from),
                "where a cylinder begins on its axis (write `axis` before it), or the lowest corner by X, Y and Z",
            ),
            length(
                concat!($table, ".from.<axis>"),
                SignRule::Any,
                |m, k| along(&mut $body(m, k).from, k),
                "the lowest corner of a box; where a cylinder begins, with the middle of its end; the zero of an STL file",
            ),
            length(
                concat!($table, ".to"),
                SignRule::Any,
                |m, k| end_on_axis($body(m, k), |body| &mut body.to),
                "where a cylinder ends on its axis, or the highest corner by X, Y and Z",
            ),
            length(
                concat!($table, ".to.<axis>"),
                SignRule::Any,
                |m, k| along(&mut $body(m, k).to, k),
                "the highest corner of a box; where a cylinder ends",
            ),
            word(concat!($table, ".axis"), "body axis", AXES, |m, k| &mut $body(m, k).axis, "the axis of a cylinder or tube; otherwise Z"),
            length(
                concat!($table, ".diameter"),
                SignRule::Positive,
                |m, k| &mut $body(m, k).diameter_mm,
                "the diameter of a cylinder or tube",
            ),
            length(
                concat!($table, ".bore"),
                SignRule::Positive,
                |m, k| &mut $body(m, k).bore_mm,
                "the diameter of the bore of a tube",
            ),
            SchemaRow {
                path: concat!($table, ".file"),
                slot: SchemaSlot::File(|m, k| &mut $body(m, k).file),
                doc: "the STL or DXF file, relative to this file",
            },
            SchemaRow {
                path: concat!($table, ".contour"),
                slot: SchemaSlot::Contour(|m, k| &mut $body(m, k).contour),
                doc: "the outline of a half section: X as a diameter and Z of each corner; with a radius an arc leads to it, as G3 with a positive radius and as G2 with a negative one. An outline that does not end where it begins is closed along the axis",
            },
            word(concat!($table, ".unit"), "mesh unit", words!(MeshUnit), |m, k| &mut $body(m, k).unit, "the unit of the file, which the file does not name; otherwise mm"),
            word(concat!($table, ".turned_over"), "body axis", AXES, |m, k| &mut $body(m, k).turned_over, "an STL file is turned by 180 degrees about this axis before it is placed: the part of operation 1, turned over for operation 2"),
            SchemaRow {
                path: concat!($table, ".material"),
                slot: SchemaSlot::OptionalText(|m, k| &mut $body(m, k).material),
                doc: "what it is made of",
            },
        ];
    };
}

body_rows!(STOCK, "stock", stock, "what the program cuts from");
body_rows!(
    FIXTURE,
    "fixtures.<name>",
    fixture,
    "a vise, a clamp or another body that the tool must not touch, by any name"
);
body_rows!(TARGET, "target", target, "the part as it should be");

fn material<'m>(machine: &'m mut Machine, keys: &PlaceholderKeys) -> &'m mut CuttingForce {
    machine.setup.materials.entry(keys.name.clone()).or_default()
}

pub(super) static MATERIALS: [SchemaRow; 4] = [
    SchemaRow {
        path: "materials.<name>",
        slot: SchemaSlot::Table(|m, k| {
            material(m, k);
        }),
        doc: "the cutting force of a material, by the word of `[stock] material`; it counts before the built-in table",
    },
    SchemaRow {
        path: "materials.<name>.k_c1",
        slot: SchemaSlot::Within {
            dimension: Some(QuantityDimension::Stress),
            from: 10.0,
            to: 20_000.0,
            usual: "such as 700 N/mm² for aluminium, 1500 for steel, 3300 for nickel alloys",
            place: |m, k| &mut material(m, k).k_c1_n_per_mm2,
        },
        doc: "the force on a chip of 1 mm × 1 mm (Kienzle); otherwise that of the built-in material of this name",
    },
    SchemaRow {
        path: "materials.<name>.m_c",
        slot: SchemaSlot::Within {
            dimension: None,
            from: 0.0,
            to: 0.8,
            usual: "such as 0.25",
            place: |m, k| &mut material(m, k).m_c,
        },
        doc: "by which power of the thickness of the chip the force by area falls; otherwise that of the built-in material of this name",
    },
    SchemaRow {
        path: "materials.<name>.source",
        slot: SchemaSlot::OptionalText(|m, k| &mut material(m, k).source),
        doc: "where the values are from",
    },
];

pub(super) static OWN: [SchemaRow; 2] = [
    length(
        "fixtures.<name>.clearance",
        SignRule::NotNegative,
        |m, k| &mut fixture(m, k).clearance_mm,
        "how far the tool must stay away from it; otherwise 0 mm",
    ),
    length(
        "target.tolerance",
        SignRule::Positive,
        |m, k| &mut target(m, k).tolerance_mm,
        "how far the part may be from it; otherwise 0.05 mm (assumed)",
    ),
];
