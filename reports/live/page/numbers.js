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
      energyName: `${load}ε`,
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

// The rows of the main numbers of a result.
export function mainRows(answer) {
  const {document: result} = answer,
    u = unitsOf(answer),
    p = result.pull_off,
    loops = result.hysteresis;
  if (!p) return [['Pull-off', 'none was found', '']];
  const rows = [
    ['Pull-off force', withError(p.force * u.force, p.error_estimate * u.force), u.forceName],
    ['Approach at pull-off', withError(p.approach * u.length, p.approach_error_estimate * u.length), u.lengthName],
    [
      'Contact radius at pull-off',
      withError(p.contact_radius === null ? null : p.contact_radius * u.length, p.contact_radius_error_estimate * u.length),
      u.lengthName,
    ],
  ];
  if (p.preload?.approach != null)
    rows.push(
      ['Preload needed: approach', withError(p.preload.approach * u.length), u.lengthName],
      ['Preload needed: load', withError(p.preload.load * u.force), u.forceName],
    );
  for (const [name, how] of [
    ['displacement_control', 'at given approach'],
    ['spring', 'through the spring'],
  ]) {
    const loop = loops?.[name];
    if (loop?.energy_lost != null)
      rows.push([
        `Energy lost in a loop ${how}`,
        withError(loop.energy_lost * u.energy, loop.energy_lost_error_estimate * u.energy),
        u.energyName,
      ]);
  }
  return rows;
}

export const KINDS = {
  jump_in: 'jump into contact',
  jump_out: 'jump out of contact',
  minimum: 'minimum of the load',
  maximum: 'maximum of the load',
};

export const specialRows = (answer) => {
  const u = unitsOf(answer),
    {folds, extrema} = answer.document;
  return [...folds, ...extrema]
    .sort((a, b) => a.position - b.position)
    .map((s) => [
      KINDS[s.kind],
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
