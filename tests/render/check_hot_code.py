#!/usr/bin/env python3
"""Checks that an object file of the hot code defines nothing global but its one table.

    check_hot_code.py NM OBJECT
    check_hot_code.py --self-test

Inline functions of headers become weak symbols, of which the linker keeps one: maybe the one that
was compiled for AVX-512, for a machine without it. Hence everything must have internal linkage.
"""
import re
import subprocess
import sys

# Marks of the C++ runtime that hold no code of ours.
HARMLESS = re.compile(r"^(DW\.ref\.|__gxx_personality|_ZTI|_ZTS|_ZTV|__odr_asan|"
                      r"__asan_|__tsan_|__ubsan_)")
TABLE = re.compile(r"kernels(X86_64|Avx2|Avx512)E?$")


def wrong_symbols(listing):
    """The lines of `nm` output (address, type, name) that break the rule."""
    tables, wrong = [], []
    for line in listing.splitlines():
        match = re.match(r"^[0-9a-fA-F]*\s+(\S)\s+(\S+)", line)
        if not match:
            continue
        kind, name = match.groups()
        if HARMLESS.match(name) or name.startswith("GCC_except_table"):
            continue
        if kind in "WVuwv" and not (kind in "wv" and line.startswith(" ")):
            wrong.append(f"weak {kind} {name}")
        elif kind in "TDBRGSC":
            (tables if TABLE.search(name) else wrong).append(f"global {kind} {name}")
    if len(tables) != 1:
        wrong.append(f"{len(tables)} tables instead of one")
    return wrong


def self_test():
    table = "0000000000000000 R _ZN2gp3cpu11kernelsAvx2E\n"
    local = "0000000000000010 t _ZN2gp3cpu5localEv\n                 U sinf\n"
    assert wrong_symbols(table + local) == []
    assert wrong_symbols(table + "0000000000000000 W _ZSt3minIjERKT_S2_S2_\n")
    assert wrong_symbols(table + "0000000000000000 V _ZN2gp5valueE\n")
    assert wrong_symbols(table + "0000000000000000 u _ZN2gp5guardE\n")
    assert wrong_symbols(table + "0000000000000000 T _ZN2gp3cpu9traceTileEv\n")
    assert wrong_symbols("")


def main():
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        return 0
    nm, path = sys.argv[1:]
    listing = subprocess.run([nm, path], check=True, capture_output=True, text=True).stdout
    wrong = wrong_symbols(listing)
    for line in wrong:
        print(f"{path}: {line}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
