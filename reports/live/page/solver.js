// The module pulloff.wasm in JavaScript: requests and answers as objects. The same in a worker of the page and in node.

// What the module takes from its surroundings: a clock, and neither files nor an environment (WASI preview 1).
function surroundings(memory) {
  const view = () => new DataView(memory().buffer);
  const BAD_FILE = 8,
    NO_FILE = 44;
  return {
    environ_get: () => 0,
    environ_sizes_get: (count, size) => {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    clock_time_get: (clock, precision, at) => {
      view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    path_open: () => NO_FILE,
    fd_close: () => BAD_FILE,
    fd_fdstat_get: () => BAD_FILE,
    fd_fdstat_set_flags: () => BAD_FILE,
    fd_prestat_get: () => BAD_FILE,
    fd_prestat_dir_name: () => BAD_FILE,
    fd_read: () => BAD_FILE,
    fd_seek: () => BAD_FILE,
    fd_write: () => BAD_FILE,
    proc_exit: (code) => {
      throw new Error(`the solver ended with status ${code}`);
    },
  };
}

// module: a compiled WebAssembly.Module. Returned: ask(request, hooks) gives the answer to a request as
// reports/live/machine/live.c describes it; hooks, optional: progress(approach, load) at each point of a trace, and
// profile(number, rows), where rows are radius, gap, traction and initial gap of one node after the other.
export function makeSolver(module) {
  let hooks = {};
  const imports = {
    wasi_snapshot_preview1: surroundings(() => solver.memory),
    page: {
      progress: (approach, load) => hooks.progress?.(approach, load),
      profile: (number, at, count) => hooks.profile?.(number, new Float64Array(solver.memory.buffer, at, 4 * count)),
    },
  };
  const solver = new WebAssembly.Instance(module, imports).exports;
  solver._initialize();
  const ask = (request, given = {}) => {
    hooks = given;
    const text = new TextEncoder().encode(JSON.stringify(request) + '\0');
    const from = solver.malloc(text.length);
    new Uint8Array(solver.memory.buffer).set(text, from);
    const to = solver.po_live(from);
    if (!to) return {error: 'out of memory'};
    const bytes = new Uint8Array(solver.memory.buffer);
    const answer = new TextDecoder().decode(bytes.slice(to, bytes.indexOf(0, to)));
    solver.free(to);
    solver.free(from);
    return JSON.parse(answer);
  };
  return {ask, memory: () => solver.memory.buffer.byteLength};
}
