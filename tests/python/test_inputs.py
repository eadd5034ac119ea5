"""What Python gives: values of NumPy in scenes, mistakes of all kinds, threads. Run by ctest."""
import gc
import os
import pathlib
import signal
import tempfile
import threading
import unittest
import warnings

import numpy as np

import knuckle

MODEL = pathlib.Path(__file__).resolve().parents[2] / "assets/models/humanoid.glb"
BOX = {"type": "rigid", "shape": "box", "name": "box", "size": [0.3, 0.3, 0.3], "position": [0, 1, 0]}
SCENE = {"diameter": 0.1, "objects": [BOX]}


def simulation(document=SCENE, **changes):
    return knuckle.Simulation(knuckle.Scene.load(document, changes), "software")


def elsewhere(call):
    """What another thread gets of it, or its exception."""
    got = []

    def run():
        try:
            got.append(call())
        except Exception as error:
            got.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    return got[0]


class Values(unittest.TestCase):
    def test_scenes_and_cameras_take_values_of_numpy(self):
        box = dict(BOX, size=np.full(3, 0.3), position=(np.float32(0), np.int64(1), np.array(0)))
        same = knuckle.Scene.load({"diameter": np.float64(0.1), "seed": np.uint8(0), "objects": [box]},
                                  {"duration": np.int32(2), "objects.0.fixed": np.False_})
        self.assertEqual(knuckle.Simulation(same, "software").hash(), simulation().hash())
        pictures = [simulation().render((64, 36), {"position": place, "target": [0, 1, 0]})
                    for place in ([0, 1, 2], np.array([0, 1, 2]), np.array([0, 1, 2], np.float16))]
        self.assertTrue((pictures[0] == pictures[1]).all() and (pictures[0] == pictures[2]).all())

    def test_files_are_paths(self):
        document = {"diameter": 0.06, "objects": [{"type": "actor", "file": MODEL}]}
        self.assertGreater(len(simulation(document).bodies()["name"]), 10)

    def test_vectors_are_of_any_type_and_stride(self):
        hashes = set()
        for velocity in ([1, 2, 3], np.array([1, 2, 3]), np.array([1, 0, 2, 0, 3], np.float32)[::2],
                         np.array([3, 2, 1], ">f8")[::-1], np.array([1, 2, 3], object)):
            pushed = simulation()
            pushed.set_velocity("box", velocity)
            hashes.add(pushed.hash())
        self.assertEqual(len(hashes), 1)


class Mistakes(unittest.TestCase):
    def are_one_line(self, mistakes):
        for call, words in mistakes:
            with self.assertRaises(knuckle.InputError, msg=words) as caught, warnings.catch_warnings():
                warnings.simplefilter("error")
                call()
            self.assertIn(words, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))

    def test_in_scenes(self):
        holds_itself = {}
        holds_itself["a"] = [holds_itself]
        load, nan = knuckle.Scene.load, float("nan")
        self.are_one_line([
            (lambda: load(dict(SCENE, diameter=nan)), "scene: /diameter is nan, must be finite"),
            (lambda: load(dict(SCENE, objects=[dict(BOX, position=np.array([0, np.inf, 0]))])),
             "scene: /objects/0/position/1 is inf, must be finite"),
            (lambda: load({3: 4}), "scene: / has the key 3, no text"),
            (lambda: load({"seed": 10**30}), "scene: /seed is too large a number"),
            (lambda: load({"name": "\udc80"}), "scene: /name is no text"),
            (lambda: load(holds_itself), "contains itself"),
            (lambda: load(SCENE, {3: 4}), "changes: 3 is no path"),
            (lambda: load(SCENE, {"duration": nan}), "changes: duration: / is nan, must be finite"),
            (lambda: simulation().render(camera={"position": [nan, 0, 0]}), "camera: /position/0 is nan"),
            (lambda: knuckle.Simulation(load(SCENE), seed=-1), "/seed: -1 is below the minimum 0"),
        ])

    def test_in_numbers(self):
        free = simulation()
        self.are_one_line([
            (lambda: free.set_velocity("box", np.eye(3)), "velocity must be 3 numbers, not an array of float64 (3, 3)"),
            (lambda: free.set_velocity("box", np.zeros((3, 1))), "not an array of float64 (3, 1)"),
            (lambda: free.set_velocity("box", [1j, 0, 0]), "velocity must be 3 numbers, not [1j, 0, 0]"),
            (lambda: free.set_velocity("box", ["1", "2", "3"]), "velocity must be 3 numbers"),
            (lambda: free.set_velocity("box", np.zeros(3, "M8[D]")), "not an array of datetime64[D] (3,)"),
            (lambda: free.set_velocity("box", None), "velocity must be 3 numbers, not None"),
            (lambda: free.set_velocity("box", np.ma.array([1, 2, 3], mask=[0, 0, 1])), "velocity has masked entries"),
            (lambda: free.set_velocity("box", [None, 0, 0]), "velocity must be finite"),
            (lambda: free.set_velocity("box", [1e300, 0, 0]), "velocity must be finite"),
            (lambda: free.step(-1), "count must be 0 or more; it is -1"),
            (lambda: free.render(size=(-1, 5)), "size must be a width and a height [pixels]; it is -1, 5"),
            (lambda: knuckle.voxelize(MODEL, particles=-5), "particles: -5 is not from"),
            (lambda: knuckle.voxelize(MODEL, levels=[-5]), "levels: -5 is not from"),
            (lambda: knuckle.voxelize(MODEL, diameter=float("nan")), "diameter: nan is no length above 0 m"),
            (lambda: knuckle.voxelize(MODEL, particles=300, diameter=0.05), "particles: excludes diameter"),
            (lambda: knuckle.Actor({}), 'actor: /: "format" is missing'),
            (lambda: knuckle.Actor({3: [1]}), "actor: has the key 3, no text"),
            (lambda: knuckle.Actor({"file": [1]}), "actor: /file: unknown array"),
            (lambda: knuckle.Actor({"particles": np.ma.masked_less([[1, 2, 3]], 2)}), "actor: /particles has masked"),
        ])

    def test_in_pictures(self):
        black = np.zeros((20, 30, 3), np.uint8)
        self.are_one_line([
            (lambda: knuckle.compare(None, black), "a picture is an array of uint8, not None"),
            (lambda: knuckle.compare(np.ma.array(black, mask=black < 1), black), "a picture has masked entries"),
            (lambda: knuckle.compare(black.tolist(), black), "a picture is an array of uint8, not [[["),
            (lambda: knuckle.compare(black, black, threshold=float("nan")), "threshold must be from 0 to 255"),
            (lambda: knuckle.Film("film.xyz"), "film.xyz: films are written as .mp4"),
            (lambda: knuckle.Film("frame_####.exr"), "frame_####.exr: films are written as .mp4"),
        ])
        self.assertEqual(knuckle.compare(black, black[:9]),
                         dict(dict.fromkeys(("differing", "changed", "flip", "ssim")), same_size=False, identical=False))

    def test_no_scene_is_an_exception(self):
        with self.assertRaises(TypeError):
            knuckle.Simulation(None)

    def test_states_of_other_scenes_are_refused(self):
        kept = simulation().save_state()
        other = simulation(dict(SCENE, objects=[dict(BOX, position=[5, 1, 0])]))
        with self.assertRaisesRegex(knuckle.InputError, "the state is of another scene"):
            other.load_state(kept)
        simulation().load_state(kept)


class Threads(unittest.TestCase):
    def test_the_last_reference_may_be_in_another_thread(self):
        here = simulation()
        here.step()
        left = [simulation()]
        left[0].render((64, 36))
        self.assertIsNone(elsewhere(left.clear))
        first = elsewhere(simulation)   # its thread has ended
        with self.assertRaisesRegex(RuntimeError, "another thread"):
            first.positions()
        # A thread that comes later may have the number of the one that ended.
        self.assertRegex(str(elsewhere(first.positions)), "another thread")
        del first
        gc.collect()
        here.step()
        self.assertEqual(here.render((64, 36)).shape, (36, 64, 4))

    def test_each_has_simulations_of_its_own(self):
        def stepped():
            one = simulation()
            one.step(20)
            return one.hash()

        self.assertEqual(elsewhere(stepped), stepped())

    def test_ctrl_c_stops_between_steps(self):
        stopped = simulation()
        kick = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        kick.start()
        with self.assertRaises(KeyboardInterrupt):
            stopped.step(10**9)
        kick.join()
        steps = stopped.steps
        self.assertGreater(steps, 0)
        stopped.step(2)
        self.assertEqual(stopped.steps, steps + 2)


class Films(unittest.TestCase):
    def test_a_generator_that_is_left_leaves_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            def frames():
                with knuckle.Film(f"{folder}/left.mp4") as film:
                    while True:
                        film.add(np.zeros((36, 64, 3), np.uint8))
                        yield

            running = frames()
            next(running)
            del running
            gc.collect()
            self.assertEqual(os.listdir(folder), [])


if __name__ == "__main__":
    unittest.main()
