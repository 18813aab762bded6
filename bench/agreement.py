#!/usr/bin/env python3
"""Our reference against Cycles on three diffuse scenes: is what differs noise, and only noise?

usage: bench/agreement.py [--samples N] [--build TREE] [--keep FOLDER]

Each renderer makes two pictures of N/2 samples with different seeds. Their mean is compared, and
what the two differ by says how much noise the comparison has. Writes docs/agreement.md and its
pictures.
"""
import argparse
import json
import math
import os
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from gltf_file import GltfFile
from picture_files import read_exr, write_png
from programs import ASSETS, ENVIRONMENT, ROOT, ProgramFailed, Programs, machine, run, say
from scenes import (ENVIRONMENT_ROTATION, LUMENS_PER_WATT, PEER_SCENES, SUN_TRAVELS, SUN_WATTS,
                    camera_of, from_blender, sun_angles, triple)

BLOCK = 16
MOST_MEAN = 0.01        # relative difference of the pictures' means, each channel
MOST_BLOCK = 0.015      # of the picture's mean, for a block of 16 x 16 pixels ...
MOST_SIGMA = 4.0        # ... unless the noise explains it
MOST_CORRELATION = 0.1  # between neighbours, of the difference divided by its noise
BOUNCES = 4
OUR_SUN_ANGLE = 0.0093  # diameter, of the glitterpath command


class Pair:
    """A scene for both renderers."""

    def __init__(self, name, title, gltf, camera, size, lit):
        self.name, self.title, self.gltf = name, title, gltf
        self.position, self.target, self.fov = camera
        self.width, self.height = size
        self.environment, self.sun = lit
        self.path = None

    def materials(self):
        result = []
        for m in self.gltf.doc["materials"]:
            strength = m.get("extensions", {}).get("KHR_materials_emissive_strength", {})
            scale = strength.get("emissiveStrength", 1.0)
            color = m.get("pbrMetallicRoughness", {}).get("baseColorFactor", [1, 1, 1])
            result.append({"name": m["name"], "color": color[:3],
                           "emission": [e * scale for e in m.get("emissiveFactor", [0, 0, 0])]})
        return result


def cornell(programs, folder):
    path = os.path.join(folder, "cornell-source.glb")
    run([programs.tool, "make-scene", "cornell", "-o", path])
    camera = ((0, 1, 4.6), (0, 1, 0), 32.0)
    return Pair("cornell", "Box with one lamp, our own (`make-scene cornell`)", GltfFile(path),
                camera, (192, 192), (False, False))


def asset(programs, name, title, color, sun):
    description = next(d for d in PEER_SCENES if d["name"] == name)
    path = os.path.join(ASSETS, description["asset"])
    if not os.path.exists(path) or not os.path.exists(ENVIRONMENT):
        say(f"agreement: {name} is not beside the checkout: left out")
        return None
    totals = programs.info(path)
    lo, hi = totals["bounds_min"], totals["bounds_max"]
    gltf = GltfFile(path)
    gltf.make_diffuse(color)
    if description["ground"]:
        gltf.add_ground(((lo[0] + hi[0]) / 2, (lo[2] + hi[2]) / 2), math.dist(lo, hi) * 5, lo[1])
    return Pair(name.lower(), title, gltf, camera_of(description, lo, hi), (256, 144), (True, sun))


def all_pairs(programs, folder):
    pairs = [
        asset(programs, "Zdm2", "Zdm2, all grey 0.5, under environment and sun", [0.5] * 3, True),
        cornell(programs, folder),
        asset(programs, "DamagedHelmet", "The helmet's shape, all white 0.8, under an environment",
              [0.8] * 3, False)]
    return [p for p in pairs if p]


def render_ours(programs, pair, samples, folder):
    options = ["--size", f"{pair.width}x{pair.height}", "--spp", str(samples), "--full-float",
               f"--from={triple(pair.position)}", f"--look-at={triple(pair.target)}",
               f"--fov={pair.fov:.7g}", "--bounces", str(BOUNCES)]
    if pair.environment:
        options += [f"--env={ENVIRONMENT}", f"--env-rotation={ENVIRONMENT_ROTATION}"]
    if pair.sun:
        azimuth, elevation = sun_angles()
        options.append(f"--sun={azimuth:.7g},{elevation:.7g},{SUN_WATTS * LUMENS_PER_WATT:.7g}")
    outputs = []
    for seed in (1, 2):
        outputs.append(os.path.join(folder, f"{pair.name}-ours-{seed}.exr"))
        programs.render(pair.path, outputs[-1], "--seed", str(seed), *options)
    return outputs


def render_cycles(programs, pair, samples, folder):
    outputs = [os.path.join(folder, f"{pair.name}-cycles-{seed}.exr") for seed in (1, 2)]
    sun = {"watts": SUN_WATTS, "angle": OUR_SUN_ANGLE, "travels": from_blender(SUN_TRAVELS)}
    spec = {"gltf": pair.path, "materials": pair.materials(), "width": pair.width,
            "height": pair.height, "from": pair.position, "look_at": pair.target,
            "vertical_fov": pair.fov, "environment": ENVIRONMENT if pair.environment else "",
            "sun": sun if pair.sun else None, "samples": samples, "bounces": BOUNCES,
            "threads": programs.threads, "outputs": outputs}
    path = os.path.join(folder, pair.name + ".json")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(spec, file)
    script = os.path.join(ROOT, "bench", "cycles_diffuse.py")
    printed = run([programs.blender, "-b", "--factory-startup", "-P", script, "--", path])
    if printed.count("RENDERED") != len(outputs):
        faults = [line for line in printed.splitlines() if "Error" in line] or ["no pictures"]
        raise ProgramFailed("blender: " + faults[-1])
    return outputs


def luminance(planes):
    # [ITU-R BT.709-6, item 3.2]
    return [0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in zip(*planes)]


def read_two(paths):
    """The mean of two pictures: its planes, its luminance, and half the luminance's difference,
    whose square is an unbiased estimate of the variance of the mean."""
    first, second = (read_exr(p) for p in paths)
    planes = [[(a + b) / 2 for a, b in zip(p, q)] for p, q in zip(first[2], second[2])]
    halves = [(a - b) / 2 for a, b in zip(luminance(first[2]), luminance(second[2]))]
    return first[0], first[1], planes, luminance(planes), halves


def block_table(width, height, difference, variance):
    """(mean difference, its standard deviation) of each whole block."""
    blocks = []
    for y0 in range(0, height - BLOCK + 1, BLOCK):
        for x0 in range(0, width - BLOCK + 1, BLOCK):
            pixels = [y * width + x for y in range(y0, y0 + BLOCK) for x in range(x0, x0 + BLOCK)]
            mean = sum(difference[i] for i in pixels) / len(pixels)
            sigma = math.sqrt(sum(variance[i] for i in pixels)) / len(pixels)
            blocks.append((mean, sigma, x0, y0))
    return blocks


def neighbour_correlation(width, height, difference, variance):
    """Of the difference divided by its noise, which is taken from 5 x 5 pixels; cut at 4 sigma, so
    that a few edges do not decide. Noise has none; structure has much."""
    z = []
    for y in range(height):
        for x in range(width):
            near = [variance[v * width + u] for v in range(max(0, y - 2), min(height, y + 3))
                    for u in range(max(0, x - 2), min(width, x + 3))]
            sigma = math.sqrt(sum(near) / len(near))
            d = difference[y * width + x]
            z.append(max(-4.0, min(4.0, d / sigma)) if sigma > 0 else 0.0)
    power = sum(v * v for v in z)
    beside = sum(z[y * width + x] * z[y * width + x + 1]
                 for y in range(height) for x in range(width - 1))
    below = sum(a * b for a, b in zip(z, z[width:]))
    return (beside + below) / (2 * power)


def compare(ours, cycles):
    width, height, our_planes, our_light, our_halves = read_two(ours)
    _, _, their_planes, their_light, their_halves = read_two(cycles)
    difference = [a - b for a, b in zip(our_light, their_light)]
    variance = [a * a + b * b for a, b in zip(our_halves, their_halves)]
    mean = sum(their_light) / len(their_light)
    blocks = block_table(width, height, difference, variance)
    unexplained = [b for b in blocks
                   if abs(b[0]) > MOST_BLOCK * mean and abs(b[0]) > MOST_SIGMA * b[1]]
    worst = max(blocks, key=lambda b: abs(b[0]))
    root = math.sqrt(sum(b[0] ** 2 for b in blocks) / len(blocks)) / mean
    channels = [sum(a) / sum(b) - 1 for a, b in zip(our_planes, their_planes)]
    correlation = neighbour_correlation(width, height, difference, variance)
    met = (max(abs(c) for c in channels) <= MOST_MEAN and not unexplained
           and abs(correlation) <= MOST_CORRELATION)
    return {"means": channels, "blocks": len(blocks), "unexplained": len(unexplained),
            "worst": worst[0] / mean, "worst_sigma": abs(worst[0]) / max(worst[1], 1e-30),
            "worst_at": worst[2:], "rms": root, "correlation": correlation, "met": met,
            "mean_sigma": math.sqrt(sum(variance)) / len(variance) / mean,
            "noise": math.sqrt(sum(variance) / len(variance)) / mean,
            "pictures": (width, height, our_planes, their_planes, difference, mean)}


def srgb(x):
    # [IEC 61966-2-1]
    x = max(0.0, min(1.0, x))
    return round(255 * (12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055))


def coarse(value, step):
    """In whole steps: noise does not compress, and nobody sees the finest ones."""
    return max(0, min(255 // step, round(value / step))) * step


def write_triptych(path, pictures):
    """Ours, Cycles', and ten times the difference of luminance about a middle grey."""
    width, height, ours, cycles, difference, mean = pictures
    scale = 0.3 / mean
    rows = bytearray()
    for y in range(height):
        line = range(y * width, (y + 1) * width)
        for planes in (ours, cycles):
            rows += bytes(coarse(srgb(planes[c][i] * scale), 3) for i in line for c in range(3))
        for i in line:
            grey = coarse(127.5 + 255 * 10 * difference[i] * scale, 16)
            rows += bytes((grey, grey, grey))
    write_png(path, 3 * width, height, rows)


def percent(x, digits=2):
    return f"{100 * x:+.{digits}f} %"


def document(pairs, samples, about):
    lines = ["# Agreement with Cycles", "",
             "Three diffuse scenes, the same camera, light and number of bounces "
             f"({BOUNCES}), linear pictures,", f"{samples} samples a pixel from each renderer (two "
             "pictures of half as many with different seeds, whose",
             "difference is the measure of the noise). Made by `bench/agreement.py` with Blender's",
             f"Cycles {about}.", "",
             "What must hold: the means of each colour differ by at most "
             f"{100 * MOST_MEAN:.0f} %; each block of {BLOCK} x {BLOCK} pixels differs by at",
             f"most {100 * MOST_BLOCK:.1f} % of the picture's mean, or by no more than "
             f"{MOST_SIGMA:.0f} standard deviations of its noise; and neighbouring",
             "pixels of the difference, divided by its noise, are uncorrelated "
             f"(at most {MOST_CORRELATION}), as noise is and structure is not.", ""]
    lines += ["| scene | mean R, G, B | noise of the mean | worst block | its sigmas | blocks, RMS"
              " | unexplained blocks | correlation | noise of a pixel | agrees |",
              "|" + "---|" * 10]
    for pair, r in pairs:
        lines.append(f"| {pair.title} | " + ", ".join(percent(m) for m in r["means"])
                     + f" | {100 * r['mean_sigma']:.3f} %"
                     f" | {percent(r['worst'])} at {r['worst_at'][0]},{r['worst_at'][1]}"
                     f" | {r['worst_sigma']:.1f} | {100 * r['rms']:.2f} %"
                     f" | {r['unexplained']} of {r['blocks']} | {r['correlation']:+.3f}"
                     f" | {100 * r['noise']:.1f} % | {'yes' if r['met'] else '**no**'} |")
    biased = [p.title for p, r in pairs
              if max(abs(m) for m in r["means"]) > max(1e-3, MOST_SIGMA * r["mean_sigma"])]
    if biased:
        lines += ["", "The means differ by more than their noise explains (and 0.1 %), so one of "
                  "the two is biased: " + "; ".join(biased) + "."]
    lines += ["", "Ours, Cycles', and ten times the difference of luminance (middle grey: none).",
              "Thin bright and dark edges around a lamp or a sunlit border are noise too: there a",
              "pixel holds the lamp or not by the chance of the pixel filter.", ""]
    for pair, _ in pairs:
        lines += [f"![{pair.title}](images/agreement-{pair.name}.png)", ""]
    return "\n".join(lines)


def blender_version(programs):
    return run([programs.blender, "--version"]).split("\n")[0].replace("Blender ", "")


def cycles_pictures(programs, pair, samples, folder, reuse):
    kept = [os.path.join(folder, f"{pair.name}-cycles-{seed}.exr") for seed in (1, 2)]
    if reuse and all(os.path.exists(path) for path in kept):
        return kept
    return render_cycles(programs, pair, samples, folder)


def measure(programs, samples, folder, pictures, reuse):
    results = []
    for pair in all_pairs(programs, folder):
        say(f"agreement: {pair.title}")
        pair.path = os.path.join(folder, pair.name + ".glb")
        pair.gltf.write(pair.path)
        ours = render_ours(programs, pair, samples // 2, folder)
        result = compare(ours, cycles_pictures(programs, pair, samples // 2, folder, reuse))
        write_triptych(os.path.join(pictures, f"agreement-{pair.name}.png"), result["pictures"])
        results.append((pair, result))
        say(f"  means {', '.join(percent(m) for m in result['means'])}; worst block "
            f"{percent(result['worst'])}; {result['unexplained']} unexplained; correlation "
            f"{result['correlation']:+.3f}: {'agrees' if result['met'] else 'DOES NOT AGREE'}")
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--samples", type=int, default=1024, help="a pixel (default %(default)s)")
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"))
    parser.add_argument("--keep", help="folder for the scenes and EXR pictures")
    parser.add_argument("--reuse", action="store_true",
                        help="take Cycles' pictures that an earlier run left in --keep")
    parser.add_argument("--docs", default=os.path.join(ROOT, "docs"), help="where to write")
    args = parser.parse_args()
    programs = Programs(args.build)
    if not programs.blender:
        sys.exit("agreement: blender is not installed: there is nothing to compare with")
    pictures = os.path.join(args.docs, "images")
    os.makedirs(pictures, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        try:
            results = measure(programs, args.samples, args.keep or folder, pictures,
                              args.reuse)
        except ProgramFailed as failure:
            sys.exit(f"agreement: {failure}")
    about = f"({blender_version(programs)}) on {machine()['date'][:10]}"
    with open(os.path.join(args.docs, "agreement.md"), "w", encoding="utf-8") as file:
        file.write(document(results, args.samples, about))
    sys.exit(0 if all(r["met"] for _, r in results) else 1)


if __name__ == "__main__":
    main()
