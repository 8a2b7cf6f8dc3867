// Opens sweeps with the engine of a page, as the page does, follows cases of each, and prints what
// it answers as JSON: node follow.mjs FOLDER_OF_THE_ENGINE ASKED.json, which is
// [{ opening, cases: [{ case, set, method }] }].
import { readFileSync } from "node:fs";
import vm from "node:vm";

const [folder, asked] = process.argv.slice(2);
vm.runInThisContext(readFileSync(`${folder}/engine.js`, "utf8"));
const engine = await startEngine(readFileSync(`${folder}/engine.wasm.gz`).toString("base64"));
const answered = async (ask) => {
  try {
    return await ask();
  } catch (error) {
    return { error: error.message };
  }
};
const follow = async (one) => {
  const { row, columns } = await engine.simulate(one);
  const plain = Object.entries(columns).map(([name, values]) => [name, [...values]]);
  return { row, columns: Object.fromEntries(plain) };
};
const answers = [];
for (const { opening, cases } of JSON.parse(readFileSync(asked, "utf8"))) {
  const opened = await answered(async () => ({ ok: await engine.open(opening) }));
  const followed = [];
  for (const one of cases) followed.push(await answered(() => follow(one)));
  answers.push({ opened, followed });
}
console.log(JSON.stringify(answers));
engine.close();
