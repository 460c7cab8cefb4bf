//! Single views for a page that has a caption and a legend of its own.

use chordal::geometry::Aabb;

use super::Plot;
use super::frame::{self, GridSteps};
use super::layout::single;
use super::palette::Palette;
use super::sheet::{clip, ground, tool_dash, under_path, view};
use super::text::px;
use super::view::{FRONT, ISOMETRIC, SIDE, TOP, TURNED, ViewDirection, ViewPanel};

/// Bytes of path data of a view beyond which it is drawn coarser: a page is mailed and printed.
const MAX_BYTES: usize = 1 << 20;
/// Views of the path that a page may have.
const VIEWS: usize = 4;

/// Where one looks from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Viewpoint {
    /// From above: the XY plane.
    Top,
    /// From the operator's place: the plane of X and Z.
    Front,
    /// From the right: the plane of Y and Z.
    Right,
    /// From the front, the right and above.
    Isometric,
    /// Of a lathe: the axis of the part to the right, X up.
    Turned,
}

impl Viewpoint {
    fn view(self) -> ViewDirection {
        match self {
            Viewpoint::Top => TOP,
            Viewpoint::Front => FRONT,
            Viewpoint::Right => SIDE,
            Viewpoint::Isometric => ISOMETRIC,
            Viewpoint::Turned => TURNED,
        }
    }
}

/// A view of the path.
#[derive(Clone, Debug, PartialEq)]
pub struct PageView {
    /// The drawing. Its colours are names, which [`Plot::page_colors`] explains; an id in it is
    /// another one in each view.
    pub svg: String,
    /// The step of its grid, as `10 mm`.
    pub grid: String,
}

/// A view that is begun.
struct OpenPanel {
    svg: String,
    panel: ViewPanel,
    /// The step of its grid.
    grid: String,
    unit: f64,
}

/// A tool as the drawings show it.
#[derive(Clone, Debug, PartialEq)]
pub struct PageTool {
    /// Its number; 0 before any tool was changed.
    pub number: u32,
    /// A line as its cuts are drawn, as SVG.
    pub sign: String,
}

impl Plot {
    /// One view as SVG for a page; `None` where there is nothing to draw. Sides below 200 px are
    /// drawn as 200.
    pub fn page_view(&self, from: Viewpoint, width_px: u32, height_px: u32) -> Option<PageView> {
        let turned = self.turned.as_ref().filter(|_| from == Viewpoint::Turned);
        let (bounds, index) = (self.store.extent()?, from as usize);
        let bounds = turned.map_or(bounds, |turned| turned.around(bounds));
        let OpenPanel { mut svg, panel, grid, unit } =
            self.opened(from, [width_px, height_px], &bounds, (index, "Path of the tool"));
        if let Some(turned) = turned {
            under_path(&mut svg, &turned.svg(&panel, unit, Palette::page()), index);
        }
        view(&mut svg, &self.store, &panel, index, unit, MAX_BYTES, Palette::page());
        svg.push_str("</svg>\n");
        Some(PageView { svg, grid })
    }

    /// The stock alone, without the path; `None` where there is none.
    pub fn page_stock(&self, from: Viewpoint, width_px: u32, height_px: u32) -> Option<PageView> {
        let stock = self.store.stock.as_ref()?;
        // Ids of its own: the views of the path may stand on the same page.
        let index = VIEWS + from as usize;
        let OpenPanel { mut svg, panel, grid, unit } = self.opened(
            from,
            [width_px, height_px],
            &stock.bounds(),
            (index, "Stock that is left"),
        );
        frame::over(&mut svg, &panel, unit, Palette::page());
        svg.push_str("</svg>\n");
        Some(PageView { svg, grid })
    }

    /// A view with its ground and the stock.
    fn opened(
        &self,
        from: Viewpoint,
        [width_px, height_px]: [u32; 2],
        bounds: &Aabb,
        (index, what): (usize, &str),
    ) -> OpenPanel {
        let (width, height) = (f64::from(width_px.max(200)), f64::from(height_px.max(200)));
        let (unit, colors) = (1.0, Palette::page());
        let panel = single(from.view(), width, height, bounds, unit);
        let grid = GridSteps::new(&panel, unit, self.inch, bounds);
        let mut svg = format!(
            "<svg viewBox=\"0 0 {} {}\" role=\"img\" \
             aria-label=\"{what}, {}\"><defs>",
            px(width),
            px(height),
            panel.view.title.to_lowercase()
        );
        clip(&mut svg, &panel, index);
        svg.push_str("</defs>\n");
        ground(&mut svg, &panel, index, &grid, bounds, unit, colors);
        let stock = self.store.stock.as_ref().and_then(|stock| stock.draw(&panel, false));
        svg.extend(stock.map(|drawn| drawn.svg()));
        OpenPanel { svg, panel, grid: grid.text(), unit }
    }

    /// The tools that cut, in the order of their first use.
    pub fn page_tools(&self) -> Vec<PageTool> {
        let colors = Palette::page();
        let tools = self.store.tools().iter().enumerate();
        tools
            .map(|(index, tool)| PageTool {
                number: tool.number,
                sign: format!(
                    "<svg viewBox=\"0 0 28 8\" width=\"28\" \
                     height=\"8\" aria-hidden=\"true\"><path d=\"M0 4h28\" stroke=\"{}\" \
                     stroke-width=\"4\"{}/></svg>",
                    colors.tool(index),
                    tool_dash(colors, index, 1.0)
                ),
            })
            .collect()
    }

    /// True when cuts came whose place is not known, and which are not drawn.
    pub fn leaves_out_cuts(&self) -> bool {
        self.store.has_unknown()
    }

    /// What is said of axes that the program does not name, and that are drawn at zero, and of moves that are left out for
    /// their work offset.
    pub fn remarks(&self) -> Vec<String> {
        self.store.remarks()
    }

    /// The colours of [`Plot::page_view`] on a light or a dark page, as CSS declarations.
    pub fn page_colors(dark: bool) -> String {
        Palette::declarations(dark)
    }
}
