//! A machine as the file that would give it, with nothing left to inherit.

use std::fmt::Write;

use crate::axis::{Axis, PerAxis};
use crate::check::{key_text, string_text};
use crate::designation::InsertLetter;
use crate::machine::{DiameterProgramming, Machine, ProbeHit, RotaryAxis, Turret};
use crate::quantity::QuantityDimension;
use crate::setup::{Body, BodyShape, MeshUnit};
use crate::tool::Tool;
use crate::turning::{ToolFacing, TurningTool};
use crate::value::SettingValue;

impl Machine {
    /// The machine file that gives this machine, every inherited key in it, in millimetres,
    /// seconds and radians: reading it back gives the same bits.
    pub fn to_toml(&self) -> String {
        let mut out = TomlWriter(String::new());
        let factors = self.written_factors();
        out.line("name", &string_text(&self.name));
        out.line("title", &string_text(&self.title));
        if !self.notes.is_empty() {
            let notes: Vec<String> = self.notes.iter().map(|note| string_text(note)).collect();
            out.line("notes", &format!("[{}]", notes.join(", ")));
        }
        out.line("control", &string_text(self.control.as_str()));
        if self.turret != Turret::default() {
            out.line("turret", &string_text(self.turret.as_str()));
        }
        out.quantity("turret_clearance", self.turret_clearance_mm, QuantityDimension::Length);
        self.write_axes(&mut out);
        if self.feed != Default::default() {
            out.table("feed");
            out.quantity("max", self.feed.max_mm_per_s, QuantityDimension::Velocity);
            out.quantity("max_rotary", self.feed.max_rad_per_s, QuantityDimension::AngularVelocity);
        }
        if let Some(shape) = self.rapid {
            out.table("rapid");
            out.line("shape", &string_text(shape.as_str()));
        }
        let speeds = [self.spindle_max_rpm, self.live_tool_max_rpm, self.spindle_power_kw];
        if speeds.iter().any(Option::is_some) {
            out.table("spindle");
            out.quantity("max", self.spindle_max_rpm, QuantityDimension::SpindleSpeed);
            out.quantity("live_max", self.live_tool_max_rpm, QuantityDimension::SpindleSpeed);
            out.quantity("power", self.spindle_power_kw, QuantityDimension::Power);
        }
        out.positions("home", &self.home, &factors);
        for (at, point) in self.reference_points.iter().enumerate() {
            out.positions(&format!("reference_points.{}", at + 2), point, &factors);
        }
        self.write_switches(&mut out);
        if self.clearance_mm.is_some() {
            out.table("program");
            out.quantity("clearance", self.clearance_mm, QuantityDimension::Length);
        }
        self.write_motion(&mut out);
        self.write_times(&mut out);
        let codes = self.shop_codes.iter().map(|(number, code)| (format!("M{number}"), code));
        let programs = self.shop_programs.iter().map(|(number, code)| (format!("O{number}"), code));
        for (name, code) in codes.chain(programs) {
            out.table(&format!("shop_codes.{name}"));
            out.quantity("time", code.time_s, QuantityDimension::Time);
            for (key, text) in [("label", &code.label), ("blocks", &code.blocks)] {
                if let Some(text) = text {
                    out.line(key, &string_text(text));
                }
            }
        }
        self.write_macros(&mut out);
        match self.probe.hit {
            Some(hit) => {
                out.table("probe");
                let word = if hit == ProbeHit::End { "end" } else { "none" };
                out.line("hit", &string_text(word));
            }
            None => out.positions("probe.hit", &self.probe.planes, &factors),
        }
        self.write_tools(&mut out, &factors);
        for (name, body) in self.setup.bodies() {
            write_body(&mut out, &name, body);
        }
        for (name, material) in &self.setup.materials {
            out.table(&format!("materials.{}", key_text(name)));
            out.quantity("k_c1", material.k_c1_n_per_mm2, QuantityDimension::Stress);
            if let Some(exponent) = material.m_c {
                out.line("m_c", &exponent.to_string());
            }
            if let Some(source) = &material.source {
                out.line("source", &string_text(source));
            }
        }
        for (name, offset) in &self.work_offsets {
            out.table(&format!("work_offsets.{}", key_text(name)));
            out.values(&offset.values, &factors);
        }
        if !self.settings.is_empty() {
            out.table("settings");
            for (name, setting) in &self.settings {
                let value = match &setting.value {
                    SettingValue::Text(text) => string_text(text),
                    SettingValue::Integer(number) => number.to_string(),
                    // `1.0`, not `1`, so that it stays a number with a fraction.
                    SettingValue::Float(number) => format!("{number:?}"),
                    SettingValue::Bool(flag) => flag.to_string(),
                };
                out.line(&key_text(name), &value);
            }
        }
        out.0
    }

    fn write_axes(&self, out: &mut TomlWriter) {
        for axis in Axis::ALL {
            let Some(limits) = self.axis(axis) else { continue };
            out.table(&format!("axes.{axis}"));
            let of = |dimension: QuantityDimension| match axis.is_rotary() {
                true => dimension.of_rotary(),
                false => dimension,
            };
            if limits.programmed != DiameterProgramming::default() {
                out.line("programmed", &string_text(limits.programmed.as_str()));
            }
            if let Some((low, high)) = limits.travel {
                let factor = limits.programmed.factor();
                let (low, high) = (low * factor, high * factor);
                let unit = of(QuantityDimension::Length).inside();
                out.line("travel", &format!("[\"{low} {unit}\", \"{high} {unit}\"]"));
            }
            out.quantity("max_velocity", limits.max_velocity, of(QuantityDimension::Velocity));
            out.quantity(
                "max_acceleration",
                limits.max_acceleration,
                of(QuantityDimension::Acceleration),
            );
            out.quantity("max_jerk", limits.max_jerk, of(QuantityDimension::Jerk));
            let acceleration = of(QuantityDimension::Acceleration);
            out.quantity("rapid_acceleration", limits.rapid_acceleration, acceleration);
            out.quantity("rapid_jerk", limits.rapid_jerk, of(QuantityDimension::Jerk));
        }
        for (letter, rotary) in ["A", "B", "C"].into_iter().zip(&self.rotary) {
            if *rotary == RotaryAxis::default() {
                continue;
            }
            out.table(&format!("rotary.{letter}"));
            if let Some(turns) = rotary.turns {
                out.line("turns", &string_text(turns.as_str()));
            }
            if rotary.reversed {
                out.line("reversed", "true");
            }
            for (axis, mm) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(rotary.center_mm) {
                let mm = mm.map(|mm| mm * self.written_factor(axis as usize));
                out.quantity(&format!("center.{axis}"), mm, QuantityDimension::Length);
            }
        }
    }

    fn write_motion(&self, out: &mut TomlWriter) {
        let motion = &self.motion;
        if *motion == Default::default() {
            return;
        }
        out.table("motion");
        out.quantity("servo_period", motion.servo_period_s, QuantityDimension::Time);
        out.fraction("feed_override", motion.feed_override);
        out.fraction("rapid_override", motion.rapid_override);
        out.quantity("corner_tolerance", motion.corner_tolerance_mm, QuantityDimension::Length);
        out.quantity(
            "exact_path_tolerance",
            motion.exact_path_tolerance_mm,
            QuantityDimension::Length,
        );
        let rapid = motion.rapid_corner_tolerance_mm;
        out.quantity("rapid_corner_tolerance", rapid, QuantityDimension::Length);
        out.quantity("rotary_tolerance", motion.rotary_tolerance_rad, QuantityDimension::Angle);
    }

    fn write_times(&self, out: &mut TomlWriter) {
        let times = &self.times;
        if *times == Default::default() {
            return;
        }
        out.table("times");
        out.quantity("tool_change", times.tool_change_s, QuantityDimension::Time);
        out.quantity("spindle_per_1000_rpm", times.spindle_per_1000_rpm_s, QuantityDimension::Time);
        out.quantity("spindle_orient", times.spindle_orient_s, QuantityDimension::Time);
        out.quantity("probe", times.probe_s, QuantityDimension::Time);
        out.quantity("m_code", times.m_code_s, QuantityDimension::Time);
    }

    fn write_switches(&self, out: &mut TomlWriter) {
        let switches = &self.switches;
        if *switches == Default::default() {
            return;
        }
        out.table("switches");
        let on: Vec<String> =
            (1..10).filter(|at| switches.block_delete[*at]).map(|at| at.to_string()).collect();
        match on.len() {
            0 => {}
            9 => out.line("block_delete", "true"),
            _ => out.line("block_delete", &format!("[{}]", on.join(", "))),
        }
        if switches.optional_stop {
            out.line("optional_stop", "true");
        }
    }

    fn write_macros(&self, out: &mut TomlWriter) {
        let macros = &self.macros;
        if *macros == Default::default() {
            return;
        }
        out.table("macros");
        if let Some(date) = macros.date {
            let (year, month, day) = (date / 10_000, date / 100 % 100, date % 100);
            out.line("date", &format!("\"{year:04}-{month:02}-{day:02}\""));
        }
        if let Some(time) = macros.time {
            let (hour, minute, second) = (time / 10_000, time / 100 % 100, time % 100);
            out.line("time", &format!("\"{hour:02}:{minute:02}:{second:02}\""));
        }
        if !macros.inputs.is_empty() {
            let inputs: Vec<String> = macros.inputs.iter().map(|n| format!("{n:?}")).collect();
            out.line("inputs", &format!("[{}]", inputs.join(", ")));
        }
        if !macros.variables.is_empty() || !macros.named_variables.is_empty() {
            out.table("macros.variables");
            for (number, value) in &macros.variables {
                out.line(&number.to_string(), &format!("{value:?}"));
            }
            for (name, value) in &macros.named_variables {
                out.line(&format!("\"<{name}>\""), &format!("{value:?}"));
            }
        }
    }

    fn write_tools(&self, out: &mut TomlWriter, factors: &PerAxis<f64>) {
        for (number, tool) in &self.tools {
            out.table(&format!("tools.{number}"));
            write_tool(out, tool, factors);
        }
    }
}

/// A body of the setup under its name.
fn write_body(out: &mut TomlWriter, name: &str, body: &Body) {
    let keys: Vec<String> = name.splitn(2, '.').map(key_text).collect();
    out.table(&keys.join("."));
    let words = [
        ("shape", body.shape.map(BodyShape::as_str)),
        ("work_offset", body.work_offset.as_deref()),
        ("file", body.file.as_deref()),
        ("unit", body.unit.map(MeshUnit::as_str)),
        ("material", body.material.as_deref()),
    ];
    for (key, word) in words {
        if let Some(word) = word {
            out.line(key, &string_text(word));
        }
    }
    for (key, axis) in [("axis", body.axis), ("turned_over", body.turned_over)] {
        if let Some(axis) = axis {
            out.line(key, &string_text(&axis.to_string()));
        }
    }
    for (end, values) in [("from", &body.from), ("to", &body.to)] {
        for (axis, value) in [Axis::X, Axis::Y, Axis::Z].into_iter().zip(values) {
            out.quantity(&format!("{end}.{axis}"), *value, QuantityDimension::Length);
        }
    }
    out.lengths(
        "contour",
        body.contour.iter().map(|point| {
            let corner = [2.0 * point.radius_mm, point.z_mm];
            corner.into_iter().chain(point.arc_mm).collect()
        }),
    );
    out.quantity("diameter", body.diameter_mm, QuantityDimension::Length);
    out.quantity("bore", body.bore_mm, QuantityDimension::Length);
    out.quantity("clearance", body.clearance_mm, QuantityDimension::Length);
    out.quantity("tolerance", body.tolerance_mm, QuantityDimension::Length);
}

/// The keys of a tool.
fn write_tool(out: &mut TomlWriter, tool: &Tool, factors: &PerAxis<f64>) {
    out.quantity("diameter", tool.diameter_mm, QuantityDimension::Length);
    out.quantity("diameter_wear", tool.diameter_wear_mm, QuantityDimension::Length);
    // A mill has its length and no more: the key that people know.
    for (key, length, values) in
        [("offset", "length", &tool.offset), ("offset_wear", "length_wear", &tool.offset_wear)]
    {
        for axis in Axis::ALL {
            let written = written(values, axis, factors);
            let name = match axis {
                Axis::Z => length.to_string(),
                _ => format!("{key}.{axis}"),
            };
            out.quantity(&name, written, dimension_of(axis));
        }
    }
    if let Some(shape) = tool.shape {
        out.line("shape", &string_text(shape.as_str()));
    }
    out.quantity("corner_radius", tool.corner_radius_mm, QuantityDimension::Length);
    out.quantity("point_angle", tool.point_angle_rad, QuantityDimension::Angle);
    out.quantity("tip_diameter", tool.tip_diameter_mm, QuantityDimension::Length);
    out.quantity("pitch", tool.pitch_mm, QuantityDimension::Length);
    out.quantity("nose_radius", tool.nose_radius_mm, QuantityDimension::Length);
    for (key, count) in [("teeth", tool.teeth), ("tip", tool.tip)] {
        if let Some(count) = count {
            out.line(key, &count.to_string());
        }
    }
    out.quantity("max_chip", tool.max_chip_mm, QuantityDimension::Length);
    out.quantity("min_chip", tool.min_chip_mm, QuantityDimension::Length);
    out.lengths("profile", tool.profile.iter().map(|point| point.to_vec()));
    out.quantity("flute_length", tool.flute_length_mm, QuantityDimension::Length);
    out.quantity("shank_diameter", tool.shank_diameter_mm, QuantityDimension::Length);
    for (key, solids) in [("shank", &tool.shank), ("holder", &tool.holder)] {
        out.lengths(key, solids.iter().map(|s| vec![s.height_mm, s.lower_mm, s.upper_mm]));
    }
    write_turning(out, &tool.turning);
    for (key, text) in [("description", &tool.description), ("comment", &tool.comment)] {
        if let Some(text) = text {
            out.line(key, &string_text(text));
        }
    }
}

/// The keys of a turning tool.
fn write_turning(out: &mut TomlWriter, tool: &TurningTool) {
    let insert = tool.insert_designation.as_ref().map(|written| written.text.as_str());
    let words = [
        ("insert", insert.or(tool.insert.map(InsertLetter::as_str))),
        ("holder_designation", tool.holder_designation.as_ref().map(|one| one.text.as_str())),
        ("facing", tool.facing.map(ToolFacing::as_str)),
    ];
    for (key, word) in words {
        if let Some(word) = word {
            out.line(key, &string_text(word));
        }
    }
    out.quantity("insert_angle", tool.insert_angle_rad, QuantityDimension::Angle);
    out.quantity("approach_angle", tool.approach_angle_rad, QuantityDimension::Angle);
    out.quantity("width", tool.width_mm, QuantityDimension::Length);
    out.quantity("lead_angle", tool.lead_angle_rad, QuantityDimension::Angle);
    out.quantity("bar_offset", tool.bar_offset_mm, QuantityDimension::Length);
    out.lengths("holder_outline", tool.holder_outline.iter().map(|corner| corner.to_vec()));
}

/// A place as the file has it: a diameter on an axis that is programmed in diameters.
fn written(values: &PerAxis<Option<f64>>, axis: Axis, factors: &PerAxis<f64>) -> Option<f64> {
    Some(values[axis as usize]? * factors[axis as usize])
}

const fn dimension_of(axis: Axis) -> QuantityDimension {
    if axis.is_rotary() { QuantityDimension::Angle } else { QuantityDimension::Length }
}

struct TomlWriter(String);

impl TomlWriter {
    fn table(&mut self, name: &str) {
        self.push(format_args!("\n[{name}]\n"));
    }

    fn line(&mut self, key: &str, value: &str) {
        self.push(format_args!("{key} = {value}\n"));
    }

    fn quantity(&mut self, key: &str, value: Option<f64>, dimension: QuantityDimension) {
        if let Some(value) = value {
            self.line(key, &format!("\"{value} {}\"", dimension.inside()));
        }
    }

    fn fraction(&mut self, key: &str, value: Option<f64>) {
        if let Some(value) = value {
            self.line(key, &format!("{value:?}"));
        }
    }

    /// A table of positions, if there are any.
    fn positions(&mut self, name: &str, values: &PerAxis<Option<f64>>, factors: &PerAxis<f64>) {
        if values.iter().any(Option::is_some) {
            self.table(name);
            self.values(values, factors);
        }
    }

    fn values(&mut self, values: &PerAxis<Option<f64>>, factors: &PerAxis<f64>) {
        for axis in Axis::ALL {
            let written = written(values, axis, factors);
            self.quantity(&axis.to_string(), written, dimension_of(axis));
        }
    }

    /// Lists of lengths, if there are any.
    fn lengths(&mut self, key: &str, rows: impl Iterator<Item = Vec<f64>>) {
        let rows: Vec<String> = rows
            .map(|row| {
                let row: Vec<String> = row.iter().map(|mm| format!("\"{mm} mm\"")).collect();
                format!("[{}]", row.join(", "))
            })
            .collect();
        if !rows.is_empty() {
            self.line(key, &format!("[{}]", rows.join(", ")));
        }
    }

    fn push(&mut self, text: std::fmt::Arguments<'_>) {
        // Writing into a string does not fail.
        let _ = self.0.write_fmt(text);
    }
}
