// The layout of the page: bars, panes and panels, and the messages in them.

import type { Path } from "../path/path";
import type { PlaybackState } from "../path/playback-state";
import type { MachineChoice, MachineInfo, RunReport, ToolInfo } from "../protocol/messages";
import type { ViewName } from "../view/camera";
import { type ColorBy, type Palette, toolColor } from "../view/colors";
import type { VisibleSection } from "../view/visible-section";
import { setCodeSpans } from "./code-spans";
import { element } from "./dom";
import { icon } from "./icons";
import { sectionControls } from "./section-controls";
import { type Units, angles, count, countText, length, positionText, speed } from "./units";

export type PanelName = "problems" | "outline" | "state" | "times" | "compare";

const PANELS: [PanelName, string][] = [
  ["problems", "Problems"],
  ["outline", "Outline"],
  ["state", "Active"],
  ["times", "Times"],
  ["compare", "Compare"],
];

/** View, text of the button, and key. */
const VIEWS: [ViewName, string, string][] = [
  ["top", "Top", "1"],
  ["front", "Front", "2"],
  ["right", "Side", "3"],
  ["iso", "3D", "4"],
];

function button(text: string, label: string): HTMLButtonElement {
  const item = element("button", "", text);
  item.type = "button";
  item.title = label;
  if (label !== text) item.setAttribute("aria-label", label);
  return item;
}

function check(text: string, checked: boolean): [HTMLLabelElement, HTMLInputElement] {
  const label = element("label", "check");
  const box = element("input");
  box.type = "checkbox";
  box.checked = checked;
  label.append(box, text);
  return [label, box];
}

/** How long the tolerance slider must rest before chords are requested, ms. */
const TOLERANCE_REST_MS = 60;
/** How long a message that is no error stays, ms. */
const TOAST_MS = 5000;
/** Limits of the width of the program's pane, and a step of it by key, percent. */
const MIN_WIDTH_PERCENT = 20;
const MAX_WIDTH_PERCENT = 70;
const WIDTH_STEP_PERCENT = 2;
/** Tools that the legend names at most. */
const MAX_LEGEND_KEYS = 24;

/** With more tools the legend does not say which diameters are not known. */
const MAX_DETAILED_KEYS = 6;

/** The size of a tool as text: nose radius of an insert, width of a blade, otherwise the diameter; undefined where the diameter is not known. */
function sizeOf(tool: ToolInfo | undefined, units: Units): string | undefined {
  if (tool?.shape === "insert") return tool.nose_radius_mm === null ? "" : `R${length(units, tool.nose_radius_mm)}`;
  if (tool?.shape === "groove") return tool.width_mm === null ? "" : `${length(units, tool.width_mm)} wide`;
  return tool?.diameter_mm ? `Ø${length(units, Math.abs(tool.diameter_mm))}` : undefined;
}

/** `T1`, with size and shape where they are known. */
function toolName(tool: number, machine: MachineInfo | undefined, units: Units, omitsUnknown: boolean): string {
  if (tool === 0) return "No tool";
  const known = machine?.tools.find(({ number }) => number === tool);
  const size = sizeOf(known, units) ?? (omitsUnknown || machine?.turret ? "" : "Ø not known");
  return [`T${tool}`, size, known?.shape].filter(Boolean).join(" ");
}

export function layout(root: HTMLElement) {
  const header = element("header", "top");
  const name = element("h1", "name", "Chordal");
  const dirty = element("span", "dirty");
  const save = button("Save", "Save (Ctrl-S)");
  save.id = "save";
  save.hidden = true;
  const machineLabel = element("label", "machine", "Machine ");
  const machine = element("select");
  machine.id = "machine";
  machineLabel.append(machine);
  const why = element("span", "why");
  const theme = button("", "Light or dark");
  theme.classList.add("sign");
  theme.append(icon("theme"));
  theme.id = "theme";
  header.append(name, dirty, save, machineLabel, why, theme);

  const bar = element("div", "bar");
  bar.setAttribute("role", "toolbar");
  bar.setAttribute("aria-label", "View");
  const views = VIEWS.map(([view, text, key]) => {
    const viewButton = button(text, `${text} view (${key})`);
    viewButton.dataset.view = view;
    viewButton.addEventListener("click", () => api.onView(view));
    return viewButton;
  });
  const fit = button("Fit", "Fit the path to the view (F)");
  fit.addEventListener("click", () => api.onFit());
  const color = element("select");
  color.id = "color";
  color.setAttribute("aria-label", "Colour of cuts");
  color.title = "Colour of the cuts";
  for (const [value, text] of [["tool", "By tool"], ["speed", "By feed"], ["depth", "By depth"]] as const) {
    color.append(new Option(text, value));
  }
  const byPower = new Option("By power (S)", "power");
  color.addEventListener("change", () => api.onColor(color.value as ColorBy));
  const [rapidsLabel, rapids] = check("Rapids", true);
  const [toolLabel, toolOn] = check("Tool", true);
  const [travelLabel, travel] = check("Travel", false);
  travel.id = "travel";
  travelLabel.title = "The space that the machine can reach";
  const [machineOnLabel, machineOn] = check("Machine", false);
  machineOn.id = "machine-bodies";
  machineOnLabel.title = "The bodies of the machine file, at the time of the slider";
  machineOnLabel.hidden = true;
  rapidsLabel.title = "Rapid moves";
  toolLabel.title = "The tool at the time of the slider, or at the line of the cursor";
  const [chordsLabel, chordsOn] = check("Chords", false);
  chordsLabel.title = "The straight pieces that a control would send for the arcs";
  chordsOn.id = "chords";
  const tolerance = element("input");
  tolerance.type = "range";
  tolerance.id = "tolerance";
  Object.assign(tolerance, { min: "-4", max: "1", step: "0.05", value: "-0.5" });
  tolerance.setAttribute("aria-label", "Tolerance of the chords");
  const [balancedLabel, balanced] = check("inside and outside", false);
  balancedLabel.title = "The ends of the chords outside the arc and their middles inside it, by the same distance";
  const [ownLabel, ownChords] = check("as the control cuts", true);
  ownLabel.title = "The segments that the control itself cuts arcs into";
  ownLabel.hidden = true;
  ownChords.id = "own-chords";
  const chordText = element("output", "chord-text");
  chordText.setAttribute("aria-live", "polite");
  const chordControls = element("span", "chord-controls");
  chordControls.append(ownLabel, tolerance, balancedLabel, chordText);
  chordControls.hidden = true;
  const showChordControls = () => {
    chordControls.hidden = !chordsOn.checked;
    tolerance.hidden = balancedLabel.hidden = api.ownChords();
  };
  const chordsChanged = () => {
    showChordControls();
    api.onChords();
  };
  chordsOn.addEventListener("change", chordsChanged);
  balanced.addEventListener("change", chordsChanged);
  ownChords.addEventListener("change", chordsChanged);
  let toleranceTimer = 0;
  tolerance.addEventListener("input", () => {
    window.clearTimeout(toleranceTimer);
    toleranceTimer = window.setTimeout(chordsChanged, TOLERANCE_REST_MS);
  });
  const measure = button("Measure", "Measure points, lines and arcs of the path (M)");
  measure.id = "measure";
  measure.setAttribute("aria-pressed", "false");
  const section = sectionControls((chosen) => api.onSection(chosen), () => api.cursorLine());
  const stockSlot = element("span", "stock-slot");
  bar.append(...views, fit, color, rapidsLabel, toolLabel, travelLabel, machineOnLabel, measure, section.root, stockSlot, chordsLabel, chordControls);

  const left = element("section", "left");
  left.setAttribute("aria-label", "Program");
  const code = element("div", "code");
  const tabs = element("div", "tabs");
  tabs.setAttribute("role", "tablist");
  const panels = {} as Record<PanelName, HTMLElement>;
  const tabOf = {} as Record<PanelName, HTMLButtonElement>;
  const panelRoot = element("div", "panels");
  for (const [panel, text] of PANELS) {
    const tab = button(text, text);
    tab.setAttribute("role", "tab");
    tab.id = `tab-${panel}`;
    tab.setAttribute("aria-controls", `panel-${panel}`);
    tab.addEventListener("click", () => {
      show(panel);
      api.onPanel(panel);
    });
    tab.addEventListener("keydown", (event) => {
      const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (by === 0) return;
      const index = PANELS.findIndex(([name]) => name === panel);
      const next = PANELS[(index + by + PANELS.length) % PANELS.length]![0];
      tabOf[next].click();
      tabOf[next].focus();
    });
    tabOf[panel] = tab;
    tabs.append(tab);
    const body = element("div", "panel");
    body.id = `panel-${panel}`;
    body.setAttribute("role", "tabpanel");
    body.setAttribute("aria-labelledby", tab.id);
    body.tabIndex = 0;
    panels[panel] = body;
    panelRoot.append(body);
  }
  const counts = element("span", "counts");
  counts.id = "counts";
  counts.setAttribute("role", "status");
  const tabRow = element("div", "tab-row");
  tabRow.append(tabs, element("span", "space"), counts);
  left.append(code, tabRow, panelRoot);

  const right = element("section", "right");
  right.setAttribute("aria-label", "Path");
  const stage = element("div", "stage");
  const canvas = element("canvas", "path");
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", "Path of the tool");
  const axes = element("canvas", "axes");
  axes.setAttribute("aria-hidden", "true");
  const legend = element("div", "legend");
  const readout = element("div", "readout");
  const measured = element("div", "measured");
  measured.setAttribute("role", "status");
  const comparison = element("div", "comparison");
  comparison.setAttribute("role", "status");
  const paths = element("div", "paths");
  // Above the view, not in it, so that the legend covers nothing of the path.
  const strip = element("div", "strip");
  strip.append(legend, readout);
  const turns = element("div", "turns");
  turns.hidden = true;
  const travelWhy = element("div", "travel-why");
  travelWhy.hidden = true;
  travelWhy.setAttribute("role", "status");
  const hints = element("div", "hints");
  hints.append(travelWhy, turns);
  const unverified = element("div", "unverified");
  unverified.hidden = true;
  unverified.setAttribute("role", "status");
  const empty = element("div", "empty");
  empty.hidden = true;
  const progress = element("progress", "progress");
  progress.max = 1;
  progress.hidden = true;
  progress.setAttribute("aria-label", "Running the program");
  stage.append(canvas, axes, measured, comparison, hints, unverified, empty, progress);
  const timeline = element("div", "timeline");
  right.append(bar, strip, paths, stage, timeline);

  const splitter = element("div", "splitter");
  splitter.setAttribute("role", "separator");
  splitter.setAttribute("aria-orientation", "vertical");
  splitter.setAttribute("aria-label", "Width of the program");
  splitter.setAttribute("aria-valuenow", "38");
  splitter.tabIndex = 0;
  const main = element("main");
  const setWidth = (percent: number) => {
    const clamped = Math.min(MAX_WIDTH_PERCENT, Math.max(MIN_WIDTH_PERCENT, percent));
    main.style.setProperty("--left", `${clamped}%`);
    splitter.setAttribute("aria-valuenow", String(Math.round(clamped)));
  };
  splitter.addEventListener("pointerdown", (event) => splitter.setPointerCapture(event.pointerId));
  splitter.addEventListener("pointermove", (event) => {
    if (splitter.hasPointerCapture(event.pointerId)) setWidth((event.clientX / main.clientWidth) * 100);
  });
  splitter.addEventListener("keydown", (event) => {
    const by = event.key === "ArrowRight" ? WIDTH_STEP_PERCENT : event.key === "ArrowLeft" ? -WIDTH_STEP_PERCENT : 0;
    if (by !== 0) setWidth(Number(splitter.getAttribute("aria-valuenow")) + by);
  });
  main.append(left, splitter, right);
  const toast = element("div", "toast");
  toast.setAttribute("role", "alert");
  toast.hidden = true;
  const readings = element("section", "readings");
  readings.hidden = true;
  root.append(header, readings, main, toast);

  theme.addEventListener("click", () => {
    const { dataset } = document.documentElement;
    const isDark = dataset.theme ? dataset.theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
    dataset.theme = isDark ? "light" : "dark";
    api.onTheme();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => api.onTheme());

  let shown: PanelName = "problems";
  function show(panel: PanelName): void {
    shown = panel;
    for (const [name] of PANELS) {
      panels[name].hidden = name !== panel;
      tabOf[name].setAttribute("aria-selected", String(name === panel));
      tabOf[name].tabIndex = name === panel ? 0 : -1;
    }
  }
  show("problems");

  let toastTimer = 0;
  /** The machine that was chosen as a reading, which the list may lack. */
  let machineOfReading: MachineChoice | undefined;
  const api = {
    header, save, machine, readings, measure, section, stockSlot, canvas, axes, code, timeline, panels, paths, rapids, travel, machineOn, toolOn, chordsOn, balanced,
    onView: (_view: ViewName) => {},
    onFit: () => {},
    onColor: (_by: ColorBy) => {},
    onTheme: () => {},
    onPanel: (_panel: PanelName) => {},
    onChords: () => {},
    onSection: (_section: VisibleSection) => {},
    cursorLine: () => 1,
    show,
    shown: () => shown,
    chordTolerance: () => 10 ** Number(tolerance.value),
    /** Whether the control's own chords are chosen. */
    ownChords: () => !ownLabel.hidden && ownChords.checked,
    /** Offers the control's own chords, for a control that divides arcs into chords. */
    offerOwnChords(offered: boolean): void {
      ownLabel.hidden = !offered;
      showChordControls();
    },
    setChordText: (text: string) => (chordText.textContent = text),
    /** Offers to show the bodies of the machine, where its file has some. */
    offerMachine(offered: boolean): void {
      machineOnLabel.hidden = !offered;
    },
    /** Shows why the travel box or bodies of the machine are missing; empty where they are shown or switched off. */
    setTravelHint(text: string): void {
      setCodeSpans(travelWhy, text);
      travelWhy.hidden = text === "";
    },
    setName(path: string): void {
      name.textContent = path.split(/[\\/]/).pop() ?? path;
      name.title = path;
    },
    setDirty: (isDirty: boolean) => (dirty.textContent = isDirty ? "● Not saved" : ""),
    measured: (text: string) => (measured.textContent = text),
    comparison: (text: string) => (comparison.textContent = text),
    /** Shows the hint about axes that are drawn without being known; empty for none. */
    setAxisHint(text: string): void {
      setCodeSpans(turns, text);
      turns.hidden = text === "";
    },
    /** Shows from where on the path is not verified; empty where all of it is. */
    unverified(text: string): void {
      unverified.textContent = text;
      unverified.hidden = text === "";
    },
    /** Shows why there is no path; empty where there is one. */
    empty(text: string): void {
      empty.textContent = text;
      empty.hidden = text === "";
    },
    setMachines(machines: MachineChoice[]): void {
      machine.replaceChildren(new Option("recognized from the program", ""));
      for (const { name, title } of machines) machine.append(new Option(title, name));
    },
    /** Replaces the list of machines; the chosen one stays chosen. */
    offerMachines(machines: MachineChoice[]): void {
      const { value } = machine;
      api.setMachines(machines);
      if (machines.some(({ name }) => name === value)) machine.value = value;
      else if (machineOfReading?.name === value) api.chooseMachine(machineOfReading);
    },
    /** Chooses a machine, which is added where it is not in the list: one with units at power-on. */
    chooseMachine(chosen: MachineChoice): void {
      const isListed = [...machine.options].some(({ value }) => value === chosen.name);
      if (!isListed) machine.append(new Option(chosen.title, chosen.name));
      machineOfReading = chosen;
      machine.value = chosen.name;
    },
    /** Shows the title of the recognized machine, and why it was chosen. */
    machineWhy(title: string, reason: string | null): void {
      machine.options[0]!.textContent = machine.value === "" ? title : "recognized from the program";
      setCodeSpans(why, reason ?? "");
    },
    /** Shows the fraction of the run that is done; 1 hides it. */
    progress(fraction: number): void {
      progress.hidden = fraction >= 1;
      progress.value = fraction;
    },
    counts(report: RunReport | undefined, isRefused: boolean): void {
      counts.className = `counts ${isRefused || (report?.errors ?? 0) > 0 ? "bad" : (report?.warnings ?? 0) > 0 ? "doubt" : "good"}`;
      counts.textContent = isRefused
        ? "Cannot run"
        : report
          ? [countText(report.errors, "error"), ...(report.warnings > 0 ? [countText(report.warnings, "warning")] : [])].join(", ")
          : "";
    },
    /** Offers colours by power, for programs whose cuts differ in S. */
    offerPower(offered: boolean): void {
      if (offered) color.append(byPower);
      else if (color.value === "power") {
        color.value = "tool";
        api.onColor("tool");
      }
      if (!offered) byPower.remove();
    },
    /** Shows what the colours of the cuts mean. */
    legend(by: ColorBy, path: Path, report: RunReport | undefined, machine: MachineInfo | undefined, palette: Palette): void {
      const units = { inch: report?.inch ?? false };
      legend.replaceChildren();
      if (by === "tool") {
        for (const [index, tool] of path.cutters.slice(0, MAX_LEGEND_KEYS).entries()) {
          const item = element("span", "key");
          const swatch = element("span", "swatch");
          swatch.style.background = toolColor(palette, index);
          item.append(swatch, toolName(tool, machine, units, path.cutters.length > MAX_DETAILED_KEYS));
          legend.append(item);
        }
        const more = path.cutters.length - MAX_LEGEND_KEYS;
        if (more > 0) legend.append(element("span", "key", `and ${countText(more, "more tool")}`));
        return;
      }
      const ramp = element("span", "ramp");
      ramp.style.background = `linear-gradient(90deg, ${palette.ramp.join(", ")})`;
      const z = path.origin[2];
      const ranges = {
        speed: [path.minFeed, path.maxFeed],
        depth: [path.depths[0] + z, path.depths[1] + z],
        power: [0, path.maxPower],
      } as const;
      const [low, high] = ranges[by];
      if (!(low <= high)) return void legend.append(element("span", "key", by === "speed" ? "No cut has a feed." : "No cuts."));
      const texts = {
        speed: (value: number) => speed(units, value),
        depth: (value: number) => `Z ${length(units, value)}`,
        power: (value: number) => `S ${count(value)}`,
      };
      const text = texts[by];
      legend.append(text(low), ramp, text(high));
    },
    readout({ coordinates, rotaryAngles, speed: mmPerMin }: PlaybackState, units: Units): void {
      const feedrate = mmPerMin === undefined ? "" : `   ${speed(units, mmPerMin)}`;
      readout.textContent = `${positionText(units, coordinates)}${angles(rotaryAngles)}${feedrate}`;
    },
    notify(kind: "note" | "warning" | "error", text: string): void {
      toast.className = `toast ${kind}`;
      setCodeSpans(toast, text);
      toast.hidden = false;
      window.clearTimeout(toastTimer);
      if (kind !== "error") toastTimer = window.setTimeout(() => (toast.hidden = true), TOAST_MS);
    },
    /** Shows a question with a button for each answer. */
    prompt(text: string, answers: [string, () => void][]): void {
      window.clearTimeout(toastTimer);
      toast.className = "toast warning";
      toast.replaceChildren(element("span", "", text));
      for (const [answer, act] of answers) {
        const answerButton = button(answer, answer);
        answerButton.addEventListener("click", () => {
          toast.hidden = true;
          act();
        });
        toast.append(answerButton);
      }
      toast.hidden = false;
    },
  };
  return api;
}
