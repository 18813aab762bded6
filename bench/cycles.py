"""Cycles on the scenes of the benchmark, by the script beside the checkout."""
import json
import os

from programs import CYCLES_SCRIPT, ENVIRONMENT, ProgramFailed, run, say
from scenes import HEIGHT, WIDTH, triple


def cycles_is_here(programs):
    if not programs.blender:
        say("bench: blender is not installed: nothing is compared with Cycles")
    elif not os.path.exists(CYCLES_SCRIPT):
        say("bench: shared/bench/cycles_bench.py is not beside the checkout: no Cycles")
    else:
        return True
    return False


def cycles_seconds(programs, scene, samples, output):
    """Wall seconds and core-seconds of one render, scene and structures already there. Includes
    what Cycles does for every picture: synchronising and saving."""
    command = [programs.blender, "-b", "--factory-startup", "-P", CYCLES_SCRIPT, "--",
               "--gltf", scene.asset, "--env", ENVIRONMENT, "--out", output, "--w", str(WIDTH),
               "--h", str(HEIGHT), "--spp", str(samples), "--threads", str(programs.threads),
               "--runs", "1"]
    if scene.ground:
        command.append("--ground")
    if "position" in scene.camera:
        # One word each: Blender's parser would take a leading minus for an option.
        command += [f"--cam-pos={triple(scene.camera['position'])}",
                    f"--cam-target={triple(scene.camera['target'])}",
                    f"--fov={scene.camera['fov']}"]
    printed = run(command)
    for line in printed.splitlines():
        if line.startswith("RESULT "):
            result = json.loads(line[7:])
            return result["runs_s"][0], result["cpu_s"][0]
    # Blender ends well even when its script did not.
    faults = [line for line in printed.splitlines() if "Error" in line] or ["no RESULT"]
    raise ProgramFailed("blender: " + faults[-1])
