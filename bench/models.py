"""Nanoseconds of every reflectance model, by bsdf_bench (Google Benchmark)."""
import json
import os
import tempfile

from programs import machine, run, say


def medians(raw):
    """Benchmark name to {"eval/lambert": measured}; each was repeated."""
    runs = {}
    for row in raw["benchmarks"]:
        if row.get("run_type") == "iteration":
            runs.setdefault(row["run_name"], []).append(row["cpu_time"])
    results = {}
    for name, values in runs.items():
        values.sort()
        results[name] = {"value": values[len(values) // 2], "unit": "ns", "least": values[0],
                         "most": values[-1], "runs": len(values)}
    return results


def google_benchmark(build, name, quick):
    """What a program made with Google Benchmark writes; None where it is not built."""
    program = os.path.join(build, "bin", name)
    if not os.path.exists(program):
        say(f"  left out: {name} is not built (libbenchmark-dev)")
        return None
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.json")
        run([program, f"--benchmark_min_time={0.02 if quick else 0.1}",
             f"--benchmark_repetitions={3 if quick else 5}", f"--benchmark_out={out}",
             "--benchmark_out_format=json"])
        with open(out, encoding="utf-8") as file:
            raw = json.load(file)
    failed = [row["run_name"] for row in raw["benchmarks"] if row.get("error_occurred")]
    if failed:
        raise SystemExit(f"bench: {name}: no number: {', '.join(sorted(set(failed)))}")
    return raw


def table_sizes(context):
    level_2 = [c["size"] for c in context["caches"] if c["level"] == 2 and c["type"] != "Data"]
    return {"albedo_tables": int(context["bytes_of_albedo_tables"]),
            "material": int(context["bytes_of_a_material"]),
            "level_2_cache": level_2[0] if level_2 else 0}


def models(build, quick):
    """ns per eval and per sample of each model, what terms cost that are off, sizes of tables. The
    program checks all results first and fails where one is not finite."""
    say("reflectance models")
    quiet = machine()
    raw = google_benchmark(build, "bsdf_bench", quick)
    if raw is None:
        return None
    times = medians(raw)
    rows, terms = {}, {}
    for name, time in times.items():
        kind, _, rest = name.partition("/")
        if kind in ("eval", "sample"):
            rows.setdefault(rest, {})[kind] = time
        elif kind == "term":
            term, _, how = rest.rpartition("/")
            terms.setdefault(term, {})[how] = time
    plain = {name.partition("/")[2]: t for name, t in times.items() if name.startswith("plain/")}
    prepared = {name.partition("/")[2]: t for name, t in times.items()
                if name.startswith("prepare/")}
    ratio = plain["disney"]["value"] / plain["ggx and lambert"]["value"]
    return {"machine": quiet, "models": rows, "terms": terms, "plain": plain,
            "prepared": prepared,
            "bytes": table_sizes(raw["context"]),
            "disney_against_plain": {"value": ratio, "unit": "times GGX and Lambert"}}
