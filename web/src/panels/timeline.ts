// The timeline: speed over time, a scrubber, and playback.

import { type EngagementCurve, type EngagementMeasure, measureText } from "../path/engagement";
import { type Setpoints, speedBands } from "../path/setpoints";
import { type IconName, icon, signButton } from "./icons";
import { type Units, duration, speed } from "./units";

export const PLAYBACK_RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50, 200];

export class Timeline {
  private points: Setpoints | undefined;
  private units: Units = { inch: false };
  private now = 0;
  private playing = false;
  private rate = PLAYBACK_RATES.indexOf(1);
  private before = 0;
  private canvas: HTMLCanvasElement;
  private slider: HTMLInputElement;
  private clock: HTMLElement;
  private rateText: HTMLElement;
  private playButton: HTMLButtonElement;
  private choice: HTMLSelectElement;
  private engagement: EngagementCurve | undefined;
  onTime: (seconds: number, playing: boolean) => void = () => {};
  onStep: (direction: 1 | -1) => void = () => {};
  onToCursor: () => void = () => {};

  constructor(root: HTMLElement) {
    const bar = document.createElement("div");
    bar.className = "transport";
    this.playButton = signButton("play", "Play (Space)", () => this.toggle());
    this.playButton.id = "play";
    this.rateText = document.createElement("span");
    this.rateText.className = "rate";
    this.clock = document.createElement("span");
    this.clock.className = "clock";
    this.clock.id = "clock";
    this.choice = document.createElement("select");
    this.choice.id = "over-time";
    this.choice.setAttribute("aria-label", "What is drawn over time");
    this.choice.addEventListener("change", () => this.draw());
    this.choice.hidden = true;
    bar.append(
      signButton("start", "To the start", () => this.seek(0)),
      signButton("back", "Previous block (,)", () => this.onStep(-1)),
      this.playButton,
      signButton("next", "Next block (.)", () => this.onStep(1)),
      signButton("cursor", "To the line of the cursor (R)", () => this.onToCursor()),
      signButton("minus", "Slower ([)", () => this.faster(-1)),
      this.rateText,
      signButton("plus", "Faster (])", () => this.faster(1)),
      this.clock,
      this.choice,
    );
    const plot = document.createElement("div");
    plot.className = "plot";
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "Speed over time");
    this.slider = document.createElement("input");
    this.slider.type = "range";
    this.slider.id = "scrubber";
    this.slider.min = "0";
    this.slider.max = "1";
    this.slider.step = "any";
    this.slider.value = "0";
    this.slider.setAttribute("aria-label", "Time");
    this.slider.addEventListener("input", () => {
      // Read before the pause shows the old time again.
      const seconds = Number(this.slider.value);
      this.pause();
      this.seek(seconds);
    });
    plot.append(this.canvas, this.slider);
    root.append(bar, plot);
    new ResizeObserver(() => this.draw()).observe(plot);
    this.show();
  }

  get time(): number {
    return this.now;
  }

  get isPlaying(): boolean {
    return this.playing;
  }

  clear(): void {
    this.points = undefined;
    this.setEngagement(undefined);
    this.pause();
    this.draw();
    this.show();
  }

  set(points: Setpoints, units: Units): void {
    this.points = points;
    this.units = units;
    this.slider.max = String(points.totalS);
    this.now = Math.min(this.now, points.totalS);
    this.draw();
    this.show();
  }

  /** Cutting loads, once they are known. */
  setEngagement(engagement: EngagementCurve | undefined): void {
    const { value } = this.choice;
    this.engagement = engagement;
    this.choice.hidden = !engagement;
    const known = engagement?.labels ?? [];
    this.choice.replaceChildren(...[["speed", "Speed"], ...known].map(([key, text]) => new Option(text, key)));
    this.choice.value = known.some(([measure]) => measure === value) ? value : "speed";
    this.draw();
  }

  private get measure(): EngagementMeasure | undefined {
    return this.engagement && this.choice.value !== "speed" ? (this.choice.value as EngagementMeasure) : undefined;
  }

  toggle(): void {
    if (!this.points) return;
    if (this.playing) {
      this.pause();
      return;
    }
    if (this.now >= this.points.totalS) this.now = 0;
    this.playing = true;
    this.before = performance.now();
    requestAnimationFrame((at) => this.tick(at));
    this.show();
  }

  pause(): void {
    this.playing = false;
    this.show();
  }

  faster(by: number): void {
    this.rate = Math.min(PLAYBACK_RATES.length - 1, Math.max(0, this.rate + by));
    this.show();
  }

  private tick(at: number): void {
    if (!this.playing || !this.points) return;
    const passed = Math.max(0, at - this.before) / 1000;
    this.before = at;
    const next = this.now + passed * PLAYBACK_RATES[this.rate]!;
    if (next >= this.points.totalS) this.playing = false;
    this.seek(next);
    if (this.playing) requestAnimationFrame((then) => this.tick(then));
  }

  seek(seconds: number): void {
    const total = this.points?.totalS ?? 0;
    this.now = Math.min(total, Math.max(0, seconds));
    this.show();
    this.onTime(this.now, this.playing);
  }

  /** Shows a time without calling `onTime`. */
  put(seconds: number): void {
    this.now = Math.min(this.points?.totalS ?? 0, Math.max(0, seconds));
    this.show();
  }

  private show(): void {
    const total = this.points?.totalS ?? 0;
    this.showSign();
    this.rateText.textContent = `${PLAYBACK_RATES[this.rate]}×`;
    this.clock.textContent = this.points ? `${duration(this.now)} / ${duration(total)}` : "planning…";
    this.slider.disabled = !this.points;
    this.slider.value = String(this.now);
    this.slider.setAttribute("aria-valuetext", duration(this.now));
  }

  private showSign(): void {
    const sign: IconName = this.playing ? "pause" : "play";
    const label = this.playing ? "Pause (Space)" : "Play (Space)";
    this.playButton.setAttribute("aria-label", label);
    this.playButton.title = label;
    if (this.playButton.querySelector("svg")?.dataset.sign !== sign) this.playButton.replaceChildren(icon(sign));
  }

  setMessage(text: string): void {
    this.clock.textContent = text;
  }

  draw(): void {
    const { canvas, points } = this;
    const { clientWidth: width, clientHeight: height } = canvas;
    const scale = Math.min(2, window.devicePixelRatio);
    canvas.width = Math.max(1, Math.round(width * scale));
    canvas.height = Math.max(1, Math.round(height * scale));
    const context = canvas.getContext("2d");
    if (!context || !points || width === 0 || points.totalS <= 0) return;
    const style = getComputedStyle(canvas);
    const { measure } = this;
    const bands = this.engagement?.bands(measure, points, canvas.width);
    const [low, high] = measure && bands ? [new Float32Array(canvas.width), bands.maxima] : speedBands(points, canvas.width);
    canvas.setAttribute("aria-label", `${measure ? this.choice.selectedOptions[0]?.text : "Speed"} over time`);
    const most = high.reduce((a, b) => (b > a ? b : a), 0) || 1;
    const y = (value: number) => canvas.height - 1 - (value / most) * (canvas.height - 16 * scale);
    context.fillStyle = style.getPropertyValue("--plot-fill");
    context.strokeStyle = style.getPropertyValue("--plot-line");
    context.lineWidth = scale;
    context.beginPath();
    context.moveTo(0, canvas.height);
    for (let x = 0; x < high.length; x++) context.lineTo(x, y(high[x]!));
    context.lineTo(canvas.width, canvas.height);
    context.fill();
    context.beginPath();
    for (let x = 0; x < high.length; x++) {
      context.moveTo(x, measure ? y(high[x]!) : y(low[x]!));
      context.lineTo(x, y(high[x]!) - 1);
    }
    context.stroke();
    context.fillStyle = style.getPropertyValue("--plot-text");
    context.font = `${11 * scale}px system-ui, sans-serif`;
    const text = measure ? `at most ${measureText(this.units, measure, high.reduce((a, b) => Math.max(a, b), 0))}` : speed(this.units, most);
    context.fillText(text, 4 * scale, 11 * scale);
    // Moves that are too much, or rub: where, and how many parts of the line.
    for (const [fault, color] of [["rubs", "--warning"], ["overload", "--error"]] as const) {
      context.fillStyle = style.getPropertyValue(color);
      bands?.faults.forEach((own, x) => own === fault && context.fillRect(x, canvas.height - 4 * scale, Math.max(1, scale), 4 * scale));
    }
  }
}
