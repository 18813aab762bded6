"""Asserts that a shared library exports exactly what the header declares.

usage: check_exports.py NM LIBRARY HEADER
"""
import re
import subprocess
import sys


def exported(nm, library):
    """Names of the defined dynamic symbols, without their versions."""
    text = subprocess.run([nm, "-D", "--defined-only", library], check=True, capture_output=True,
                          text=True).stdout
    return {line.split()[-1].split("@")[0] for line in text.splitlines() if line.strip()}


def declared(header):
    with open(header, encoding="utf-8") as file:
        return set(re.findall(r"GP_API[^;(]*?\b(gp[A-Z]\w*)\s*\(", file.read()))


def main():
    nm, library, header = sys.argv[1:]
    have, want = exported(nm, library), declared(header)
    if len(want) < 40:
        sys.exit(f"only {len(want)} functions were found in the header: it was not read rightly")
    missing, extra = sorted(want - have), sorted(have - want)
    for name in missing:
        print(f"declared, but not exported: {name}")
    for name in extra:
        print(f"exported, but not declared: {name}")
    if missing or extra:
        sys.exit(1)
    print(f"{len(want)} functions are declared and exported, nothing else")


if __name__ == "__main__":
    main()
