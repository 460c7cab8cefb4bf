//! The parts of tools as cylinders and cones, which contain them.

use std::collections::BTreeMap;

use chordal_stock::shape::{BodyBound, Frustum, RoundBody};

use super::tools::{ShankPiece, ToolBody, tools_of};
use crate::job::Job;

/// Rounded parts of a cutter are approximated from outside by cones within this, mm.
const ROUND_MM: f64 = 1e-3;

/// A part of a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ToolPart {
    Cutter,
    Shank,
    Holder,
}

/// A tool as cylinders and cones above its tip.
pub(crate) struct ToolFrustums {
    pub parts: Vec<(ToolPart, Frustum)>,
}

/// The tools that a program may use, by number; an error says why a tool has no outline.
pub(crate) fn tool_outlines(job: &Job) -> BTreeMap<u32, Result<ToolFrustums, String>> {
    let outline = |body: Result<ToolBody, super::tools::NoBody>| match body {
        Ok(body) => outline_of(&body),
        Err(reason) => Err(reason.why()),
    };
    tools_of(job).into_iter().map(|(number, body)| (number, outline(body))).collect()
}

fn outline_of(tool: &ToolBody) -> Result<ToolFrustums, String> {
    let edges =
        tool.cutter.flutes().unwrap_or_else(|| tool.top()).max(tool.cutter.side() + ROUND_MM);
    let cutter = RoundBody::of_cutter(&tool.cutter, edges, ROUND_MM, BodyBound::Outer)
        .map_err(|error| error.to_string())?;
    let mut parts: Vec<(ToolPart, Frustum)> =
        cutter.frustums().iter().map(|frustum| (ToolPart::Cutter, *frustum)).collect();
    for (part, pieces) in [(ToolPart::Shank, &tool.shank), (ToolPart::Holder, &tool.holder)] {
        let frustum = |piece: &ShankPiece| Frustum {
            from: piece.from,
            to: piece.from + piece.height,
            lower: piece.lower / 2.0,
            upper: piece.upper / 2.0,
        };
        let pieces = pieces.iter().filter(|piece| piece.height > 0.0);
        parts.extend(pieces.map(|piece| (part, frustum(piece))));
    }
    Ok(ToolFrustums { parts })
}
