"use strict";
// Small plots of a page, in SVG, whose colours are the style sheet's variables --ink, --rule,
// --line and --accent.
//
//   plotHistory(svg, { title, time, values, unit, marks })   a quantity over time, s
//   plotOrbit(svg, { title, x, y, unit, clearance })         an orbit in its hole
//   plotMap(svg, { title, axes: [x, y], lines, here })       limits over two axes, and a dot
//       axes: { title, least, most }; lines: each of pieces [[x, y], …]; here: [x, y]; gives
//       { place(event) }, the values under a pointer.

const PLOT = { width: 480, height: 260, left: 62, right: 14, top: 26, bottom: 42 };

/** Round numbers between two, about so many. */
function plotTicks(least, most, count) {
  const rough = (most - least) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((part) => part * power).find((size) => size >= rough);
  const ticks = [];
  for (let at = Math.ceil(least / step - 1e-9); at * step <= most + 1e-9 * step; at += 1) {
    ticks.push(at * step);
  }
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return ticks.map((value) => ({ value, text: value.toFixed(Math.min(digits, 9)) }));
}

/** The frame with its ticks and titles, and how values become places in it. */
function plotFrame(svg, title, [x, y], size = PLOT) {
  const { width, height, left, right, top, bottom } = size;
  const span = ({ least, most }) => (most > least ? most - least : 1);
  const px = (value) => left + ((value - x.least) / span(x)) * (width - left - right);
  const py = (value) => height - bottom - ((value - y.least) / span(y)) * (height - top - bottom);
  const text = (at, content, more = "") =>
    `<text x="${at[0]}" y="${at[1]}" ${more}>${content.replace(/&/g, "&amp;").replace(/</g, "&lt;")}</text>`;
  let inside = text([left, 16], title, 'class="plot-title"');
  for (const { value, text: label } of plotTicks(x.least, x.least + span(x), 6)) {
    inside += `<path class="plot-rule" d="M${px(value)} ${top}V${height - bottom}"/>`
      + text([px(value), height - bottom + 16], label, 'text-anchor="middle"');
  }
  for (const { value, text: label } of plotTicks(y.least, y.least + span(y), 4)) {
    inside += `<path class="plot-rule" d="M${left} ${py(value)}H${width - right}"/>`
      + text([left - 6, py(value) + 4], label, 'text-anchor="end"');
  }
  inside += text([(left + width - right) / 2, height - 6], x.title, 'text-anchor="middle"')
    + text([0, 0], y.title, `text-anchor="middle" transform="translate(13 ${(top + height - bottom) / 2}) rotate(-90)"`);
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  return { px, py, inside };
}

function plotRange(values) {
  let [least, most] = [0, 0];
  for (const value of values) {
    if (value < least) least = value;
    if (value > most) most = value;
  }
  const margin = 0.05 * (most - least) || 1;
  return { least: least < 0 ? least - margin : 0, most: most + margin };
}

/** A line over time: of every column of pixels the first, least, greatest and last value. */
function plotPath(time, values, px, py) {
  let path = "";
  let column = null;
  const put = ({ x, first, least, most, last }) => {
    const at = (value) => `L${x.toFixed(1)} ${py(value).toFixed(1)}`;
    path += at(first) + at(least) + at(most) + at(last);
  };
  for (let step = 0; step < time.length; step += 1) {
    const x = Math.round(px(time[step]) * 2) / 2;
    const value = values[step];
    if (!column || column.x !== x) {
      if (column) put(column);
      column = { x, first: value, least: value, most: value, last: value };
    }
    column.least = Math.min(column.least, value);
    column.most = Math.max(column.most, value);
    column.last = value;
  }
  if (column) put(column);
  return path.replace("L", "M");
}

function plotHistory(svg, { title, time, values, unit, marks = [] }) {
  const x = { least: 0, most: time[time.length - 1], title: "Time t (s)" };
  const y = { ...plotRange(values), title: unit };
  const { px, py, inside } = plotFrame(svg, title, [x, y]);
  const mark = (value) => `<path class="plot-mark" d="M${px(x.least)} ${py(value)}H${px(x.most)}"/>`;
  svg.innerHTML = inside + marks.map(mark).join("")
    + `<path class="plot-line" d="${plotPath(time, values, px, py)}"/>`;
}

function plotOrbit(svg, { title, x, y, unit, clearance }) {
  let reach = clearance ?? 0;
  for (let step = 0; step < x.length; step += 1) reach = Math.max(reach, Math.hypot(x[step], y[step]));
  reach *= 1.05;
  const side = (name) => ({ least: -reach, most: reach, title: `${name} (${unit})` });
  const size = { ...PLOT, width: 380, height: 372 };
  const { px, py, inside } = plotFrame(svg, title, [side("x"), side("y")], size);
  let path = "";
  let last = null;
  for (let step = 0; step < x.length; step += 1) {
    const place = `${px(x[step]).toFixed(1)} ${py(y[step]).toFixed(1)}`;
    if (place !== last) path += `${path ? "L" : "M"}${place}`;
    last = place;
  }
  const wall = clearance === undefined ? "" : `<ellipse class="plot-mark" cx="${px(0)}" cy="${py(0)}"
    rx="${px(clearance) - px(0)}" ry="${py(0) - py(clearance)}"/>`;
  svg.innerHTML = `${inside}${wall}<path class="plot-line plot-orbit" d="${path}"/>`;
}

function plotMap(svg, { title, axes, lines, here }) {
  const { px, py, inside } = plotFrame(svg, title, axes);
  const within = ([x, y]) => x >= axes[0].least && x <= axes[0].most && y >= axes[1].least && y <= axes[1].most;
  // What leaves the frame is not joined to where it comes back.
  const joined = (piece) => piece.map((point, at) => {
    if (!within(point)) return "";
    const command = at > 0 && within(piece[at - 1]) ? "L" : "M";
    return `${command}${px(point[0]).toFixed(1)} ${py(point[1]).toFixed(1)}`;
  }).join("");
  const drawn = lines.map((pieces, at) => {
    const path = pieces.map(joined).join("");
    return path && `<path class="plot-line look-${at}" d="${path}"/>`;
  });
  svg.innerHTML = `${inside}${drawn.join("")}
    <circle class="plot-here" cx="${px(here[0])}" cy="${py(here[1])}" r="7"/>`;
  return {
    place(event) {
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
      const value = ({ least, most }, from, to, where) =>
        Math.min(most, Math.max(least, least + ((where - from) / (to - from)) * (most - least)));
      return [
        value(axes[0], px(axes[0].least), px(axes[0].most), at.x),
        value(axes[1], py(axes[1].least), py(axes[1].most), at.y),
      ];
    },
  };
}
