//! One chart: frame, ticks, curves, limits.

use super::super::palette::Palette;
use super::super::text::{label, push_px, px};
use super::super::view::PixelRect;
use super::buckets::ValueBuckets;

/// A curve of a chart: a value of the cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct ChartSeries {
    /// Its place in a cell.
    pub value: usize,
    /// What it is multiplied by, to be in the unit of the chart.
    pub factor: f64,
    pub color: &'static str,
    /// Units.
    pub stroke: f64,
}

/// What stands along one side of a chart.
#[derive(Clone, Debug)]
pub(super) struct AxisScale {
    pub low: f64,
    pub high: f64,
    step: f64,
    decimals: usize,
}

impl AxisScale {
    /// From low to high in steps of 1, 2 or 5 times a power of ten, about so many; where
    /// `whole`, it ends at full steps.
    pub fn new(low: f64, high: f64, ticks: f64, whole: bool) -> AxisScale {
        let span = if high > low { high - low } else { 1.0 };
        let power = (span / ticks).log10().floor();
        let unit = 10f64.powf(power);
        let step = [1.0, 2.0, 5.0, 10.0]
            .map(|factor| factor * unit)
            .into_iter()
            .find(|step| span / step <= ticks)
            .unwrap_or(10.0 * unit);
        let decimals = (-(step.log10() + 1e-9).floor()).clamp(0.0, 12.0) as usize;
        let (mut low, mut high) = (low, low + span);
        if whole {
            // What is a full step but for rounding stays where it is.
            low = (low / step + 1e-9).floor() * step;
            high = (high / step - 1e-9).ceil() * step;
        }
        AxisScale { low, high, step, decimals }
    }

    /// The places with a number.
    pub fn ticks(&self) -> impl Iterator<Item = f64> {
        let first = (self.low / self.step - 1e-9).ceil() as i64;
        let last = (self.high / self.step + 1e-9).floor() as i64;
        let step = self.step;
        (first..=last.min(first + 200)).map(move |n| n as f64 * step)
    }

    /// A number with commas between the thousands.
    pub fn number(&self, value: f64) -> String {
        let text = label(value, self.decimals);
        let (whole, rest) = match text.find('.') {
            Some(at) => text.split_at(at),
            None => (text.as_str(), ""),
        };
        let digits = whole.chars().filter(char::is_ascii_digit).count();
        let mut out = String::new();
        let mut seen = 0;
        for character in whole.chars() {
            if character.is_ascii_digit() {
                if seen > 0 && (digits - seen).is_multiple_of(3) {
                    out.push(',');
                }
                seen += 1;
            }
            out.push(character);
        }
        out + rest
    }
}

/// A chart on the sheet.
#[derive(Debug)]
pub(super) struct ChartArea {
    pub rect: PixelRect,
    pub x: AxisScale,
    pub y: AxisScale,
    /// px for each unit of the sheet.
    pub unit: f64,
}

impl ChartArea {
    pub fn across(&self, x: f64) -> f64 {
        self.rect.x + self.rect.width * (x - self.x.low) / (self.x.high - self.x.low)
    }

    pub fn down(&self, y: f64) -> f64 {
        self.rect.bottom() - self.rect.height * (y - self.y.low) / (self.y.high - self.y.low)
    }

    /// Ground, grid and numbers.
    pub fn frame(&self, out: &mut String, title: &str, x_unit: &str, colors: &Palette) {
        let PixelRect { x, y, width, height } = self.rect;
        let unit = self.unit;
        out.push_str(&format!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"{}\" \
             stroke-width=\"{}\"/>\n",
            px(x),
            px(y),
            px(width),
            px(height),
            colors.panel,
            colors.border,
            px(unit)
        ));
        let (mut thin, mut zero) = (String::new(), String::new());
        for tick in self.x.ticks() {
            thin.push_str(&format!("M{} {}v{}", px(self.across(tick)), px(y), px(height)));
        }
        for tick in self.y.ticks() {
            let data = if tick == 0.0 { &mut zero } else { &mut thin };
            data.push_str(&format!("M{} {}h{}", px(x), px(self.down(tick)), px(width)));
        }
        for (data, color) in [(thin, colors.grid), (zero, colors.zero)] {
            out.push_str(&format!(
                "<path d=\"{data}\" stroke=\"{color}\" stroke-width=\"{}\" fill=\"none\"/>\n",
                px(unit)
            ));
        }
        for tick in self.y.ticks() {
            let at = (x - 8.0 * unit, self.down(tick) + 4.5 * unit);
            self.text(out, at, "end", colors.faint, &self.y.number(tick));
        }
        for tick in self.x.ticks() {
            let at = (self.across(tick), self.rect.bottom() + 17.0 * unit);
            let text = format!("{} {x_unit}", self.x.number(tick));
            self.text(out, at, "middle", colors.faint, &text);
        }
        out.push_str(&format!(
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\">{title}</text>\n",
            px(x),
            px(y - 8.0 * unit),
            px(15.0 * unit),
            colors.text
        ));
    }

    /// A small text.
    pub fn text(&self, out: &mut String, at: (f64, f64), anchor: &str, color: &str, text: &str) {
        out.push_str(&format!(
            "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{color}\" \
             text-anchor=\"{anchor}\">{text}</text>\n",
            px(at.0),
            px(at.1),
            px(13.0 * self.unit)
        ));
    }

    /// A line at a limit.
    pub fn limit(&self, out: &mut String, value: f64, color: &str) {
        out.push_str(&format!(
            "<path d=\"M{} {}h{}\" stroke=\"{color}\" stroke-width=\"{}\" \
             stroke-dasharray=\"{} {}\" fill=\"none\"/>\n",
            px(self.rect.x),
            px(self.down(value)),
            px(self.rect.width),
            px(1.1 * self.unit),
            px(7.0 * self.unit),
            px(5.0 * self.unit)
        ));
    }

    /// A curve: in each interval down to the least and up to the largest.
    pub fn curve<const N: usize>(
        &self,
        out: &mut String,
        cells: &ValueBuckets<N>,
        x_factor: f64,
        series: &ChartSeries,
    ) {
        let mut data = String::new();
        let mut here = None;
        for (at, cell) in cells.cells() {
            let x = self.across(at * x_factor);
            let low = self.down(cell.low[series.value] * series.factor);
            let high = self.down(cell.high[series.value] * series.factor);
            let from_high = here.is_some_and(|y: f64| (y - high).abs() < (y - low).abs());
            let (first, second) = if from_high { (high, low) } else { (low, high) };
            let flat = (first - second).abs() < 0.3;
            for y in [first, second].into_iter().take(if flat { 1 } else { 2 }) {
                data.push(if here.is_some() { 'L' } else { 'M' });
                push_px(&mut data, x);
                data.push(' ');
                push_px(&mut data, y);
                here = Some(y);
            }
        }
        if !data.is_empty() {
            out.push_str(&format!(
                "<path d=\"{data}\" stroke=\"{}\" stroke-width=\"{}\" fill=\"none\" \
                 stroke-linejoin=\"round\"/>\n",
                series.color,
                px(series.stroke * self.unit)
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_numbers() {
        let texts = |low: f64, high: f64, count: f64| {
            let scale = AxisScale::new(low, high, count, true);
            scale.ticks().map(|tick| scale.number(tick)).collect::<Vec<_>>()
        };
        assert_eq!(texts(0.0, 6000.0, 5.0), ["0", "2,000", "4,000", "6,000"]);
        assert_eq!(texts(-0.9, 0.9, 5.0), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(
            texts(-110_000.0, 110_000.0, 5.0),
            ["−150,000", "−100,000", "−50,000", "0", "50,000", "100,000", "150,000"]
        );
        assert_eq!(texts(0.0, 0.0, 5.0).first().map(String::as_str), Some("0.0"));
    }
}
