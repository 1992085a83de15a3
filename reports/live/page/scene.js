// The scene: the fields of the form, the fragment of the address, the request to the solver and the command line. All of
// them use the names of the options of `pulloff solve`.

const isSphere = (scene) => (scene.profile ?? 'sphere') === 'sphere';
const isSI = (scene) => 'from-physical' in scene;
const hasWaves = (scene) => 'waves' in scene;
const isPanel = (scene) => (scene.scheme ?? 'panel') === 'panel';
const inEpsilon = (scene) => !isSI(scene);
const isTable = (scene) => scene.profile === 'table' && inEpsilon(scene);

// The table that the form begins with: a sphere of radius 80 with a worn end.
const WORN = 'r,gap\n' + Array.from({length: 41}, (_, r) => `${r},${Number((r ** 4 / (160 * (r ** 2 + 60))).toPrecision(6))}\n`).join('');
export const TABLE_NAME = 'profile.csv';

// The unit of loads, by the profile.
export const loadUnitOf = (scene) => (isSphere(scene) ? 'πwR' : 'πwε');
export const labelOf = ({label}, scene) => (typeof label === 'function' ? label(scene) : label);

// One row a field: the option; the label, or that for a scene; its usual value; `range`, that of the slider (logarithmic unless it begins
// with 0); `choices`; `isTable`, whether it is the text of a table; `of`, whether a scene has the
// field; `law` or `profile`, to which alone it belongs; `si`, the SI unit in
// which the form shows it; `part`, where; `varies`, whether a series can vary it.
export const FIELDS = [
  {name: 'tabor', label: 'Tabor parameter μ', usual: '1', range: [0.05, 20], of: (s) => inEpsilon(s) && isSphere(s)},
  {name: 'coupling', label: 'Coupling w/(E*ε)', usual: '0.1', range: [0.001, 10], of: (s) => inEpsilon(s) && !isSphere(s)},
  {name: 'amplitude', label: 'Amplitude A of the wave (ε)', usual: '0', range: [0, 8], of: (s) => inEpsilon(s) && !hasWaves(s)},
  {name: 'wavelength', label: 'Wavelength λ (ε)', usual: '20', range: [2, 100], of: (s) => inEpsilon(s) && !hasWaves(s)},
  {name: 'radius', label: 'Radius R of the sphere (ε)', usual: '100', range: [10, 2000], of: (s) => inEpsilon(s) && isSphere(s)},
  {name: 'modulus-pa', label: 'Contact modulus E* (GPa)', usual: '1e10', si: 1e9, range: [1e6, 1e12], of: isSI},
  {name: 'work-j-per-m2', label: 'Work of adhesion w (mJ/m²)', usual: '0.05', si: 1e-3, range: [1e-3, 1], of: isSI},
  {name: 'distance-m', label: 'Equilibrium distance ε (nm)', usual: '4e-10', si: 1e-9, range: [1e-10, 2e-9], of: isSI},
  {name: 'radius-m', label: 'Radius R of the sphere (nm)', usual: '1e-6', si: 1e-9, range: [1e-8, 1e-5], of: isSI},
  {name: 'amplitude-m', label: 'Amplitude A of the wave (nm)', usual: '0', si: 1e-9, range: [0, 5e-9], of: isSI},
  {name: 'wavelength-m', label: 'Wavelength λ (nm)', usual: '2e-8', si: 1e-9, range: [1e-9, 1e-7], of: isSI},
  {name: 'outer-radius-m', label: 'Outer radius of the surface (nm, or inf)', usual: 'inf', si: 1e-9, of: isSI, part: 'more'},
  {
    name: 'profile',
    label: 'Profile of the body',
    usual: 'sphere',
    choices: ['sphere', 'cone', 'power', 'punch', 'truncated', 'exact_sphere', 'hyperboloid', 'table'],
    of: inEpsilon,
  },
  {name: 'cone-t', label: 'Slope T of the cone', usual: '0.3', range: [0.01, 2], profile: 'cone'},
  {name: 'power-c', label: 'Factor C of C rᴺ', usual: '0.01', range: [1e-4, 1], profile: 'power'},
  {name: 'power-n', label: 'Exponent N of C rᴺ', usual: '3', range: [1.1, 8], profile: 'power'},
  {name: 'punch-b', label: 'Radius B of the flat end (ε)', usual: '5', range: [0.5, 50], profile: 'punch'},
  {name: 'punch-r', label: 'Radius R of the rounded edge (ε)', usual: '20', range: [1, 500], profile: 'punch'},
  {
    name: 'truncated-b',
    label: 'Radius B of the flat end (ε)',
    usual: '5',
    range: [0.5, 50],
    profile: 'truncated',
  },
  {
    name: 'truncated-r',
    label: 'Radius R of the sphere (ε)',
    usual: '90',
    range: [10, 1000],
    profile: 'truncated',
  },
  {name: 'exact-sphere-r', label: 'Radius R of the sphere (ε)', usual: '90', range: [10, 1000], profile: 'exact_sphere'},
  {name: 'hyperboloid-t', label: 'Slope T of the cone', usual: '0.3', range: [0.01, 2], profile: 'hyperboloid'},
  {name: 'hyperboloid-b', label: 'Radius B of the blunt tip (ε)', usual: '5', range: [0.5, 50], profile: 'hyperboloid'},
  {name: 'table', label: 'Table: columns r and gap', usual: WORN, isTable: true, of: isTable},
  {name: 'table-scale', label: 'Unit of the table (ε)', usual: '1', range: [0.01, 100], of: isTable},
  {name: 'law', label: 'Traction–separation law', usual: 'lennard-jones', choices: ['lennard-jones', 'mie', 'morse']},
  {name: 'mie-m', label: 'Exponent M', usual: '4', range: [1.5, 8], law: 'mie'},
  {name: 'mie-n', label: 'Exponent N', usual: '10', range: [4, 20], law: 'mie'},
  {name: 'morse-a', label: 'Parameter A', usual: '1', range: [0.2, 5], law: 'morse'},
  {name: 'waves', label: 'Several waves: A,λ; A,λ; … (ε)', usual: '', of: inEpsilon, part: 'more'},
  {name: 'outer-radius', label: 'Outer radius of the surface (ε, or inf)', usual: 'inf', of: inEpsilon, part: 'more'},
  {name: 'preload', label: 'Preload: approach (ε, or inf)', usual: '', part: 'more', of: inEpsilon},
  {name: 'preload-load', label: (s) => `Preload: load (${loadUnitOf(s)})`, usual: '', part: 'more', of: inEpsilon},
  {name: 'preload-load-n', label: 'Preload: load (nN)', usual: '', si: 1e-9, of: isSI, part: 'more'},
  {
    name: 'stiffness',
    label: (s) => `Stiffness k of the spring (${isSphere(s) ? 'πwR/ε' : 'πw'})`,
    usual: '',
    range: [1e-3, 10],
    of: (s) => inEpsilon(s) && 'stiffness' in s,
    part: 'control',
  },
  {
    name: 'stiffness-n-per-m',
    label: 'Stiffness k of the spring (N/m)',
    usual: '',
    si: 1,
    range: [0.01, 1000],
    of: (s) => isSI(s) && 'stiffness-n-per-m' in s,
    part: 'control',
  },
  {name: 'approach-start', label: 'Approach at the beginning (ε)', usual: '', part: 'more', of: inEpsilon},
  {name: 'approach-end', label: 'Approach at the end (ε)', usual: '', part: 'more', of: inEpsilon},
  {name: 'scheme', label: 'Elements', usual: 'panel', choices: ['panel', 'ring', 'triangle'], part: 'more'},
  {
    name: 'grading',
    label: 'Spacing of the nodes',
    usual: 'uniform',
    choices: ['uniform', 'graded'],
    of: (s) => !isPanel(s),
    part: 'more',
  },
  {name: 'nodes', label: 'Number of nodes', usual: '501', of: (s) => !isPanel(s), part: 'more'},
  {name: 'tolerance', label: 'Relative tolerance on the force', usual: '1e-6', of: isPanel, part: 'more'},
  {name: 'time-limit', label: 'Limit of the processor time (s)', usual: '', part: 'more'},
];

const FIELD = new Map(FIELDS.map((field) => [field.name, field]));
const has = (scene, field) =>
  (!field.of || field.of(scene)) && ['law', 'profile'].every((owner) => !field[owner] || scene[owner] === field[owner]);
export const fieldsOf = (scene) => FIELDS.filter((field) => has(scene, field));
export const valueOf = (scene, name) => scene[name] ?? FIELD.get(name).usual;

// Options that a profile, a law or SI units need, whether or not the value is the usual one.
const isNeeded = (field) => field.law || field.profile || /^(coupling|table)$|-(m|pa|m2)$/.test(field.name);
export const SI_ENDING = /-(n-per-m|j-per-m2|pa|m|n)$/;
const isWave = (name) => /^wavelength/.test(name);

// The option of the stiffness; and a scene with a spring, or without.
const stiffnessName = (scene) => (isSI(scene) ? 'stiffness-n-per-m' : 'stiffness');
const SOFT = {stiffness: '0.05', 'stiffness-n-per-m': '20'};
export const hasSpring = (scene) => stiffnessName(scene) in scene;
export function withSpring(scene, wanted) {
  const {[stiffnessName(scene)]: before, ...without} = scene;
  return wanted ? {...without, [stiffnessName(scene)]: before || SOFT[stiffnessName(scene)]} : without;
}
const amplitudeOf = (scene) => valueOf(scene, isSI(scene) ? 'amplitude-m' : 'amplitude');

// The value that an empty field stands for; none if the solver then wants one.
export const placeholderOf = (field) => (isNeeded(field) || isWave(field.name) || field.choices ? '' : field.usual);

const isSame = (a, b) => a === b || (a !== '' && b !== '' && Number(a) === Number(b));

// The options of a scene in the order of the fields, [name, text] each, without those that change nothing.
export function optionsOf(scene) {
  const chosen = fieldsOf(scene).filter(({name, usual}) => {
    const text = valueOf(scene, name);
    if (isWave(name)) return Number(amplitudeOf(scene)) !== 0;
    if (name === 'amplitude-m') return Number(text) !== 0;
    return text !== '' && (isNeeded(FIELD.get(name)) ? text !== 'inf' : !isSame(text, usual));
  });
  return [...(isSI(scene) ? [['from-physical', '']] : []), ...chosen.map(({name}) => [name, valueOf(scene, name)])];
}

const wavesOf = (text) =>
  text
    .split(';')
    .map((wave) => wave.trim())
    .filter(Boolean);

// The request to the solver (reports/live/machine/live.c).
export function requestOf(scene, want) {
  const keys = {};
  for (const [name, text] of optionsOf(scene)) {
    if (name === 'from-physical' || name === 'table') continue;
    if (text === 'table') keys.profile_file = TABLE_NAME;
    else
      keys[name.replaceAll('-', '_')] =
        name === 'waves'
          ? wavesOf(text)
              .map((wave) => wave.replace(',', '@'))
              .join(';')
          : text;
  }
  if (want) keys.want = want;
  const files = isTable(scene) ? {[TABLE_NAME]: tableOf(scene)} : undefined;
  return {keys, files};
}

// The text of the table of a scene, whose last line ends.
export const tableOf = (scene) => valueOf(scene, 'table').replace(/\n?$/, '\n');

const quoted = (text) => (/^[\w.,:+-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

// The command that computes the same.
const commandLine = (verb, scene, more, without) => {
  const words = optionsOf(scene).flatMap(([name, text]) => {
    if (name === without) return [];
    if (name === 'waves') return wavesOf(text).map((wave) => `--wave ${quoted(wave.replaceAll(' ', ''))}`);
    if (name === 'table') return [];
    if (text === 'table') return [`--profile-file ${TABLE_NAME}`];
    return [text === '' ? `--${name}` : `--${name} ${quoted(text)}`];
  });
  return ['pulloff', verb, ...words, ...more].join(' ');
};
export const commandOf = (scene, want) => commandLine('solve', scene, want ? [`--want ${want}`] : []);

// A series of scenes, {key, from, to, points, log}: the scene without what `pulloff follow` does not have.
const NOT_FOLLOWED = ['scheme', 'grading', 'nodes', 'approach-start', 'approach-end', 'stiffness'];
function followedScene(scene, {key, to}) {
  const followed = Object.fromEntries(Object.entries(scene).filter(([name]) => !NOT_FOLLOWED.includes(name)));
  return {...followed, [key]: String(to)}; // a wave that the series has needs its wavelength
}
export function requestOfSeries(scene, series) {
  const request = requestOf(followedScene(scene, series));
  const key = series.key.replaceAll('-', '_');
  delete request.keys[key];
  return {...request, series: {...series, key}};
}
export const commandOfSeries = (scene, {key, from, to, points, log}) =>
  commandLine(
    'follow',
    followedScene(scene, {key, to}),
    [`--key ${key} --from ${from} --to ${to} --points ${points}${log ? '' : ' --scale linear'}`],
    key,
  );

// The fields that a series can vary.
export const variedFields = (scene) => fieldsOf(scene).filter(({range, part, name}) => range && !part && !isSI(scene) && name !== 'table-scale');

// The address of a scene. It is not empty for the scene of all usual values, because an address without a scene is that of
// another scene (START in page.js).
export function fragmentOf(scene) {
  const options = optionsOf(scene);
  return (
    '#' +
    (options.length ? options : [['tabor', valueOf(scene, 'tabor')]])
      .map(([name, text]) => (text === '' ? name : `${name}=${encodeURIComponent(text).replace(/%2C/g, ',').replace(/%3B/g, ';')}`))
      .join('&')
  );
}

const LONGEST = 200, // characters of a value
  LONGEST_TABLE = 1e6;

// The scene of a fragment, and messages about parts that are left out.
export function sceneOf(fragment) {
  const scene = {},
    messages = [];
  for (const part of fragment.replace(/^#/, '').split('&').filter(Boolean)) {
    const at = part.indexOf('=');
    const name = at < 0 ? part : part.slice(0, at);
    let text = at < 0 ? '' : part.slice(at + 1);
    try {
      text = decodeURIComponent(text);
    } catch {
      messages.push(`The address has a value of ${name.slice(0, 40)} that cannot be read.`);
      continue;
    }
    const field = FIELD.get(name);
    if (name === 'from-physical') scene[name] = '';
    else if (!field) messages.push(`The address has an unknown option ${name.slice(0, 40)}.`);
    else if (text.length > (field.isTable ? LONGEST_TABLE : LONGEST))
      messages.push(`The value of ${name} in the address is longer than ${field.isTable ? LONGEST_TABLE : LONGEST} characters.`);
    else if (field.choices && !field.choices.includes(text))
      messages.push(`${name} is ${text.slice(0, 40)}: expected ${field.choices.join(', ')}.`);
    else if (text === '') messages.push(`The address has no value of ${name}.`);
    else {
      if (name in scene) messages.push(`The address has ${name} more than once: the last one is taken.`);
      scene[name] = text;
    }
  }
  for (const name of Object.keys(scene))
    if (name !== 'from-physical' && !has(scene, FIELD.get(name))) {
      messages.push(`The option ${name} has no effect on this scene.`);
      delete scene[name];
    }
  return {scene, messages};
}

const rounded = (value) => String(Number(value.toPrecision(6)));

const numberOf = (scene, name) => Number(valueOf(scene, name) || NaN);

// The units of a sphere in SI units: of length in m, of the load in N; 1 for a scene in epsilon.
function scalesOf(scene) {
  const length = isSI(scene) ? numberOf(scene, 'distance-m') : 1;
  return {length, force: isSI(scene) ? Math.PI * numberOf(scene, 'work-j-per-m2') * numberOf(scene, 'radius-m') : 1};
}

// How the points of an unfinished trace, approach in epsilon and load in its unit, are drawn: as those of the result.
export function progressOf(scene) {
  const {length, force} = scalesOf(scene),
    stiffness = hasSpring(scene) ? (numberOf(scene, stiffnessName(scene)) * length) / force : Infinity;
  const [long, strong] = isSI(scene) ? [length * 1e9, force * 1e9] : [1, 1];
  return {
    x: (approach, load) => (approach + load / stiffness) * long,
    y: (load) => load * strong,
    label: `${hasSpring(scene) ? 'base of the spring: approach + load/k' : 'approach'} (${isSI(scene) ? 'nm' : 'ε'})`,
    loadLabel: `load (${isSI(scene) ? 'nN' : loadUnitOf(scene)})`,
  };
}

// What a sphere has in both units: its fields in epsilon and in SI units, and whether they are a length or a load; a
// stiffness is a load over a length.
const CONVERTED = [
  ['radius', 'radius-m', 1, 0],
  ['amplitude', 'amplitude-m', 1, 0],
  ['wavelength', 'wavelength-m', 1, 0],
  ['outer-radius', 'outer-radius-m', 1, 0],
  ['preload-load', 'preload-load-n', 0, 1],
  ['stiffness', 'stiffness-n-per-m', -1, 1],
];
const OF_BOTH = ['law', 'tolerance', 'scheme', 'nodes', 'grading', 'time-limit'];

// A scene in the other units, to six digits, and the names of its options that the other units do not have. SI units are those
// of a sphere, for the usual work of adhesion and distance.
export function inOtherUnits(scene) {
  const toSI = !isSI(scene),
    made = Object.fromEntries(Object.entries(scene).filter(([name]) => FIELD.get(name)?.law || OF_BOTH.includes(name)));
  if (toSI) made['from-physical'] = '';
  const number = (name) => numberOf(scene, name),
    distance = numberOf(toSI ? {} : scene, 'distance-m'),
    work = numberOf(toSI ? {} : scene, 'work-j-per-m2');
  const force = Math.PI * work * (toSI ? number('radius') * distance : number('radius-m'));
  const taken = ['from-physical', ...Object.keys(made), 'tabor', 'modulus-pa', 'work-j-per-m2', 'distance-m'];
  for (const names of CONVERTED) {
    const [from, to] = toSI ? names : [names[1], names[0]],
      scale = (distance ** names[2] * force ** names[3]) ** (toSI ? 1 : -1);
    if (Number.isFinite(number(from) * scale)) made[to] = rounded(number(from) * scale);
    taken.push(from);
  }
  // mu^3 = R w^2/(E*^2 epsilon^3)
  const values = toSI
    ? {'modulus-pa': (Math.sqrt(number('radius') / number('tabor')) * work) / (number('tabor') * distance)}
    : {tabor: Math.cbrt((number('radius-m') * (work / number('modulus-pa')) ** 2) / distance ** 3)};
  for (const [name, value] of Object.entries(values)) if (Number.isFinite(value)) made[name] = rounded(value);
  return {scene: made, lost: optionsOf(scene).map(([name]) => name).filter((name) => !taken.includes(name))};
}

// The request for a point of the JKR curve of a scene at a contact radius: what that theory takes of the member `input` of the
// result of the scene.
export function requestOfJkr(scene, input, at) {
  const taken = Object.entries(input).filter(
    ([name, value]) => value !== null && value !== 'table' && /^(tabor|radius|waves|profile|table|cone|power|punch|truncated|exact_sphere|hyperboloid)/.test(name),
  );
  const keys = Object.fromEntries(taken.map(([name, value]) => [name, String(value)]));
  return {keys, files: requestOf(scene).files, theory: 'jkr', at};
}
