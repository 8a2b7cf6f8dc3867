"use strict";
// The page of `sweep explore`: a case that is simulated anew as its sliders move.

const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);
// As they are shown: in the units of the sweep file.
const values = Object.fromEntries(data.controls.map(({ axis, value }) => [axis, value]));
let engine;
let wanted = null;
let busy = false;
let mapEnds = null;

/** What differs from the case as the file has it, as the engine takes it: in the units of the axes' names. */
const changes = () => Object.fromEntries(
  data.controls.filter(({ axis, value }) => values[axis] !== value).map(({ axis, size }) => [axis, values[axis] * size]),
);

/** The same as the command takes it: in the units that are shown. */
const changesInWords = () =>
  data.controls.filter(({ axis, value }) => values[axis] !== value).map(({ axis, name }) => ` --set ${name}=${values[axis]}`).join("");

/** Of a method that has a lattice of waves to build in each piece of the string. */
const SLOW = ` Linear systems by ${data.slow} take minutes to build in a page, of a string with friction along it.`;

const BUILT = " The linear system of this string is built first; then its cases are quick.";

/** Why it takes long, where that is known: at first, and when what was changed last is of the string, there is no linear system. */
const waiting = (method) => {
  if (method === data.slow) return SLOW;
  if (data.why) return ` ${data.why}`;
  return !changed || control(changed).of_string ? BUILT : "";
};

/** Asks for the case as it now is; of several wishes the last is met. */
async function redraw(quick) {
  wanted = { quick };
  if (busy) return;
  busy = true;
  while (wanted) {
    const { quick: isQuick } = wanted;
    wanted = null;
    const method = isQuick ? data.quick : data.method;
    const slow = setTimeout(() => { byId("status").textContent = `Simulating …${waiting(method)}`; }, 250);
    const request = { case: data.case, set: changes(), method, quick: isQuick };
    try {
      const answer = await engine.simulate(request);
      const lines = await limitLines(request);
      clearTimeout(slow);
      show(answer, lines, method, isQuick);
      if (changed) complain(changed, "");
    } catch (error) {
      refuse(error.message);
    } finally {
      clearTimeout(slow);
    }
  }
  busy = false;
}

const control = (axis) => data.controls.find((one) => one.axis === axis);

/** The control that was changed last. */
let changed = null;

/** Writes a message next to the field that it is about; none takes it away. */
const complain = (axis, message) => {
  byId(`error-${axis}`).textContent = message;
  byId(`number-${axis}`).setAttribute("aria-invalid", String(message !== ""));
};

/** What the engine refuses stands at the field that it names, else at the one that was changed last. */
const refuse = (message) => {
  const named = data.controls.find(({ axis, name }) => message.includes(axis) || message.includes(name));
  const axis = named?.axis ?? changed;
  if (axis) complain(axis, message);
  byId("status").textContent = axis ? `Not simulated: see ${control(axis).title}.` : message;
};

/** What is wrong with a number in a field; nothing where it may be asked for. */
const wrongWith = ({ lowest, highest, unit, counted }, value) => {
  if (!Number.isFinite(value)) return "This is not a number.";
  if (value < lowest) return `At least ${readable(lowest)} ${unit}`.trim() + ".";
  if (value > highest) return `At most ${readable(highest)} ${unit}`.trim() + ".";
  if (counted && !Number.isInteger(value)) return "A whole number.";
  return "";
};

/** The lines of the map, in the units of their axes' names: those that came with the page, or Eq. 74. */
async function limitLines(request) {
  if (!data.map || data.map.lines) return data.map?.lines;
  const [torque] = data.map.axes;
  const { least, most, size } = control(torque);
  const values = Array.from({ length: 101 }, (_, at) => (least + ((most - least) * at) / 100) * size);
  const limit = await engine.limit({ of: request, axis: torque, values });
  return [{ pieces: [Array.from(limit.value, (value, at) => [value, limit.speed[at]])] }];
}

/** How the lines of a map are drawn, in a class and in words: those of whirl are three at most. */
const LOOKS = [["curve", "solid"], ["curve second", "dashed"], ["curve third", "dotted"]];

/** Of the lines of a map, the least at a place; null where there is none. */
const limitAt = (curves, at) => {
  let least = null;
  for (const { x, y } of curves) {
    for (let place = 1; place < x.length; place += 1) {
      const [from, to] = [x[place - 1], x[place]];
      if ((from - at) * (to - at) > 0 || from === to) continue;
      const limit = y[place - 1] + ((y[place] - y[place - 1]) * (at - from)) / (to - from);
      if (least === null || limit < least) least = limit;
    }
  }
  return least;
};

/** The line of a map: its title and name, what is said of a case below and above it, and, of a limit, that the side above it is shaded. Eq. 74 asks what one slip does and is no limit, so neither side is: the label of the case says how it turns. Of a bit that cuts no line is drawn. */
const SIDES = {
  drilling: { title: "Where the case is" },
  stick_slip: {
    title: "One-slip estimate of stick-slip (Eq. 74)",
    line: "the one-slip estimate (Eq. 74)",
    below: "one slip from even rotation stops the bit again here; whether stick-slip lasts, the case says",
    above: "one slip from even rotation does not stop the bit again here, but several may: the case says",
  },
  whirl: { title: "Limit of whirl", line: "the limit", isShaded: true, below: "no steady whirl", above: "whirl can last, once begun" },
};

/** The area above the least limit, piece by piece where there is a limit. */
const sidesOf = (curves, [[from, to], [low, high]]) => {
  const pieces = [];
  let piece = null;
  for (let step = 0; step <= 200; step += 1) {
    const x = from + (step * (to - from)) / 200;
    const limit = limitAt(curves, x);
    if (limit === null) {
      piece = null;
      continue;
    }
    if (!piece) pieces.push((piece = { x: [], y: [] }));
    piece.x.push(x);
    piece.y.push(Math.min(high, Math.max(low, limit)));
  }
  return pieces.map(({ x, y }) => ({ x: [x[0], ...x, x.at(-1)], y: [high, ...y, high] }));
};

/** Names of both sides, where each has room. */
const sideNames = (curves, ends, side) => {
  const [low, high] = ends[1];
  const at = [0.05, 0.95].map((part) => ends[0][0] + part * (ends[0][1] - ends[0][0]));
  const limits = at.map((x) => limitAt(curves, x));
  const room = 0.14 * (high - low);
  const names = [];
  // Below the limit where it is high, above it where it is low, nearer to the frame than to the limit.
  const [left, right] = limits.map((limit) => limit === null ? null : Math.min(high, Math.max(low, limit)));
  const below = (left ?? low) > (right ?? low) ? 0 : 1;
  const edge = [left, right][below];
  if (edge !== null && edge - low > room) names.push({ text: side.below, at: [at[below], low + 0.3 * (edge - low)] });
  const other = [left, right][1 - below];
  if (other !== null && high - other > room) names.push({ text: side.above, at: [at[1 - below], high - 0.3 * (high - other)] });
  return names;
};

function showMap(lines) {
  const axes = data.map.axes.map(control);
  // Friction from nothing on: limits may lie below what its slider has.
  if (data.map.of === "whirl") axes[1] = { ...axes[1], least: 0 };
  const ends = axes.map(({ least, most }) => [least, most > least ? most : least + 1]);
  const along = (piece, at) => piece.map((point) => point[at] / axes[at].size);
  const curves = lines.flatMap(({ pieces }, at) =>
    pieces.map((piece) => ({ x: along(piece, 0), y: along(piece, 1), look: LOOKS[at][0] })));
  const { title, ...side } = SIDES[data.map.of];
  const words = axes.map((axis) => axis.title);
  const here = axes.map(({ axis }) => values[axis]);
  const shades = side.isShaded ? { sides: sidesOf(curves, ends), names: sideNames(curves, ends, side) } : {};
  byId("map").replaceChildren(chart({ title, words, ends, lines: curves, here, shape: 2, ...shades }));
  mapEnds = ends;
  showSide(limitAt(curves, here[0]), here, axes, side);
  const keys = lines.filter(({ name }) => name).map(({ name }, at) => `${LOOKS[at][1]}: ${name}`);
  byId("lines").hidden = keys.length === 0;
  byId("lines").textContent = `Of the string as it is in the file; ${keys.join("; ")}.`;
}

/** Says on which side of the line the case is. */
function showSide(limit, [at, value], axes, side) {
  const [across, limited] = axes.map(({ unit }) => (unit ? ` ${unit}` : ""));
  const words = limit === null ? "" : (() => {
    const isBelow = value < limit;
    const digits = (number) => readable(Number(number.toPrecision(3)));
    const off = digits(Math.abs(value - limit));
    const [where, what] = isBelow ? ["below", side.below] : ["above", side.above];
    return `${off}${limited} ${where} ${side.line}, ${digits(limit)}${limited} at ${readable(at)}${across}: ${what}.`;
  })();
  byId("side").textContent = words;
}

const number = (value) => (typeof value === "number" ? String(Number(value.toPrecision(4))) : String(value).replace(/_/g, " "));

/** The charts of a motion: of orbits that of the site nearest to the bit. */
function charts({ time, speed, torque, cut, positions }) {
  const found = [];
  if (speed) found.push(overTime("Speed of the bit", time, speed, { unit: "Bit speed (rpm)", size: 1 }, 0));
  const { unit, size } = data.torque;
  if (torque) found.push(overTime("Torque on the bit", time, torque, { unit: `Torque (${unit})`, size: 1e3 * size }, 0));
  if (cut) found.push(...ofCutting(time, cut, data));
  if (positions.length > 0) {
    const last = positions.length - 1;
    const title = `Orbit of ${data.sites.at(-1)}; heavy: the last ${CLOSING} s; dashed: the wall`;
    found.push(orbit(title, positions[last], data.width, data.clearances?.[last], closingOf(time)));
  }
  return found.map(enlargeable);
}

/** A row of labels.csv in the units that are shown. */
const rowCells = (name, value) => {
  const { words, unit, size } = data.columns[name] ?? { words: name, unit: "", size: 1 };
  return [unit ? `${words} (${unit})` : words, typeof value === "number" ? number(value / size) : number(value)];
};

function show(answer, lines, method, isQuick) {
  const { row, time, speed, torque, cut, positions, milliseconds } = answer;
  byId("status").textContent = isQuick && method !== data.method
    ? `By ${method} while you drag; by ${data.method} when you let go. ${Math.round(milliseconds)} ms.`
    : `By ${method}, as sweep simulate has it. ${Math.round(milliseconds)} ms.`;
  if (data.slow && method !== data.slow) byId("status").textContent += SLOW;
  const warnings = [row.motor_stalled === "true" && "the mud motor stalls", row.wall_breaks === "true" && "the wall would break"];
  byId("regime").textContent = [row.torsion, row.axial, row.lateral, ...warnings].filter((label) => label).map(number).join(", ");
  byId("row").replaceChildren();
  for (const [name, value] of Object.entries(row)) {
    if (value === null || ["case", "method", "torsion", "axial", "lateral"].includes(name) || name in values) continue;
    const line = byId("row").insertRow();
    for (const text of rowCells(name, value)) line.insertCell().append(...indexed(text));
  }
  const all = charts({ time, speed, torque, cut, positions });
  // What the label is about leads.
  const lead = row.torsion ? all.shift() : all.pop();
  const others = all;
  byId("lead").replaceChildren(...(lead ? [lead] : []));
  byId("motion").replaceChildren(...others);
  if (lines) showMap(lines);
  byId("command").value = `${data.command}${changesInWords()}`;
  document.body.dataset.shown = JSON.stringify({ method, set: changes(), milliseconds });
  window.shown = answer;
}

/** Takes a value over into both fields of its control. */
function put(axis, value) {
  values[axis] = value;
  complain(axis, "");
  byId(`range-${axis}`).value = value;
  byId(`number-${axis}`).value = Number(value.toPrecision(6));
}

/** To as many digits as a slider distinguishes. */
const rounded = (axis, value) => {
  const { least, most } = control(axis);
  const digits = Math.max(0, 3 - Math.floor(Math.log10(most - least)));
  return Number(value.toFixed(Math.min(digits, 12)));
};

function controls() {
  for (const it of data.controls) {
    const { axis, title, value, least, most, lowest, highest } = it;
    const field = make("fieldset");
    const error = make("p", { class: "error", id: `error-${axis}`, role: "alert" });
    const range = make("input", { type: "range", id: `range-${axis}`, min: least, max: most, step: "any" });
    const typed = make("input", { type: "number", id: `number-${axis}`, step: "any", min: lowest, max: highest, "aria-label": title, "aria-describedby": error.id });
    field.append(make("label", { for: range.id }, ...indexed(title)), range, typed, error);
    byId("controls").append(field);
    // Steps of the keyboard.
    range.step = (most - least) / 500;
    const moved = (quick) => {
      changed = axis;
      values[axis] = rounded(axis, range.valueAsNumber);
      typed.value = values[axis];
      complain(axis, "");
      redraw(quick);
    };
    put(axis, value);
    range.addEventListener("input", () => moved(true));
    range.addEventListener("change", () => moved(false));
    typed.addEventListener("input", () => complain(axis, wrongWith(it, typed.valueAsNumber)));
    typed.addEventListener("change", () => {
      const wrong = wrongWith(it, typed.valueAsNumber);
      complain(axis, wrong);
      if (wrong) return;
      changed = axis;
      values[axis] = typed.valueAsNumber;
      range.value = values[axis];
      redraw(false);
    });
  }
}

function mapControls() {
  const map = byId("map");
  const { axes } = data.map;
  const go = (places, quick) => {
    changed = axes[0];
    axes.forEach((axis, at) => put(axis, rounded(axis, places[at])));
    redraw(quick);
  };
  map.addEventListener("pointerdown", (event) => {
    map.setPointerCapture(event.pointerId);
    if (mapEnds) go(placeIn(map, mapEnds, event), true);
  });
  map.addEventListener("pointermove", (event) => {
    if (mapEnds && map.hasPointerCapture(event.pointerId)) go(placeIn(map, mapEnds, event), true);
  });
  map.addEventListener("pointerup", () => redraw(false));
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
  map.addEventListener("keydown", (event) => {
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    go(axes.map((axis, at) => {
      const { least, most } = control(axis);
      return Math.min(most, Math.max(least, values[axis] + (step[at] * (most - least)) / 100));
    }), true);
  });
  map.addEventListener("keyup", (event) => { if (steps[event.key]) redraw(false); });
}

byId("copy").addEventListener("click", async () => {
  byId("command").select();
  // From a file a browser may not let the clipboard be written to: the text is selected then.
  await navigator.clipboard?.writeText(byId("command").value).catch(() => {});
});
byId("reset").addEventListener("click", () => {
  data.controls.forEach(({ axis, value }) => put(axis, value));
  redraw(false);
});

(async () => {
  try {
    engine = await startEngine(byId("engine").textContent.trim());
    const sweep = await engine.open(data.opening);
    data.clearances = sweep.clearances_mm;
    controls();
    if (data.map) mapControls();
    else [byId("map"), byId("side")].forEach((element) => element.remove());
    byId("live").hidden = false;
    byId("still").hidden = true;
    await redraw(false);
  } catch (error) {
    byId("status").textContent = `The engine cannot be started here: ${error.message}`;
  }
})();
