"""`--export bgeo`: read by a reader of its own, and by Partio's Python where that is, and compared with `ply`."""
import struct
import sys
import unittest

import numpy as np

from runs import Runs, pair_beside_pool, read_ply

try:
    import partio
except ImportError:
    partio = None
    print("Partio's Python is not here: what it reads is not tested", file=sys.stderr)

SCENE = pair_beside_pool()
KINDS = {0: ">f4", 1: ">i4", 5: ">f4"}  # float, integer, vector


def read_bgeo(path):
    """Points of Houdini's classic geometry, version 5: a structured array with P, its weight, and attributes."""
    data = path.read_bytes()
    magic, letter, version, points, *others = struct.unpack_from(">4sc9i", data)
    assert (magic, letter, version) == (b"Bgeo", b"V", 5)
    primitives, point_groups, primitive_groups, attributes, of_vertices, of_primitives, of_all = others
    assert primitives == point_groups == primitive_groups == of_vertices == of_primitives == of_all == 0
    at, columns = 41, [("P", ">f4", 3), ("weight", ">f4")]
    for _ in range(attributes):
        length, = struct.unpack_from(">H", data, at)
        name = data[at + 2:at + 2 + length].decode()
        size, kind = struct.unpack_from(">Hi", data, at + 2 + length)
        at += 8 + length
        assert not any(data[at:at + 4 * size]), "defaults"
        at += 4 * size
        columns.append((name, KINDS[kind], size) if size > 1 else (name, KINDS[kind]))
    read = np.frombuffer(data, np.dtype(columns), points, at)
    assert data[at + read.nbytes:] == b"\x00\xff", "the end"
    return read


class Bgeo(Runs):
    def setUp(self):
        super().setUp()
        self.render(SCENE, "--export", "bgeo=bgeo", "--export", "ply=ply")

    def test_has_what_ply_has_bit_by_bit(self):
        for frame in range(1, 6):
            points = read_bgeo(self.folder / f"bgeo/frame_{frame:04}.bgeo")
            ply = read_ply(self.folder / f"ply/frame_{frame:04}.ply")["vertex"]
            self.assertEqual(len(points), len(ply))
            for name, columns in (("P", "x y z"), ("v", "vx vy vz")):
                np.testing.assert_array_equal(points[name], np.stack([ply[c] for c in columns.split()], 1))
            for name in ("id", "body", "material"):
                np.testing.assert_array_equal(points[name], ply[name])
            np.testing.assert_array_equal(points["weight"], 1)

    def test_has_radii_and_densities(self):
        points = read_bgeo(self.folder / "bgeo/frame_0005.bgeo")
        solid = points["body"] >= 0
        np.testing.assert_allclose(points["pscale"][solid], 0.05)
        self.assertTrue((points["pscale"][~solid] < 0.05).all())
        np.testing.assert_array_equal(points["density"][solid], 1000)

    @unittest.skipUnless(partio, "Partio's Python is not here")
    def test_is_what_partio_reads(self):
        theirs = partio.read(str(self.folder / "bgeo/frame_0005.bgeo"))
        own = read_bgeo(self.folder / "bgeo/frame_0005.bgeo")
        self.assertEqual(theirs.numParticles(), len(own))
        for name, field in (("position", "P"), ("v", "v"), ("id", "id"), ("pscale", "pscale")):
            attribute = theirs.attributeInfo(name)
            values = [theirs.get(attribute, i) for i in range(len(own))]
            np.testing.assert_array_equal(np.squeeze(values), own[field])

    def test_of_stored_states_lacks_densities(self):
        self.render(SCENE, "--record", "states=run.states")
        result = self.knuckle("render", "--from", "run.states", "-o", "drawn", "--export", "bgeo=stored")
        self.assertEqual(result.returncode, 0, result.stderr)
        stored, own = (read_bgeo(self.folder / f"{name}/frame_0005.bgeo") for name in ("stored", "bgeo"))
        self.assertNotIn("density", stored.dtype.names)
        np.testing.assert_array_equal(stored["P"], own["P"])


if __name__ == "__main__":
    unittest.main()
