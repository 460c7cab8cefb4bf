//! Colours of the two sheets, and of the page of `chordal view`, which shows the same ones.

use std::fmt::Write;

/// The colours of a sheet.
#[derive(Debug)]
pub(super) struct Palette {
    pub sheet: &'static str,
    pub panel: &'static str,
    pub border: &'static str,
    pub grid: &'static str,
    pub zero: &'static str,
    pub text: &'static str,
    pub faint: &'static str,
    pub rapid: &'static str,
    pub start: &'static str,
    tools: [&'static str; TOOLS],
    /// From the least to the most, of a feed or a height: from one lightness to another, so that the order
    /// shows without colours, too.
    ramp: [&'static str; 5],
}

/// Tools that have a colour of their own.
const TOOLS: usize = 10;

/// One of each family of hues, with the lightness of each chosen so that any two stay apart for those
/// who do not see red, green or blue, and each from the sheet and the rapids. The tests of the page
/// measure it.
static LIGHT: Palette = Palette {
    sheet: "#ffffff",
    panel: "#fcfcfb",
    border: "#b9bdc3",
    grid: "#e9eaec",
    zero: "#c9cdd3",
    text: "#1d2227",
    faint: "#68707a",
    rapid: "#8d949c",
    start: "#1d2227",
    tools: [
        "#0096ff", "#ff5a00", "#780096", "#2da55a", "#87000f", "#007887", "#ff1ee1", "#875a00",
        "#0000e1", "#3c3c4b",
    ],
    ramp: ["#1c0055", "#46218f", "#7a3fae", "#c0568f", "#e8730c"],
};

static DARK: Palette = Palette {
    sheet: "#14171b",
    panel: "#191d22",
    border: "#444b55",
    grid: "#262b32",
    zero: "#434b56",
    text: "#e6e9ec",
    faint: "#98a1ab",
    rapid: "#7b8590",
    start: "#ffffff",
    tools: [
        "#0069b4", "#f09600", "#9600ff", "#87ff00", "#ff1e69", "#4bc3b4", "#ffa5ff", "#78690f",
        "#8787ff", "#e1e1d2",
    ],
    ramp: ["#6a5acd", "#a65fd0", "#e56fae", "#ffa07a", "#fff3a0"],
};

/// Names for the page that the drawing stands in, which gives each its colour.
static PAGE: Palette = Palette {
    sheet: "var(--plot-sheet)",
    panel: "var(--plot-panel)",
    border: "var(--plot-border)",
    grid: "var(--plot-grid)",
    zero: "var(--plot-zero)",
    text: "var(--plot-text)",
    faint: "var(--plot-faint)",
    rapid: "var(--plot-rapid)",
    start: "var(--plot-start)",
    tools: [
        "var(--plot-tool-1)",
        "var(--plot-tool-2)",
        "var(--plot-tool-3)",
        "var(--plot-tool-4)",
        "var(--plot-tool-5)",
        "var(--plot-tool-6)",
        "var(--plot-tool-7)",
        "var(--plot-tool-8)",
        "var(--plot-tool-9)",
        "var(--plot-tool-10)",
    ],
    // No drawing of a report is coloured by it.
    ramp: [""; 5],
};

impl Palette {
    /// The names of a page.
    pub fn page() -> &'static Palette {
        &PAGE
    }

    /// What a page says to give the names their colours on a light or a dark sheet, as CSS.
    pub fn declarations(dark: bool) -> String {
        let colors = Palette::of(dark);
        let pairs = PAGE.all().into_iter().zip(colors.all());
        let name = |color: &str| color.trim_start_matches("var(").trim_end_matches(')').to_string();
        pairs.map(|(own, color)| format!("{}:{color};", name(own))).collect()
    }

    fn all(&self) -> Vec<&'static str> {
        let Palette { sheet, panel, border, grid, zero, text, faint, rapid, start, tools, ramp: _ } =
            self;
        let one = [sheet, panel, border, grid, zero, text, faint, rapid, start];
        one.into_iter().chain(tools).copied().collect()
    }

    /// The colours of a light or a dark sheet.
    pub fn of(dark: bool) -> &'static Palette {
        if dark { &DARK } else { &LIGHT }
    }

    /// The colour of a tool by its place in the order of use.
    pub fn tool(&self, index: usize) -> &'static str {
        self.tools[index % self.tools.len()]
    }

    /// The colour of a step of the scale from least to most.
    pub fn step(&self, step: usize) -> &'static str {
        self.ramp[step.min(self.ramp.len() - 1)]
    }

    /// How often all colours were used before.
    pub fn round(&self, index: usize) -> usize {
        index / self.tools.len()
    }
}

/// The colours as TypeScript, for the page of `chordal view`.
pub(super) fn typescript() -> String {
    let mut text = String::from(
        "// Written by `cargo run -p chordal-export --example palette`: the colours of the picture files.\n",
    );
    for (name, colors) in [("LIGHT_SHEET", &LIGHT), ("DARK_SHEET", &DARK)] {
        let list = |colors: &[&str]| format!("[\"{}\"]", colors.join("\", \""));
        let Palette { sheet, text: ink, rapid, tools, ramp, .. } = colors;
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "\nexport const {name} = {{\n  sheet: \"{sheet}\",\n  text: \"{ink}\",\n  rapid: \"{rapid}\",\n  \
             tools: {},\n  ramp: {},\n}};\n",
            list(tools),
            list(ramp)
        );
    }
    text
}
