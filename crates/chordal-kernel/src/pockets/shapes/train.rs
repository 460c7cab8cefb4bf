//! The parallel of an open chain of lines and arcs.

use core::f64::consts::TAU;

use chordal_geometry::Vec2;

use super::outline::{COINCIDENT_POINT_MM, OutlineElement};

/// A path nearer to its contour than the distance by more than this, mm, cuts into it.
const GOUGE_MM: f64 = 1e-5;

/// The tool does not fit at a point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TrainError(pub Vec2);

/// The chain at a distance on the left, on the right for a negative one, mm: outside corners get an arc about them, inside
/// corners the intersection.
///
/// # Errors
/// Where the path would come nearer to the chain than the distance.
pub fn offset_train(
    chain: &[OutlineElement],
    distance: f64,
) -> Result<Vec<OutlineElement>, TrainError> {
    if distance == 0.0 {
        return Ok(chain.to_vec());
    }
    let mut path: Vec<OutlineElement> = Vec::new();
    for element in chain {
        let next = element.moved_left(distance).ok_or(TrainError(element.point(0.5)))?;
        let Some(last) = path.pop() else {
            path.push(next);
            continue;
        };
        path.extend(joined(last, next, element.from(), distance)?);
    }
    check(chain, &path, distance.abs())?;
    Ok(path)
}

/// Two parallels with their corner.
fn joined(
    last: OutlineElement,
    next: OutlineElement,
    corner: Vec2,
    distance: f64,
) -> Result<Vec<OutlineElement>, TrainError> {
    let (from, to) = (last.to(), next.from());
    if from.distance(to) <= COINCIDENT_POINT_MM {
        return Ok(vec![last, next]);
    }
    let (Some(before), Some(after)) = (last.direction(1.0), next.direction(0.0)) else {
        return Err(TrainError(corner));
    };
    if before.cross(after) * distance <= 0.0 {
        let (u, v) = (from - corner, to - corner);
        let angle = libm::atan2(u.cross(v), u.dot(v));
        let sweep = if angle * distance > 0.0 { angle - TAU * distance.signum() } else { angle };
        return Ok(vec![last, OutlineElement::Arc { from, to, center: corner, sweep }, next]);
    }
    let points = last.crossings(&next, COINCIDENT_POINT_MM).into_iter();
    let near = |point: &Vec2| point.distance(corner);
    let point = points.min_by(|a, b| near(a).total_cmp(&near(b))).ok_or(TrainError(corner))?;
    let on = |own: &OutlineElement| own.fraction(point, COINCIDENT_POINT_MM);
    let (t, s) = (on(&last).ok_or(TrainError(corner))?, on(&next).ok_or(TrainError(corner))?);
    Ok(vec![last.part(0.0, t), next.part(s, 1.0)])
}

/// The path keeps its distance everywhere.
fn check(
    chain: &[OutlineElement],
    path: &[OutlineElement],
    distance: f64,
) -> Result<(), TrainError> {
    let points = |own: &OutlineElement| [0.0, 0.25, 0.5, 0.75, 1.0].map(|t| own.point(t));
    let is_near = |point: Vec2, others: &[OutlineElement]| {
        others.iter().any(|other| other.distance(point) < distance - GOUGE_MM)
    };
    for own in path {
        if let Some(point) = points(own).into_iter().find(|point| is_near(*point, chain)) {
            return Err(TrainError(point));
        }
        let crossed = chain.iter().flat_map(|other| own.crossings(other, 0.0)).next();
        if let Some(point) = crossed {
            return Err(TrainError(point));
        }
    }
    for own in chain {
        if let Some(point) = points(own).into_iter().find(|point| is_near(*point, path)) {
            return Err(TrainError(point));
        }
    }
    Ok(())
}
