// A solver in a worker. One request at a time; a later one takes the place of one that waits. A worker that is stopped, that
// failed or that holds much memory is replaced by a new one.

const PATIENCE = 1500; // ms that a solve is left to run when a later request waits
const MOST_MEMORY = 4e8; // bytes, after a solve

// module: a promise of the compiled module; source: the text of the worker.
export function makeJobs(module, source) {
  let worker = null,
    running = null,
    waiting = null,
    count = 0;
  const address = URL.createObjectURL(new Blob([source], {type: 'text/javascript'}));

  const end = () => {
    worker?.terminate();
    worker = null;
  };
  const begin = async (job) => {
    running = job;
    job.began = performance.now();
    const compiled = await module;
    if (running !== job) return;
    if (!worker) {
      worker = new Worker(address);
      worker.onmessage = receive;
      worker.onerror = (event) => finish({error: `the worker failed: ${event.message}`, stopped: true});
      worker.postMessage({module: compiled});
    }
    worker.postMessage({id: job.id, request: job.request});
  };
  const finish = (answer, more = {}) => {
    const job = running;
    running = null;
    if (answer.stopped || more.memory > MOST_MEMORY) end();
    job?.resolve({answer, seconds: (performance.now() - job.began) / 1000, ...more});
    const next = waiting;
    waiting = null;
    if (next && !running) begin(next);
  };
  const receive = ({data}) => {
    if (data.id !== running?.id) return;
    if (data.progress) running.progress?.(data.progress, (performance.now() - running.began) / 1000);
    else finish(data.answer, {profiles: data.profiles, memory: data.memory});
  };
  const stop = () => {
    if (!running) return;
    end();
    finish({error: 'stopped', stopped: true});
  };

  // Returned: a promise of {answer, profiles, seconds}; answer.stopped: it was stopped, or a later request took its place.
  const ask = (request, progress) =>
    new Promise((resolve) => {
      const job = {id: ++count, request, progress, resolve};
      if (!running) {
        begin(job);
        return;
      }
      waiting?.resolve({answer: {error: 'replaced', stopped: true}});
      waiting = job;
      const late = running;
      setTimeout(() => running === late && waiting && stop(), Math.max(0, PATIENCE - (performance.now() - running.began)));
    });
  return {ask, stop, isBusy: () => running !== null};
}
