//! Free contours (FK): lines and arcs of which each block gives only some values, solved together in closed form.
//!
//! Every element lies on a carrier, an oriented line or circle. Carriers follow from what is known of them and of their
//! neighbours, the points between elements from their carriers; both are found in turn until nothing more follows. Where
//! more than one carrier or point is possible each is followed; what contradicts a value is dropped. FSELECT takes one of
//! the contours that are left at its block; without it none is taken.
//!
//! Words and their meaning: iTNC 530 user's manual 340 49x-03, 6.6 (FK free contour programming); TNC 320 34055x-06 p. 209
//! to 214 (relative data).

mod carrier;
mod chain;
mod check;
mod circles;
mod lines;
mod points;
mod solve;

use chordal_geometry::TurnDirection;

pub use solve::solve_free_contour;

/// The element that a relative value is counted from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FreeReference {
    /// Where the contour begins, and the direction of the element before it.
    Start,
    /// An element before the contour, by its index among those of the request.
    Before(usize),
    /// An element of the contour, by its index.
    Own(usize),
}

/// A coordinate, radius or angle: mm or degrees.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FreeValue {
    /// The number.
    pub value: f64,
    /// The element at whose end it is counted from; `None` for an absolute value.
    pub from: Option<FreeReference>,
}

impl From<f64> for FreeValue {
    fn from(value: f64) -> FreeValue {
        FreeValue { value, from: None }
    }
}

/// What a block says of an element; points on the axes of the plane, mm.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
pub struct FreeElementValues {
    /// The direction of an arc (FC); `None` for a line (FL).
    pub turn: Option<TurnDirection>,
    /// It goes on in the direction of the element before (FLT, FCT).
    pub is_tangent: bool,
    /// FPOL.
    pub pole: Option<[f64; 2]>,
    /// X and Y: its end.
    pub end: [Option<FreeValue>; 2],
    /// PR and PA: the distance of its end from the pole, and its angle there, degrees.
    pub polar: [Option<FreeValue>; 2],
    /// LEN: the length of a line, or of the chord of an arc.
    pub length: Option<f64>,
    /// AN: the angle of a line, or with which an arc begins, degrees.
    pub angle: Option<FreeValue>,
    /// CCX and CCY: the centre of an arc.
    pub center: [Option<FreeValue>; 2],
    /// CCPR and CCPA: the centre of an arc from the pole, the angle in degrees.
    pub center_polar: [Option<FreeValue>; 2],
    /// CCA: the angle of an arc, degrees, without a sign.
    pub center_angle_deg: Option<f64>,
    /// R: the radius of an arc.
    pub radius: Option<f64>,
    /// P1X to P3Y: points on the element, of a line also on its extension.
    pub auxiliary: [Option<[f64; 2]>; 3],
    /// PDX, PDY and D: a point, and its distance from the element.
    pub distance_point: Option<([f64; 2], f64)>,
    /// PAR: the line to which a line is parallel, in its direction or against it.
    pub parallel_to: Option<FreeReference>,
    /// DP: the distance of the two.
    pub parallel_distance: Option<f64>,
}

/// An element that is known before the contour.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KnownElement {
    /// Its start.
    pub start: [f64; 2],
    /// Its end.
    pub end: [f64; 2],
    /// Centre and direction of an arc; `None` for a line.
    pub arc: Option<([f64; 2], TurnDirection)>,
}

/// In which order solutions have their numbers for FSELECT. No manual says it.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub enum FreeSolutionOrder {
    /// First the one that turns least in the programmed DR and at its corners.
    #[default]
    Turning,
    /// First the end further along a line, and a distance point on the left of it.
    Along,
}

/// A free contour that is to be solved; the plane of the tool, mm.
#[derive(Clone, Copy, Debug)]
pub struct FreeContourRequest<'v> {
    /// Its elements.
    pub elements: &'v [FreeElementValues],
    /// Elements before it that its values refer to.
    pub before: &'v [KnownElement],
    /// Where it begins.
    pub start: [f64; 2],
    /// The direction in which the element before it ends.
    pub entry: Option<[f64; 2]>,
    /// FSELECT: the index of the element before it, and the number of the solution, from 1.
    pub selections: &'v [(usize, u32)],
    /// The order of the solutions.
    pub order: FreeSolutionOrder,
    /// How far values may be off each other.
    pub tolerance_mm: f64,
}

/// An element that is solved.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SolvedFreeElement {
    /// Its end.
    pub end: [f64; 2],
    /// The centre of an arc; `None` for a line.
    pub center: Option<[f64; 2]>,
}

/// What is known of an element of one of several contours.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PartlySolvedElement {
    /// Its end.
    pub end: Option<[f64; 2]>,
    /// The centre and the radius of an arc.
    pub circle: Option<([f64; 2], f64)>,
    /// The direction of a line, degrees from 0 to 360.
    pub direction_deg: Option<f64>,
}

/// One of several contours: its number for FSELECT, and its elements.
#[derive(Clone, PartialEq, Debug)]
pub struct NumberedSolution {
    /// The number, from 1.
    pub number: u32,
    /// What is known of its elements, from the first one on in which the contours differ.
    pub elements: Vec<PartlySolvedElement>,
}

/// Several contours that fit the values up to an element.
#[derive(Clone, PartialEq, Debug)]
pub struct ContourChoice {
    /// The element after which FSELECT takes one.
    pub element: usize,
    /// The first element in which they differ.
    pub from: usize,
    /// Those that the values of later elements leave.
    pub solutions: Vec<NumberedSolution>,
}

/// Why a free contour is not solved.
#[derive(Clone, PartialEq, Debug)]
pub enum FreeContourFault {
    /// This element is the first that the values do not determine.
    Undetermined(usize),
    /// The values of this element contradict each other.
    Contradiction(usize),
    /// Several contours fit.
    Ambiguous(ContourChoice),
    /// FSELECT after this element selects a solution that does not exist: its number, and how many there are.
    NoSuchSolution(usize, u32, usize),
    /// More contours fit the values up to this element than are followed.
    TooManySolutions(usize),
}
