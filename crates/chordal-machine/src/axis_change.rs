//! Adds or removes an axis of a machine, and adapts the positions that the file gives along it.

use crate::axis::Axis;
use crate::machine::{AxisLimits, Machine};
use crate::schema::{SchemaSlot, tables, written_tables};

impl Machine {
    /// Adds, changes or removes an axis. The numbers in the file keep their values, so if diameter programming changes,
    /// the positions change.
    pub(crate) fn change_axis(&mut self, axis: Axis, limits: Option<AxisLimits>) {
        let index = axis as usize;
        let before = self.written_factor(index);
        self.axes[index] = limits;
        let by = before / self.written_factor(index);
        if by != 1.0 {
            self.scale_places(axis, by);
        }
    }

    /// Multiplies every position of an axis that the file gives.
    fn scale_places(&mut self, axis: Axis, by: f64) {
        let keys =
            tables().flat_map(|table| written_tables(self, table)).flat_map(|(_, keys)| keys);
        let along: Vec<_> = keys.filter(|(_, _, keys)| keys.axis == Some(axis)).collect();
        for (_, row, keys) in along {
            match row.slot {
                SchemaSlot::Position(place) => {
                    let value = place(self, &keys);
                    *value = value.map(|value| value * by);
                }
                SchemaSlot::Range(place) => {
                    let range = place(self, &keys);
                    *range = range.map(|(low, high)| (low * by, high * by));
                }
                _ => {}
            }
        }
    }
}
