// As tests/library/solve_json.c, by the WebAssembly of the page, in node: solve_json.mjs SOLVER.JS PULLOFF.WASM WORD...
import {readFileSync} from 'node:fs';

const [solver, wasm, ...words] = process.argv.slice(2);
const {makeSolver} = await import(solver);
const request = {keys: {}, files: {}};
if (words[0] === 'theory') request.theory = words.splice(0, 2)[1];
for (let k = 0; k < words.length; k += 2) request.keys[words[k]] = words[k + 1];
const table = request.keys.profile_file;
if (table) request.files[table] = readFileSync(table, 'utf8');
const answer = makeSolver(new WebAssembly.Module(readFileSync(wasm))).ask(request);
if (answer.error) {
  console.error(answer.error);
  process.exit(1);
}
console.log(JSON.stringify(answer.document, null, 2));
