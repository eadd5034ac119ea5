"""Actors as NumPy has them: from files, from arrays, in scenes. Run by ctest; KNUCKLE names the program."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import knuckle

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODEL = ROOT / "assets/models/humanoid.glb"


def door():
    """The door of docs/actor-format.md."""
    page = (ROOT / "docs/actor-format.md").read_text()
    return json.loads(page.split("```json\n")[1].split("```")[0])


def door_arrays():
    """The same as arrays that somebody writes by hand."""
    return {
        "format": "knuckle-actor", "version": 1, "name": "door", "diameter": 0.1,
        "particles": np.array(door()["particles"]),
        "bodies_name": ["post", "door"], "bodies_parent": [-1, 0],
        "bodies_particles": [0, 1, 2, 3, 4, 5, 4, 5, 6, 7, 8, 9], "bodies_particles_starts": [0, 6, 12],
        "joints_name": ["door"], "joints_type": ["hinge"], "joints_parent": [0], "joints_child": [1],
        "joints_anchor": [[0, 0.05, 0]], "joints_axis": [[0, 1, 0]], "joints_limits_bend": [[0, 110]],
        "joints_sharedParticles": [4, 5], "joints_sharedParticles_starts": [0, 2],
    }


def fallen(actor, diameter=None):
    """The hash of some steps after it was thrown on its back."""
    scene = {"colliders": [{"type": "plane"}],
             "objects": [{"type": "actor", "file": actor, "position": [0, 1.2, 0], "rotation": [180, 0, 0],
                          "velocity": [0, -6, 0]}]}
    if diameter:
        scene["diameter"] = diameter
    simulation = knuckle.Simulation(knuckle.Scene.load(scene), "software")
    simulation.step(20)
    return simulation.hash()


class Files(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = pathlib.Path(place.name)

    def check(self, name):
        """What the program says of a file."""
        result = subprocess.run([os.environ["KNUCKLE"], "check", name], cwd=self.folder, capture_output=True, text=True)
        return result.returncode, (result.stdout + result.stderr).strip()

    def test_json_and_npz_hold_the_same_actor(self):
        actor = knuckle.voxelize(MODEL, particles=300)
        actor.save(self.folder / "first.json")
        knuckle.load_actor(self.folder / "first.json").save(self.folder / "second.npz")
        knuckle.load_actor(self.folder / "second.npz").save(self.folder / "third.json")
        self.assertEqual((self.folder / "first.json").read_bytes(), (self.folder / "third.json").read_bytes())
        hashes = {fallen(given) for given in (actor, str(self.folder / "first.json"), str(self.folder / "second.npz"))}
        self.assertEqual(len(hashes), 1)
        self.assertEqual(self.check("first.json")[1].split(": ")[1], self.check("second.npz")[1].split(": ")[1])

    def test_a_file_gives_the_world_that_its_model_gives(self):
        for name, diameter in (("humanoid", 0.07), ("dog", 0.06)):
            model = ROOT / f"assets/models/{name}.glb"
            actor = knuckle.voxelize(model, diameter=diameter)
            for file in ("actor.json", "actor.npz"):
                actor.save(self.folder / file)
                self.assertEqual(fallen(str(self.folder / file), diameter), fallen(str(model), diameter), name)

    def test_bodies_that_never_touch_are_in_both(self):
        actor = knuckle.voxelize(MODEL, particles=1000)
        names = [body["name"] for body in actor.bodies]
        pair = [names.index(f"forearm.{side}") for side in "LR"]
        for pairs in (np.zeros((0, 2)), [pair]):
            given = knuckle.Actor({**actor.arrays(), "neverTouch": pairs})
            np.testing.assert_array_equal(given.arrays()["neverTouch"], pairs)
            for file in ("actor.json", "actor.npz"):
                given.save(self.folder / file)
                np.testing.assert_array_equal(knuckle.load_actor(self.folder / file).arrays()["neverTouch"], pairs)

    def test_reads_what_numpy_writes(self):
        knuckle.voxelize(MODEL, particles=300).save(self.folder / "own.npz")
        own = np.load(self.folder / "own.npz")
        swapped = {name: array.astype(array.dtype.newbyteorder()) if array.dtype.kind in "fi" else array
                   for name, array in own.items()}
        columns = {name: np.asfortranarray(array) if array.ndim > 1 else array for name, array in own.items()}
        wide = {name: array.astype("f8") if array.dtype.kind in "fi" else array for name, array in own.items()}
        for save in (np.savez, np.savez_compressed):
            for number, arrays in enumerate((own, swapped, columns, wide)):
                save(self.folder / "theirs.npz", **arrays)
                knuckle.load_actor(self.folder / "theirs.npz").save(self.folder / "again.npz")
                again = np.load(self.folder / "again.npz")
                for name in own:
                    np.testing.assert_array_equal(again[name], own[name], f"{name} {number}")

    def test_the_same_actor_gives_the_same_bytes(self):
        actor = knuckle.voxelize(MODEL, particles=300)
        for name in ("a.npz", "b.npz"):
            actor.save(self.folder / name)
        self.assertEqual((self.folder / "a.npz").read_bytes(), (self.folder / "b.npz").read_bytes())

    def test_a_file_that_ends_early_or_is_damaged_is_one_line(self):
        actor = knuckle.voxelize(MODEL, particles=300)
        actor.save(self.folder / "whole.npz")
        whole = (self.folder / "whole.npz").read_bytes()
        place = whole.index(b"particles.npy") + 400
        damaged = whole[:place] + bytes([whole[place] ^ 1]) + whole[place + 1:]
        for bad, words in ((b"", "no zip archive"), (whole[:1000], "ends early"), (whole[:-30], "ends early"),
                           (whole[:-1], "ends early"), (damaged, "is damaged")):
            (self.folder / "bad.npz").write_bytes(bad)
            code, text = self.check("bad.npz")
            self.assertEqual((code, text.count("\n")), (2, 0), text)
            self.assertIn(words, text)
            self.assertTrue(text.startswith("knuckle: bad.npz: "), text)

    def test_refuses_other_endings(self):
        with self.assertRaisesRegex(knuckle.InputError, "spot.ply: an actor is written as .json or .npz or .urdf"):
            knuckle.Actor(door_arrays()).save(self.folder / "spot.ply")


class Levels(unittest.TestCase):
    def test_have_the_same_bodies_and_joints_in_the_order_asked_for(self):
        fine, coarse = knuckle.voxelize(MODEL, levels=[1000, 300])
        for count, actor in ((1000, fine), (300, coarse)):
            self.assertAlmostEqual(len(actor.particles) / count, 1, delta=0.05)
            self.assertEqual(len(actor.particle_weights[0]), len(actor.particles))
        for part, fields in (("bodies", ("name", "parent", "merged_bones")), ("joints", ("name", "parent", "child"))):
            for field in fields:
                self.assertEqual(*([item[field] for item in getattr(actor, part)] for actor in (fine, coarse)), field)
        # By itself the finer one has room for more.
        self.assertGreater(len(knuckle.voxelize(MODEL, particles=1000).bodies), len(fine.bodies))

    def test_mistakes_are_one_line_each(self):
        for arguments, words in (({"levels": []}, "levels: is empty; give a number of particles for each actor"),
                                 ({"levels": [300, 5]}, "levels: 5 is not from 12 to 200000"),
                                 ({"particles": 300000}, "particles: 300000 is not from 12 to 200000"),
                                 ({"levels": [300], "particles": 300},
                                  "levels: stand for particles and diameter; leave those out")):
            with self.assertRaises(knuckle.InputError) as caught:
                knuckle.voxelize(MODEL, **arguments)
            self.assertEqual(str(caught.exception), words)


class Arrays(unittest.TestCase):
    def test_an_actor_of_arrays_is_that_of_its_file(self):
        actor = knuckle.Actor(door_arrays())
        self.assertEqual([body["name"] for body in actor.bodies], ["post", "door"])
        # Four particles of 1 kg, and half of two.
        np.testing.assert_allclose([body["mass"] for body in actor.bodies], [5, 5], rtol=1e-5)
        np.testing.assert_allclose([body["centre"][0] for body in actor.bodies], [-0.08, 0.12], atol=1e-6)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "door.json"
            path.write_text(json.dumps(door()))
            self.assertEqual(fallen(actor), fallen(str(path)))
            for name, array in knuckle.load_actor(path).arrays().items():
                np.testing.assert_array_equal(actor.arrays()[name], array, name)

    def test_inertia_is_that_of_points(self):
        body = knuckle.Actor(door_arrays()).bodies[0]
        places = np.array(door()["particles"])[body["particles"]]
        masses = np.array([1, 1, 1, 1, 0.5, 0.5])
        r = places - masses @ places / masses.sum()
        inertia = np.eye(3) * (masses @ (r * r).sum(1)) - (r.T * masses) @ r
        np.testing.assert_allclose(body["inertia"], inertia, atol=1e-6)

    def test_weights_are_of_vertices_and_of_particles(self):
        actor = knuckle.voxelize(MODEL, particles=1000)
        for count, (bodies, weights) in ((len(actor.particles), actor.particle_weights),
                                         (len(actor.vertices), actor.vertex_weights)):
            self.assertEqual((bodies.shape, weights.shape), ((count, 4), (count, 4)))
            np.testing.assert_allclose(weights.sum(1), 1, atol=1e-5)
            self.assertLess(bodies.max(), len(actor.bodies))
            self.assertTrue((np.diff(weights, axis=1) <= 0).all())
        # Most particles weigh most in a body that has them.
        bodies = actor.particle_weights[0]
        own = sum(particle in set(actor.bodies[bodies[particle, 0]]["particles"]) for particle in range(len(bodies)))
        self.assertGreater(own / len(bodies), 0.9)

    def test_mistakes_are_one_line_each(self):
        places = door_arrays()["particles"]
        nan = places.copy()
        nan[3, 1] = np.nan
        for change, words in (
                ({"particles": places[:, :2]}, "actor: /particles: has the shape (10, 2), must have (n, 3)"),
                ({"particles": places.ravel()}, "actor: /particles: has the shape (30,), must have (n, 3)"),
                ({"particles": nan}, "actor: /particles: has nan in row 3; must be finite"),
                ({"particles": places.astype(str)}, "actor: /particles: is of texts, must be of numbers"),
                ({"particles": places.astype(complex)}, "is of the type '<c16'; must be of numbers or of texts (str)"),
                ({"particles": [None]}, "actor: /particles: is of the type '|O'"),
                ({"body_name": ["a"]}, 'actor: /body_name: unknown array; did you mean "bodies_name"?'),
                ({"bodies_parent": [-1, 0, 1]}, "actor: /bodies_parent: has the shape (3,), must have (2,)"),
                ({"bodies_parent": [-1, 0.5]}, "actor: /bodies/1/parent: is 0.5"),
                ({"bodies_parent": [-1, 1]}, "actor: /bodies/1/parent: 1 must be smaller than the body's own place, 1"),
                ({"bodies_particles_starts": [0, 6]}, "has the shape (2,), must have (3,)"),
                ({"bodies_particles_starts": [0, 7, 5]}, "has 5 in row 2; must rise from 0 to 12"),
                ({"bodies_particles_starts": [0, 6, 11]}, "ends with 11; must end with 12"),
                ({"bodies_mass": [5, 7]}, "actor: /bodies/1/mass: has 7"),
                ({"joints_type": ["hing"]}, '/joints/0/type: "hing" is unknown; did you mean "hinge"?'),
                ({"joints_child": [4]}, "actor: /joints/0/child: 4 is not one of the 2 bodies"),
                ({"skin_particleBodies": np.zeros((10, 4), int)}, "/skin/particleWeights: has 0 entries for 10"),
                ({"skin_particleBodies": np.zeros((10, 4), int), "skin_particleWeights": np.ones((10, 4))},
                 "actor: /skin/particleWeights/0: has the sum 4; must be 1"),
        ):
            with self.assertRaises(knuckle.InputError, msg=words) as caught:
                knuckle.Actor({**door_arrays(), **change})
            self.assertIn(words, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))
        for missing, words in (("bodies_particles_starts", "is missing"), ("bodies_name", '"name" is missing'),
                               ("particles", '"particles" is missing'), ("format", '"format" is missing')):
            arrays = door_arrays()
            del arrays[missing]
            with self.assertRaises(knuckle.InputError) as caught:
                knuckle.Actor(arrays)
            self.assertIn(words, str(caught.exception))

    def test_a_scene_takes_nothing_but_actors(self):
        with self.assertRaisesRegex(TypeError, "a scene has no values of the type <class 'set'>"):
            knuckle.Scene.load({"objects": [{"type": "actor", "file": {1}}]})


if __name__ == "__main__":
    unittest.main()
