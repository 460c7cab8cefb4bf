// Whatever is given, there is an answer or a ChordalError, and the next question is answered.

import assert from "node:assert/strict";
import { test } from "node:test";

import * as chordal from "../dist/index.js";
import { ask, memoryInUse } from "../dist/engine.js";
import { questionOf } from "../dist/question.js";
import { start } from "../dist/worker.js";

const PART = "%\nO1\nG21 G90 G54 S900 M3\nG0 X0. Y0. Z5.\nG1 Z0. F100.\nX10.\nG2 X20. Y10. I0. J10.\nM30\n%\n";
const HAAS = { machine: "haas-vf2" };

async function works() {
  assert.equal((await chordal.check(PART, HAAS)).machine, "haas-vf2");
}

/** A ChordalError of a kind, whose message says something. */
async function refused(promise, kind, says) {
  const error = await promise.then(
    (answer) => assert.fail(`answered: ${JSON.stringify(answer)?.slice(0, 200)}`),
    (error) => error,
  );
  assert.equal(error.name, "ChordalError", String(error.stack));
  assert.equal(error.kind, kind, error.message);
  assert.match(error.message, says);
}

test("a program that is not a text", async () => {
  for (const [text, is] of [[undefined, "undefined"], [null, "null"], [7, "number"], [{}, "object"], [["G0"], "an array"], [Symbol("x"), "symbol"]]) {
    await refused(chordal.check(text), "use", new RegExp(`^the program is ${is}$`));
  }
  await refused(chordal.check(PART, { files: { "O2.nc": 2 } }), "use", /^the file O2.nc is number$/);
  await refused(chordal.check(PART, "haas-vf2"), "use", /^the options are a string$/);
  await works();
});

test("odd texts have an answer", async () => {
  const odd = [
    "", "\0", "%", "\uD800", "\u{1F600}".repeat(1000), "(".repeat(100_000), "[".repeat(100_000), `#1=${"[".repeat(50_000)}1`,
    "G1".repeat(2_000), "X".repeat(1_000_000), "\n".repeat(1_000_000), "G0 X1e999", "M98 P1", "G65 P1", "O1 M99", "WHILE [1] DO1\nEND1",
    "N1 GOTO 1", "G1 X99999999999999999999 F1e300", "\r\n\r\n", `G2 X0 Y0 I1e-300 J1e300 F1`,
  ];
  for (const text of odd) {
    for (const machine of ["haas-vf2", "fadal-4020", "linuxcnc-mill", "shapeoko-3"]) {
      const answer = await chordal.check(text, { machine, maxBlocks: 10_000 }).catch((error) => error);
      const kind = answer instanceof chordal.ChordalError ? answer.kind : answer.schema;
      assert.ok(kind === "chordal.diagnostics/1" || kind === "use", `${text.slice(0, 20)} on ${machine}: ${answer}`);
    }
  }
  for (let seed = 1; seed < 200; seed++) {
    const bytes = new Uint8Array(257).map((_, at) => (Math.imul(seed * 257 + at, 2654435761) >>> 13) & 255);
    assert.equal((await chordal.check(bytes)).schema, "chordal.diagnostics/1");
  }
  await works();
});

test("options that do not go", async () => {
  await refused(chordal.check(PART, { machin: "haas-vf2" }), "use", /unknown option `machin`/);
  await refused(chordal.check(PART, { machine: "haas-vf99" }), "use", /haas-vf99/);
  await refused(chordal.check(PART, { machine: 5 }), "use", /expected a string/);
  await refused(chordal.check(PART, { machine: "/etc/passwd.toml" }), "file", /is not among the given files/);
  await refused(chordal.check(PART, { machine: "m.toml", files: { "m.toml": "control = 'haas'\naxis = 1" } }), "machine", /m\.toml:2/);
  await refused(chordal.check(PART, { machine: "m.toml", files: { "m.toml": "inherits = 'm.toml'" } }), "machine", /m\.toml/);
  await refused(chordal.check(PART, { set: ["tools.5.diameter=0.5"] }), "machine", /./);
  await refused(chordal.check(PART, { ...HAAS, program: 2 }), "use", /no program O2/);
  await refused(chordal.check(PART, { ...HAAS, program: -1 }), "use", /-1/);
  await refused(chordal.check(PART, { ...HAAS, format: "xml" }), "use", /xml/);
  await refused(chordal.check(PART, { ...HAAS, format: "csv" }), "use", /does not have this format/);
  await refused(chordal.check(PART, { ...HAAS, maxBlocks: 1n }), "use", /BigInt/);
  const circle = {};
  circle.circle = circle;
  await refused(chordal.check(PART, { ...HAAS, circle }), "use", /circular/i);
  for (const period of [0, -1, NaN, Infinity, "1ms"]) {
    await refused(chordal.sample(PART, { ...HAAS, period }), "use", /./);
  }
  await refused(chordal.sample(PART, { ...HAAS, period: 1e-9 }), "use", /more than 5000000 setpoints: the run takes at least/);
  await refused(chordal.compare(PART, PART, { ignore: ["colour"] }), "use", /no category `colour`/);
  await refused(chordal.compare(PART, PART, { a: { ...HAAS, to: "x" } }), "use", /unknown option `to`/);
  await refused(chordal.convert(PART, HAAS), "use", /missing field `to`/);
  await refused(chordal.convert(PART, { ...HAAS, to: "nothing" }), "use", /nothing/);
  await refused(chordal.convert(PART, { ...HAAS, to: "fanuc-30i", tolerance: -1 }), "use", /`tolerance` is -1/);
  await refused(chordal.convert(PART, { ...HAAS, to: "fanuc-30i", digits: 400 }), "use", /above 9/);
  await refused(chordal.explain("CH9999"), "use", /CH9999/);
  await refused(chordal.explain(), "use", /missing field `word`/);
  await refused(chordal.machine("../../x"), "use", /./);
  await works();
});

test("a program without an end ends", async () => {
  const { diagnostics } = await chordal.check("%\nO1\nN1 G0 X1.\nX0.\nGOTO 1\nM30\n%", { machine: "haas-vf2", maxBlocks: 10_000 });
  assert.ok(diagnostics.some((one) => one.severity === "error"), JSON.stringify(diagnostics));
});

test("after a panic the next question is answered", async () => {
  await refused(ask(questionOf("panic", [], [], {})), "inside", /Chordal failed: .*asked to panic/s);
  await works();
});

test("after memory has run out the next question is answered", async () => {
  await works();
  const memory = memoryInUse();
  // What nobody writes to is not really taken.
  memory.grow(65_536 - memory.buffer.byteLength / 65_536 - 64);
  const large = `${PART}${"G1 X1. F100.\n".repeat(1_000_000)}`;
  const error = await chordal.commands(large, HAAS).then(() => assert.fail("answered"), (error) => error);
  assert.equal(error.name, "ChordalError", String(error.stack));
  assert.ok(["use", "inside"].includes(error.kind), error.message);
  await works();
});

test("a question that there is not", async () => {
  await refused(ask(questionOf("nothing", [], [], {})), "use", /no question `nothing`/);
  await refused(ask(questionOf("check", [], [], {})), "use", /there is no program/);
  const [length, head] = questionOf("check", [{ options: {}, text: new TextEncoder().encode(PART) }], [], {});
  for (const torn of [[], [length], [head], [length, head], [head, length], [new Uint8Array(100).fill(255)]]) {
    await refused(ask(torn), "use", /the request (ends too early|cannot be read)/);
  }
  await works();
});

test("a worker answers, refuses and closes", async () => {
  const worker = await start();
  const [found, again] = await Promise.all([worker.check(PART, HAAS), worker.curves(PART, HAAS)]);
  assert.deepEqual(found, await chordal.check(PART, HAAS));
  assert.deepEqual(again.columns, (await chordal.curves(PART, HAAS)).columns);
  await refused(worker.check(PART, { machine: "haas-vf99" }), "use", /haas-vf99/);
  await refused(worker.check(PART, { ...HAAS, maxBlocks: 1n }), "use", /BigInt/);
  await refused(worker.check(PART, { name: () => 1 }), "use", /./);
  const waiting = worker.time(PART, HAAS);
  worker.close();
  await refused(waiting, "closed", /closed/);
  await refused(worker.check(PART), "closed", /closed/);
});
