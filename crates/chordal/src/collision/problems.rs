//! Words for what collides.

use chordal_command::{Origin, Units, number_text};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_machine::Axis;

use super::report::CollisionProblem;

/// The diagnostic of two bodies that touch, or may touch.
pub(super) fn contact_diagnostic(
    problem: &CollisionProblem,
    origin: &Origin,
    units: Units,
) -> Diagnostic {
    let [one, other] = &problem.bodies;
    let place = axes_text(&problem.axes, units);
    let length = |mm: f64| units.length_text(mm);
    let is_doubt = problem.code == Code::CollisionNotProved;
    let measure = match (is_doubt, problem.depth_mm > 0.0) {
        (false, true) => {
            format!("{one} is at least {} deep in {other}", length(problem.depth_mm))
        }
        (false, false) => {
            format!(
                "{one} touches {other}, or is no more than {} away",
                length(problem.distance_mm)
            )
        }
        (true, _) => format!("{one} may touch {other}"),
    };
    let help = match is_doubt {
        true => {
            "the real body is smaller than what is compared: the stock before its first cut, a mesh or a tube without its \
             hollows; look whether there is room"
        }
        false => {
            "move away before this block, or change the order of its moves; if the two may touch, name one in `may_touch` of \
             the other in `[solids]`"
        }
    };
    Diagnostic::new(problem.code, origin.span, measure)
        .label(format!("at {place} (machine coordinates)"))
        .help(help)
}

/// The diagnostic of two bodies that the budget did not decide.
pub(super) fn budget_diagnostic(problem: &CollisionProblem, origin: &Origin) -> Diagnostic {
    let [one, other] = &problem.bodies;
    let message = format!(
        "whether {one} touches {other} on this move is not decided: the check may look at no more positions"
    );
    Diagnostic::new(problem.code, origin.span, message)
        .help("allow more positions, or take a larger tolerance")
}

/// Positions of the axes: `X 10 mm, A 30 deg`.
fn axes_text(axes: &[Option<f64>; 6], units: Units) -> String {
    let texts = Axis::ALL.iter().zip(axes).filter_map(|(axis, value)| {
        let value = (*value)?;
        Some(match axis.is_rotary() {
            true => format!("{axis} {} deg", number_text(value.to_degrees(), 3)),
            false => format!("{axis} {}", units.length_text(value)),
        })
    });
    texts.collect::<Vec<String>>().join(", ")
}
