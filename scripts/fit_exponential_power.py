#!/usr/bin/env python3
"""Prints the constants of exponential_power_fit in src/shading/microfacet/smith_fit.glsl.

usage: scripts/fit_exponential_power.py

The slopes of this distribution only scale with alpha, so that Smith's masking depends on the power
p alone; the seven coefficients of smith_fit.glsl are then polynomials in p / (1 + p), each
interpolated at four Chebyshev nodes between p = 1/4 and p = 4.
"""
from math import acos, cos, exp, expm1, gamma, log, pi, sqrt

COEFFICIENTS, POWERS = 7, 4


def nodes(count):
    return [cos(pi * (k + 0.5) / count) for k in range(count)]


def chebyshev(values):
    n = len(values)
    return [(1 if j == 0 else 2) / n * sum(v * cos(pi * j * (k + 0.5) / n)
                                           for k, v in enumerate(values)) for j in range(n)]


def smith_lambda(p, cotangent):
    """2 integral_c^inf P22(t) t (sqrt(t^2 / c^2 - 1) - acos(c / t)) dt, with t = c e^(q^2)."""
    scale = p / (pi * gamma(1 / p))
    last = sqrt(max(log(700 ** (1 / (2 * p)) / cotangent), 0))
    step = last / 2000
    total = 0.0
    for j in range(1, 2001):
        s = (j * step) ** 2
        t = cotangent * exp(s)
        total += scale * exp(-t ** (2 * p)) * t * t * (sqrt(expm1(2 * s)) - acos(exp(-s))) * j
    return 4 * total * step * step


def fit(p):
    slope = gamma(1.5 / p) / (pi * gamma(1 / p))
    values = []
    for x in nodes(COEFFICIENTS):
        place = 0.5 + 0.5 * x
        cotangent = 4 * slope * place / (1 - place)
        u = cotangent / (cotangent + slope)
        g1 = 1 / (1 + smith_lambda(p, cotangent))
        values.append((g1 / u - 1) / (u * (1 - u)))
    return chebyshev(values)


def main():
    rows = []
    for x in nodes(POWERS):
        share = 0.5 + 0.3 * x
        rows.append(fit(share / (1 - share)))
    for column in zip(*rows):
        print("vec4(" + ", ".join(f"{c:.6f}f" for c in chebyshev(column)) + ")")


if __name__ == "__main__":
    main()
