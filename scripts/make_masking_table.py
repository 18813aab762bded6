#!/usr/bin/env python3
"""Writes src/shading/microfacet/masking_table.glsl: Smith's masking of distributions without a
closed form of Lambda.

usage: scripts/make_masking_table.py > src/shading/microfacet/masking_table.glsl

With t the tangent of a normal and P22 = D cos^4, a direction of cotangent c has

    Lambda = 2 integral_c^inf P22(t) t (sqrt(t^2 / c^2 - 1) - acos(c / t)) dt,

the projected area of the facets that look away from it (Heitz 2014, equation 16, with
integral D (wo . wm) = cos). It grows like m / c at grazing angles, m = 2 integral P22 t^2 dt, so
G1 = 1 / (1 + Lambda) is stored over u = c / (c + m), by which it is divided: between 1 and 1.33 for
every distribution here. m over the width is stored as a logarithm. masking.glsl has the coordinates.
"""
import math
from math import acos, asinh, exp, expm1, gamma, log, pi, sinh, sqrt

GAUSS = [(0.1834346424956498, 0.362683783378362), (0.525532409916329, 0.3137066458778873),
         (0.7966664774136267, 0.2223810344533745), (0.9602898564975363, 0.1012285362903763)]


def integrate(f, a, b, panels):
    half = (b - a) / panels / 2
    total = 0.0
    for i in range(panels):
        middle = a + (2 * i + 1) * half
        total += sum(w * (f(middle - x * half) + f(middle + x * half)) for x, w in GAUSS)
    return total * half


def expm1_over(x):
    return expm1(x) / x if x else 1.0


# Each gives P22 as a function of the tangent.
def gtr(alpha, power):
    big_l = -2 * log(alpha)
    peak = expm1_over(-big_l) / (pi * alpha ** 2 * expm1_over((1 - power) * big_l))
    return lambda t: peak * ((1 + (t / alpha) ** 2) / (1 + t * t)) ** -power / (1 + t * t) ** 2


def blinn_phong(alpha, _):
    if alpha == 0:  # the limit, in units of alpha
        return exponential_power(1, 1)
    half_n = 1 / alpha ** 2 - 1
    return lambda t: exp(-(half_n + 2) * math.log1p(t * t)) / (pi * alpha ** 2)


def exponential_power(_, p):
    scale = p / (pi * gamma(1 / p))
    return lambda t: scale * exp(-min(t ** (2 * p), 700))


def shifted_gamma(alpha, p):
    norm = integrate(lambda s: exp(-exp(s)) * exp((1 - p) * s), log(alpha), log(60 + alpha), 60)
    return lambda t: exp(-min(alpha + t * t / alpha, 700)) / (
        pi * alpha * norm) * (alpha + t * t / alpha) ** -p


def abc(alpha, c):
    b = 2 / alpha ** 2
    area = integrate(lambda s: (b + 1 - exp(s)) * exp((1 - c) * s), 0, log(1 + b), 60)

    def p22(t):
        cosine = 1 / sqrt(1 + t * t)
        y = 1 + b * t * t / (1 + t * t) / (1 + cosine)
        return b * b / (2 * pi * area) * y ** -c * cosine ** 4
    return p22


def mean_slope(p22):
    return integrate(lambda s: 2 * p22(exp(s)) * exp(3 * s), log(1e-9), log(1e9), 80)


def smith_lambda(p22, c):
    def f(q):
        s = q * q
        t = c * exp(s)
        return 2 * p22(t) * t * t * (sqrt(expm1(2 * s)) - acos(exp(-s))) * 2 * q
    return integrate(f, 0, sqrt(log(1e9 / c)), 32)


# The widths and shapes at the places [0, 1] of a table; masking.glsl has the inverses.
def width_of(x, power, low=1e-4):
    first = low ** power
    return (first + x * (1 - first)) ** (1 / power)


def centred_shape(y):
    first, last = asinh((0.1 - 1.25) / 0.4), asinh((10 - 1.25) / 0.4)
    return 1.25 + 0.4 * sinh(first + (last - first) * y)


def effective_width(alpha, power):
    """1 / sqrt(pi D(0)): what makes GTR of high and of low powers alike; alpha if that is 2."""
    return 1 / sqrt(pi * gtr(alpha, power)(0))


def gtr_width(x, power):
    wanted = width_of(x, 0.2, effective_width(1e-4, power))
    low, high = log(1e-4), 0.0
    for _ in range(60):
        middle = (low + high) / 2
        narrower = effective_width(exp(middle), power) < wanted
        low, high = (middle, high) if narrower else (low, middle)
    return exp((low + high) / 2)


def places(n):
    return [i / (n - 1) for i in range(n)] if n > 1 else [0.0]


def slope_table(kind, widths, shapes, unit):
    return [log(mean_slope(kind(a(s), s)) / unit(a(s), s)) for a in widths for s in shapes]


def masking_table(kind, widths, shapes, count):
    values = []
    for a in widths:
        for s in shapes:
            p22 = kind(a(s), s)
            m = mean_slope(p22)
            for u in places(count):
                inside = 0 < u < 1
                values.append(1 / (1 + smith_lambda(p22, m * u / (1 - u))) / u if inside else 1.0)
    return values


def fixed(values):
    return [lambda _, v=v: v for v in values]


def main():
    centred = lambda n: [centred_shape(y) for y in places(n)]
    thirds = lambda n: [3 * y for y in places(n)]
    effective = lambda n: [lambda s, x=x: gtr_width(x, s) for x in places(n)]
    by_power = lambda n, power: fixed([width_of(x, power) for x in places(n)])
    quotient = [(0.2 + 0.6 * y) / (0.8 - 0.6 * y) for y in places(9)]
    width = lambda a, _: a
    tables = [
        ("GTR_SLOPE", slope_table(gtr, effective(17), centred(33), effective_width)),
        ("GTR", masking_table(gtr, effective(9), centred(13), 17)),
        ("ABC_SLOPE", slope_table(abc, by_power(17, 0.2), centred(33), width)),
        ("ABC", masking_table(abc, by_power(9, 0.2), centred(13), 17)),
        ("SGD_SLOPE", slope_table(shifted_gamma, by_power(17, 0.1), thirds(17), width)),
        ("SGD", masking_table(shifted_gamma, by_power(7, 0.1), thirds(9), 13)),
        ("BLINN_PHONG_SLOPE", slope_table(blinn_phong, fixed(places(9)), [0],
                                           lambda a, _: a or 1)),
        ("BLINN_PHONG", masking_table(blinn_phong, fixed(places(9)), [0], 17)),
        ("EXPONENTIAL_POWER", masking_table(exponential_power, fixed([1]), quotient, 25)),
    ]
    print("// Generated by scripts/make_masking_table.py, which says what this is. Do not edit.")
    print("#ifndef GP_SHADING_MICROFACET_MASKING_TABLE_GLSL")
    print("#define GP_SHADING_MICROFACET_MASKING_TABLE_GLSL\n")
    first = 0
    for name, values in tables:
        print(f"#define MASKING_{name} {first}")
        first += len(values)
    print("\nfloat masking_entry(int index) {")
    print(f"    CONST_TABLE float entries[{first}] = {{")
    numbers = [f"{v:.5f}f" for _, values in tables for v in values]
    for i in range(0, len(numbers), 9):
        print("        " + ", ".join(numbers[i:i + 9]) + ("," if i + 9 < len(numbers) else ""))
    print("    };\n    return entries[index];\n}\n\n#endif")


if __name__ == "__main__":
    main()
