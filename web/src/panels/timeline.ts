// The timeline: speed over time, a scrubber, and playback.

import { type EngagementCurve, type EngagementMeasure, measureText } from "../path/engagement";
import { type Setpoints, speedBands } from "../path/setpoints";
import { type IconName, icon, iconButton } from "./icons";
import { type Units, duration, speed } from "./units";

export const PLAYBACK_RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10, 50, 200];

export class Timeline {
  private setpoints: Setpoints | undefined;
  private units: Units = { inch: false };
  /** The present time of the run, s. */
  private now = 0;
  private playing = false;
  /** Index in `PLAYBACK_RATES`. */
  private rate = PLAYBACK_RATES.indexOf(1);
  /** When the last frame of the playback began, ms. */
  private lastFrameMs = 0;
  private canvas: HTMLCanvasElement;
  private slider: HTMLInputElement;
  private clock: HTMLElement;
  private rateText: HTMLElement;
  private playButton: HTMLButtonElement;
  private measureSelect: HTMLSelectElement;
  private engagement: EngagementCurve | undefined;
  /** Called when the time was changed by the user or by playback. */
  onTime: (seconds: number, playing: boolean) => void = () => {};
  onStep: (direction: 1 | -1) => void = () => {};
  onToCursor: () => void = () => {};

  constructor(root: HTMLElement) {
    const bar = document.createElement("div");
    bar.className = "transport";
    this.playButton = iconButton("play", "Play (Space)", () => this.toggle());
    this.playButton.id = "play";
    this.rateText = document.createElement("span");
    this.rateText.className = "rate";
    this.clock = document.createElement("span");
    this.clock.className = "clock";
    this.clock.id = "clock";
    this.measureSelect = document.createElement("select");
    this.measureSelect.id = "over-time";
    this.measureSelect.setAttribute("aria-label", "What is drawn over time");
    this.measureSelect.addEventListener("change", () => this.draw());
    this.measureSelect.hidden = true;
    bar.append(
      iconButton("start", "To the start", () => this.seek(0)),
      iconButton("back", "Previous block (,)", () => this.onStep(-1)),
      this.playButton,
      iconButton("next", "Next block (.)", () => this.onStep(1)),
      iconButton("cursor", "To the line of the cursor (R)", () => this.onToCursor()),
      iconButton("minus", "Slower ([)", () => this.faster(-1)),
      this.rateText,
      iconButton("plus", "Faster (])", () => this.faster(1)),
      this.clock,
      this.measureSelect,
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
      // Read before `pause`, which sets the slider to the old time.
      const seconds = Number(this.slider.value);
      this.pause();
      this.seek(seconds);
    });
    plot.append(this.canvas, this.slider);
    root.append(bar, plot);
    new ResizeObserver(() => this.draw()).observe(plot);
    this.show();
  }

  /** The present time of the run, s. */
  get time(): number {
    return this.now;
  }

  get isPlaying(): boolean {
    return this.playing;
  }

  clear(): void {
    this.setpoints = undefined;
    this.setEngagement(undefined);
    this.pause();
    this.draw();
    this.show();
  }

  set(setpoints: Setpoints, units: Units): void {
    this.setpoints = setpoints;
    this.units = units;
    this.slider.max = String(setpoints.totalS);
    this.now = Math.min(this.now, setpoints.totalS);
    this.draw();
    this.show();
  }

  /** Sets the cutting loads; undefined until they are known. */
  setEngagement(engagement: EngagementCurve | undefined): void {
    const { value } = this.measureSelect;
    this.engagement = engagement;
    this.measureSelect.hidden = !engagement;
    const measures = engagement?.labels ?? [];
    this.measureSelect.replaceChildren(...[["speed", "Speed"], ...measures].map(([key, text]) => new Option(text, key)));
    this.measureSelect.value = measures.some(([measure]) => measure === value) ? value : "speed";
    this.draw();
  }

  private get measure(): EngagementMeasure | undefined {
    return this.engagement && this.measureSelect.value !== "speed" ? (this.measureSelect.value as EngagementMeasure) : undefined;
  }

  toggle(): void {
    if (!this.setpoints) return;
    if (this.playing) {
      this.pause();
      return;
    }
    if (this.now >= this.setpoints.totalS) this.now = 0;
    this.playing = true;
    this.lastFrameMs = performance.now();
    requestAnimationFrame((now) => this.tick(now));
    this.show();
  }

  pause(): void {
    this.playing = false;
    this.show();
  }

  /** Chooses another playback rate, `by` steps faster. */
  faster(by: number): void {
    this.rate = Math.min(PLAYBACK_RATES.length - 1, Math.max(0, this.rate + by));
    this.show();
  }

  /** A frame of the playback, which begins at `now`, ms. */
  private tick(now: number): void {
    if (!this.playing || !this.setpoints) return;
    const elapsed = Math.max(0, now - this.lastFrameMs) / 1000;
    this.lastFrameMs = now;
    const next = this.now + elapsed * PLAYBACK_RATES[this.rate]!;
    if (next >= this.setpoints.totalS) this.playing = false;
    this.seek(next);
    if (this.playing) requestAnimationFrame((nextFrame) => this.tick(nextFrame));
  }

  /** Goes to a time of the run, and calls `onTime`. */
  seek(seconds: number): void {
    const total = this.setpoints?.totalS ?? 0;
    this.now = Math.min(total, Math.max(0, seconds));
    this.show();
    this.onTime(this.now, this.playing);
  }

  /** Shows a time without calling `onTime`. */
  showTime(seconds: number): void {
    this.now = Math.min(this.setpoints?.totalS ?? 0, Math.max(0, seconds));
    this.show();
  }

  private show(): void {
    const total = this.setpoints?.totalS ?? 0;
    this.showPlayIcon();
    this.rateText.textContent = `${PLAYBACK_RATES[this.rate]}×`;
    this.clock.textContent = this.setpoints ? `${duration(this.now)} / ${duration(total)}` : "planning…";
    this.slider.disabled = !this.setpoints;
    this.slider.value = String(this.now);
    this.slider.setAttribute("aria-valuetext", duration(this.now));
  }

  private showPlayIcon(): void {
    const name: IconName = this.playing ? "pause" : "play";
    const label = this.playing ? "Pause (Space)" : "Play (Space)";
    this.playButton.setAttribute("aria-label", label);
    this.playButton.title = label;
    if (this.playButton.querySelector("svg")?.dataset.sign !== name) this.playButton.replaceChildren(icon(name));
  }

  setMessage(text: string): void {
    this.clock.textContent = text;
  }

  draw(): void {
    const { canvas, setpoints } = this;
    const { clientWidth: width, clientHeight: height } = canvas;
    const scale = Math.min(2, window.devicePixelRatio);
    canvas.width = Math.max(1, Math.round(width * scale));
    canvas.height = Math.max(1, Math.round(height * scale));
    const context = canvas.getContext("2d");
    if (!context || !setpoints || width === 0 || setpoints.totalS <= 0) return;
    const style = getComputedStyle(canvas);
    const { measure } = this;
    const bands = this.engagement?.bands(measure, setpoints, canvas.width);
    const [low, high] = measure && bands ? [new Float32Array(canvas.width), bands.maxima] : speedBands(setpoints, canvas.width);
    canvas.setAttribute("aria-label", `${measure ? this.measureSelect.selectedOptions[0]?.text : "Speed"} over time`);
    const max = high.reduce((a, b) => (b > a ? b : a), 0) || 1;
    const y = (value: number) => canvas.height - 1 - (value / max) * (canvas.height - 16 * scale);
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
    const text = measure ? `at most ${measureText(this.units, measure, high.reduce((a, b) => Math.max(a, b), 0))}` : speed(this.units, max);
    context.fillText(text, 4 * scale, 11 * scale);
    // Marks below the curve where a tool rubs or is overloaded.
    for (const [fault, color] of [["rubs", "--warning"], ["overload", "--error"]] as const) {
      context.fillStyle = style.getPropertyValue(color);
      bands?.faults.forEach((worst, x) => worst === fault && context.fillRect(x, canvas.height - 4 * scale, Math.max(1, scale), 4 * scale));
    }
  }
}
