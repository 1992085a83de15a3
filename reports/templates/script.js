"use strict";
// Drawings and long lists are compressed until they are scrolled to, opened, searched, or linked to.
const opened = new WeakMap();
async function inflate(part) {
  if (part.dataset.packed === undefined) return;
  const bytes = Uint8Array.from(atob(part.dataset.packed), (letter) => letter.charCodeAt(0));
  part.removeAttribute("data-packed");
  part.innerHTML = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).text();
  part.querySelectorAll("table.sortable").forEach(makeSortable);
}
function unpack(part) {
  if (!opened.has(part)) opened.set(part, inflate(part));
  return opened.get(part);
}
const unpackAll = (parts) => Promise.all([...parts].map(unpack));
const seen = new IntersectionObserver((entries) => {
  for (const entry of entries) if (entry.isIntersecting) unpack(entry.target);
}, { rootMargin: "1200px" });
document.querySelectorAll(".picture").forEach((picture) => seen.observe(picture));
document.addEventListener("toggle", (event) => {
  if (event.target.open) unpackAll(event.target.querySelectorAll(".packed"));
}, true);
addEventListener("beforeprint", () => unpackAll(document.querySelectorAll(".picture")));
// Sorting: a click on a column head sorts the rows within each table body, or the bodies of a table of class by-body.
function cellKey(row, column) {
  const cell = row.cells[column];
  if (!cell) return "";
  const text = cell.dataset.sort !== undefined ? cell.dataset.sort : cell.textContent.trim();
  const number = Number(text.replace("\u2212", "-"));
  return text !== "" && !Number.isNaN(number) ? number : text;
}
function compareKeys(a, b) {
  if (typeof a === "number" && typeof b === "number") return a - b;
  if (a === "" || b === "") return a === "" ? (b === "" ? 0 : 1) : -1;
  return String(a).localeCompare(String(b), undefined, { numeric: true });
}
function sortTable(table, column, down) {
  const sign = down ? -1 : 1;
  const order = (a, b) => sign * compareKeys(cellKey(a, column), cellKey(b, column));
  if (table.classList.contains("by-body")) {
    [...table.tBodies].sort((a, b) => order(a.rows[0], b.rows[0])).forEach((body) => table.append(body));
    return;
  }
  for (const body of table.tBodies) {
    [...body.rows].filter((row) => !row.classList.contains("group")).sort(order).forEach((row) => body.append(row));
  }
}
function makeSortable(table) {
  const heads = [...table.tHead.rows[table.tHead.rows.length - 1].cells];
  heads.forEach((head, column) => {
    head.tabIndex = 0;
    head.setAttribute("role", "columnheader");
    const act = () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      sortTable(table, column, down);
    };
    head.addEventListener("click", act);
    head.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") { event.preventDefault(); act(); }
    });
  });
}
document.querySelectorAll("table.sortable").forEach(makeSortable);
// Filtering of the checks by words and by verdict.
async function applyFilter(name) {
  const section = document.getElementById(name);
  await unpackAll(section.querySelectorAll(".packed"));
  const words = section.querySelector("[data-filter]").value.toLowerCase().split(/\s+/).filter(Boolean);
  const only = section.querySelector("[data-only]").checked;
  const active = only || words.length > 0;
  let total = 0;
  for (const list of section.querySelectorAll("details.list")) {
    const title = list.querySelector("summary").textContent.toLowerCase();
    let found = 0;
    for (const body of list.querySelectorAll("tbody")) {
      const head = title + " " + body.rows[0].textContent.toLowerCase();
      let shown = 0;
      for (const row of [...body.rows].slice(1)) {
        const text = head + " " + row.textContent.toLowerCase() + " " + row.title.toLowerCase();
        row.hidden = (only && "passes" in row.dataset) || !words.every((word) => text.includes(word));
        shown += row.hidden ? 0 : 1;
      }
      body.hidden = shown === 0;
      found += shown;
    }
    list.hidden = active && found === 0;
    list.open = active && found > 0;
    total += found;
  }
  section.querySelector("[data-none]").hidden = !active || total > 0;
}
for (const input of document.querySelectorAll("[data-filter], [data-only]")) {
  input.addEventListener("input", () => applyFilter(input.dataset.filter || input.dataset.only));
}
// A link to something in a folded list unfolds the list.
async function reveal() {
  const name = decodeURIComponent(location.hash.slice(1));
  if (!name) return;
  for (const part of document.querySelectorAll("details .packed")) {
    if (document.getElementById(name)) break;
    await unpack(part);
  }
  const target = document.getElementById(name);
  if (!target) return;
  for (let list = target.closest("details"); list; list = list.parentElement.closest("details")) list.open = true;
  await unpackAll(target.querySelectorAll(".packed"));
  target.scrollIntoView();
}
addEventListener("hashchange", reveal);
reveal();
// The link that covers a map leads to the scene under the pointer; both axes are logarithmic.
addEventListener("pointermove", (event) => {
  const link = event.target.closest?.("a[data-tabor]");
  if (!link) return;
  const box = link.querySelector("rect").getBoundingClientRect();
  const nearest = (texts, part) => {
    const values = texts.split(" ");
    const wanted = Math.log(values[0]) + part * Math.log(values[values.length - 1] / values[0]);
    return values.reduce((a, b) => (Math.abs(Math.log(b) - wanted) < Math.abs(Math.log(a) - wanted) ? b : a));
  };
  const tabor = nearest(link.dataset.tabor, (event.clientX - box.left) / box.width);
  const amplitude = nearest(link.dataset.amplitude, (box.bottom - event.clientY) / box.height);
  link.setAttribute("href", link.getAttribute("href").replace(/tabor=[^&]*/, `tabor=${tabor}`).replace(/amplitude=[^&]*/, `amplitude=${amplitude}`));
  link.querySelector("title").textContent = `Solve in the browser: tabor=${tabor} amplitude=${amplitude}`;
});
// A figure enlarges to the window, where it can be zoomed and moved.
const zoom = document.getElementById("zoom");
const stage = zoom.querySelector(".stage");
let view = { x: 0, y: 0, scale: 1 };
const pointers = new Map(), downs = new Map();  // the last events of the pointers that are down, and the first ones
function place() {
  stage.firstChild.style.transform = `translate(${view.x}px, ${view.y}px) scale(${view.scale})`;
}
function fit() { view = { x: 0, y: 0, scale: 1 }; place(); }
function scaleAt(factor, x, y) {
  const box = stage.getBoundingClientRect();
  const scale = Math.min(Math.max(view.scale * factor, 1), 24);
  const real = scale / view.scale;
  const px = x - box.left - box.width / 2, py = y - box.top - box.height / 2;
  view = { x: px - real * (px - view.x), y: py - real * (py - view.y), scale };
  if (scale === 1) { view.x = 0; view.y = 0; }
  place();
}
for (const picture of document.querySelectorAll("figure .picture")) {
  const open = async () => {
    await unpack(picture);
    const sheet = document.createElement("div");
    sheet.append(...[...picture.querySelectorAll("svg")].map((drawing) => drawing.cloneNode(true)));
    stage.replaceChildren(sheet);
    fit();
    zoom.showModal();
  };
  picture.addEventListener("click", (event) => event.target.closest("a") || open());
  picture.addEventListener("keydown", (event) => {
    if (event.target.closest("a")) return;
    if (event.key === "Enter" || event.key === " ") { event.preventDefault(); open(); }
  });
}
stage.addEventListener("wheel", (event) => {
  event.preventDefault();
  scaleAt(Math.exp(-event.deltaY / 400), event.clientX, event.clientY);
}, { passive: false });
stage.addEventListener("dblclick", fit);
stage.addEventListener("pointerdown", (event) => {
  stage.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, event);
  downs.set(event.pointerId, event);
});
stage.addEventListener("pointermove", (event) => {
  const before = pointers.get(event.pointerId);
  if (!before) return;
  if (pointers.size === 2) {
    const other = [...pointers.values()].find((item) => item.pointerId !== event.pointerId);
    const far = (a) => Math.hypot(a.clientX - other.clientX, a.clientY - other.clientY);
    scaleAt(far(event) / Math.max(far(before), 1), other.clientX, other.clientY);
  } else {
    view.x += event.clientX - before.clientX;
    view.y += event.clientY - before.clientY;
    place();
  }
  pointers.set(event.pointerId, event);
});
stage.addEventListener("pointerup", (event) => {  // a click, although the stage has captured the pointer
  const pressed = downs.get(event.pointerId);
  const link = document.elementsFromPoint(event.clientX, event.clientY).find((part) => part.closest("a.scene"));
  if (link && pressed && Math.hypot(event.clientX - pressed.clientX, event.clientY - pressed.clientY) < 4) location = link.closest("a").href.baseVal;
});
for (const kind of ["pointerup", "pointercancel"]) {
  stage.addEventListener(kind, (event) => pointers.delete(event.pointerId));
}
zoom.querySelector(".close").addEventListener("click", () => zoom.close());
zoom.addEventListener("close", () => pointers.clear());
// On a narrow screen the table of contents is folded.
if (!matchMedia("(min-width: 1240px)").matches) document.querySelector("nav.contents details").open = false;
// The table of contents marks the section that is being read.
const links = new Map([...document.querySelectorAll("nav.contents a")].map((a) => [a.hash.slice(1), a]));
const parts = [...links.keys()].map((id) => document.getElementById(id)).filter(Boolean);
function mark() {
  const reached = parts.filter((part) => part.getBoundingClientRect().top < 140);
  const current = reached.length ? reached[reached.length - 1].id : "summary";
  for (const [id, link] of links) link.classList.toggle("here", id === current);
}
document.addEventListener("scroll", mark, { passive: true });
mark();
