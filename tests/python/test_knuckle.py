"""The Python package against NumPy and the command line. Run by ctest; KNUCKLE names the program."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import knuckle

ROOT = pathlib.Path(__file__).resolve().parents[2]
BALL = {
    "duration": 1,
    "diameter": 0.1,
    "solver": {"gravity": [0, -9.81, 0]},
    "objects": [{"type": "rigid", "shape": "sphere", "name": "ball", "radius": 0.1, "position": [0, 5, 0],
                 "velocity": [2, 1, 0]}],
}


def simulation(document=None, **changes):
    return knuckle.Simulation(knuckle.Scene.load(document or BALL, changes), "software")


class Steps(unittest.TestCase):
    def test_a_thrown_ball_flies_along_its_parabola(self):
        thrown = simulation()
        start = thrown.bodies()["position"][0].copy()
        thrown.step(30)
        t = thrown.time
        self.assertAlmostEqual(t, 0.5, places=5)
        expected = start + np.array([2, 1, 0]) * t + 0.5 * np.array([0, -9.81, 0]) * t * t
        # Of 1.2 m of fall; substeps round 5 m to 5e-7 each.
        np.testing.assert_allclose(thrown.bodies()["position"][0], expected, atol=3e-4)
        np.testing.assert_allclose(thrown.bodies()["velocity"][0], [2, 1 - 9.81 * t, 0], atol=1e-3)

    def test_arrays_have_the_shapes_that_the_documents_say(self):
        falling = simulation()
        positions = falling.positions()
        self.assertEqual((positions.dtype, positions.ndim, positions.shape[1]), (np.float32, 2, 3))
        self.assertEqual(falling.velocities().shape, positions.shape)
        self.assertTrue(falling.active().all())
        bodies = falling.bodies()
        self.assertEqual(bodies["name"], ["ball"])
        self.assertEqual(bodies["rotation"].shape, (1, 4))
        # A copy: what is done to it changes nothing.
        positions[:] = 0
        self.assertGreater(falling.positions()[:, 1].min(), 4)

    def test_the_same_scene_has_the_hash_of_the_command_line(self):
        path = ROOT / "assets/scenes/hello.json"
        with tempfile.TemporaryDirectory() as folder:
            told = subprocess.run([os.environ["KNUCKLE"], "render", path, "-o", folder, "--size", "64x36", "--hash",
                                   "--frames", "1:11", "--device", "software"], capture_output=True, text=True, check=True)
        scene = knuckle.Scene.load(path)
        stepped = knuckle.Simulation(scene, "software")
        stepped.step(10 * scene.steps_per_frame)
        self.assertIn(stepped.hash(), told.stdout)

    def test_returns_to_a_state_and_goes_on_with_the_same_bits(self):
        path = ROOT / "assets/scenes/hello.json"
        stepped = knuckle.Simulation(knuckle.Scene.load(path), "software")
        stepped.step(20)
        kept = stepped.save_state()
        stepped.step(10)
        first = stepped.hash()
        stepped.load_state(kept)
        self.assertEqual(stepped.steps, 20)
        stepped.step(10)
        self.assertEqual(stepped.hash(), first)

    def test_several_simulations_do_not_disturb_each_other(self):
        alone = simulation()
        alone.step(12)
        first, second = simulation(), simulation(**{"objects.0.position": [1, 2, 3]})
        for _ in range(12):
            first.step()
            second.step()
        self.assertEqual(first.hash(), alone.hash())
        self.assertNotEqual(second.hash(), alone.hash())


class Pictures(unittest.TestCase):
    def test_a_picture_shows_the_ball_where_it_is(self):
        scene = dict(BALL, materials={"default": {"color": [0.9, 0.02, 0.02], "draw": "shape"}},
                     render={"colorBy": "material"})
        seen = simulation(scene)
        camera = {"position": [0, 5, 4], "target": [0, 5, 0], "fieldOfView": 40}
        picture = seen.render(size=(160, 90), camera=camera)
        self.assertEqual((picture.shape, picture.dtype), ((90, 160, 4), np.uint8))
        self.assertTrue((picture[..., 3] == 255).all())
        red = picture[..., 0].astype(int) - picture[..., 1] > 60
        rows, columns = np.nonzero(red)
        # In the middle; 0.1 m at 4 m and 40 degrees are 3.1 pixels of radius, of particles a little less.
        np.testing.assert_allclose([rows.mean(), columns.mean()], [44.5, 79.5], atol=1.0)
        self.assertGreater(red.sum(), 12)

    def test_layers_say_what_pixels_show(self):
        scene = dict(BALL, materials={"default": {"draw": "shape"}}, colliders=[{"type": "plane"}])
        camera = {"position": [0, 5, 4], "target": [0, 5, 0], "fieldOfView": 40}
        layers = simulation(scene).layers(size=(160, 90), camera=camera)
        for name, kind, shape in (("depth", np.float32, (90, 160)), ("normals", np.float32, (90, 160, 3)),
                                  ("albedo", np.float32, (90, 160, 3)), ("object", np.uint32, (90, 160)),
                                  ("body", np.uint32, (90, 160)), ("collider", np.uint32, (90, 160))):
            self.assertEqual((layers[name].dtype, layers[name].shape), (kind, shape), name)
        ball = layers["body"] == 1
        self.assertEqual(layers["objects"], ["ball"])
        np.testing.assert_array_equal(ball, layers["object"] == 1)
        rows, columns = np.nonzero(ball)
        np.testing.assert_allclose([rows.mean(), columns.mean()], [44.5, 79.5], atol=0.5)
        # Its nearest point is a radius, 0.1 m, before its middle; pixels are 0.03 m apart there.
        self.assertAlmostEqual(layers["depth"][ball].min(), 3.9, delta=0.005)
        self.assertGreater(layers["normals"][ball][:, 2].max(), 0.95)
        np.testing.assert_allclose(np.linalg.norm(layers["normals"][ball], axis=-1), 1, atol=1e-6)
        ground = layers["collider"] == 1
        self.assertTrue(ground.any() and (ground & ball).sum() == 0)
        np.testing.assert_allclose(layers["normals"][ground], np.broadcast_to([0, 1, 0], (ground.sum(), 3)), atol=1e-4)
        self.assertTrue(np.isinf(layers["depth"][~ground & ~ball]).all())
        np.testing.assert_allclose(layers["camera"]["camera_to_world"][:3, 3], [0, 5, 4], atol=1e-6)
        self.assertAlmostEqual(layers["camera"]["fy"], 45 / np.tan(np.radians(20)), places=3)

    def test_pictures_are_compared(self):
        black = np.zeros((20, 30, 3), np.uint8)
        dotted = black.copy()
        dotted[3, 4] = 200
        self.assertTrue(knuckle.compare(black, black)["identical"])
        found = knuckle.compare(black, dotted)
        self.assertEqual((found["differing"], found["changed"]), (1, 1))
        with self.assertRaisesRegex(knuckle.InputError, r"\[height, width, 3 or 4\]"):
            knuckle.compare(black, black[0])


class Actors(unittest.TestCase):
    def test_a_model_becomes_an_actor_and_its_file(self):
        actor = knuckle.voxelize(ROOT / "assets/models/humanoid.glb", particles=1000)
        self.assertLess(abs(len(actor.particles) - 1000), 50)
        shared = {i for joint in actor.joints for i in joint["particles"]}
        for joint in actor.joints:
            both = set(actor.bodies[joint["parent"]]["particles"]) & set(actor.bodies[joint["child"]]["particles"])
            self.assertTrue(both & shared or joint["type"] == "universal", joint["name"])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "actor.json"
            actor.save(path)
            np.testing.assert_array_equal(knuckle.load_actor(path).particles, actor.particles)
            self.assertEqual(len(json.loads(path.read_text())["particles"]), len(actor.particles))


class Errors(unittest.TestCase):
    def test_mistakes_are_one_line_with_their_place(self):
        with self.assertRaisesRegex(knuckle.InputError, "/objects/0/shape: .*did you mean \"sphere\""):
            knuckle.Scene.load(dict(BALL, objects=[{"type": "rigid", "shape": "spere"}]))
        with self.assertRaisesRegex(ValueError, "no such file"):
            knuckle.Scene.load("there_is_none.json")
        with self.assertRaises(knuckle.InputError):
            simulation().render(camera={"positon": [0, 0, 1]})
        with self.assertRaises(knuckle.InputError):
            knuckle.Simulation(knuckle.Scene.load(BALL), "hardwear")
        with self.assertRaisesRegex(knuckle.InputError, "particles: 3 is not from 12 to 200000"):
            knuckle.voxelize(ROOT / "assets/models/humanoid.glb", particles=3)


if __name__ == "__main__":
    unittest.main()
