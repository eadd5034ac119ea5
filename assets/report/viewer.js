// Which image is shown, by which mode, and what the keys do.

const state = { image: null, filter: "all", mode: "slider", boxes: true, place: -1, blinks: true, other: false };
let blinkTimer = 0;

const shownImages = () => images.filter(FILTERS[state.filter]);

/** The mode that was chosen, or the first that the image has pictures for. */
function modeOf(image) {
  return hasMode(image, state.mode) ? state.mode : Object.keys(MODES).find(mode => hasMode(image, mode));
}

/** What the panes show in a mode. */
function showPictures(image, mode) {
  const { reference, output, heatmap, difference } = image.pictures;
  const single = !reference || !output;
  divider.hidden = mode !== "slider";
  panes[1].element.hidden = mode !== "two" || single;
  stage.classList.toggle("two", !panes[1].element.hidden);
  setHalf(panes[1], 0, output, "output");
  const of = {
    slider: [reference, output],
    blink: state.other ? [null, output] : [reference, null],
    two: single ? [reference, output] : [reference, null],
    heatmap: [heatmap, null],
    difference: [difference, null],
  }[mode];
  setHalf(panes[0], 0, of[0], { heatmap: "FLIP", difference: "difference × " + GAIN }[mode] ?? "reference");
  setHalf(panes[0], 1, of[1], "output");
  setDivider(dividerAt);
  byId("legend").hidden = mode !== "heatmap" && mode !== "difference";
  byId("legend").lastElementChild.hidden = mode !== "heatmap";
  byId("legend-text").textContent = mode === "heatmap"
    ? "FLIP: how much a person sees the pixel differ, 0 nothing, 1 as much as can be"
    : `Difference of each channel, ${GAIN} times as bright as it is`;
}

function setSize(image) {
  const pictures = Object.values(image.pictures);
  const apply = () => {
    if (state.image !== image) return;
    view.width = Math.max(1, ...pictures.map(picture => picture.naturalWidth));
    view.height = Math.max(1, ...pictures.map(picture => picture.naturalHeight));
    fitView();
  };
  // Pictures of the hidden table are only loaded when they are wanted.
  for (const picture of pictures) picture.loading = "eager";
  Promise.allSettled(pictures.map(picture => picture.decode())).then(apply);
}

function update() {
  const { image } = state, mode = modeOf(image), hasPictures = Object.keys(image.pictures).length > 0;
  stage.hidden = byId("values").hidden = byId("tools").hidden = !hasPictures;
  byId("modes").hidden = Object.keys(image.pictures).length < 2;
  byId("empty").hidden = hasPictures;
  byId("empty").textContent = image.empty;
  showPictures(image, mode);
  for (const button of byId("modes").children) {
    button.disabled = !hasPictures || !hasMode(image, button.value);
    button.setAttribute("aria-pressed", button.value === mode);
  }
  stage.dataset.mode = mode;
  byId("boxes").setAttribute("aria-pressed", state.boxes);
  byId("boxes").disabled = byId("next-place").disabled = image.boxes.length === 0 || !hasPictures;
  setBoxes(state.boxes ? image.boxes : []);
  for (const pane of panes) pane.boxes.children[state.place]?.classList.add("current");
  byId("blink-tools").hidden = mode !== "blink";
  byId("blink-run").setAttribute("aria-pressed", state.blinks);
  clearInterval(blinkTimer);
  if (mode === "blink" && state.blinks) blinkTimer = setInterval(showOther, 700);
  try {
    history.replaceState(null, "", `#image-${image.index + 1}.${state.mode}`);
  } catch {
    // Some browsers allow a hundred in half a minute, and none in a page within another one.
  }
}

function showOther() {
  state.other = !state.other;
  showPictures(state.image, modeOf(state.image));
}

function showImage(image) {
  if (!image) return;
  const { row } = image;
  Object.assign(state, { image, place: -1, other: false });
  byId("name").textContent = image.name;
  byId("line").textContent = image.line;
  byId("values").textContent = "Point at a pixel to read both pictures there.";
  const details = [...row.querySelectorAll("th .notes, .all > *")].map(part => part.cloneNode(true));
  byId("details").replaceChildren(...details);
  byId("details").querySelectorAll("[data-box]").forEach((item, place) => {
    const button = make("button", { type: "button", textContent: item.textContent });
    button.addEventListener("click", () => showPlace(place));
    item.replaceChildren(button);
  });
  updatePosition();
  update();
  setSize(image);
}

function updatePosition() {
  const shown = shownImages(), place = shown.indexOf(state.image);
  byId("position").textContent = `${place < 0 ? "–" : place + 1} / ${shown.length}`;
  for (const button of byId("list").querySelectorAll("button")) {
    const current = Number(button.value) === state.image.index;
    button.setAttribute("aria-current", current);
    if (current) scrollInList(button);
  }
}

/** Scrolls the list alone, not the page. */
function scrollInList(button) {
  const list = byId("list"), top = button.offsetTop - list.offsetTop;
  if (top < list.scrollTop) list.scrollTop = top;
  else if (top + button.offsetHeight > list.scrollTop + list.clientHeight)
    list.scrollTop = top + button.offsetHeight - list.clientHeight;
}

function step(by) {
  const shown = shownImages(), place = shown.indexOf(state.image);
  if (shown.length > 0) showImage(shown[place < 0 ? 0 : Math.min(shown.length - 1, Math.max(0, place + by))]);
}

function showPlace(place) {
  if (state.image.boxes.length === 0 || stage.hidden) return;
  state.place = place % state.image.boxes.length;
  state.boxes = true;
  update();
  zoomTo(state.image.boxes[state.place]);
}

function setFilter(filter) {
  state.filter = filter;
  for (const button of byId("filters").children) button.setAttribute("aria-pressed", button.value === filter);
  const shown = shownImages();
  byId("none-shown").hidden = shown.length > 0;
  byId("list").replaceChildren(...shown.map(image => {
    const button = make("button", { type: "button", value: image.index }, make("bdi", { textContent: image.name }),
      make("small", { className: "status", textContent: image.status }));
    button.dataset.status = image.status;
    button.addEventListener("click", () => {
      showImage(image);
      // On a phone the list is below.
      if (byId("view").getBoundingClientRect().top < 0) byId("view").scrollIntoView();
    });
    return make("li", {}, button);
  }));
  if (shown.length > 0 && !shown.includes(state.image)) showImage(shown[0]);
  else updatePosition();
}

function setMode(mode) {
  if (!hasMode(state.image, mode)) return;
  state.mode = mode;
  state.other = false;
  update();
  if (view.fitted) fitView();
}

function setBlinks(blinks) {
  state.blinks = blinks;
  update();
}

function chooser(parent, values, labelOf, choose) {
  byId(parent).append(...values.map(value => {
    const button = make("button", { type: "button", value, textContent: labelOf(value) });
    button.addEventListener("click", () => choose(value));
    return button;
  }));
}

function readValues(event) {
  const { pixelX, pixelY } = pointIn(event), { reference, output } = state.image.pictures;
  const values = { reference: pixelAt(reference, pixelX, pixelY), output: pixelAt(output, pixelX, pixelY) };
  if (!values.reference && !values.output) return;
  const parts = [`${pixelX},${pixelY}`];
  for (const [name, value] of Object.entries(values)) {
    if (!value) continue;
    const swatch = make("span", { className: "swatch" });
    swatch.style.background = `rgb(${value.slice(0, 3).join(" ")} / ${value[3] / 255})`;
    parts.push(`\n${name.padEnd(10)} `, swatch, (value[3] < 255 ? value : value.slice(0, 3)).join(" "));
  }
  if (values.reference && values.output)
    parts.push("\ndifference   " + values.output.map((v, i) => v - values.reference[i])
      .slice(0, values.reference[3] < 255 || values.output[3] < 255 ? 4 : 3)
      .map(v => (v > 0 ? "+" : "") + v).join(" ").replaceAll("-", "−"));
  byId("values").replaceChildren(...parts);
}

const actions = {
  previous: () => step(-1),
  next: () => step(1),
  "zoom-in": () => zoomBy(1.5),
  "zoom-out": () => zoomBy(1 / 1.5),
  "zoom-fit": fitView,
  boxes: () => { state.boxes = !state.boxes; update(); },
  "next-place": () => showPlace(state.place + 1),
  "blink-run": () => setBlinks(!state.blinks),
  "blink-other": () => { setBlinks(false); showOther(); },
  "help-button": () => byId("help").showModal(),
};
const KEYS = { j: "next", ArrowDown: "next", ArrowRight: "next", k: "previous", ArrowUp: "previous", ArrowLeft: "previous",
  "+": "zoom-in", "=": "zoom-in", "-": "zoom-out", 0: "zoom-fit", p: "boxes", n: "next-place", b: "blink-run",
  " ": "blink-other", "?": "help-button" };

function nextFilter() {
  const names = Object.keys(FILTERS);
  setFilter(names[(names.indexOf(state.filter) + 1) % names.length]);
}

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || byId("help").open) return;
  const mode = Object.keys(MODES)[Number(event.key) - 1];
  if (event.key === " " && (event.target.closest("button") || modeOf(state.image) !== "blink")) return;
  if (event.key === "f") nextFilter();
  else if (mode && /^[1-9]$/.test(event.key)) setMode(mode);
  else if (KEYS[event.key]) actions[KEYS[event.key]]();
  else return;
  event.preventDefault();
}

/** "#image-3.blink" */
function readHash() {
  const [, number, mode] = /^#image-(\d+)(?:\.(\w+))?$/.exec(location.hash) ?? [];
  if (mode in MODES) state.mode = mode;
  return images[Number(number) - 1];
}

function start() {
  if (images.length === 0) return;
  byId("images").hidden = true;
  byId("viewer").hidden = false;
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) state.blinks = false;
  chooser("filters", Object.keys(FILTERS), name => `${name} ${images.filter(FILTERS[name]).length}`, setFilter);
  chooser("modes", Object.keys(MODES), mode => MODES[mode].label, setMode);
  for (const [id, act] of Object.entries(actions)) byId(id).addEventListener("click", act);
  state.image = readHash() ?? images[0];
  setFilter("all");
  showImage(state.image);
  document.addEventListener("keydown", onKey);
  for (const name of ["pointermove", "pointerdown"]) stage.addEventListener(name, readValues);
  addEventListener("hashchange", () => { const image = readHash(); if (image) showImage(image); });
}
start();
