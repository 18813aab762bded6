"""Milliseconds of a real-time frame, pass by pass, by `glitterpath animate`."""
import json
import os

from programs import from_spread, run, say
from scenes import own_scene

# Name, size of the picture, what is turned on beside the defaults (A-SVGF, anti-aliasing).
CASES = [("corridor", "640x360", []), ("corridor", "320x180", []),
         ("corridor, light reuse", "320x180", ["--light-reuse", "biased"])]
LARGEST = ("largest", "640x360", [])
# What changes in every frame: options of gp_bench_changing.
CHANGES = {"100,000 sphere lights": ["--lights", "100000"],
           "100,000 pentagon lights": ["--lights", "100000", "--corners", "5"],
           "a mesh of 100,000 triangles": ["--triangles", "100000"]}
HERE = os.path.dirname(os.path.abspath(__file__))
PATH = os.path.join(HERE, "..", "data", "paths", "corridor.json")


def frames(programs, scene, size, options, count, folder):
    out = os.path.join(folder, "realtime.json")
    run([programs.tool, "animate", scene.path, "--frames", str(count), "--size", size,
         "--mode", "realtime", "-o", os.path.join(folder, "frame-%04d.png"), "--json", out,
         "--quiet", *scene.options, *options])
    with open(out, encoding="utf-8") as file:
        return json.load(file)


def row(raw):
    milliseconds = raw["milliseconds_per_frame"]
    return {"milliseconds": milliseconds, "passes": raw["passes"],
            "rays_per_frame": raw["rays_per_frame"],
            "mrays_per_second": raw["rays_per_frame"] / milliseconds["mean"] * 1e-3,
            "bytes_per_pixel": raw["frame_image_bytes_per_pixel"]}


def changing(programs, quick):
    """Frames of 320 x 180 in which much changes each time: medians in milliseconds."""
    results = {}
    for name, options in CHANGES.items():
        raw = programs.json([programs.changing, *options, "--frames", "4" if quick else "16"])
        results[name] = {key: from_spread(raw[key], "ms") for key in
                         ("calls_ms", "build_ms", "render_ms", "frame_core_ms")}
    return results


def realtime(programs, largest, folder, quick):
    """The corridor at two sizes, and the scene with the most triangles of `largest` (or none)."""
    say("real time")
    count = 16 if quick else 48
    corridor = own_scene(programs, "corridor", folder)
    corridor.options = ["--path", PATH]
    results = {}
    for name, size, options in CASES:
        results[f"{name} {size}"] = row(frames(programs, corridor, size, options, count, folder))
    if largest is not None:
        name = f"{largest.name} {LARGEST[1]}"
        orbit = ["--path", "orbit", "--orbit-period", "60"]
        results[name] = row(frames(programs, largest, LARGEST[1], orbit, count, folder))
    return results
