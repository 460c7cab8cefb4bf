//! Turned stock and the passes that cut it.

use chordal_geometry::Vec2;

use super::arrange::{ArrangementResult, NEW, RegionRule, UnlistedEdges, WindingSide};
use super::edge::{Box2, RegionEdge};
use super::hull::DirectionHull;
use super::overlay::{
    AreaAndVolume, OverlayError, OverlayOperands, OverlayScale, OverlayWorkspace,
};
use super::region::{Region, RegionError};
use super::segment::OutlineSegment;
use super::store::EdgeStore;
use super::sweep::{SweptRegion, sweep};
use super::tool::ToolOutline;

/// Why a pass failed. The stock is unchanged.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum PassError {
    /// The path cannot be used.
    #[error(transparent)]
    Path(#[from] RegionError),
    /// A near coincidence between the sweep of the tool and the outline of the stock could not be resolved.
    #[error(transparent)]
    Unresolved(#[from] OverlayError),
}

/// What a tool removes from stock along one move, or would remove.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TurnedPass {
    /// Area removed from the half section, mm².
    pub area: f64,
    /// Removed volume, mm³.
    pub volume: f64,
    /// Extent of the removed material across the feed, mm: the depth of cut. For a straight move it is measured
    /// normal to the move, for an arc along the radius, for a move without length along r.
    pub across: f64,
    /// Extent of the removed material along the feed, mm: the depth of a plunge. For an arc it is measured along the
    /// chord, for a move without length along z.
    pub along: f64,
    /// Whether anything thicker than rounding is removed.
    pub touched: bool,
    /// The corners of the box around the removed material: least z and r, largest z and r, mm; `None` where nothing
    /// is removed.
    pub place: Option<(Vec2, Vec2)>,
    /// Bound of the deviation of the new outline from the exact one, mm, usually 0. It has the bound of the tool;
    /// 1e-11 of the size where the stock has walls thinner than that; and the shift of the sweep where one was needed
    /// to resolve a near coincidence.
    pub bound: f64,
}

impl TurnedPass {
    /// The lesser of the extents along and across the feed, mm: how deep a rapid goes into the stock.
    #[must_use]
    pub fn depth(&self) -> f64 {
        self.along.min(self.across)
    }
}

/// Work space of a pass, reused to save allocations.
#[derive(Debug, Default)]
struct PassWorkspace {
    input: PassInput,
    overlay: OverlayWorkspace,
    outcome: ArrangementResult,
}

/// The operands of a pass: the swept edges, and those of the stock near them.
#[derive(Debug, Default)]
struct PassInput {
    swept: Vec<RegionEdge>,
    hull: DirectionHull,
    near: Vec<RegionEdge>,
    slots: Vec<u32>,
}

/// The edges of the stock that are not among the operands.
struct RemainingRegion<'a> {
    store: &'a EdgeStore,
    without: &'a [u32],
}

impl UnlistedEdges for RemainingRegion<'_> {
    fn passages(&self, side: &WindingSide) -> i32 {
        self.store.passages(side, self.without)
    }
}

/// Turned stock: the exact region of its half section.
#[derive(Debug)]
pub struct LatheStock {
    store: EdgeStore,
    bounds: Box2,
    area: f64,
    size: f64,
    vertices: u64,
    work: PassWorkspace,
}

impl Clone for LatheStock {
    fn clone(&self) -> Self {
        LatheStock { store: self.store.clone(), work: PassWorkspace::default(), ..*self }
    }
}

impl LatheStock {
    /// Stock that fills a region.
    #[must_use]
    pub fn new(region: &Region) -> LatheStock {
        let edges = region.edges();
        let bounds = Box2::around(edges);
        LatheStock {
            store: EdgeStore::of(edges),
            bounds,
            area: region.area(),
            size: bounds.size(),
            // Above all numbers of its vertices.
            vertices: 1 + edges.iter().flat_map(|edge| edge.ends).max().unwrap_or(0),
            work: PassWorkspace::default(),
        }
    }

    /// The region that is left.
    #[must_use]
    pub fn region(&self) -> Region {
        Region::of(self.store.iter().copied().collect())
    }

    /// Area of the half section that is left, mm².
    #[must_use]
    pub fn area(&self) -> f64 {
        self.amounts().area
    }

    /// Volume that is left, mm³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.amounts().volume
    }

    fn amounts(&self) -> AreaAndVolume {
        if self.store.len() == 0 {
            return AreaAndVolume::default();
        }
        let origin = (self.bounds.min + self.bounds.max) * 0.5;
        let edges = self.store.iter();
        edges.fold(AreaAndVolume::default(), |sum, edge| AreaAndVolume {
            area: sum.area + edge.area(origin),
            volume: sum.volume + edge.volume(),
        })
    }

    /// The number of edges that bound it: lines, and arcs within a quadrant.
    #[must_use]
    pub fn edges(&self) -> usize {
        self.store.len()
    }

    /// Removes what a tool sweeps along a move, given as the path of its programmed point: a line or an arc. The new
    /// edges get the tag of the path.
    pub fn cut(
        &mut self,
        tool: &ToolOutline,
        path: &OutlineSegment,
    ) -> Result<TurnedPass, PassError> {
        let mut work = core::mem::take(&mut self.work);
        let found = self.lay(&mut work, tool, path);
        if matches!(&found, Ok(pass) if pass.area > 0.0) {
            self.take(&mut work);
            self.area -= work.overlay.amounts.area;
        }
        self.work = work;
        found
    }

    /// Like [`cut`](Self::cut), and returns what was removed.
    pub fn cut_out(
        &mut self,
        tool: &ToolOutline,
        path: &OutlineSegment,
    ) -> Result<(TurnedPass, Region), PassError> {
        let pass = self.cut(tool, path)?;
        Ok((pass, Region::of(self.work.overlay.common.clone())))
    }

    /// What a tool or holder would remove along a move; the stock stays as it is.
    pub fn touch(
        &self,
        tool: &ToolOutline,
        path: &OutlineSegment,
    ) -> Result<(TurnedPass, Region), PassError> {
        let mut work = PassWorkspace::default();
        let pass = self.lay(&mut work, tool, path)?;
        Ok((pass, Region::of(work.overlay.common)))
    }

    fn lay(
        &self,
        work: &mut PassWorkspace,
        tool: &ToolOutline,
        path: &OutlineSegment,
    ) -> Result<TurnedPass, PassError> {
        let mut pass = TurnedPass { bound: tool.bound(), ..TurnedPass::default() };
        let PassWorkspace { input, overlay, outcome } = work;
        overlay.common.clear();
        let swept = sweep(tool.parts(), path, &mut input.swept)?;
        let scale = OverlayScale::new(self.size, self.area.max(0.0));
        if self.store.len() == 0 || !self.bounds.meets(&swept.bounds.grown(scale.margin)) {
            return Ok(pass);
        }
        input.hull.of(&input.swept, swept.simple);
        self.gather(input, &swept, scale);
        let lay = OverlayWorkspace::lay;
        if self.overlay(input, &swept, scale, overlay, outcome, lay).is_err() {
            let scale = scale.wide();
            self.gather(input, &swept, scale);
            self.overlay(input, &swept, scale, overlay, outcome, OverlayWorkspace::lay_shifted)?;
        }
        let OverlayWorkspace { common, amounts, off, .. } = overlay;
        pass.bound += *off;
        if common.is_empty() {
            return Ok(pass);
        }
        let bounds = Box2::around(common);
        // For a tiny area, rounding may give a negative value.
        (pass.area, pass.volume) = (amounts.area.max(0.0), amounts.volume.max(0.0));
        (pass.across, pass.along) = extents(common, path);
        let around: f64 = common.iter().map(RegionEdge::length).sum();
        pass.touched = amounts.area > scale.tolerance * around;
        pass.place = Some((bounds.min, bounds.max));
        Ok(pass)
    }

    /// Finds the edges of the stock near the swept area.
    fn gather(&self, input: &mut PassInput, swept: &SweptRegion, scale: OverlayScale) {
        let PassInput { hull, near, slots, .. } = input;
        near.clear();
        slots.clear();
        let area = swept.bounds.grown(scale.margin);
        self.store.near(&area, hull, scale.margin, |slot, edge| {
            slots.push(slot);
            near.push(*edge);
        });
    }

    fn overlay(
        &self,
        input: &PassInput,
        swept: &SweptRegion,
        scale: OverlayScale,
        overlay: &mut OverlayWorkspace,
        outcome: &mut ArrangementResult,
        lay: impl Fn(&mut OverlayWorkspace, &OverlayOperands<'_>) -> Result<(), OverlayError>,
    ) -> Result<(), OverlayError> {
        let rest = RemainingRegion { store: &self.store, without: &input.slots };
        let operands = OverlayOperands {
            first: &input.near,
            others: &rest,
            second: &input.swept,
            simple: swept.simple,
            bounds: swept.bounds,
            hull: &input.hull,
            scale,
        };
        lay(overlay, &operands)?;
        if !overlay.common.is_empty() {
            overlay.outcome(&operands, RegionRule::Difference, outcome);
        }
        Ok(())
    }

    /// Replaces edges by the outcome of the last operation.
    fn take(&mut self, work: &mut PassWorkspace) {
        for at in &work.outcome.gone {
            self.store.remove(work.input.slots[*at as usize]);
        }
        let first = self.vertices;
        let mut highest = 0;
        for edge in &work.outcome.came {
            let mut edge = *edge;
            for end in &mut edge.ends {
                if *end & NEW != 0 {
                    let local = *end & !NEW;
                    highest = highest.max(local + 1);
                    *end = first + local;
                }
            }
            self.store.insert(edge);
        }
        self.vertices = first + highest;
        self.store.settle();
    }
}

/// The extents of edges across and along a path, mm.
fn extents(edges: &[RegionEdge], path: &OutlineSegment) -> (f64, f64) {
    let spread = |reach: &dyn Fn(&RegionEdge) -> (f64, f64)| {
        let ends = edges.iter().map(reach);
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |all, one| {
            (all.0.min(one.0), all.1.max(one.1))
        });
        high - low
    };
    let feed = (path.end - path.start).normalized().unwrap_or(Vec2::new(1.0, 0.0));
    let across = match path.bend {
        None => spread(&|edge| edge.reach(feed.turned_left())),
        Some(bend) => spread(&|edge| edge.distances(bend.center)),
    };
    (across, spread(&|edge| edge.reach(feed)))
}
