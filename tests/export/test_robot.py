"""Figures for simulators of robots: read by MuJoCo and by ROS' check_urdf, where those are there."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

import numpy as np

from runs import PROGRAM, Runs

CHECK = pathlib.Path(os.environ.get("MUJOCO_CHECK", pathlib.Path(PROGRAM).parent / "mujoco_check"))
if not CHECK.exists():
    print("built without MuJoCo (libmujoco-dev): what it reads of figures is not tested", file=sys.stderr)
if not shutil.which("check_urdf"):
    print("no check_urdf (liburdfdom-tools): its word on URDF is not asked", file=sys.stderr)
MODELS = pathlib.Path(__file__).resolve().parents[2] / "assets/models"
UPRIGHT = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
GRAVITY, STEP = 9.81, 0.002  # MuJoCo's own


def parents_of(actor):
    names = [body["name"] for body in actor["bodies"]] + ["world"]  # which is that of number -1
    return {body["name"]: names[body["parent"]] for body in actor["bodies"]}


class Robot(Runs):
    def voxelize(self, name, file):
        result = self.knuckle("-q", "voxelize", str(MODELS / f"{name}.glb"), "-o", file)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return self.folder / file

    def load(self, file, speed=0, *more):
        """Bodies and joints by their names, and what came of a second with a speed of all hinges."""
        result = subprocess.run([CHECK, file, "1", str(speed), *more], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        bodies, joints = {}, {}
        for line in result.stdout.splitlines():
            words = line.split()
            if words[0] == "body":
                numbers = np.array(words[1:14], float)
                bodies[words[15]] = {"mass": numbers[0], "centre": numbers[1:4], "inertia": numbers[4:].reshape(3, 3),
                                     "parent": words[14]}
            elif words[0] == "joint":
                joints[words[9]] = {"type": words[1], "axis": np.array(words[2:5], float),
                                    "range": np.array(words[6:8], float) if words[5] == "1" else None,
                                    "body": words[8]}
        return bodies, joints, np.array(words[1:], float)

    def expect_bodies(self, actor, bodies, origin):
        """Masses, centres and inertias as the actor's own file says them, with the balls' own inertia."""
        for body in actor["bodies"]:
            read, mass = bodies[body["name"]], body["mass"]
            self.assertAlmostEqual(read["mass"] / mass, 1, delta=1e-4)
            np.testing.assert_allclose(read["centre"], UPRIGHT @ body["centre"] - origin, atol=1e-5)
            inertia = UPRIGHT @ body["inertia"] @ UPRIGHT.T + 0.1 * mass * actor["diameter"] ** 2 * np.eye(3)
            np.testing.assert_allclose(read["inertia"], inertia, atol=1e-4 * np.trace(inertia))

    def expect_joints(self, actor, joints):
        hinges = 0
        for joint in actor["joints"]:
            child = actor["bodies"][joint["child"]]["name"]
            if joint["type"] == "hinge":
                read = joints[joint["name"]]
                np.testing.assert_allclose(read["axis"], UPRIGHT @ joint["axis"], atol=1e-5)
                np.testing.assert_allclose(read["range"], np.radians(joint["limits"]["bend"]), atol=1e-5)
                hinges += 1
            elif joint["type"] == "ball":
                twist = joints[joint["name"] + "_twist"]
                self.assertEqual(twist["body"], child)
                np.testing.assert_allclose(twist["axis"], UPRIGHT @ joint["axis"], atol=1e-5)
                np.testing.assert_allclose(twist["range"], np.radians(joint["limits"]["twist"]), atol=1e-5)
        return hinges

    @unittest.skipUnless(CHECK.exists(), "MuJoCo is not here")
    def test_mujoco_has_the_bodies_and_joints_of_mjcf(self):
        hinges = 0
        for name in ("humanoid", "dog", "spider"):
            actor = json.loads(self.voxelize(name, "actor.json").read_text())
            file = self.voxelize(name, "figure.mjcf")
            bodies, joints, (steps, warnings, fallen, beyond) = self.load(file)
            self.assertEqual({name: body["parent"] for name, body in bodies.items()}, parents_of(actor))
            self.expect_bodies(actor, bodies, 0)
            hinges += self.expect_joints(actor, joints)
            # Freely, by MuJoCo's steps: a sum of velocities. Nothing touches and nothing turns.
            self.assertEqual((steps, warnings), (1 / STEP, 0))
            self.assertAlmostEqual(fallen, GRAVITY * STEP ** 2 * steps * (steps + 1) / 2, delta=1e-4)
            self.assertLess(beyond, 1e-4)
            # Into its limits, which MuJoCo makes soft.
            for speed, most in ((2, 0.6), (5, 1.2), (-5, 1.2)):
                _, _, (steps, warnings, _, beyond) = self.load(file, speed)
                self.assertEqual((steps, warnings), (1 / STEP, 0), f"{name} at {speed} rad/s")
                self.assertLess(beyond, most, f"{name} at {speed} rad/s")
        self.assertGreater(hinges, 10)

    @unittest.skipUnless(CHECK.exists(), "MuJoCo is not here")
    def test_mujoco_has_the_bodies_and_joints_of_urdf(self):
        for name in ("humanoid", "dog", "spider"):
            actor = json.loads(self.voxelize(name, "actor.json").read_text())
            file = self.voxelize(name, "figure.urdf")
            # Else the first link, which MuJoCo hangs on the world, would lose its name.
            keep = '<mujoco><compiler fusestatic="false"/></mujoco></robot>'
            file.write_text(file.read_text().replace("</robot>", keep))
            bodies, joints, (steps, warnings, _, beyond) = self.load(file, 2, "through")
            between = [link for link in bodies if "_between_" in link]  # of 1 g each
            above = {link: bodies[link]["parent"] for link in bodies}
            for link in between:
                above = {other: above[link] if parent == link else parent for other, parent in above.items()}
            self.assertEqual({link: above[link] for link in above if link not in between}, parents_of(actor))
            self.assertAlmostEqual(sum(body["mass"] for body in bodies.values()) - 1e-3 * len(between),
                                   sum(body["mass"] for body in actor["bodies"]), delta=1e-3)
            self.expect_bodies(actor, bodies, UPRIGHT @ actor["bodies"][0]["centre"])
            self.expect_joints(actor, joints)
            self.assertEqual((steps, warnings), (1 / STEP, 0))
            self.assertLess(beyond, 1.2)

    @unittest.skipUnless(shutil.which("check_urdf"), "check_urdf is not here")
    def test_check_urdf_finds_the_tree(self):
        actor = json.loads(self.voxelize("humanoid", "actor.json").read_text())
        file = self.voxelize("humanoid", "figure.urdf")
        result = subprocess.run(["check_urdf", file], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("root Link: hips has 3 child(ren)", result.stdout)
        for body in actor["bodies"][1:]:
            self.assertRegex(result.stdout, rf"child\(\d\):  {re.escape(body['name'])}\n")


if __name__ == "__main__":
    unittest.main()
