//! Reads the stock from comments at the head of a program, and where its zero is.
//!
//! A size alone is not enough, since nobody knows where the stock is. Where comments contradict each other or
//! themselves, nothing is taken.

use chordal_diagnostics::{FileId, Span};
use chordal_dialect::Control;
use chordal_machine::{Axis, Body, BodyShape};
use chordal_syntax::{Block, BlockReader};

use super::forms::{field, fields, number, numbers};
use super::program_is_inch;
use crate::Job;

/// Number of blocks at the head of a program in which comments on the stock are looked for.
const MAX_HEAD_BLOCKS: usize = 500;
/// Sizes above this are not those of a stock, mm.
const MAX_STOCK_MM: f64 = 20_000.0;
/// Positions that differ by less than this are equal, mm: post processors write two decimals.
const TOLERANCE_MM: f64 = 0.02;

/// The words of LinuxCNC's comments for each axis: the centre of a round stock, and its ends.
const SIDES: [[&str; 3]; 3] = [["X", "XMIN", "XMAX"], ["Y", "YMIN", "YMAX"], ["Z", "ZMIN", "ZMAX"]];

/// The stock that comments describe.
#[derive(Clone, Debug, PartialEq)]
pub struct CommentedStock {
    /// Its size, and its place where that is known.
    pub place: StockPlace,
    /// The comment that gives its size.
    pub comment: Span,
}

/// How much is known of a stock.
#[derive(Clone, Debug, PartialEq)]
pub enum StockPlace {
    /// A body in the coordinates of the program.
    Body(Box<Body>),
    /// Its size along X, Y and Z, mm; no comment says where its zero is.
    Size([f64; 3]),
}

/// The stock that the comments before the first move describe.
pub fn commented_stock(job: &Job) -> Option<CommentedStock> {
    let source = job.sources().get(FileId(0))?;
    let text = source.text();
    let control = job.word_address()?;
    let comments = head_comments(control, text);
    if comments.is_empty() {
        return None;
    }
    let head = HeadComments { comments, inch: program_is_inch(control, text), turns: job.turns() };
    head.stock()
}

/// The comments up to the first block with X, Y or Z, in upper case, without their delimiters.
fn head_comments(control: &Control, text: &[u8]) -> Vec<(String, Span)> {
    let mut reader = BlockReader::new(text, FileId(0), control.table.lexicon);
    let mut block = Block::new();
    let mut comments = Vec::new();
    for _ in 0..MAX_HEAD_BLOCKS {
        if !reader.read(&mut block) {
            break;
        }
        for range in &block.comments {
            let words = String::from_utf8_lossy(range.slice(text)).to_ascii_uppercase();
            let words = words.trim_matches(['(', ')', ';', '*', '\'', ' ', '\t']);
            comments.push((words.to_string(), range.in_file(FileId(0))));
        }
        if b"XYZ".iter().any(|axis| block.word(*axis).is_some()) {
            break;
        }
    }
    comments
}

/// A stock with a size; its zero may be given in another comment.
struct SizedStock {
    size: [f64; 3],
    /// The corner with the least coordinates, mm; `None` where the comment itself does not give it.
    low: Option<[f64; 3]>,
    /// Its round shape; `None` for a box.
    round: Option<RoundStock>,
}

/// A bar or a tube.
#[derive(Clone, Copy)]
struct RoundStock {
    axis: Axis,
    /// Its outer diameter, mm.
    diameter: f64,
    /// The diameter of the bore of a tube, mm.
    bore: Option<f64>,
}

impl RoundStock {
    fn bar(diameter: f64) -> RoundStock {
        RoundStock { axis: Axis::Z, diameter, bore: None }
    }
}

struct HeadComments {
    comments: Vec<(String, Span)>,
    inch: bool,
    turns: bool,
}

impl HeadComments {
    fn stock(&self) -> Option<CommentedStock> {
        let mut found: Option<(SizedStock, Span)> = None;
        for (at, (text, span)) in self.comments.iter().enumerate() {
            let Some(sized) = self.sized(at, text) else { continue };
            let sound = sized.size.iter().all(|side| *side > 0.0 && *side <= MAX_STOCK_MM);
            if !sound {
                return None;
            }
            match &found {
                // The same size again changes nothing; of two different sizes one is out of date.
                Some((known, _)) if !same(&known.size, &sized.size) => return None,
                Some((known, _)) if known.low.is_some() => {}
                _ => found = Some((sized, *span)),
            }
        }
        let (sized, comment) = found?;
        let low = sized.low.or_else(|| self.low_corner(&sized.size));
        let place = match low {
            // The stock of a lathe turns about Z.
            Some(low) if !self.turns || sized.round.is_some_and(|round| round.axis == Axis::Z) => {
                StockPlace::Body(Box::new(body(&sized, low)))
            }
            _ => StockPlace::Size(sized.size),
        };
        Some(CommentedStock { place, comment })
    }

    fn mm(&self) -> f64 {
        if self.inch { 25.4 } else { 1.0 }
    }

    fn sized(&self, at: usize, text: &str) -> Option<SizedStock> {
        self.record(text)
            .or_else(|| self.work_piece(text))
            .or_else(|| self.cut_viewer(text))
            .or_else(|| self.predator(text))
            .or_else(|| self.bar(text))
            .or_else(|| {
                self.size_only(at, text).map(|size| SizedStock { size, low: None, round: None })
            })
    }

    /// `@F360|STOCK|id=box|…` and `@F360|ORIGIN|…`: Fusion, FreeCAD and Makera Studio for machines of Makera.
    fn record(&self, text: &str) -> Option<SizedStock> {
        let own = fields(text, "STOCK")?;
        let unit = self.comments.iter().find_map(|(text, _)| {
            let unit = fields(text, "UNIT")?;
            match field(&unit, "VALUE")? {
                "MM" => Some(1.0),
                "IN" | "INCH" => Some(25.4),
                _ => None,
            }
        });
        let mm = unit.unwrap_or_else(|| self.mm());
        let length = |key: &str| Some(number(field(&own, key)?)? * mm);
        let makera = text.trim_start_matches([';', ' ']).starts_with("@MKR");
        let (id, x, y) = (field(&own, "ID")?, length("WIDTH"), length("DEPTH"));
        let (x, y) = if makera { (length("LENGTH"), length("WIDTH")) } else { (x, y) };
        let z = length("HEIGHT")?;
        let (size, round) = match id {
            "BOX" | "CUBOID" => ([x?, y?, z], None),
            "CYLINDER" => {
                let diameter = length("DIAMETER")?;
                ([diameter, diameter, z], Some(RoundStock::bar(diameter)))
            }
            // The bore of a tube is not given.
            _ => return None,
        };
        Some(SizedStock { size, low: self.record_low(size, mm), round })
    }

    /// The low corner from the origin, which is given relative to the centre of the stock.
    fn record_low(&self, size: [f64; 3], mm: f64) -> Option<[f64; 3]> {
        let origin = self.comments.iter().find_map(|(text, _)| fields(text, "ORIGIN"))?;
        let mut low = [0.0; 3];
        let sides = named_point(field(&origin, "TYPE_NAME").unwrap_or_default());
        for (axis, key) in ["X", "Y", "Z"].into_iter().enumerate() {
            let from_centre = number(field(&origin, key)?)? * mm;
            low[axis] = -0.5 * size[axis] - from_centre;
            // Where the origin names a point of the stock, its coordinates must agree.
            if let Some(sides) = sides
                && (from_centre - 0.5 * sides[axis] * size[axis]).abs() > TOLERANCE_MM
            {
                return None;
            }
        }
        Some(low)
    }

    /// `WORKPIECE,BOX,XMIN=0,…`: LinuxCNC.
    fn work_piece(&self, text: &str) -> Option<SizedStock> {
        let rest = text.strip_prefix("WORKPIECE,")?;
        let several =
            self.comments.iter().filter(|(text, _)| text.starts_with("WORKPIECE,")).count() > 1;
        let (kind, rest) = rest.split_once(',')?;
        let fields: Vec<(&str, &str)> =
            rest.split(',').filter_map(|part| part.split_once('=')).collect();
        let of = |key: &str| Some(number(field(&fields, key)?)? * self.mm());
        if several {
            return None;
        }
        match kind.trim() {
            "BOX" => {
                let low = [of("XMIN")?, of("YMIN")?, of("ZMIN")?];
                let high = [of("XMAX")?, of("YMAX")?, of("ZMAX")?];
                let size = [0, 1, 2].map(|axis| high[axis] - low[axis]);
                Some(SizedStock { size, low: Some(low), round: None })
            }
            kind @ ("CYLINDER" | "TUBE") => {
                let axis = match field(&fields, "AXIS") {
                    Some("X") => Axis::X,
                    Some("Y") => Axis::Y,
                    None | Some("Z") => Axis::Z,
                    Some(_) => return None,
                };
                let bore = match kind {
                    "TUBE" => Some(of("INNER_DIAMETER")?),
                    _ => None,
                };
                let diameter = of("DIAMETER")?;
                if bore.is_some_and(|bore| bore <= 0.0 || bore >= diameter) {
                    return None;
                }
                let (mut low, mut size) = ([0.0; 3], [diameter; 3]);
                for (at, [centre, least, most]) in SIDES.into_iter().enumerate() {
                    if at == axis as usize {
                        low[at] = of(least)?;
                        size[at] = of(most)? - low[at];
                    } else {
                        low[at] = of(centre).unwrap_or(0.0) - 0.5 * diameter;
                    }
                }
                let round = Some(RoundStock { axis, diameter, bore });
                Some(SizedStock { size, low: Some(low), round })
            }
            _ => None,
        }
    }

    /// `STOCK/BLOCK,l,w,h,ox,oy,oz`: CutViewer; the last three are the zero relative to the low corner.
    fn cut_viewer(&self, text: &str) -> Option<SizedStock> {
        let values = numbers(text.strip_prefix("STOCK/BLOCK")?.trim_start().strip_prefix(',')?)?;
        let mm = |at: usize| values.get(at).map(|value| value * self.mm());
        let size = [mm(0)?, mm(1)?, mm(2)?];
        // A zero outside the stock comes from a post processor that counts it with the opposite sign.
        let zero = |axis: usize| {
            let at = mm(3 + axis)?;
            (at >= -TOLERANCE_MM && at <= size[axis] + TOLERANCE_MM).then_some(-at)
        };
        let low = zero(0).zip(zero(1)).zip(zero(2)).map(|((x, y), z)| [x, y, z]);
        Some(SizedStock { size, low, round: None })
    }

    /// `SBOX X0 Y0 Z-20 L100 W50 H20`: Predator, BobCAD.
    fn predator(&self, text: &str) -> Option<SizedStock> {
        let words: Vec<&str> = text.strip_prefix("SBOX ")?.split_ascii_whitespace().collect();
        let of = |letter: char| {
            let word = words.iter().find_map(|word| word.strip_prefix(letter));
            Some(number(word?)? * self.mm())
        };
        let low = Some([of('X')?, of('Y')?, of('Z')?]);
        Some(SizedStock { size: [of('L')?, of('W')?, of('H')?], low, round: None })
    }

    /// `Zmin:-60 Zmax:0 Diametro:40` for a lathe.
    fn bar(&self, text: &str) -> Option<SizedStock> {
        if !self.turns {
            return None;
        }
        let fields: Vec<(&str, &str)> =
            text.split_ascii_whitespace().filter_map(|word| word.split_once(':')).collect();
        let of = |key: &str| Some(number(field(&fields, key)?)? * self.mm());
        let (low, high) = (of("ZMIN")?, of("ZMAX")?);
        let diameter = of("DIAMETRO").or_else(|| of("DIAMETER"))?;
        let low = [-0.5 * diameter, -0.5 * diameter, low];
        let size = [diameter, diameter, high - low[2]];
        Some(SizedStock { size, low: Some(low), round: Some(RoundStock::bar(diameter)) })
    }

    /// Formats that give a size along each axis, without the zero, mm.
    fn size_only(&self, at: usize, text: &str) -> Option<[f64; 3]> {
        let scale = self.mm();
        let in_mm = |size: [f64; 3], mm: f64| size.map(|side| side * mm);
        if let Some(rest) = text.strip_prefix("MATERIAL SIZE") {
            // Vectric writes the lengths in the next comment or after a colon, proLIGHT after a colon.
            let rest = match rest.trim_start_matches([' ', ':']) {
                "" => self.comments.get(at + 1)?.0.as_str(),
                rest => rest,
            };
            let own_unit = self.comments.iter().find_map(|(text, _)| {
                match text.strip_prefix("UNITS:")?.trim() {
                    "INCH" | "INCHES" => Some(25.4),
                    "METRIC" | "MM" | "MILLIMETERS" => Some(1.0),
                    _ => None,
                }
            });
            return Some(in_mm(by_letters(rest)?, own_unit.unwrap_or(scale)));
        }
        if let Some(rest) = text.strip_prefix("BLANK SIZE:") {
            return Some(in_mm(by_letters(rest)?, scale));
        }
        if let Some(rest) = text.strip_prefix("$SETPARTSIZE(") {
            let values = numbers(rest.trim_end_matches(')'))?;
            let &[x, y, z, ..] = values.as_slice() else { return None };
            return Some(in_mm([x, y, z], scale));
        }
        if text.starts_with("STOCK ") {
            return by_hand(text, scale);
        }
        self.router(text).map(|size| in_mm(size, scale))
    }

    /// `X SIZE:600`, one comment for each length; the thickness of the material is its size along Z.
    fn router(&self, text: &str) -> Option<[f64; 3]> {
        text.strip_prefix("X SIZE:")?;
        let of = |keys: &[&str]| {
            self.comments
                .iter()
                .find_map(|(text, _)| keys.iter().find_map(|key| number(text.strip_prefix(key)?)))
        };
        let x = of(&["X SIZE:"])?;
        Some([x, of(&["Y SIZE:"])?, of(&["Z SIZE:", "THICKNESS:"])?])
    }

    /// The low corner from a separate comment on the zero, mm; `None` without one.
    fn low_corner(&self, size: &[f64; 3]) -> Option<[f64; 3]> {
        self.vectric_corner(size).or_else(|| self.corner_by_hand(size))
    }

    /// `Z Origin for Material = …`, `XY Origin for Material = …`: Vectric.
    fn vectric_corner(&self, size: &[f64; 3]) -> Option<[f64; 3]> {
        let value_of = |key: &str| {
            self.comments.iter().find_map(|(text, _)| {
                Some(text.strip_prefix(key)?.trim_start_matches([' ', '=']).trim())
            })
        };
        // The meaning of an origin position other than zero is not known.
        if let Some(position) = value_of("XY ORIGIN POSITION") {
            let values: Option<Vec<f64>> = position
                .split(',')
                .map(|part| number(part.trim().trim_start_matches(['X', 'Y', ':'])))
                .collect();
            if values?.iter().any(|value| *value != 0.0) {
                return None;
            }
        }
        let z = match value_of("Z ORIGIN FOR MATERIAL")? {
            "MATERIAL SURFACE" => -size[2],
            "TABLE SURFACE" => 0.0,
            "CENTER" | "CENTER OF MATERIAL" => -0.5 * size[2],
            _ => return None,
        };
        let [x, y] = match value_of("XY ORIGIN FOR MATERIAL")?.trim_end_matches("CORNER").trim() {
            "BOTTOM LEFT" => [0.0, 0.0],
            "BOTTOM RIGHT" => [-size[0], 0.0],
            "TOP LEFT" => [0.0, -size[1]],
            "TOP RIGHT" => [-size[0], -size[1]],
            "CENTER" => [-0.5 * size[0], -0.5 * size[1]],
            _ => return None,
        };
        Some([x, y, z])
    }

    /// `G54 = BACK-LEFT-TOP`.
    fn corner_by_hand(&self, size: &[f64; 3]) -> Option<[f64; 3]> {
        let sides = self.comments.iter().find_map(|(text, _)| {
            let rest = text.strip_prefix("WCS").unwrap_or(text).trim_start();
            let rest = rest.strip_prefix("G54")?.trim_start_matches([' ', '=', ':']);
            let words: Vec<&str> = rest.split(['-', ' ']).filter(|word| !word.is_empty()).collect();
            if words.len() != 3 {
                return None;
            }
            let side = |low: &str, high: &str| match (words.contains(&low), words.contains(&high)) {
                (true, false) => Some(0.0),
                (false, true) => Some(1.0),
                _ => None,
            };
            Some([side("LEFT", "RIGHT")?, side("FRONT", "BACK")?, side("BOTTOM", "TOP")?])
        })?;
        Some([0, 1, 2].map(|axis| -sides[axis] * size[axis]))
    }
}

/// The side of the stock on which a named point is, for each axis: −1, 0 (the middle) or 1; `None` where the name is
/// no such point.
fn named_point(name: &str) -> Option<[f64; 3]> {
    if name.is_empty() || name == "CUSTOM" {
        return None;
    }
    let side = |low: &str, high: &str| match (name.contains(low), name.contains(high)) {
        (true, _) => -1.0,
        (_, true) => 1.0,
        _ => 0.0,
    };
    Some([side("LEFT", "RIGHT"), side("FRONT", "BACK"), side("BOTTOM", "TOP")])
}

/// `X= 300, Y= 200, Z= 12`, `X3 Y2 Z.5`; `None` where one is missing.
fn by_letters(text: &str) -> Option<[f64; 3]> {
    let mut size = [None; 3];
    let mut rest = text.trim();
    while !rest.is_empty() {
        let axis = b"XYZ".iter().position(|letter| rest.as_bytes()[0] == *letter)?;
        let after = rest[1..].trim_start_matches([' ', '=', ':']);
        let end = after.find([' ', ',']).unwrap_or(after.len());
        size[axis] = Some(number(&after[..end])?);
        rest = after[end..].trim_start_matches([' ', ',']);
    }
    let [Some(x), Some(y), Some(z)] = size else { return None };
    Some([x, y, z])
}

/// `STOCK 6061 DX 6.0IN DY 4.0IN DZ 1.5IN`, in mm; `None` where a length cannot be read.
fn by_hand(text: &str, scale: f64) -> Option<[f64; 3]> {
    let words: Vec<&str> = text.split_ascii_whitespace().collect();
    let mut size = [0.0; 3];
    for (side, key) in size.iter_mut().zip(["DX", "DY", "DZ"]) {
        let at = words.iter().position(|word| *word == key)?;
        let word = words.get(at + 1)?;
        let digits = word.trim_end_matches(|c: char| !c.is_ascii_digit() && c != '.');
        let mm = match &word[digits.len()..] {
            "" => scale,
            "IN" | "\"" => 25.4,
            "MM" => 1.0,
            _ => return None,
        };
        *side = number(digits)? * mm;
    }
    Some(size)
}

fn same(one: &[f64; 3], other: &[f64; 3]) -> bool {
    one.iter().zip(other).all(|(one, other)| (one - other).abs() < TOLERANCE_MM)
}

fn body(sized: &SizedStock, low: [f64; 3]) -> Body {
    let high = [0, 1, 2].map(|axis| low[axis] + sized.size[axis]);
    let Some(RoundStock { axis, diameter, bore }) = sized.round else {
        return Body {
            shape: Some(BodyShape::Box),
            from: low.map(Some),
            to: high.map(Some),
            ..Body::default()
        };
    };
    let along = axis as usize;
    let mut from = low.map(|low| Some(low + 0.5 * diameter));
    let mut to = [None; 3];
    (from[along], to[along]) = (Some(low[along]), Some(high[along]));
    Body {
        shape: Some(if bore.is_some() { BodyShape::Tube } else { BodyShape::Cylinder }),
        axis: Some(axis),
        diameter_mm: Some(diameter),
        bore_mm: bore,
        from,
        to,
        ..Body::default()
    }
}
