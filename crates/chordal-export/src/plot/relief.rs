//! The stock that is left, shaded, as it lies under the path in a view.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use chordal::geometry::{Aabb, Vec3};
use chordal::stock::StockReport;
use chordal::stock::mesh::Mesh;
use resvg::tiny_skia::{Pixmap, PixmapPaint, PremultipliedColorU8, Transform};

use super::depths::DepthBuffer;
use super::text::px;
use super::view::{PixelRect, ViewPanel};

/// Tops and undersides are joined that differ by no more than this share of a column.
const JOINED: f64 = 0.1;

/// Pixels of the picture for each of the sheet, along a side: edges are not jagged in print.
const OVERSAMPLING: f64 = 2.0;
/// The longest side of a picture, px.
const MAX_SIDE_PX: f64 = 4096.0;
/// Light on the sheet: to the right, up and towards the eye; from the upper left.
const LIGHT: Vec3 = Vec3::new(-0.4, 0.55, 0.73);
/// What is left of the colour where no light falls, and on the lowest place.
const AMBIENT: f64 = 0.45;
const DEEP: f64 = 0.8;
/// The colour of stock: pale, so that the path on it is seen.
const LIGHT_STOCK: Vec3 = Vec3::new(226.0, 222.0, 212.0);
const DARK_STOCK: Vec3 = Vec3::new(112.0, 116.0, 122.0);

/// The surface of a stock: corners in the middle of columns, and a ring at the bottom around them, which makes
/// the walls.
#[derive(Debug)]
pub(super) struct StockRelief {
    bounds: Aabb,
    /// Where the corners are, mm.
    x: Vec<f64>,
    y: Vec<f64>,
    /// Their heights, row by row, mm.
    z: Vec<f64>,
    lowest: f64,
    /// The side of a column, mm.
    column: f64,
    /// Where the surface has undersides it is drawn as triangles.
    solid: Option<Mesh>,
}

impl StockRelief {
    /// Of what is left: the height in the middle of each column.
    pub fn of(found: &StockReport) -> StockRelief {
        let grid = found.stock.grid();
        let bounds = grid.bounds();
        let [columns, rows] = grid.cells().map(|cells| cells as usize);
        let along = |low: f64, high: f64, count: usize| -> Vec<f64> {
            let inside = |at: usize| low + (at as f64 - 0.5) * grid.resolution();
            let place = |at: usize| match at {
                0 | 1 => low,
                _ if at >= count => high,
                _ => inside(at),
            };
            (0..count + 2).map(place).collect()
        };
        let bottom = bounds.min.z;
        let width = columns + 2;
        let mut z = vec![bottom; width * (rows + 2)];
        let mut lowest = bounds.max.z;
        for (index, &height) in found.tops().iter().enumerate() {
            let (column, row) = (index % columns, index / columns);
            z[(row + 1) * width + column + 1] = height;
            if height > bottom {
                lowest = lowest.min(height);
            }
        }
        let x = along(bounds.min.x, bounds.max.x, columns);
        let y = along(bounds.min.y, bounds.max.y, rows);
        let surface = found.has_undersides().then(|| {
            // Without one the tops alone are drawn.
            found.surface(JOINED * grid.resolution()).ok()
        });
        let solid = surface.flatten().map(|surface| surface.mesh);
        StockRelief { bounds, x, y, z, lowest, column: grid.resolution(), solid }
    }

    /// The box of the stock before the first cut.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn corner(&self, column: usize, row: usize) -> Vec3 {
        Vec3::new(self.x[column], self.y[row], self.z[row * self.x.len() + column])
    }

    /// Across the surface at a corner, out of the material.
    fn normal(&self, column: usize, row: usize) -> Vec3 {
        let last = [self.x.len() - 1, self.y.len() - 1];
        let [left, right] = [column.saturating_sub(1), (column + 1).min(last[0])];
        let [below, above] = [row.saturating_sub(1), (row + 1).min(last[1])];
        let along = self.corner(right, row) - self.corner(left, row);
        let up = self.corner(column, above) - self.corner(column, below);
        // Where the ring is at the edge, too, the surface is upright.
        let slope = |rise: f64, run: f64| rise / run.max(1e-3 * (rise.abs() + 1e-9));
        Vec3::new(-slope(along.z, along.x), -slope(up.z, up.y), 1.0).normalized().unwrap_or(Vec3::Z)
    }

    /// Draws the tops of the columns, with walls between them.
    fn draw_tops(
        &self,
        canvas: &mut ReliefCanvas,
        corner: &impl Fn(Vec3, Vec3) -> ReliefVertex,
        shade: &impl Fn(Vec3, f64) -> Vec3,
    ) {
        let columns = self.x.len();
        let rows: Vec<Vec<ReliefVertex>> = (0..self.y.len())
            .map(|row| {
                let corner =
                    |column: usize| corner(self.corner(column, row), self.normal(column, row));
                (0..columns).map(corner).collect()
            })
            .collect();
        for pair in rows.windows(2) {
            for column in 0..columns - 1 {
                let [a, b] = [&pair[0][column], &pair[0][column + 1]];
                let [c, d] = [&pair[1][column], &pair[1][column + 1]];
                // Along the diagonal that is less steep: walls are straight then.
                let rise = |a: &ReliefVertex, b: &ReliefVertex| (a.near - b.near).abs();
                let triangles = if rise(a, d) > rise(b, c) {
                    [[a, b, c], [b, d, c]]
                } else {
                    [[a, b, d], [a, d, c]]
                };
                for corners in triangles {
                    if !corners.iter().all(|corner| corner.is_empty) {
                        canvas.triangle(corners, shade);
                    }
                }
            }
        }
    }

    /// Draws it as a panel sees it; `None` where the panel has no size.
    pub fn draw(&self, panel: &ViewPanel, dark: bool) -> Option<DrawnRelief> {
        let PixelRect { width, height, .. } = panel.rect;
        let fine = OVERSAMPLING.min(MAX_SIDE_PX / width.max(height));
        let size = |length: f64| (length * fine).ceil().max(1.0) as u32;
        let mut canvas = ReliefCanvas::new(size(width), size(height));
        let base = if dark { DARK_STOCK } else { LIGHT_STOCK };
        let eye = panel.view.eye();
        let light = panel.view.right * LIGHT.x + panel.view.up * LIGHT.y + eye * LIGHT.z;
        let span = (self.bounds.max.z - self.lowest).max(1e-9);
        let shade = |normal: Vec3, tone: f64| {
            let lit = normal.normalized().map_or(0.0, |normal| normal.dot(light)).max(0.0);
            base * (tone * (AMBIENT + (1.0 - AMBIENT) * lit / LIGHT.z).min(1.08))
        };
        let corner = |at: Vec3, normal: Vec3| {
            let (x, y) = panel.place(at);
            let deep = ((self.bounds.max.z - at.z) / span).clamp(0.0, 1.0);
            ReliefVertex {
                x: (x - panel.rect.x) * fine,
                y: (y - panel.rect.y) * fine,
                near: eye.dot(at),
                normal,
                tone: 1.0 - (1.0 - DEEP) * deep,
                is_empty: at.z <= self.bounds.min.z,
            }
        };
        match &self.solid {
            Some(mesh) => draw_solid(mesh, self.column, panel, &mut canvas, &corner, base),
            None => self.draw_tops(&mut canvas, &corner, &shade),
        }
        Some(DrawnRelief { rect: panel.rect, fine, pixmap: canvas.into_pixmap()? })
    }
}

/// Draws triangles, with the light of the slope that steps of columns make together.
fn draw_solid(
    mesh: &Mesh,
    column: f64,
    panel: &ViewPanel,
    canvas: &mut ReliefCanvas,
    corner: &impl Fn(Vec3, Vec3) -> ReliefVertex,
    base: Vec3,
) {
    let eye = panel.view.eye();
    for triangle in 0..mesh.triangles().len() {
        let [a, b, c] = mesh.corners(triangle);
        if (b - a).cross(c - a).dot(eye) > 0.0 {
            let [a, b, c] = [a, b, c].map(|at| corner(at, eye));
            canvas.triangle([&a, &b, &c], &|_, _| base);
        }
    }
    let [from, to] = [Vec3::ZERO, panel.view.right].map(|at| corner(at, eye));
    let (near, width) = (&canvas.near, canvas.width as usize);
    let pixel = 1.0 / (to.x - from.x).abs();
    let normals = DepthBuffer { near, width, column, pixel }.normals();
    let some = || near.iter().copied().filter(|near| near.is_finite());
    let (nearest, farthest) =
        (some().fold(f64::NEG_INFINITY, f64::max), some().fold(f64::INFINITY, f64::min));
    for ((color, near), normal) in canvas.color.iter_mut().zip(near).zip(normals) {
        let deep = (nearest - near) / (nearest - farthest).max(1e-9);
        let lit = normal.dot(LIGHT).max(0.0) / LIGHT.z;
        let tone = (1.0 - (1.0 - DEEP) * deep.clamp(0.0, 1.0)) * (AMBIENT + (1.0 - AMBIENT) * lit);
        let own = base * tone.min(1.08);
        *color = [own.x, own.y, own.z].map(|part| part.clamp(0.0, 255.0) as u8);
    }
}

struct ReliefVertex {
    x: f64,
    y: f64,
    /// How near to the eye, mm.
    near: f64,
    normal: Vec3,
    tone: f64,
    /// No stock is left there.
    is_empty: bool,
}

/// Pixels with how near to the eye they are.
struct ReliefCanvas {
    width: u32,
    height: u32,
    near: Vec<f64>,
    color: Vec<[u8; 3]>,
}

impl ReliefCanvas {
    fn new(width: u32, height: u32) -> ReliefCanvas {
        let count = width as usize * height as usize;
        ReliefCanvas {
            width,
            height,
            near: vec![f64::NEG_INFINITY; count],
            color: vec![[0; 3]; count],
        }
    }

    fn triangle(&mut self, [a, b, c]: [&ReliefVertex; 3], shade: &impl Fn(Vec3, f64) -> Vec3) {
        let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if area.is_nan() || area.abs() <= 1e-9 {
            return;
        }
        let least = |of: fn(&ReliefVertex) -> f64| of(a).min(of(b)).min(of(c));
        let most = |of: fn(&ReliefVertex) -> f64| of(a).max(of(b)).max(of(c));
        let range = |low: f64, high: f64, count: u32| {
            let from = (low - 0.5).ceil().max(0.0) as u32;
            let to = ((high - 0.5).floor() + 1.0).clamp(0.0, f64::from(count)) as u32;
            from..to
        };
        for y in range(least(|at| at.y), most(|at| at.y), self.height) {
            for x in range(least(|at| at.x), most(|at| at.x), self.width) {
                let (px, py) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
                let part = |from: &ReliefVertex, to: &ReliefVertex| {
                    ((to.x - from.x) * (py - from.y) - (px - from.x) * (to.y - from.y)) / area
                };
                let [u, v, w] = [part(b, c), part(c, a), part(a, b)];
                // A little over the edges: no pixel between two triangles is missed.
                if u.min(v).min(w) < -1e-6 {
                    continue;
                }
                let at = y as usize * self.width as usize + x as usize;
                let near = u * a.near + v * b.near + w * c.near;
                if near <= self.near[at] {
                    continue;
                }
                self.near[at] = near;
                let normal = a.normal * u + b.normal * v + c.normal * w;
                let color = shade(normal, u * a.tone + v * b.tone + w * c.tone);
                self.color[at] =
                    [color.x, color.y, color.z].map(|part| part.clamp(0.0, 255.0) as u8);
            }
        }
    }

    fn into_pixmap(self) -> Option<Pixmap> {
        let mut pixmap = Pixmap::new(self.width, self.height)?;
        for ((pixel, near), [red, green, blue]) in
            pixmap.pixels_mut().iter_mut().zip(&self.near).zip(&self.color)
        {
            if *near > f64::NEG_INFINITY {
                *pixel = PremultipliedColorU8::from_rgba(*red, *green, *blue, 255)?;
            }
        }
        Some(pixmap)
    }
}

/// A picture of the stock in its place on the sheet.
pub(super) struct DrawnRelief {
    rect: PixelRect,
    fine: f64,
    pixmap: Pixmap,
}

impl DrawnRelief {
    /// As an element of an SVG; nothing where it cannot be written.
    pub fn svg(&self) -> String {
        let Ok(png) = self.pixmap.encode_png() else { return String::new() };
        format!(
            "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
             href=\"data:image/png;base64,{}\"/>\n",
            px(self.rect.x),
            px(self.rect.y),
            px(f64::from(self.pixmap.width()) / self.fine),
            px(f64::from(self.pixmap.height()) / self.fine),
            STANDARD.encode(png)
        )
    }

    /// Onto a sheet of pixels.
    pub fn paint(&self, sheet: &mut Pixmap) {
        let small = 1.0 / self.fine as f32;
        let place =
            Transform::from_row(small, 0.0, 0.0, small, self.rect.x as f32, self.rect.y as f32);
        let paint = PixmapPaint {
            quality: resvg::tiny_skia::FilterQuality::Bilinear,
            ..PixmapPaint::default()
        };
        sheet.draw_pixmap(0, 0, self.pixmap.as_ref(), &paint, place, None);
    }
}
