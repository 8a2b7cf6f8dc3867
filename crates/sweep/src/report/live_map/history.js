// A case's motion, simulated in the page.

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

/** The charts of a motion: bit speed, torque on bit, how it cuts and, with a wall, the orbit of the site that decides. */
const charts = (cases, { row, time, speed, torque, cut, positions, description }) => {
  const found = [];
  if (speed) found.push(overTime("Bit speed", time, speed, { unit: "rpm", size: 1 }));
  if (torque) found.push(overTime("Torque on bit", time, torque, cases.shown.torque));
  if (cut) found.push(...ofCutting(time, cut, cases.shown));
  const from = row.site_from_bit_m ?? 0;
  const { unit, size } = cases.shown.length;
  const site = from === 0 ? "bit" : `${from}m_above_bit`;
  const path = positions.find((one) => one.site === site);
  if (!path) return found;
  const clearance = description.clearances_mm?.[description.sites_from_bit_m.indexOf(from)];
  const title = `Orbit ${from === 0 ? "of the bit" : `${readable(from / size)} ${unit} above the bit`}; heavy: the last ${CLOSING} s; dashed: the wall`;
  found.push(orbit(title, path, cases.shown.width, clearance, closingOf(time)));
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
    shown.append(make("div", { class: "panels" }, ...charts(cases, history).map(enlargeable)));
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
