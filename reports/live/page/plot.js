// Plots in SVG: axes, curves, markers. A plot is drawn anew whenever something changes.

const SPACE = 'http://www.w3.org/2000/svg';
const MARGIN = {left: 58, right: 12, top: 10, bottom: 40};

export function element(name, attributes = {}, ...children) {
  const made = document.createElementNS(SPACE, name);
  for (const [key, value] of Object.entries(attributes)) if (value !== undefined) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

// Ticks at 1, 2 or 5 times a power of ten, about `count` of them.
export function ticksOf(from, to, count) {
  const rough = (to - from) / count,
    power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= rough) ?? 10 * power;
  const ticks = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k) ticks.push(Number((k * step).toPrecision(12)));
  return ticks;
}

// Ticks at 1, 2 and 5 times the powers of ten of a logarithmic axis.
const logTicksOf = (from, to) => {
  const ticks = [];
  for (let power = Math.floor(Math.log10(from)); 10 ** power <= to; ++power)
    for (const digit of [1, 2, 5]) ticks.push(Number(`${digit}e${power}`));
  return ticks.filter((tick) => tick >= from * (1 - 1e-9) && tick <= to * (1 + 1e-9));
};

// The range of values with a margin; that of [0, 1] if there are none.
export function rangeOf(values, margin = 0.06) {
  let from = Infinity,
    to = -Infinity;
  for (const value of values)
    if (Number.isFinite(value)) {
      from = Math.min(from, value);
      to = Math.max(to, value);
    }
  if (!(from <= to)) return [0, 1];
  const more = (to - from) * margin || Math.max(1e-3 * Math.abs(to), 1e-9);
  return [from - more, to + more];
}

const short = (value) => (Object.is(value, -0) ? '0' : String(value).replace('-', '−'));
const place = (value) => Math.max(-1e5, Math.min(1e5, value)).toFixed(2);

// The path of a curve given as points {x, y, dx, dy}; with slopes, by cubics (dx, dy: derivatives with respect to `at`).
export function pathOf(points, X, Y) {
  let path = '';
  points.forEach((p, k) => {
    const before = points[k - 1],
      third = before && p.at !== undefined ? (p.at - before.at) / 3 : 0;
    const here = `${place(X(p.x))} ${place(Y(p.y))}`;
    if (!before) path += `M${here}`;
    else if (!third) path += `L${here}`;
    else
      path +=
        `C${place(X(before.x + third * before.dx))} ${place(Y(before.y + third * before.dy))} ` +
        `${place(X(p.x - third * p.dx))} ${place(Y(p.y - third * p.dy))} ${here}`;
  });
  return path;
}

// Draws into an <svg>. Given: label of the whole for screen readers; x and y: {label, range}, x with `log`; curves: {points,
// kind}, where kind is a class of style.css; markers: {x, y, kind, title, text}; lines: {points: [[x, y], [x, y]], kind, arrow}; areas: {points, kind, to}, filled from the points to the value `to`.
// Returned: the scales X, Y from values to pixels and their inverses.
export function draw(svg, {label, x, y, curves = [], markers = [], lines = [], areas = []}) {
  const width = svg.clientWidth || 600,
    height = svg.clientHeight || 360;
  const right = width - MARGIN.right,
    bottom = height - MARGIN.bottom;
  const scale = x.log ? Math.log : (value) => value;
  const [from, to] = x.range.map(scale);
  const X = (value) => MARGIN.left + ((scale(value) - from) / (to - from)) * (right - MARGIN.left);
  const Y = (value) => bottom - ((value - y.range[0]) / (y.range[1] - y.range[0])) * (bottom - MARGIN.top);
  const clip = `${svg.id}-clip`;
  const frame = element('g', {class: 'frame'});
  for (const tick of x.log ? logTicksOf(...x.range) : ticksOf(...x.range, Math.max(3, width / 90)))
    frame.append(
      element('line', {x1: X(tick), x2: X(tick), y1: MARGIN.top, y2: bottom}),
      element('text', {x: X(tick), y: bottom + 16, 'text-anchor': 'middle'}, short(tick)),
    );
  for (const tick of ticksOf(...y.range, Math.max(3, height / 45)))
    frame.append(
      element('line', {x1: MARGIN.left, x2: right, y1: Y(tick), y2: Y(tick)}),
      element('text', {x: MARGIN.left - 6, y: Y(tick) + 4, 'text-anchor': 'end'}, short(tick)),
    );
  frame.append(
    element('text', {class: 'name', x: (MARGIN.left + right) / 2, y: height - 6, 'text-anchor': 'middle'}, x.label),
    element(
      'text',
      {
        class: 'name',
        x: 12,
        y: (MARGIN.top + bottom) / 2,
        'text-anchor': 'middle',
        transform: `rotate(-90 12 ${(MARGIN.top + bottom) / 2})`,
      },
      y.label,
    ),
  );
  const inside = element('g', {'clip-path': `url(#${clip})`});
  for (const {points, kind, to} of areas)
    if (points.length > 1)
      inside.append(
        element('path', {class: `area ${kind}`, d: `${pathOf(points, X, Y)}L${place(X(points.at(-1).x))} ${place(Y(to))}L${place(X(points[0].x))} ${place(Y(to))}Z`}),
      );
  for (const {points, kind} of curves) inside.append(element('path', {class: `curve ${kind}`, d: pathOf(points, X, Y)}));
  for (const {points, kind, arrow} of lines) {
    const [[x1, y1], [x2, y2]] = points.map(([at, value]) => [Number(place(X(at))), Number(place(Y(value)))]);
    inside.append(element('line', {class: kind, x1, y1, x2, y2}));
    const angle = (Math.atan2(y2 - y1, x2 - x1) * 180) / Math.PI;
    if (arrow && Math.hypot(x2 - x1, y2 - y1) > 9)
      inside.append(
        element('path', {class: `head ${kind}`, d: 'M0 0L-9 3.5L-9 -3.5Z', transform: `translate(${x2} ${y2}) rotate(${angle})`}),
      );
  }
  const marks = element('g'); // whole at the edge, too
  for (const {x: at, y: value, kind, title, text} of markers) {
    const [cx, cy] = [place(X(at)), place(Y(value))].map(Number);
    if (cx < MARGIN.left - 1 || cx > right + 1 || cy < MARGIN.top - 1 || cy > bottom + 1) continue;
    marks.append(
      element(
        'circle',
        {class: `marker ${kind}`, cx, cy, r: kind === 'chosen' ? 8 : 4.5},
        ...(title ? [element('title', {}, title)] : []),
      ),
    );
    if (text)
      marks.append(
        element('text', {class: 'note', x: Math.max(MARGIN.left + 30, Math.min(right - 30, cx)), y: cy + 21, 'text-anchor': 'middle'}, text),
      );
  }
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', label);
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  svg.replaceChildren(
    element(
      'defs',
      {},
      element(
        'clipPath',
        {id: clip},
        element('rect', {
          x: MARGIN.left,
          y: MARGIN.top,
          width: Math.max(1, right - MARGIN.left),
          height: Math.max(1, bottom - MARGIN.top),
        }),
      ),
    ),
    frame,
    inside,
    marks,
  );
  return {X, Y, marks};
}
