import type { Text } from "./question.js";

/** How a program is run. What is not said is as a `chordal.toml` among the files or the text itself says. */
export interface ProgramOptions {
  /** The name of the program: for messages, and for what lies next to it. */
  name?: string;
  /** The machine: a built-in name, or the path of a machine file among `files`. */
  machine?: string;
  /** Assignments to keys of the machine, such as `tools.5.diameter="0.5 in"`. */
  set?: string[];
  /** The path of a LinuxCNC tool table among `files`. */
  tools?: string;
  /** The path of what a GRBL firmware printed for `$$`, among `files`. */
  settings?: string;
  /** Runs only this program of the text. */
  program?: number;
  /** Skips the blocks that start with `/`. */
  blockDelete?: boolean;
  /** Most blocks carried out in calls, repeats and jumps. */
  maxBlocks?: number;
  /** Subprograms, machine files and tool tables, by their paths. Nothing else is looked for. */
  files?: Readonly<Record<string, Text>>;
}

export type Severity = "error" | "warning" | "note";

/** Words of a text. Lines and columns count from 1, columns in characters; `start` and `end` are bytes. All are null for a problem of the program as a whole. */
export interface Place {
  file: string | null;
  line: number | null;
  column: number | null;
  end_line: number | null;
  end_column: number | null;
  start: number | null;
  end: number | null;
}

/** A problem of a program. */
export interface Diagnostic extends Place {
  /** Such as `CH401`; `explain` says what it means. */
  code: string;
  name: string;
  severity: Severity;
  message: string;
  label: string;
  secondary: (Place & { label: string })[];
  /** What the user's control says. */
  alarm: string | null;
  notes: string[];
  /** What to do. */
  help: string | null;
  fix: Fix | null;
  /** Others that would do as well, the likeliest first. */
  other_fixes: Fix[];
  /** The calls that led here. */
  calls: { file: string | null; line: number | null; text: string }[];
}

export interface Fix {
  title: string;
  replacement: string;
  applicability: "safe" | "unsafe";
  file: string | null;
  start: number;
  end: number;
}

/** As what a text may be read that does not name its control and its units for certain. */
export interface Readings {
  /** The controls that move it alike are one reading; the first one is what runs. */
  possible: {
    /** For people: `GRBL and LinuxCNC in inch`. */
    title: string;
    /** The likeliest of `controls`. */
    control: string;
    controls: string[];
    /** The built-in machine of `control`. */
    machine: string;
    /** Units at power-on; null where the text names its units. */
    units: "inch" | "mm" | null;
    /** The settings that the text leaves open, as assignments to the machine: `settings.units="inch"`. */
    settings: string[];
    /** The size of what is cut along X, Y and Z; null where only the beginning was run or nothing is cut. */
    size_mm: (number | null)[] | null;
    /** What the block of the difference does: `Z 127 mm`; empty where there is none. */
    motion: string;
    /** What to type to read the text so. */
    option: string;
  }[];
  /** The first block that they move differently; null where all move alike. */
  difference: { line: number | null; only_feed: boolean } | null;
}

/** On what a program was read, and its problems. */
export interface Reading {
  file: string;
  /** Null where the text is in a language that is not read. */
  machine: string | null;
  control: string;
  /** Who says so. */
  control_from: "given" | "folder" | "extension" | "text";
  control_strength: "sure" | "likely" | "weak" | "assumed" | null;
  control_evidence: { sign: string; line: number; weight: number }[];
  runner_up: { control: string; weight: number; errors: number | null } | null;
  /** Only where the control or the units are a guess. */
  readings?: Readings;
  counts: { errors: number; warnings: number; notes: number };
  /** The whole path is known. */
  verified: boolean;
  not_verified_from: { file: string; line: number } | null;
  /** Conditions that nobody knows, of which both sides were run or one was not, and whether block delete was run both ways. */
  other_sides: { run: { file: string; line: number }[]; left_out: { file: string; line: number }[]; block_delete: boolean };
  diagnostics: Diagnostic[];
  /** Problems that are counted and not listed. */
  dropped: { code: string; name: string; count: number }[];
}

/** What `check` finds. */
export interface Check extends Reading {
  schema: "chordal.diagnostics/1";
}

/** What `run` finds: lengths in mm, angles in degrees, times in s, feeds in mm/min. */
export interface Run extends Reading {
  schema: "chordal.summary/1";
  summary: {
    units: "inch" | "mm";
    blocks: number;
    moves: {
      lines: number;
      arcs: number;
      helices: number;
      spirals: number;
      splines: number;
      rapids: number;
      dwells: number;
    };
    cut_length_mm: number;
    rapid_length_mm: number;
    /** Null where the program is too long to be planned here; `time` does it. */
    time_s: number | null;
    time_without_acceleration_s: number;
    cuts_without_feed: number;
    tools: {
      tool: number;
      shape: string | null;
      diameter_mm: number | null;
      lines: [number, number][];
      feed_mm_per_min: [number, number] | null;
      speeds_rpm: number[];
      cut_length_mm: number;
      cut_time_without_acceleration_s: number;
      rapid_time_without_acceleration_s: number;
    }[];
    axes: {
      axis: string;
      unit: "mm" | "deg";
      range: [number, number];
      cut_range: [number, number] | null;
    }[];
    /** Of moves in work offsets of which nobody knows how they lie to the first: `axes` are without them. */
    moves_left_out: string[];
    repeats: boolean;
    /** What the program prints. */
    prints: string[];
  };
}

export interface TimeOptions {
  /** `best` optimizes, for short programs. */
  level?: "fast" | "best";
  /** Other overrides and path modes, for programs of any length; without it, up to 20,000 moves. */
  whatIf?: boolean;
  /** How far above the physical limit. Takes up to a minute. */
  bound?: boolean;
  /** Where operations begin. */
  operations?: "tool" | "comment";
}

/** Seconds. */
export interface Times {
  total_s: number;
  cutting_s: number;
  rapid_s: number;
  other_s: number;
  /** Above that at the programmed feed or rapid speed. */
  lost_s: number;
}

/** The least times, where `bound` asks for them. */
export interface Least {
  bound_s?: number;
  reference_s?: number | null;
  reference_unknown_s?: number;
}

/** A line, with its file where that is not the program's. */
export interface Line {
  line: number;
  file?: string;
}

export interface BlockTime extends Line {
  text: string;
  runs: number;
  time_s: number;
  lost_s: number;
  reason: string;
  loses_by?: string;
}

/** What `time` finds. */
export interface Time extends Times, Least {
  schema: "chordal.time/1";
  machine: string;
  /** The least and the most time where it depends on conditions that nobody knows. */
  total_s_range: [number, number] | null;
  at_feed_s: number;
  level: "fast" | "best";
  moves: number;
  tool_changes: number;
  tangent_stops: number;
  cut_ends: {
    at_rest: number;
    exact: number;
    within: number;
    joined: number;
    least_tolerance_mm?: number;
    largest_tolerance_mm?: number;
  };
  errors: number;
  verified: boolean;
  waits: Record<string, number>;
  tools: (Times & { tool: number; changes: number })[];
  operations: (Times & Least & { tool: number; first: Line; last: Line; comment?: string })[];
  operations_left_out: number;
  longest_blocks: BlockTime[];
  costliest_blocks: BlockTime[];
  what_if?: {
    feed_override?: number;
    rapid_override?: number;
    path_mode?: "exact stop" | "exact path" | "continuous";
    smoothness?: number;
    tolerance_mm?: number | null;
    total_s: number;
  }[];
  short_lines?: {
    tool: number;
    lines: number;
    length_mm: number;
    time_s: number;
    at_feed_s: number;
    tolerance_mm: number | null;
    savings: {
      with: "joined" | "tolerance" | "decimals" | "shorter_lines" | "arcs";
      tolerance_mm?: number;
      decimals?: number;
      within_mm?: number;
      pieces?: number;
      saves_s: number;
    }[];
  }[];
  assumed: { axis: string; limit: string; value: number; unit: "mm" | "deg" }[];
  cuts_without_feed: number;
  unknown_moves: number;
  refused_moves: number;
}

export interface SampleOptions {
  /** Time from one setpoint to the next, s; 0.001 without it. */
  period?: number;
  level?: "fast" | "best";
  /** Most setpoints; 5,000,000 without it. */
  maxSamples?: number;
}

/** What two runs can differ in. */
export type Category =
  | "path" | "order" | "rotary" | "rapid" | "rapid-path" | "unknown" | "feed" | "time" | "spindle" | "tool"
  | "ready-tool" | "length-offset" | "radius-offset" | "work-offset" | "written" | "variable" | "coolant"
  | "path-mode" | "overrides" | "dwell" | "stop" | "code" | "message" | "alarm" | "block-delete" | "probe"
  | "output" | "value" | "not-run" | "problem";

export interface CompareOptions {
  /** Of the first program. */
  a?: ProgramOptions;
  /** Of the second one. */
  b?: ProgramOptions;
  /** Paths this far apart count as the same, mm. */
  tolerance?: number;
  /** Feeds and speeds that differ by this fraction count as the same. */
  feedTolerance?: number;
  /** Differences to ignore. */
  ignore?: Category[];
}

/** Both programs. */
export interface Sides<T> {
  a: T;
  b: T;
}

/** Blocks of one side of a difference. */
export interface DifferentBlocks {
  lines?: [number, number];
  text?: string;
  file?: string;
  steps: unknown;
  value?: unknown;
  at_mm?: unknown;
}

export interface Difference extends Sides<DifferentBlocks> {
  category: Category;
  times: number;
  distance_mm?: number;
  shift_mm?: unknown;
}

/** What `compare` finds: lengths in mm, feeds in mm/min, angles in degrees. */
export interface Comparison {
  schema: "chordal.compare/1";
  verdict: "same" | "within" | "different" | "not-verified";
  tolerance_mm: number;
  max_distance_mm: number | null;
  farthest: Sides<Line & { text: string; at_mm: unknown }> | null;
  programs: Sides<{
    file: string;
    machine: string;
    moves: number;
    errors: number;
    not_verified_from: { file: string; line: number } | null;
  }>;
  differences: Difference[];
  dropped: number;
}

export interface ConvertOptions extends ProgramOptions {
  /** The machine to write the program for: a built-in name, or the path of a machine file among `files`. */
  to: string;
  /** How far the path may be from the old one where a curve must be written as other curves, mm. */
  tolerance?: number;
  /** Decimals of computed words. */
  digits?: number;
  /** Converts a program that has errors on its own control. */
  despiteErrors?: boolean;
  /** Writes cycles out as moves where the new machine makes their pecks or passes in other steps. */
  exactCycles?: boolean;
  /** Writes positions of the axes in place of the tip of the tool, on the same control too. */
  axisPositions?: boolean;
}

/** The ways through a program that a proof covers beside the one that its first run takes. */
export interface Covers {
  /** Conditions that nobody knows, of which both sides were compared. */
  conditions: number;
  /** Block delete was compared on and off. */
  block_delete: boolean;
  /** No such condition is left. */
  complete: boolean;
}

/** What `convert` comes to. */
export interface Conversion {
  schema: "chordal.convert/1";
  from: string;
  to: string;
  /** Everything was converted, and the motion is proved to be the same. */
  holds: boolean;
  refusals: { line: number; text: string; reason: string }[];
  changes: { line: number; before: string; after: string; reason: string }[];
  pecks: unknown[];
  passes: unknown[];
  proof: (Comparison & { of_the_machines: Difference[]; covers: Covers }) | null;
  /** The new program; empty where something was refused. */
  text: string;
}

/** A built-in machine. */
export interface MachineName {
  name: string;
  title: string;
  control: string;
  controlTitle: string;
}

/** A machine with everything that it inherits. */
export interface Machine extends MachineName {
  notes: string[];
  /** It as a machine file. */
  toml: string;
}
