//! A tool: its offsets, its shape, its shank and its holder.

use crate::axis::{Axis, PerAxis};
use crate::turning::TurningTool;

/// The default point angle of a drill, rad: 118°, that of common twist drills.
pub const USUAL_POINT_ANGLE_RAD: f64 = 118.0_f64.to_radians();

/// A tool, its offsets and its shape. `None`: not given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tool {
    /// The diameter, which is twice the radius offset, mm.
    pub diameter_mm: Option<f64>,
    /// The wear that is added to the diameter, mm.
    pub diameter_wear_mm: Option<f64>,
    /// The geometry offset by `axis as usize`, mm or rad, always as a radius: for a mill, Z is its length; a turning
    /// tool has X and Z.
    pub offset: PerAxis<Option<f64>>,
    /// The wear that is added to the geometry offset, mm or rad.
    pub offset_wear: PerAxis<Option<f64>>,
    /// Its shape; `None`: not known, and not guessed.
    pub shape: Option<ToolShape>,
    /// The radius of the corner between side and end, mm.
    pub corner_radius_mm: Option<f64>,
    /// The point angle of a drill or chamfer mill, from side to side, rad.
    pub point_angle_rad: Option<f64>,
    /// The diameter of the flat at the end of a chamfer mill, mm.
    pub tip_diameter_mm: Option<f64>,
    /// The pitch of a tap or thread mill, mm.
    pub pitch_mm: Option<f64>,
    /// The number of teeth: around, or for a thread mill along its axis.
    pub teeth: Option<u32>,
    /// The largest chip thickness of a tooth, mm.
    pub max_chip_mm: Option<f64>,
    /// The smallest chip thickness that its edges cut, mm: thinner chips are only rubbed.
    pub min_chip_mm: Option<f64>,
    /// The nose radius of an insert, mm.
    pub nose_radius_mm: Option<f64>,
    /// The tip number: the direction of the programmed point from the nose, 0 to 9 as the control counts.
    pub tip: Option<u32>,
    /// The outline of a form tool from its end upward: height above the end and radius, mm.
    pub profile: Vec<[f64; 2]>,
    /// The length of the cutting edges, mm.
    pub flute_length_mm: Option<f64>,
    /// The diameter of a round shank if `shank` is empty, mm.
    pub shank_diameter_mm: Option<f64>,
    /// The shank, from the edges upward.
    pub shank: Vec<HolderSegment>,
    /// The holder, from the shank upward.
    pub holder: Vec<HolderSegment>,
    /// The insert, blade and holder of a turning tool.
    pub turning: TurningTool,
    /// A name for display, such as `roughing end mill`.
    pub description: Option<String>,
    /// Free text.
    pub comment: Option<String>,
}

impl Tool {
    /// The length offset without wear: the geometry offset along Z, mm; `None`: not given.
    pub const fn length_mm(&self) -> Option<f64> {
        self.offset[Axis::Z as usize]
    }

    /// The geometry offset of an axis including its wear, mm or rad; `None` without geometry.
    pub fn offset_of(&self, axis: usize) -> Option<f64> {
        Some(self.offset[axis]? + self.offset_wear[axis].unwrap_or(0.0))
    }

    /// The radius for cutter compensation, including wear, mm: half the diameter, or the nose radius of an insert.
    /// `None`: not given.
    pub fn radius_mm(&self) -> Option<f64> {
        let wear = self.diameter_wear_mm.unwrap_or(0.0);
        match self.diameter_mm {
            Some(diameter) => Some((diameter + wear) / 2.0),
            None => self.nose_radius_mm.map(|nose| nose + wear / 2.0),
        }
    }

    /// The shape with its dimensions; `None` if it is not known or one of them is missing.
    pub fn cutter(&self) -> Option<Cutter<'_>> {
        // On some controls a negative diameter means the other side; the tool itself has no negative diameter.
        let diameter_mm = || self.diameter_mm.map(f64::abs);
        Some(match self.shape? {
            ToolShape::Flat => match self.corner_radius_mm {
                Some(corner) if corner > 0.0 => {
                    Cutter::Bull { diameter_mm: diameter_mm()?, corner_radius_mm: corner }
                }
                _ => Cutter::Flat { diameter_mm: diameter_mm()? },
            },
            ToolShape::Ball => Cutter::Ball { diameter_mm: diameter_mm()? },
            ToolShape::Bull => Cutter::Bull {
                diameter_mm: diameter_mm()?,
                corner_radius_mm: self.corner_radius_mm?,
            },
            ToolShape::Chamfer => Cutter::Chamfer {
                diameter_mm: diameter_mm()?,
                tip_diameter_mm: self.tip_diameter_mm.unwrap_or(0.0),
                point_angle_rad: self.point_angle_rad?,
            },
            ToolShape::Drill => Cutter::Drill {
                diameter_mm: diameter_mm()?,
                point_angle_rad: self.point_angle_rad.unwrap_or(USUAL_POINT_ANGLE_RAD),
            },
            ToolShape::Tap => Cutter::Tap { diameter_mm: diameter_mm()?, pitch_mm: self.pitch_mm? },
            ToolShape::ThreadMill => Cutter::ThreadMill {
                diameter_mm: diameter_mm()?,
                pitch_mm: self.pitch_mm?,
                teeth: self.teeth?,
            },
            ToolShape::TSlot => Cutter::TSlot {
                diameter_mm: diameter_mm()?,
                thickness_mm: self.flute_length_mm?,
                neck_mm: self.neck_mm()?,
            },
            ToolShape::Lollipop => {
                Cutter::Lollipop { diameter_mm: diameter_mm()?, neck_mm: self.neck_mm()? }
            }
            ToolShape::Form if self.profile.len() < 2 => return None,
            ToolShape::Form => Cutter::Form { profile: &self.profile },
            ToolShape::Insert => {
                Cutter::Insert { nose_radius_mm: self.nose_radius_mm?, tip: self.tip? }
            }
            ToolShape::Groove => {
                Cutter::Groove { width_mm: self.turning.width_mm?, tip: self.tip? }
            }
        })
    }

    /// Whether it is a drill without a point angle, so that the default is used.
    pub fn has_assumed_point_angle(&self) -> bool {
        self.shape == Some(ToolShape::Drill) && self.point_angle_rad.is_none()
    }

    /// The keys in a machine file of the dimensions that the shape needs and that are missing.
    pub fn missing_dimensions(&self) -> Vec<&'static str> {
        let Some(shape) = self.shape else { return vec!["shape"] };
        let diameter = ("diameter", self.diameter_mm.is_some());
        let pitch = ("pitch", self.pitch_mm.is_some());
        let neck = ("shank_diameter", self.neck_mm().is_some());
        let tip = ("tip", self.tip.is_some());
        let needed = match shape {
            ToolShape::Flat | ToolShape::Ball | ToolShape::Drill => vec![diameter],
            ToolShape::Bull => vec![diameter, ("corner_radius", self.corner_radius_mm.is_some())],
            ToolShape::Chamfer => vec![diameter, ("point_angle", self.point_angle_rad.is_some())],
            ToolShape::Tap => vec![diameter, pitch],
            ToolShape::ThreadMill => vec![diameter, pitch, ("teeth", self.teeth.is_some())],
            ToolShape::TSlot => {
                vec![diameter, ("flute_length", self.flute_length_mm.is_some()), neck]
            }
            ToolShape::Lollipop => vec![diameter, neck],
            ToolShape::Form => vec![("profile", self.profile.len() >= 2)],
            ToolShape::Insert => vec![("nose_radius", self.nose_radius_mm.is_some()), tip],
            ToolShape::Groove => vec![("width", self.turning.width_mm.is_some()), tip],
        };
        needed.into_iter().filter(|(_, is_provided)| !is_provided).map(|(key, _)| key).collect()
    }

    /// The diameter of the shank at the end of the edges, mm.
    fn neck_mm(&self) -> Option<f64> {
        self.shank.first().map(|piece| piece.lower_mm).or(self.shank_diameter_mm)
    }

    /// Its label in lists: its comment, else its description, else its shape.
    pub fn label(&self) -> Option<&str> {
        let shape = || self.shape.map(ToolShape::as_str);
        self.comment.as_deref().or(self.description.as_deref()).or_else(shape)
    }

    /// Reads a free text: as the shape if it names one, else as the description. False if it names no shape.
    pub(crate) fn take_kind(&mut self, text: &str) -> bool {
        let shape = ToolShape::from_words(text);
        self.shape = shape.or(self.shape);
        let is_own_word = shape.is_some_and(|shape| shape.as_str().eq_ignore_ascii_case(text));
        if !is_own_word {
            self.description = Some(text.to_string());
        }
        shape.is_some()
    }
}

/// The shape of a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ToolShape {
    /// An end mill with a flat end, or a face mill.
    Flat,
    /// An end mill with a half ball at its end.
    Ball,
    /// An end mill with rounded corners.
    Bull,
    /// A conical chamfer mill.
    Chamfer,
    /// A drill, center drill or spot drill.
    Drill,
    /// A tap.
    Tap,
    /// A thread mill.
    ThreadMill,
    /// A disc on a neck.
    TSlot,
    /// A ball on a neck.
    Lollipop,
    /// A body of revolution with any outline.
    Form,
    /// A turning insert.
    Insert,
    /// A grooving or parting blade.
    Groove,
}

impl ToolShape {
    /// Every shape.
    pub const ALL: [ToolShape; 12] = [
        ToolShape::Flat,
        ToolShape::Ball,
        ToolShape::Bull,
        ToolShape::Chamfer,
        ToolShape::Drill,
        ToolShape::Tap,
        ToolShape::ThreadMill,
        ToolShape::TSlot,
        ToolShape::Lollipop,
        ToolShape::Form,
        ToolShape::Insert,
        ToolShape::Groove,
    ];

    /// The word for it in machine files.
    pub const fn as_str(self) -> &'static str {
        match self {
            ToolShape::Flat => "flat",
            ToolShape::Ball => "ball",
            ToolShape::Bull => "bull",
            ToolShape::Chamfer => "chamfer",
            ToolShape::Drill => "drill",
            ToolShape::Tap => "tap",
            ToolShape::ThreadMill => "thread mill",
            ToolShape::TSlot => "t-slot",
            ToolShape::Lollipop => "lollipop",
            ToolShape::Form => "form",
            ToolShape::Insert => "insert",
            ToolShape::Groove => "groove",
        }
    }

    /// The shape that a free text names (`FLAT END MILL`, `spot drill`, `5/8 bull nose`). `None` if it names none, or a
    /// tool without a shape here, such as a reamer.
    pub fn from_words(text: &str) -> Option<ToolShape> {
        let text = text.to_ascii_uppercase();
        let words: Vec<&str> = text.split(|c: char| !c.is_ascii_alphanumeric()).collect();
        let has = |word: &str| words.contains(&word);
        let pair = |a: &str, b: &str| words.windows(2).any(|pair| pair == [a, b]);
        let either = |list: &[&str]| list.iter().any(|word| has(word));
        let place = |word: &str| words.iter().position(|own| *own == word).unwrap_or(usize::MAX);
        // The first match counts: a thread mill is not a flat mill, and neither is a ball end mill.
        Some(match () {
            () if either(&["REAM", "REAMER", "PROBE", "DOVETAIL", "KEYSEAT", "KEYCUTTER"])
                || either(&[
                    "ENGRAVER",
                    "ENGRAVE",
                    "BORE",
                    "BAR",
                    "COUNTERBORE",
                    "SLITTING",
                    "SAW",
                ]) =>
            {
                return None;
            }
            () if pair("T", "SLOT") || has("TSLOT") => ToolShape::TSlot,
            () if has("LOLLIPOP") => ToolShape::Lollipop,
            () if pair("THREAD", "MILL") || either(&["THREADMILL", "THREADMILLING"]) => {
                ToolShape::ThreadMill
            }
            () if either(&["INSERT", "TURNING"]) => ToolShape::Insert,
            () if either(&["GROOVING", "PARTING", "CUTOFF"]) => ToolShape::Groove,
            // `#7 TAP DRILL`, `F DRILL FOR 5/16-18 TAP`.
            () if pair("TAP", "DRILL") || has("DRILL") && place("DRILL") < place("TAP") => {
                ToolShape::Drill
            }
            () if either(&["TAP", "TAPPING"]) => ToolShape::Tap,
            () if either(&["DRILL", "DRILLS", "SPOT", "SPOTDRILL", "CENTERDRILL"]) => {
                ToolShape::Drill
            }
            () if either(&[
                "CHAMFER",
                "CHAMF",
                "CHAM",
                "COUNTERSINK",
                "CSINK",
                "CSK",
                "CHAMFERMILL",
                "VBIT",
            ]) || pair("V", "BIT") =>
            {
                ToolShape::Chamfer
            }
            () if either(&["BALL", "BALLNOSE", "BALLMILL", "BALLEND", "BEM", "SPHERICAL"]) => {
                ToolShape::Ball
            }
            () if either(&["BULL", "BULLNOSE"]) => ToolShape::Bull,
            () if either(&["FORM"]) => ToolShape::Form,
            () if either(&[
                "ENDMILL",
                "FACEMILL",
                "SHELLMILL",
                "FLAT",
                "FEM",
                "EM",
                "SLOTMILL",
            ]) =>
            {
                ToolShape::Flat
            }
            () if pair("END", "MILL") || pair("FACE", "MILL") || pair("SHELL", "MILL") => {
                ToolShape::Flat
            }
            () if pair("SQUARE", "MILL") || pair("E", "M") => ToolShape::Flat,
            () => return None,
        })
    }
}

/// A shape with all of its dimensions, mm and rad.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs, reason = "the fields are those of `Tool`")]
pub enum Cutter<'t> {
    /// A flat end.
    Flat { diameter_mm: f64 },
    /// A half ball.
    Ball { diameter_mm: f64 },
    /// Rounded corners.
    Bull { diameter_mm: f64, corner_radius_mm: f64 },
    /// A cone above a flat, whose diameter may be zero.
    Chamfer { diameter_mm: f64, tip_diameter_mm: f64, point_angle_rad: f64 },
    /// A point and a cylinder.
    Drill { diameter_mm: f64, point_angle_rad: f64 },
    /// A tap with a thread of this pitch.
    Tap { diameter_mm: f64, pitch_mm: f64 },
    /// A thread mill with a number of threads along its axis.
    ThreadMill { diameter_mm: f64, pitch_mm: f64, teeth: u32 },
    /// A disc on a neck.
    TSlot { diameter_mm: f64, thickness_mm: f64, neck_mm: f64 },
    /// A ball on a neck.
    Lollipop { diameter_mm: f64, neck_mm: f64 },
    /// An outline: height above the end and radius.
    Form { profile: &'t [[f64; 2]] },
    /// An insert with a nose radius and a tip number.
    Insert { nose_radius_mm: f64, tip: u32 },
    /// A blade with a width and a tip number.
    Groove { width_mm: f64, tip: u32 },
}

/// A segment of a shank or holder: a cylinder, or a cone if the diameters differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HolderSegment {
    /// Its height, mm.
    pub height_mm: f64,
    /// The diameter at its lower end, mm.
    pub lower_mm: f64,
    /// The diameter at its upper end, mm.
    pub upper_mm: f64,
}
