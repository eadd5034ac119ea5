"""annotations.json of `--export layers`: boxes, masks and joints of figures, of which a wall hides the left half."""
import json
import struct
import unittest

import numpy as np

from runs import Runs
from test_layers import ROOT, Camera, overlay, read_exr

MODEL, PLACE = ROOT / "assets/models/humanoid.glb", np.array([0.3, 0.1, -0.2])
WALL = 0.35  # its right edge [m]
SCENE = {
    "duration": 0.08, "fps": 25, "diameter": 0.05,
    "colliders": [{"type": "box", "position": [WALL - 1, 1, 0.8], "size": [2, 4, 0.1]}],
    "objects": [{"type": "actor", "name": "doll", "file": str(MODEL), "skin": "mesh", "position": PLACE.tolist()},
                {"type": "rigid", "shape": "box", "name": "crate", "size": [0.2, 0.2, 0.2], "position": [1.4, 1, 0],
                 "repeat": {"counts": [1, 2, 1], "spacing": [1, 0.5, 1]}},
                {"type": "actor", "name": "away", "file": str(MODEL), "position": [0, 0, 30], "skin": "mesh"}],
    # From so far away that the wall's edge hides what is left of it, almost.
    "camera": {"position": [WALL, 1, 20], "target": [WALL, 1, 0], "fieldOfView": 7},
    "render": {"width": 320, "height": 240},
}


def joints_of(path):
    """Places of the nodes of a binary glTF file by name, which are not turned at rest."""
    data = path.read_bytes()
    text = json.loads(data[20:20 + struct.unpack_from("<I", data, 12)[0]])
    places = {}

    def visit(node, place):
        place = place + node.get("translation", [0, 0, 0])
        assert np.allclose(node.get("rotation", [0, 0, 0, 1]), [0, 0, 0, 1])
        places[node["name"]] = place
        for child in node.get("children", []):
            visit(text["nodes"][child], place)

    for root in text["scenes"][0]["nodes"]:
        visit(text["nodes"][root], np.zeros(3))
    return places


def mask_of(segmentation):
    values = np.arange(len(segmentation["counts"])) % 2
    height, width = segmentation["size"]
    return np.repeat(values, segmentation["counts"]).reshape(width, height).T.astype(bool)


class Annotations(Runs):
    def setUp(self):
        super().setUp()
        self.render(SCENE, "--export", "layers=data")
        self.data = self.folder / "data"
        self.notes = json.loads((self.data / "annotations.json").read_text())
        self.categories = {c["id"]: c for c in self.notes["categories"]}
        self.camera = Camera(self.data, 1)
        self.first = [a for a in self.notes["annotations"] if a["image_id"] == 1]
        self.doll = next(a for a in self.first if self.categories[a["category_id"]]["name"] == "doll")

    def test_each_image_is_a_frame(self):
        self.assertEqual([(i["id"], i["frame"], i["file_name"], i["width"], i["height"]) for i in self.notes["images"]],
                         [(1, 1, "frame_0001.exr", 320, 240), (2, 2, "frame_0002.exr", 320, 240)])
        self.assertEqual([a["id"] for a in self.notes["annotations"]], list(range(1, 7)))

    def test_copies_are_of_one_category_and_what_is_not_seen_is_left_out(self):
        names = [self.categories[a["category_id"]]["name"] for a in self.first]
        self.assertEqual(names, ["doll", "crate", "crate"])
        self.assertEqual([self.camera.known["objects"][a["object_id"] - 1] for a in self.first],
                         ["doll", "crate_1", "crate_2"])

    def test_boxes_masks_and_areas_are_those_of_the_ids(self):
        layers = read_exr(self.data / "frame_0001.exr")
        for note in self.first:
            shown = layers["id.object"] == note["object_id"]
            rows, columns = np.nonzero(shown)
            box = [columns.min(), rows.min(), columns.max() + 1 - columns.min(), rows.max() + 1 - rows.min()]
            self.assertEqual(note["bbox"], box)
            self.assertEqual(note["area"], shown.sum())
            np.testing.assert_array_equal(mask_of(note["segmentation"]), shown)
            for body in note["bodies"]:
                self.assertEqual(body["area"], (layers["id.body"] == body["body_id"]).sum())
                self.assertEqual(body["name"], self.camera.known["bodies"][body["body_id"] - 1])
            self.assertEqual(sum(body["area"] for body in note["bodies"]), note["area"])

    def test_joints_are_where_the_model_has_them(self):
        category = self.categories[self.doll["category_id"]]
        places = np.reshape(self.doll["keypoints_3d"], (-1, 3))
        joints = joints_of(MODEL)
        self.assertGreater(len(places), 15)
        expected = np.array([joints[name] for name in category["keypoints"]]) + PLACE
        # Particles stand on a lattice, and figures on the ground: the whole may be shifted, by less than a radius.
        np.testing.assert_allclose(places - expected, np.broadcast_to((places - expected).mean(0), places.shape), atol=2e-4)
        self.assertLess(np.abs((places - expected).mean(0)).max(), 0.026)
        self.assertTrue(all(1 <= end <= len(places) for edge in category["skeleton"] for end in edge))

    def test_joints_behind_the_wall_are_hidden(self):
        places, points = np.reshape(self.doll["keypoints_3d"], (-1, 3)), np.reshape(self.doll["keypoints"], (-1, 3))
        np.testing.assert_allclose(points[:, :2], self.camera.picture(places), atol=1e-3)
        self.assertEqual(self.doll["num_keypoints"], len(points))
        # Through the wall's edge goes the camera's own plane; within 2 cm of it surfaces of the bodies may decide.
        clear = np.abs(places[:, 0] - WALL) > 0.02
        np.testing.assert_array_equal(points[clear, 2], np.where(places[clear, 0] < WALL, 1, 2))
        self.assertTrue({1, 2} <= set(points[:, 2]))

    def test_the_example_draws_them(self):
        pixels = overlay(self.data, 1)
        self.assertEqual(pixels.shape, (240, 320, 3))
        points = np.reshape(self.doll["keypoints"], (-1, 3))
        column, row, _ = points[points[:, 2] == 1][0]
        self.assertEqual(tuple(pixels[int(row), int(column)]), (255, 60, 60))


if __name__ == "__main__":
    unittest.main()
