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

/// After Okabe and Ito: told apart by the colour-blind, and by their grey in print. Yellow is
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

impl Palette {
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
