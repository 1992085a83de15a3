// The worker: solves one request after the other. Messages to it: {module} once, then {id, request}. Messages from it:
// {id, progress: {points, approach, load}} while it solves, and {id, answer, profiles, memory}.
import {makeSolver} from './solver.js';

const INTERVAL = 60; // ms between messages about progress
const MOST_NUMBERS = 1.2e7; // of all profiles that are kept: 48 MB

// Keeps gap and traction at the points of the curve; if there are too many, at every second point, every fourth, ...
function makeKeeper() {
  let kept = new Map(),
    stride = 1,
    numbers = 0;
  return {
    add(number, rows) {
      if (number === 0) {
        kept = new Map();
        stride = 1;
        numbers = 0;
      }
      if (number % stride) return;
      kept.set(number, Float32Array.from(rows));
      numbers += rows.length;
      if (numbers <= MOST_NUMBERS) return;
      stride *= 2;
      for (const [key, profile] of kept)
        if (key % stride) {
          numbers -= profile.length;
          kept.delete(key);
        }
    },
    all: () => [...kept],
  };
}

let solver;
onmessage = ({data}) => {
  if (data.module) {
    solver = makeSolver(data.module);
    return;
  }
  const keeper = makeKeeper();
  let points = [],
    last = performance.now();
  const hooks = {
    progress(approach, load) {
      points.push(approach, load);
      const now = performance.now();
      if (now - last < INTERVAL) return;
      last = now;
      postMessage({id: data.id, progress: {points}});
      points = [];
    },
    profile: (number, rows) => keeper.add(number, rows),
  };
  let answer;
  try {
    answer = solver.ask(data.request, hooks);
  } catch (error) {
    answer = {error: `the solver stopped: ${error.message}`, stopped: true};
  }
  const profiles = keeper.all();
  postMessage(
    {id: data.id, answer, profiles, memory: solver.memory()},
    profiles.map(([, rows]) => rows.buffer),
  );
};
