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

/** A value that is shown, in the unit of its axis' name: in as many digits as it was shown with. */
const named = (axis, value) => {
  const { size } = control(axis);
  return size === 1 ? value : Number((value * size).toPrecision(12));
};

/** What differs from the case as the file has it. */
const changes = () => Object.fromEntries(
  data.controls.filter(({ axis, value }) => values[axis] !== value).map(({ axis }) => [axis, named(axis, values[axis])]),
);

/** Asks for the case as it now is; of several wishes the last is met. */
async function redraw(quick) {
  wanted = { quick };
  if (busy) return;
  busy = true;
  while (wanted) {
    const { quick: isQuick } = wanted;
    wanted = null;
    const method = isQuick ? data.quick : data.method;
    const request = { case: data.case, set: changes(), method, quick: isQuick };
    try {
      const answer = await engine.simulate(request);
      show(answer, await limitLines(request), method, isQuick);
    } catch (error) {
      byId("status").textContent = error.message;
    }
  }
  busy = false;
}

const control = (axis) => data.controls.find((one) => one.axis === axis);

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

function showMap(lines) {
  const axes = data.map.axes.map(control);
  // Friction from nothing on: limits may lie below what its slider has.
  if (data.map.lines) axes[1] = { ...axes[1], least: 0 };
  const ends = axes.map(({ least, most }) => [least, most > least ? most : least + 1]);
  const along = (piece, at) => piece.map((point) => point[at] / axes[at].size);
  const curves = lines.flatMap(({ pieces }, at) =>
    pieces.map((piece) => ({ x: along(piece, 0), y: along(piece, 1), look: LOOKS[at][0] })));
  const title = data.map.lines ? "Limit of backward whirl" : "Limit of stick-slip (Eq. 74)";
  const words = axes.map((axis) => axis.title);
  const here = axes.map(({ axis }) => values[axis]);
  byId("map").replaceChildren(chart({ title, words, ends, lines: curves, here, shape: 2 }));
  mapEnds = ends;
  const names = lines.filter(({ name }) => name).map(({ name }, at) => `${LOOKS[at][1]}: ${name}`);
  byId("lines").hidden = names.length === 0;
  byId("lines").textContent = `Of the string as it is in the file; ${names.join("; ")}.`;
}

const number = (value) => (typeof value === "number" ? String(Number(value.toPrecision(4))) : String(value).replace(/_/g, " "));

/** The charts of a motion: of orbits that of the site nearest to the bit. */
function charts({ time, speed, torque, positions }) {
  const found = [];
  if (speed) found.push(overTime("Speed of the bit", time, speed, { unit: "Bit speed (rpm)", size: 1 }, 0));
  const { unit, size } = data.torque;
  if (torque) found.push(overTime("Torque on the bit", time, torque, { unit: `Torque (${unit})`, size: 1e3 * size }, 0));
  if (positions.length > 0) {
    const last = positions.length - 1;
    const title = `Orbit, ${positions[last].site.replace(/_/g, " ")}; heavy: the last ${CLOSING} s; dashed: the wall`;
    found.push(orbit(title, positions[last], data.width, data.clearances?.[last], closingOf(time)));
  }
  return found;
}

function show(answer, lines, method, isQuick) {
  const { row, time, speed, torque, positions, milliseconds } = answer;
  byId("status").textContent = isQuick && method !== data.method
    ? `By ${method} while you drag; by ${data.method} when you let go. ${Math.round(milliseconds)} ms.`
    : `By ${method}, as sweep simulate has it. ${Math.round(milliseconds)} ms.`;
  byId("regime").textContent = number(row.torsion ?? row.lateral ?? "");
  byId("row").replaceChildren();
  for (const [name, value] of Object.entries(row)) {
    if (value === null || ["case", "method", "torsion", "lateral"].includes(name) || name in values) continue;
    const line = byId("row").insertRow();
    line.insertCell().textContent = name;
    line.insertCell().textContent = number(value);
  }
  byId("motion").replaceChildren(...charts({ time, speed, torque, positions }));
  if (lines) showMap(lines);
  const set = Object.entries(changes()).map(([axis, value]) => ` --set ${axis}=${value}`).join("");
  byId("command").value = `${data.command}${set}`;
  document.body.dataset.shown = JSON.stringify({ method, set: changes(), milliseconds });
  window.shown = answer;
}

/** Takes a value over into both fields of its control. */
function put(axis, value) {
  values[axis] = value;
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
  for (const { axis, title, value, least, most } of data.controls) {
    const field = make("fieldset");
    const range = make("input", { type: "range", id: `range-${axis}`, min: least, max: most, step: "any" });
    const typed = make("input", { type: "number", id: `number-${axis}`, step: "any", "aria-label": title });
    field.append(make("label", { for: range.id }, title), range, typed);
    byId("controls").append(field);
    // Steps of the keyboard.
    range.step = (most - least) / 500;
    const moved = (quick) => { values[axis] = rounded(axis, range.valueAsNumber); typed.value = values[axis]; redraw(quick); };
    put(axis, value);
    range.addEventListener("input", () => moved(true));
    range.addEventListener("change", () => moved(false));
    typed.addEventListener("change", () => {
      if (!Number.isFinite(typed.valueAsNumber)) return;
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
    else byId("map").remove();
    byId("live").hidden = false;
    byId("still").hidden = true;
    await redraw(false);
  } catch (error) {
    byId("status").textContent = `The engine cannot be started here: ${error.message}`;
  }
})();
