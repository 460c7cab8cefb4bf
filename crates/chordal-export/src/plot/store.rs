//! What is kept of a path until its extent, and so the scale, is known.

use chordal::control::WorkNaming;
use chordal::geometry::{Aabb, Curve, ParamCurve, Vec3};
use chordal::path::{NotNamed, UnrelatedZero};
use chordal::{Segment, SegmentKind};

use super::relief::StockRelief;
use crate::omissions::{left_out_texts, not_named_texts};

/// Pieces after which the path is thinned for the first time.
const FIRST_THINNING_PIECES: usize = 1 << 21;
/// Thinning keeps detail of this fraction of the drawing: below half a pixel on any sheet.
const DETAIL: f64 = 1.0 / 65_536.0;
/// Rapids are drawn this far beyond the cuts, as a fraction of the largest extent.
const RAPID_OVERSHOOT_SHARE: f64 = 0.18;

/// A piece after the point where the one before ended.
#[derive(Clone, Copy, Debug)]
pub(super) enum StoredPiece {
    /// A straight line to a point.
    To(Vec3),
    /// The curve of this number.
    Curve(u32),
}

/// Pieces one after the other, of one tool.
#[derive(Clone, Debug)]
pub(super) struct ToolRun {
    /// Index of the tool in [`PathStore::tools`]; `None` for rapids.
    pub tool: Option<usize>,
    pub start: Vec3,
    /// Its first piece; it ends where the next run begins.
    first: usize,
}

/// A tool, and the power that it has cut with where that is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlottedTool {
    pub number: u32,
    power: f64,
    pub cut_mm: f64,
}

/// How a group of cuts is drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum CutStroke {
    /// As this tool of the order of use.
    Tool(usize),
    /// As the rapids: a laser that is off.
    Off,
    /// With this step of the scale from least to most.
    Step(usize),
}

/// Cuts that are drawn alike.
#[derive(Clone, Debug)]
pub(super) struct CutGroup {
    /// As the picture names them, and as the legend does.
    pub id: String,
    pub name: String,
    pub cut_mm: f64,
    pub stroke: CutStroke,
}

/// What is drawn alike: the tools, or steps of power.
#[derive(Clone, Debug)]
pub(super) struct CutGroups {
    pub list: Vec<CutGroup>,
    /// The group of each tool of [`PathStore::tools`].
    pub of_tool: Vec<usize>,
}

/// Steps of power, as many as the scale has colours.
const STEPS: usize = 5;

/// The path, thinned when it grows large.
#[derive(Debug)]
pub(super) struct PathStore {
    runs: Vec<ToolRun>,
    pieces: Vec<StoredPiece>,
    curves: Vec<Curve>,
    tools: Vec<PlottedTool>,
    rapid_mm: f64,
    cuts: Aabb,
    rapids: Aabb,
    start: Option<Vec3>,
    end: Vec3,
    limit: usize,
    unknown: bool,
    /// The axes that the program does not name, of what is drawn.
    not_named: NotNamed,
    /// Zeros whose moves are left out.
    unrelated_zeros: Vec<UnrelatedZero>,
    /// How the control calls its work offsets.
    naming: WorkNaming,
    /// Two programs in one picture, by these names, not tools.
    pub overlay: Option<[String; 2]>,
    /// The stock that is left.
    pub stock: Option<StockRelief>,
    /// One tool with several powers is drawn by them: a laser.
    pub by_power: bool,
}

impl PathStore {
    /// Nothing yet, of a control that calls its work offsets so.
    pub fn new(naming: WorkNaming) -> PathStore {
        PathStore {
            runs: Vec::new(),
            pieces: Vec::new(),
            curves: Vec::new(),
            tools: Vec::new(),
            rapid_mm: 0.0,
            cuts: Aabb::EMPTY,
            rapids: Aabb::EMPTY,
            start: None,
            end: Vec3::ZERO,
            limit: FIRST_THINNING_PIECES,
            unknown: false,
            not_named: NotNamed::NONE,
            unrelated_zeros: Vec::new(),
            naming,
            overlay: None,
            stock: None,
            by_power: false,
        }
    }

    /// Keeps a segment that can be drawn.
    pub fn push(&mut self, segment: &Segment) {
        let bounds = segment.curve.bounds();
        let finite = bounds.min.is_finite() && bounds.max.is_finite();
        let rapid = segment.kind == SegmentKind::Rapid;
        if let Some(zero) = segment.unrelated_zero
            && !self.unrelated_zeros.contains(&zero)
        {
            self.unrelated_zeros.push(zero);
        }
        if !segment.is_drawn() || !finite {
            // The way to the first place is never known; that is no loss.
            self.unknown |= !rapid && segment.unrelated_zero.is_none();
            return;
        }
        self.not_named = self.not_named.or(segment.not_named);
        let tool = (!rapid).then(|| self.tool(segment.tool, segment.rpm));
        let length = if segment.length_mm.is_finite() { segment.length_mm } else { 0.0 };
        match tool {
            Some(index) => {
                self.tools[index].cut_mm += length;
                self.cuts = self.cuts.union(bounds);
            }
            None => {
                self.rapid_mm += length;
                self.rapids = self.rapids.union(bounds);
            }
        }
        let (start, end) = (segment.curve.start(), segment.curve.end());
        self.start.get_or_insert(start);
        let goes_on = self.runs.last().is_some_and(|run| run.tool == tool) && self.end == start;
        if !goes_on {
            self.runs.push(ToolRun { tool, start, first: self.pieces.len() });
        }
        self.end = end;
        self.pieces.push(match segment.curve {
            Curve::Line(_) => StoredPiece::To(end),
            curve => {
                self.curves.push(curve);
                StoredPiece::Curve(self.curves.len() as u32 - 1)
            }
        });
        if self.pieces.len() >= self.limit {
            self.thin();
        }
    }

    /// What is drawn alike.
    pub fn groups(&self) -> CutGroups {
        let most = self.tools.iter().map(|tool| tool.power).fold(0.0, f64::max);
        if self.has_powers() && most > 0.0 {
            return self.steps_of_power(most);
        }
        let mut list: Vec<CutGroup> = Vec::new();
        let mut of_tool = Vec::new();
        for tool in &self.tools {
            let id = format!("tool-{}", tool.number);
            let place = list.iter().position(|group| group.id == id).unwrap_or_else(|| {
                let stroke = CutStroke::Tool(list.len());
                list.push(CutGroup { id, name: self.name(tool), cut_mm: 0.0, stroke });
                list.len() - 1
            });
            list[place].cut_mm += tool.cut_mm;
            of_tool.push(place);
        }
        CutGroups { list, of_tool }
    }

    /// A tool has cut with more than one power.
    fn has_powers(&self) -> bool {
        self.by_power
            && self.tools.iter().any(|tool| {
                self.tools
                    .iter()
                    .any(|other| other.number == tool.number && other.power != tool.power)
            })
    }

    /// From nothing to the most, in equal steps.
    fn steps_of_power(&self, most: f64) -> CutGroups {
        let of_tool: Vec<usize> = self
            .tools
            .iter()
            .map(|tool| (tool.power / most * STEPS as f64).ceil().clamp(0.0, STEPS as f64) as usize)
            .collect();
        let list = (0..=STEPS)
            .map(|step| {
                let own = self.tools.iter().zip(&of_tool).filter(|(_, of)| **of == step);
                let powers = own.clone().map(|(tool, _)| tool.power);
                let name = if step == 0 { "S0, off".to_string() } else { named(powers) };
                let stroke = if step == 0 { CutStroke::Off } else { CutStroke::Step(step - 1) };
                let cut_mm = own.map(|(tool, _)| tool.cut_mm).sum();
                CutGroup { id: format!("power-{step}"), name, cut_mm, stroke }
            })
            .collect();
        CutGroups { list, of_tool }
    }

    /// What the legend calls a tool.
    pub fn name(&self, tool: &PlottedTool) -> String {
        match (&self.overlay, tool.number) {
            (Some(names), number) => names[usize::from(number > 1)].clone(),
            (None, 0) => "no tool".into(),
            (None, number) => format!("T{number}"),
        }
    }

    fn tool(&mut self, number: u32, rpm: f64) -> usize {
        let power = if self.by_power { self.known_power(rpm) } else { 0.0 };
        // The newest is the likely one, and there are few.
        match self.tools.iter().rposition(|tool| tool.number == number && tool.power == power) {
            Some(index) => index,
            None => {
                self.tools.push(PlottedTool { number, power, cut_mm: 0.0 });
                self.tools.len() - 1
            }
        }
    }

    /// A power; where there are very many already, to three digits.
    fn known_power(&self, rpm: f64) -> f64 {
        const POWER_STEPS: usize = 1000;
        if !rpm.is_finite() || rpm <= 0.0 {
            return 0.0;
        }
        if self.tools.len() < POWER_STEPS {
            return rpm;
        }
        let digit = 10f64.powf(rpm.log10().floor() - 2.0);
        (rpm / digit).round() * digit
    }

    /// Leaves out corners and curves that no drawing shows.
    fn thin(&mut self) {
        let reach = self.extent().map_or(0.0, |extent| extent.size().length() * DETAIL);
        let old = std::mem::replace(self, PathStore::new(self.naming));
        self.tools = old.tools;
        self.curves = Vec::new();
        for (index, run) in old.runs.iter().enumerate() {
            let until = old.runs.get(index + 1).map_or(old.pieces.len(), |next| next.first);
            self.runs.push(ToolRun { first: self.pieces.len(), ..run.clone() });
            let mut at = run.start;
            for (place, piece) in old.pieces[run.first..until].iter().enumerate() {
                let last = run.first + place + 1 == until;
                let curve = match piece {
                    StoredPiece::To(_) => None,
                    StoredPiece::Curve(number) => Some(old.curves[*number as usize]),
                };
                let end = match (piece, &curve) {
                    (_, Some(curve)) => curve.end(),
                    (StoredPiece::To(point), _) => *point,
                    (StoredPiece::Curve(_), None) => at,
                };
                let size =
                    curve.map_or((end - at).length(), |curve| curve.bounds().size().length());
                if size < reach && !last {
                    continue;
                }
                at = end;
                self.pieces.push(match curve {
                    Some(curve) if size >= reach => {
                        self.curves.push(curve);
                        StoredPiece::Curve(self.curves.len() as u32 - 1)
                    }
                    _ => StoredPiece::To(end),
                });
            }
        }
        self.rapid_mm = old.rapid_mm;
        (self.cuts, self.rapids) = (old.cuts, old.rapids);
        (self.start, self.end, self.unknown) = (old.start, old.end, old.unknown);
        self.not_named = old.not_named;
        self.unrelated_zeros = old.unrelated_zeros;
        (self.overlay, self.stock, self.by_power) = (old.overlay, old.stock, old.by_power);
        self.limit = FIRST_THINNING_PIECES.max(2 * self.pieces.len());
    }

    /// The runs with their pieces.
    pub fn runs(&self) -> impl Iterator<Item = (&ToolRun, &[StoredPiece])> {
        self.runs.iter().enumerate().map(|(index, run)| {
            let until = self.runs.get(index + 1).map_or(self.pieces.len(), |next| next.first);
            (run, &self.pieces[run.first..until])
        })
    }

    /// A curve of the path.
    pub fn curve(&self, number: u32) -> &Curve {
        &self.curves[number as usize]
    }

    /// The tools that cut, in the order of their first use.
    pub fn tools(&self) -> &[PlottedTool] {
        &self.tools
    }

    /// Length of the rapids, mm; `None` when there are none.
    pub fn rapid_mm(&self) -> Option<f64> {
        (!self.rapids.is_empty()).then_some(self.rapid_mm)
    }

    /// Length of all cuts, mm.
    pub fn cut_mm(&self) -> f64 {
        self.tools.iter().map(|tool| tool.cut_mm).sum()
    }

    /// Where the path begins and ends.
    pub fn ends(&self) -> Option<(Vec3, Vec3)> {
        self.start.map(|start| (start, self.end))
    }

    /// True when cuts came that cannot be drawn.
    pub fn has_unknown(&self) -> bool {
        self.unknown
    }

    /// What is said of axes that the program does not name, and of moves that are left out for their work offset.
    pub fn remarks(&self) -> Vec<String> {
        let mut texts = not_named_texts(self.not_named);
        texts.extend(left_out_texts(&self.unrelated_zeros, self.naming));
        texts
    }

    /// The box of the cuts.
    pub fn cut_extent(&self) -> Option<Aabb> {
        (!self.cuts.is_empty()).then_some(self.cuts)
    }

    /// The box that is drawn: the cuts, the rapids near them, and the stock.
    pub fn extent(&self) -> Option<Aabb> {
        let stock = self.stock.as_ref().map(StockRelief::bounds);
        match (self.path_extent(), stock) {
            (Some(path), Some(stock)) => Some(path.union(stock)),
            (path, stock) => path.or(stock),
        }
    }

    fn path_extent(&self) -> Option<Aabb> {
        let Some(cuts) = self.cut_extent() else {
            return self.rapid_mm().map(|_| self.rapids);
        };
        if self.rapid_mm().is_none() {
            return Some(cuts);
        }
        let size = cuts.size();
        let reach =
            Vec3::new(1.0, 1.0, 1.0) * (RAPID_OVERSHOOT_SHARE * size.x.max(size.y).max(size.z));
        let (low, high) = (cuts.min - reach, cuts.max + reach);
        let near = |value: f64, low: f64, high: f64| value.clamp(low, high);
        let corner = |p: Vec3| {
            Vec3::new(near(p.x, low.x, high.x), near(p.y, low.y, high.y), near(p.z, low.z, high.z))
        };
        let near_rapids = Aabb { min: corner(self.rapids.min), max: corner(self.rapids.max) };
        Some(cuts.union(near_rapids))
    }
}

/// The powers of a step: the one, or from the least to the most.
fn named(powers: impl Iterator<Item = f64>) -> String {
    let (least, most) =
        powers.fold((f64::INFINITY, 0.0_f64), |(a, b), power| (a.min(power), b.max(power)));
    if least < most {
        format!("S{} to S{}", number(least), number(most))
    } else {
        format!("S{}", number(most))
    }
}

/// A power without decimals that say nothing.
fn number(value: f64) -> String {
    let text = format!("{value:.1}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_string)
}
