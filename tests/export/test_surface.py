"""`--export surface`: closed meshes that hold the volume of their particles; a drop is round, a pool flat."""
import unittest

import numpy as np

from runs import Runs, read_ply, read_vtp

POOL = {
    "duration": 0.7, "fps": 30, "diameter": 0.08,
    "colliders": [{"type": "container", "width": 1.0, "depth": 0.8, "visible": False}],
    "objects": [{"type": "fluid", "shape": "box", "size": [1.0, 0.4, 0.8], "position": [0, 0.2, 0]}],
    "render": {"width": 64, "height": 36},
}
RADIUS = 0.4
DROP = {
    "duration": 0.04, "fps": 30, "diameter": 0.08, "solver": {"gravity": [0, 0, 0]},
    "objects": [{"type": "fluid", "shape": "sphere", "radius": RADIUS, "position": [0.3, 2, -0.1]}],
    "render": {"width": 64, "height": 36},
}


def places_of(mesh):
    return np.stack([mesh["vertex"][axis] for axis in "xyz"], 1).astype(float)


def corners_of(mesh):
    """[triangles, 3, 3]"""
    assert (mesh["face"]["count"] == 3).all()
    return places_of(mesh)[mesh["face"]["vertex_indices"]]


def volume_of(mesh):
    a, b, c = np.moveaxis(corners_of(mesh), 1, 0)
    return (np.cross(a, b) * c).sum() / 6


class Surface(Runs):
    def meshes(self, scene, frame):
        """The mesh of a frame, and the volume of its particles."""
        self.render(scene, "--frames", f"{frame}:{frame}", "--export", "surface=mesh", "--export", "vtk=points")
        points = read_vtp(self.folder / f"points/frame_{frame:04}.vtp")
        self.check_closed(mesh := read_ply(self.folder / f"mesh/frame_{frame:04}.ply"))
        return mesh, points["count"] * (2 * float(points["radius"][0]))**3

    def check_closed(self, mesh):
        """Each edge is there once in each direction, and each corner is used."""
        triangles = mesh["face"]["vertex_indices"].astype(np.int64)
        edges = np.concatenate([triangles[:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))])
        there, back = (edges[:, a] << 32 | edges[:, b] for a, b in ((0, 1), (1, 0)))
        self.assertEqual(len(np.unique(there)), len(there))
        np.testing.assert_array_equal(np.sort(there), np.sort(back))
        np.testing.assert_array_equal(np.unique(triangles), np.arange(len(mesh["vertex"])))

    def test_a_still_pool_keeps_its_volume_and_is_flat(self):
        mesh, volume = self.meshes(POOL, 21)
        self.assertAlmostEqual(volume_of(mesh) / volume, 1, delta=0.03)
        places = places_of(mesh)
        middle = (np.abs(places[:, :1]) < 0.35).all(1) & (np.abs(places[:, 2]) < 0.25)
        top = places[middle & (places[:, 1] > 0.2), 1]
        self.assertGreater(len(top), 100)
        self.assertAlmostEqual(top.mean(), 0.4, delta=0.02)
        self.assertLess(top.std(), 0.003)
        self.assertAlmostEqual(places[middle & (places[:, 1] < 0.2), 1].mean(), 0, delta=0.02)

    def test_a_drop_is_round_and_keeps_its_volume(self):
        mesh, volume = self.meshes(DROP, 1)
        self.assertAlmostEqual(volume_of(mesh) / volume, 1, delta=0.03)
        arms = places_of(mesh) - DROP["objects"][0]["position"]
        radii = np.linalg.norm(arms, axis=1)
        # Of a ball of as much volume; a lattice fills one of 5 spacings across unevenly.
        expected = (volume * 3 / (4 * np.pi))**(1 / 3)
        self.assertLess(np.abs(radii / expected - 1).max(), 0.03)
        self.assertLess(radii.std() / expected, 0.015)

    def test_normals_point_outwards(self):
        mesh, _ = self.meshes(DROP, 1)
        normals = np.stack([mesh["vertex"][axis] for axis in ("nx", "ny", "nz")], 1)
        np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-5)
        arms = places_of(mesh) - DROP["objects"][0]["position"]
        self.assertGreater((normals * arms / np.linalg.norm(arms, axis=1, keepdims=True)).sum(1).min(), 0.8)
        a, b, c = np.moveaxis(corners_of(mesh), 1, 0)
        faces = np.cross(b - a, c - a)
        self.assertGreater((faces * normals[mesh["face"]["vertex_indices"]].sum(1)).sum(1).min(), -1e-9)

    def test_of_stored_states_and_of_a_second_run_the_bytes_are_the_same(self):
        files = []
        for name in ("one", "two"):
            self.render(POOL, "--frames", "10:10", "--export", f"surface={name}", "--record", f"states={name}.states")
            files.append((self.folder / name / "frame_0010.ply").read_bytes())
        result = self.knuckle("render", "--from", "one.states", "-o", "drawn", "--export", "surface=stored")
        self.assertEqual(result.returncode, 0, result.stderr)
        files.append((self.folder / "stored/frame_0010.ply").read_bytes())
        self.assertEqual(files[0], files[1])
        self.assertEqual(files[0], files[2])

    def test_a_single_particle_is_a_drop(self):
        water = {"type": "fluid", "shape": "box", "size": [0.04] * 3, "position": [0, 1, 0]}
        mesh, volume = self.meshes(DROP | {"objects": [water]}, 1)
        self.assertAlmostEqual(volume, 0.04**3, places=9)
        # Smaller than what it stands for: its kernel comes to a half only near its middle.
        self.assertGreater(volume_of(mesh), 0.1 * volume)
        self.assertLess(volume_of(mesh), volume)

    def test_a_stream_is_there_and_nothing_is_an_empty_mesh(self):
        scene = DROP | {"emitters": [{"shape": "disc", "radius": 0.05, "position": [0, 1, 0], "direction": [0, -1, 0],
                                      "speed": 3, "start": 0.2}],
                        "objects": [{"type": "rigid", "shape": "box", "size": [0.2, 0.2, 0.2]}], "duration": 0.5}
        self.render(scene, "--export", "surface=mesh", "--export", "vtk=points")
        self.assertEqual(len(read_ply(self.folder / "mesh/frame_0001.ply")["face"]), 0)
        mesh, points = read_ply(self.folder / "mesh/frame_0015.ply"), read_vtp(self.folder / "points/frame_0015.vtp")
        self.check_closed(mesh)
        drops = points["Points"][points["body"] < 0]
        self.assertGreater(len(drops), 5)
        near = np.linalg.norm(places_of(mesh)[None] - drops[:, None], axis=2).min(1)
        self.assertLess(near.max(), 0.08)

    def test_refuses_scenes_without_fluids(self):
        scene = DROP | {"objects": [{"type": "rigid", "shape": "box", "size": [0.2, 0.2, 0.2]}]}
        self.assertEqual(self.refused(scene, "--export", "surface=mesh"),
                         "--export surface=mesh: the scene has no fluids, whose surface could be written")


if __name__ == "__main__":
    unittest.main()
