// Runs the scripts of a page of `sweep explore` without a browser, and prints as JSON what the page
// says of its case: node shown.mjs explore.html. Its elements hold text and attributes, no layout.
import { readFileSync } from "node:fs";
import vm from "node:vm";

class Element {
  constructor(name) {
    Object.assign(this, { name, children: [], attributes: {}, style: {}, dataset: {}, value: "" });
  }

  get textContent() {
    return this.children.map((child) => child.textContent ?? child).join("");
  }

  set textContent(text) {
    this.children = [text];
  }

  append(...added) {
    this.children.push(...added);
  }

  replaceChildren(...others) {
    this.children = others;
  }

  setAttribute(key, value) {
    this.attributes[key] = String(value);
  }

  getAttribute(key) {
    return this.attributes[key] ?? null;
  }

  querySelector() {
    return null;
  }

  insertRow() {
    return this.inserted("tr");
  }

  insertCell() {
    return this.inserted("td");
  }

  inserted(name) {
    this.append(new Element(name));
    return this.children.at(-1);
  }

  addEventListener() {}

  /** All elements below it. */
  below() {
    return this.children.filter((child) => child instanceof Element).flatMap((child) => [child, ...child.below()]);
  }
}

const html = readFileSync(process.argv[2], "utf8");
const contentOf = (opening) => html.split(opening)[1].split("</script>")[0];
const elements = new Map();
const byId = (id) => {
  if (!elements.has(id)) elements.set(id, new Element(id));
  return elements.get(id);
};
byId("data").textContent = contentOf('id="data">');
byId("engine").textContent = contentOf('id="engine">');
// What the page makes is found by its id, too.
const created = (name) => {
  const element = new Element(name);
  const set = element.setAttribute;
  element.setAttribute = (key, value) => {
    set.call(element, key, value);
    if (key === "id") elements.set(value, element);
  };
  return element;
};
globalThis.window = globalThis;
globalThis.document = {
  getElementById: byId,
  createElement: created,
  createElementNS: (_, name) => created(name),
  body: new Element("body"),
};
vm.runInThisContext(contentOf("<script>"));

const started = Date.now();
while (!document.body.dataset.shown) {
  const status = byId("status").textContent;
  if (Date.now() - started > 300_000 || /cannot|Not simulated/.test(status)) throw new Error(`nothing is shown: ${status}`);
  await new Promise((next) => setTimeout(next, 20));
}
const map = byId("map");
const classes = map.below().map(({ attributes }) => attributes.class);
console.log(JSON.stringify({
  regime: byId("regime").textContent,
  side: byId("side").textContent,
  map: map.textContent,
  row: byId("row").below().filter(({ name }) => name === "td").map(({ textContent }) => textContent),
  areas: classes.filter((name) => name === "side").length,
  lines: classes.filter((name) => name === "curve").length,
}));
process.exit(0);
