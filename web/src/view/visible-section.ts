// Which part of the path is shown.

/** Limits of what is shown; a limit that is left out does not apply. */
export interface VisibleSection {
  tool?: number;
  /** Lines of the program, from and to, both counted. */
  lines?: [number, number];
  /** Lowest and highest point, in the frame of the run, mm. */
  depth?: [number, number];
}
