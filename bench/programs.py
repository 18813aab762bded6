"""Where the programs are and how they are called; medians and spreads; the machine."""
import datetime
import json
import os
import resource
import shutil
import statistics
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SHARED = os.path.join(os.path.dirname(ROOT), "shared")
ASSETS = os.path.join(SHARED, "assets")
CYCLES_SCRIPT = os.path.join(SHARED, "bench", "cycles_bench.py")
ENVIRONMENT = os.path.join(ASSETS, "env_venice_sunset_1k", "venice_sunset_1k.hdr")


class ProgramFailed(Exception):
    """A program ended with an error; the message is its last line."""


def say(text):
    print(text, flush=True)


def own_environment(program):
    """The environment with the program's own folder first: Debian's Blender takes the Python that
    PATH names first, and only Debian's has the numpy that its glTF importer needs."""
    variables = {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")}
    folder = os.path.dirname(shutil.which(program) or program)
    variables["PATH"] = folder + os.pathsep + variables.get("PATH", "")
    return variables


def run(command, timeout=900):
    """Standard output of a program that must succeed."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=timeout, check=False,
                          env=own_environment(command[0]))
    if done.returncode != 0:
        lines = (done.stderr.strip() or done.stdout.strip() or "no message").splitlines()
        raise ProgramFailed(f"{os.path.basename(command[0])}: {lines[-1]}")
    return done.stdout


class Programs:
    def __init__(self, build):
        self.tool = os.path.join(build, "bin", "glitterpath")
        self.rays = os.path.join(build, "bin", "gp_bench_rays")
        self.changing = os.path.join(build, "bin", "gp_bench_changing")
        for program in (self.tool, self.rays, self.changing):
            if not os.path.exists(program):
                sys.exit(f"bench: {os.path.relpath(program)} is not built")
        self.blender = shutil.which("blender")
        self.threads = os.cpu_count() or 1

    def json(self, command):
        return json.loads(run(command))

    def render(self, scene, output, *options):
        """One render by the command: its report, and the core-seconds of the process."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        report = self.json([self.tool, "render", scene, "-o", output, "--quiet", "--json", "-",
                            *options])
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        report["core_seconds"] = (after.ru_utime + after.ru_stime
                                  - before.ru_utime - before.ru_stime)
        return report

    def info(self, scene):
        return self.json([self.tool, "info", scene, "--json"])["totals"]


def measured(values, unit):
    return {"value": statistics.median(values), "unit": unit, "least": min(values),
            "most": max(values), "runs": len(values)}


def from_spread(spread, unit):
    """The spread that gp_bench_rays prints."""
    return {"value": spread["median"], "unit": unit, "least": spread["least"],
            "most": spread["most"], "runs": spread["runs"]}


def machine():
    """What the numbers depend on, without the machine's name."""
    model = "unknown"
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        for line in file:
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    with open("/proc/meminfo", encoding="utf-8") as file:
        kilobytes = int(file.readline().split()[1])
    return {"cpu": model, "cores": os.cpu_count(), "memory_gib": round(kilobytes / 2**20, 1),
            "load_average_at_start": [round(x, 2) for x in os.getloadavg()],
            "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC")}
