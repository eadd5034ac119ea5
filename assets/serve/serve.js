const $ = id => document.getElementById(id);
const query = location.search;   // has the token, if there is one
const picture = $("picture"), message = $("message");
let now = { paused: false, speed: 1 };

let fading = 0;
function tell(text) {
  message.textContent = text;
  clearTimeout(fading);
  fading = setTimeout(() => { message.textContent = ""; }, 6000);
}

// Answers with the JSON that came back, or null.
async function send(wish) {
  try {
    const answer = await fetch("input" + query, { method: "POST", body: JSON.stringify(wish) });
    if (answer.ok) return await answer.json();
    if (answer.status !== 429) tell((await answer.text()).trim());
  } catch {
    tell("the program does not answer");
  }
  return null;
}

// One wish of a kind is on its way at a time; what comes meanwhile is added up.
const waiting = new Map();
function sendSum(kind, add) {
  const held = waiting.get(kind);
  if (held) { held.next = held.next ? add(held.next) : add(null); return; }
  const entry = { next: null };
  waiting.set(kind, entry);
  send(add(null)).then(() => {
    waiting.delete(kind);
    if (entry.next) sendSum(kind, () => entry.next);
  });
}
const move = (kind, x, y) => sendSum(kind, sum => ({ do: kind, by: sum ? [sum.by[0] + x, sum.by[1] + y] : [x, y] }));
const zoom = factor => sendSum("zoom", sum => ({ do: "zoom", factor: Math.min(10, Math.max(0.1, (sum ? sum.factor : 1) * factor)) }));

// The part of the element that the picture fills.
function shown() {
  const box = picture.getBoundingClientRect();
  const scale = Math.min(box.width / (picture.naturalWidth || 16), box.height / (picture.naturalHeight || 9));
  const width = scale * (picture.naturalWidth || 16), height = scale * (picture.naturalHeight || 9);
  return { left: box.left + (box.width - width) / 2, top: box.top + (box.height - height) / 2, width, height };
}

// Where an event is, in shares of the picture.
function placeOf(event) {
  const box = shown(), share = (value, size) => Math.min(1, Math.max(0, value / size));
  return [share(event.clientX - box.left, box.width), share(event.clientY - box.top, box.height)];
}

let chosen = "";
function choose(found) {
  if (!found) return;
  chosen = found.name;
  $("chosen").hidden = !chosen;
  $("chosen-name").textContent = chosen;
  tell(chosen ? "" : "nothing that has a name");
}
// Where the mouse was last.
let pointed = [0.5, 0.5];
const throwBall = () => now.hasBall ? send({ do: "ball", at: pointed, speed: 8 }) : tell("there is no ball here: knuckle serve --ball 0.15");
const letGo = () => chosen && send({ do: "release", name: chosen });

// A drag turns or moves the camera, with Ctrl it pulls what is under the mouse; without moving it is a click.
let drag = null, held = null, pulling = false;
function togglePull() {
  pulling = !pulling;
  $("pull").setAttribute("aria-pressed", String(pulling));
}
$("pull").onclick = togglePull;
picture.addEventListener("pointerdown", event => {
  if (event.button > 1) return;
  picture.setPointerCapture(event.pointerId);
  picture.classList.add("dragging");
  drag = { x: event.clientX, y: event.clientY, moved: 0, pulls: pulling || event.ctrlKey || event.metaKey };
  if (drag.pulls) {
    held = placeOf(event);
    send({ do: "grab", at: held }).then(found => {
      choose(found);
      if (found && found.name && !found.canBePulled) tell(found.name + " cannot be pulled");
    });
  }
});
picture.addEventListener("pointermove", event => {
  pointed = placeOf(event);
  if (!drag) return;
  const height = shown().height, x = (event.clientX - drag.x) / height, y = (drag.y - event.clientY) / height;
  drag.x = event.clientX;
  drag.y = event.clientY;
  drag.moved += Math.hypot(x, y);
  if (drag.pulls) {
    held = placeOf(event);
    sendSum("drag", () => ({ do: "drag", at: held }));
  } else if (event.shiftKey || event.buttons === 4) move("pan", x, y);
  else move("orbit", 3 * x, 3 * y);
});
for (const end of ["pointerup", "pointercancel"])
  picture.addEventListener(end, event => {
    if (!drag) return;
    if (drag.pulls) send({ do: "drop" });
    else if (end === "pointerup" && drag.moved < 0.01) send({ do: "pick", at: placeOf(event) }).then(choose);
    drag = held = null;
    picture.classList.remove("dragging");
  });
// Who holds still holds on.
setInterval(() => { if (held) sendSum("drag", () => ({ do: "drag", at: held })); }, 1000);
picture.addEventListener("dblclick", event => send({ do: "throw", at: placeOf(event), speed: 5 }).then(choose));
picture.addEventListener("contextmenu", event => event.preventDefault());
picture.addEventListener("wheel", event => {
  event.preventDefault();
  zoom(Math.exp(Math.min(1, Math.max(-1, event.deltaY / 500))));
}, { passive: false });

function setSpeed(speed) {
  now.speed = Math.round(10 * Math.min(1, Math.max(0.1, speed))) / 10;
  showSpeed();
  send({ do: "speed", factor: now.speed });
}
function showSpeed() {
  $("speed").value = now.speed;
  $("speed-text").textContent = now.speed.toFixed(1);
}

// Settings that may change while it runs: a slider for each of their numbers.
const FARTHEST = { gravity: 25, wind: 20, linearDamping: 10 };
const TITLES = { linearDamping: "damping", maxSpeed: "top speed" };
const sliders = new Map();
function rowOf(field, k) {
  const row = document.createElement("label"), name = document.createElement("span");
  const slider = document.createElement("input"), text = document.createElement("output");
  row.className = "field";
  name.textContent = (TITLES[field.name] || field.name) + (field.value.length > 1 ? " " + "xyz"[k] : "");
  const most = FARTHEST[field.name] || Infinity;
  Object.assign(slider, { type: "range", min: Math.max(field.least, -most), max: Math.min(field.most, most), step: 0.01 });
  slider.dataset.field = field.name + (field.value.length > 1 ? " " + "xyz"[k] : "");
  slider.oninput = () => {
    const held = sliders.get(field.name);
    held.value[k] = Number(slider.value);
    held.rows[k].show(held.value[k]);
    held.touched = Date.now();
    sendSum("set " + field.name, () => ({ do: "set", field: field.name, value: held.value.length > 1 ? held.value : held.value[0] }));
  };
  row.append(name, slider, text);
  $("fields").append(row);
  return { slider, show(value) {
    slider.value = value;
    text.textContent = Number(value.toFixed(2)) + " " + field.unit;
  } };
}
let listed = "";
function showFields(fields) {
  const names = fields.map(field => field.name).join();
  if (names !== listed) {
    listed = names;
    sliders.clear();
    $("fields").replaceChildren();
    for (const field of fields) sliders.set(field.name, { value: [], rows: field.value.map((_, k) => rowOf(field, k)), touched: 0 });
  }
  for (const field of fields) {
    const held = sliders.get(field.name);
    if (Date.now() - held.touched < 500) continue;
    held.value = [...field.value];
    held.value.forEach((value, k) => held.rows[k].show(value));
  }
}
function toggleSettings() {
  $("settings").hidden = !$("settings").hidden;
  $("settings-button").setAttribute("aria-expanded", String(!$("settings").hidden));
}
$("settings-button").onclick = toggleSettings;
$("share").oninput = () => {
  $("share-text").textContent = Math.round(100 * $("share").value) + " %";
  sendSum("share", () => ({ do: "share", part: Number($("share").value) }));
};
$("restart").onsubmit = event => {
  event.preventDefault();
  tell("it begins anew …");
  send({ do: "restart", set: [$("set").value] }).then(answer => answer && tell(""));
};

const toggle = () => send({ do: now.paused ? "run" : "pause" });

$("run").onclick = toggle;
$("one").onclick = () => send({ do: "step" });
$("reset").onclick = () => send({ do: "reset" });
$("release").onclick = letGo;
$("ball").onclick = throwBall;
$("home").onclick = () => send({ do: "home" });
$("speed").oninput = () => setSpeed(Number($("speed").value));
$("help-button").onclick = () => $("help").showModal();

const keys = {
  " ": toggle, s: () => send({ do: "step" }), r: () => send({ do: "reset" }), h: () => send({ do: "home" }),
  l: letGo, b: throwBall,
  "[": () => setSpeed(now.speed - 0.1), "]": () => setSpeed(now.speed + 0.1), "?": () => $("help").showModal(), g: toggleSettings, p: togglePull,
  "+": () => zoom(0.9), "-": () => zoom(1 / 0.9),
  ArrowLeft: () => move("orbit", -0.1, 0), ArrowRight: () => move("orbit", 0.1, 0),
  ArrowUp: () => move("orbit", 0, 0.1), ArrowDown: () => move("orbit", 0, -0.1),
};
document.addEventListener("keydown", event => {
  const key = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  const isControl = event.target.closest("input, dialog") || (event.key === " " && event.target.closest("button"));
  if (!key || isControl || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  key();
});

// Three digits: "2.04 k".
function withPrefix(value) {
  const kilos = value >= 999.5e6 ? 3 : value >= 999.5e3 ? 2 : value >= 999.5 ? 1 : 0;
  const digits = value / 1000 ** kilos;
  return digits.toFixed(digits < 9.995 ? 2 : digits < 99.95 ? 1 : 0) + " " + ["", "k", "M", "G"][kilos];
}

function show(figures) {
  now = figures;
  if (figures.message) tell(figures.message);
  $("step").textContent = figures.step;
  $("time").textContent = figures.time.toFixed(2) + " s";
  $("step-time").textContent = figures.stepMilliseconds.toFixed(1) + " ms";
  $("draw-time").textContent = figures.drawMilliseconds.toFixed(0) + " ms";
  $("rate").textContent = figures.picturesPerSecond.toFixed(figures.picturesPerSecond < 10 ? 1 : 0) + " /s";
  $("max-speed").textContent = figures.maxSpeed.toFixed(2) + " m/s";
  $("energy").textContent = withPrefix(figures.energy) + "J";
  for (const name of ["contacts", "particles", "viewers"]) $(name).textContent = figures[name];
  $("ball").hidden = !figures.hasBall;
  $("run").textContent = figures.paused ? "run" : "pause";
  if (document.activeElement !== $("speed")) showSpeed();
  showFields(figures.fields);
  if (document.activeElement === $("share")) return;
  $("share").value = figures.share;
  $("share-text").textContent = Math.round(100 * figures.share) + " %";
}

const events = new EventSource("events" + query);
events.onopen = () => tell("");
events.onmessage = event => { show(JSON.parse(event.data)); };
events.onerror = () => tell("no connection to the program");

// A picture that breaks off is asked for again.
const watch = () => { picture.src = "stream" + (query ? query + "&" : "?") + "again=" + Date.now(); };
picture.onerror = () => setTimeout(watch, 1000);
watch();
