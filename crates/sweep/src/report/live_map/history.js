// A case's motion, simulated in the page.

/** Round numbers between two ends. */
const ticksOf = (low, high, most) => {
  const rough = (high - low) / most || 1;
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * decade).find((size) => size >= rough);
  const first = Math.ceil(low / step);
  const count = Math.max(0, Math.floor(high / step) - first + 1);
  return Array.from({ length: count }, (_, place) => Number(((first + place) * step).toPrecision(12)));
};

/** Ends of an axis that has all of some values, with room. */
const endsOf = (values) => {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
  const room = 0.04 * (high - low) || Math.abs(high) || 1;
  return [low - room, high + room];
};

const SVG = "http://www.w3.org/2000/svg";
const draw = (name, attributes) => {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
};

/** A chart of lines `{ x, y, look }`: drawn in whatever room there is, with words that keep their size. */
const chart = ({ title, words, ends, lines, circle, shape }) => {
  const [width, height] = [600, 600 / shape];
  const place = (axis, value) => (value - ends[axis][0]) / (ends[axis][1] - ends[axis][0]);
  const svg = draw("svg", { viewBox: `0 0 ${width} ${height}`, preserveAspectRatio: "none", role: "img", "aria-label": title });
  const ticks = ends.map(([low, high], axis) => ticksOf(low, high, axis ? 4 : 6));
  const across = ticks[0].map((value) => `M${(place(0, value) * width).toFixed(1)} 0v${height}`);
  const level = ticks[1].map((value) => `M0 ${((1 - place(1, value)) * height).toFixed(1)}h${width}`);
  svg.append(draw("path", { class: "grid", d: across.concat(level).join("") }));
  if (circle) {
    const [rx, ry] = [0, 1].map((axis) => (circle / (ends[axis][1] - ends[axis][0])) * [width, height][axis]);
    svg.append(draw("ellipse", { class: "wall", cx: place(0, 0) * width, cy: (1 - place(1, 0)) * height, rx, ry }));
  }
  for (const { x, y, look } of lines) {
    const points = thinned(x, y, (value) => place(0, value) * width, (value) => (1 - place(1, value)) * height);
    svg.append(draw("path", { class: look, d: `M${points.join("L")}` }));
  }
  const spans = (axis, side) =>
    ticks[axis].map((value) => {
      const span = make("span", {}, readable(value));
      span.style[side] = `${100 * place(axis, value)}%`;
      return span;
    });
  const widest = ticks[1].map(readable).reduce((one, other) => (other.length > one.length ? other : one), "");
  const area = make("div", { class: "area" }, svg);
  area.style.aspectRatio = shape;
  return make(
    "div",
    { class: "panel" },
    make("h4", {}, title),
    make(
      "div",
      { class: "plot" },
      make("div", { class: "title-y" }, make("span", {}, words[1])),
      make("div", { class: "axis-y" }, make("i", { "aria-hidden": "true" }, widest), ...spans(1, "bottom")),
      area,
      make("div", { class: "axis-x" }, ...spans(0, "left")),
      make("div", { class: "title-x" }, words[0]),
    ),
  );
};

/** Points of a line: where many lie within a tenth of a unit of the last, they are left out. */
const thinned = (x, y, across, down) => {
  const points = [];
  let [left, top] = [NaN, NaN];
  for (let place = 0; place < x.length; place += 1) {
    const [here, there] = [across(x[place]), down(y[place])];
    if (Math.abs(here - left) < 0.3 && Math.abs(there - top) < 0.3) continue;
    [left, top] = [here, there];
    points.push(`${here.toFixed(1)} ${there.toFixed(1)}`);
  }
  return points;
};

/** The engine of the page, with one sweep open at a time. */
class PageEngine {
  constructor(element) {
    this.element = element;
    this.stop();
  }

  /** Whether the page holds it, and this browser can run it. */
  get isThere() {
    return this.element !== null && typeof WebAssembly === "object" && typeof DecompressionStream === "function";
  }

  /** Ends what is under way: its answer never comes. */
  stop() {
    this.started?.then((engine) => engine.close());
    this.started = null;
    this.opening = null;
    this.isBusy = false;
  }

  /** Simulates a case of a sweep: what the engine answers, with the sweep's description. */
  async simulate(opening, asked) {
    this.started ??= startEngine(this.element.textContent.trim());
    const { started } = this;
    this.isBusy = true;
    try {
      const engine = await started;
      if (this.opening !== opening) {
        this.description = await engine.open(opening);
        this.opening = opening;
      }
      return { ...(await engine.simulate(asked)), description: this.description };
    } finally {
      // Another may have been started meanwhile.
      if (this.started === started) this.isBusy = false;
    }
  }
}

const engine = new PageEngine(document.getElementById("engine"));

/** How long the end of an orbit is that is set off, s. */
const CLOSING = 2;

/** The charts of a motion: bit speed, torque on bit and, with a wall, the orbit of the site that decides. */
const charts = (cases, { row, time, speed, torque, positions, description }) => {
  const found = [];
  const overTime = (values, title, { unit, size }) => {
    if (!values) return;
    const y = values.map((value) => value / size);
    const lines = [{ x: time, y, look: "curve" }];
    found.push(chart({ title, words: ["Time (s)", unit], ends: [[time[0], time.at(-1)], endsOf(y)], lines, shape: 3 }));
  };
  overTime(speed, "Bit speed", { unit: "rpm", size: 1 });
  overTime(torque, "Torque on bit", cases.shown.torque);
  const from = row.site_from_bit_m ?? 0;
  const site = from === 0 ? "bit" : `${from}m_above_bit`;
  const orbit = positions.find((one) => one.site === site);
  if (!orbit) return found;
  const { unit, size } = cases.shown.width;
  const [x, y] = [orbit.x, orbit.y].map((values) => values.map((value) => value / size));
  const place = description.sites_from_bit_m.indexOf(from);
  const clearance = description.clearances_mm?.[place] / size;
  const reach = 1.08 * Math.max(clearance || 0, ...[x, y].map((values) => Math.max(...endsOf(values).map(Math.abs))));
  const closing = time.findIndex((moment) => moment > time.at(-1) - CLOSING);
  const lines = [
    { x, y, look: "curve before" },
    { x: x.subarray(closing), y: y.subarray(closing), look: "curve" },
  ];
  const title = `Orbit ${from === 0 ? "of the bit" : `${from} m above the bit`}; heavy: the last ${CLOSING} s; dashed: the wall`;
  const ends = [0, 1].map(() => [-reach, reach]);
  found.push(chart({ title, words: [`x (${unit})`, `y (${unit})`], ends, lines, circle: clearance, shape: 1 }));
  return found;
};

/** What the engine opens: a list of cases is given back to it. */
const openingOf = (cases) => {
  const { path, sweep, list } = cases.opening;
  const texts = {};
  if (list) {
    const row = (index) => cases.values.map((values) => values[index]).join(",");
    const names = cases.axes.map(({ name }) => name).join(",");
    texts[list] = [names, ...[...cases.cases.keys()].map(row)].join("\n");
  }
  return { path, sweep, texts };
};

/** Simulates a case and shows its motion; `shown` is emptied first. */
const showHistory = async (cases, index, method, shown) => {
  const status = make("p", { class: "note", role: "status" }, "Simulating …");
  shown.replaceChildren(status);
  cases.asked ??= openingOf(cases);
  const number = cases.opening.list ? index : cases.cases[index];
  const asked = { case: number, method: cases.methods[method], full: cases.full };
  try {
    const history = await engine.simulate(cases.asked, asked);
    const label = (name) => history.row[name]?.replaceAll("_", " ");
    const labels = LABELS.map(label).filter((words) => words).join(", ");
    status.textContent = `${cases.methods[method]}, simulated in this page in ${Math.ceil(history.milliseconds)} ms: ${labels}`;
    shown.append(make("div", { class: "panels" }, ...charts(cases, history)));
    document.dispatchEvent(new CustomEvent("history", { detail: { case: number, method: asked.method, ...history } }));
  } catch (error) {
    status.textContent = `Not simulated: ${error.message}.`;
  }
};

/** The part of an opened case that simulates it; what is missing for that is said. */
const historyOf = (cases, index) => {
  const { absent } = cases.opening;
  if (!engine.isThere) return [];
  if (absent) {
    return [make("p", { class: "note" }, `Its motion takes ${absent.join(" and ")}, which is not in the results folder: the command simulates it.`)];
  }
  const shown = make("div", { class: "history" });
  const buttons = cases.methods.map((name, method) => {
    const button = make("button", { type: "button", "aria-pressed": "false" }, name);
    button.addEventListener("click", () => choose(method));
    return button;
  });
  const choose = (method) => {
    if (engine.isBusy) engine.stop();
    buttons.forEach((button, place) => button.setAttribute("aria-pressed", String(place === method)));
    showHistory(cases, index, method, shown);
  };
  choose(0);
  const group = make("p", { class: "command", role: "group", "aria-label": "Method" }, ...buttons);
  return cases.methods.length > 1 ? [group, shown] : [shown];
};
