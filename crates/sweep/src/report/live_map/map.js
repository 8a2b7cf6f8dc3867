// Interactive maps: pointing at a case shows its values, opening it shows all of them. A case is
// found by its position, not by its own element.

/** The cases of a results folder, as the page holds them. */
class Cases {
  constructor(data) {
    Object.assign(this, data);
  }

  /** The value of a case along an axis, in the unit that is shown. */
  along(axis, index) {
    return this.values[axis][index] / this.axes[axis].size;
  }

  /** What a column has of a case by a method: a text or a number, or null. */
  cell(column, index, method) {
    const value = column.rows[index * this.methods.length + method];
    if (value === null) return null;
    return column.texts ? column.texts[value] : value / column.size;
  }

  reason(index, method) {
    return this.failures[this.cases[index]]?.[this.methods[method]];
  }

  /** The command that simulates a case. */
  command(index) {
    return this.command_parts.join(this.cases[index]);
  }

  axisWords(axis) {
    const { words, unit } = this.axes[axis];
    return unit ? `${words} (${unit})` : words;
  }

  columnWords(column) {
    return column.unit ? `${column.words} (${column.unit})` : column.words;
  }

  /** A table with a row for each of some columns that have anything to say of a case. */
  table(index, columns) {
    const has = (column) => this.methods.some((_, method) => this.cell(column, index, method) !== null);
    const rows = columns.filter(has).map((column) => {
      const cells = this.methods.map((_, method) => shown(this.cell(column, index, method)));
      return make("tr", {}, make("th", { scope: "row" }, this.columnWords(column)), ...cells);
    });
    const names = this.methods.map((name) => make("th", { scope: "col" }, name));
    const head = make("thead", {}, make("tr", {}, make("td"), ...names));
    return make("table", {}, head, make("tbody", {}, ...rows));
  }

  /** Why methods have no answer. */
  reasons(index) {
    const of = (name, method) => {
      const reason = this.reason(index, method);
      return reason ? [make("p", {}, `${name}: no answer, ${reason}`)] : [];
    };
    return this.methods.flatMap(of);
  }
}

/** A cell of a table: a number in few digits with all of them as its title. */
const shown = (value) => {
  if (typeof value === "number") return make("td", { class: "number", title: value }, readable(value));
  return make("td", {}, value === null ? "–" : value.replaceAll("_", " "));
};

/** What a tooltip shows in addition to labels. */
const BRIEF = ["stick_slip_severity", "bit_speed_peak_rpm", "peak_radius_mm", "contact_fraction"];
const LABELS = ["torsion", "lateral"];

const tip = make("div", { class: "tip", role: "status", hidden: "" });
document.body.append(tip);

const isInTip = (column) => LABELS.includes(column.name) || BRIEF.includes(column.name);

/** Shows the values of a case next to a place of the window. */
const showTip = (cases, index, others, hint, [x, y]) => {
  const values = cases.axes.map((_, axis) => {
    const value = cases.along(axis, index);
    return make("div", { title: value }, `${cases.axes[axis].words} = ${readable(value)} ${cases.axes[axis].unit}`);
  });
  const here = others > 1 ? ` (one of ${others} here: Page Down for the next)` : "";
  const title = make("strong", {}, `Case ${cases.cases[index]}`);
  tip.replaceChildren(
    make("p", {}, title, here),
    ...values,
    cases.table(index, cases.columns.filter(isInTip)),
    ...cases.reasons(index),
    make("p", { class: "note" }, hint),
  );
  // Above what is open.
  ([...document.querySelectorAll("dialog[open]")].at(-1) ?? document.body).append(tip);
  tip.hidden = false;
  const { width, height } = tip.getBoundingClientRect();
  const room = document.documentElement.clientWidth;
  const sideways = x + 16 + width <= room ? x + 16 : x - 16 - width;
  const below = y + 16 + height <= innerHeight ? y + 16 : y - 16 - height;
  tip.style.left = `${Math.max(8, Math.min(sideways, room - width - 8))}px`;
  tip.style.top = `${Math.max(8, below)}px`;
};

/** One map, which knows where its cases are. */
class LiveMap {
  /** How far from a case one may point, in pixels. */
  static REACH = 24;

  constructor(cases, panel, area) {
    this.cases = cases;
    this.area = area;
    this.mark = make("span", { class: "here", hidden: "" });
    area.append(this.mark);
    const isHere = (index) => panel.held.every(([axis, value]) => cases.values[axis][index] === value);
    this.indices = [...cases.cases.keys()].filter(isHere);
    const place = (end) => (index) => {
      const value = cases.along(cases.places[end], index);
      const [low, high, at] = [...cases.ends[end], value].map(cases.logarithmic[end] ? Math.log : Number);
      return (at - low) / (high - low);
    };
    [this.x, this.y] = [0, 1].map((end) => this.indices.map(place(end)));
    this.at = null;
    this.touched = null;
    area.classList.add("answers");
    area.tabIndex = 0;
    area.setAttribute("role", "application");
    area.setAttribute("aria-roledescription", "map");
    area.setAttribute("aria-label", `${area.querySelector("svg").getAttribute("aria-label")}. Arrow keys go from case to case, Enter opens one.`);
    area.addEventListener("pointermove", (event) => this.point(event));
    area.addEventListener("pointerleave", () => this.leave());
    area.addEventListener("click", (event) => this.click(event));
    area.addEventListener("keydown", (event) => this.key(event));
    area.addEventListener("focus", () => area.matches(":focus-visible") && this.show(this.at ?? 0));
    area.addEventListener("blur", () => this.leave());
  }

  get size() {
    const { clientWidth, clientHeight } = this.area;
    return [clientWidth, clientHeight];
  }

  /** The case nearest to a place of the window, within reach; null where there is none. */
  nearest({ clientX, clientY }) {
    const { left, top } = this.area.getBoundingClientRect();
    const [width, height] = this.size;
    let [best, least] = [null, LiveMap.REACH ** 2];
    for (let place = 0; place < this.x.length; place += 1) {
      const across = this.x[place] * width - (clientX - left);
      const up = (1 - this.y[place]) * height - (clientY - top);
      const distance = across * across + up * up;
      if (distance < least) [best, least] = [place, distance];
    }
    return best;
  }

  /** Those at the same place. */
  together(at) {
    return [...this.x.keys()].filter((place) => this.x[place] === this.x[at] && this.y[place] === this.y[at]);
  }

  point(event) {
    const at = this.nearest(event);
    if (at === null) this.leave();
    else this.show(at, [event.clientX, event.clientY], "Click: all values");
  }

  /** A first touch tells what a pointer does by coming near. */
  click(event) {
    const at = this.nearest(event);
    if (at === null) return;
    if (event.pointerType !== "touch" || this.touched === at) {
      this.open(at);
    } else {
      this.show(at, [event.clientX, event.clientY], "Touch again: all values");
      this.touched = at;
    }
  }

  show(at, place, hint = "Enter: all values") {
    this.at = at;
    this.mark.style.left = `${100 * this.x[at]}%`;
    this.mark.style.top = `${100 * (1 - this.y[at])}%`;
    this.mark.hidden = false;
    const { left, top } = this.area.getBoundingClientRect();
    const [width, height] = this.size;
    const corner = place ?? [left + this.x[at] * width, top + (1 - this.y[at]) * height];
    showTip(this.cases, this.indices[at], this.together(at).length, hint, corner);
  }

  leave() {
    tip.hidden = true;
    this.mark.hidden = true;
  }

  open(at) {
    this.at = at;
    this.leave();
    openCase(this.cases, this.indices[at]);
  }

  key(event) {
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const at = this.at ?? 0;
    if (steps[event.key]) this.show(this.neighbour(at, steps[event.key]));
    else if (event.key === "PageDown" || event.key === "PageUp") this.show(this.next(at, event.key === "PageDown" ? 1 : -1));
    else if (event.key === "Enter" || event.key === " ") this.open(at);
    else if (event.key === "Escape" && !tip.hidden) this.leave();
    else return;
    event.preventDefault();
  }

  /** The nearest case in a direction; what lies aside counts for more. */
  neighbour(at, [right, up]) {
    const [width, height] = this.size;
    let [best, least] = [at, Infinity];
    for (let place = 0; place < this.x.length; place += 1) {
      const across = (this.x[place] - this.x[at]) * width;
      const upwards = (this.y[place] - this.y[at]) * height;
      const ahead = right * across + up * upwards;
      const aside = right ? upwards : across;
      const distance = ahead + 4 * Math.abs(aside);
      if (ahead > 1e-6 && distance < least) [best, least] = [place, distance];
    }
    return best;
  }

  /** The next one at the same place. */
  next(at, step) {
    const places = this.together(at);
    return places.at((places.indexOf(at) + step) % places.length);
  }
}

const dialog = make("dialog", { class: "case", "aria-labelledby": "case-title" });
document.body.append(dialog);
// A click outside it closes it, as Esc does.
dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
// What is still being simulated is not wanted any more.
dialog.addEventListener("close", () => engine.isBusy && engine.stop());

/** Opens a case: all its values, and the command that simulates it. */
const openCase = (cases, index) => {
  if (engine.isBusy) engine.stop();
  const close = make("button", { type: "button" }, "Close");
  close.addEventListener("click", () => dialog.close());
  const title = make("h2", { id: "case-title" }, `Case ${cases.cases[index]}`);
  const values = cases.axes.map((_, axis) => {
    const name = make("th", { scope: "row" }, cases.axisWords(axis));
    return make("tr", {}, name, shown(cases.along(axis, index)));
  });
  const scrolled = (table) => make("div", { class: "scroll", tabindex: "0" }, table);
  const digits = cases.digits ? [make("p", { class: "note" }, `Measures in ${cases.digits} digits: labels.csv has all.`)] : [];
  dialog.replaceChildren(
    make("header", {}, title, close),
    scrolled(make("table", {}, make("tbody", {}, ...values))),
    ...cases.reasons(index),
    commandLine(cases.command(index)),
    ...historyOf(cases, index),
    scrolled(cases.table(index, cases.columns)),
    ...digits,
  );
  dialog.showModal();
};

const commandLine = (command) => {
  const code = make("code", {}, command);
  const copy = make("button", { type: "button" }, "Copy");
  copy.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(command);
      copy.textContent = "Copied";
    } catch {
      // Where a page may not write there, the reader copies what is selected.
      getSelection().selectAllChildren(code);
    }
  });
  return make("p", { class: "command" }, code, copy);
};

for (const figure of document.querySelectorAll("figure[data-cases]")) {
  const data = document.getElementById(figure.dataset.cases);
  const cases = new Cases(JSON.parse(data.textContent));
  const areas = figure.querySelectorAll(".area");
  cases.panels.forEach((panel, place) => new LiveMap(cases, panel, areas[place]));
}

document.querySelectorAll("main .panel").forEach(enlargeable);
