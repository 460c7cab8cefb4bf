//! The program's text.

use super::plan::ThreadMillPlan;
use super::{MillingDirection, ThreadMill, ThreadMillCutter};
use crate::numbers::{AnswerUnit, trimmed};
use chordal_dialect::{PostTemplate, table};

use crate::post::fill;
use crate::thread::{ThreadHand, ThreadLocation};

/// Feed away from the part, mm/s: 40 in/min, 1000 mm/min.
const fn approach(units: AnswerUnit) -> (f64, &'static str) {
    match units {
        AnswerUnit::Inch => (40.0, "40."),
        AnswerUnit::Millimetre => (1000.0, "1000."),
    }
}

/// `INSIDE THREAD 1.5-8, RIGHT HAND`.
pub(super) fn title(ask: &ThreadMill) -> String {
    let units = ask.units;
    let major = trimmed(ask.thread.major / units.mm(), 4);
    let name = match units {
        AnswerUnit::Inch => format!("{major}-{}", trimmed(25.4 / ask.thread.pitch, 3)),
        AnswerUnit::Millimetre => format!("M{major}x{}", trimmed(ask.thread.pitch, 4)),
    };
    let place = if ask.place == ThreadLocation::Inside { "inside" } else { "outside" };
    let hand = if ask.hand == ThreadHand::Right { "right" } else { "left" };
    format!("{place} thread {name}, {hand} hand")
}

/// Which way, and why.
pub(super) fn direction(ask: &ThreadMill, plan: &ThreadMillPlan) -> String {
    let code = if plan.sense > 0.0 { "G3" } else { "G2" };
    let path = if plan.rises(ask) { "up" } else { "down" };
    let cut = if ask.cut == MillingDirection::Climb { "climb" } else { "conventional" };
    let hand = if ask.hand == ThreadHand::Right { "right" } else { "left" };
    let place = if ask.place == ThreadLocation::Inside { "inside" } else { "outside" };
    format!("{hand} hand, {place}, {cut} cut with M3: {code}, Z {path}")
}

/// The hole below which the Haas manual (thread milling) has doubts, mm: 3/8 in.
const SMALL_HOLE_MM: f64 = 9.525;

/// What to know about a small hole.
pub(super) fn small_hole(ask: &ThreadMill) -> Option<&'static str> {
    let small =
        ask.place == ThreadLocation::Inside && ask.thread.minor_inside() < SMALL_HOLE_MM - 1e-9;
    small.then_some(match ask.units {
        AnswerUnit::Inch => "holes below 3/8 in may not be possible or practical to thread mill",
        AnswerUnit::Millimetre => {
            "holes below 9.525 mm may not be possible or practical to thread mill"
        }
    })
}

/// The whole program.
pub(super) fn write(ask: &ThreadMill, plan: &ThreadMillPlan) -> String {
    let post = table(ask.control).map_or(&PostTemplate::EMPTY, |table| table.post);
    let words = ProgramWords { ask, plan, post };
    let fillings = words.fillings();
    let mut lines: Vec<String> = post.open.iter().map(|line| fill(line, &fillings)).collect();
    lines.extend(words.remarks());
    lines.extend(post.begin.iter().map(|line| fill(line, &fillings)));
    lines.extend(words.path_blocks());
    lines.extend(post.end.iter().map(|line| fill(line, &fillings)));
    let mut text = lines.join("\n");
    text.push('\n');
    text
}

struct ProgramWords<'a> {
    ask: &'a ThreadMill,
    plan: &'a ThreadMillPlan,
    post: &'static PostTemplate,
}

impl ProgramWords<'_> {
    /// A coordinate of so many increments.
    fn word(&self, letter: char, increments: f64) -> String {
        let decimals = self.ask.units.word_decimals();
        let text = trimmed(increments / f64::from(10u32.pow(decimals as u32)), decimals);
        // A point always: `X1` is a ten-thousandth to some controls.
        if text.contains('.') { format!("{letter}{text}") } else { format!("{letter}{text}.") }
    }

    /// Height of rapids: above all that is cut, so that none goes down.
    fn clear(&self) -> f64 {
        let requested = (self.ask.clearance / self.plan.step).round();
        self.plan.heights.iter().copied().fold(requested, f64::max)
    }

    fn xy(&self, at: [f64; 2]) -> String {
        format!("{} {}", self.word('X', at[0]), self.word('Y', at[1]))
    }

    fn feed(&self, mm_per_s: f64) -> String {
        let (per_minute, decimals) = match self.ask.units {
            AnswerUnit::Inch => (mm_per_s * 60.0 / 25.4, 2),
            AnswerUnit::Millimetre => (mm_per_s * 60.0, 1),
        };
        // Never F0: what rounds to nothing is the least there is.
        let least = 10f64.powi(-(decimals as i32));
        let text = trimmed(per_minute.max(least), decimals);
        if text.contains('.') { format!("F{text}") } else { format!("F{text}.") }
    }

    fn fillings(&self) -> Vec<(&'static str, String)> {
        let ask = self.ask;
        let inch = ask.units == AnswerUnit::Inch;
        vec![
            ("number", format!("{:04}", ask.number)),
            ("title", title(ask).to_ascii_uppercase()),
            ("units", if inch { "G20" } else { "G21" }.to_string()),
            ("blend", if inch { "P0.0002" } else { "P0.005" }.to_string()),
            ("tool", ask.tool.to_string()),
            ("offset", format!("{:02}", ask.tool)),
            ("wear", ask.wear.map_or_else(String::new, |_| format!("D{} ", ask.tool))),
            ("start", self.xy(self.plan.start)),
            ("spindle", format!("S{}", trimmed(ask.spindle, 0))),
            ("clear", self.word('Z', self.clear())),
        ]
    }

    fn remarks(&self) -> Vec<String> {
        let (ask, plan) = (self.ask, self.plan);
        let number = |mm: f64| ask.units.number(mm);
        let (tool, cut) = (number(ask.tool_diameter), number(plan.cut_diameter));
        let sign = if ask.place == ThreadLocation::Inside { '-' } else { '+' };
        let low = plan.heights.iter().copied().fold(f64::INFINITY, f64::min);
        let mut remarks = vec![
            format!(
                "for {}, chordal check --machine {}",
                ask.control,
                table(ask.control).map_or(ask.control.as_str(), |table| table.default_machine)
            ),
            direction(ask, plan),
            "X0 Y0 on the axis of the thread, Z0 on top of the part".to_string(),
            match ask.cutter {
                ThreadMillCutter::Hob => format!(
                    "thread hob dia {tool}, pitch {}, teeth over at least {}: one turn",
                    number(ask.thread.pitch),
                    number(ask.depth)
                ),
                ThreadMillCutter::Single => {
                    format!("single point dia {tool}: {} turns", plan.turns)
                }
            },
            format!("tool centre on radius {cut}/2 {sign} {tool}/2 = {}", number(plan.radius_mm)),
            format!(
                "lead-in and lead-out arcs of {} with {} of the pitch, lowest {}",
                number(plan.to_mm(plan.lead_in)),
                plan.ramp.text(),
                self.word('Z', low)
            ),
            format!(
                "{} on diameter {cut} is {} of the tool centre",
                self.feed(ask.feed),
                self.feed(plan.feed)
            ),
        ];
        if ask.place == ThreadLocation::Inside {
            remarks.push(format!("hole before threading: {}", number(ask.thread.minor_inside())));
            remarks.extend(small_hole(ask).map(String::from));
        } else {
            remarks.push(format!("boss before threading: {}", number(ask.thread.major)));
        }
        if let Some(wear) = ask.wear {
            remarks.push(format!(
                "D{} is only the wear, at most {}: set it to 0 for a new tool",
                ask.tool,
                number(wear)
            ));
        }
        let [before, after] = self.post.remark;
        let remark = |text: &String| format!("{before}{}{after}", text.to_ascii_uppercase());
        remarks.iter().map(remark).collect()
    }

    fn path_blocks(&self) -> Vec<String> {
        let (ask, plan) = (self.ask, self.plan);
        let code = |number| self.post.code(number);
        let heights = &plan.heights;
        let (entry, last) = (heights[0], heights[heights.len() - 1]);
        let (line, turn) = (code(1), code(if plan.sense > 0.0 { 3 } else { 2 }));
        let lead = code(if plan.lead_sense > 0.0 { 3 } else { 2 });
        let feed = self.feed(plan.feed);
        let approach = format!("F{}", approach(ask.units).1);
        let moves_straight = plan.arc_in != plan.start;

        let mut lines = vec![format!("{line} {} {approach}", self.word('Z', entry))];
        if moves_straight {
            let (on, d) = match ask.wear {
                Some(_) => {
                    let side = if ask.cut == MillingDirection::Climb { 41 } else { 42 };
                    (format!("G{side} "), self.offset_word())
                }
                None => (String::new(), String::new()),
            };
            lines.push(format!("{on}{line} {}{d} {feed}", self.xy(plan.arc_in)));
        }
        let [x, y] = plan.arc_in;
        lines.push(format!(
            "{lead} {} {} {} {} {feed} (IN)",
            self.xy([plan.radius, 0.0]),
            self.word('I', plan.lead_center - x),
            self.word('J', -y),
            self.word('Z', heights[1]),
        ));
        for (index, height) in heights[2..heights.len() - 1].iter().enumerate() {
            lines.push(format!(
                "{turn} {} {} (TURN {})",
                self.word('I', -plan.radius),
                self.word('Z', *height),
                index + 1
            ));
        }
        lines.push(format!(
            "{lead} {} {} {} {} (OUT)",
            self.xy(plan.arc_out),
            self.word('I', plan.lead_center - plan.radius),
            self.word('J', 0.0),
            self.word('Z', last),
        ));
        if moves_straight {
            let off = if ask.wear.is_some() { "G40 " } else { "" };
            // Straight out, not across to where the way in began.
            let end = if ask.place == ThreadLocation::Inside {
                plan.start
            } else {
                [plan.start[0], plan.arc_out[1]]
            };
            lines.push(format!("{off}{line} {} {approach}", self.xy(end)));
        }
        lines
    }

    /// D on the line of G41, where it is not given with H before.
    fn offset_word(&self) -> String {
        let before = self.post.begin.iter().any(|line| line.contains("{wear}"));
        if before { String::new() } else { format!(" D{}", self.ask.tool) }
    }
}
