#!/usr/bin/env node
// Opens a report as its readers do, in headless Chromium: at a desk, in the dark, on
// a phone and in print. Fails if the page asks for anything but itself, says
// anything on the console, or is wider than the phone. Look at the pictures it leaves.
//
//     scripts/look-at-report.mjs results/fig09/report.html FOLDER
//
// Needs Node and Chromium (CHROMIUM, or `chromium` on the path), and no package.
// Exit codes: 0 no fault, 1 faults, 2 bad usage, 3 the page could not be looked at.
import { spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [report, folder] = process.argv.slice(2);
if (!report || !folder) {
  console.error("usage: look-at-report.mjs REPORT FOLDER");
  process.exit(2);
}
const profile = mkdtempSync(join(tmpdir(), "look-"));
const chromium = spawn(
  process.env.CHROMIUM ?? "chromium",
  ["--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", `--user-data-dir=${profile}`],
  { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] },
);
const giveUp = (why) => {
  console.error(`skipped: ${why}`);
  chromium.kill();
  process.exit(3);
};
chromium.on("error", (error) => giveUp(`Chromium cannot be started (${error.code})`));
process.on("uncaughtException", (error) => giveUp(error.message));
setTimeout(() => giveUp("Chromium does not answer"), 120_000).unref();
const [, , , toChromium, fromChromium] = chromium.stdio;

// The DevTools protocol: JSON messages that end with a zero byte.
const waiting = new Map();
const listeners = new Map();
let number = 0;
let buffered = "";
fromChromium.on("data", (bytes) => {
  const pieces = (buffered + bytes).split("\0");
  buffered = pieces.pop();
  for (const message of pieces.map((piece) => JSON.parse(piece))) {
    if (message.id) waiting.get(message.id)(message);
    else listeners.get(message.method)?.(message.params);
  }
});
const send = (method, params = {}, sessionId) =>
  new Promise((done, fail) => {
    number += 1;
    waiting.set(number, ({ error, result }) => (error ? fail(new Error(`${method}: ${error.message}`)) : done(result)));
    toChromium.write(`${JSON.stringify({ id: number, method, params, sessionId })}\0`);
  });

const faults = [];
const { targetId } = await send("Target.createTarget", { url: "about:blank" });
const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
const page = (method, params) => send(method, params, sessionId);
const address = pathToFileURL(resolve(report)).href;
listeners.set("Network.requestWillBeSent", ({ request }) => {
  if (request.url.split("#")[0] !== address && !request.url.startsWith("data:")) faults.push(`request for ${request.url}`);
});
listeners.set("Runtime.consoleAPICalled", ({ args }) => faults.push(`console: ${JSON.stringify(args)}`));
listeners.set("Runtime.exceptionThrown", ({ exceptionDetails }) => faults.push(`exception: ${exceptionDetails.text}`));
listeners.set("Log.entryAdded", ({ entry }) => faults.push(`console: ${entry.text}`));
for (const domain of ["Network", "Runtime", "Log", "Page"]) await page(`${domain}.enable`);

const load = async () => {
  const loaded = new Promise((done) => listeners.set("Page.loadEventFired", done));
  await page("Page.navigate", { url: address });
  await loaded;
};
const save = (name, data) => writeFileSync(join(folder, name), Buffer.from(data, "base64"));
mkdirSync(folder, { recursive: true });
for (const [name, width, height, scheme, scale] of [
  ["desk", 1280, 800, "light", 1],
  ["dark", 1280, 800, "dark", 1],
  ["phone", 390, 844, "light", 2],
  ["phone-dark", 390, 844, "dark", 2],
]) {
  await page("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile: width < 500 });
  await page("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: scheme }] });
  await load();
  const { result } = await page("Runtime.evaluate", { expression: "document.documentElement.scrollWidth" });
  if (result.value > width) faults.push(`${name}: the page is ${result.value} px wide`);
  const { data } = await page("Page.captureScreenshot", { captureBeyondViewport: true });
  save(`${name}.png`, data);
}
await page("Emulation.clearDeviceMetricsOverride");
const { data } = await page("Page.printToPDF", { preferCSSPageSize: true, paperWidth: 8.27, paperHeight: 11.69 });
save("print.pdf", data);

await send("Browser.close");
await new Promise((done) => chromium.on("exit", done));
rmSync(profile, { recursive: true, force: true });
for (const fault of faults) console.error(fault);
console.log(`${report}: ${faults.length} faults; its pictures are in ${folder}`);
process.exit(faults.length > 0 ? 1 : 0);
