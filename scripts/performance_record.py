#!/usr/bin/env python3
"""Keeps and draws figures of speed; scripts/performance.sh calls it.

performance_record.py append FIGURES.json HISTORY.jsonl   adds a run to the history, a line of JSON each
performance_record.py plot SCALE.json FOLDER [--check]    draws `knuckle bench scale --json` as FOLDER/*.svg;
                                                          --check: fails if a picture there is another
"""
import json
import math
import os
import subprocess
import sys
from xml.sax.saxutils import escape

COLORS = {"pairs": "#c2571a", "dam": "#2166ac", "sand": "#8a7a1f"}
NAMES = {"pairs": "jointed pairs", "dam": "breaking dam", "sand": "breaking sand"}
KEPT = ("preset", "world", "objectCount", "particleCount", "stepsPerSecond", "settledStepsPerSecond",
        "drawnStepsPerSecond", "milliseconds", "microsecondsPerParticle", "bytesPerParticle", "problem")
BARS = 10  # passes that have a bar of their own


class Drawing:
    """An SVG of a width and height in pixels."""

    def __init__(self, width, height):
        self.size = (width, height)
        self.parts = []

    def text(self, x, y, words, anchor="start", size=12, color="#222", bold=False):
        weight = ' font-weight="bold"' if bold else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" '
                          f'fill="{color}"{weight}>{escape(words)}</text>')

    def line(self, points, color, width=1.0):
        places = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.parts.append(f'<polyline points="{places}" fill="none" stroke="{color}" stroke-width="{width}"/>')

    def dot(self, x, y, color):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{color}"/>')

    def bar(self, x, y, width, height, color):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{color}"/>')

    def svg(self):
        width, height = self.size
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                f'viewBox="0 0 {width} {height}" font-family="DejaVu Sans, Verdana, sans-serif">')
        paper = f'<rect width="{width}" height="{height}" fill="white"/>'
        return "\n".join([head, paper, *self.parts, "</svg>"]) + "\n"


def even_lines(most):
    """Round values from zero, three to eight of them."""
    power = 10.0 ** math.floor(math.log10(most))
    step = next(s * power for s in (0.2, 0.5, 1.0, 2.0) if most / (s * power) <= 7)
    return [k * step for k in range(int(most / step) + 1)]


def doubled_lines(least, most):
    """1, 2, 5, 10, ... from one that is not above `least` to one that is not below `most`."""
    lines = [d * 10.0 ** power for power in range(-6, 7) for d in (1, 2, 5)]
    first = max(k for k, line in enumerate(lines) if line <= least)
    last = next(k for k, line in enumerate(lines) if line >= most)
    return lines[first:max(last, first + 1) + 1]


def panel(drawing, left, top, width, height, title, series, as_ratios=False):
    """Curves over the number of particles: from zero up, or with equal ratios equally far apart."""
    counts = sorted({count for points in series.values() for count, _ in points})
    values = [value for points in series.values() for _, value in points]
    low, high = math.log(counts[0]), math.log(max(counts[-1], counts[0] + 1))
    across = lambda count: left + width * (math.log(count) - low) / (high - low)
    lines = doubled_lines(min(values), max(values)) if as_ratios else even_lines(1.1 * max(values))
    most = lines[-1] if as_ratios else 1.1 * max(values)
    share = lambda value: math.log(value / lines[0]) / math.log(most / lines[0]) if as_ratios else value / most
    up = lambda value: top + height * (1.0 - share(value))
    drawing.text(left, top - 12, title, bold=True)
    for value in lines:
        drawing.line([(left, up(value)), (left + width, up(value))], "#ddd")
        drawing.text(left - 6, up(value) + 4, f"{value:g}", "end", 11)
    last = -math.inf
    for count in counts:
        if across(count) - last < 44:
            continue
        last = across(count)
        drawing.text(last, top + height + 18, f"{count / 1000:.0f}k", "middle", 11)
    drawing.text(left + width / 2, top + height + 36, "particles", "middle")
    for world, points in series.items():
        drawing.line([(across(count), up(value)) for count, value in points], COLORS[world], 2)
        for count, value in points:
            drawing.dot(across(count), up(value), COLORS[world])


def scaling(runs):
    series = {}
    for run in runs:
        series.setdefault(run["world"], []).append(run)
    drawing = Drawing(820, 330)
    curves = lambda key: {world: [(r["particleCount"], r[key]) for r in part] for world, part in series.items()}
    panel(drawing, 60, 50, 310, 210, "time: µs a particle and step", curves("microsecondsPerParticle"),
          as_ratios=True)
    panel(drawing, 470, 50, 310, 210, "memory: bytes a particle", curves("bytesPerParticle"))
    for k, world in enumerate(series):
        drawing.dot(230 + 140 * k, 318, COLORS[world])
        drawing.text(240 + 140 * k, 322, NAMES[world])
    return drawing.svg()


def shares(run):
    """Bars of the passes that take most of a step, and one of all others."""
    passes = sorted(run["passes"], key=lambda p: -p["milliseconds"])
    whole = sum(p["milliseconds"] for p in passes)
    rows = [(p["name"], p["milliseconds"] / whole) for p in passes[:BARS]]
    if len(passes) > BARS:
        rows.append((f"{len(passes) - BARS} others", sum(p["milliseconds"] for p in passes[BARS:]) / whole))
    drawing = Drawing(640, 60 + 24 * len(rows))
    drawing.text(16, 26, f'{NAMES[run["world"]]}, {run["particleCount"]} particles: share of a step', bold=True)
    longest = max(share for _, share in rows)
    for k, (name, share) in enumerate(rows):
        y = 44 + 24 * k
        drawing.text(250, y + 13, name, "end")
        drawing.bar(258, y, 310 * share / longest, 17, COLORS[run["world"]] if k < BARS else "#999")
        drawing.text(264 + 310 * share / longest, y + 13, f"{100 * share:.1f} %", size=11)
    return drawing.svg()


def plot(figures, folder, check):
    with open(figures, encoding="utf-8") as file:
        runs = [run for run in json.load(file)["runs"] if run["problem"] is None]
    pictures = {"scaling.svg": scaling(runs)}
    for world in NAMES:
        of_world = [run for run in runs if run["world"] == world]
        if of_world:
            # The one nearest to 64,000, where lists no longer fit any cache.
            run = min(of_world, key=lambda r: abs(r["particleCount"] - 64000))
            pictures[f"passes_{world}.svg"] = shares(run)
    failed = False
    for name, text in pictures.items():
        path = os.path.join(folder, name)
        if check:
            same = os.path.exists(path) and open(path, encoding="utf-8").read() == text
            if not same:
                print(f"{path} does not show {figures}; run scripts/performance.sh", file=sys.stderr)
                failed = True
            continue
        with open(path + ".part", "w", encoding="utf-8") as file:
            file.write(text)
        os.rename(path + ".part", path)
    return 1 if failed else 0


def append(figures, history):
    with open(figures, encoding="utf-8") as file:
        run = json.load(file)
    with open("VERSION", encoding="utf-8") as file:
        version = file.read().strip()
    commit = subprocess.run(["git", "rev-parse", "--short=10", "HEAD"], capture_output=True, text=True, check=False)
    entry = {key: run.get(key) for key in ("measured", "note", "benchmark", "device", "driverThreads")}
    entry["version"], entry["commit"] = version, commit.stdout.strip()
    entry["runs"] = [{key: r[key] for key in KEPT if r.get(key) is not None} for r in run["runs"]]
    with open(history, "a", encoding="utf-8") as file:
        file.write(json.dumps(entry) + "\n")
    return 0


def main(words):
    if len(words) == 3 and words[0] == "append":
        return append(words[1], words[2])
    if len(words) in (3, 4) and words[0] == "plot" and words[3:] in ([], ["--check"]):
        return plot(words[1], words[2], len(words) == 4)
    print(__doc__.strip(), file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
