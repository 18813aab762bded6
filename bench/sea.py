"""How far the sea of real-time frames is from references, by gp_bench_sea."""
import json
import os

from programs import from_spread, machine, run, say

PLAIN = ("rmse", "flip", "flicker", "specular_frames", "change")


def sea(build, quick):
    """Errors, histories and the time of the lighting pass, by what moves."""
    say("sea in real time")
    program = os.path.join(build, "bin", "gp_bench_sea")
    quiet = machine()
    options = ["--frames", "8", "--last", "2", "--spp", "8"] if quick else []
    raw = json.loads(run([program, "--json", *options]))
    cases = {name: {**{k: {"value": c[k]} for k in PLAIN},
                    "lighting": from_spread(c["lighting_ms"], "ms")}
             for name, c in raw["cases"].items()}
    return {"machine": quiet, "cases": cases,
            **{k: raw[k] for k in ("size", "frames", "last", "samples")}}
