"""`--export vtk`: read without VTK, and by VTK where Python has it, and compared with `ply` and `bodies` of the run."""
import csv
import sys
import unittest
import xml.etree.ElementTree as xml

import numpy as np

from runs import Runs, pair_beside_pool, read_ply, read_vtp

try:
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError:
    vtk = None
    print("VTK's Python (python3-vtk9) is not here: what it reads is not tested", file=sys.stderr)

SCENE = pair_beside_pool("pär")
EXPORTS = ["--export", "vtk=vtk", "--export", "ply=ply", "--export", "bodies=bodies.csv"]


class Vtk(Runs):
    def setUp(self):
        super().setUp()
        self.render(SCENE, *EXPORTS)

    def test_has_what_ply_has_bit_by_bit(self):
        for frame in range(1, 6):
            points, ply = read_vtp(self.folder / f"vtk/frame_{frame:04}.vtp"), \
                read_ply(self.folder / f"ply/frame_{frame:04}.ply")["vertex"]
            self.assertEqual(points["count"], len(ply))
            for name, columns in (("Points", "x y z"), ("velocity", "vx vy vz")):
                np.testing.assert_array_equal(points[name], np.stack([ply[c] for c in columns.split()], 1))
            for name in ("id", "body", "material"):
                np.testing.assert_array_equal(points[name], ply[name])
            np.testing.assert_array_equal(points["connectivity"], np.arange(len(ply)))
            np.testing.assert_array_equal(points["offsets"], np.arange(1, len(ply) + 1))

    def test_names_bodies_and_materials(self):
        points = read_vtp(self.folder / "vtk/frame_0003.vtp")
        with open(self.folder / "bodies.csv", newline="") as table:
            rows = [row for row in csv.DictReader(table) if row["frame"] == "3"]
        self.assertEqual(points["bodyNames"], [f"{row['object']}/{row['name']}" for row in rows])
        self.assertEqual(points["materialNames"], ["default", "water"])
        self.assertEqual(set(points["body"]), {-1, 0, 1})

    def test_has_radii_and_densities(self):
        first, last = (read_vtp(self.folder / f"vtk/frame_000{frame}.vtp") for frame in (1, 5))
        fluid = first["body"] < 0
        self.assertTrue(fluid.any())
        np.testing.assert_allclose(first["radius"][~fluid], 0.05)
        self.assertEqual(len(set(first["radius"][fluid])), 1)
        self.assertLess(first["radius"][fluid][0], 0.05)
        np.testing.assert_array_equal(first["density"], 1000)
        # Water falls: what is within is as dense as at rest, what is at the surface has fewer neighbours.
        self.assertGreater(np.percentile(last["density"][fluid], 95), 900)
        self.assertLess(last["density"][fluid].max(), 1100)
        self.assertGreater(len(set(last["density"][fluid])), 10)
        np.testing.assert_array_equal(last["density"][~fluid], 1000)

    def test_is_a_series_with_times(self):
        sets = list(xml.parse(self.folder / "vtk/frames.pvd").getroot().iter("DataSet"))
        self.assertEqual([s.attrib["file"] for s in sets], [f"frame_{n:04}.vtp" for n in range(1, 6)])
        np.testing.assert_allclose([float(s.attrib["timestep"]) for s in sets], [0, 0.02, 0.04, 0.06, 0.08])
        np.testing.assert_allclose(read_vtp(self.folder / "vtk/frame_0003.vtp")["TimeValue"], [0.04])

    @unittest.skipUnless(vtk, "VTK's Python is not here")
    def test_is_what_vtk_reads(self):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "vtk/frame_0005.vtp"))
        reader.Update()
        data, own = reader.GetOutput(), read_vtp(self.folder / "vtk/frame_0005.vtp")
        self.assertEqual(data.GetNumberOfPoints(), own["count"])
        self.assertEqual(data.GetNumberOfVerts(), own["count"])
        np.testing.assert_array_equal(vtk_to_numpy(data.GetPoints().GetData()), own["Points"])
        for name in ("id", "body", "material", "velocity", "radius", "density"):
            np.testing.assert_array_equal(vtk_to_numpy(data.GetPointData().GetArray(name)), own[name])
        names = data.GetFieldData().GetAbstractArray("bodyNames")
        self.assertEqual([names.GetValue(k) for k in range(names.GetNumberOfValues())], own["bodyNames"])

    def test_of_stored_states_lacks_densities_and_says_so(self):
        self.render(SCENE, "--record", "states=run.states", "--export", "vtk=again")
        result = self.knuckle("render", "--from", "run.states", "-o", "drawn", "--export", "vtk=stored")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("leave out densities, which run.states does not hold", result.stderr)
        stored, own = (read_vtp(self.folder / f"{name}/frame_0005.vtp") for name in ("stored", "vtk"))
        self.assertNotIn("density", stored)
        np.testing.assert_array_equal(stored["Points"], own["Points"])

    def test_refuses_a_folder_that_cannot_be_written(self):
        (self.folder / "file").write_text("")
        self.assertIn("file", self.refused(SCENE, "--export", "vtk=file"))
        self.assertIn("frames are written into a folder", self.refused(SCENE, "--export", "vtk=a.vtp"))


if __name__ == "__main__":
    unittest.main()
