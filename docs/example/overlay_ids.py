"""Draws what `--export layers=FOLDER` says of a frame over its picture of colours: objects tinted, their boxes, and the
joints of figures, filled where they are seen. Needs NumPy.

    knuckle render assets/scenes/dance.json --frames 60:60 --export layers=out/data
    python3 docs/example/overlay_ids.py out/data 60 out/overlay.png
"""
import json
import pathlib
import struct
import sys
import zlib

import numpy as np

PIXEL_TYPES = {0: "<u4", 1: "<f2", 2: "<f4"}
ZIP = 3


def exr_header(data):
    """Channels [(name, NumPy type)], width, height, and where the header ends."""
    assert data[:8] == b"\x76\x2f\x31\x01\x02\0\0\0", "an OpenEXR file of lines, of one part"
    at, attributes = 8, {}
    while data[at]:
        name, kind, rest = data[at:].split(b"\0", 2)
        at += len(name) + len(kind) + 2
        size = struct.unpack_from("<i", data, at)[0]
        attributes[name.decode()] = data[at + 4:at + 4 + size]
        at += 4 + size
    assert attributes["compression"][0] == ZIP
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    channels, text = [], attributes["channels"]
    while text[0]:
        name, text = text.split(b"\0", 1)
        channels.append((name.decode(), PIXEL_TYPES[struct.unpack_from("<i", text)[0]]))
        text = text[16:]
    return channels, right + 1 - left, bottom + 1 - top, at + 1


def unpacked(packed, size):
    """The bytes of a block: they are stored as differences, those of even places first."""
    if len(packed) == size:
        return packed
    parts = np.frombuffer(zlib.decompress(packed), np.uint8).copy()
    parts[1:] -= 128
    parts = np.cumsum(parts, dtype=np.uint8)
    out = np.empty(size, np.uint8)
    out[::2], out[1::2] = parts[:(size + 1) // 2], parts[(size + 1) // 2:]
    return out.tobytes()


def read_exr(path):
    """Channels by name, arrays of [height, width], top row first; of files packed by ZIP, as Knuckle writes them."""
    data = pathlib.Path(path).read_bytes()
    channels, width, height, at = exr_header(data)
    line = sum(width * np.dtype(kind).itemsize for _, kind in channels)
    out = {name: np.empty((height, width), kind) for name, kind in channels}
    at += 8 * -(-height // 16)
    for first in range(0, height, 16):
        count = min(16, height - first)
        size = struct.unpack_from("<i", data, at + 4)[0]
        block, place = unpacked(data[at + 8:at + 8 + size], count * line), 0
        at += 8 + size
        for row in range(first, first + count):
            for name, kind in channels:
                out[name][row] = np.frombuffer(block, kind, width, place)
                place += out[name][row].nbytes
    return out


def write_png(path, pixels):
    """`pixels`: uint8 [height, width, 3]."""
    height, width, _ = pixels.shape
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)), (b"IDAT", zlib.compress(rows)),
              (b"IEND", b"")]
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for name, body in chunks:
            file.write(struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body)))


def tint(number):
    """A colour of each number's own."""
    return np.array([number * 67 % 256, number * 151 % 256, number * 211 % 256], np.float32)


def disc(pixels, column, row, radius, color):
    height, width, _ = pixels.shape
    y, x = np.ogrid[:height, :width]
    pixels[np.hypot(x + 0.5 - column, y + 0.5 - row) < radius] = color


def line(pixels, start, end, color):
    height, width, _ = pixels.shape
    for part in np.linspace(0, 1, 1 + int(2 * np.hypot(*np.subtract(end, start)))):
        column, row = (1 - part) * np.array(start) + part * np.array(end)
        if 0 <= column < width and 0 <= row < height:
            pixels[int(row), int(column)] = color


def overlay(folder, frame):
    """The picture: uint8 [height, width, 3]."""
    folder = pathlib.Path(folder)
    notes = json.loads((folder / "annotations.json").read_text())
    image = next(i for i in notes["images"] if i["frame"] == frame)
    layers = read_exr(folder / image["file_name"])
    albedo = np.stack([layers["albedo." + c] for c in "RGB"], 2)
    facing = 0.35 + 0.65 * np.clip(layers["normal.Y"], 0, 1)[..., None]
    pixels = 255 * np.sqrt(np.clip(albedo * facing, 0, 1))
    objects = layers["id.object"]
    for number in np.unique(objects[objects > 0]):
        pixels[objects == number] = 0.4 * pixels[objects == number] + 0.6 * tint(int(number))
    pixels = pixels.astype(np.uint8)
    radius = max(2.0, image["height"] / 180)
    skeletons = {c["id"]: c.get("skeleton", []) for c in notes["categories"]}
    for note in (a for a in notes["annotations"] if a["image_id"] == image["id"]):
        x, y, w, h = note["bbox"]
        for start, end in (((x, y), (x + w, y)), ((x, y + h), (x + w, y + h)), ((x, y), (x, y + h)),
                           ((x + w, y), (x + w, y + h))):
            line(pixels, start, end, (255, 255, 255))
        points = np.reshape(note.get("keypoints", []), (-1, 3))
        for a, b in skeletons[note["category_id"]]:
            if points[a - 1, 2] and points[b - 1, 2]:
                line(pixels, points[a - 1, :2], points[b - 1, :2], (255, 230, 80))
        for column, row, seen in points:
            if seen:
                disc(pixels, column, row, radius, (20, 20, 20))
                disc(pixels, column, row, 0.7 * radius, (80, 255, 80) if seen == 2 else (255, 60, 60))
    return pixels


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("usage: overlay_ids.py FOLDER FRAME PICTURE.png")
    write_png(sys.argv[3], overlay(sys.argv[1], int(sys.argv[2])))
