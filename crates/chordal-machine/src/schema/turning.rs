//! The rows of turning tools.

use super::rows::{length, quantity, tool, word, words};
use super::{SchemaRow, SchemaSlot, SignRule};
use crate::quantity::QuantityDimension;
use crate::turning::ToolFacing;

pub(super) static ROWS: [SchemaRow; 9] = [
    SchemaRow {
        path: "tools.<tool>.insert",
        slot: SchemaSlot::Insert,
        doc: "the designation of an insert: `CNMG120408` (ISO 1832) or `CNMG432` (inch) gives its corner angle, the length of its edges and its nose radius; a single letter gives the corner angle alone. C and W 80°, D and K 55°, E 75°, S and L 90°, T 60°, V 35°, A 85°, B 82°, M 86°, P 108°, H 120°, O 135°, R round. The length of its edges is `flute_length`",
    },
    SchemaRow {
        path: "tools.<tool>.holder_designation",
        slot: SchemaSlot::HolderDesignation,
        doc: "the designation of a turning holder, `PCLNR2525M12` (ISO 5608), or of a boring bar, `S20R-SCLCR09` (ISO 6261): it gives `approach_angle`, and the corner angle and the length of the edges of its inserts. `tip` is that of the usual mounting, where none is given and only one is usual: 3 of a right-hand holder, 2 of a bar, 8 of a neutral holder",
    },
    quantity(
        "tools.<tool>.insert_angle",
        QuantityDimension::Angle,
        SignRule::Positive,
        |m, k| &mut tool(m, k).turning.insert_angle_rad,
        "the corner angle of an insert; otherwise the one of its letter",
    ),
    quantity(
        "tools.<tool>.approach_angle",
        QuantityDimension::Angle,
        SignRule::Positive,
        |m, k| &mut tool(m, k).turning.approach_angle_rad,
        "the angle between the main cutting edge of an insert and the feed along Z: 95° of a PCLNL holder, 93° of an SDJCL. Needed for the tips 1 to 4; an insert with tip 5 to 8 stands symmetrically",
    ),
    length(
        "tools.<tool>.width",
        SignRule::Positive,
        |m, k| &mut tool(m, k).turning.width_mm,
        "the width of a grooving or parting tool",
    ),
    quantity(
        "tools.<tool>.lead_angle",
        QuantityDimension::Angle,
        SignRule::Any,
        |m, k| &mut tool(m, k).turning.lead_angle_rad,
        "the slope of the front edge of a grooving or parting tool: positive if the corner at the greater Z stands back; otherwise 0",
    ),
    word(
        "tools.<tool>.facing",
        "facing",
        words!(ToolFacing),
        |m, k| &mut tool(m, k).turning.facing,
        "where a grooving tool cuts; otherwise by its tip: 3, 4, 8 outside, 1, 2, 6 inside, 7 a face, 5 a back face",
    ),
    length(
        "tools.<tool>.bar_offset",
        SignRule::Positive,
        |m, k| &mut tool(m, k).turning.bar_offset_mm,
        "the distance along X from the programmed point of a boring bar to the middle of its round shank; otherwise half of `shank_diameter`",
    ),
    SchemaRow {
        path: "tools.<tool>.holder_outline",
        slot: SchemaSlot::Outline(|m, k| &mut tool(m, k).turning.holder_outline),
        doc: "the corners of the holder of a turning tool in the plane of Z and X, as distances along X and Z from the programmed point (X is not doubled)",
    },
];
