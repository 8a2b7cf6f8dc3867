// The engine that simulates cases in the page: a worker, so that the page answers meanwhile.

/** What the worker runs: the engine's module, asked in JSON, answering in JSON and numbers. */
const work = () => {
  let wasm;
  const begin = async (bytes) => {
    wasm = (await WebAssembly.instantiate(bytes, {})).instance.exports;
  };
  const answer = () => {
    const { memory, words, words_length, numbers, numbers_length } = wasm;
    const text = new TextDecoder().decode(new Uint8Array(memory.buffer, words(), words_length()));
    return { ...JSON.parse(text), numbers: new Float64Array(memory.buffer, numbers(), numbers_length()).slice() };
  };
  const ask = (request) => {
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const place = wasm.input(bytes.length);
    new Uint8Array(wasm.memory.buffer, place, bytes.length).set(bytes);
    try {
      wasm.answer();
    } catch (trap) {
      // It has left its words; after that it is of no more use.
      return { error: answer().error ?? String(trap), broken: true };
    }
    return answer();
  };
  onmessage = async ({ data }) => {
    try {
      if (data.bytes) await begin(data.bytes);
      postMessage(ask(data.request));
    } catch (error) {
      postMessage({ error: String(error), broken: true });
    }
  };
};

/** One request at a time; a sweep stays open until another is asked for. */
class Engine {
  constructor(element) {
    this.element = element;
    this.worker = null;
    this.open = null;
    this.isBusy = false;
  }

  /** Whether the page holds it. */
  get isThere() {
    return this.element !== null && typeof WebAssembly === "object";
  }

  async bytes() {
    const text = atob(this.element.textContent.trim());
    const packed = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
    const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(unpacked).arrayBuffer();
  }

  /** Ends what is under way: its answer never comes. */
  stop() {
    this.worker?.terminate();
    this.worker = null;
    this.open = null;
    this.isBusy = false;
  }

  async ask(request) {
    const message = { request };
    if (!this.worker) {
      message.bytes = await this.bytes();
      const source = URL.createObjectURL(new Blob([`(${work})()`], { type: "text/javascript" }));
      this.worker = new Worker(source);
      URL.revokeObjectURL(source);
    }
    const { worker } = this;
    this.isBusy = true;
    const answered = await new Promise((done, fail) => {
      worker.onmessage = ({ data }) => done(data);
      worker.onerror = () => fail(new Error("the engine cannot be started here"));
      worker.postMessage(message);
    });
    this.isBusy = false;
    if (answered.broken) this.stop();
    if (answered.error) throw new Error(answered.error);
    return answered;
  }

  /** Simulates a case of a sweep: its columns by name, its row, and the sweep's description. */
  async simulate(opening, asked) {
    if (!this.worker || this.open?.opening !== opening) {
      const { ok } = await this.ask({ open: opening });
      this.open = { opening, description: ok };
    }
    const { ok, numbers } = await this.ask({ simulate: asked });
    const length = numbers.length / ok.columns.length;
    const column = (name, place) => [name, numbers.subarray(place * length, (place + 1) * length)];
    return { row: ok.row, columns: new Map(ok.columns.map(column)), description: this.open.description };
  }
}
