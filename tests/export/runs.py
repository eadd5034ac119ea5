"""What tests of exported files share: the program, run in a folder of its own, and readers of what it writes."""
import base64
import json
import os
import pathlib
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as xml

import numpy as np

PROGRAM = os.environ["KNUCKLE"]


class Runs(unittest.TestCase):
    """A test in a temporary folder."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def knuckle(self, *words):
        return subprocess.run([PROGRAM, "--device", "software", *words], cwd=self.folder, capture_output=True, text=True)

    def render(self, scene, *words):
        """A run of a scene, a dictionary, that must end well."""
        (self.folder / "scene.json").write_text(json.dumps(scene))
        result = self.knuckle("-q", "render", "scene.json", *words)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def refused(self, scene, *words):
        """The one line that a run is refused with."""
        (self.folder / "scene.json").write_text(json.dumps(scene))
        result = self.knuckle("-q", "render", "scene.json", *words)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        return result.stderr.removeprefix("knuckle: ").strip()


def pair_beside_pool(pair="pair"):
    """A scene of a tenth of a second: a pair of jointed cubes of this name falls beside a small pool; diameters are
    0.1 m."""
    return {
        "duration": 0.1, "fps": 50,
        "colliders": [{"type": "plane"}],
        "objects": [{"type": "joined", "name": pair, "position": [1, 0.6, 0]},
                    {"type": "fluid", "shape": "box", "name": "pool", "position": [-1, 0.3, 0],
                     "size": [0.6, 0.4, 0.6]}],
        "render": {"width": 64, "height": 36},
    }


PLY_TYPES = {"uint": "<u4", "int": "<i4", "float": "<f4", "uchar": "u1"}


def read_ply(path):
    """Elements of a binary PLY file: structured arrays; lists, all of three numbers, as rows."""
    data = pathlib.Path(path).read_bytes()
    head, end = data.split(b"end_header\n", 1)[0].decode(), data.index(b"end_header\n") + 11
    elements = {}
    for line in head.splitlines():
        words = line.split()
        if words[0] == "element":
            columns, elements[words[1]] = [], [int(words[2]), []]
            columns = elements[words[1]][1]
        elif words[0] == "property" and words[1] == "list":
            columns += [("count", PLY_TYPES[words[2]]), (words[4], PLY_TYPES[words[3]], 3)]
        elif words[0] == "property":
            columns.append((words[2], PLY_TYPES[words[1]]))
    read = {}
    for name, (count, columns) in elements.items():
        kind = np.dtype(columns)
        read[name] = np.frombuffer(data, kind, count, end)
        end += count * kind.itemsize
    assert end == len(data), "as many bytes as the head says"
    return read


VTK_TYPES = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt32": "<u4"}


def read_vtp(path):
    """Arrays of VTK PolyData by name, without VTK: numbers, and lists of strings."""
    root = xml.parse(path).getroot()
    assert root.attrib["header_type"] == "UInt64" and root.attrib["byte_order"] == "LittleEndian"
    arrays = {}
    for array in root.iter("DataArray"):
        kind = np.dtype(VTK_TYPES[array.attrib["type"]])
        if array.attrib["format"] == "ascii":
            values = np.array(array.text.split(), kind)
        else:
            data = base64.b64decode(array.text)
            values = np.frombuffer(data, kind, offset=8)
            assert int.from_bytes(data[:8], "little") == values.nbytes
        width = int(array.attrib.get("NumberOfComponents", "1"))
        arrays[array.attrib["Name"]] = values.reshape(-1, width) if width > 1 else values
    for array in root.iter("Array"):
        text = bytes(int(word) for word in array.text.split()).decode()
        arrays[array.attrib["Name"]] = text.split("\0")[:-1]
    arrays["count"] = int(root.find("PolyData/Piece").attrib["NumberOfPoints"])
    return arrays
