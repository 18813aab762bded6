"""results.md from the numbers: what was to be reached, what was reached, said plainly."""

TARGET_RATIO = 0.45      # of bare Embree, textured glTF scene with environment light
TARGET_CYCLES = 2.0      # times Cycles' samples a second
TARGET_DIFFUSE = 2.38    # Msamples/s, Embree's tutorial path tracer on Zdm2, paths of length 2
TARGET_OCEAN = 12.0      # ms, two cores
TARGET_WATER = 120.0     # ms of all threads: full-screen water, one light, glints
TARGET_GLINTS = 4.0      # times the same frame with smooth slopes
TARGET_MASKING = 1.05    # times the frame with Smith's
TARGET_MEMORY = 1.5      # times (geometry + textures + Embree's own)
# Textured, lit by an environment picture: those that the first target speaks of.
TEXTURED = ("DamagedHelmet", "DutchShipMedium", "FlightHelmet")


def number(m, digits=2):
    """Median and spread, as text."""
    if m.get("runs", 1) == 1 or "least" not in m:
        return f"{m['value']:.{digits}f}"
    return f"{m['value']:.{digits}f} ({m['least']:.{digits}f}..{m['most']:.{digits}f})"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def verdict(met):
    return "yes" if met else "**no**"


def target_rows(results):
    rows = []
    for name, r in results["rays"].items():
        if name in TEXTURED:
            rows.append([f"{name}: renderer against bare Embree, same rays",
                         f">= {TARGET_RATIO:.0%}", f"{r['ratio']['value']:.0%}",
                         verdict(r["ratio"]["value"] >= TARGET_RATIO)])
    for name, c in results.get("cycles", {}).items():
        rows.append([f"{name}: samples a second against Cycles", f">= {TARGET_CYCLES:.1f} x",
                     f"{c['ratio']['value']:.2f} x",
                     verdict(c["ratio"]["value"] >= TARGET_CYCLES)])
    for light, m in results.get("plain_diffuse", {}).items():
        rows.append([f"Zdm2, plain diffuse, paths of length 2, {light.replace('_', ' ')}",
                     f">= {TARGET_DIFFUSE} Msamples/s", f"{m['value']:.2f} Msamples/s",
                     verdict(m["value"] >= TARGET_DIFFUSE)])
    if results.get("ocean"):
        update = results["ocean"]["parts"]["update"]["wall"]
        rows.append(["update of the sea, 3 x 256 x 256", f"<= {TARGET_OCEAN} ms",
                     f"{update['value']:.1f} ms", verdict(update["value"] <= TARGET_OCEAN)])
    rows += water_targets(results)
    for name, m in results["memory"].items():
        if "ratio" in m:
            rows.append([f"{name}: peak memory", f"<= {TARGET_MEMORY} x",
                         f"{m['ratio']['value']:.2f} x",
                         verdict(m["ratio"]["value"] <= TARGET_MEMORY)])
    return rows


def rays_part(results):
    rows = []
    for name, r in results["rays"].items():
        e = r["embree"]
        rows.append([name, str(r["bounces"]), number(r["renderer"], 1)]
                    + [number(e[k], 1) if k in e else "-"
                       for k in ("mixed", "camera", "bounce", "shadow", "camera_packets")]
                    + [f"{r['ratio']['value']:.0%}", f"{r['ratio_of_core_seconds']['value']:.0%}"])
    return ["## Rays a second", "",
            "The whole renderer (640 x 360, full materials), and bare `rtcIntersect1` and",
            "`rtcOccluded1` over the rays recorded from that very render, in its proportions, in",
            "turns in one process. Mrays/s: median (least..most). Packets are for information: the",
            "renderer sends its camera rays so; the ceiling (mixed) has them one by one. The last",
            "column is the same ratio of seconds that threads computed.", ""] + table(
        ["scene", "bounces", "renderer", "Embree, mixed", "camera", "bounce", "shadow",
         "camera, packets", "renderer / mixed", "by core-seconds"], rows)


def cycles_part(results):
    if "cycles" not in results:
        return []
    rows = []
    for name, c in results["cycles"].items():
        other = c["other_limit"]
        rows.append([name, str(c["bounces"]), number(c["glitterpath"]), number(c["cycles"]),
                     number(c["cycles_samples_alone"]), number(c["ratio"]),
                     number(c["ratio_of_core_seconds"]), rays_a_sample(c["rays"]),
                     f"{number(other['glitterpath'])}, {rays_a_sample(other['rays'])} rays"
                     f" ({other['bounces']})"])
    samples = next(iter(results["cycles"].values()))["samples_per_pixel"]
    return ["## Against Cycles (Blender)", "",
            f"640 x 360, {samples} samples, environment picture and sun, the same camera, runs in",
            "turns. Msamples/s: median (least..most).", "",
            "- Bounces: Cycles' paths end after 1 diffuse and 1 glossy bounce, at most 2 together.",
            "  Our paths have one limit for all: 1 in Zdm2, where everything is matte and the",
            "  paths are the same; 2 elsewhere, which follows every path of Cycles and also",
            "  diffuse to diffuse and glossy to glossy: more work for us, not less. The last",
            "  column has the other limit, and how many rays a sample took.",
            "- Cycles' seconds include synchronising and saving each picture; ours do not. So one",
            "  more run with 1 sample is taken off Cycles' time (\"samples alone\"), and the ratio",
            "  is that to the faster figure.",
            "- The ratio of core-seconds counts what the threads computed, samples alone, for",
            "  both; other programs on the machine change it less.", ""] + table(
        ["scene", "bounces", "Glitterpath", "Cycles", "Cycles, samples alone", "ratio",
         "ratio, core-seconds", "our rays a sample", "other limit"], rows)


def rays_a_sample(rays):
    return f"{rays['total'] / rays['camera']:.2f}"


def diffuse_part(results):
    if "plain_diffuse" not in results:
        return []
    rows = [[name.replace("_", " "), number(m)] for name, m in results["plain_diffuse"].items()]
    return ["## Plain diffuse, paths of length 2, Zdm2", "",
            "`--shading diffuse --bounces 1`; Embree's own tutorial path tracer reached",
            f"{TARGET_DIFFUSE} Msamples/s on the reference machine.", ""] + table(
        ["light", "Msamples/s"], rows)


def build_part(results):
    rows = [[name, f"{b['triangles']:,}"] + [number(b[k], 1) for k in (
        "static_ms", "dynamic_ms")]
        for name, b in results["build_times"].items()]
    return ["## Build times", "",
            "Milliseconds to bring the backend's scene up to date with one mesh: static (high",
            "quality), dynamic with moved vertices (low quality). `waves_N` are generated.",
            ""] + table(["mesh", "triangles", "static", "dynamic"], rows)


def scaling_part(results):
    rows = []
    for name, rates in results["scaling"].items():
        one = rates["1"]["value"]
        rows += [[name, threads, number(m), f"{m['value'] / one:.2f}"]
                 for threads, m in rates.items()]
    return ["## Threads", ""] + table(["scene", "threads", "Msamples/s", "against one"], rows)


def memory_part(results):
    memory = results["memory"]
    rows = [[name] + [number(m[k], 1) for k in ("peak", "geometry", "textures", "embree",
                                                "frame")]
            + [number(m["ratio"]), number(m["ratio_without_program_and_frame"])]
            for name, m in memory.items() if "ratio" in m]
    return ["## Memory", "",
            "MiB. Peak of the whole process, loading included, against geometry + textures +",
            "Embree's structures. The program itself takes "
            f"{memory['program_alone']['value']:.0f} MiB (a small scene's peak less",
            "what that scene needs); the last column leaves that and the frame's images out.",
            ""] + table(
        ["scene", "peak", "geometry", "textures", "Embree", "frame", "peak / needed",
         "without program, frame"], rows)


def models_part(results):
    if not results.get("models"):
        return []
    m = results["models"]
    rows = [[name, number(t["eval"], 0), number(t["sample"], 0)]
            for name, t in m["models"].items()]
    terms = [[name] + [number(t[how], 0) for how in ("on", "off", "absent")]
             + [f"{t['off']['value'] / t['absent']['value']:.2f}"]
             for name, t in m["terms"].items()]
    prepared = [[name, f"{t['value'] / 1000:,.0f} ({t['least'] / 1000:,.0f}.."
                       f"{t['most'] / 1000:,.0f})"] for name, t in m["prepared"].items()]
    size = m["bytes"]
    plain = m["plain"]
    return ["## Reflectance models", "",
            "Nanoseconds on one core (AVX2) for one evaluation, and for one sample with its weight",
            "and density, of each model with its defaults: median (least..most). Directions change",
            f"with every call. No result was NaN or infinite. {m['machine']['date']}, load average "
            f"{m['machine']['load_average_at_start'][0]:.2f}.", ""] + table(
        ["model", "eval", "sample"], rows) + [
            f"Disney's BRDF takes {number(plain['disney'], 0)} ns an evaluation, GGX and Lambert",
            f"together {number(plain['ggx and lambert'], 0)} ns, both called without a choice of",
            f"model: {m['disney_against_plain']['value']:.1f} times.", "",
            "What terms cost that are off: nanoseconds an evaluation with the term, with its",
            "parameter at 0, and with code that was compiled without it.", ""] + table(
        ["term", "on", "off", "absent", "off / absent"], terms) + [
            "Microseconds to make a material, where numbers are derived from its parameters.",
            ""] + table(["material", "microseconds"], prepared) + [
            f"Tables: {size['albedo_tables']:,} bytes of albedo, read when a material is made and",
            f"never by evaluation; a material has {size['material']} bytes; a core's second cache",
            f"{size['level_2_cache']:,}.", ""]


def realtime_part(results):
    if not results.get("realtime"):
        return []
    r = results["realtime"]
    rows, names = [], []
    for case, c in r["cases"].items():
        names += [n for n in c["passes"] if n not in names]
        m = c["milliseconds"]
        rows.append([case, f"{m['mean']:.1f}", f"{m['p50']:.1f}", f"{m['p95']:.1f}",
                     f"{1000 / m['mean']:.1f}", f"{c['mrays_per_second']:.2f}",
                     f"{c['bytes_per_pixel']:.0f}"])
    passes = [[name] + [f"{c['passes'].get(name, 0):.2f}" for c in r["cases"].values()]
              for name in names]
    return ["## Real time", "",
            "Milliseconds of a frame with A-SVGF and anti-aliasing over time, the camera moving;",
            "rays of all kinds; memory of all images of the frame. "
            f"{r['machine']['date']}, load average "
            f"{r['machine']['load_average_at_start'][0]:.2f}.", ""] + table(
        ["scene", "mean", "median", "95 %", "frames/s", "Mrays/s", "bytes a pixel"], rows) + [
            "Pass by pass, mean milliseconds:", ""] + table(
                ["pass", *r["cases"]], passes) + changing_part(r)


def changing_part(r):
    if not r.get("changing"):
        return []
    rows = [[what] + [f"{c[key]['value']:.1f} ({c[key]['least']:.1f}..{c[key]['most']:.1f})"
                      for key in ("calls_ms", "build_ms", "render_ms")]
            + [f"{c['frame_core_ms']['value']:.1f}"] for what, c in r["changing"].items()]
    return ["Frames of 320 x 180 in which much changes each time, milliseconds, median",
            "(least..most): the calls that change it, making its structures anew, the rest of the",
            "frame, and what all threads computed for the frame.", ""] + table(
        ["what changes", "calls", "structures", "rest", "core-ms"], rows)


def water_targets(results):
    if not results.get("water"):
        return []
    core = {name: v["core"]["value"] for name, v in results["water"]["variants"].items()}
    glints, smooth = core["glints"], core["smooth"]
    masking = smooth / core["smooth, Smith"]
    return [["full-screen water, glints, one light, camera rays included",
             f"<= {TARGET_WATER:.0f} ms of all threads", f"{glints:.0f} ms",
             verdict(glints <= TARGET_WATER)],
            ["the same frame with glints over without", f"<= {TARGET_GLINTS:.0f} x",
             f"{glints / smooth:.2f} x", verdict(glints <= TARGET_GLINTS * smooth)],
            ["the same frame with sheared V-cavities over Smith's", f"<= {TARGET_MASKING} x",
             f"{masking:.3f} x", verdict(masking <= TARGET_MASKING)]]


def water_part(results):
    if not results.get("water"):
        return []
    r = results["water"]
    rows = [[name, f"{v['share']:.0%}", number(v["core"], 0), number(v["wall"], 0)]
            for name, v in r["variants"].items()]
    return ["## Frames of water", "",
            f"{r['size'][0]} x {r['size'][1]}, one sample a pixel, one directional light, no",
            "shadows (GP_MODE_LOCAL), camera rays, waves' slopes and light together; milliseconds,",
            f"median (least..most). {r['device']}, {r['machine']['date']}, load average "
            f"{r['machine']['load_average_at_start'][0]:.2f}.", ""] + table(
        ["frame", "water", "all threads", "wall"], rows)


def sea_part(results):
    if not results.get("sea"):
        return []
    r = results["sea"]
    rows = [[name, *(f"{c[k]['value']:.4f}" for k in ("rmse", "flip", "flicker")),
             f"{c['specular_frames']['value']:.1f}", f"{c['change']['value']:.3f}",
             number(c["lighting"], 0)] for name, c in r["cases"].items()]
    return ["## The sea in real time", "",
            f"{r['size'][0]} x {r['size'][1]}, one path a pixel, the last {r['last']} of",
            f"{r['frames']} frames against {r['samples']} paths a pixel: errors of the picture as",
            "it is shown, how they flicker, frames of specular history, change that gradients",
            "see, and milliseconds of the lighting pass by the wall's clock.",
            f"{r['machine']['date']}, load average "
            f"{r['machine']['load_average_at_start'][0]:.2f}.", ""] + table(
        ["what moves", "RMSE", "FLIP", "flicker", "history", "change", "lighting"], rows)


def ocean_part(results):
    if not results.get("ocean"):
        return []
    r = results["ocean"]
    rows = [[name, number(p["wall"]), number(p["core"])] for name, p in r["parts"].items()]
    return ["## The sea", "",
            f"One step of time of {r['cascades']} cascades of {r['size']} x {r['size']} points,",
            f"{r['threads']} threads, {r['instructions']} instructions, milliseconds: median",
            "(least..most). The update is all parts, and now and then a moment that foam",
            f"remembers. {r['machine']['date']}, load average "
            f"{r['machine']['load_average_at_start'][0]:.2f}.", ""] + table(
        ["part", "wall", "all threads"], rows)


def glint_part(results):
    if not results.get("glint"):
        return []
    r = results["glint"]
    methods = ("smooth", "dictionary", "counting", "zirr", "sample")
    rows = [[name] + [number(t[m], 0) for m in methods]
            + [f"{1000 / t['dictionary']['value']:.1f}"]
            for name, t in r["footprints"].items()]
    return ["## Glints", "",
            "Nanoseconds on one core (AVX2) for the light of one facet of water (Fresnel, density",
            "of slopes, V-cavity masking) under one light, by method and by the footprint's axes,",
            "and for a sample of the dictionary's slopes: median (least..most); millions of",
            f"evaluations a second with the dictionary. {r['machine']['date']}, load average "
            f"{r['machine']['load_average_at_start'][0]:.2f}.", ""] + table(
        ["footprint", *methods, "million/s"], rows)


def markdown(results):
    m = results["machine"]
    lines = ["# Speed, measured", "",
             "Made by `scripts/bench`" + (" --quick" if results["quick"] else "")
             + "; all numbers with their units are in `results.json`.", "",
             f"{m['cpu']}, {m['cores']} cores, {m['memory_gib']} GiB; load average at the start "
             + ", ".join(f"{x:.2f}" for x in m["load_average_at_start"]) + f"; {m['date']}.", ""]
    if m["load_average_at_start"][0] > 0.5:
        lines += ["**The machine was not quiet: rates by the wall's clock are too low, those of",
                  "core-seconds less so.**", ""]
    lines += ["## Targets", ""]
    lines += table(["what", "target", "reached", "met"], target_rows(results))
    for part in (rays_part, cycles_part, diffuse_part, build_part, scaling_part, memory_part,
                 models_part, realtime_part, ocean_part, glint_part, water_part, sea_part):
        lines += part(results)
    return "\n".join(lines)
