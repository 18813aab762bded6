"""Milliseconds of frames of the sea under one light, by gp_bench_water."""
import json
import os

from programs import from_spread, machine, run, say


def water(build, quick):
    """{"smooth": {"share": 1, "core": measured, "wall": measured}, …}, variants in turn."""
    say("water")
    program = os.path.join(build, "bin", "gp_bench_water")
    quiet = machine()
    raw = json.loads(run([program, "--frames", "4" if quick else "24"]))
    return {"machine": quiet, "device": raw["device"], "size": [raw["width"], raw["height"]],
            "variants": {name: {"share": v["share"],
                                "core": from_spread(v["frame_core_ms"], "ms"),
                                "wall": from_spread(v["frame_wall_ms"], "ms")}
                         for name, v in raw["variants"].items()}}
