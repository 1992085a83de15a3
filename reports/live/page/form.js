// The form: one row for each field that the scene has, with a slider where the field has a range.
import {FIELDS, fieldsOf, labelOf, placeholderOf, SI_ENDING, TABLE_NAME, valueOf} from './scene.js';

const STEPS = 1000, // of a slider
  MOST_BYTES = 5e5; // of a table

const valueAt = ([from, to], step) => (from > 0 ? from * (to / from) ** (step / STEPS) : to * (step / STEPS) ** 2);
const stepAt = ([from, to], value) =>
  Math.round(STEPS * (from > 0 ? Math.log(value / from) / Math.log(to / from) : Math.sqrt(Math.max(0, value) / to)));

// The text of a value in the unit of the form, and back. Numbers keep their digits.
const shownOf = (field, text) =>
  field.si && text !== '' && Number.isFinite(Number(text)) ? String(Number((Number(text) / field.si).toPrecision(15))) : text;
const storedOf = (field, text) =>
  field.si && text !== '' && Number.isFinite(Number(text)) ? String(Number((Number(text) * field.si).toPrecision(15))) : text;

// Shows a scene in `form`. change(name, text) is called when the reader changes a field.
export function makeForm(form, change) {
  const rows = new Map();
  const boxes = {
    usual: form.querySelector('.fields'),
    more: form.querySelector('details .fields'),
    control: document.querySelector('.fields.control'),
  };

  function makeRow(field, scene) {
    const row = document.createElement('div'),
      label = document.createElement('label'),
      id = `field-${field.name}`;
    row.className = 'field';
    label.htmlFor = id;
    const input = document.createElement(field.choices ? 'select' : field.isTable ? 'textarea' : 'input');
    input.id = id;
    row.append(label, input);
    const name = (shown) => (label.textContent = labelOf(field, shown));
    name(scene);
    if (field.choices) {
      for (const choice of field.choices) input.append(new Option(choice, choice));
      input.onchange = () => change(field.name, input.value);
      return {row, show: (text) => (input.value = text), input, name};
    }
    if (field.isTable) return {...makeTable(field, row, input), name};
    Object.assign(input, {
      type: 'text',
      inputMode: field.name === 'waves' ? 'text' : 'decimal',
      autocomplete: 'off',
      spellcheck: false,
      maxLength: 200,
      placeholder: shownOf(field, placeholderOf(field)),
    });
    let slider = null;
    if (field.range) {
      slider = document.createElement('input');
      Object.assign(slider, {type: 'range', min: 0, max: STEPS});
      const ends = field.range.map((end) => shownOf(field, String(end)));
      slider.setAttribute('aria-label', `${labelOf(field, scene)}, slider from ${ends[0]} to ${ends[1]}`);
      input.title = `The slider goes from ${ends[0]} to ${ends[1]}; the field takes other values, too.`;
      slider.oninput = () => {
        const text = String(Number(valueAt(field.range, Number(slider.value)).toPrecision(3)));
        input.value = shownOf(field, text);
        change(field.name, text);
      };
      row.append(...ends.map((text) => Object.assign(document.createElement('small'), {textContent: text})));
      row.insertBefore(slider, row.lastChild);
    }
    const show = (text) => {
      if (storedOf(field, input.value.trim()) !== text) input.value = shownOf(field, text);
      if (!slider) return;
      slider.value = stepAt(field.range, Number(text));
      slider.setAttribute('aria-valuetext', shownOf(field, text));
    };
    input.oninput = () => {
      const text = storedOf(field, input.value.trim());
      change(field.name, text);
    };
    return {row, show, input, name};
  }

  // The row of a table: its text, which can be typed, or be that of a file that is chosen or dropped on it.
  function makeTable(field, row, input) {
    Object.assign(input, {rows: 6, spellcheck: false});
    const file = Object.assign(document.createElement('input'), {type: 'file', accept: '.csv,.txt,text/*'});
    file.setAttribute('aria-label', 'File with the table');
    row.classList.add('table');
    row.append(file);
    const take = async (given) => {
      if (!given) return;
      input.value = given.size > MOST_BYTES ? `${given.name} has ${given.size} bytes: expected at most ${MOST_BYTES}` : await given.text();
      change(field.name, input.value);
    };
    input.oninput = () => change(field.name, input.value);
    input.ondragover = (event) => event.preventDefault();
    input.ondrop = (event) => {
      if (!event.dataTransfer.files.length) return;
      event.preventDefault();
      take(event.dataTransfer.files[0]);
    };
    file.onchange = () => take(file.files[0]);
    return {row, input, show: (text) => input.value !== text && (input.value = text)};
  }

  // Makes the row of a field, in the order of the fields; no other row is moved, which could have the focus.
  function insertRow(field, scene) {
    const made = makeRow(field, scene),
      box = boxes[field.part ?? 'usual'],
      index = FIELDS.indexOf(field);
    made.row.dataset.index = index;
    box.insertBefore(made.row, [...box.children].find((row) => Number(row.dataset.index) > index) ?? null);
    rows.set(field.name, made);
  }

  return {
    show(scene) {
      const fields = fieldsOf(scene);
      const shown = new Set(fields.map((field) => field.name));
      for (const [name, {row}] of rows) if (!shown.has(name)) row.hidden = true;
      for (const field of fields) {
        if (!rows.has(field.name)) insertRow(field, scene);
        const {row, show, name} = rows.get(field.name);
        row.hidden = false;
        name(scene);
        show(valueOf(scene, field.name));
      }
    },
    // Marks the field that a message names. Returned: what the reader could have meant, or an empty text.
    mark(message) {
      const first = message.split(/[ :]/, 1)[0].replaceAll('_', '-'),
        named = first === TABLE_NAME ? 'table' : first;
      let hint = '';
      for (const [name, {input}] of rows)
        if (message && (name === named || name.replace(SI_ENDING, '') === named)) {
          input.setAttribute('aria-invalid', 'true');
          if (/^\s*[-+]?\d*,\d+\s*$/.test(input.value)) hint = ' (decimal point, not comma)';
        } else input.removeAttribute('aria-invalid');
      return hint;
    },
  };
}
