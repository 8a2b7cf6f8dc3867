// Charts of the pages of `sweep report` and `sweep explore`: an SVG of lines that fills the room
// there is, with words around it that keep their size. `plot.css` has their looks.
//
//   chart({ title, words, ends, lines, shape, circle, here, sides, names })   a chart
//       words: what is along x and along y; ends: [[low, high], [low, high]]; lines:
//       [{ x, y, look }], whose look is a class; shape: width over height; circle: the radius of
//       a wall around the origin; here: a place [x, y] with a dot; sides: areas, each as its
//       corners { x, y }; names: words at places, [{ text, at: [x, y] }].
//   overTime(title, time, values, { unit, size }, also)         a quantity over time, s
//   ofCutting(time, { weight, depth, drilled }, { force, width })   how a bit cuts, over time
//   orbit(title, { x, y }, { unit, size }, clearance, closing)  an orbit in its hole, heavy from
//       the step `closing` on
//   placeIn(element, ends, event)                               the values under a pointer
//       size: how much of the values' unit the unit that is shown is; also: a value that the axis
//       has room for.

const SVG = "http://www.w3.org/2000/svg";

/** An element with attributes and content. Text is only ever put in as text. */
const make = (name, attributes = {}, ...content) => {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...content);
  return element;
};

const draw = (name, attributes) => {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
};

/** Words with the indices of T_s, μ_d and the like below the line. */
const indexed = (text) =>
  text.split(/(?<=\S)_(\w)(?!\w)/).map((piece, place) => (place % 2 ? make("sub", {}, piece) : piece));

/** A number in digits that are read, all of them where one looks closer. */
const readable = (value) => {
  const rounded = Number(value.toPrecision(4));
  return rounded.toString().replace("-", "−");
};

/** Round numbers between two ends. */
const ticksOf = (low, high, most) => {
  const rough = (high - low) / most || 1;
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * decade).find((size) => size >= rough);
  const first = Math.ceil(low / step);
  const count = Math.max(0, Math.floor(high / step) - first + 1);
  return Array.from({ length: count }, (_, place) => Number(((first + place) * step).toPrecision(12)));
};

/** Ends of an axis that has all of some values and another one, with room. */
const endsOf = (values, also) => {
  let [low, high] = also === undefined ? [Infinity, -Infinity] : [also, also];
  for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
  const room = 0.04 * (high - low) || Math.abs(high) || 1;
  return [low - room, high + room];
};

/** Points of a line: where many lie within a third of a unit of the last, they are left out, as are invalid ones. */
const thinned = (x, y, across, down) => {
  const points = [];
  let [left, top] = [NaN, NaN];
  for (let place = 0; place < x.length; place += 1) {
    const [here, there] = [across(x[place]), down(y[place])];
    if (!Number.isFinite(here + there)) continue;
    if (Math.abs(here - left) < 0.3 && Math.abs(there - top) < 0.3) continue;
    [left, top] = [here, there];
    points.push(`${here.toFixed(1)} ${there.toFixed(1)}`);
  }
  return points;
};

/** What is inside the frame of a chart; `place` gives a value's place along an axis, from 0 to 1. */
const drawn = ({ title, ends, lines, shape, circle, sides = [] }, ticks, place) => {
  const [width, height] = [600, 600 / shape];
  const across = (value) => place(0, value) * width;
  const down = (value) => (1 - place(1, value)) * height;
  const svg = draw("svg", { viewBox: `0 0 ${width} ${height}`, preserveAspectRatio: "none", role: "img", "aria-label": title });
  const upright = ticks[0].map((value) => `M${across(value).toFixed(1)} 0v${height}`);
  const level = ticks[1].map((value) => `M0 ${down(value).toFixed(1)}h${width}`);
  svg.append(draw("path", { class: "grid", d: upright.concat(level).join("") }));
  if (circle) {
    const [rx, ry] = [0, 1].map((axis) => (circle / (ends[axis][1] - ends[axis][0])) * [width, height][axis]);
    svg.append(draw("ellipse", { class: "wall", cx: across(0), cy: down(0), rx, ry }));
  }
  for (const { x, y } of sides) {
    const points = thinned(x, y, across, down);
    if (points.length > 0) svg.append(draw("path", { class: "side", d: `M${points.join("L")}z` }));
  }
  for (const { x, y, look } of lines) {
    const points = thinned(x, y, across, down);
    if (points.length > 0) svg.append(draw("path", { class: look, d: `M${points.join("L")}` }));
  }
  return svg;
};

const chart = (asked) => {
  const { title, words, ends, shape, here, names = [] } = asked;
  const place = (axis, value) => (value - ends[axis][0]) / (ends[axis][1] - ends[axis][0]);
  const ticks = ends.map(([low, high], axis) => ticksOf(low, high, axis ? 4 : 6));
  const spans = (axis, side) =>
    ticks[axis].map((value) => {
      const span = make("span", {}, readable(value));
      span.style[side] = `${100 * place(axis, value)}%`;
      return span;
    });
  const widest = ticks[1].map(readable).reduce((one, other) => (other.length > one.length ? other : one), "");
  const area = make("div", { class: "area" }, drawn(asked, ticks, place));
  area.style.aspectRatio = shape;
  if (here) {
    const dot = make("span", { class: "dot" });
    dot.style.left = `${100 * place(0, here[0])}%`;
    dot.style.bottom = `${100 * place(1, here[1])}%`;
    area.append(dot);
  }
  for (const { text, at } of names) {
    const name = make("span", { class: "name" }, text);
    const [right, up] = [0, 1].map((axis) => place(axis, at[axis]));
    // Those on the right half stand to the left of their place.
    if (right <= 0.5) name.style.left = `${100 * right}%`;
    else name.style.right = `${100 * (1 - right)}%`;
    name.style.top = `${100 * (1 - up)}%`;
    area.append(name);
  }
  return make(
    "div",
    { class: shape === 1 ? "panel square" : "panel" },
    make("h4", {}, title),
    make(
      "div",
      { class: "plot" },
      make("div", { class: "title-y" }, make("span", {}, ...indexed(words[1]))),
      make("div", { class: "axis-y" }, make("i", { "aria-hidden": "true" }, widest), ...spans(1, "bottom")),
      area,
      make("div", { class: "axis-x" }, ...spans(0, "left")),
      make("div", { class: "title-x" }, ...indexed(words[0])),
    ),
  );
};

const overTime = (title, time, values, { unit, size }, also) => {
  const y = values.map((value) => value / size);
  const lines = [{ x: time, y, look: "curve" }];
  const ends = [[time[0], time.at(-1)], endsOf(y, also)];
  return chart({ title, words: ["Time (s)", unit], ends, lines, shape: 3 });
};

const ofCutting = (time, { weight, depth, drilled }, { force, width }) => {
  const units = (words, { unit, size }) => ({ unit: `${words} (${unit})`, size });
  return [
    overTime("Weight on bit", time, weight, units("Weight", force), 0),
    overTime("Depth of cut of a blade; below zero off bottom", time, depth, units("Depth", width), 0),
    overTime("Depth of the bit", time, drilled, units("Depth", width), 0),
  ];
};

const orbit = (title, path, { unit, size }, clearance, closing) => {
  const [x, y] = [path.x, path.y].map((values) => values.map((value) => value / size));
  const circle = clearance && clearance / size;
  const reach = 1.08 * Math.max(circle || 0, ...[x, y].map((values) => Math.max(...endsOf(values).map(Math.abs))));
  const lines = [
    { x, y, look: "curve before" },
    { x: x.subarray(closing), y: y.subarray(closing), look: "curve" },
  ];
  const ends = [0, 1].map(() => [-reach, reach]);
  return chart({ title, words: [`x (${unit})`, `y (${unit})`], ends, lines, circle, shape: 1 });
};

/** How long the end of an orbit is that is heavy, s, and the first step of it. */
const CLOSING = 2;
const closingOf = (time) => time.findIndex((moment) => moment > time.at(-1) - CLOSING);

const placeIn = (element, ends, { clientX, clientY }) => {
  const { left, top, width, height } = element.querySelector("svg").getBoundingClientRect();
  const parts = [(clientX - left) / width, 1 - (clientY - top) / height];
  return ends.map(([low, high], axis) => low + Math.min(1, Math.max(0, parts[axis])) * (high - low));
};
