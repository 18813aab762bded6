"""Nanoseconds of glints by method and footprint, by glint_bench (Google Benchmark)."""
from models import google_benchmark, medians
from programs import machine, say


def glint(build, quick):
    """{"1 : 1": {"smooth": measured, "dictionary": …}}: a facet's light, and a sample."""
    say("glints")
    quiet = machine()
    raw = google_benchmark(build, "glint_bench", quick)
    if raw is None:
        return None
    footprints = {}
    for name, time in medians(raw).items():
        method, _, footprint = name.partition("/")
        footprints.setdefault(footprint, {})[method] = time
    return {"machine": quiet, "footprints": footprints}
