// Headless Chromium by the DevTools protocol, without a package: a page, what it asks the
// network for and what it says on the console.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

/**
 * Chromium with one page. Without Chromium the program ends with exit code 3; once a page is
 * open, an exception, or an answer that does not come within a number of milliseconds, is the page's
 * fault: exit code 1.
 */
export async function browse(patience) {
  const profile = mkdtempSync(join(tmpdir(), "look-"));
  const chromium = spawn(
    process.env.CHROMIUM ?? "chromium",
    ["--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", `--user-data-dir=${profile}`],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] },
  );
  let isThere = false;
  const giveUp = (why) => {
    console.error(isThere ? why : `the page was not checked: ${why}`);
    chromium.kill();
    process.exit(isThere ? 1 : 3);
  };
  chromium.on("error", (error) => giveUp(`Chromium cannot be started (${error.code})`));
  process.on("uncaughtException", (error) => giveUp(error.stack));
  setTimeout(() => giveUp("Chromium does not answer"), patience).unref();
  const [, , , toChromium, fromChromium] = chromium.stdio;
  const waiting = new Map();
  const listeners = new Map();
  let number = 0;
  let buffered = "";
  // JSON messages that end with a zero byte.
  fromChromium.on("data", (bytes) => {
    const pieces = (buffered + bytes).split("\0");
    buffered = pieces.pop();
    for (const message of pieces.map((piece) => JSON.parse(piece))) {
      if (message.id) waiting.get(message.id)(message);
      else listeners.get(message.method)?.(message.params);
    }
  });
  const send = (method, params = {}, sessionId) => new Promise((done, fail) => {
    number += 1;
    waiting.set(number, ({ error, result }) =>
      (error ? fail(new Error(`${method}: ${error.message}`)) : done(result)));
    toChromium.write(`${JSON.stringify({ id: number, method, params, sessionId })}\0`);
  });
  const { targetId } = await send("Target.createTarget", { url: "about:blank" });
  const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
  const page = (method, params) => send(method, params, sessionId);

  const faults = [];
  let address = "";
  const isItself = (url) => url.split("#")[0] === address || /^(data|blob):/.test(url);
  listeners.set("Network.requestWillBeSent", ({ request }) => {
    if (!isItself(request.url)) faults.push(`request for ${request.url}`);
  });
  listeners.set("Runtime.consoleAPICalled", ({ args }) => faults.push(`console: ${JSON.stringify(args)}`));
  listeners.set("Runtime.exceptionThrown", ({ exceptionDetails }) => {
    faults.push(`exception: ${exceptionDetails.exception?.description ?? exceptionDetails.text}`);
  });
  listeners.set("Log.entryAdded", ({ entry }) => faults.push(`console: ${entry.text}`));
  for (const domain of ["Network", "Runtime", "Log", "Page"]) await page(`${domain}.enable`);

  return {
    faults,
    page,
    async load(url) {
      address = url;
      const loaded = new Promise((done) => listeners.set("Page.loadEventFired", done));
      await page("Page.navigate", { url });
      await loaded;
      isThere = true;
    },
    /** The value of an expression of the page, which may be a promise. */
    async evaluate(expression) {
      const answer = await page("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
      if (answer.exceptionDetails) throw new Error(answer.exceptionDetails.exception?.description);
      return answer.result.value;
    },
    async close() {
      await send("Browser.close");
      await new Promise((done) => chromium.on("exit", done));
      rmSync(profile, { recursive: true, force: true });
    },
  };
}
