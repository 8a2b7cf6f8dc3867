#!/usr/bin/env node
// Opens a report as its readers do, in headless Chromium: at a desk, on a tablet and on a phone, by
// day and in the dark, and in print. Fails if the page asks for anything but itself, says anything
// on the console, is wider than the screen with all of it unfolded, or has letters that are too small
// to read. Opens a map in large and closes it again. Points at cases of its maps, by mouse,
// keys and touch, and fails unless it shows the values of labels.csv of the results folder. With
// SWEEP, the program, where the sweep files are, it runs the commands that the page gives for those
// cases, and fails unless the page's own motion is that of history.csv to 1e-9. Look at the
// pictures it leaves.
//
//     scripts/look-at-report.mjs results/fig09/report.html FOLDER [RESULTS …]
//
// Needs Node and Chromium (CHROMIUM, or `chromium` on the path), and no package.
// Exit codes: 0 no fault, 1 faults, 2 bad usage, 3 3 the page could not be checked.
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { browse } from "./devtools.mjs";

const [report, folder, ...results] = process.argv.slice(2);
if (!report || !folder) {
  console.error("usage: look-at-report.mjs REPORT FOLDER [RESULTS ...]");
  process.exit(2);
}
const { faults, page, load: open, evaluate, close } = await browse(300_000);
const address = pathToFileURL(resolve(report)).href;
const load = () => open(address);
const fault = (wrong, words) => wrong && faults.push(words);

/** The rows of a labels.csv by case and method. */
const read = (results) => {
  const [header, ...lines] = readFileSync(join(results, "labels.csv"), "utf8").trim().split("\n");
  const names = header.split(",");
  const rows = lines.map((line) => Object.fromEntries(line.split(",").map((field, place) => [names[place], field])));
  const cases = new Map();
  for (const row of rows) cases.set(Number(row.case), [...(cases.get(Number(row.case)) ?? []), row]);
  return cases;
};

/** What the page says of a case in an element: the numbers behind its words, and its texts. */
const shownOf = (selector) =>
  evaluate(`(() => {
    const element = document.querySelector(${JSON.stringify(selector)});
    const numbers = [...element.querySelectorAll("[title]:not(button)")].map((one) => Number(one.title));
    const shown = element.matches("dialog") ? element.open : !element.hidden;
    return { shown, text: element.innerText, numbers };
  })()`);

/** Where a case is in the window, from its values: on the first map of a figure. */
const placeOf = (figure, rows) =>
  evaluate(`(() => {
    const figure = document.querySelectorAll("figure[data-cases]")[${figure}];
    const { axes, places, ends } = JSON.parse(document.getElementById(figure.dataset.cases).textContent);
    const area = figure.querySelector(".area");
    area.scrollIntoView({ block: "center" });
    const { left, top } = area.getBoundingClientRect();
    const row = ${JSON.stringify(rows[0])};
    const [x, y] = [0, 1].map((end) => {
      const { name, size } = axes[places[end]];
      return (row[name] / size - ends[end][0]) / (ends[end][1] - ends[end][0]);
    });
    return { x: left + area.clientLeft + x * area.clientWidth, y: top + area.clientTop + (1 - y) * area.clientHeight };
  })()`);

/** How near the numbers of the page are to those of labels.csv: of many cases, to four digits. */
let tolerance = 1e-12;

/** Every number shown of a case is one of labels.csv, and at least a given count of them is shown. */
const compare = (what, { shown, text, numbers }, rows, least) => {
  const known = rows.flatMap((row) => Object.values(row).filter((field) => field !== "").map(Number));
  const near = (value) => known.some((other) => Math.abs(other - value) <= tolerance * Math.abs(value));
  fault(!shown, `${what}: nothing is shown`);
  fault(!text.includes(`Case ${rows[0].case}`), `${what}: shows another case: ${text}`);
  fault(numbers.length < least, `${what}: ${numbers.length} numbers`);
  for (const value of numbers) fault(!near(value), `${what}: ${value} is not in labels.csv`);
  for (const { torsion, lateral } of rows) {
    for (const label of [torsion, lateral]) fault(label && !text.includes(label.replaceAll("_", " ")), `${what}: no ${label}`);
  }
};

const mouse = (type, { x, y }, more) => page("Input.dispatchMouseEvent", { type, x, y, ...more });
const click = async (place) => {
  const button = { button: "left", clickCount: 1 };
  await mouse("mousePressed", place, button);
  await mouse("mouseReleased", place, button);
};
const CODES = { Enter: 13, Escape: 27, ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40 };
const key = async (name) => {
  const windowsVirtualKeyCode = CODES[name];
  for (const type of ["keyDown", "keyUp"]) await page("Input.dispatchKeyEvent", { type, key: name, code: name, windowsVirtualKeyCode, text: name === "Enter" ? "\r" : undefined });
};
const picture = async (name) => save(`${name}.png`, (await page("Page.captureScreenshot")).data);

/** Whether the page has an engine. */
const hasEngine = () => evaluate("document.getElementById('engine') !== null");

/** Before a page runs: its last motion is kept. */
const KEEP = "document.addEventListener('history', ({ detail }) => { globalThis.lastHistory = detail; });";

/** Holds the motion of the open case, by the first method, against that of the command. */
const compareHistory = async (what, command, cases) => {
  if (!(await hasEngine())) return;
  const kept = await evaluate(`(async () => {
    for (let wait = 0; wait < 200 && !globalThis.lastHistory; wait += 1) await new Promise((done) => setTimeout(done, 50));
    const { method, row, columns } = globalThis.lastHistory ?? { columns: {} };
    globalThis.lastHistory = null;
    return { method, row, columns: Object.fromEntries(Object.entries(columns).map(([name, values]) => [name, [...values]])) };
  })()`);
  fault(!kept.method, `${what}: no motion`);
  const known = cases.find(({ method }) => method === kept.method);
  for (const motion of ["torsion", "lateral"]) {
    const [found, expected] = [kept.row?.[motion] ?? "", known?.[motion] ?? ""];
    fault(kept.method && found !== expected, `${what}: ${found} where labels.csv has ${expected}`);
  }
  if (!kept.method || !command || !process.env.SWEEP) return;
  const out = mkdtempSync(join(tmpdir(), "history-"));
  const words = command.split(" ").concat("--methods", kept.method, "--out", out);
  execFileSync(process.env.SWEEP, words, { stdio: ["ignore", "ignore", "inherit"] });
  const [header, ...lines] = readFileSync(join(out, "history.csv"), "utf8").trim().split("\n");
  rmSync(out, { recursive: true });
  const rows = lines.map((line) => line.split(","));
  // Whirl magnifies rounding at each impact: there the motion is compared up to the first contact.
  const until = kept.row.first_contact_s ?? Infinity;
  for (const [place, name] of header.split(",").entries()) {
    if (name === "case" || name === "method") continue;
    const expected = rows.map((row) => Number(row[place]));
    const found = kept.columns[name] ?? [];
    const largest = Math.max(1e-300, ...expected.map(Math.abs));
    const off = expected.map((value, step) => Math.abs(value - found[step]) / largest);
    const apart = off.findIndex((part) => !(part <= 1e-9));
    const since = apart < 0 ? Infinity : kept.columns.time_s[apart];
    fault(found.length !== expected.length, `${what}: ${name} has ${found.length} steps, history.csv ${expected.length}`);
    fault(!(since > until) && apart >= 0, `${what}: ${name} is not that of history.csv from ${since} s on`);
    parted = Math.min(parted, since - until);
    worst = Math.max(worst, ...off.slice(0, apart < 0 ? undefined : apart));
    compared += apart < 0 ? expected.length : apart;
  }
};
/** Time from a first contact to where a motion is another one, s. */
let parted = Infinity;
let worst = 0;
let compared = 0;

/** Points at some cases of the first map of a figure, and opens them. */
const pointAt = async (figure, cases, name) => {
  const all = [...cases.values()];
  for (const place of new Set([0, Math.floor(all.length / 2), all.length - 1])) {
    const rows = all[place];
    const what = `${name}, case ${rows[0].case}`;
    const at = await placeOf(figure, rows);
    await mouse("mouseMoved", at);
    compare(`${what}, pointed at`, await shownOf(".tip"), rows, 2);
    if (place > 0 && place < all.length - 1) await picture(`${name}-tip`);
    await click(at);
    const opened = await shownOf(CASE);
    compare(`${what}, opened`, opened, rows, 4);
    fault(!opened.text.includes(`--case ${rows[0].case}`), `${what}: no command`);
    // By day alone: the program takes its time.
    await compareHistory(what, name.startsWith("desk") && /sweep (simulate .*)/.exec(opened.text)?.[1], rows);
    if (place > 0 && place < all.length - 1) await picture(`${name}-case`);
    await key("Escape");
    fault((await shownOf(CASE)).shown, `${what}: Escape does not close it`);
  }
};

/** Goes over the first map by keys: to a neighbour, into it and back. */
const goByKeys = async (cases) => {
  const area = "document.querySelector('.answers')";
  const shown = async (selector) => Number(/Case (\d+)/.exec((await shownOf(selector)).text)?.[1]);
  await mouse("mouseMoved", { x: 0, y: 0 });
  await evaluate(`${area}.blur()`);
  await evaluate(`${area}.focus({ focusVisible: true })`);
  const before = await shown(".tip");
  let after = before;
  for (const arrow of ["ArrowRight", "ArrowUp", "ArrowLeft", "ArrowDown"]) {
    await key(arrow);
    if (after === before) after = await shown(".tip");
  }
  fault(cases.size > 1 && !(after !== before), `arrow keys stay at case ${before}`);
  const last = await shown(".tip");
  await key("Enter");
  fault((await shown(CASE)) !== last || !(await shownOf(CASE)).shown, "Enter does not open the case");
  await key("Escape");
  fault((await evaluate(`document.activeElement === ${area}`)) !== true, "Escape does not go back to the map");
};

/** A finger: a first touch shows the values, a second opens the case. */
const touch = async (rows) => {
  const place = await placeOf(0, rows);
  for (const expected of [".tip", CASE]) {
    await page("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [place] });
    await page("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    const said = await shownOf(expected);
    fault(!said.shown || !said.text.includes(`Case ${rows[0].case}`), `touch: ${expected} does not show the case`);
    if (expected === CASE) await compareHistory("phone", null, rows);
    await picture(expected === CASE ? "phone-case" : "phone-tip");
  }
  fault((await evaluate("document.documentElement.scrollWidth")) > 390, "phone: an open case makes the page wide");
  await key("Escape");
};

/** What opens with a case. */
const CASE = "dialog.case";

/** Everything unfolded: nothing is wider than the screen, and no letter is too small. */
const fits = async (name, width) => {
  await evaluate(`document.querySelectorAll("details").forEach((one) => { one.open = true; })`);
  const wide = await evaluate("Math.max(document.scrollingElement.scrollWidth, innerWidth)");
  fault(wide > width, `${name}: the page is ${wide} px wide`);
  const small = await evaluate(`(() => {
    const words = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    let least = Infinity;
    while (words.nextNode()) {
      const element = words.currentNode.parentElement;
      if (!words.currentNode.data.trim() || element.closest("script, style") || element.getClientRects().length === 0) continue;
      least = Math.min(least, parseFloat(getComputedStyle(element).fontSize));
    }
    return least;
  })()`);
  fault(small < SMALLEST, `${name}: letters of ${small} px`);
  await evaluate(`document.querySelectorAll("details").forEach((one) => { one.open = false; })`);
};
/** The least size of letters, px. */
const SMALLEST = 9;

/** Opens the first picture in large by the keyboard, makes it larger, and goes back. */
const enlarge = async (name) => {
  if (!(await evaluate(`document.querySelector("main .enlarge") !== null`))) return;
  await evaluate(`document.querySelector("main .enlarge").focus()`);
  await key("Enter");
  const width = () => evaluate(`document.querySelector("dialog.zoom[open] .zoom-content .area")?.clientWidth ?? 0`);
  const before = await width();
  fault(before === 0, `${name}: the picture does not open in large`);
  await picture(`${name}-large`);
  await key("+");
  fault(!((await width()) > 1.2 * before), `${name}: the picture does not grow`);
  await key("Escape");
  const isBack = `new Promise((done) => {
    const look = (left) => {
      const isBack = !document.querySelector("dialog.zoom[open]") && document.activeElement === document.querySelector("main .enlarge");
      if (isBack || left === 0) done(isBack);
      else setTimeout(look, 20, left - 1);
    };
    look(100);
  })`;
  fault(!(await evaluate(isBack)), `${name}: the picture does not go back to its place`);
};

const save = (name, data) => writeFileSync(join(folder, name), Buffer.from(data, "base64"));
mkdirSync(folder, { recursive: true });
await page("Page.addScriptToEvaluateOnNewDocument", { source: KEEP });
for (const [name, width, height, scheme, scale] of [
  ["desk", 1600, 1000, "light", 1],
  ["dark", 1600, 1000, "dark", 1],
  ["tablet", 820, 1180, "light", 1],
  ["tablet-dark", 820, 1180, "dark", 1],
  ["phone", 390, 844, "light", 2],
  ["phone-dark", 390, 844, "dark", 2],
]) {
  await page("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile: width < 500 });
  await page("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: scheme }] });
  await load();
  await fits(name, width);
  await enlarge(name);
  const { data } = await page("Page.captureScreenshot", { captureBeyondViewport: true });
  save(`${name}.png`, data);
  const tables = results.map(read);
  const isRounded = await evaluate(`[...document.querySelectorAll("script[id^=cases]")].some(({ text }) => JSON.parse(text).digits)`);
  if (isRounded) tolerance = 6e-4;
  const isPhone = width < 500;
  const isDesk = width > 1000;
  if (tables.length > 0 && isPhone && scheme === "light") {
    await page("Emulation.setTouchEmulationEnabled", { enabled: true });
    await touch([...tables[0].values()].at(-1));
    await page("Emulation.setTouchEmulationEnabled", { enabled: false });
  }
  for (const [figure, cases] of isDesk ? tables.entries() : []) {
    await pointAt(figure, cases, figure === 0 ? name : `${name}-${figure}`);
  }
  if (tables.length > 0 && name === "desk") await goByKeys(tables[0]);
}
// A page of A4 as a picture too, in a dark colour scheme.
await page("Emulation.setDeviceMetricsOverride", { width: 680, height: 960, deviceScaleFactor: 1, mobile: false });
await page("Emulation.setEmulatedMedia", { media: "print", features: [{ name: "prefers-color-scheme", value: "dark" }] });
await load();
await picture("print");
await page("Emulation.setEmulatedMedia", { media: "", features: [] });
await page("Emulation.clearDeviceMetricsOverride");
const { data } = await page("Page.printToPDF", { preferCSSPageSize: true, paperWidth: 8.27, paperHeight: 11.69 });
save("print.pdf", data);

await close();
for (const fault of faults) console.error(fault);
if (compared > 0) console.log(`${compared} numbers of motions are those of history.csv to ${worst} of the largest`);
if (parted < Infinity) console.log(`whirl is another motion ${parted} s after its first contact at the earliest`);
console.log(`${report}: ${faults.length} faults; its pictures are in ${folder}`);
process.exit(faults.length > 0 ? 1 : 0);
