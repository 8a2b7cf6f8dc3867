"use strict";
// The engine of a page: cases followed as `sweep simulate` follows them, by the same program,
// compiled to WebAssembly (crates/page). It works from a file and fetches nothing.
//
//   const engine = await startEngine(gzippedInBase64);
//       The module, as engine.wasm.gz in base64. It runs in a worker; where the browser allows
//       none, in the page. Everything below returns a promise; what is refused rejects with an
//       Error in the words of the command.
//   const sweep = await engine.open({ path, texts, sweep, methods });
//       path: the sweep file's; texts: {path: text} of it and of every file that it names (a
//       file is found by its name alone too). sweep: the resolved sweep of manifest.json,
//       instead of the file's text. methods: those it is to have in addition to its own.
//       Gives { title, methods, cases, axes, sites_from_bit_m, clearances_mm }.
//   const answer = await engine.simulate({ case, values, set, method, full, quick });
//       case: its number (0). values: one for each of the sweep's axes, in place of the case's
//       own. set: {axis: value}, as --set. method: its name; by default the first of the sweep.
//       full: as --full. quick: a linear system that is there may serve though it was built for
//       a longer time; histories then differ in their last digits.
//       Gives { row, columns, time, speed, torque, cut, positions, milliseconds }:
//         row        the row of labels.csv, {column: number, text or null}
//         columns    {name: Float64Array}, those of history.csv
//         time       s;  speed  of the bit, rpm, or undefined;  torque  on it, N m, or undefined
//         cut        { weight, depth, drilled } of a bit that cuts: on it, kN, of a blade's cut and of
//                    the bit, mm; or undefined
//         positions  [{ site, x, y }], mm, from the surface down; empty without a wall
//   const limit = await engine.limit({ of, axis, values });
//       Eq. 74 at values of `torque_dynamic_nm` or `weight_on_bit_kn`; of: a case, as above.
//       Gives { value, torque, speed }: Float64Arrays, N m and rpm.
//   engine.close();

/** Runs in the worker or in the page: gives `ask(request)`, one request at a time. */
function engineCore(module) {
  let exports = null;
  let opening = null;
  const text = () => {
    const bytes = new Uint8Array(exports.memory.buffer, exports.words(), exports.words_length());
    return new TextDecoder().decode(bytes);
  };
  const call = (request) => {
    const input = new TextEncoder().encode(JSON.stringify(request));
    const place = exports.input(input.length);
    new Uint8Array(exports.memory.buffer, place, input.length).set(input);
    try {
      exports.answer();
    } catch (trap) {
      // What panicked is not to be used again.
      const words = exports.words_length() ? JSON.parse(text()).error : String(trap);
      exports = null;
      throw new Error(words);
    }
    const { ok, error } = JSON.parse(text());
    if (error !== undefined) throw new Error(error);
    const numbers = new Float64Array(
      exports.memory.buffer, exports.numbers(), exports.numbers_length(),
    ).slice();
    return { ok, numbers };
  };
  return async (request) => {
    if (!exports) {
      exports = (await WebAssembly.instantiate(module, {})).exports;
      if (opening && !request.open) call(opening);
    }
    const start = performance.now();
    const answer = call(request);
    if (request.open) opening = request;
    return { ...answer, milliseconds: performance.now() - start };
  };
}

/** The module, from gzip in base64. */
async function engineModule(gzippedInBase64) {
  const bytes = Uint8Array.from(atob(gzippedInBase64), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}

/** Asks a worker, or the core itself where none can be made. */
function engineAsk(module) {
  let worker;
  try {
    const source = `const ask = (${engineCore})`
      + `; let core; onmessage = async ({ data }) => {
          if (data.module) { core = ask(data.module); return; }
          try {
            const answer = await core(data.request);
            postMessage({ id: data.id, answer }, [answer.numbers.buffer]);
          } catch (error) { postMessage({ id: data.id, error: error.message }); }
        };`;
    const url = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    worker = new Worker(url);
    URL.revokeObjectURL(url);
    worker.postMessage({ module });
  } catch {
    return { ask: engineCore(module), close: () => {} };
  }
  const open = new Map();
  let last = 0;
  worker.onmessage = ({ data }) => {
    const { resolve, reject } = open.get(data.id);
    open.delete(data.id);
    if (data.error === undefined) resolve(data.answer);
    else reject(new Error(data.error));
  };
  worker.onerror = ({ message }) => {
    open.forEach(({ reject }) => reject(new Error(message)));
    open.clear();
  };
  const ask = (request) => new Promise((resolve, reject) => {
    last += 1;
    open.set(last, { resolve, reject });
    worker.postMessage({ id: last, request });
  });
  return { ask, close: () => worker.terminate() };
}

/** See above. */
async function startEngine(gzippedInBase64) {
  const { ask, close } = engineAsk(await engineModule(gzippedInBase64));
  let axes = [];
  const columnsOf = ({ ok, numbers }) => {
    const length = numbers.length / ok.columns.length;
    const column = (name, place) => [name, numbers.subarray(place * length, (place + 1) * length)];
    return Object.fromEntries(ok.columns.map(column));
  };
  const asked = ({ values, set, ...rest }) => ({
    ...rest,
    set: { ...Object.fromEntries((values ?? []).map((value, at) => [axes[at], value])), ...set },
  });
  return {
    close,
    async open(opening) {
      const { ok } = await ask({ open: opening });
      axes = ok.axes;
      return ok;
    },
    async simulate(request) {
      const answer = await ask({ simulate: asked(request) });
      const columns = columnsOf(answer);
      const sites = Object.keys(columns).filter((name) => name.endsWith("_x_mm"));
      return {
        row: answer.ok.row,
        columns,
        time: columns.time_s,
        speed: columns.bit_speed_rpm,
        torque: columns.torque_on_bit_nm,
        cut: columns.weight_on_bit_kn && {
          weight: columns.weight_on_bit_kn,
          depth: columns.depth_of_cut_mm,
          drilled: columns.bit_depth_mm,
        },
        positions: sites.map((name) => {
          const site = name.slice(0, -"_x_mm".length);
          return { site, x: columns[name], y: columns[`${site}_y_mm`] };
        }),
        milliseconds: answer.milliseconds,
      };
    },
    async limit({ of = {}, axis, values }) {
      const answer = await ask({ limit: { of: asked(of), axis, values } });
      const columns = columnsOf(answer);
      return {
        value: columns.value,
        torque: columns.torque_dynamic_nm,
        speed: columns.surface_speed_rpm,
      };
    },
  };
}
