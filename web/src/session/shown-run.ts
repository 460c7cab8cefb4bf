// The run of the program that the page shows: what the server has sent of it so far.

import type { Units } from "../panels/units";
import { Path } from "../path/path";
import type { Setpoints } from "../path/setpoints";
import { type Frame, f32, u32 } from "../protocol/frame";
import type { MachineInfo, RunReport, RunTimes } from "../protocol/messages";

/** Why a program could not be run. */
export interface Refusal {
  message: string;
  help?: string | null;
}

export class ShownRun {
  /** Numbered by the server, from 0 for each program; a message with another number is out of date. */
  number = 0;
  /** The path of the program's file. */
  programName = "";
  machine: MachineInfo | undefined;
  path = new Path();
  report: RunReport | undefined;
  refusal: Refusal | undefined;
  times: RunTimes | undefined;
  /** Why there are no times; undefined where there are, or while they are computed. */
  timesMessage: string | undefined;
  /** The planned motion; undefined until it is planned, and where it cannot be. */
  setpoints: Setpoints | undefined;

  /** Begins with another program, whose runs are numbered from 0. */
  open(programName: string): void {
    this.programName = programName;
    this.number = 0;
  }

  begin(number: number, machine: MachineInfo): void {
    this.number = number;
    this.machine = machine;
    this.path = new Path();
    this.report = undefined;
    this.refusal = undefined;
    this.times = undefined;
    this.timesMessage = undefined;
    this.setpoints = undefined;
  }

  /** Units of lengths. */
  get units(): Units {
    return { inch: this.report?.inch ?? false };
  }

  /** Units of coordinates, with the axes that the machine has, and which of them are diameters. */
  get axisUnits(): Units {
    const { machine } = this;
    return { ...this.units, ...(machine && { factors: machine.factors, has: machine.has }) };
  }

  takeSetpoints(frame: Frame): Setpoints {
    const optional = (name: string) => (name in frame.columns ? f32(frame, name) : undefined);
    this.setpoints = {
      positions: f32(frame, "places"),
      programmed: optional("programmed"),
      rotaryAngles: optional("turns"),
      machineAxes: optional("axes"),
      speed: f32(frame, "speed"),
      row: u32(frame, "row"),
      periodS: Number(frame.header.period_s),
      totalS: Number(frame.header.total_s),
    };
    return this.setpoints;
  }
}
