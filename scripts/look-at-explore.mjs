#!/usr/bin/env node
// Plays with a page of `sweep explore` in headless Chromium: moves each slider, the dot on the
// map and a number, waits for what is drawn, and prints how long cases took. Fails if nothing
// is drawn, a wrong number is not marked at its field, a slider moves out of the sight of what it
// changes, a picture does not open in large, the page asks for anything but itself, says anything on
// the console or is wider than the screen of a desk, a tablet or a phone. FOLDER gets pictures to look at, and history.json: the history that is shown
// at last, with the command that repeats it.
//
//     scripts/look-at-explore.mjs explore.html FOLDER
//
// Needs Node and Chromium (CHROMIUM, or `chromium` on the path), and no package.
// Exit codes: 0 no fault, 1 faults, 2 bad usage, 3 3 the page could not be checked.
import { mkdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { browse } from "./devtools.mjs";

const [file, folder] = process.argv.slice(2);
if (!file || !folder) {
  console.error("usage: look-at-explore.mjs PAGE FOLDER");
  process.exit(2);
}
const { faults, page, load, evaluate, close } = await browse(180_000);
mkdirSync(folder, { recursive: true });
const address = pathToFileURL(resolve(file)).href;

/** Until the page shows what was asked for last, or says why it does not. */
const settled = `new Promise((done) => {
  const look = () => (document.body.dataset.shown && !busy && !wanted) ? done() : setTimeout(look, 20);
  look();
})`;
const shown = async () => {
  await evaluate(settled);
  const words = await evaluate("document.getElementById('status').textContent");
  if (!words.startsWith("By ")) faults.push(`the page says: ${words}`);
  return JSON.parse(await evaluate("document.body.dataset.shown"));
};
const picture = async (name) => {
  const { data } = await page("Page.captureScreenshot", { captureBeyondViewport: true });
  writeFileSync(join(folder, name), Buffer.from(data, "base64"));
};

await load(address);
const first = await shown();
console.log(`first history ${Math.round(await evaluate("performance.now()"))} ms after the page began, ${Math.round(first.milliseconds)} ms of them simulating`);
const axes = await evaluate("data.controls.map(({ axis }) => axis)");
let before = await evaluate("document.getElementById('live').innerHTML");
for (const axis of axes) {
  const times = [];
  for (const part of [0.3, 0.35, 0.4, 0.45]) {
    await evaluate(`{ const it = document.getElementById("range-${axis}");
      it.value = Number(it.min) + ${part} * (it.max - it.min); it.dispatchEvent(new Event("input")); }`);
    times.push((await shown()).milliseconds);
    const now = await evaluate("document.getElementById('live').innerHTML");
    if (now === before) faults.push(`${axis}: nothing is drawn anew`);
    before = now;
  }
  console.log(`${axis}: ${times.map((time) => time.toFixed(1)).join(", ")} ms a case`);
}
if (await evaluate("data.map !== null")) {
  const here = "document.querySelector('.dot').outerHTML";
  const was = await evaluate(here);
  await evaluate(`document.getElementById("map").focus()`);
  for (const type of ["keyDown", "keyUp"]) await page("Input.dispatchKeyEvent", { type, key: "ArrowUp", code: "ArrowUp" });
  await shown();
  if (await evaluate(here) === was) faults.push("the dot does not move by arrow keys");
}
// No number, and one that no file may have: each is marked where it stands.
const typed = async (axis, value) => {
  await evaluate(`{ const it = document.getElementById("number-${axis}"); it.value = "${value}"; it.dispatchEvent(new Event("input")); it.dispatchEvent(new Event("change")); }`);
  return evaluate(`(() => { const it = document.getElementById("number-${axis}");
    return [it.getAttribute("aria-invalid"), document.getElementById(it.getAttribute("aria-describedby")).textContent]; })()`);
};
for (const axis of axes) {
  for (const wrong of ["", "1e300"]) {
    const [isInvalid, words] = await typed(axis, wrong);
    if (isInvalid !== "true" || !words) faults.push(`${axis} = "${wrong}" is not marked: ${words}`);
  }
  const kept = await evaluate(`document.getElementById("range-${axis}").value`);
  const [isInvalid, words] = await typed(axis, kept);
  if (isInvalid === "true" || words) faults.push(`${axis} = ${kept} is marked: ${words}`);
  await shown();
}
await evaluate(`document.getElementById("range-${axes[0]}").dispatchEvent(new Event("change"))`);
const last = await shown();
const history = await evaluate(`Object.fromEntries(Object.entries(window.shown.columns).map(([name, values]) => [name, [...values]]))`);
const command = await evaluate("document.getElementById('command').value");
writeFileSync(join(folder, "history.json"), JSON.stringify({ command, method: last.method, history }));

for (const [name, width, height, scheme, scale] of [
  ["desk.png", 1600, 1000, "light", 1],
  ["dark.png", 1600, 1000, "dark", 1],
  ["tablet.png", 820, 1180, "light", 1],
  ["tablet-dark.png", 820, 1180, "dark", 1],
  ["phone.png", 390, 844, "light", 2],
  ["phone-dark.png", 390, 844, "dark", 2],
]) {
  await page("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile: width < 500 });
  await page("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: scheme }] });
  const wide = await evaluate("Math.max(document.scrollingElement.scrollWidth, innerWidth)");
  if (wide > width) faults.push(`${name}: the page is ${wide} px wide`);
  // Each slider together with what it changes.
  for (const axis of axes) {
    const together = await evaluate(`(() => {
      document.getElementById("range-${axis}").scrollIntoView({ block: "end" });
      const [slider, chart] = [document.getElementById("range-${axis}"), document.querySelector("#lead .area")].map((it) => it.getBoundingClientRect());
      return chart.top >= 0 && chart.bottom <= innerHeight && slider.bottom <= innerHeight + 1 && (slider.top >= chart.bottom || slider.right <= chart.left);
    })()`);
    if (!together) faults.push(`${name}: ${axis} and what it changes are not seen together`);
  }
  if (width < 500) writeFileSync(join(folder, `together-${name}`), Buffer.from((await page("Page.captureScreenshot", {})).data, "base64"));
  await evaluate("scrollTo(0, 0)");
  const large = await evaluate(`(() => {
    document.querySelector(".enlarge").click();
    const isOpen = document.querySelector("dialog.zoom").open && document.querySelector(".zoom-content .area").clientWidth > 200;
    document.querySelector("dialog.zoom").close();
    return isOpen;
  })()`);
  if (!large) faults.push(`${name}: a picture does not open in large`);
  await picture(name);
}
await page("Emulation.setScriptExecutionDisabled", { value: true });
await load(address);
await picture("without-scripts.png");
await close();
for (const fault of faults) console.error(fault);
console.log(`${file}: ${faults.length} faults; its pictures are in ${folder}`);
process.exit(faults.length > 0 ? 1 : 0);
