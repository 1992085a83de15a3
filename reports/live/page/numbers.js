// Numbers and tables: with errors, in the units of the page.

const sign = (text) => text.replace(/-/g, '−');

// A number with the digits that its error leaves, and the error; six digits if there is none.
export function withError(value, error) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  if (!(error > 0)) return sign(String(Number(value.toPrecision(6))));
  const digits = Math.max(0, Math.min(14, 1 - Math.floor(Math.log10(error))));
  return sign(`${value.toFixed(digits)} ± ${error.toExponential(1)}`);
}

export const LOAD_UNITS = {'pi w R': 'πwR', 'pi w epsilon': 'πwε'};
const ENERGY_UNITS = {'pi w R': 'πwRε', 'pi w epsilon': 'πwε²'};
const JKR_FORCE = 1.5; // of a smooth sphere, pi w R

// The pull-off of a result; null if there is none, or if the solve ended before it is known that this is the one.
export const pullOffOf = (result) => (result.status === 'ok' ? result.pull_off : null);

const keep = (value) => value;

// The units in which an answer is shown: the factor of each dimension, and its name.
export function unitsOf({document, units}) {
  const load = LOAD_UNITS[document.input.load_unit] ?? document.input.load_unit;
  if (!units)
    return {
      length: 1,
      force: 1,
      traction: 1,
      energy: 1,
      lengthName: 'ε',
      forceName: load,
      energyName: ENERGY_UNITS[document.input.load_unit],
      gap: keep,
      gapLabel: 'gap h/ε − 1',
      tractionLabel: `traction p ${document.input.tabor > 0 ? 'μ' : ''}ε/w`,
    };
  return {
    length: units.length * 1e9,
    force: units.force * 1e9,
    traction: units.traction * 1e-6,
    energy: units.force * units.length * 1e18,
    lengthName: 'nm',
    forceName: 'nN',
    energyName: 'aJ',
    gap: (gap) => (1 + gap) * units.length * 1e9,
    gapLabel: 'gap h (nm)',
    tractionLabel: 'traction p (MPa)',
  };
}

// Fills a table: heads, rows of cells; the first cell of a row is its head.
export function fillTable(table, heads, rows) {
  const makeRow = (cells, isHead) => {
    const row = document.createElement('tr');
    cells.forEach((text, k) => {
      const cell = document.createElement(isHead || k === 0 ? 'th' : 'td');
      cell.scope = isHead ? 'col' : k === 0 ? 'row' : '';
      cell.textContent = text;
      row.append(cell);
    });
    return row;
  };
  table.tHead.replaceChildren(...(heads.length ? [makeRow(heads, true)] : []));
  table.tBodies[0].replaceChildren(...rows.map((cells) => makeRow(cells, false)));
}

// The rows of the preload that a pull-off needs.
function preloadRows({preload, until, approach}, u) {
  if (preload?.approach == null) return [['Preload needed', 'no test at given approach measures this minimum of the load', '']];
  const upTo = until?.approach == null ? '' : `up to ${withError(until.approach * u.length)} ${u.lengthName}`;
  if (preload.approach === approach) return [['Preload needed', `none: any contact suffices${upTo ? `, ${upTo} of approach` : ''}`, '']];
  return [
    ['Preload needed: approach beyond', withError(preload.approach * u.length), `${u.lengthName}${upTo ? `, ${upTo}` : ''}`],
    ['Load there', withError(preload.load * u.force), `${u.forceName}${preload.load < 0 ? '; negative: no compression is needed' : ''}`],
  ];
}

// The rows of the wave of a sphere: the numbers of the paper.
function waveRows({waves, radius, profile}) {
  const [amplitude, wavelength] = /^[^;]+@[^;]+$/.test(waves ?? '') ? waves.split('@').map(Number) : [0, 1];
  if (!(amplitude > 0) || profile !== 'sphere') return [];
  return [
    ['A/λ', withError(amplitude / wavelength), ''],
    ['α = AR/λ²', withError((amplitude * radius) / wavelength ** 2), ''],
  ];
}

// What preloads harder than the usual one give, by an answer of a solve that went on beyond it: as the line `harder` of the program.
export function harderWords(answer) {
  const {pull_off: p, pull_off_any: any, status} = answer.document,
    u = unitsOf(answer);
  if (status !== 'ok' || !p) return 'not known: the search found no pull-off';
  const place = (state) => `approach ${withError(state.approach * u.length)} ${u.lengthName} (load ${withError(state.load * u.force)} ${u.forceName})`;
  const givesMore = any && any.force - p.force > Math.max(0, p.error_estimate) + Math.max(0, any.error_estimate);
  const words = [];
  if (givesMore) words.push(`loading beyond ${place(any.preload)} gives the pull-off force ${withError(any.force * u.force)} ${u.forceName}`);
  else if (p.until.approach !== null)
    words.push(`beyond approach ${withError(p.until.approach * u.length)} ${u.lengthName} the tension is greatest where loading is reversed`);
  if (any) words.push(any.complete ? 'none gives a greater pull-off force' : `preloads beyond ${place(any.searched)} were not examined`);
  return words.join('; ') || 'not examined, because the preload of the scene is given';
}

export const HELD = {displacement_control: 'at given approach', load_control: 'at given load', spring: 'through the spring'};

// The rows of the main numbers of a result, for a test in a control.
export function mainRows(answer, control) {
  const {document: result} = answer,
    u = unitsOf(answer),
    p = pullOffOf(result),
    loop = result.hysteresis?.[control];
  if (!p) return [['Pull-off', result.status === 'ok' ? 'none was found' : 'not reached: the solve ended early', '']];
  const rows = [
    ['Pull-off force', withError(p.force * u.force, p.error_estimate * u.force), u.forceName],
    ...(result.input.load_unit === 'pi w R' ? [['Pull-off force relative to that of JKR, 1.5 πwR', withError(p.force / JKR_FORCE, p.error_estimate / JKR_FORCE), '']] : []),
    ['Approach at pull-off', withError(p.approach * u.length, p.approach_error_estimate * u.length), u.lengthName],
    [
      'Contact radius at pull-off',
      withError(p.contact_radius === null ? null : p.contact_radius * u.length, p.contact_radius_error_estimate * u.length),
      u.lengthName,
    ],
    ...preloadRows(p, u),
  ];
  if (loop?.preload)
    rows.push([
      `Energy lost in a loop ${HELD[control]}`,
      ...(loop.energy_lost === null
        ? ['without bound: in the last jump the bodies fly apart', '']
        : [withError(loop.energy_lost * u.energy, loop.energy_lost_error_estimate * u.energy), u.energyName]),
    ]);
  return [...rows, ...waveRows(result.input)];
}

const KINDS = {
  jump_in: 'jump into contact',
  jump_out: 'jump out of contact',
  minimum: 'minimum of the load',
  maximum: 'maximum of the load',
};

// The name of a special point; folds are those at given approach in every control.
export const kindOf = ({kind}, control) =>
  KINDS[kind] + (/^jump/.test(kind) && control !== 'displacement_control' ? ' (at given approach)' : '');

export const specialRows = (answer, control) => {
  const u = unitsOf(answer),
    {folds, extrema} = answer.document;
  return [...folds, ...extrema]
    .sort((a, b) => a.position - b.position)
    .map((s) => [
      kindOf(s, control),
      withError(s.approach * u.length, s.error_estimate * u.length),
      withError(s.load * u.force, s.load_error_estimate * u.force),
      withError(s.contact_radius * u.length),
      String(s.unstable_modes),
    ]);
};

// The theories beside a solve: what each says, and whether its assumptions hold in the computed state.
export const theoryRows = ({document: result, words, units}) => {
  const u = unitsOf({document: result, units});
  return (result.theories ?? []).map((row, k) => {
    const limit = `${row.side === 'at_least' ? 'at least' : 'at most'} ${row.limit}`;
    return row.force === null
      ? [words[k].theory, '–', '–', '–', row.reason, row.source]
      : [
          words[k].theory,
          withError(row.force * u.force),
          row.deviation === null ? '–' : sign(`${row.deviation > 0 ? '+' : ''}${(100 * row.deviation).toFixed(2)}\u00a0%`),
          row.assumptions,
          `${words[k].decided_by} ${row.number === null ? 'unknown' : withError(Number(row.number.toPrecision(4)))}, expected ${limit}`,
          row.source,
        ];
  });
};
