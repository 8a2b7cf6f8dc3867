// Follows cases with the engine of a page, as the page does, and prints their histories as
// JSON: node follow.mjs FOLDER_OF_THE_ENGINE OPENING.json, which is
// { opening, cases: [{ case, set, method }] }.
import { readFileSync } from "node:fs";
import vm from "node:vm";

const [folder, asked] = process.argv.slice(2);
vm.runInThisContext(readFileSync(`${folder}/engine.js`, "utf8"));
const { opening, cases } = JSON.parse(readFileSync(asked, "utf8"));
const engine = await startEngine(readFileSync(`${folder}/engine.wasm.gz`).toString("base64"));
const sweep = await engine.open(opening);
const answers = [];
for (const one of cases) {
  try {
    const { row, columns, milliseconds } = await engine.simulate(one);
    const plain = Object.entries(columns).map(([name, values]) => [name, [...values]]);
    answers.push({ row, columns: Object.fromEntries(plain), milliseconds });
  } catch (error) {
    answers.push({ error: error.message });
  }
}
console.log(JSON.stringify({ sweep, answers }));
engine.close();
