//! Elements of contours, approaches and departures, as pure functions on points of a plane, mm.

mod approach;
mod element;
mod free_contour;
mod vectors;

pub use approach::{
    ApproachArc, ApproachFault, ApproachPath, ApproachRequest, approach_path, departure_path,
};
pub use element::{ContourElement, arc_about, arc_by_radius, arc_fault_mm, tangent_center};
pub use free_contour::{
    ContourChoice, FreeContourFault, FreeContourRequest, FreeElementValues, FreeReference,
    FreeSolutionOrder, FreeValue, KnownElement, NumberedSolution, PartlySolvedElement,
    SolvedFreeElement, solve_free_contour,
};
pub use vectors::{COINCIDENT_POINTS_MM, turned_about};
