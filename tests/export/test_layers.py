"""`--export layers`: depth, normals, ids and motion of known things by closed form; the same files from stored states,
from a part of a run, and of each camera."""
import json
import pathlib
import sys
import unittest

import numpy as np

from runs import Runs, read_ply

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/example"))
from overlay_ids import overlay, read_exr

SPEED, RATE, RADIUS, BALL = np.array([0.9, 0.3, -0.6]), 50, 0.25, np.array([-0.3, 0.9, 0.3])
STONE, STONE_RADIUS = np.array([0.6, 0.5, -0.4]), 0.4
# A ball flies in front of a plane and a stone; without weight.
BALLS = {
    "duration": 0.1, "fps": RATE, "solver": {"gravity": [0, 0, 0]},
    "materials": {"steel": {"draw": "shape", "density": 7800}},
    "colliders": [{"type": "plane"}, {"type": "sphere", "position": STONE.tolist(), "radius": STONE_RADIUS}],
    "objects": [{"type": "rigid", "shape": "sphere", "name": "ball", "radius": RADIUS, "position": BALL.tolist(),
                 "velocity": SPEED.tolist(), "material": "steel"}],
    "render": {"width": 160, "height": 90},
    "camera": {"position": [0.4, 1.6, 3], "target": [0.1, 0.7, 0], "fieldOfView": 50},
}


def sphere_depth(origin, rays, centre, radius):
    """Along each ray, whose depth is 1; infinity beside the sphere. And how far within it the ray goes, as a share."""
    to = centre - origin
    square = (rays * rays).sum(-1)
    along = (rays @ to) / square
    inside = radius**2 - ((to - along[..., None] * rays)**2).sum(-1)
    return np.where(inside > 0, along - np.sqrt(np.maximum(inside, 0) / square), np.inf), inside / radius**2


class Camera:
    """What camera.json says of a frame."""

    def __init__(self, folder, frame):
        text = json.loads((folder / "camera.json").read_text())
        self.known = text
        self.__dict__.update(next(f for f in text["frames"] if f["frame"] == frame))
        self.matrix = np.array(self.camera_to_world)
        self.origin = self.matrix[:3, 3]

    def rays(self):
        """In the world, of pixels' middles, with a depth of 1."""
        x, y = np.meshgrid(np.arange(self.width) + 0.5, np.arange(self.height) + 0.5)
        own = np.stack([(x - self.cx) / self.fx, (self.cy - y) / self.fy, np.full_like(x, -1)], -1)
        return own @ self.matrix[:3, :3].T

    def places(self, layers):
        """In the world, of what pixels show; far away where they show nothing."""
        depth = layers["depth.Z"].astype(float)
        return self.origin + self.rays() * np.where(np.isinf(depth), 1e7, depth)[..., None]

    def picture(self, places):
        """Columns and rows of places in the world."""
        own = (places - self.origin) @ self.matrix[:3, :3]
        return np.stack([self.cx - self.fx * own[..., 0] / own[..., 2], self.cy + self.fy * own[..., 1] / own[..., 2]], -1)


def vectors(layers, name, axes="XYZ"):
    return np.stack([layers[f"{name}.{axis}"] for axis in axes], -1)


class KnownThings(Runs):
    def setUp(self):
        super().setUp()
        self.render(BALLS, "--export", "layers=data")
        self.data = self.folder / "data"

    def shown(self, frame):
        """Layers, the camera, the ball's centre, and the pixels of the plane, the stone and the ball."""
        layers, camera = read_exr(self.data / f"frame_{frame:04}.exr"), Camera(self.data, frame)
        ball, rays = BALL + SPEED * (frame - 1) / RATE, camera.rays()
        with np.errstate(divide="ignore"):
            plane = np.where(rays[..., 1] < 0, -camera.origin[1] / rays[..., 1], np.inf)
        spheres = [sphere_depth(camera.origin, rays, c, r) for c, r in ((STONE, STONE_RADIUS), (ball, RADIUS))]
        depths = np.stack([plane] + [depth for depth, _ in spheres])
        # Not within a thousandth of an edge, where rounding decides, and the square root has few digits.
        clear = np.all([np.abs(inside) > 1e-3 for _, inside in spheres], axis=0)
        clear &= np.isinf(plane) | (plane < 2e3)
        return layers, camera, ball, depths, clear

    def test_the_camera_is_where_the_scene_has_it(self):
        camera = Camera(self.data, 3)
        np.testing.assert_allclose(camera.origin, [0.4, 1.6, 3], atol=1e-6)
        way = np.array([0.1, 0.7, 0]) - camera.origin
        np.testing.assert_allclose(-camera.matrix[:3, 2], way / np.linalg.norm(way), atol=1e-6)
        np.testing.assert_allclose(camera.matrix[:3, :3].T @ camera.matrix[:3, :3], np.eye(3), atol=1e-6)
        np.testing.assert_allclose(camera.fy, 45 / np.tan(np.radians(25)), rtol=1e-6)
        self.assertEqual((camera.fx, camera.cx, camera.cy, camera.time), (camera.fy, 80, 45, 0.04))

    def test_depth_is_that_of_what_is_nearest(self):
        for frame in (1, 5):
            layers, _, _, depths, clear = self.shown(frame)
            expected, got = depths.min(0), layers["depth.Z"]
            self.assertEqual(got.dtype, np.float32)
            np.testing.assert_array_equal(np.isinf(got[clear]), np.isinf(expected[clear]))
            known = clear & np.isfinite(expected)
            self.assertGreater(known.sum(), 9000)
            # 32-bit floats have 2^-24 of a value; the root at an edge, within 1e-3, may lose 1 / (2 sqrt(1e-3)) = 16 of
            # them, and the ray's sums a few more.
            np.testing.assert_allclose(got[known], expected[known], rtol=1e-5)

    def test_normals_are_those_of_spheres_and_plane(self):
        layers, camera, ball, depths, clear = self.shown(4)
        normals, ids = vectors(layers, "normal"), vectors(layers, "id", ("collider", "body"))
        places = camera.places(layers)
        for which, exact in ((ids[..., 0] == 1, np.array([0, 1, 0])), (ids[..., 0] == 2, (places - STONE) / STONE_RADIUS),
                             (ids[..., 1] == 1, (places - ball) / RADIUS)):
            which = which & clear
            self.assertGreater(which.sum(), 200)
            # 16 bits a coordinate of the octahedral map: half of 1 / 32767, by its slope of at most 3, in both.
            np.testing.assert_allclose(normals[which], np.broadcast_to(exact, normals.shape)[which], atol=1.5e-4)
        nothing = np.isinf(layers["depth.Z"])
        self.assertEqual(np.abs(normals[nothing]).sum(), 0)

    def test_ids_are_those_of_the_scene(self):
        layers, camera, _, depths, clear = self.shown(2)
        nearest = np.where(np.isinf(depths.min(0)), -1, depths.argmin(0))
        for name, of_plane, of_stone, of_ball in (("collider", 1, 2, 0), ("object", 0, 0, 1), ("body", 0, 0, 1),
                                                  ("material", 0, 0, 1), ("particle", 0, 0, 0)):
            ids = layers["id." + name]
            self.assertEqual(ids.dtype, np.uint32)
            for which, id in ((-1, 0), (0, of_plane), (1, of_stone), (2, of_ball)):
                self.assertEqual(set(ids[clear & (nearest == which)]), {id}, name)
        self.assertEqual(camera.known["objects"], ["ball"])
        self.assertEqual(camera.known["materials"][0], "steel")

    def test_motion_is_that_of_the_ball_alone(self):
        for frame in (1, 2, 5):
            layers, camera, _, _, clear = self.shown(frame)
            motion, ball = vectors(layers, "motion", "XY"), (layers["id.body"] == 1) & clear
            if frame == 1:
                self.assertEqual(np.abs(motion).max(), 0)
                continue
            places = camera.places(layers)
            expected = camera.picture(places) - camera.picture(places - SPEED / RATE)
            self.assertGreater(np.linalg.norm(expected[ball], axis=-1).min(), 0.4)
            # The solver's floats: a millionth of a metre at 2 m is a ten-thousandth of a pixel.
            np.testing.assert_allclose(motion[ball], expected[ball], atol=0.005)
            self.assertLess(np.abs(motion[layers["id.body"] == 0]).max(), 0.001)

    def test_colours_are_without_light(self):
        layers, *_ = self.shown(1)
        albedo = vectors(layers, "albedo", "RGB")
        self.assertEqual(len(np.unique(albedo[layers["id.body"] == 1], axis=0)), 1)
        self.assertEqual(len(np.unique(albedo[layers["id.collider"] == 2], axis=0)), 1)

    def test_a_part_of_the_run_and_stored_states_give_the_same_files(self):
        self.render(BALLS, "--export", "layers=part", "--frames", "3:4", "--record", "states=run.states")
        self.render(BALLS, "--record", "states=run.states")
        self.assertEqual(self.knuckle("render", "--from", "run.states", "-o", "drawn", "--export",
                                      "layers=stored").returncode, 0)
        for name in ("part/frame_0003.exr", "part/frame_0004.exr", "stored/frame_0001.exr", "stored/frame_0005.exr",
                     "stored/camera.json", "stored/annotations.json"):
            self.assertEqual((self.folder / name).read_bytes(), (self.data / pathlib.Path(name).name).read_bytes(), name)

    def test_each_camera_has_a_folder(self):
        scene = BALLS | {"cameras": {"above": {"position": [0, 5, 0.1], "target": [0, 0, 0]}}}
        self.render(scene, "-o", "out", "--camera", "above=above", "--export", "layers=two", "--frames", "2:2")
        self.assertEqual((self.folder / "two/frame_0002.exr").read_bytes(), (self.data / "frame_0002.exr").read_bytes())
        np.testing.assert_allclose(Camera(self.folder / "two/above", 2).origin, [0, 5, 0.1], atol=1e-6)

    def test_a_camera_that_turns_moves_what_stands(self):
        scene = BALLS | {"camera": {"kind": "orbit", "position": [0.4, 1.6, 3], "target": [0, 0.5, 0], "orbitSpeed": 60}}
        self.render(scene, "--export", "layers=turn", "--frames", "3:3")
        self.render(scene, "--export", "layers=all")
        layers, camera = read_exr(self.folder / "turn/frame_0003.exr"), Camera(self.folder / "turn", 3)
        before = Camera(self.folder / "all", 2)
        still = layers["id.collider"] > 0
        places = camera.places(layers)
        expected = (camera.picture(places) - before.picture(places))[still]
        self.assertGreater(np.abs(expected).max(), 1)
        # A place at a depth of 2 km is known to a tenth of a millimetre.
        np.testing.assert_allclose(vectors(layers, "motion", "XY")[still], expected, atol=0.01)
        sky = np.isinf(layers["depth.Z"])
        expected = (camera.picture(places) - before.picture(places))[sky]
        np.testing.assert_allclose(vectors(layers, "motion", "XY")[sky], expected, atol=0.01)

    def test_refuses_a_folder_that_cannot_be_written(self):
        (self.folder / "file").write_text("")
        self.assertIn("file", self.refused(BALLS, "--export", "layers=file"))
        self.assertIn("frames are written into a folder", self.refused(BALLS, "--export", "layers=a.exr"))


# One of each kind of matter in a row, falling freely: all go equally far from frame to frame.
KINDS = ["skin", "particles", "shape", "glass", "cloth", "soft", "rope", "grains", "pool"]
FALLING = {
    "duration": 0.13, "fps": 25, "diameter": 0.06,
    "materials": {"glass": {"draw": "shape", "finish": "glass"}},
    "objects": [
        {"type": "actor", "name": "skin", "file": str(ROOT / "assets/models/humanoid.glb"), "skin": "mesh",
         "position": [-2.4, 2, 0]},
        {"type": "rigid", "shape": "box", "name": "particles", "size": [0.4, 0.4, 0.4], "position": [-1.5, 3, 0]},
        {"type": "rigid", "shape": "box", "name": "shape", "size": [0.4, 0.4, 0.4], "position": [-0.9, 3, 0],
         "draw": "shape"},
        {"type": "rigid", "shape": "box", "name": "glass", "size": [0.4, 0.4, 0.4], "position": [-0.9, 2.4, 0],
         "material": "glass"},
        {"type": "cloth", "name": "cloth", "size": [0.5, 0.5], "position": [-0.2, 3, 0], "rotation": [60, 0, 0],
         "draw": "surface"},
        {"type": "soft", "shape": "box", "name": "soft", "size": [0.4, 0.4, 0.4], "position": [0.5, 3, 0],
         "draw": "surface"},
        {"type": "rope", "name": "rope", "from": [1, 3.3, 0], "to": [1.4, 2.4, 0], "draw": "shape"},
        {"type": "grains", "shape": "box", "name": "grains", "size": [0.3, 0.3, 0.3], "spacing": 0.08,
         "jitter": 0, "position": [1.8, 3, 0]},
        {"type": "fluid", "shape": "box", "name": "pool", "size": [0.5, 0.5, 0.5], "position": [2.6, 3, 0]}],
    "render": {"width": 480, "height": 200},
    "camera": {"position": [0.1, 2.6, 5], "target": [0.1, 2.7, 0], "fieldOfView": 32},
}


class AllKinds(Runs):
    def test_are_there_and_fall_as_one(self):
        self.render(FALLING, "--export", "layers=data", "--export", "ply=ply", "--frames", "2:3")
        data = self.folder / "data"
        layers, camera = read_exr(data / "frame_0003.exr"), Camera(data, 3)
        self.assertEqual(sorted(camera.known["objects"]), sorted(KINDS))
        now, before = (read_ply(self.folder / f"ply/frame_000{n}.ply")["vertex"] for n in (3, 2))
        fallen = np.median(before["y"] - now["y"])
        self.assertLess(np.percentile(np.abs(before["y"] - now["y"] - fallen), 99), 0.002)
        objects, places = layers["id.object"], camera.places(layers)
        motion = vectors(layers, "motion", "XY")
        for kind in KINDS:
            shown = objects == camera.known["objects"].index(kind) + 1
            self.assertGreater(shown.sum(), 80, kind)
            expected = (camera.picture(places) - camera.picture(places + [0, fallen, 0]))[shown]
            self.assertGreater(expected[:, 1].min(), 1.5, kind)
            # Joints, ropes and fluids move a little within.
            self.assertLess(np.abs(np.median(motion[shown], axis=0) - np.median(expected, axis=0)).max(), 0.1, kind)
            self.assertLess(np.percentile(np.abs(motion[shown] - expected), 80), 0.3, kind)
        # Skin and grains show which body and which particle.
        skin = objects == camera.known["objects"].index("skin") + 1
        self.assertGreater(len(set(layers["id.body"][skin])), 6)
        self.assertTrue((layers["id.body"][skin] > 0).all() and (layers["id.particle"][skin] == 0).all())
        loose = objects >= camera.known["objects"].index("grains") + 1
        grains = now["id"][now["body"] < 0]
        self.assertTrue(np.isin(layers["id.particle"][loose] - 1, grains).all())


if __name__ == "__main__":
    unittest.main()
