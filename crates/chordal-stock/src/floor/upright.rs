//! The lowest point of a flat or a ball cutter over a column along an arc in a vertical plane.
//!
//! In the plane of the arc the tip is at X + A·cos θ, Z + A·sin θ; the column is at the distance b from X along the
//! plane and e from the plane. A flat is lowest at the lowest point of the arc within its radius. The section of a
//! ball at e is a circle of radius q = √(R² − e²): it is lowest over the column where cos θ = b/(A + q) in a valley
//! and b/(A − q) on a hill. Other rings have no closed form here.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_geometry::{Arc, Vec3};
use libm::{acos, atan2, sincos};

use super::profile::{LowestOffer, PushedProfile};
use super::straight::chord;
use crate::cutter::RingElement;

/// An arc in a vertical plane; its parameter is the angle travelled, from 0 to `sweep`.
#[derive(Clone, Copy, Debug)]
pub(super) struct VerticalArc {
    center: Vec3,
    /// Unit vector of the plane in plan.
    direction: [f64; 2],
    radius: f64,
    /// θ at the start.
    first: f64,
    /// 1 where θ grows along the path, −1 where it falls.
    turn: f64,
    /// Radians, above zero.
    sweep: f64,
}

impl VerticalArc {
    /// The path of an arc about a horizontal axis, without a rise. `None` where its axis has no direction in plan.
    pub(super) fn new(arc: &Arc) -> Option<VerticalArc> {
        let across = Vec3::new(arc.w.x, arc.w.y, 0.0).normalized()?;
        // Turned about the axis by a quarter, this points up.
        let direction = [-across.y, across.x];
        let first = atan2(arc.u.z, arc.u.x * direction[0] + arc.u.y * direction[1]);
        let turn = arc.sweep.signum();
        let (center, radius) = (arc.center, arc.radius);
        Some(VerticalArc { center, direction, radius, first, turn, sweep: arc.sweep.abs() })
    }

    pub(super) const fn sweep(&self) -> f64 {
        self.sweep
    }

    /// Whether [`VerticalArc::lowest`] has a closed form for a cutter.
    pub(super) fn is_closed_for(profile: PushedProfile) -> bool {
        profile.rings().all(|ring| match ring.element {
            RingElement::Disc { .. } => true,
            RingElement::Cone { .. } => false,
            RingElement::Torus { middle, .. } => middle == 0.0,
        })
    }

    /// The distances of a column from the centre along the plane, and from the plane, mm.
    fn seen_from(&self, place: [f64; 2]) -> (f64, f64) {
        let [dx, dy] = self.direction;
        let [x, y] = [place[0] - self.center.x, place[1] - self.center.y];
        (x * dx + y * dy, (x * dy - y * dx).abs())
    }

    fn theta(&self, angle: f64) -> f64 {
        self.first + self.turn * angle
    }

    /// Emits the angles travelled within a range at which the path is at θ.
    fn each_at(&self, theta: f64, [from, to]: [f64; 2], push: &mut dyn FnMut(f64)) {
        let once = self.turn * (theta - self.first);
        let first = ((from - once) / TAU).ceil() as i64;
        let last = ((to - once) / TAU).floor() as i64;
        for turns in first..=last {
            push(once + TAU * turns as f64);
        }
    }

    /// Emits the ranges of the angle in which the axis is within a radius of the column, in order.
    pub(super) fn windows(&self, place: [f64; 2], radius: f64, push: &mut dyn FnMut([f64; 2])) {
        let (along, aside) = self.seen_from(place);
        let Some(half) = chord(radius, aside) else { return };
        let (right, left) = ((along + half) / self.radius, (along - half) / self.radius);
        if left > 1.0 || right < -1.0 {
            return;
        }
        // |θ| is between these two.
        let (near, far) = (acos(right.min(1.0)), acos(left.max(-1.0)));
        if near <= 0.0 && far >= PI {
            push([0.0, self.sweep]);
            return;
        }
        let middles = if near <= 0.0 {
            vec![(0.0, far)]
        } else if far >= PI {
            vec![(PI, PI - near)]
        } else {
            let half = 0.5 * (far - near);
            vec![(0.5 * (near + far), half), (-0.5 * (near + far), half)]
        };
        let mut found = Vec::new();
        for (theta, reach) in middles {
            self.each_at(theta, [-reach, self.sweep + reach], &mut |angle| {
                found.push([(angle - reach).max(0.0), (angle + reach).min(self.sweep)]);
            });
        }
        found.retain(|range| range[0] <= range[1]);
        found.sort_by(|a, b| a[0].total_cmp(&b[0]));
        found.into_iter().for_each(push);
    }

    /// The lowest point over a column within a range of the angle throughout which the cutter is over it.
    pub(super) fn lowest(
        &self,
        profile: PushedProfile,
        place: [f64; 2],
        range: [f64; 2],
    ) -> Option<LowestOffer> {
        let (along, aside) = self.seen_from(place);
        let mut low = LowestOffer::NONE;
        let distance = |theta: f64| {
            let w = self.radius * sincos(theta).1 - along;
            (w * w + aside * aside).sqrt()
        };
        let height = |theta: f64| self.center.z + self.radius * sincos(theta).0;
        // Both ends are within the radius, up to rounding.
        for end in range {
            let theta = self.theta(end);
            let reached = distance(theta).min(profile.radius());
            low.offer(height(theta) + profile.height_at(reached), end);
        }
        for ring in profile.rings() {
            let Some(outer) = chord(ring.to, aside) else { continue };
            let inner = chord(ring.from, aside).unwrap_or(0.0);
            // The boundaries of the ring on both sides; further below, the stationary points of the height.
            let edges = [along + outer, along - outer, along + inner, along - inner];
            let offer = |theta: f64, low: &mut LowestOffer| {
                self.each_at(theta, range, &mut |at| {
                    let far = distance(theta);
                    // A boundary is on the ring, up to rounding.
                    let rounding = ROUNDING_SHARE * (self.radius + along.abs() + ring.to);
                    if ring.from - rounding <= far && far <= ring.to + rounding {
                        let reached = far.clamp(ring.from, ring.to);
                        low.offer(height(theta) + ring.height_at(reached), at);
                    }
                });
            };
            for edge in edges {
                let cosine = edge / self.radius;
                if cosine.abs() <= 1.0 {
                    let theta = acos(cosine);
                    offer(theta, &mut low);
                    offer(-theta, &mut low);
                }
            }
            match ring.element {
                RingElement::Torus { round, .. } => {
                    let q = chord(round, aside).unwrap_or(0.0);
                    let valley = along / (self.radius + q);
                    if valley.abs() <= 1.0 {
                        offer(-acos(valley), &mut low);
                    }
                    let hill = along / (self.radius - q);
                    if hill.abs() <= 1.0 {
                        offer(acos(hill), &mut low);
                    }
                }
                RingElement::Disc { .. } | RingElement::Cone { .. } => offer(-FRAC_PI_2, &mut low),
            }
        }
        low.found()
    }
}

/// Rounding error of a distance, as a share of the lengths from which it was computed.
const ROUNDING_SHARE: f64 = 1e-14;
