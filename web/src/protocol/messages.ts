// The JSON messages from the server or worker to the page. Lines count from 1.

/** A rotary axis of the machine file. */
export interface RotaryAxis {
  letter: string;
  /** What it turns; null where that is not known. */
  turns: "table" | "head" | null;
}

/** The rotation of the tool by the angle of a rotary axis. */
export interface ToolRotation {
  /** 0, 1 and 2 for A, B and C. */
  axis: number;
  /** A unit vector; a positive angle turns about it by the right-hand rule. */
  about: [number, number, number];
}

/** What the position of an axis (0 to 5 for X, Y, Z, A, B, C; mm or rad) does to a body: a shift along a vector, or a turn about a line by the right-hand rule. */
export type AxisMotion =
  | { axis: number; along: [number, number, number] }
  | { axis: number; about: [number, number, number]; through: [number, number, number] };

/** The bodies of the machine file. */
export interface MachineBodies {
  solids: {
    name: string;
    /** The corners of its triangles, nine numbers each, machine coordinates with all axes at zero, mm. */
    corners: number[];
    /** Applied in this order, they take it to its place relative to the part. */
    motions: AxisMotion[];
  }[];
  /** From machine coordinates to the frame of the run, after the motions: sixteen numbers, column by column; null where that is not known. */
  to_part: number[] | null;
  /** Why bodies are left out. */
  left_out: string[];
}

export interface SourcePlace {
  file: string;
  /** Whether it is in the program itself. */
  own: boolean;
  line: number;
  column: number;
  end_line: number;
  end_column: number;
}

export interface ProblemFix {
  title: string;
  replacement: string;
  place: SourcePlace | null;
  /** Whether it can be applied without checking the result. */
  safe: boolean;
}

export interface Problem {
  code: string;
  name: string;
  severity: "error" | "warning" | "note";
  message: string;
  place: SourcePlace | null;
  label: string;
  secondary: { place: SourcePlace | null; label: string }[];
  alarm: string | null;
  notes: string[];
  help: string | null;
  explanation: string;
  fix: ProblemFix | null;
  /** Alternatives, the most likely first. */
  other_fixes: ProblemFix[];
}

export interface ToolInfo {
  number: number;
  diameter_mm: number | null;
  length_mm: number | null;
  corner_radius_mm: number | null;
  shape: "flat" | "ball" | "bull" | "chamfer" | "drill" | "tap" | "thread mill" | "t-slot" | "lollipop" | "form" | "insert" | "groove" | null;
  point_angle_rad: number | null;
  tip_diameter_mm: number | null;
  /** Only for inserts. */
  nose_radius_mm: number | null;
  /** Only for grooving blades. */
  width_mm: number | null;
  flute_length_mm: number | null;
  /** Outline of a form tool: height above the tip and radius of each point, from the tip up. */
  profile_mm: [number, number][];
  /** Only for a shank that is a single cylinder. */
  shank_diameter_mm: number | null;
  /** Height, lower and upper diameter of each section, from the cutting edges up. */
  shank_mm: [number, number, number][];
  holder_mm: [number, number, number][];
  kind: string | null;
  comment: string | null;
}

export interface MachineInfo {
  /** The side of the axis on which a lathe has its turret; null for a mill. */
  turret: "rear" | "front" | null;
  /** Programmed coordinates per mm of X, Y and Z: 2 where diameters are programmed. */
  factors: [number, number, number];
  /** Whether it has X, Y and Z: a two-axis lathe has no Y. */
  has: [boolean, boolean, boolean];
  name: string;
  title: string;
  control: string;
  /** Limits of X, Y and Z on the machine, mm; null where they are not known. */
  travel: ([number, number] | null)[];
  rotary: RotaryAxis[];
  /** Applied in this order, they take the direction of a tool on the machine to that relative to the part. */
  tool_rotations: ToolRotation[];
  tools: ToolInfo[];
}

export interface RunReport {
  run: number;
  diagnostics: Problem[];
  /** Problems that are not in `diagnostics`. */
  left_out: number;
  errors: number;
  warnings: number;
  notes: number;
  /** From where on the path, or its time alone where the path is known, is not verified; null where all of it is. */
  not_verified_from: { file: string; line: number; own: boolean; path_known: boolean } | null;
  /** Axes that the program never names: they are drawn at zero. */
  never_named: string[];
  /** Axes that are not known in any cut. */
  named_in_no_cut: string[];
  /** Texts about moves in work offsets whose zero is not known, which cannot be drawn, with the remedy. */
  moves_left_out: string[];
  inch: boolean;
  /** The tolerance of the chords that the control itself divides arcs into, mm; null where it interpolates arcs. */
  own_chords_mm: number | null;
  /** Texts that the program prints. */
  output: string[];
  cut_length_mm: number;
  rapid_length_mm: number;
  tools: { number: number; lines: [number, number][]; feed_length_mm: number; speeds_rpm: number[] }[];
  axes: { letter: string; range: [number, number]; cut_range: [number, number] | null }[];
  rows: number;
  rows_left_out: number;
  /** Zeros of work offsets, and the zero of the run on the machine, mm; null where it is not known. */
  places: {
    zeros: { name: string; at: [number, number, number] }[];
    machine: (number | null)[] | null;
  };
  /** null where the machine file has none. */
  bodies: MachineBodies | null;
  end: { end: string; blocks: number }[];
}

export interface ModalState {
  /** The active modal codes of the control. */
  codes?: string[];
  inch: boolean;
  plane: string;
  feed_mode: "per_minute" | "inverse_time" | "per_revolution";
  feed: number | null;
  spindle: string;
  rpm: number;
  coolant: string[];
  tool: number;
  selected: number | null;
  length: { number: number; mm: number | null } | null;
  side: "off" | "left" | "right";
  cutter: { number: number | null; mm: number | null } | null;
  work: string | null;
  path_mode: string | null;
  overrides: { feed: boolean; rapid: boolean };
  shift: [number, number, number];
}

export interface PartTimes {
  cutting_s: number;
  rapid_s: number;
  other_s: number;
  total_s: number;
}

export interface RunTimes {
  run: number;
  all: PartTimes;
  tools: { number: number; changes: number; times: PartTimes }[];
  waits: [string, number][];
  longest: { line: number; runs: number; time_s: number; reason: string }[];
  refused: number;
  /** How the control handles many short blocks. */
  short_blocks: string | null;
  cuts_without_feed: number;
  assumed: number;
}

/** Where a name is defined; with file and text where that is another file. */
export interface DefinitionPlace {
  line: number;
  column: number;
  file?: string;
  text?: string;
  /** The text is only the beginning of the file. */
  cut_off?: boolean;
}

/** A program, a tool, an operation or another entry of the outline. */
export interface OutlineEntry {
  name: string;
  detail: string;
  kind: string;
  line: number;
  children: OutlineEntry[];
}

/** What the program is compared with: nothing, the program that the command line names, or its own text on another machine. */
export type ComparedWith = "nothing" | "named" | { machine: string | null };

/** Lines of a file, the first and the last; file 0 is the program itself. */
export interface BlockRange {
  file: number;
  from: number;
  to: number;
}

/** One program's side of a difference. */
export interface DifferenceSide {
  blocks: BlockRange | null;
  steps: number;
  value: string | null;
  words: string;
  /** Whether it lacks what the other program has; `blocks` is then the block after which that would come. */
  lacks: boolean;
}

export interface Difference {
  category: string;
  head: string;
  distance_mm: number | null;
  /** A point of each path, near the largest distance, mm in the frame of the run. */
  at_mm: [[number, number, number], [number, number, number]] | null;
  sides: [DifferenceSide, DifferenceSide];
}

export interface Comparison {
  run: number;
  version: number;
  verdict: "same" | "within" | "different" | "not-verified";
  tolerance_mm: number;
  headline: string;
  max_distance_mm: number | null;
  farthest: { places: { file: number; line: number }[]; at_mm: Difference["at_mm"] } | null;
  sides: { name: string; moves: number; errors: number }[];
  differences: Difference[];
  dropped: number;
}

/** The other program; `other` is "nothing" where there is none. */
export interface ComparedProgram {
  version: number;
  other: ComparedWith;
  own_text?: boolean;
  name?: string;
  machine?: MachineInfo;
  why?: string | null;
}

/** An extract of the other program, for a line of it. */
export interface OtherText {
  file: string;
  line: number;
  first_line: number;
  text: string;
}

/** A machine to choose from; its name may have the units at power-on: `haas-vf2 in inch`. */
export interface MachineChoice {
  name: string;
  title: string;
}

/** The controls that an ambiguous program may be for, where they would move the tool differently. */
export interface ProgramReadings {
  /** What is not known about the program, in a sentence. */
  message: string;
  /** The first block that differs, and its line; null where there is none. */
  line: number | null;
  block: string | null;
  /** The most likely readings, of which the first is assumed: the control, the size of the cuts, and what that block does on it. */
  shown: { title: string; size: string | null; motion: string; machine: MachineChoice }[];
  /** How many further readings there are. */
  more: number;
}

export interface HelloMessage {
  /** The version of these messages: `PROTOCOL_VERSION` in crates/chordal-view/src/view.rs. */
  protocol: number;
  name: string;
  writable: boolean;
  machines: MachineChoice[];
  compared: { name: string; own_text: boolean } | null;
  tolerance_mm: number;
}

/** The result of the simulation of the stock, with all problems of the run. */
export interface StockReport {
  run: number;
  verdict: "clean" | "problems" | "not-proved";
  resolution_mm: number;
  removed_mm3: { least: number; most: number };
  left_mm3: { least: number; most: number };
  diagnostics: Problem[];
  left_out: number;
  errors: number;
  warnings: number;
  notes: number;
}

/** The same for a lathe, whose simulation is exact. */
export interface TurnedReport extends Omit<StockReport, "resolution_mm"> {
  /** How many parts were cut off. */
  parts_off: number;
  /** `at` is Z and radius, mm. */
  problems: { code: string; line: number; at: [number, number] }[];
}

export interface WordMeaning {
  line: number;
  column: number;
  end_column: number;
  /** Markdown: paragraphs, `code`, **bold**. */
  text: string;
}

export type ServerMessage =
  | ({ type: "turned_report" } & TurnedReport)
  | ({ type: "stock_report" } & StockReport)
  | { type: "no_stock"; run: number; message: string | null; help: string | null }
  | ({ type: "hello" } & HelloMessage)
  | ({ type: "machines" } & Pick<HelloMessage, "machines" | "compared">)
  | ({ type: "compared_program" } & ComparedProgram)
  | { type: "compared_program_refused"; version: number; other: ComparedWith; message: string; help?: string | null }
  | { type: "compared_path_end"; version: number; rows: number; rows_left_out: number }
  | ({ type: "comparison" } & Comparison)
  | { type: "no_comparison"; run: number; version: number; message: string }
  | ({ type: "other_text"; id: number } & OtherText)
  | { type: "run"; run: number; machine: MachineInfo; why: string | null; readings: ProgramReadings | null }
  | { type: "refused"; run: number; message: string; help?: string | null }
  | ({ type: "report" } & RunReport)
  | ({ type: "times" } & RunTimes)
  | { type: "no_times"; run: number; message: string }
  | { type: "state"; id: number; state: ModalState | null }
  | { type: "tokens"; id: number; classes: string[]; tokens: number[] }
  | { type: "hover"; id: number; hover: WordMeaning | null }
  | { type: "definition"; id: number; place: DefinitionPlace | null }
  | { type: "outline"; id: number; entries: OutlineEntry[] }
  | { type: "saved"; id: number }
  | { type: "conflict"; id: number }
  | { type: "changed" }
  | { type: "gone" }
  | { type: "error"; id: number; message: string; help?: string | null };
