"""What Python may change of a running simulation, against closed forms. Run by ctest."""
import os
import re
import subprocess
import tempfile
import unittest

import numpy as np

import knuckle

FREE = {
    "duration": 1,
    "diameter": 0.1,
    "solver": {"gravity": [0, 0, 0]},
    "objects": [{"type": "rigid", "shape": "box", "name": "box", "size": [0.2, 0.3, 0.5], "position": [0, 1, 0]},
                {"type": "joined", "name": "pair", "position": [3, 1, 0]}],
}
RESTING = {
    "duration": 1,
    "diameter": 0.1,
    "colliders": [{"type": "plane"}],
    "objects": [{"type": "rigid", "shape": "box", "name": "low", "size": [0.3, 0.3, 0.3], "position": [0, 0.15, 0]},
                {"type": "rigid", "shape": "box", "name": "high", "size": [0.3, 0.3, 0.3], "position": [0, 0.45, 0]}],
}
HELD = {
    "duration": 1,
    "diameter": 0.1,
    "objects": [{"type": "rigid", "shape": "box", "name": "held", "size": [0.3, 0.3, 0.3], "position": [0, 2, 0],
                 "fixed": True, "release": {"time": 1000}},
                {"type": "rigid", "shape": "box", "name": "nailed", "size": [0.3, 0.3, 0.3], "position": [2, 2, 0],
                 "fixed": True}],
}
WHEEL = {
    "duration": 1,
    "diameter": 0.1,
    "solver": {"gravity": [0, 0, 0]},
    "objects": [{"type": "rigid", "shape": "box", "name": "arm", "size": [0.6, 0.2, 0.2], "position": [0.3, 1, 0]},
                {"type": "joint", "name": "axle", "kind": "hinge", "bodies": ["arm", "world"], "at": [0, 1, 0],
                 "axis": [0, 0, 1], "motor": {"speed": 0, "torque": 100}}],
}


def simulation(document):
    return knuckle.Simulation(knuckle.Scene.load(document), "software")


def body(stepped, name):
    bodies = stepped.bodies()
    k = bodies["name"].index(name)
    return {key: value[k] for key, value in bodies.items()}


class Velocities(unittest.TestCase):
    def test_a_body_flies_on_as_told(self):
        flying = simulation(FREE)
        flying.step(5)
        start = body(flying, "box")["position"]
        flying.set_velocity("box", [1, 0.5, -2], angular_velocity=[0, 3, 0])
        np.testing.assert_allclose(body(flying, "box")["velocity"], [1, 0.5, -2], atol=1e-5)
        np.testing.assert_allclose(body(flying, "box")["angular_velocity"], [0, 3, 0], atol=1e-4)
        flying.step(30)
        now = body(flying, "box")
        # Half a second in single precision; a box that turns about a main axis keeps its spin.
        np.testing.assert_allclose(now["position"] - start, [0.5, 0.25, -1], atol=1e-4)
        np.testing.assert_allclose(now["angular_velocity"], [0, 3, 0], atol=0.02)

    def test_bodies_of_an_object_move_as_one(self):
        flying = simulation(FREE)
        names = [name for name in flying.bodies()["name"] if name.startswith("pair/")]
        self.assertEqual(len(names), 2)
        flying.set_velocity("pair", [0, 1, 0], angular_velocity=[0, 0, 2])
        first, second = (body(flying, name) for name in names)
        away = second["position"] - first["position"]
        np.testing.assert_allclose(second["velocity"], np.array([0, 1, 0]) + np.cross([0, 0, 2], away), atol=1e-4)
        flying.step(20)
        first, second = (body(flying, name) for name in names)
        # As one: nothing bends the joint between.
        np.testing.assert_allclose(np.linalg.norm(second["position"] - first["position"]), np.linalg.norm(away),
                                   atol=1e-3)

    def test_water_takes_a_velocity_too(self):
        drop = simulation({"duration": 1, "diameter": 0.1, "solver": {"gravity": [0, 0, 0]},
                           "materials": {"water": {"fluid": True}},
                           "objects": [{"type": "fluid", "shape": "sphere", "name": "drop", "radius": 0.2,
                                        "material": "water"}]})
        drop.step(1)
        drop.set_velocity("drop", [1, 0, 0])
        before = drop.positions().mean(axis=0)
        drop.step(12)
        np.testing.assert_allclose(drop.positions().mean(axis=0) - before, [0.2, 0, 0], atol=2e-3)
        with self.assertRaisesRegex(knuckle.InputError, "loose particles"):
            drop.set_velocity("drop", [1, 0, 0], [0, 0, 1])


class Impulses(unittest.TestCase):
    def test_an_impulse_changes_momentum_and_spin(self):
        pushed = simulation(FREE)
        mass = body(pushed, "box")["mass"]
        at = body(pushed, "box")["position"] + [0, 0, 0.25]
        pushed.apply_impulse("box", [2, 0, 0], at=at)
        now = body(pushed, "box")
        np.testing.assert_allclose(now["velocity"], [2 / mass, 0, 0], rtol=1e-4, atol=1e-5)
        # About y by 0.25 m times 2 N s: a box of particles of 0.1 m, two wide and five deep, as points.
        inertia = mass * ((2 ** 2 - 1) + (5 ** 2 - 1)) / 12 * 0.1 ** 2
        np.testing.assert_allclose(now["angular_velocity"], [0, 0.5 / inertia, 0], rtol=0.02, atol=1e-3)

    def test_a_force_acts_for_a_step(self):
        pushed = simulation(FREE)
        mass = body(pushed, "box")["mass"]
        for _ in range(30):
            pushed.apply_force("box", [0, 6, 0])
            pushed.step(1)
        np.testing.assert_allclose(body(pushed, "box")["velocity"], [0, 6 * 0.5 / mass, 0], rtol=1e-3, atol=1e-4)


    def test_what_sleeps_wakes(self):
        asleep = simulation({**RESTING, "solver": {"sleep": 0.02}})
        asleep.step(120)
        before = asleep.hash()
        asleep.step(5)
        self.assertEqual(asleep.hash(), before, "nothing is asleep")
        asleep.apply_impulse("high", [0, 3 * body(asleep, "high")["mass"], 0])
        asleep.step(6)
        # It leaves at 3 m/s, a tenth of a second ago.
        self.assertAlmostEqual(body(asleep, "high")["velocity"][1], 3 - 0.981, delta=0.05)


class Poses(unittest.TestCase):
    def test_a_body_is_where_it_is_put(self):
        moved = simulation(FREE)
        moved.set_velocity("box", [0, 0, 1])
        turned = [0, np.sin(np.pi / 8), 0, np.cos(np.pi / 8)]
        moved.set_pose("box", [5, 2, 1], rotation=turned)
        now = body(moved, "box")
        np.testing.assert_allclose(now["position"], [5, 2, 1], atol=1e-5)
        np.testing.assert_allclose(now["rotation"], turned, atol=1e-5)
        np.testing.assert_allclose(now["velocity"], [0, 0, 1], atol=1e-5)
        moved.step(10)
        np.testing.assert_allclose(body(moved, "box")["position"], [5, 2, 1 + 1 / 6], atol=1e-4)
        np.testing.assert_allclose(body(moved, "box")["rotation"], turned, atol=1e-3)

    def test_particles_and_joined_bodies_come_along(self):
        moved = simulation(FREE)
        before, names = moved.positions(), moved.bodies()["name"]
        gap = moved.measure()["worst_joint_gap"]
        first = body(moved, next(name for name in names if name.startswith("pair/")))["position"]
        moved.set_pose("pair", first + [0, 4, 0])
        shift = moved.positions() - before
        of_pair = before[:, 0] > 1.5
        np.testing.assert_allclose(shift[of_pair], np.tile([0, 4, 0], (of_pair.sum(), 1)), atol=1e-5)
        np.testing.assert_allclose(shift[~of_pair], 0)
        moved.step(5)
        self.assertLess(moved.measure()["worst_joint_gap"], gap + 1e-3)

    def test_a_crate_that_is_put_on_another_lies_on_it(self):
        put = simulation(RESTING)
        put.step(30)
        put.set_pose("high", [0.05, 0.46, 0])
        put.step(60)
        np.testing.assert_allclose(body(put, "high")["position"], [0.05, 0.45, 0], atol=0.02)


class Contacts(unittest.TestCase):
    def test_they_carry_what_lies_on_them(self):
        resting = simulation(RESTING)
        resting.step(90)
        weight = 9.81 * body(resting, "high")["mass"]
        contacts, names = resting.contacts(), resting.bodies()["name"]
        low, high = names.index("low"), names.index("high")
        between = (contacts["bodies"][:, 1] >= 0)
        self.assertTrue(between.any() and (contacts["collider"][between] == -1).all())
        force = contacts["force"][between]
        sign = np.where(contacts["bodies"][between][:, 0] == high, 1, -1)[:, None]
        self.assertTrue((np.sort(contacts["bodies"][between], axis=1) == sorted([low, high])).all())
        np.testing.assert_allclose((sign * force).sum(axis=0), [0, weight, 0], atol=0.03 * weight)
        on_floor = contacts["collider"] == 0
        np.testing.assert_allclose(contacts["force"][on_floor].sum(axis=0), [0, 2 * weight, 0], atol=0.06 * weight)
        np.testing.assert_allclose(contacts["position"][on_floor][:, 1], 0.05, atol=0.01)


class Releases(unittest.TestCase):
    def test_what_is_held_falls_once_it_is_let_go(self):
        held = simulation(HELD)
        held.step(10)
        np.testing.assert_allclose(body(held, "held")["position"], [0, 2, 0], atol=1e-6)
        with self.assertRaisesRegex(knuckle.InputError, '"held" is held, and nothing else moves it; release\\(\\)'):
            held.set_velocity("held", [1, 0, 0])
        held.release("held")
        held.step(30)
        # First order: g t^2 / 2 and half a substep more.
        self.assertAlmostEqual(body(held, "held")["position"][1], 2 - 9.81 * 0.125, delta=0.02)
        with self.assertRaisesRegex(knuckle.InputError, "held for ever"):
            held.release("nailed")


class Drives(unittest.TestCase):
    def test_a_motor_turns_as_it_is_told(self):
        wheel = simulation(WHEEL)
        wheel.step(5)
        wheel.drive("axle", speed=2, torque=200)
        wheel.step(30)
        np.testing.assert_allclose(abs(body(wheel, "arm")["angular_velocity"]), [0, 0, 2], atol=0.05)
        state = wheel.save_state()
        wheel.drive("axle", angle=0, torque=500)
        wheel.step(60)
        np.testing.assert_allclose(body(wheel, "arm")["angular_velocity"], 0, atol=0.05)
        # A state has its motors.
        wheel.load_state(state)
        wheel.step(30)
        np.testing.assert_allclose(abs(body(wheel, "arm")["angular_velocity"]), [0, 0, 2], atol=0.05)


class Films(unittest.TestCase):
    def test_a_film_has_the_frames_that_were_added(self):
        free = simulation(FREE)
        with tempfile.TemporaryDirectory() as folder:
            with knuckle.Film(f"{folder}/flight.mp4", fps=25) as film, knuckle.Film(f"{folder}/f_##.png") as frames:
                for _ in range(5):
                    free.step(1)
                    picture = free.render(size=(64, 48), quality="draft")
                    film.add(picture)
                    frames.add(picture)
            told = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                   "stream=width,height,r_frame_rate,nb_read_frames", "-of", "csv=p=0",
                                   f"{folder}/flight.mp4"], capture_output=True, text=True, check=True)
            self.assertEqual(told.stdout.strip(), "64,48,25/1,5")
            self.assertEqual(film.frames, 5)
            self.assertTrue(knuckle.compare(f"{folder}/f_05.png", picture)["identical"])

    def test_one_that_fails_leaves_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(ZeroDivisionError):
                with knuckle.Film(f"{folder}/half.mp4") as film:
                    film.add(np.zeros((48, 64, 3), np.uint8))
                    1 / 0
            self.assertEqual(os.listdir(folder), [])
            film = knuckle.Film(f"{folder}/other.mp4")
            film.add(np.zeros((48, 64, 3), np.uint8))
            for picture, message in [(np.zeros((40, 64, 3), np.uint8), "a picture of 64x40 in a film of 64x48"),
                                     (np.zeros((48, 64), np.uint8), "a picture is an array [height, width, 3 or 4]"),
                                     (np.zeros((48, 64, 3)), "a picture is an array of uint8")]:
                with self.assertRaisesRegex(knuckle.InputError, re.escape(message)):
                    film.add(picture)
            with self.assertRaisesRegex(knuckle.InputError, "fps must be above 0"):
                knuckle.Film(f"{folder}/never.mp4", fps=0)


class Seeds(unittest.TestCase):
    def test_another_seed_is_another_run(self):
        sand = knuckle.Scene.load({"duration": 1, "diameter": 0.1, "objects": [
            {"type": "grains", "shape": "box", "seed": 2, "position": [0, 1, 0]}]})
        places = [knuckle.Simulation(sand, "software", seed=seed).positions() for seed in (None, 0, 3)]
        np.testing.assert_array_equal(places[0], places[1])
        self.assertGreater(np.abs(places[0] - places[2]).max(), 1e-3)


class Mistakes(unittest.TestCase):
    def test_each_is_one_line(self):
        free = simulation(FREE)
        for call, message in [
            (lambda: free.set_velocity("bocks", [0, 0, 0]), 'there is no object or body "bocks"; known: box, pair'),
            (lambda: free.set_velocity("box", [0, 0]), "velocity must be 3 numbers"),
            (lambda: free.set_velocity("box", [0, float("nan"), 0]), "velocity must be finite"),
            (lambda: free.set_velocity("box", "fast"), "velocity must be 3 numbers"),
            (lambda: free.set_pose("box", [0, 0, 0], [0, 0, 0, 0]), "rotation must be a quaternion"),
            (lambda: free.apply_impulse("pair", [1, 0, 0]), '"pair" has 2 bodies; name one of them'),
            (lambda: free.apply_impulse("box", [1, 0, 0], at=[1]), "at must be 3 numbers"),
            (lambda: free.drive("axle", speed=1, torque=1), 'there is no joint with a motor or a spring "axle"'),
            (lambda: free.drive("axle", torque=1), "give drive"),
            (lambda: free.drive("axle", speed=1, torque=0), "torque must be above 0"),
        ]:
            with self.assertRaises(knuckle.InputError) as caught:
                call()
            self.assertIn(message, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))

    def test_changes_are_the_same_every_time(self):
        def thrown():
            free = simulation(FREE)
            free.step(3)
            free.apply_impulse("box", [1, 2, 3], at=[0.1, 1, 0.2])
            free.set_pose("pair", [2, 2, 2])
            free.step(20)
            return free.hash()

        self.assertEqual(thrown(), thrown())


if __name__ == "__main__":
    unittest.main()
