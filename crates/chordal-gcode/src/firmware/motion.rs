//! The motion of a block: what it asks of the words, and where it ends.

use chordal_dialect::firmware::FirmwareError;
use chordal_dialect::table::ArcTurns;
use chordal_syntax::Letters;

use super::block_check::{BlockCheck, MM_PER_INCH};
use super::codes::AxisUse;
use super::line::LineFault;
use super::memory::{FirmwareMemory, FirmwareMotion, HoleMemory};

impl BlockCheck<'_> {
    /// The motion in force, and the position after it.
    pub fn motion(
        &mut self,
        after: &mut FirmwareMemory,
        target: [f32; 3],
        feed: f32,
    ) -> Result<(), LineFault> {
        let motion = self.modes.motion;
        if motion != FirmwareMotion::Cycle {
            after.hole = None;
        }
        if motion == FirmwareMotion::None {
            let passes =
                self.firmware.block.cancel_with_one_shot && self.axis_use != Some(AxisUse::Motion);
            return if self.has_axes() && !passes {
                self.refuse(FirmwareError::AxesWithoutMotion, "XYZ")
            } else {
                Ok(())
            };
        }
        if self.axis_use != Some(AxisUse::Motion) {
            return Ok(());
        }
        if motion != FirmwareMotion::Rapid && feed == 0.0 {
            return self.refuse(FirmwareError::NoFeed, "GXYZ");
        }
        match motion {
            FirmwareMotion::None => {}
            FirmwareMotion::Rapid | FirmwareMotion::Linear => {
                if !self.has_axes() {
                    self.axis_use = None;
                    return Ok(());
                }
            }
            FirmwareMotion::Arc => self.arc(after.position, target)?,
            FirmwareMotion::Spline(_) => self.spline()?,
            FirmwareMotion::Cycle => {
                after.position = self.cycle(after, target)?;
                return Ok(());
            }
            FirmwareMotion::Probe(_) => {
                if !self.has_axes() {
                    return self.refuse(FirmwareError::NoAxes, "G");
                }
                if target == after.position {
                    return self.refuse(FirmwareError::SamePlace, "XYZ");
                }
            }
        }
        after.position = target;
        Ok(())
    }

    /// A spline by one block: the control points of a first one, and the end.
    fn spline(&mut self) -> Result<(), LineFault> {
        if self.modes.plane != 0 {
            return self.refuse(FirmwareError::SplinePlane, "G");
        }
        if !self.has_axes() {
            return self.refuse(FirmwareError::NoAxes, "G");
        }
        if self.written.has(b'Z') {
            return self.refuse(FirmwareError::AxisConflict, "Z");
        }
        let row = self.codes.iter().find_map(|(_, row)| row.action.motion().map(|_| *row));
        let is_cubic = match row {
            Some(row) => row.words.has(b'P'),
            None => self.control.g_code(self.spline_code()).is_some_and(|row| row.words.has(b'P')),
        };
        let goes_on = is_cubic && self.before.modes.motion == self.modes.motion;
        let needed = match (is_cubic, goes_on) {
            (false, _) => "IJ",
            (true, false) => "IJPQ",
            (true, true) => "PQ",
        };
        if !Letters::of(needed).within(self.written) {
            return self.refuse(FirmwareError::NoValue, "G");
        }
        self.use_up(Letters::of(if is_cubic { "IJPQ" } else { "IJ" }));
        Ok(())
    }

    fn spline_code(&self) -> u16 {
        if let FirmwareMotion::Spline(code) = self.modes.motion { code } else { 0 }
    }

    /// A canned cycle: the words that it needs, and where the tool is after it.
    fn cycle(
        &mut self,
        after: &mut FirmwareMemory,
        target: [f32; 3],
    ) -> Result<[f32; 3], LineFault> {
        let [a, b] = self.modes.plane_axes();
        let axis = 3 - a - b;
        let from = after.position;
        let unit = if self.modes.inch { MM_PER_INCH } else { 1.0 };
        // Levels are kept as the program counts them.
        let base = after.machine(axis, 0.0);
        let kept = after.hole.map(|hole| hole.moved(base));
        let initial = kept.map_or(from[axis], |hole| hole.initial);
        let depth = self.axis(axis);
        if kept.is_none() && !(self.written.has(b'R') && depth.is_some()) {
            let measured = format!("R and {}", char::from(b"XYZ"[axis]));
            return self.refuse_measured(FirmwareError::NoValue, "G", measured);
        }
        let count = self.number(b'L').unwrap_or(1.0).trunc();
        if count < 1.0 {
            return self.refuse(FirmwareError::NotPositive, "L");
        }
        let incremental = self.modes.incremental;
        let r = match self.number(b'R').map(|r| r * unit) {
            Some(r) if incremental => initial + r,
            Some(r) => after.machine(axis, r),
            None => kept.map_or(initial, |hole| hole.r),
        };
        let z = match depth {
            Some(depth) if incremental => r + depth,
            Some(_) => target[axis],
            None => kept.map_or(r, |hole| hole.z),
        };
        let letters = kept.map_or(Letters::NONE, |hole| hole.letters).union(self.written);
        self.cycle_words(letters)?;
        if r < z {
            return self.refuse_measured(
                FirmwareError::LevelOrder,
                "RZ",
                format!("R is {} mm below it", z - r),
            );
        }
        self.use_up(Letters::of("RQPL"));
        after.hole = Some(HoleMemory { initial, r, z, letters }.moved(-base));
        let mut end = target;
        if incremental {
            for axis in [a, b] {
                end[axis] = from[axis] + count * (target[axis] - from[axis]);
            }
        }
        end[axis] = if self.modes.return_to_r { r } else { initial.max(r) };
        Ok(end)
    }

    /// The words that the cycle of this block needs beyond R and its depth.
    fn cycle_words(&self, had: Letters) -> Result<(), LineFault> {
        let Some(kind) = self.codes.iter().find_map(|(_, row)| row.action.cycle()) else {
            return Ok(());
        };
        let needed = match (kind.is_peck(), kind.dwells()) {
            (true, _) => "Q",
            (false, true) => "P",
            (false, false) => "",
        };
        if needed == "Q" && self.number(b'Q').is_some_and(|q| q <= 0.0) {
            return self.refuse(FirmwareError::NotPositive, "Q");
        }
        match Letters::of(needed).within(had) {
            true => Ok(()),
            false => self.refuse_measured(FirmwareError::NoValue, "G", needed.to_string()),
        }
    }

    fn arc(&mut self, from: [f32; 3], to: [f32; 3]) -> Result<(), LineFault> {
        if self.control.table.arc_turns != ArcTurns::None {
            self.use_up(Letters::of("P"));
        }
        let is_bare = self.firmware.block.bare_circles
            && !self.written.has(b'R')
            && self.written.meets(Letters::of("IJK"));
        if !self.has_axes() && !is_bare {
            return self.refuse(FirmwareError::NoAxes, "G");
        }
        let [a, b] = self.modes.plane_axes();
        let letters = |of: &[u8; 3]| {
            let mut letters = Letters::NONE;
            [a, b].into_iter().for_each(|axis| letters.insert(of[axis]));
            letters
        };
        if !self.written.meets(letters(b"XYZ")) && !is_bare {
            return self.refuse(FirmwareError::NoPlaneAxes, "XYZ");
        }
        let unit = if self.modes.inch { MM_PER_INCH } else { 1.0 };
        let (x, y) = (to[a] - from[a], to[b] - from[b]);
        if let Some(radius) = self.number(b'R') {
            self.use_up(Letters::of("R"));
            if from == to {
                return self.refuse(FirmwareError::SamePlace, "R");
            }
            let radius = radius * unit;
            if 4.0 * radius * radius - x * x - y * y < 0.0 {
                let half = 0.5 * (x * x + y * y).sqrt();
                let measured = format!("R is {radius} mm, and half the distance {half} mm");
                return self.refuse_measured(FirmwareError::Radius, "R", measured);
            }
            return Ok(());
        }
        if !self.written.meets(letters(b"IJK")) {
            return self.refuse(FirmwareError::NoCenter, "IJKG");
        }
        self.use_up(Letters::of("IJK"));
        let center = |axis: usize| self.number(b"IJK"[axis]).unwrap_or(0.0) * unit;
        let size = |x: f32, y: f32| (x * x + y * y).sqrt();
        let radius = size(center(a), center(b));
        let at_end = size(x - center(a), y - center(b));
        let off = (at_end - radius).abs();
        let [always, most, share] = self.firmware.arc;
        if off > always && (off > most || off > share * radius) {
            let allowed = always.max(most.min(share * radius));
            let measured = format!(
                "the radius is {radius} mm at the start and {at_end} mm at the end: {off} mm apart, and {allowed} \
                 mm are allowed"
            );
            return self.refuse_measured(FirmwareError::OffCircle, "IJK", measured);
        }
        Ok(())
    }
}
