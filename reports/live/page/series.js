// The pull-off force of scenes in which one parameter varies.
import {commandOfSeries, requestOfSeries, valueOf, variedFields} from './scene.js';
import {fillTable, LOAD_UNITS, withError} from './numbers.js';
import {drawSeries} from './views.js';

const MOST_POINTS = 200;

// The range that is proposed for a field: about its value, or within its slider.
function rangeAbout({range}, value) {
  const middle = value > 0 ? value : range[1] / 10;
  return [middle / 3, middle * 3].map((end) => Number(end.toPrecision(3)));
}

// Fills the part of the page. jobs: a solver; open(name, text): shows the scene with this value. Returned: show(scene).
export function makeSeries(part, jobs, open) {
  const [choice, from, to, points, log, button, state, plot, command] = ['select', ...['from', 'to', 'points', 'log'].map((name) => `[name=${name}]`), 'button', '[role=status]', 'svg', 'pre'].map(
    (what) => part.querySelector(what),
  );
  let scene = {},
    shown = null,
    asked = null; // of the series that is shown or being computed
  const fieldOf = (name) => variedFields(scene).find((field) => field.name === name);

  function propose() {
    const field = fieldOf(choice.value);
    if (field) [from.value, to.value] = rangeAbout(field, Number(valueOf(scene, field.name)));
  }

  function draw() {
    plot.toggleAttribute('hidden', !shown);
    if (shown && part.open) drawSeries(plot, shown, (value) => open(shown.name, String(value)));
  }

  async function compute() {
    const own = scene;
    asked = {key: choice.value, from: Number(from.value || NaN), to: Number(to.value || NaN), points: Math.min(MOST_POINTS, Math.round(Number(points.value))), log: log.checked};
    const mine = asked,
      field = fieldOf(asked.key),
      seen = new Set();
    button.textContent = 'Stop';
    state.textContent = 'Solving …';
    const {answer, seconds} = await jobs.ask(requestOfSeries(own, asked), (progress, elapsed) => {
      for (let k = 0; k < progress.points.length; k += 2) seen.add(progress.points[k]);
      state.textContent = `${seen.size} of ${asked.points} scenes begun, ${elapsed.toFixed(1)} s`;
    });
    button.textContent = 'Compute';
    if (mine !== asked) return;
    if (answer.error) {
      state.textContent = answer.error === 'stopped' ? 'Stopped.' : answer.error;
      return;
    }
    const failed = answer.series.filter((row) => row.force === null).length;
    state.textContent = `${asked.points} scenes in ${seconds.toFixed(1)} s${failed ? `, ${failed} without a pull-off` : ''}. A click on a point opens its scene.`;
    const unit = LOAD_UNITS[answer.load_unit];
    shown = {series: answer.series, unit, label: field.label, log: asked.log, name: asked.key};
    command.textContent = commandOfSeries(own, asked);
    fillTable(
      part.querySelector('table'),
      [field.label, `pull-off force (${unit})`, 'approach (ε)', 'status'],
      answer.series.map((row) => [withError(row.value), withError(row.force, row.error_estimate), withError(row.approach), row.status]),
    );
    draw();
  }

  // A series belongs to its scene, whatever the value of the parameter that varies.
  function forget() {
    asked = shown = null;
    jobs.stop();
    state.textContent = command.textContent = '';
    fillTable(part.querySelector('table'), [], []);
    draw();
  }

  choice.addEventListener('change', propose);
  button.addEventListener('click', () => (jobs.isBusy() ? jobs.stop() : compute()));
  part.addEventListener('toggle', draw);
  addEventListener('resize', draw);
  return {
    show(next) {
      const before = choice.value;
      if (asked && commandOfSeries(next, asked) !== commandOfSeries(scene, asked)) forget();
      scene = next;
      part.hidden = variedFields(scene).length === 0;
      choice.replaceChildren(...variedFields(scene).map(({name, label}) => new Option(label, name)));
      if (fieldOf(before)) choice.value = before;
      if (!fieldOf(before) || !from.value) propose();
    },
  };
}
