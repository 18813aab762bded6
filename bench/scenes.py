"""The scenes of the benchmark: where they come from, camera, light.

The three scenes against Cycles follow the Cycles script (camera, sun, ground plane), whose axes are
Blender's: (x, y, z) there is (x, z, -y) here.
"""
import math
import os

from gltf_file import GltfFile
from programs import ASSETS, ENVIRONMENT, run, say

WIDTH, HEIGHT = 640, 360
LUMENS_PER_WATT = 683.0
SUN_WATTS = 3.0           # W/m^2 on a plane that faces it
SUN_TRAVELS = (-0.4, 0.5, -1.0)      # Blender's axes
CAMERA_DIRECTION = (0.6, -1.0, 0.35)  # from the middle of the scene
CAMERA_FOV = 45.0         # horizontal, degrees
# Blender's picture begins at +X where ours begins at -Z: a quarter of a turn clockwise.
ENVIRONMENT_ROTATION = -90.0

# bounces: of ours. Cycles ends a path after 1 diffuse and 1 glossy bounce, at most 2 together. A
# purely diffuse scene has the same paths with our 1; others get 2, which also follows diffuse to
# diffuse.
PEER_SCENES = [
    {"name": "DamagedHelmet", "asset": "DamagedHelmet/DamagedHelmet.glb", "ground": True,
     "bounces": 2},
    {"name": "Zdm2", "asset": "Zdm2/zdm2.glb", "ground": False, "bounces": 1, "fov": 91.5,
     "position": (11.7976, -9.5425, 1.499), "target": (11.45, -14.5, 1.0)},
    {"name": "DutchShipMedium", "asset": "DutchShipMedium/dutch_ship_medium_1k.gltf",
     "ground": True, "bounces": 2},
]
FLIGHT_HELMET = {"name": "FlightHelmet", "asset": "FlightHelmet/FlightHelmet.gltf",
                 "ground": True, "bounces": 2}


def from_blender(v):
    return (v[0], v[2], -v[1])


def triple(v):
    return ",".join(f"{x:.6g}" for x in v)


def vertical_fov(horizontal):
    half = math.tan(math.radians(horizontal) / 2) * HEIGHT / WIDTH
    return math.degrees(2 * math.atan(half))


def sun_angles():
    """Azimuth from -Z towards +X and elevation, degrees, of the side where the sun stands."""
    x, y, z = (-c for c in from_blender(SUN_TRAVELS))
    return math.degrees(math.atan2(x, -z)), math.degrees(math.atan2(y, math.hypot(x, z)))


def camera_of(description, lo, hi):
    """Position, target and vertical angle, as the Cycles script places its camera."""
    fov = vertical_fov(description.get("fov", CAMERA_FOV))
    if "position" in description:
        return from_blender(description["position"]), from_blender(description["target"]), fov
    centre = [(a + b) / 2 for a, b in zip(lo, hi)]
    radius = math.dist(lo, hi) / 2
    direction = from_blender(CAMERA_DIRECTION)
    distance = radius / math.sin(math.radians(fov) / 2) / math.hypot(*direction)
    return [c + d * distance for c, d in zip(centre, direction)], centre, fov


class BenchScene:
    """A file, and the options that light it and look at it."""

    def __init__(self, name, path, bounces, asset=None, options=(), ray_options=()):
        self.name, self.path, self.bounces, self.asset = name, path, bounces, asset
        self.options, self.ray_options = list(options), list(ray_options)
        self.ground = False


def prepare_peer_scene(programs, description, folder):
    """Writes the scene with its ground as one .glb; None where the asset is missing."""
    asset = os.path.join(ASSETS, description["asset"])
    if not os.path.exists(asset) or not os.path.exists(ENVIRONMENT):
        say(f"bench: {description['name']} is not beside the checkout: left out")
        return None
    totals = programs.info(asset)
    lo, hi = totals["bounds_min"], totals["bounds_max"]
    gltf = GltfFile(asset)
    gltf.fill_missing_materials()
    if description["ground"]:
        gltf.add_ground(((lo[0] + hi[0]) / 2, (lo[2] + hi[2]) / 2), math.dist(lo, hi) * 5, lo[1])
    path = os.path.join(folder, description["name"] + ".glb")
    gltf.write(path)
    position, target, fov = camera_of(description, lo, hi)
    azimuth, elevation = sun_angles()
    common = [f"--env={ENVIRONMENT}", f"--env-rotation={ENVIRONMENT_ROTATION}",
              f"--from={triple(position)}", f"--look-at={triple(target)}", f"--fov={fov:.6g}"]
    scene = BenchScene(description["name"], path, description["bounces"], asset)
    sun = f"--sun={azimuth:.6g},{elevation:.6g}"
    scene.options = common + [f"{sun},{SUN_WATTS * LUMENS_PER_WATT:.6g}"]
    scene.ray_options = common + [f"{sun},{SUN_WATTS:.6g}"]
    scene.ground = description["ground"]
    scene.camera = description
    return scene


def own_scene(programs, name, folder, *parameters):
    """One of the project's generated scenes, with its own camera and light."""
    path = os.path.join(folder, name + ".glb")
    run([programs.tool, "make-scene", name, "-o", path, *parameters])
    return BenchScene(name, path, 4)
