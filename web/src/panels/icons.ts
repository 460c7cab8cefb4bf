// Icons of buttons as SVG: not all fonts have them.

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";

/** SVG paths in a square of 16 units. */
const ICON_PATHS = {
  play: "M4 2.5 13 8 4 13.5Z",
  pause: "M3.5 2.5h3v11h-3ZM9.5 2.5h3v11h-3Z",
  start: "M3 2.5h2v11H3ZM13 2.5v11L6 8Z",
  back: "M11 3v10L5 8Z",
  next: "M5 3v10l6-5Z",
  cursor: "M2 7h6V3.5L13 8l-5 4.5V9H2ZM13 2.5h1.6v11H13Z",
  minus: "M3 7.2h10v1.6H3Z",
  plus: "M3 7.2h4.2V3h1.6v4.2H13v1.6H8.8V13H7.2V8.8H3Z",
  theme: "M8 1.5a6.5 6.5 0 1 0 0 13 6.5 6.5 0 0 0 0-13ZM8 3v10A5 5 0 0 1 8 3Z",
  close: "M3.6 4.7 4.7 3.6 8 6.9l3.3-3.3 1.1 1.1L9.1 8l3.3 3.3-1.1 1.1L8 9.1l-3.3 3.3-1.1-1.1L6.9 8Z",
} as const;

export type IconName = keyof typeof ICON_PATHS;

export function icon(name: IconName): SVGSVGElement {
  const svg = document.createElementNS(SVG_NAMESPACE, "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("width", "14");
  svg.setAttribute("height", "14");
  svg.setAttribute("aria-hidden", "true");
  svg.dataset.sign = name;
  const path = document.createElementNS(SVG_NAMESPACE, "path");
  path.setAttribute("d", ICON_PATHS[name]);
  path.setAttribute("fill", "currentColor");
  path.setAttribute("fill-rule", "evenodd");
  svg.append(path);
  return svg;
}

/** A button with an icon; `label` is its accessible name and tooltip. */
export function iconButton(name: IconName, label: string, onClick: () => void): HTMLButtonElement {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "sign";
  button.append(icon(name));
  button.title = label;
  button.setAttribute("aria-label", label);
  button.addEventListener("click", onClick);
  return button;
}
