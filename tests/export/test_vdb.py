"""`--export vdb`: refused in one line where the program has no OpenVDB, else read back by vdb_check and compared."""
import os
import pathlib
import subprocess
import sys
import unittest

import numpy as np

from runs import PROGRAM, Runs, read_ply
from test_surface import POOL, volume_of

CHECK = pathlib.Path(os.environ.get("VDB_CHECK", pathlib.Path(PROGRAM).parent / "vdb_check"))
if not CHECK.exists():
    print("built without OpenVDB (libopenvdb-dev, libboost-dev): its files are not tested", file=sys.stderr)


class Vdb(Runs):
    @unittest.skipIf(CHECK.exists(), "OpenVDB is here")
    def test_says_what_is_missing(self):
        self.assertEqual(self.refused(POOL, "--export", "vdb=vdb"),
                         "--export vdb=vdb: this program was built without OpenVDB; install libopenvdb-dev and "
                         "libboost-dev, and build it again, which finds them")
        self.assertFalse((self.folder / "vdb").exists())

    @unittest.skipUnless(CHECK.exists(), "OpenVDB is not here")
    def test_has_the_points_and_the_surface(self):
        scene = POOL | {"objects": POOL["objects"] + [{"type": "rigid", "shape": "box", "size": [0.2, 0.2, 0.2],
                                                       "position": [0, 1, 0], "velocity": [0, 0, 1]}]}
        for name in ("one", "two"):
            self.render(scene, "--frames", "3:3", "--export", f"vdb={name}", "--export", "ply=ply",
                        "--export", "surface=mesh")
        file = self.folder / "one/frame_0003.vdb"
        self.assertEqual(file.read_bytes(), (self.folder / "two/frame_0003.vdb").read_bytes())
        lines = subprocess.run([CHECK, file], capture_output=True, text=True, check=True).stdout.splitlines()
        points = np.array(sorted([float(w) for w in line.split()[1:]] for line in lines if line.startswith("point ")))
        ply = read_ply(self.folder / "ply/frame_0003.ply")["vertex"]
        self.assertIn(f"points {len(ply)}", lines)
        np.testing.assert_array_equal(points[:, 0], ply["id"])
        # Places are kept as parts of a voxel, in 32 bits.
        np.testing.assert_allclose(points[:, 1:4], np.stack([ply[c] for c in "xyz"], 1), atol=1e-6)
        np.testing.assert_allclose(points[:, 4:], np.stack([ply[c] for c in ("vx", "vy", "vz")], 1), rtol=1e-6)
        fluid = next(line.split() for line in lines if line.startswith("fluid"))
        self.assertEqual(fluid[1], "1")
        volume = volume_of(read_ply(self.folder / "mesh/frame_0003.ply"))
        self.assertAlmostEqual(float(fluid[2]) / volume, 1, delta=0.02)


if __name__ == "__main__":
    unittest.main()
