"""Nanoseconds of glints by method and footprint, by glint_bench (Google Benchmark)."""
import json
import os
import tempfile

from models import medians
from programs import machine, run, say


def glint(build, quick):
    """{"1 : 1": {"smooth": measured, "dictionary": …}}: a facet's light, and a sample."""
    say("glints")
    program = os.path.join(build, "bin", "glint_bench")
    if not os.path.exists(program):
        say("  left out: glint_bench is not built (libbenchmark-dev)")
        return None
    quiet = machine()
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "glint.json")
        run([program, f"--benchmark_min_time={0.02 if quick else 0.1}",
             f"--benchmark_repetitions={3 if quick else 5}", f"--benchmark_out={out}",
             "--benchmark_out_format=json"])
        with open(out, encoding="utf-8") as file:
            raw = json.load(file)
    failed = [row["run_name"] for row in raw["benchmarks"] if row.get("error_occurred")]
    if failed:
        raise SystemExit(f"bench: glint_bench: no number: {', '.join(sorted(set(failed)))}")
    footprints = {}
    for name, time in medians(raw).items():
        method, _, footprint = name.partition("/")
        footprints.setdefault(footprint, {})[method] = time
    return {"machine": quiet, "footprints": footprints}
