//! Roundings and chamfers between two elements of an outline, fitted as those between two moves.

use chordal_geometry::Vec2;

use super::outline::OutlineElement;
use crate::corner_fit::{CornerFit, CornerLeg, chamfer, rounding};

/// Two elements that meet, with a rounding of a radius (mm) between them; `None` where it does not fit or where there is
/// no corner.
pub fn rounded(
    first: &OutlineElement,
    second: &OutlineElement,
    radius: f64,
) -> Option<[OutlineElement; 3]> {
    let fit = rounding(&leg(first), &leg(second), radius, 0.0).ok()??;
    Some(with_corner(first, second, &fit))
}

/// Two lines that meet, with a chamfer that takes a length (mm) of each; `None` where it does not fit or where there is
/// no corner.
pub fn chamfered(
    first: &OutlineElement,
    second: &OutlineElement,
    length: f64,
) -> Option<[OutlineElement; 3]> {
    let are_lines = [first, second].iter().all(|own| matches!(own, OutlineElement::Line { .. }));
    let is_left = length < first.length() && length < second.length();
    if !are_lines || !is_left {
        return None;
    }
    let fit = chamfer(&leg(first), &leg(second), length, 0.0).ok()??;
    Some(with_corner(first, second, &fit))
}

fn leg(element: &OutlineElement) -> CornerLeg {
    let arc = match *element {
        OutlineElement::Line { .. } => None,
        OutlineElement::Arc { center, sweep, .. } => Some((center.to_array(), sweep)),
    };
    CornerLeg { from: element.from().to_array(), to: element.to().to_array(), arc }
}

/// Both elements without what the corner takes of them, and the corner between them.
fn with_corner(
    first: &OutlineElement,
    second: &OutlineElement,
    fit: &CornerFit,
) -> [OutlineElement; 3] {
    let share = |element: &OutlineElement, lost: f64| match *element {
        OutlineElement::Line { .. } => lost / element.length(),
        OutlineElement::Arc { sweep, .. } => lost / sweep.abs(),
    };
    let [from, to] = [fit.start, fit.end].map(Vec2::from_array);
    let corner = match fit.arc {
        Some((center, sweep)) => {
            OutlineElement::Arc { from, to, center: Vec2::from_array(center), sweep }
        }
        None => OutlineElement::Line { from, to },
    };
    let [t, s] = [1.0 - share(first, fit.lost[0]), share(second, fit.lost[1])];
    [first.part(0.0, t), corner, second.part(s, 1.0)]
}
