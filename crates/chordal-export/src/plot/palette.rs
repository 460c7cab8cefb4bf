//! Colours of the two sheets.

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
    tools: [&'static str; 7],
}

/// After Okabe and Ito: distinguished by the colour-blind, and by their grey in print. Yellow is
/// left out, because it does not show on white.
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
    tools: ["#0072b2", "#d55e00", "#008a63", "#b0487f", "#5b4bb5", "#b87d00", "#30353b"],
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
    tools: ["#56b4e9", "#ff8b3d", "#2fc79a", "#e58fbd", "#a79cf5", "#f0c04a", "#dfe3e8"],
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
    ],
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
        let Palette { sheet, panel, border, grid, zero, text, faint, rapid, start, tools } = self;
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

    /// How often all colours were used before.
    pub fn round(&self, index: usize) -> usize {
        index / self.tools.len()
    }
}
