// Where pictures are shown: one pane, or two side by side, with one zoom.

const stage = byId("stage");
const LARGEST_ZOOM = 64;
/** `s` pixels of the screen for one of the picture, whose corner is at x, y of a pane. */
const view = { s: 1, x: 0, y: 0, fit: 1, width: 1, height: 1, fitted: true };
let dividerAt = 0.5;

function makePane() {
  const halves = [0, 1].map(() => make("div", { className: "half", hidden: true }, make("img", { alt: "", draggable: false })));
  const boxes = make("div");
  const badges = ["badge", "badge right"].map(className => make("span", { className, hidden: true }));
  const element = make("div", { className: "pane" }, ...halves, boxes, ...badges);
  stage.append(element);
  return { element, halves, boxes, badges };
}
const panes = [makePane(), makePane()];
const divider = make("div", { id: "divider", tabIndex: 0 });
for (const [name, value] of Object.entries({ role: "slider", "aria-label": "divider between reference and output",
  "aria-valuemin": 0, "aria-valuemax": 100 })) divider.setAttribute(name, value);
panes[0].element.append(divider);

/** Shows a picture in a half of a pane, or nothing. */
function setHalf(pane, half, picture, label) {
  const element = pane.halves[half];
  element.hidden = !picture;
  pane.badges[half].hidden = !picture;
  pane.badges[half].textContent = label;
  element.style.clipPath = "";
  if (!picture) return;
  const shown = element.firstChild;
  if (shown.src !== picture.src) shown.src = picture.src;
}

function setDivider(place) {
  dividerAt = Math.min(1, Math.max(0, place));
  const percent = dividerAt * 100;
  divider.style.left = percent + "%";
  divider.setAttribute("aria-valuenow", Math.round(percent));
  if (divider.hidden) return;
  panes[0].halves[0].style.clipPath = `inset(0 ${100 - percent}% 0 0)`;
  panes[0].halves[1].style.clipPath = `inset(0 0 0 ${percent}%)`;
}

function setBoxes(boxes) {
  for (const pane of panes)
    pane.boxes.replaceChildren(...boxes.map(([x, y, width, height]) => {
      const box = make("div", { className: "box" });
      for (const [name, value] of Object.entries({ "--bx": x, "--by": y, "--bw": width, "--bh": height }))
        box.style.setProperty(name, value);
      return box;
    }));
}

function applyView() {
  for (const name of ["x", "y", "s"]) stage.style.setProperty("--" + name, view[name]);
  stage.classList.toggle("pixels", view.s * devicePixelRatio >= 1);
  stage.classList.toggle("zoomed", view.s > view.fit * 1.001);
  const percent = view.s * 100;
  byId("zoom").textContent = (percent < 10 ? percent.toFixed(1) : Math.round(percent)) + " %";
}

/** Keeps the picture in its pane: in the middle where it is smaller, without a gap where it is larger. */
function keepInPane() {
  const pane = panes[0].element;
  for (const [axis, room, size] of [["x", pane.clientWidth, view.width], ["y", pane.clientHeight, view.height]]) {
    const rest = room - size * view.s;
    view[axis] = rest >= 0 ? rest / 2 : Math.min(0, Math.max(rest, view[axis]));
  }
  applyView();
}

/** Shows the whole picture; a small one with whole pixels. */
function fitView() {
  const pane = panes[0].element;
  const room = Math.min(pane.clientWidth / view.width, pane.clientHeight / view.height);
  view.fit = room > 1 ? Math.min(LARGEST_ZOOM, Math.floor(room)) : Math.max(room, 0.001);
  view.s = view.fit;
  view.fitted = true;
  keepInPane();
}

/** Zooms by a factor around a point of a pane, by default its middle. */
function zoomBy(factor, x = panes[0].element.clientWidth / 2, y = panes[0].element.clientHeight / 2) {
  const s = Math.min(LARGEST_ZOOM, Math.max(Math.min(view.fit, 1) / 2, view.s * factor));
  view.x = x - (x - view.x) * s / view.s;
  view.y = y - (y - view.y) * s / view.s;
  view.s = s;
  view.fitted = Math.abs(s - view.fit) < 1e-6;
  keepInPane();
}

/** Zooms so that a rectangle fills a third of the pane. */
function zoomTo([x, y, width, height]) {
  const pane = panes[0].element;
  const s = Math.min(pane.clientWidth / width, pane.clientHeight / height) / 3;
  view.s = Math.min(LARGEST_ZOOM, Math.max(view.fit, s));
  view.fitted = view.s === view.fit;
  view.x = pane.clientWidth / 2 - (x + width / 2) * view.s;
  view.y = pane.clientHeight / 2 - (y + height / 2) * view.s;
  keepInPane();
}

/** Of the pane below a point of the screen: the point in it, and the pixel there. */
function pointIn(event) {
  const pane = panes.find(p => !p.element.hidden && p.element.contains(event.target)) ?? panes[0];
  const area = pane.element.getBoundingClientRect();
  const x = event.clientX - area.left - pane.element.clientLeft, y = event.clientY - area.top - pane.element.clientTop;
  return { x, y, pixelX: Math.floor((x - view.x) / view.s), pixelY: Math.floor((y - view.y) / view.s) };
}

// One finger moves the divider or the picture, two zoom.
const pointers = new Map();
let movesDivider = false, dividerBefore = 0.5;

stage.addEventListener("pointerdown", event => {
  if (event.button !== 0) return;
  const point = pointIn(event);
  pointers.set(event.pointerId, point);
  movesDivider = pointers.size === 1 && !divider.hidden &&
    (event.target === divider || !stage.classList.contains("zoomed"));
  if (pointers.size === 1) dividerBefore = dividerAt;
  else setDivider(dividerBefore);   // The first finger of two has moved it.
  if (movesDivider) setDivider(point.x / panes[0].element.clientWidth);
  event.target.setPointerCapture(event.pointerId);
});
stage.addEventListener("pointermove", event => {
  const last = pointers.get(event.pointerId);
  if (!last) return;
  const point = pointIn(event), other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
  if (other) {
    const before = Math.hypot(last.x - other.x, last.y - other.y), now = Math.hypot(point.x - other.x, point.y - other.y);
    view.x += (point.x - last.x) / 2;
    view.y += (point.y - last.y) / 2;
    zoomBy(now / Math.max(1, before), (point.x + other.x) / 2, (point.y + other.y) / 2);
  } else if (movesDivider) {
    setDivider(point.x / panes[0].element.clientWidth);
  } else {
    view.x += point.x - last.x;
    view.y += point.y - last.y;
    keepInPane();
  }
  pointers.set(event.pointerId, point);
});
for (const name of ["pointerup", "pointercancel"])
  stage.addEventListener(name, event => pointers.delete(event.pointerId));
stage.addEventListener("dblclick", event => {
  const point = pointIn(event);
  if (view.fitted) zoomBy(4, point.x, point.y);
  else fitView();
});
stage.addEventListener("wheel", event => {
  if (event.ctrlKey || event.deltaY !== 0) event.preventDefault();
  const point = pointIn(event), lines = event.deltaMode === 1 ? 30 : 1;
  zoomBy(Math.exp(-Math.max(-300, Math.min(300, event.deltaY * lines)) / 400), point.x, point.y);
}, { passive: false });
divider.addEventListener("keydown", event => {
  const step = { ArrowLeft: -0.02, ArrowRight: 0.02, Home: -1, End: 1 }[event.key];
  if (step === undefined) return;
  event.preventDefault();
  event.stopPropagation();
  setDivider(dividerAt + step);
});
new ResizeObserver(() => view.fitted ? fitView() : keepInPane()).observe(panes[0].element);
