// Written by `cargo run -p chordal-export --example palette`: the colours of the picture files.

export const LIGHT_SHEET = {
  sheet: "#ffffff",
  text: "#1d2227",
  rapid: "#8d949c",
  tools: ["#0096ff", "#ff5a00", "#780096", "#2da55a", "#87000f", "#007887", "#ff1ee1", "#875a00", "#0000e1", "#3c3c4b"],
  ramp: ["#1c0055", "#46218f", "#7a3fae", "#c0568f", "#e8730c"],
};

export const DARK_SHEET = {
  sheet: "#14171b",
  text: "#e6e9ec",
  rapid: "#7b8590",
  tools: ["#0069b4", "#f09600", "#9600ff", "#87ff00", "#ff1e69", "#4bc3b4", "#ffa5ff", "#78690f", "#8787ff", "#e1e1d2"],
  ramp: ["#6a5acd", "#a65fd0", "#e56fae", "#ffa07a", "#fff3a0"],
};
