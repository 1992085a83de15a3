// The figures of the report: their scenes, and whether this page computes the same numbers to the last bit.
import {FIELDS, fragmentOf, labelOf, requestOf, sceneOf} from './scene.js';
import {drawFigure} from './views.js';
import {makeJobs} from './jobs.js';

// The numbers of a result that are compared, in an order that assemble.py has, too.
const numbersOf = ({pull_off: p, folds, extrema}) => [
  ...(p ? [p.force, p.approach, p.contact_radius, p.error_estimate] : []),
  ...[...folds, ...extrema].flatMap((s) => [s.approach, s.load, s.contact_radius, s.error_estimate]),
];

// FNV-1a, 64 bits, of the bytes of the numbers; a null is a NaN.
function hashOf(numbers) {
  const view = new DataView(new ArrayBuffer(8));
  let hash = 0xcbf29ce484222325n;
  for (const number of numbers) {
    view.setFloat64(0, number === null ? NaN : number + 0);
    for (let k = 0; k < 8; ++k) hash = BigInt.asUintN(64, (hash ^ BigInt(view.getUint8(k))) * 0x100000001b3n);
  }
  return hash.toString(16).padStart(16, '0');
}

// Fills the part of the page. figures: {NAME: {title, want, scenes: [[fragment, hash]]}}. Returned: show(name).
export function makeFigures(part, figures, compiled, source) {
  const [choice, button, state, list, plot, legend] = ['select', 'button', '[role=status]', 'ol', 'svg', '.legend'].map((what) => part.querySelector(what));
  part.hidden = Object.keys(figures).length === 0;
  for (const [name, {title}] of Object.entries(figures)) choice.append(new Option(title, name));
  const jobs = [];
  let run = 0,
    solved = []; // {scene, answer} of the figure
  const labelOfField = (name) => labelOf(FIELDS.find((field) => field.name === name) ?? {label: name}, {});

  function drawSolved() {
    plot.toggleAttribute('hidden', solved.length === 0);
    const names = solved.length ? drawFigure(plot, solved, figures[choice.value].scenes.map(([fragment]) => sceneOf(fragment).scene), labelOfField) : [];
    legend.replaceChildren(
      ...(names.length > 1 ? names : []).map((text, k) => Object.assign(document.createElement('span'), {className: `key group group${k % 6}`, textContent: text})),
    );
  }

  function show(name) {
    ++run;
    for (const job of jobs) job.stop();
    solved = [];
    drawSolved();
    if (!Object.hasOwn(figures, name)) return false;
    choice.value = name;
    button.textContent = 'Recompute this figure';
    state.textContent = `${figures[name].scenes.length} scenes`;
    list.replaceChildren(
      ...figures[name].scenes.map(([given]) => {
        const item = document.createElement('li'),
          link = document.createElement('a'),
          fragment = fragmentOf(sceneOf(given).scene);
        link.href = fragment;
        link.textContent = fragment.slice(1).replaceAll('&', ' ');
        item.append(link);
        return item;
      }),
    );
    return true;
  }

  async function recompute() {
    const name = choice.value,
      {scenes, want} = figures[name];
    show(name);
    const mine = run;
    let next = 0,
      done = 0,
      same = 0;
    button.textContent = 'Stop';
    const work = async (job) => {
      while (next < scenes.length && mine === run) {
        const k = next++,
          [fragment, hash] = scenes[k];
        const {scene} = sceneOf(fragment);
        const {answer} = await job.ask(requestOf(scene, want));
        if (mine !== run) return;
        if (answer.document) {
          solved.push({scene, answer});
          drawSolved();
        }
        const isSame = Boolean(answer.document) && hashOf(numbersOf(answer.document)) === hash;
        same += isSame;
        list.children[k].append(isSame ? ' identical' : ` different: ${answer.error ?? answer.document.reason}`);
        state.textContent = `${++done} of ${scenes.length} solved, ${same} identical to the last bit with the report`;
      }
    };
    while (jobs.length < Math.max(1, Math.min(4, (navigator.hardwareConcurrency ?? 2) - 1)))
      jobs.push(makeJobs(compiled, source));
    await Promise.all(jobs.map(work));
    if (mine === run) button.textContent = 'Recompute this figure';
  }

  choice.addEventListener('change', () => show(choice.value));
  button.addEventListener('click', () => {
    if (button.textContent === 'Stop') show(choice.value);
    else recompute();
  });
  addEventListener('resize', drawSolved);
  show(choice.value);
  return {show, first: () => figures[choice.value].scenes[0][0], names: Object.keys(figures)};
}
