// The figures of the page: load against approach, gap and traction, staircase.
import {draw, rangeOf} from './plot.js';
import {HELD, kindOf, pullOffOf, unitsOf, withError} from './numbers.js';

// The stiffness of the control: infinite at given approach, 0 at given load; that of a spring is known of a solve that ended
// early, too.
const stiffnessOf = ({document: result}, control) =>
  control === 'load_control' ? 0 : control === 'spring' ? (result.input.stiffness ?? Infinity) : Infinity;

// Whether an equilibrium is stable in a control: the load of the spring must not fall faster than that of the contact.
export const isStable = (answer, p, control) => {
  const stiffness = stiffnessOf(answer, control);
  return p.unstable_modes === 0 && (stiffness === Infinity || (p.load_rate + stiffness * p.approach_rate) * p.approach_rate > 0);
};

// The points that the figure of the load must contain.
function pointsOfInterest({document: result}, control) {
  const {displacement_control: own, load_control: load, spring} = result.hysteresis ?? {};
  const loops = (control === 'spring' ? [spring ?? own] : [own, load]).filter((loop) => loop?.preload);
  const states = loops.flatMap((loop) => [loop.preload, ...loop.jumps.flatMap((jump) => [jump.before, jump.after])]);
  const force = result.pull_off?.force ?? 0;
  const first = result.curve.find((p) => Math.abs(p.load) >= 0.05 * force);
  const all = [...result.folds, ...result.extrema, ...states, ...(first ? [first] : [])].filter((p) => p.approach !== null);
  return all.length > 1 ? [...all, {approach: all[0].approach, load: 0}] : result.curve;
}

// Runs of points of equal stability; each begins with the last point of the one before.
function runsOf(answer, control) {
  const runs = [],
    {curve} = answer.document;
  curve.forEach((p, k) => {
    const stable = isStable(answer, p, control);
    if (!runs.length || runs.at(-1).stable !== stable) runs.push({stable, points: k ? [curve[k - 1]] : []});
    runs.at(-1).points.push(p);
  });
  return runs;
}

// Runs of states of the JKR theory in which the surfaces do not overlap outside the disc of contact, as the theory assumes.
function fullDiscs(jkr) {
  const runs = [[]];
  for (const state of jkr)
    if (state && state.least_gap >= 0) runs.at(-1).push(state);
    else if (runs.at(-1).length) runs.push([]);
  return runs;
}

// Draws the load against the approach, or against the position of the base of the spring, approach + load/k. Given:
// answer; control; jkr: points of the JKR curve; whole: all points; turned: minus the approach to the right, as in the paper; chosen: the number of a point of the curve. Returned: nearest(px, py), the number of the point that is nearest to a place, and the
// first and the last number that are visible.
export function drawLoad(svg, {answer, control, jkr, whole, turned, chosen}) {
  const {document: result} = answer,
    u = unitsOf(answer),
    {curve} = result;
  const shown = whole ? curve : pointsOfInterest(answer, control);
  const stiffness = stiffnessOf(answer, control),
    give = 0 < stiffness && stiffness < Infinity ? 1 / stiffness : 0;
  const way = turned ? -u.length : u.length;
  const at = (p) => (p.approach + give * p.load) * way;
  const what = (turned ? 'minus the ' : '') + (give ? 'base of the spring: approach + load/k' : turned ? 'approach −Δ' : 'approach');
  const x = {label: `${what} (${u.lengthName})`, range: rangeOf(shown.map(at))};
  const [lowest, highest] = rangeOf(shown.map((p) => p.load * u.force));
  const y = {label: `load (${u.forceName})`, range: [lowest - 0.08 * (highest - lowest), highest]}; // with the name of the pull-off below it
  const scaled = (p) => ({
    x: at(p),
    y: p.load * u.force,
    at: p.position,
    dx: (p.approach_rate + give * p.load_rate) * way,
    dy: p.load_rate * u.force,
  });
  const curves = fullDiscs(jkr).map((points) => ({
    kind: 'theory',
    points: points.map((p) => ({x: at(p), y: p.load * u.force})),
  }));
  for (const run of runsOf(answer, control))
    curves.push({kind: run.stable ? 'stable' : 'unstable', points: run.points.map(scaled)});
  const end = (state) => [state.approach === null ? x.range[turned ? 1 : 0] : at(state), state.load * u.force];
  const lines = (result.hysteresis?.[control]?.jumps ?? []).map((jump) => ({
    kind: `jump ${jump.phase}`,
    arrow: true,
    points: [end(jump.before), end(jump.after)],
  }));
  const markers = [...result.extrema, ...result.folds].map((s) => ({
    x: at(s),
    y: s.load * u.force,
    kind: /^jump/.test(s.kind) ? 'fold' : 'extremum',
    title: `${kindOf(s, control)}: approach ${withError(s.approach * u.length)}, load ${withError(s.load * u.force)}`,
  }));
  const p = pullOffOf(result);
  if (p)
    markers.push({
      x: at({approach: p.approach, load: -p.force}),
      y: -p.force * u.force,
      kind: 'pulloff',
      text: 'pull-off',
      title: `pull-off: ${withError(p.force * u.force)} ${u.forceName}`,
    });
  if (curve[chosen]) markers.push({x: at(curve[chosen]), y: curve[chosen].load * u.force, kind: 'chosen'});
  const label =
    `Load against ${what}: ${curve.length} equilibria, ${result.folds.length} folds, ${lines.length} jumps. ` +
    (p
      ? `Pull-off force ${withError(p.force * u.force)} ${u.forceName} at approach ${withError(p.approach * u.length)} ${u.lengthName}.`
      : '');
  const {X, Y} = draw(svg, {label, x, y, curves, lines, markers});
  const isInside = (q) =>
    at(q) >= x.range[0] && at(q) <= x.range[1] && q.load * u.force >= y.range[0] && q.load * u.force <= y.range[1];
  const nearest = (px, py) => {
    let best = 0,
      least = Infinity;
    curve.forEach((q, k) => {
      const distance = Math.hypot(X(at(q)) - px, Y(q.load * u.force) - py);
      if (isInside(q) && distance < least) [best, least] = [k, distance];
    });
    return best;
  };
  return {nearest, first: Math.max(0, curve.findIndex(isInside)), last: Math.max(0, curve.findLastIndex(isInside))};
}

// The load as far as it is computed: points [approach, load], drawn as `how` says (progressOf in scene.js). What is stable is
// not known yet.
export function drawProgress(svg, points, how, turned) {
  const shown = points.map(([approach, load]) => ({x: (turned ? -1 : 1) * how.x(approach, load), y: how.y(load)}));
  const label = (turned ? 'minus the ' : '') + how.label;
  draw(svg, {
    label: `${how.loadLabel} against ${label}, as far as it is computed`,
    x: {label, range: rangeOf(shown.map((p) => p.x))},
    y: {label: how.loadLabel, range: rangeOf(shown.map((p) => p.y))},
    curves: [{kind: 'unfinished', points: shown}],
  });
}

// Numbers of a row of a profile: radius, gap, traction, initial gap.
const ROW = 4;

// The ranges of the figures of gap and traction, the same for all points of a curve.
export function rangesOfProfiles(answer, profiles) {
  const {curve, input} = answer.document,
    u = unitsOf(answer);
  const contact = Math.max(...curve.map((p) => p.contact_radius), 0);
  const radius = contact > 0 ? 1.4 * contact : Math.sqrt(8 * input.radius);
  const waves = (input.waves ?? '').split(';').reduce((sum, wave) => sum + 2.2 * Number(wave.split('@')[0] || 0), 0);
  const tractions = [];
  for (const [, rows] of profiles) for (let k = 0; k < rows.length && rows[k] < radius; k += ROW) tractions.push(rows[k + 2]);
  return {
    radius: [0, radius * u.length],
    gap: [-0.6, Math.max(4, waves)].map(u.gap),
    traction: rangeOf(tractions.map((value) => value * u.traction)),
  };
}

// Draws body and surface of one equilibrium on both sides of the axis. The surface is drawn nearer by the equilibrium distance, so that
// the two touch where they neither attract nor repel each other. Given: approach of the equilibrium.
function drawBodies(svg, {answer, rows, ranges, state, approach}) {
  const u = unitsOf(answer),
    body = [],
    surface = [];
  for (let k = 0; k < rows.length && rows[k] * u.length <= 1.3 * ranges.radius[1]; k += ROW) {
    const height = rows[k + 3] - approach;
    body.push({x: rows[k] * u.length, y: height * u.length});
    surface.push({x: rows[k] * u.length, y: (height - rows[k + 1]) * u.length});
  }
  const both = (points) => [...points.map(({x, y}) => ({x: -x, y})).reverse(), ...points];
  const isShown = ({x}) => x <= ranges.radius[1];
  const [low, high] = rangeOf([...body.filter(isShown).map((p) => p.y), ...surface.filter(isShown).map((p) => p.y)]);
  const stretch = ((high - low) / (2 * ranges.radius[1])) * ((svg.clientWidth || 600) / (svg.clientHeight || 240));
  draw(svg, {
    label: `Body and surface of the half-space ${state}`,
    x: {
      label: `distance from the axis (${u.lengthName}); heights are drawn ${withError(Number((1 / stretch).toPrecision(2)))} times as large`,
      range: [-ranges.radius[1], ranges.radius[1]],
    },
    y: {label: `height (${u.lengthName})`, range: [low, high]},
    areas: [
      {points: both(body), kind: 'body', to: high},
      {points: both(surface), kind: 'half-space', to: low},
    ],
    curves: [
      {points: both(body), kind: 'body'},
      {points: both(surface), kind: 'half-space'},
    ],
  });
}

// Draws body and surface, gap and traction of one equilibrium: rows as above.
export function drawProfile(bodies, gapPlot, tractionPlot, {answer, rows, ranges, state, approach}) {
  const u = unitsOf(answer),
    gaps = [],
    tractions = [];
  drawBodies(bodies, {answer, rows, ranges, state, approach});
  for (let k = 0; k < rows.length; k += ROW) {
    gaps.push({x: rows[k] * u.length, y: u.gap(rows[k + 1])});
    tractions.push({x: rows[k] * u.length, y: rows[k + 2] * u.traction});
  }
  const x = {label: `radius (${u.lengthName})`, range: ranges.radius};
  const zero = (value) => ({
    kind: 'zero',
    points: [
      [ranges.radius[0], value],
      [ranges.radius[1], value],
    ],
  });
  draw(gapPlot, {
    label: `Gap against radius ${state}`,
    x,
    y: {label: u.gapLabel, range: ranges.gap},
    curves: [{kind: 'stable', points: gaps}],
    lines: [zero(u.gap(0))],
  });
  draw(tractionPlot, {
    label: `Traction against radius ${state}, positive in compression`,
    x,
    y: {label: u.tractionLabel, range: ranges.traction},
    curves: [{kind: 'stable', points: tractions}],
    lines: [zero(0)],
  });
}

// Draws the pull-off force of a series of scenes against the parameter that varies. Given: series, the rows of the answer;
// label and log of the axis; choose(value): called for the scene that the reader chooses.
export function drawSeries(svg, {series, unit, label, log}, choose) {
  const found = series.filter((row) => row.force !== null);
  const points = found.map((row) => ({x: row.value, y: row.force}));
  const {marks} = draw(svg, {
    label: `Pull-off force against ${label}: ${found.length} scenes`,
    x: {label, log, range: rangeOf(series.map((row) => row.value), log ? 0 : undefined)},
    y: {label: `pull-off force (${unit})`, range: rangeOf([0, ...points.map((p) => p.y)])},
    curves: [{kind: 'stable', points}],
    markers: points.map(({x, y}) => ({x, y, kind: 'scene', title: `${label} ${withError(x)}: pull-off force ${withError(y)} ${unit}`})),
  });
  marks.querySelectorAll('.scene').forEach((marker, k) => marker.addEventListener('click', () => choose(found[k].value)));
}

// Draws the pull-off force against the load of the preload.
export function drawStaircase(svg, answer, control) {
  const u = unitsOf(answer),
    {staircase} = answer.document;
  const steps = (stairs) => (stairs?.steps ?? []).map((step) => ({...step, last: step.until ?? stairs.reached}));
  const own = steps(staircase?.[control]),
    jkr = steps(staircase?.jkr?.[control]);
  const lineOf = (kind) => (step) => ({
    kind,
    points: [
      [step.preload.load * u.force, step.force * u.force],
      [step.last.load * u.force, step.force * u.force],
    ],
  });
  const all = [...own, ...jkr];
  draw(svg, {
    label: `Pull-off force against the load of the preload, ${HELD[control]}: ${own.length} steps`,
    x: {
      label: `load of the preload (${u.forceName})`,
      range: rangeOf(own.flatMap((step) => [step.preload.load * u.force, step.last.load * u.force])),
    },
    y: {label: `pull-off force (${u.forceName})`, range: rangeOf([0, ...all.map((step) => step.force * u.force)])},
    lines: [...jkr.map(lineOf('step theory')), ...own.map(lineOf('step'))],
  });
  return own.map((step) => [
    withError(step.preload.load * u.force, step.preload.load_error_estimate * u.force),
    withError(step.preload.approach * u.length),
    withError(step.force * u.force, step.error_estimate * u.force),
  ]);
}

// The numbers of the fields that differ among scenes: {NAME: set of values}.
function variedNumbers(scenes) {
  const values = {};
  for (const scene of scenes) for (const [name, text] of Object.entries(scene)) if (Number.isFinite(Number(text))) (values[name] ??= new Set()).add(Number(text));
  return Object.fromEntries(Object.entries(values).filter(([, set]) => set.size > 1));
}

// The scenes of a figure as curves: load against approach, where curves were wanted; otherwise the pull-off force against the field with
// the most values, a curve for each combination of the other fields. Returned: {x, y, curves: [{points, name}]}.
function curvesOfFigure(solved, scenes, labelOfField) {
  const unit = unitsOf(solved[0].answer).forceName;
  const values = variedNumbers(scenes);
  const names = Object.keys(values).sort((a, b) => values[b].size - values[a].size);
  const nameOf = (scene, of) => of.map((name) => `${labelOfField(name)} ${scene[name] ?? '–'}`).join(', ');
  if (solved[0].answer.document.curve?.length)
    return {
      x: {label: 'minus the approach −Δ (ε)'},
      y: {label: `load (${unit})`},
      curves: solved.map(({scene, answer}) => ({name: nameOf(scene, names), points: answer.document.curve.map((p) => ({x: -p.approach, y: p.load}))})),
    };
  const [first, ...others] = names,
    groups = new Map();
  for (const {scene, answer} of solved) {
    const name = nameOf(scene, others);
    if (pullOffOf(answer.document)) groups.set(name, [...(groups.get(name) ?? []), {x: Number(scene[first]), y: answer.document.pull_off.force}]);
  }
  const all = [...(values[first] ?? [])];
  return {
    x: {label: first ? labelOfField(first) : 'scene', log: Math.min(...all) > 0 && Math.max(...all) > 20 * Math.min(...all)},
    y: {label: `pull-off force (${unit})`},
    curves: [...groups].map(([name, points]) => ({name, points: points.sort((a, b) => a.x - b.x)})),
  };
}

// Draws what is solved, [{scene, answer}], of the scenes of a figure. Load curves are cut at a little beyond their zeros, as in the paper.
export function drawFigure(svg, solved, scenes, labelOfField) {
  const {x, y, curves} = curvesOfFigure(solved, scenes, labelOfField);
  const points = curves.flatMap((curve) => curve.points);
  const deepest = Math.min(...points.map((p) => p.y));
  const shown = deepest < 0 ? points.filter((p) => p.y < -0.02 * deepest || p.y < 0) : points;
  const inside = deepest < 0 ? shown.filter((p) => p.y < 0.02 * deepest) : shown;
  draw(svg, {
    label: `${y.label} against ${x.label}: ${curves.length} curves`,
    x: {...x, range: rangeOf(inside.map((p) => p.x), x.log ? 0 : undefined)},
    y: {...y, range: deepest < 0 ? [1.1 * deepest, -0.3 * deepest] : rangeOf([0, ...points.map((p) => p.y)])},
    curves: curves.map(({points: own}, k) => ({kind: `group group${k % 6}`, points: own})),
    markers: curves.flatMap(({points: own, name}, k) => {
      const marked = deepest < 0 ? [own.reduce((least, p) => (p.y < least.y ? p : least))] : own;
      return marked.map((p) => ({...p, kind: `group${k % 6}`, title: `${name ? `${name}: ` : ''}${withError(p.x)}, ${withError(p.y)}`}));
    }),
  });
  return curves.map(({name}) => name);
}
