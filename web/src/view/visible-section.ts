// The part of the path that is shown.

/** Limits of what is shown; a limit that is left out does not apply. */
export interface VisibleSection {
  tool?: number;
  /** First and last line of the program. */
  lines?: [number, number];
  /** Lowest and highest Z, in the frame of the run, mm. */
  depth?: [number, number];
}
