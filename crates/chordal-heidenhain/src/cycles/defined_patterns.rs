//! The points of PATTERN DEF: rows, grids, frames, circles and arcs (TNC 640 cycle programming 34059x, 2.3).

use chordal_kernel::frames::sin_cos_degrees;

use super::step::KlartextCycleFault;

/// More points than this are a mistake in the data.
const MAX_POINTS: f64 = 100_000.0;

/// The data of a pattern besides its first point or centre; lengths in mm, angles in degrees.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DefinedPattern {
    /// The words and their values.
    pub words: Vec<(String, f64)>,
}

impl DefinedPattern {
    fn value(&self, name: &str) -> f64 {
        self.words.iter().find(|(own, _)| own == name).map_or(0.0, |(_, value)| *value)
    }

    fn has(&self, name: &str) -> bool {
        self.words.iter().any(|(own, _)| own == name)
    }

    fn count(&self, name: &str) -> Result<u32, KlartextCycleFault> {
        let value = self.value(name).round();
        if (1.0..=MAX_POINTS).contains(&value) {
            return Ok(value as u32);
        }
        let message = format!("{name} is {value}: it is the number of points");
        Err(KlartextCycleFault::BadValue(message))
    }

    /// The points from the first one or the centre, in the order in which they are visited; `None` for a pattern that
    /// is not known.
    ///
    /// # Errors
    /// A number of points that is not possible.
    pub fn points(&self, kind: &str) -> Result<Option<Vec<[f64; 2]>>, KlartextCycleFault> {
        let points = match kind {
            "ROW" => self.row()?,
            "PAT" => self.grid(false)?,
            "FRAME" => self.grid(true)?,
            "CIRC" => self.circle()?,
            "PITCHCIRC" => self.arc()?,
            _ => return Ok(None),
        };
        Ok(Some(points))
    }

    fn row(&self) -> Result<Vec<[f64; 2]>, KlartextCycleFault> {
        let (sin, cos) = sin_cos_degrees(self.value("ROT"));
        let spacing = self.value("D");
        let point = |index: u32| [cos, sin].map(|part| f64::from(index) * spacing * part);
        Ok((0..self.count("NUM")?).map(point).collect())
    }

    /// Lines along the first axis, to and fro; of a frame the points on its border.
    fn grid(&self, is_frame: bool) -> Result<Vec<[f64; 2]>, KlartextCycleFault> {
        let (columns, lines) = (self.count("NUMX")?, self.count("NUMY")?);
        if f64::from(columns) * f64::from(lines) > MAX_POINTS {
            let message = format!("{columns} columns of {lines} lines are too many points");
            return Err(KlartextCycleFault::BadValue(message));
        }
        // ROTX and ROTY turn one axis each, ROT turns all.
        let whole = self.value("ROT");
        let (sin_x, cos_x) = sin_cos_degrees(whole + self.value("ROTX"));
        let (sin_y, cos_y) = sin_cos_degrees(whole + self.value("ROTY"));
        let (dx, dy) = (self.value("DX"), self.value("DY"));
        let mut points = Vec::new();
        for line in 0..lines {
            for index in 0..columns {
                let column = if line % 2 == 0 { index } else { columns - 1 - index };
                let is_border =
                    [0, columns - 1].contains(&column) || [0, lines - 1].contains(&line);
                if is_frame && !is_border {
                    continue;
                }
                let (along, across) = (f64::from(column) * dx, f64::from(line) * dy);
                points.push([along * cos_x - across * sin_y, along * sin_x + across * cos_y]);
            }
        }
        Ok(points)
    }

    fn circle(&self) -> Result<Vec<[f64; 2]>, KlartextCycleFault> {
        let count = self.count("NUM")?;
        Ok(self.on_circle(count, 360.0 / f64::from(count)))
    }

    /// Points on an arc, by the angle between them or by that of the last one.
    fn arc(&self) -> Result<Vec<[f64; 2]>, KlartextCycleFault> {
        let count = self.count("NUM")?;
        let step = match self.has("STEP") {
            true => self.value("STEP"),
            false => {
                (self.value("END") - self.value("START"))
                    / f64::from(count.saturating_sub(1).max(1))
            }
        };
        Ok(self.on_circle(count, step))
    }

    fn on_circle(&self, count: u32, step_deg: f64) -> Vec<[f64; 2]> {
        let radius = self.value("D") / 2.0;
        let point = |index: u32| {
            let (sin, cos) = sin_cos_degrees(self.value("START") + step_deg * f64::from(index));
            [radius * cos, radius * sin]
        };
        (0..count).map(point).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(kind: &str, words: &[(&str, f64)]) -> Vec<[f64; 2]> {
        let words = words.iter().map(|(name, value)| (name.to_string(), *value)).collect();
        let found = DefinedPattern { words }.points(kind).expect("data").expect("a pattern");
        found.iter().map(|point| point.map(|value| (value * 1e4).round() / 1e4 + 0.0)).collect()
    }

    #[test]
    fn rows_and_grids() {
        let row = points("ROW", &[("D", 8.0), ("NUM", 3.0), ("ROT", 90.0)]);
        assert_eq!(row, [[0.0, 0.0], [0.0, 8.0], [0.0, 16.0]]);
        let size = [("DX", 8.0), ("DY", 10.0), ("NUMX", 3.0), ("NUMY", 3.0)];
        let grid = points("PAT", &size);
        assert_eq!(grid[2..5], [[16.0, 0.0], [16.0, 10.0], [8.0, 10.0]]);
        assert_eq!(points("FRAME", &size).len(), 8);
        assert!(!points("FRAME", &size).contains(&[8.0, 10.0]));
        let mut leaning = size.to_vec();
        leaning.push(("ROTY", 30.0));
        assert_eq!(points("PAT", &leaning)[5], [-5.0, 8.6603]);
    }

    #[test]
    fn circles_and_arcs() {
        let circle = points("CIRC", &[("D", 80.0), ("START", 45.0), ("NUM", 4.0)]);
        assert_eq!(circle[..2], [[28.2843, 28.2843], [-28.2843, 28.2843]]);
        let arc = [("D", 80.0), ("START", 0.0), ("STEP", 30.0), ("NUM", 4.0)];
        assert_eq!(points("PITCHCIRC", &arc)[3], [0.0, 40.0]);
        let none = DefinedPattern { words: vec![("NUM".to_string(), 0.0)] };
        assert!(none.points("CIRC").is_err());
        assert_eq!(none.points("WAVE"), Ok(None));
    }
}
