// The bodies of a machine with head B and table C, while a blade is cut: the spindle is where the tool is.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { picture, session } from "./browser.mjs";

const tests = session();
const folder = mkdtempSync(join(tmpdir(), "chordal-machine-"));
after(() => rmSync(folder, { recursive: true, force: true }));

const TOOL_LENGTH_MM = 120;

const MACHINE = `inherits = "fanuc-head-table"

[work_offsets.G54]
X = "-500 mm"
Y = "-250 mm"
Z = "-450 mm"

[home]
X = "-500 mm"
Y = "-250 mm"
Z = "0 mm"
B = "0 deg"
C = "0 deg"

[tools.1]
length = "${TOOL_LENGTH_MM} mm"
diameter = "6 mm"
shape = "ball"

[kinematics]
X = "head"
Y = "table"
Z = "head"

[solids.bed]
on = "base"
shape = "box"
from = { X = "-900 mm", Y = "-600 mm", Z = "-800 mm" }
to = { X = "-100 mm", Y = "100 mm", Z = "-700 mm" }

[solids.column]
on = "base"
shape = "box"
from = { X = "-900 mm", Y = "300 mm", Z = "-800 mm" }
to = { X = "-100 mm", Y = "450 mm", Z = "350 mm" }

[solids.slide]
on = "Y"
shape = "box"
from = { X = "-720 mm", Y = "-450 mm", Z = "-700 mm" }
to = { X = "-280 mm", Y = "-50 mm", Z = "-570 mm" }

[solids.table]
on = "C"
shape = "cylinder"
from = { X = "-500 mm", Y = "-250 mm", Z = "-570 mm" }
to = { X = "-500 mm", Y = "-250 mm", Z = "-500 mm" }
diameter = "320 mm"

[solids.block]
on = "C"
shape = "box"
from = { X = "-560 mm", Y = "-290 mm", Z = "-500 mm" }
to = { X = "-440 mm", Y = "-210 mm", Z = "-455 mm" }

[solids.ram]
on = "Z"
shape = "box"
from = { X = "-80 mm", Y = "90 mm", Z = "60 mm" }
to = { X = "80 mm", Y = "300 mm", Z = "450 mm" }

[solids.head]
on = "B"
shape = "cylinder"
from = { Y = "-80 mm", Z = "150 mm" }
to = { Y = "90 mm", Z = "150 mm" }
diameter = "150 mm"

[solids.nose]
on = "spindle"
shape = "cylinder"
to = { Z = "120 mm" }
diameter = "80 mm"
end_diameter = "120 mm"
`;

/** A blade in rows that wind about Z and downwards, while the tool leans outwards more and more. */
function blade() {
  const number = (value) => value.toFixed(5);
  const lines = ["G21 G90 G17 G94", "T1 M6", "S9000 M3", "G54 G0 X60. Y0. B20. C0", "G43.5 H1 Z90."];
  const radians = (degrees) => (degrees * Math.PI) / 180;
  for (let row = 0; row < 6; row++) {
    for (let step = 0; step <= 60; step++) {
      const share = (row % 2 ? 60 - step : step) / 60;
      const azimuth = radians(20 + 100 * share * share);
      const radius = 25 + 40 * share - 3 * row;
      const [lean, towards] = [radians(15 + 50 * share), azimuth + radians(25 - 4 * row)];
      const tip = [radius * Math.cos(azimuth), radius * Math.sin(azimuth), 40 - 35 * share ** 1.5];
      const vector = [Math.sin(lean) * Math.cos(towards), Math.sin(lean) * Math.sin(towards), Math.cos(lean)];
      const words = ["X", "Y", "Z"].map((letter, axis) => letter + number(tip[axis])).join(" ");
      const directions = ["I", "J", "K"].map((letter, axis) => letter + number(vector[axis])).join(" ");
      lines.push(`${row + step === 0 ? "G0" : "G1"} ${words} ${directions}${row === 0 && step === 1 ? " F1500." : ""}`);
    }
  }
  return [...lines, "G49", "M30", ""].join("\n");
}

test("the spindle of a five-axis machine is where the tool is", async (context) => {
  if (tests.isStandalone) return context.skip("the machine file is named on the command line");
  const [program, machine] = [join(folder, "blade.nc"), join(folder, "machine.toml")];
  writeFileSync(program, blade());
  writeFileSync(machine, MACHINE);
  const { page, complaints } = await tests.open(program, "--machine", machine);
  await page.waitForFunction(() => window.chordal.setpoints());
  const isOffered = await page.locator("#machine-bodies").isVisible();
  assert.ok(isOffered, "the switch is there");
  await page.locator("#machine-bodies").check();
  const total = Number(await page.locator("#scrubber").getAttribute("max"));
  // Before, the tool length is not active, and the tool is drawn at the gauge point.
  for (const share of [0.3, 0.5, 0.7, 0.95, 1]) {
    await page.evaluate((seconds) => {
      const scrubber = document.querySelector("#scrubber");
      scrubber.value = String(seconds);
      scrubber.dispatchEvent(new Event("input"));
    }, total * share);
    const { tool, places } = await page.evaluate(() => ({ tool: window.chordal.view.toolPose(), places: window.chordal.view.machine.places() }));
    // The gauge point is at the zero of the machine with all axes at zero.
    const gauge = tool.at.map((value, axis) => value + TOOL_LENGTH_MM * tool.up[axis]);
    const distance = Math.hypot(...places.nose.map((value, axis) => value - gauge[axis]));
    assert.ok(tool.isShown && distance < 0.01, `${share}: ${distance} mm`);
    await picture(page, `machine-${share}`);
  }
  assert.deepEqual(complaints, []);
});
