#!/usr/bin/env python3
"""Whether bench/agreement.py finds what it is there to find: pictures of one scene with noise
agree; brighter, shifted or stained ones do not. And that the benchmark's glTF files come back as
written."""
import json
import os
import random
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import agreement
from gltf_file import GltfFile

WIDTH, HEIGHT, NOISE = 96, 64, 0.05


def scene(x, y):
    """A gradient with a dark square in it."""
    dark = 20 <= x < 60 and 20 <= y < 40
    return (0.1 if dark else 0.6) + 0.4 * x / WIDTH


def picture(seed, change=lambda value, x, y: value, shift=0):
    noise = random.Random(seed)
    plane = [change(scene(x + shift, y), x, y) + noise.gauss(0, NOISE)
             for y in range(HEIGHT) for x in range(WIDTH)]
    return WIDTH, HEIGHT, [plane, plane, plane]


class Agreement(unittest.TestCase):
    def compare(self, **theirs):
        pictures = {"ours-1": picture(1), "ours-2": picture(2),
                    "cycles-1": picture(3, **theirs), "cycles-2": picture(4, **theirs)}
        original = agreement.read_exr
        agreement.read_exr = pictures.get
        try:
            return agreement.compare(["ours-1", "ours-2"], ["cycles-1", "cycles-2"])
        finally:
            agreement.read_exr = original

    def test_noise_agrees(self):
        result = self.compare()
        self.assertTrue(result["met"], result["worst"])
        self.assertEqual(result["blocks"], WIDTH * HEIGHT // 256)

    def test_brighter_does_not(self):
        self.assertFalse(self.compare(change=lambda v, x, y: 1.015 * v)["met"])

    def test_shifted_does_not(self):
        result = self.compare(shift=1)
        self.assertFalse(result["met"])
        self.assertGreater(result["unexplained"], 0)

    def test_stain_does_not(self):
        stained = self.compare(change=lambda v, x, y: 1.05 * v if x // 16 == y // 16 == 3 else v)
        self.assertEqual(stained["unexplained"], 1)
        self.assertFalse(stained["met"])


class Gltf(unittest.TestCase):
    def test_ground_and_materials(self):
        doc = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
               "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {}}]}]}
        with tempfile.TemporaryDirectory() as folder:
            source, target = (os.path.join(folder, n) for n in ("in.gltf", "out.glb"))
            with open(source, "w", encoding="utf-8") as file:
                json.dump(doc, file)
            gltf = GltfFile(source)
            gltf.fill_missing_materials()
            gltf.add_ground((1.0, 2.0), 3.0, -1.0)
            gltf.write(target)
            again = GltfFile(target)
        self.assertEqual(again.doc["scenes"][0]["nodes"], [0, 1])
        self.assertEqual([m["name"] for m in again.doc["materials"]], ["default", "ground"])
        ground = again.doc["accessors"][again.primitives()[1]["attributes"]["POSITION"]]
        self.assertEqual((ground["min"], ground["max"]), ([-2.0, -1.0, -1.0], [4.0, -1.0, 5.0]))
        self.assertEqual(bytes(again.blob[:len(gltf.blob)]), bytes(gltf.blob))


if __name__ == "__main__":
    unittest.main()
