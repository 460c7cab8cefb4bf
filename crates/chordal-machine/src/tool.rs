//! A tool: its offsets, its shape, and the solids above its edges.

use crate::axis::{Axis, PerAxis};
use crate::turning::TurningTool;

/// The whole angle of the point of a drill that nobody gives, rad: 118°, as twist drills have it.
pub const USUAL_POINT_ANGLE_RAD: f64 = 118.0_f64.to_radians();

/// A tool, its offsets and its shape.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tool {
    /// The diameter: twice the radius offset.
    pub diameter_mm: Option<f64>,
    /// What is added to the diameter.
    pub diameter_wear_mm: Option<f64>,
    /// The geometry offset by `axis as usize`, mm or rad, a radius on every axis: that of Z is the
    /// length of a mill, those of X and Z are a turning tool's.
    pub offset: PerAxis<Option<f64>>,
    /// What is added to the geometry.
    pub offset_wear: PerAxis<Option<f64>>,
    /// What it is; `None`: not known, and nothing is guessed.
    pub shape: Option<ToolShape>,
    /// The radius of the corner between side and end.
    pub corner_radius_mm: Option<f64>,
    /// The whole angle of the point of a drill or chamfer mill, rad.
    pub point_angle_rad: Option<f64>,
    /// The diameter of the flat at the end of a chamfer mill.
    pub tip_diameter_mm: Option<f64>,
    /// The pitch of a tap or thread mill.
    pub pitch_mm: Option<f64>,
    /// Teeth: around, or of a thread mill along its axis.
    pub teeth: Option<u32>,
    /// The thickest chip that a tooth may take.
    pub max_chip_mm: Option<f64>,
    /// The thinnest chip that its edges cut: below they rub.
    pub min_chip_mm: Option<f64>,
    /// The nose radius of an insert.
    pub nose_radius_mm: Option<f64>,
    /// Where the programmed point lies as seen from the nose, 0 to 9 as the control counts.
    pub tip: Option<u32>,
    /// The outline of a form tool from its end up: height above the end and radius, mm.
    pub profile: Vec<[f64; 2]>,
    /// How far up the edges cut.
    pub flute_length_mm: Option<f64>,
    /// The diameter of a round shank, where `shank` does not say more.
    pub shank_diameter_mm: Option<f64>,
    /// The shank, from the edges up.
    pub shank: Vec<HolderSegment>,
    /// The holder, from the shank up.
    pub holder: Vec<HolderSegment>,
    /// The insert, blade and holder of a turning tool.
    pub turning: TurningTool,
    /// A name for people, as `roughing end mill`.
    pub description: Option<String>,
    /// Free text.
    pub comment: Option<String>,
}

impl Tool {
    /// The length offset without wear: the geometry along Z, mm.
    pub const fn length_mm(&self) -> Option<f64> {
        self.offset[Axis::Z as usize]
    }

    /// The geometry of an axis with its wear; `None` without geometry.
    pub fn offset_of(&self, axis: usize) -> Option<f64> {
        Some(self.offset[axis]? + self.offset_wear[axis].unwrap_or(0.0))
    }

    /// The radius that cutter compensation takes, wear in it: half the diameter, or the nose of an insert.
    pub fn radius_mm(&self) -> Option<f64> {
        let wear = self.diameter_wear_mm.unwrap_or(0.0);
        match self.diameter_mm {
            Some(diameter) => Some((diameter + wear) / 2.0),
            None => self.nose_radius_mm.map(|nose| nose + wear / 2.0),
        }
    }

    /// The shape with its dimensions; `None` where it is not known or one of them is missing.
    pub fn cutter(&self) -> Option<Cutter<'_>> {
        // Some controls take a negative diameter for the other side; the tool has none.
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

    /// A drill whose point angle nobody gives: the usual one is taken.
    pub fn has_assumed_point_angle(&self) -> bool {
        self.shape == Some(ToolShape::Drill) && self.point_angle_rad.is_none()
    }

    /// The keys of dimensions that the shape needs and that are missing, as a machine file writes them.
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

    /// The diameter of the shank where the edges end.
    fn neck_mm(&self) -> Option<f64> {
        self.shank.first().map(|piece| piece.lower_mm).or(self.shank_diameter_mm)
    }

    /// What a list calls it: its comment, else its description, else its shape.
    pub fn label(&self) -> Option<&str> {
        let shape = || self.shape.map(ToolShape::as_str);
        self.comment.as_deref().or(self.description.as_deref()).or_else(shape)
    }

    /// Takes a free text of what it is: a shape where it says one, else its description. False where it
    /// says none.
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

/// What a tool is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ToolShape {
    /// An end mill with a flat end, or a face mill.
    Flat,
    /// An end mill with a half ball at its end.
    Ball,
    /// An end mill with rounded corners.
    Bull,
    /// A cone that breaks edges.
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
    /// A body of revolution with an outline of its own.
    Form,
    /// A turning insert.
    Insert,
    /// A blade for grooves or for parting off.
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

    /// The word of a machine file.
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

    /// The shape that words of a shop speak of (`FLAT END MILL`, `spot drill`, `5/8 bull nose`).
    /// `None` where they speak of none, or of a tool that has no shape here, as a reamer.
    pub fn from_words(text: &str) -> Option<ToolShape> {
        let text = text.to_ascii_uppercase();
        let words: Vec<&str> = text.split(|c: char| !c.is_ascii_alphanumeric()).collect();
        let has = |word: &str| words.contains(&word);
        let pair = |a: &str, b: &str| words.windows(2).any(|pair| pair == [a, b]);
        let either = |list: &[&str]| list.iter().any(|word| has(word));
        let place = |word: &str| words.iter().position(|own| *own == word).unwrap_or(usize::MAX);
        // The first that fits: a thread mill is no mill, and a ball end mill no flat one.
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
    /// A cone above a flat, which may have no size.
    Chamfer { diameter_mm: f64, tip_diameter_mm: f64, point_angle_rad: f64 },
    /// A point and a cylinder.
    Drill { diameter_mm: f64, point_angle_rad: f64 },
    /// A thread that turns in.
    Tap { diameter_mm: f64, pitch_mm: f64 },
    /// Threads one above the other.
    ThreadMill { diameter_mm: f64, pitch_mm: f64, teeth: u32 },
    /// A disc of a thickness on a neck.
    TSlot { diameter_mm: f64, thickness_mm: f64, neck_mm: f64 },
    /// A ball on a neck.
    Lollipop { diameter_mm: f64, neck_mm: f64 },
    /// An outline: height above the end and radius.
    Form { profile: &'t [[f64; 2]] },
    /// A nose and where the programmed point lies.
    Insert { nose_radius_mm: f64, tip: u32 },
    /// A blade of a width and where its programmed point lies.
    Groove { width_mm: f64, tip: u32 },
}

/// A piece of a shank or holder: a cylinder, or a cone where the diameters differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HolderSegment {
    /// How high it is, mm.
    pub height_mm: f64,
    /// The diameter at its lower end, mm.
    pub lower_mm: f64,
    /// The diameter at its upper end, mm.
    pub upper_mm: f64,
}
