// What the table has, and small helpers.

const byId = id => document.getElementById(id);

function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

const KINDS = ["reference", "output", "difference", "heatmap"];

/** A row of the table as an image: its pictures are <img> elements of the row, or missing. */
function imageOf(row, index) {
  const pictures = {};
  for (const kind of KINDS) {
    const picture = row.querySelector("img." + kind);
    if (picture) pictures[kind] = picture;
  }
  return {
    index, row, pictures,
    name: row.querySelector(".name").textContent,
    line: row.querySelector(".line").textContent,
    status: row.dataset.status,
    failed: row.dataset.failed === "1",
    boxes: [...row.querySelectorAll("[data-box]")].map(item => item.dataset.box.split(" ").map(Number)),
    empty: row.querySelector(".none")?.textContent ?? "",
  };
}

const images = [...document.querySelectorAll("#images tbody tr")].map(imageOf);

const FILTERS = {
  all: () => true,
  failed: image => image.failed,
  different: image => image.status === "different" || image.status === "unreadable",
  missing: image => image.status === "missing",
  new: image => image.status === "new",
  equal: image => image.status === "equal",
};

/** What an image can be looked at by; `pictures` are needed. */
const MODES = {
  slider: { label: "slider", pictures: ["reference", "output"] },
  blink: { label: "blink", pictures: ["reference", "output"] },
  two: { label: "two-up", pictures: [] },
  heatmap: { label: "FLIP", pictures: ["heatmap"] },
  difference: { label: "difference", pictures: ["difference"] },
};

const hasMode = (image, mode) => MODES[mode].pictures.every(kind => image.pictures[kind]);

const readContext = make("canvas", { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true });

/** A pixel of an <img> as four numbers, 0 to 255; nothing outside of it. */
function pixelAt(picture, x, y) {
  if (!picture || x < 0 || y < 0 || x >= picture.naturalWidth || y >= picture.naturalHeight) return null;
  readContext.clearRect(0, 0, 1, 1);
  readContext.drawImage(picture, x, y, 1, 1, 0, 0, 1, 1);
  return [...readContext.getImageData(0, 0, 1, 1).data];
}
