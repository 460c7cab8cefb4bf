//! Divides the surface of a cutter into patches: rings along the outline, each divided around the axis.

use std::f64::consts::{FRAC_PI_2, PI};

use libm::{asin, atan2, sincos};

use crate::cutter::{CutterProfile, Ring, RingElement};

/// Least and largest number of patches around the side of a cutter. More than 720, half a degree each, are finer than
/// cells of the usual sizes.
const AROUND_SIDE: [f64; 2] = [48.0, 720.0];
/// The same for its end.
const AROUND_END: [f64; 2] = [24.0, 128.0];
/// Most rings along the outline of its end.
const MAX_RINGS: f64 = 24.0;

/// A ring of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PatchBand {
    /// Radii, mm.
    pub radii: [f64; 2],
    /// Heights above the tip, mm.
    pub heights: [f64; 2],
    /// Its length along the outline, mm.
    pub length: f64,
    /// Sine and cosine of the angle between the outward normal and −Z, at both radii.
    pub normals: [[f64; 2]; 2],
    /// By how much u·n between the radii may exceed its values at them.
    pub bow: f64,
    /// True for the side, a wall from its height upwards.
    pub is_side: bool,
}

/// The surface of a cutter.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CutterPatches {
    pub end: Vec<PatchBand>,
    pub side: PatchBand,
    /// The directions of the middles of patches around the axis, as sine and cosine of the angle from the feed.
    pub around_end: Vec<[f64; 2]>,
    pub around_side: Vec<[f64; 2]>,
    /// The upper end of the edges above the tip, mm.
    pub flutes: f64,
}

impl CutterPatches {
    pub fn new(cutter: &CutterProfile, resolution: f64) -> CutterPatches {
        let radius = cutter.radius();
        let count = |[least, most]: [f64; 2], width: f64| {
            // A multiple of four, so that patch borders are along the feed and across it.
            4 * (PI * radius / (2.0 * width)).ceil().clamp(least / 4.0, most / 4.0) as usize
        };
        let edges = cutter.edges();
        let outline: f64 = edges.iter().map(length).sum();
        let width = resolution.max(outline / MAX_RINGS);
        let mut end = Vec::new();
        for ring in edges.iter() {
            let rings = (length(ring) / width).ceil().max(1.0) as usize;
            end.extend(
                (0..rings)
                    .map(|k| band(ring, k as f64 / rings as f64, (k + 1) as f64 / rings as f64)),
            );
        }
        let flutes = cutter.flutes().unwrap_or(f64::INFINITY);
        let side = PatchBand {
            radii: [radius; 2],
            heights: [cutter.side().min(flutes); 2],
            length: 0.0,
            normals: [[1.0, 0.0]; 2],
            bow: 0.0,
            is_side: true,
        };
        CutterPatches {
            end,
            side,
            around_end: around(count(AROUND_END, width)),
            around_side: around(count(AROUND_SIDE, resolution)),
            flutes,
        }
    }
}

/// The middles of equal steps around the axis.
fn around(count: usize) -> Vec<[f64; 2]> {
    let step = 2.0 * PI / count as f64;
    (0..count)
        .map(|k| {
            let (sine, cosine) = sincos(step * (k as f64 + 0.5) - PI);
            [sine, cosine]
        })
        .collect()
}

/// The angle between the normal of a torus at a radius and −Z, rad.
fn slant(round: f64, middle: f64, radius: f64) -> f64 {
    asin(((radius - middle) / round).clamp(0.0, 1.0))
}

/// The length of a ring along its outline, mm.
fn length(ring: &Ring) -> f64 {
    match ring.element {
        RingElement::Disc { .. } => ring.to - ring.from,
        RingElement::Cone { slope, .. } => (ring.to - ring.from) * (1.0 + slope * slope).sqrt(),
        RingElement::Torus { round, middle, .. } => {
            round * (slant(round, middle, ring.to) - slant(round, middle, ring.from))
        }
    }
}

/// The part of a ring between two shares of its outline.
fn band(ring: &Ring, from: f64, to: f64) -> PatchBand {
    let along = |share: f64| ring.from + (ring.to - ring.from) * share;
    let (radii, slants) = match ring.element {
        RingElement::Disc { .. } => ([along(from), along(to)], [0.0; 2]),
        RingElement::Cone { slope, .. } => ([along(from), along(to)], [atan2(slope, 1.0); 2]),
        RingElement::Torus { round, middle, .. } => {
            let [first, last] = [ring.from, ring.to].map(|radius| slant(round, middle, radius));
            let slants = [from, to].map(|share| first + (last - first) * share);
            (slants.map(|slant| middle + round * sincos(slant).0), slants)
        }
    };
    let heights = radii.map(|radius| ring.height_at(radius.clamp(ring.from, ring.to)));
    let angle = (slants[1] - slants[0]).clamp(0.0, FRAC_PI_2);
    PatchBand {
        radii,
        heights,
        length: length(ring) * (to - from),
        normals: slants.map(|slant| {
            let (sine, cosine) = sincos(slant);
            [sine, cosine]
        }),
        // A sine exceeds its chord by at most this.
        bow: angle * angle / 8.0,
        is_side: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patches_have_the_area_of_the_cutter() {
        // Half a ball: 2πR²; a point of 90 degrees: πR²·√2.
        for (cutter, area) in [
            (CutterProfile::ball(6.0).unwrap(), 2.0 * PI * 9.0),
            (CutterProfile::pointed(8.0, 0.0, FRAC_PI_2).unwrap(), PI * 16.0 * 2.0_f64.sqrt()),
            (CutterProfile::flat(10.0).unwrap(), PI * 25.0),
        ] {
            let patches = CutterPatches::new(&cutter, 0.05);
            let sum: f64 = patches
                .end
                .iter()
                .map(|band| PI * (band.radii[0] + band.radii[1]) * band.length)
                .sum();
            assert!((sum / area - 1.0).abs() < 2e-3, "{sum} {area}");
            let last = patches.end.last().unwrap();
            assert!((last.radii[1] - cutter.radius()).abs() < 1e-12);
            assert!((last.heights[1] - cutter.side()).abs() < 1e-9);
        }
    }
}
