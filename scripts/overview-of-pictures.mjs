#!/usr/bin/env node
// Puts pictures side by side, four columns of 360 pixels, as one PNG.
//
//     scripts/overview-of-pictures.mjs OVERVIEW.png PICTURE.png ...
//
// Needs Node and Chromium (CHROMIUM, or `chromium` on the path), and no package.
// Exit codes: 0 it is there, 1 Chromium failed, 2 bad usage, 3 there is no Chromium.
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { browse } from "./devtools.mjs";

const [overview, ...pictures] = process.argv.slice(2);
if (pictures.length === 0) {
  console.error("usage: overview-of-pictures.mjs OVERVIEW.png PICTURE.png ...");
  process.exit(2);
}
const images = pictures.map((file) => `<img src="data:image/png;base64,${readFileSync(file, "base64")}">`);
const html = `<!DOCTYPE html><style>
  html { overflow: hidden; }
  body { margin: 0; width: 1464px; columns: 4; column-gap: 8px; background: white; }
  img { display: block; width: 360px; margin-bottom: 12px; break-inside: avoid; }
</style>${images.join("")}`;
const folder = mkdtempSync(join(tmpdir(), "overview-"));
const file = join(folder, "overview.html");
writeFileSync(file, html);
const { page, load, evaluate, close } = await browse(60_000);
await load(pathToFileURL(file).href);
const height = await evaluate("document.body.scrollHeight");
await page("Emulation.setDeviceMetricsOverride", { width: 1464, height, deviceScaleFactor: 1, mobile: false });
const { data } = await page("Page.captureScreenshot", {});
writeFileSync(overview, Buffer.from(data, "base64"));
await close();
rmSync(folder, { recursive: true });
