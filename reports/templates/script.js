"use strict";
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
for (const table of document.querySelectorAll("table.sortable")) {
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
// Filtering of the checks by words and by verdict.
function applyFilter(name) {
  const words = document.querySelector(`[data-filter="${name}"]`).value.toLowerCase().split(/\s+/);
  const only = document.querySelector(`[data-only="${name}"]`).checked;
  for (const table of document.querySelectorAll(`[data-table="${name}"]`)) {
    let found = 0;
    for (const body of table.tBodies) {
      const head = body.rows[0].textContent.toLowerCase();
      let shown = 0;
      for (const row of [...body.rows].slice(1)) {
        const text = head + " " + row.textContent.toLowerCase() + " " + row.title.toLowerCase();
        row.hidden = (only && ["identical", "within"].includes(row.dataset.verdict)) || !words.every((word) => text.includes(word));
        shown += row.hidden ? 0 : 1;
      }
      body.hidden = shown === 0;
      found += shown;
    }
    const list = table.closest("details");
    list.hidden = found === 0;
    list.open = found > 0 && (only || words.some((word) => word !== ""));
  }
}
for (const input of document.querySelectorAll("[data-filter], [data-only]")) {
  input.addEventListener("input", () => applyFilter(input.dataset.filter || input.dataset.only));
}
// A link to something in a folded list unfolds the list.
function reveal() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  for (let list = target.closest("details"); list; list = list.parentElement.closest("details")) list.open = true;
  target.scrollIntoView();
}
addEventListener("hashchange", reveal);
reveal();
// A figure enlarges to the window, where it can be zoomed and moved.
const zoom = document.getElementById("zoom");
const stage = zoom.querySelector(".stage");
let view = { x: 0, y: 0, scale: 1 };
const pointers = new Map();
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
  const open = () => {
    stage.replaceChildren(picture.querySelector("svg").cloneNode(true));
    fit();
    zoom.showModal();
  };
  picture.addEventListener("click", open);
  picture.addEventListener("keydown", (event) => {
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
for (const kind of ["pointerup", "pointercancel"]) {
  stage.addEventListener(kind, (event) => pointers.delete(event.pointerId));
}
zoom.querySelector(".close").addEventListener("click", () => zoom.close());
zoom.addEventListener("close", () => pointers.clear());
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
