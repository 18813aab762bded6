"""Milliseconds of a step of the sea, by gp_bench_ocean."""
import json
import os

from programs import from_spread, machine, run, say

PARTS = ("construction", "spectrum and FFTs along x", "FFTs along y and points", "foam",
         "slope moments", "update")


def ocean(build, quick):
    """Three cascades of 256 x 256: each part, and the whole update."""
    say("ocean")
    program = os.path.join(build, "bin", "gp_bench_ocean")
    quiet = machine()
    raw = json.loads(run([program, "--steps", "20" if quick else "120"]))
    return {"machine": quiet, "instructions": raw["instructions"], "threads": raw["threads"],
            "cascades": raw["cascades"], "size": raw["size"],
            "parts": {name: {"wall": from_spread(raw[name]["wall_ms"], "ms"),
                             "core": from_spread(raw[name]["core_ms"], "ms")}
                      for name in PARTS}}
