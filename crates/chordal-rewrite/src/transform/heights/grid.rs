//! A map of measured heights: a full grid of points, and the surface between them.

use std::cmp::Ordering;

/// Points whose X or Y differ by less stand in one row or column, mm.
const SAME_LINE_MM: f64 = 0.005;
/// More points than these are not read.
const MAX_POINTS: usize = 1_000_000;

/// Heights over a rectangle, mm. Between four points the surface is bilinear.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    columns: Vec<f64>,
    rows: Vec<f64>,
    /// Row after row.
    heights: Vec<f64>,
}

/// Why a text is no map.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{what}")]
pub struct MapError {
    /// Line of the text, from 1; nothing where the map as a whole is meant.
    pub line: Option<u32>,
    /// The line as it is written.
    pub text: String,
    /// What is wrong.
    pub what: String,
    /// What to do.
    pub help: String,
}

impl MapError {
    fn of_line(line: u32, text: &str, what: String, help: &str) -> MapError {
        MapError { line: Some(line), text: text.trim().into(), what, help: help.into() }
    }

    fn of_map(what: String, help: &str) -> MapError {
        MapError { line: None, text: String::new(), what, help: help.into() }
    }
}

/// One measured point, mm, and its line.
#[derive(Clone, Copy)]
struct MeasuredPoint {
    at: [f64; 3],
    line: u32,
}

/// The surface about a place: height, slopes along X and Y, and the twist (of X times Y).
#[derive(Clone, Copy, Debug)]
pub(super) struct LocalSurface {
    pub(super) height: f64,
    pub(super) slope: [f64; 2],
    pub(super) twist: f64,
}

impl HeightMap {
    /// Reads a map: a point in each line, X Y Z in this order or in that of a head line, with commas, semicolons
    /// or blanks between them; `#` begins a remark, and so does `;` at the start of a line. Lengths are in units of so many mm.
    ///
    /// # Errors
    /// The first line that is no point, or what the grid lacks.
    pub fn read(bytes: &[u8], unit_mm: f64) -> Result<HeightMap, MapError> {
        let text = String::from_utf8_lossy(bytes);
        let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
        let mut order = None;
        let mut points = Vec::new();
        for (index, whole) in text.lines().enumerate() {
            let line = index as u32 + 1;
            let is_remark = whole.trim_start().starts_with(';');
            let words = if is_remark { "" } else { whole.split('#').next().unwrap_or("") };
            let cells = cells(words);
            if cells.is_empty() {
                continue;
            }
            if order.is_none() && points.is_empty() && is_head(&cells) {
                order = Some(head(&cells).map_err(|what| {
                    MapError::of_line(line, whole, what, "name the columns x, y and z")
                })?);
                continue;
            }
            let at = point(&cells, order.unwrap_or([0, 1, 2])).map_err(|what| {
                MapError::of_line(
                    line,
                    whole,
                    what,
                    "write a point as X, Y and Z, such as 10,20,-0.05",
                )
            })?;
            if points.len() >= MAX_POINTS {
                let what = format!("the map has more than {MAX_POINTS} points");
                return Err(MapError::of_line(line, whole, what, "measure fewer points"));
            }
            points.push(MeasuredPoint { at: at.map(|value| value * unit_mm), line });
        }
        HeightMap::of(&points, unit_mm)
    }

    fn of(points: &[MeasuredPoint], unit_mm: f64) -> Result<HeightMap, MapError> {
        let [columns, rows] = [0, 1].map(|axis| places(points, axis));
        if columns.len() < 2 || rows.len() < 2 {
            let what = format!(
                "a map of {} points, {} in X and {} in Y, is no surface",
                points.len(),
                columns.len(),
                rows.len()
            );
            return Err(MapError::of_map(what, "a map needs at least two columns and two rows"));
        }
        let place_of = |point: &MeasuredPoint| {
            nearest(&rows, point.at[1]) * columns.len() + nearest(&columns, point.at[0])
        };
        // Sorted and not put in a table: points on a slanting line would want a table of their square.
        let mut placed: Vec<(usize, MeasuredPoint)> =
            points.iter().map(|point| (place_of(point), *point)).collect();
        placed.sort_by_key(|(place, point)| (*place, point.line));
        if let Some(pair) = placed.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            let [x, y, _] = pair[1].1.at.map(|value| plain(value / unit_mm));
            let what = format!("the point X{x} Y{y} stands in line {} already", pair[0].1.line);
            return Err(MapError::of_line(pair[1].1.line, "", what, "keep one of the two"));
        }
        let count = columns.len() * rows.len();
        if placed.len() < count {
            let missing = (0..count)
                .zip(placed.iter().map(|(place, _)| *place).chain([usize::MAX]))
                .find(|(target, found)| target != found)
                .map_or(0, |(target, _)| target);
            let at = [columns[missing % columns.len()], rows[missing / columns.len()]];
            let what = format!(
                "the grid of {} by {} lacks {}, the first at X{} Y{}",
                columns.len(),
                rows.len(),
                match count - placed.len() {
                    1 => "1 point".to_string(),
                    many => format!("{many} points"),
                },
                plain(at[0] / unit_mm),
                plain(at[1] / unit_mm)
            );
            return Err(MapError::of_map(what, "measure every point of the rectangle"));
        }
        let heights = placed.iter().map(|(_, point)| point.at[2]).collect();
        Ok(HeightMap { columns, rows, heights })
    }

    /// The same map with the height at a place taken for zero.
    #[must_use]
    pub fn with_zero_at(mut self, at: [f64; 2]) -> HeightMap {
        let zero = self.height(at);
        self.heights.iter_mut().for_each(|height| *height -= zero);
        self
    }

    /// How many columns and rows it has.
    pub fn size(&self) -> [usize; 2] {
        [self.columns.len(), self.rows.len()]
    }

    /// The least and the largest X and Y, mm.
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let ends = |places: &[f64]| [places[0], places[places.len() - 1]];
        [ends(&self.columns), ends(&self.rows)]
    }

    /// The lowest and the highest point, mm.
    pub fn range(&self) -> [f64; 2] {
        self.heights.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], height| {
            [low.min(*height), high.max(*height)]
        })
    }

    /// How far rapids are raised, mm: over the highest point, and never lowered.
    pub fn rise(&self) -> f64 {
        self.range()[1].max(0.0)
    }

    /// The height at a place, mm; beyond the edge that of the edge.
    pub fn height(&self, at: [f64; 2]) -> f64 {
        self.about(at).height
    }

    /// How far a place lies outside, mm.
    pub fn outside(&self, at: [f64; 2]) -> f64 {
        let [x, y] = self.bounds();
        let beyond = |[low, high]: [f64; 2], value: f64| (low - value).max(value - high).max(0.0);
        beyond(x, at[0]).hypot(beyond(y, at[1]))
    }

    /// Where the surface may have an edge along X (0) or Y (1) within a range, mm.
    pub(super) fn edges(&self, axis: usize, low: f64, high: f64) -> &[f64] {
        let places = if axis == 0 { &self.columns } else { &self.rows };
        let first = places.partition_point(|place| *place < low);
        let end = places.partition_point(|place| *place <= high);
        &places[first..end.max(first)]
    }

    /// The steepest slope within a rectangle, given by two of its corners, mm.
    pub(super) fn steepest(&self, one: [f64; 2], other: [f64; 2]) -> f64 {
        let [columns, rows] = [(&self.columns, 0), (&self.rows, 1)].map(|(places, axis)| {
            let (low, high) = (one[axis].min(other[axis]), one[axis].max(other[axis]));
            let last = places.len() - 2;
            let first = places.partition_point(|place| *place < low).saturating_sub(1);
            let end = places.partition_point(|place| *place <= high).max(1) - 1;
            first.min(last)..=end.min(last)
        });
        let mut most = 0f64;
        for row in rows {
            for column in columns.clone() {
                let [wide, high] = self.extent([column, row]);
                let [a, b, c, d] = self.corners([column, row]);
                let along = ((b - a) / wide).abs().max(((d - c) / wide).abs());
                let across = ((c - a) / high).abs().max(((d - b) / high).abs());
                most = most.max(along.hypot(across));
            }
        }
        most
    }

    pub(super) fn about(&self, at: [f64; 2]) -> LocalSurface {
        let [x, y] = [(&self.columns, at[0]), (&self.rows, at[1])].map(|(places, value)| {
            let cell = places.partition_point(|place| *place <= value);
            let cell = cell.clamp(1, places.len() - 1) - 1;
            let is_inside = value >= places[0] && value <= places[places.len() - 1];
            (cell, value.clamp(places[0], places[places.len() - 1]), is_inside)
        });
        let cell = [x.0, y.0];
        let [wide, high] = self.extent(cell);
        let [a, b, c, d] = self.corners(cell);
        let (u, v) = ((x.1 - self.columns[x.0]) / wide, (y.1 - self.rows[y.0]) / high);
        let twist = (a - b - c + d) / (wide * high);
        let only = |is_inside: bool, value: f64| if is_inside { value } else { 0.0 };
        LocalSurface {
            height: (a * (1.0 - u) + b * u) * (1.0 - v) + (c * (1.0 - u) + d * u) * v,
            slope: [
                only(x.2, ((b - a) * (1.0 - v) + (d - c) * v) / wide),
                only(y.2, ((c - a) * (1.0 - u) + (d - b) * u) / high),
            ],
            twist: only(x.2 && y.2, twist),
        }
    }

    fn extent(&self, [column, row]: [usize; 2]) -> [f64; 2] {
        [self.columns[column + 1] - self.columns[column], self.rows[row + 1] - self.rows[row]]
    }

    /// Lower left, lower right, upper left, upper right.
    fn corners(&self, [column, row]: [usize; 2]) -> [f64; 4] {
        let low = row * self.columns.len() + column;
        let high = low + self.columns.len();
        [self.heights[low], self.heights[low + 1], self.heights[high], self.heights[high + 1]]
    }
}

/// The cells of a line. With semicolons between them a comma is a decimal comma.
fn cells(line: &str) -> Vec<String> {
    let own = |cell: &str| cell.trim().trim_matches('"').trim().to_string();
    if line.contains(';') {
        let cells: Vec<String> = line.split(';').map(|cell| own(cell).replace(',', ".")).collect();
        return if cells.iter().all(String::is_empty) { Vec::new() } else { cells };
    }
    let is_gap = |c: char| c == ',' || c.is_whitespace();
    if line.contains(',') {
        let cells: Vec<String> = line.split(',').map(own).collect();
        return if cells.iter().all(String::is_empty) { Vec::new() } else { cells };
    }
    line.split(is_gap).filter(|cell| !cell.is_empty()).map(own).collect()
}

fn is_head(cells: &[String]) -> bool {
    cells.iter().all(|cell| cell.parse::<f64>().is_err())
        && cells.iter().any(|cell| cell.chars().any(char::is_alphabetic))
}

/// Where X, Y and Z stand.
fn head(cells: &[String]) -> Result<[usize; 3], String> {
    let find = |name: &str| {
        let place = cells.iter().position(|cell| {
            let word = cell.to_ascii_lowercase();
            word == name || word.split([' ', '[', '(', '_']).next() == Some(name)
        });
        place.ok_or_else(|| format!("the head names no column {name}"))
    };
    Ok([find("x")?, find("y")?, find("z")?])
}

fn point(cells: &[String], order: [usize; 3]) -> Result<[f64; 3], String> {
    let mut at = [0.0; 3];
    for (axis, place) in order.into_iter().enumerate() {
        let name = ["X", "Y", "Z"][axis];
        let cell = cells.get(place).ok_or_else(|| format!("there is no {name} in this line"))?;
        at[axis] = match cell.parse::<f64>() {
            Ok(value) if value.is_finite() && value.abs() < 1e9 => value,
            _ => return Err(format!("`{cell}` in column {} is no number for {name}", place + 1)),
        };
    }
    Ok(at)
}

/// The different places of points along an axis, in order.
fn places(points: &[MeasuredPoint], axis: usize) -> Vec<f64> {
    let mut all: Vec<f64> = points.iter().map(|point| point.at[axis]).collect();
    all.sort_unstable_by(f64::total_cmp);
    all.dedup_by(|next, before| *next - *before <= SAME_LINE_MM);
    all
}

fn nearest(places: &[f64], value: f64) -> usize {
    let above = places.partition_point(|place| *place < value);
    let candidates = [above.saturating_sub(1), above.min(places.len() - 1)];
    let off = |at: usize| (places[at] - value).abs();
    match off(candidates[0]).total_cmp(&off(candidates[1])) {
        Ordering::Greater => candidates[1],
        _ => candidates[0],
    }
}

fn plain(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}
