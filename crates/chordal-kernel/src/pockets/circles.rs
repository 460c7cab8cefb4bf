//! Circular pockets: full circles from the inside out, joined by half circles.

use chordal_command::{AxisMask, Move};
use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_geometry::tolerance::COINCIDENT_MM;
use chordal_geometry::{TurnDirection, Vec2};

use super::shapes::{Step, rings};
use crate::kernel::Kernel;
use crate::statement::{Statement, WordMeaning};

/// The words of a circular pocket about the present position.
#[derive(Clone, Debug)]
pub struct CirclesWords<'w> {
    /// The word that mills it.
    pub word: Span,
    /// Its name, for people.
    pub name: &'w str,
    /// Clockwise or counterclockwise.
    pub direction: TurnDirection,
    /// The radius of the tool, mm.
    pub tool: f64,
    /// The radii of the walls that the circles cut, mm, increasing.
    pub radii: &'w [f64],
    /// Z of the first pass, mm; `None` to stay at the present height.
    pub level: Option<f64>,
    /// Number of passes; in G91 each goes down by the same amount as the first.
    pub passes: u32,
}

impl Kernel<'_> {
    /// Mills a circular pocket.
    pub fn mill_circles(&mut self, at: &dyn Statement, pocket: &CirclesWords<'_>) {
        let centers: Vec<f64> = pocket.radii.iter().map(|radius| radius - pocket.tool).collect();
        let path = rings(&centers, 1, pocket.direction);
        let center = Vec2::new(self.state.position[0], self.state.position[1]);
        let placed: Vec<Step> = path.iter().map(|step| step.shifted(center)).collect();
        let choice = "half circles between full circles are shown, tangent and in one direction";
        let label = format!("circles: {}", pocket.radii.len());
        self.note_assumed_path(pocket.word, pocket.name, choice, label);
        let down = pocket.level.map_or(0.0, |level| level - self.state.position[2]);
        for pass in 0..pocket.passes {
            if pass > 0 && !self.count_repeated() {
                return;
            }
            let mut target = self.state.position;
            let named = if pocket.level.is_some() { AxisMask(0b100) } else { AxisMask::NONE };
            match pocket.level {
                Some(level) if pass == 0 => target[2] = level,
                Some(_) if self.state.incremental => target[2] += down,
                _ => {}
            }
            let motion = Move {
                from: self.state.position,
                to: target,
                from_known: self.state.known,
                to_known: self.state.known,
            };
            let feed = self.feed_for(at, &motion, None);
            if target != self.state.position {
                self.routine_line(target, named, feed);
            }
            self.follow(&placed, feed, AxisMask::NONE);
        }
    }

    /// Cuts one full circle about the present position: out along X by the radius, round, and back.
    pub fn mill_circle(&mut self, at: &dyn Statement, radius: f64, direction: TurnDirection) {
        let center = Vec2::new(self.state.position[0], self.state.position[1]);
        let out = Vec2::new(center.a + radius, center.b);
        let steps = [
            Step::Line { to: out },
            Step::Arc { to: out, center, sweep: direction.sign() * core::f64::consts::TAU },
            Step::Line { to: center },
        ];
        let motion = Move {
            from: self.state.position,
            to: self.state.position,
            from_known: self.state.known,
            to_known: self.state.known,
        };
        let feed = self.feed_for(at, &motion, None);
        self.follow(&steps, feed, AxisMask::NONE);
    }

    /// Warns of rings that lie further apart than the tool diameter, or that leave a core in the middle.
    pub fn note_ridges(&mut self, at: &dyn Statement, radii: &[f64], tool: f64) {
        // A single circle finishes an existing bore; with D0 the tool radius is not known.
        let &[first, second, ..] = radii else { return };
        if tool == 0.0 {
            return;
        }
        let wide = 2.0 * tool + COINCIDENT_MM;
        let core = first - 2.0 * tool;
        let (word, what, width) = if second - first > wide {
            (WordMeaning::Increment, "between the circles", second - first - 2.0 * tool)
        } else if core > tool + COINCIDENT_MM {
            (WordMeaning::FirstCircle, "about the middle", core - tool)
        } else {
            return;
        };
        let (width, tool) = (self.length_text(width), self.length_text(2.0 * tool));
        let span = at.words(word);
        self.report(
            Diagnostic::new(
                Code::PocketRidges,
                span,
                format!("a ring {width} wide stays {what}: the tool is {tool}"),
            )
            .label("more than the diameter of the tool")
            .help("use a smaller step, or a larger tool"),
        );
    }
}
