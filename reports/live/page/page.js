// The page: the scene of the address is solved, and everything is drawn again when it changes.
import {commandOf, fragmentOf, hasSpring, inOtherUnits, loadUnitOf, progressOf, requestOf, requestOfJkr, sceneOf, tableOf, withSpring, TABLE_NAME} from './scene.js';
import {makeFigures} from './figures.js';
import {makeForm} from './form.js';
import {makeJobs} from './jobs.js';
import {fillTable, harderWords, HELD, mainRows, pullOffOf, specialRows, theoryRows, unitsOf, withError} from './numbers.js';
import {makeSeries} from './series.js';
import {drawLoad, drawProfile, drawProgress, drawStaircase, isStable, rangesOfProfiles} from './views.js';

const START = '#tabor=3&amplitude=1&wavelength=20', // the scene of a page without a scene in its address
  WANT = 'curve,hysteresis,theories',
  WANT_STAIRCASE = 'preload';
const QUIET = 300; // ms of a solve before its progress is shown
const JKR_POINTS = {least: 80, perWave: 40, most: 600}, // of the curve of the JKR theory
  JKR_FIRST = [12, 8, 6, 4, 3, 2, 1].map((power) => 4 ** -power); // radii below the first step, down to the origin
const $ = (id) => document.getElementById(id);

// A part of the page that is the base64 of a gzip.
function unpack(id) {
  const packed = Uint8Array.from(atob($(id).textContent), (c) => c.charCodeAt(0));
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip')));
}
const compiled = unpack('module').arrayBuffer().then((bytes) => WebAssembly.compile(bytes));
compiled.catch((error) => report(`This browser cannot run the solver: ${error.message}`));
const [main, side, stairs, follower, beyond] = [0, 1, 2, 3, 4].map(() => makeJobs(compiled, $('worker').textContent));

const figures = makeFigures($('figures'), await unpack('records').json(), compiled, $('worker').textContent);
const series = makeSeries($('series'), follower, (name, text) => {
  scene = {...scene, [name]: text};
  changeScene();
});
let kept = null, // {scene, fragment}: the address of a figure, until the reader changes its scene
  isFigureWanted = false; // until its first solve is drawn
let {scene, messages} = sceneOfAddress();
let shown = null; // {answer, asked, profiles, ranges, jkr} of the scene `asked`, which is drawn
let chosen = 0,
  hasChosen = false,
  view = null,
  turn = 0;
const control = () => document.querySelector('input[name=control]:checked').value;
// The control in which a scene can be shown: with a spring, and only then, it is that of the spring.
const controlOf = (asked) => (hasSpring(asked) ? 'spring' : control() === 'spring' ? 'displacement_control' : control());

// The scene of the address; #figure=NAME shows a figure of the report and its first scene.
function sceneOfAddress() {
  const name = /^#figure=([^&]*)$/.exec(location.hash)?.[1];
  if (name === undefined) return sceneOf(location.href.includes('#') ? location.hash : START);
  if (!figures.show(name)) {
    const others = figures.names.length ? `only of ${figures.names.join(', ')}` : 'nor of any other: it was made without the records of the figures';
    return {...sceneOf(START), messages: [`This page has no scenes of the figure ${name.slice(0, 40) || 'without a name'}, ${others}. Another scene is shown.`]};
  }
  const first = sceneOf(figures.first());
  kept = {scene: first.scene, fragment: location.hash};
  isFigureWanted = true;
  return first;
}

function report(...texts) {
  $('messages').replaceChildren(
    ...texts.filter(Boolean).map((text) => Object.assign(document.createElement('p'), {textContent: text})),
  );
}

const form = makeForm($('scene'), (name, text) => {
  scene = {...scene, [name]: text};
  if (name === 'waves' && text === '') delete scene.waves;
  messages = [];
  changeScene();
});

// The units of the scene, in words.
function showUnits() {
  const unit = loadUnitOf(scene),
    loads = `loads in ${unit}, with the work of adhesion w${unit === 'πwR' ? ' and the radius R' : ''}`;
  $('hint').textContent = `Otherwise lengths are in ε, the distance at which the surfaces neither attract nor repel each other, and ${loads}.`;
  $('units').textContent = $('si').checked ? 'Lengths are in nm, loads in nN.' : `Lengths are in ε, the equilibrium distance of the law; ${loads}.`;
  $('formula').textContent = `Initial gap: f(r) = ${unit === 'πwR' ? 'r²/2R' : 'profile(r)'} + A (1 − cos 2πr/λ)`;
}

function changeScene() {
  history.replaceState(null, '', kept?.scene === scene ? kept.fragment : fragmentOf(scene));
  $('si').checked = 'from-physical' in scene;
  $('hint').hidden = $('si').checked;
  showUnits();
  beyond.stop();
  showWhose();
  if (hasSpring(scene)) $('spring').checked = true;
  else if ($('spring').checked) document.querySelector('input[name=control]').checked = true;
  form.show(scene);
  series.show(scene);
  solve();
  if ($('stairs').open) solveStaircase();
}

// Says of which scene the numbers and figures are, if it is not that of the form: while this one is solved, and when its solve
// failed or was stopped.
function showWhose() {
  const isOther = shown !== null && shown.asked !== scene;
  document.body.classList.toggle('stale', isOther);
  $('whose').hidden = !isOther;
  $('summary').hidden = $('harder').hidden = isOther;
  const curve = $('load').classList.contains('progress') ? 'The curve is that of the scene of the form, as far as it is computed; the other figures and numbers' : 'Figures and numbers';
  $('whose').textContent = isOther ? `${curve} are those of another scene: ${commandOf(shown.asked)}` : '';
}

async function solve() {
  const mine = ++turn,
    asked = scene,
    how = progressOf(scene),
    points = [];
  $('busy').hidden = true;
  const timer = setTimeout(() => mine === turn && main.isBusy() && showProgress({points: []}, QUIET / 1000), QUIET);
  const showProgress = (progress, seconds) => {
    for (let k = 0; k < progress.points.length; k += 2) points.push([progress.points[k], progress.points[k + 1]]);
    if (mine !== turn || seconds < QUIET / 1000) return;
    $('busy').hidden = false;
    $('busy-text').textContent = `Solving: ${points.length} points, ${seconds.toFixed(1)} s`;
    if (points.length < 2) return;
    $('load').classList.add('progress');
    drawProgress($('load'), points, how, $('turned').checked);
    showWhose();
  };
  const {answer, profiles, seconds} = await main.ask(requestOf(asked, WANT), showProgress);
  clearTimeout(timer);
  // While the reader moves a slider, the scenes on the way that are solved are drawn, too.
  if (mine !== turn && answer.error) return;
  if (mine === turn) $('busy').hidden = true;
  const meant = form.mark(answer.error && !answer.stopped ? answer.error : '');
  if (answer.error) {
    report(...messages, answer.error === 'stopped' ? 'The solve was stopped.' : answer.error + meant);
    if (shown) drawAll();
    return;
  }
  const result = answer.document;
  if (mine === turn)
    report(
      ...messages,
      result.status === 'ok' ? '' : `The solve ended early: ${result.reason}. What was found until then is shown.`,
    );
  shown = {answer, asked, seconds, profiles: new Map(profiles), jkr: [], ranges: rangesOfProfiles(answer, profiles)};
  const p = pullOffOf(result);
  choose(
    hasChosen
      ? nearestTo(result.curve, chosenState)
      : nearestTo(result.curve, p && {approach: p.approach, load: -p.force}),
  );
  showNumbers();
  drawAll();
  if (isFigureWanted && kept?.scene === asked) $('figures').scrollIntoView();
  isFigureWanted = false;
  if (mine !== turn) return;
  evaluateJkr(shown);
  searchHarder(shown);
}

let chosenState = null;
function nearestTo(curve, state) {
  let best = 0,
    least = Infinity;
  if (state)
    curve.forEach((p, k) => {
      const distance = Math.hypot(p.approach - state.approach, 5 * (p.load - state.load));
      if (distance < least) [best, least] = [k, distance];
    });
  return best;
}

function choose(number) {
  chosen = number;
  chosenState = shown.answer.document.curve[number] ?? null;
}

function showNumbers() {
  const {answer, asked, seconds} = shown,
    held = controlOf(asked),
    isOwn = held === 'displacement_control',
    result = answer.document,
    u = unitsOf(answer),
    p = pullOffOf(result);
  fillTable($('numbers'), [], mainRows(answer, held));
  fillTable(
    $('special'),
    ['point', `approach (${u.lengthName})`, `load (${u.forceName})`, `contact radius (${u.lengthName})`, `unstable modes after it${isOwn ? '' : ' (at given approach)'}`],
    specialRows(answer, held),
  );
  fillTable(
    $('theories'),
    ['theory', `pull-off force (${u.forceName})`, 'deviation', 'assumptions hold', 'decided by', 'source'],
    theoryRows(answer),
  );
  $('summary').textContent =
    (p
      ? `Pull-off force ${withError(p.force * u.force)} ${u.forceName} at approach ${withError(p.approach * u.length)} ${u.lengthName}. `
      : result.status === 'ok' ? 'No pull-off was found. ' : 'Pull-off not reached: the solve ended early. ') +
    `${result.folds.length} folds${isOwn ? '' : ' (at given approach)'}, ${result.curve.length} equilibria, solved here in ${seconds.toFixed(2)} s.`;
  $('command').textContent = commandOf(asked, WANT);
  $('save').hidden = asked.profile !== 'table';
  $('save').download = TABLE_NAME;
  $('save').href = `data:text/csv;charset=utf-8,${encodeURIComponent(tableOf(asked))}`;
  $('digest').textContent = result.digest;
}

function drawAll() {
  $('load').classList.remove('progress');
  showWhose();
  view = drawLoad($('load'), {
    ...shown,
    jkr: $('jkr').checked ? shown.jkr : [],
    control: controlOf(shown.asked),
    whole: $('whole').checked,
    turned: $('turned').checked,
    chosen,
  });
  $('point').min = view.first;
  $('point').max = view.last;
  drawChosen();
}

function drawChosen() {
  const {answer, asked, profiles, ranges} = shown,
    held = controlOf(asked),
    u = unitsOf(answer),
    p = answer.document.curve[chosen];
  if (!p) return;
  const state = `at approach ${withError(p.approach * u.length)} ${u.lengthName}, load ${withError(p.load * u.force)} ${u.forceName}`;
  const words = `${state}, contact radius ${withError(p.contact_radius * u.length)} ${u.lengthName}, ${isStable(answer, p, held) ? 'stable' : 'unstable'} ${HELD[held]}`;
  $('point').value = chosen;
  $('point').setAttribute('aria-valuetext', words);
  $('state').textContent = `Equilibrium ${words}`;
  let kept = chosen;
  while (kept > 0 && !profiles.has(kept)) --kept;
  if (profiles.has(kept)) drawProfile($('bodies'), $('gap'), $('traction'), {answer, rows: profiles.get(kept), ranges, state, approach: answer.document.curve[kept].approach});
}

function moveTo(number) {
  if (!shown) return;
  hasChosen = true;
  choose(number);
  drawAll();
}

async function evaluateJkr(own) {
  const {document: result} = own.answer,
    points = [],
    largest = 1.02 * Math.max(...result.curve.map((p) => p.contact_radius));
  const waves = result.input.wavelength && result.input.waves ? largest / result.input.wavelength : 0;
  const count = Math.min(JKR_POINTS.most, Math.max(JKR_POINTS.least, Math.ceil(JKR_POINTS.perWave * waves)));
  const steps = [...JKR_FIRST, ...Array.from({length: count}, (_, k) => k + 1)];
  for (const step of result.input.tabor > 0 && largest > 0 ? steps : []) {
    const {answer: form} = await side.ask(requestOfJkr(own.asked, result.input, (largest * step) / count));
    if (shown !== own) return;
    points.push(form.document);
  }
  own.jkr = points;
  if (!$('load').classList.contains('progress')) drawAll();
}

// What harder preloads give: another solve, which goes on beyond the usual preload.
async function searchHarder(own) {
  const show = (words) => ($('harder').textContent = `Harder preload: ${words}.`);
  show('being searched');
  const {answer} = await beyond.ask(requestOf(withSpring(own.asked, false), ''));
  if (shown === own) show(answer.error ? 'not known: the search was stopped' : harderWords(answer));
}

async function solveStaircase() {
  const asked = scene;
  const began = performance.now();
  shownStaircase = null;
  $('staircase').replaceChildren();
  fillTable($('steps'), [], []);
  $('stairs-command').textContent = $('stairs-digest').textContent = '';
  $('stairs-state').textContent = 'Solving for every preload …';
  const {answer} = await stairs.ask(requestOf(asked, WANT_STAIRCASE), (progress, seconds) => {
    $('stairs-state').textContent = `Solving for every preload: ${seconds.toFixed(1)} s`;
  });
  if (asked !== scene) return;
  $('stairs-state').textContent =
    answer.error ?? `Solved in ${((performance.now() - began) / 1000).toFixed(2)} s. ${answer.document.reason}`;
  if (answer.error) return;
  shownStaircase = answer;
  $('stairs-command').textContent = commandOf(asked, WANT_STAIRCASE);
  $('stairs-digest').textContent = answer.document.digest;
  drawStairs();
}

let shownStaircase = null;
function drawStairs() {
  if (!shownStaircase || !$('stairs').open) return;
  const u = unitsOf(shownStaircase),
    held = control() === 'load_control' ? 'load_control' : 'displacement_control'; // a spring has no staircase of its own
  $('steps').caption.textContent = `${HELD[held]}, a harder preload gives another force from these states on`;
  fillTable(
    $('steps'),
    [`from the load (${u.forceName})`, `from the approach (${u.lengthName})`, `pull-off force (${u.forceName})`],
    drawStaircase($('staircase'), shownStaircase, held),
  );
}

// What the reader does.
$('load').addEventListener('pointerdown', (event) => {
  if (!view || $('load').classList.contains('progress')) return;
  $('load').setPointerCapture(event.pointerId);
  moveTo(view.nearest(event.offsetX, event.offsetY));
});
$('load').addEventListener('pointermove', (event) => {
  if (event.buttons && view && !$('load').classList.contains('progress')) moveTo(view.nearest(event.offsetX, event.offsetY));
});
$('point').addEventListener('input', () => moveTo(Number($('point').value)));
for (const id of ['whole', 'jkr', 'turned']) $(id).addEventListener('change', () => shown && drawAll());
for (const choice of document.querySelectorAll('input[name=control]'))
  choice.addEventListener('change', () => {
    const wanted = control() === 'spring';
    if (wanted !== hasSpring(scene)) {
      scene = withSpring(scene, wanted);
      changeScene();
    } else if (shown) {
      showNumbers();
      drawAll();
    }
    drawStairs();
  });
$('figures').addEventListener('change', () => {
  kept = null;
  history.replaceState(null, '', fragmentOf(scene));
});
$('si').addEventListener('change', () => {
  const other = inOtherUnits(scene);
  scene = other.scene;
  messages = other.lost.length ? [`In the other units the page does not have ${other.lost.join(', ')}: left out.`] : [];
  changeScene();
});
$('stop').addEventListener('click', () => main.stop());
$('stairs').addEventListener('toggle', () => $('stairs').open && solveStaircase());
for (const button of document.querySelectorAll('button[data-copy]'))
  button.addEventListener('click', () => navigator.clipboard?.writeText($(button.dataset.copy).textContent));
addEventListener('hashchange', () => {
  ({scene, messages} = sceneOfAddress());
  hasChosen = false;
  changeScene();
});
addEventListener('resize', () => {
  if (shown && !$('load').classList.contains('progress')) drawAll();
  drawStairs();
});

// For the console, and for tests: (await pulloff.ask({keys: {tabor: '2'}})).answer.
const console_ = makeJobs(compiled, $('worker').textContent);
window.pulloff = {ask: console_.ask, isBusy: main.isBusy};
changeScene();
