#!/usr/bin/env python3
"""Speed, measured: everything that scripts/bench prints and writes.

(a) rays a second against bare Embree over the same rays   (b) seconds against Cycles
(c) build times   (d) scaling over threads   (e) peak memory   (f) reflectance models
(g) real-time frames, pass by pass   (h) the sea, part by part, and frames of it
(i) glints by method and footprint   (j) the sea in real time against references
Writes results.json and results.md beside this file (or to --output FOLDER).
"""
import argparse
import json
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import report
from glint import glint
from models import models
from ocean import ocean
from sea import sea
from water import water
from realtime import changing, realtime
from cycles import cycles_is_here, cycles_seconds
from programs import Programs, ProgramFailed, from_spread, machine, measured, say
from scenes import FLIGHT_HELMET, HEIGHT, PEER_SCENES, WIDTH, own_scene, prepare_peer_scene

SIZE = ["--size", f"{WIDTH}x{HEIGHT}"]
MIB = 2.0**20


class Effort:
    def __init__(self, quick):
        self.samples = 8 if quick else 64          # of renders against Cycles
        self.rounds = 1 if quick else 3
        self.ray_samples = 8 if quick else 16
        self.recorded = 1 if quick else 4
        self.ray_runs = 3 if quick else 5
        self.waves = [100000] if quick else [100000, 1000000]


def rays(programs, scenes, effort):
    results = {}
    for scene in scenes:
        say(f"rays: {scene.name}")
        command = [programs.rays, scene.path, "--width", str(WIDTH), "--height", str(HEIGHT),
                   "--spp", str(effort.ray_samples), "--recorded-spp", str(effort.recorded),
                   "--bounces", str(scene.bounces), "--runs", str(effort.ray_runs),
                   "--threads", str(programs.threads), *scene.ray_options]
        raw = programs.json(command)
        rates = {name: from_spread(spread, "Mrays/s")
                 for name, spread in raw["embree_mrays_per_second"].items()}
        results[scene.name] = {
            "bounces": raw["bounces"], "rays": raw["rays"], "device": raw["device"],
            "renderer": from_spread(raw["renderer_mrays_per_second"], "Mrays/s"),
            "embree": rates, "ratio": from_spread(raw["ratio"], "of bare Embree"),
            "renderer_per_core": from_spread(raw["renderer_mrays_per_core_second"],
                                             "Mrays/core-second"),
            "embree_per_core": from_spread(raw["embree_mrays_per_core_second"],
                                           "Mrays/core-second"),
            "ratio_of_core_seconds": from_spread(raw["ratio_of_core_seconds"], "of bare Embree")}
    return results


def ours(programs, scene, folder, *options):
    return programs.render(scene.path, os.path.join(folder, "ours.exr"), *SIZE, *scene.options,
                           *options)


class Race:
    """Seconds of both on one scene: by the wall's clock, and those that threads computed. What a
    picture of 1 sample takes is measured too: Cycles synchronises and saves each picture within its
    seconds, and our process loads the scene within its core-seconds."""

    def __init__(self, programs, scene, effort, folder):
        self.programs, self.scene, self.folder = programs, scene, folder
        self.samples = effort.samples
        self.theirs = [self._theirs(effort.samples)]
        self.mine = [self._mine(effort.samples)]
        for _ in range(effort.rounds - 1):
            self.theirs.append(self._theirs(effort.samples))
            self.mine.append(self._mine(effort.samples))
        self.their_start, self.my_start = self._theirs(1), self._mine(1)
        self.other = self._mine(effort.samples, 3 - scene.bounces)

    def _theirs(self, samples):
        return cycles_seconds(self.programs, self.scene, samples,
                              os.path.join(self.folder, "cycles"))

    def _mine(self, samples, bounces=None):
        return ours(self.programs, self.scene, self.folder, "--spp", str(samples),
                    "--bounces", str(bounces or self.scene.bounces))

    def rates(self, seconds, samples):
        return [WIDTH * HEIGHT * samples * 1e-6 / max(t, 1e-3) for t in seconds]

    def result(self):
        n = self.samples
        mine = self.rates([r["seconds"]["render"] for r in self.mine], n)
        gross = self.rates([t[0] for t in self.theirs], n)
        net = self.rates([t[0] - self.their_start[0] for t in self.theirs], n - 1)
        my_core = self.rates([r["core_seconds"] - self.my_start["core_seconds"]
                              for r in self.mine], n - 1)
        their_core = self.rates([t[1] - self.their_start[1] for t in self.theirs], n - 1)
        other = self.rates([self.other["seconds"]["render"]], n)
        return {
            "samples_per_pixel": n, "bounces": self.scene.bounces, "rays": self.mine[-1]["rays"],
            "glitterpath": measured(mine, "Msamples/s"), "cycles": measured(gross, "Msamples/s"),
            "cycles_samples_alone": measured(net, "Msamples/s"),
            "ratio": measured([a / b for a, b in zip(mine, net)], "times Cycles, samples alone"),
            "ratio_with_overhead": measured([a / b for a, b in zip(mine, gross)], "times Cycles"),
            "glitterpath_per_core": measured(my_core, "Msamples/core-second"),
            "cycles_per_core": measured(their_core, "Msamples/core-second"),
            "ratio_of_core_seconds": measured([a / b for a, b in zip(my_core, their_core)],
                                              "times Cycles, samples alone"),
            "other_limit": {"bounces": 3 - self.scene.bounces, "rays": self.other["rays"],
                            "glitterpath": measured(other, "Msamples/s")}}


def against_cycles(programs, scenes, effort, folder):
    results = {}
    for scene in scenes:
        say(f"Cycles: {scene.name}")
        results[scene.name] = Race(programs, scene, effort, folder).result()
    return results


def plain_diffuse(programs, scene, effort, folder):
    """Paths of length 2, as of Embree's tutorial path tracer: under the environment and sun, and
    under one ambient light."""
    say("plain diffuse: " + scene.name)
    options = ["--shading", "diffuse", "--bounces", "1", "--spp", str(effort.samples)]
    camera = [o for o in scene.options if not o.startswith(("--env", "--sun"))]
    results = {"environment_and_sun": [], "ambient_light": []}
    for _ in range(effort.rounds):
        results["environment_and_sun"].append(
            ours(programs, scene, folder, *options)["msamples_per_second"])
        results["ambient_light"].append(
            programs.render(scene.path, os.path.join(folder, "ours.exr"), *SIZE, *camera,
                            "--env-color", "1,1,1", *options)["msamples_per_second"])
    return {name: measured(values, "Msamples/s") for name, values in results.items()}


def build_times(programs, scenes, effort):
    say("build times")
    results = {}
    for scene in scenes:
        command = [programs.rays, scene.path, "--width", "64", "--height", "64", "--spp", "1",
                   "--recorded-spp", "1", "--bounces", "1", "--runs", "7", "--build-times",
                   *scene.ray_options]
        if scene is scenes[0]:
            command += ["--waves", ",".join(str(n) for n in effort.waves)]
        for name, times in programs.json(command)["build_times"].items():
            results[scene.name if name == "largest_mesh" else name] = {
                "triangles": times["triangles"],
                **{k: {"value": v, "unit": "ms", "runs": 7} for k, v in times.items()
                   if k != "triangles"}}
    return results


def scaling(programs, scenes, effort, folder):
    say("scaling over threads")
    results = {}
    for scene in scenes:
        rates = {}
        for threads in range(1, programs.threads + 1):
            values = [ours(programs, scene, folder, "--spp", str(effort.samples // 2), "--bounces",
                           str(scene.bounces), "--threads", str(threads))["msamples_per_second"]
                      for _ in range(effort.rounds)]
            rates[str(threads)] = measured(values, "Msamples/s")
        results[scene.name] = rates
    return results


def memory(programs, scenes, folder):
    """Peak of the whole process against what the scene needs. The program alone: a small scene's
    peak less what that scene needs itself."""
    say("memory")
    furnace = own_scene(programs, "furnace", folder)
    small = programs.render(furnace.path, os.path.join(folder, "ours.exr"), "--size", "16x16",
                            "--spp", "1", "--env-color", "1,1,1")
    furnace_totals = programs.info(furnace.path)
    program = (small["peak_memory_bytes"] - small["acceleration_bytes"] - small["frame_bytes"]
               - furnace_totals["geometry_bytes"] - furnace_totals["texture_bytes"])
    results = {"program_alone": {"value": program / MIB, "unit": "MiB"}}
    for scene in scenes:
        totals = programs.info(scene.path)
        run = ours(programs, scene, folder, "--spp", "2", "--bounces", str(scene.bounces))
        needed = totals["geometry_bytes"] + totals["texture_bytes"] + run["acceleration_bytes"]
        results[scene.name] = {
            "peak": {"value": run["peak_memory_bytes"] / MIB, "unit": "MiB"},
            "geometry": {"value": totals["geometry_bytes"] / MIB, "unit": "MiB"},
            "textures": {"value": totals["texture_bytes"] / MIB, "unit": "MiB"},
            "embree": {"value": run["acceleration_bytes"] / MIB, "unit": "MiB"},
            "frame": {"value": run["frame_bytes"] / MIB, "unit": "MiB"},
            "ratio": {"value": run["peak_memory_bytes"] / needed, "unit": "of what is needed"},
            "ratio_without_program_and_frame": {
                "value": (run["peak_memory_bytes"] - program - run["frame_bytes"]) / needed,
                "unit": "of what is needed"}}
    return results


def arguments():
    parser = argparse.ArgumentParser(prog="scripts/bench", description=__doc__.split("\n")[0])
    parser.add_argument("--quick", action="store_true", help="fewer samples, one round")
    parser.add_argument("--scenes", default="", help="only these, with commas between them")
    parser.add_argument("--no-cycles", action="store_true", help="do not run Blender")
    parser.add_argument("--only", choices=["bsdf", "realtime", "ocean", "glint", "water", "sea"],
                        help="measure the reflectance models, real-time frames, the sea, "
                             "glints, frames of water, or the sea in real time, alone; the rest "
                             "of results.json stays")
    parser.add_argument("--build", default="build/release", help="build tree (default %(default)s)")
    parser.add_argument("--output", default=os.path.dirname(os.path.abspath(__file__)),
                        help="folder for results.json and results.md (default bench/)")
    return parser.parse_args()


def chosen_scenes(programs, args, folder):
    wanted = [name for name in args.scenes.split(",") if name]
    peers = [prepare_peer_scene(programs, d, folder) for d in PEER_SCENES + [FLIGHT_HELMET]
             if not wanted or d["name"] in wanted]
    scenes = [s for s in peers if s is not None]
    own = [] if peers and scenes else ["room"]   # without the assets, two scenes of our own
    scenes += [own_scene(programs, name, folder) for name in ["still-life"] + own
               if not wanted or name in wanted]
    if not scenes:
        sys.exit(f"bench: no scene is called {args.scenes}")
    return scenes


def big_scene(programs, folder):
    """A million triangles of one mesh, four times: what memory is made of."""
    return own_scene(programs, "stress", folder, "--set", "triangles=4000000",
                     "--set", "instances=4")


def measure(programs, args, folder):
    effort = Effort(args.quick)
    results = {"machine": machine(), "quick": args.quick, "threads": programs.threads}
    scenes = chosen_scenes(programs, args, folder)
    peer_names = [d["name"] for d in PEER_SCENES]
    peers = [s for s in scenes if s.name in peer_names]
    results["rays"] = rays(programs, scenes, effort)
    if peers and not args.no_cycles and cycles_is_here(programs):
        results["cycles"] = against_cycles(programs, peers, effort, folder)
    for scene in (s for s in scenes if s.name == "Zdm2"):
        results["plain_diffuse"] = plain_diffuse(programs, scene, effort, folder)
    results["build_times"] = build_times(programs, scenes, effort)
    results["scaling"] = scaling(programs, scenes[:2], effort, folder)
    results["memory"] = memory(programs, scenes + [big_scene(programs, folder)], folder)
    results["models"] = models(args.build, args.quick)
    results["realtime"] = realtime_frames(programs, args, folder)
    results["ocean"] = ocean(args.build, args.quick)
    results["glint"] = glint(args.build, args.quick)
    results["water"] = water(args.build, args.quick)
    results["sea"] = sea(args.build, args.quick)
    return results


def realtime_frames(programs, args, folder):
    quiet = machine()
    ship = [prepare_peer_scene(programs, d, folder) for d in PEER_SCENES
            if d["name"] == "DutchShipMedium"]
    return {"machine": quiet,
            "cases": realtime(programs, ship[0] if ship else None, folder, args.quick),
            "changing": changing(programs, args.quick)}


def with_section_again(args, folder):
    """The results on disk with this one section new."""
    with open(os.path.join(args.output, "results.json"), encoding="utf-8") as file:
        results = json.load(file)
    if args.only == "bsdf":
        results["models"] = models(args.build, args.quick)
        if results["models"] is None:
            sys.exit("bench: nothing was measured")
    elif args.only == "ocean":
        results["ocean"] = ocean(args.build, args.quick)
    elif args.only == "water":
        results["water"] = water(args.build, args.quick)
    elif args.only == "sea":
        results["sea"] = sea(args.build, args.quick)
    elif args.only == "glint":
        results["glint"] = glint(args.build, args.quick)
        if results["glint"] is None:
            sys.exit("bench: nothing was measured")
    else:
        results["realtime"] = realtime_frames(Programs(args.build), args, folder)
    return results


def main():
    args = arguments()
    with tempfile.TemporaryDirectory() as folder:
        try:
            results = (with_section_again(args, folder) if args.only
                       else measure(Programs(args.build), args, folder))
        except ProgramFailed as failure:
            sys.exit(f"bench: {failure}")
    with open(os.path.join(args.output, "results.json"), "w", encoding="utf-8") as file:
        json.dump(results, file, indent=2)
        file.write("\n")
    text = report.markdown(results)
    with open(os.path.join(args.output, "results.md"), "w", encoding="utf-8") as file:
        file.write(text)
    say(text)


if __name__ == "__main__":
    main()
