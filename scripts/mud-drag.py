#!/usr/bin/env python3
"""Reference values for the loss of a string, in 34 digits by mpmath.

Writes the tables in crates/linear/src/loss/reference, which the tests of that module are held to.
Nothing here is taken from the program: the flow around a tube is found from its boundary
conditions as a system of linear equations, and a mode as a root of its own equation.

    python3 scripts/mud-drag.py
"""

import csv
from pathlib import Path

from mpmath import (besseli, besselk, exp, findroot, log, lu_solve, matrix, mp, mpc, mpf,
                    pi, sqrt)

mp.dps = 34
OUT = Path(__file__).resolve().parent.parent / "crates/linear/src/loss/reference"


def write(name, header, rows):
    with open(OUT / name, "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(header)
        table.writerows(rows)


def digits(value):
    return [mp.nstr(value.real, 17), mp.nstr(value.imag, 17)]


def bessel():
    """I_n(z) e^(-z) and K_n(z) e^z."""
    rows = []
    for size in ("1e-8", "0.1", "1.3", "1.9", "2.1", "5", "12", "17", "19.9", "20.1", "40", "150",
                 "2500"):
        for turn in ("-0.45", "-0.25", "0", "0.02", "0.2", "0.3", "0.5"):
            # As the numbers are read, and not as they would be in all digits.
            z = mpf(size) * exp(mpc(0, 1) * pi * mpf(turn))
            z = mpc(float(z.real), float(z.imag))
            row = digits(z)
            for order in range(3):
                row += digits(besseli(order, z) * exp(-z))
            for order in range(3):
                row += digits(besselk(order, z) * exp(z))
            rows.append(row)
    names = [f"{kind}{order}_{part}" for kind in "ik" for order in range(3) for part in ("re", "im")]
    write("bessel.csv", ["z_re", "z_im", *names], rows)


def waves(mu, rho, s):
    """1/length of vorticity, with what is regular at the axis and what dies away, each scaled to
    about 1 at a radius, so that the systems below are solvable."""
    k = sqrt(rho * s / mu)
    inward = lambda order, r, at: besseli(order, k * r) * exp(-k * at)
    outward = lambda order, r, at: besselk(order, k * r) * exp(k * at)
    return k, inward, outward


def turning_outside(mu, rho, outer, hole, s):
    """Torque per length and speed: v = A I1 + B K1 with v(outer) = outer, v(hole) = 0, and the
    shear -mu r d(v/r)/dr at the tube."""
    k, inward, outward = waves(mu, rho, s)
    sides = matrix([[inward(1, outer, hole), outward(1, outer, outer)],
                    [inward(1, hole, hole), outward(1, hole, outer)]])
    a, b = lu_solve(sides, matrix([outer, 0]))
    slope = a * k * (inward(0, outer, hole) - inward(1, outer, hole) / (k * outer))
    slope -= b * k * (outward(0, outer, outer) + outward(1, outer, outer) / (k * outer))
    return 2 * pi * outer**2 * mu * (1 - slope)


def turning_inside(mu, rho, inner, s):
    k, inward, _ = waves(mu, rho, s)
    a = inner / inward(1, inner, inner)
    slope = a * k * (inward(0, inner, inner) - inward(1, inner, inner) / (k * inner))
    return 2 * pi * inner**2 * mu * (slope - 1)


def sideways(mu, rho, outer, hole, s):
    """Force per length and speed across the hole: the stream function (A r + B/r + C I1 + D K1)
    sin(angle), its speed 1 at the tube and 0 at the hole. Pressure and shear add up to
    -pi rho s R (A R - B/R + C I1 + D K1)."""
    k, inward, outward = waves(mu, rho, s)
    rows, loads = [], []
    for r, moved in ((outer, 1), (hole, 0)):
        i0, i1 = inward(0, r, hole), inward(1, r, hole)
        k0, k1 = outward(0, r, outer), outward(1, r, outer)
        rows.append([1, outer**2 / r**2, i1 / r, k1 / r])
        rows.append([1, -(outer**2) / r**2, k * i0 - i1 / r, -k * k0 - k1 / r])
        loads += [moved, moved]
    a, b, c, d = lu_solve(matrix(rows), matrix(loads))
    carried = a * outer - b * outer + c * inward(1, outer, hole) + d * outward(1, outer, outer)
    return -pi * rho * s * outer * carried


def drag():
    rows = []
    for mu, rho, inner, outer, hole in (
        ("0.03", "1200", "0.054", "0.0635", "0.108"),
        ("0.001", "1000", "0.0381", "0.0825", "0.108"),
        ("0.2", "2100", "0.0357", "0.0889", "0.1"),
        ("0.05", "1500", "0.0381", "0.1", "0.101"),
        ("2", "1000", "0.02", "0.03", "0.5"),
    ):
        read = [mpf(float(it)) for it in (mu, rho, inner, outer, hole)]
        m, density, r_in, r_out, r_hole = read
        for size in ("1e-6", "0.01", "0.1", "1", "7", "60", "500", "6283", "60000"):
            for turn in ("0", "0.4", "-0.6"):
                s = mpf(size) * exp(mpc(0, 1) * pi * mpf(turn))
                s = mpc(float(s.real), float(s.imag))
                rows.append([mu, rho, inner, outer, hole, *digits(s),
                             *digits(turning_inside(m, density, r_in, s)),
                             *digits(turning_outside(m, density, r_out, r_hole, s)),
                             *digits(sideways(m, density, r_out, r_hole, s))])
    write("drag.csv", ["viscosity", "density", "inner", "outer", "hole", "s_re", "s_im", "inside_re",
                       "inside_im", "outside_re", "outside_im", "sideways_re", "sideways_im"], rows)


def modes():
    """Modes of 2000 m of pipe whose surface is held and whose bit is free."""
    shear, density, length = mpf("80e9"), mpf(7840), mpf(2000)
    inner, outer, hole = mpf("0.054"), mpf("0.0635"), mpf("0.108")
    mu, rho = mpf("0.03"), mpf(1200)
    moment = pi / 2 * (outer**4 - inner**4)

    def steel(s, factor):
        """1 + sum a s/(s + w), w from 0.01 Hz upwards by 4 to beyond 2 kHz."""
        rates = [2 * pi * mpf("0.01") * 4**step for step in range(10)]
        return 1 + sum(2 * factor * log(4) / pi * s / (s + rate) for rate in rates)

    rows = []
    for case, mud, damping, factor in (("mud", 1, "0", "0"), ("steel", 0, "0", "0.001"),
                                       ("all", 1, "0.03", "0.001")):
        for number in [*range(1, 21), 100, 500]:
            wave = (number - mpf(1) / 2) * pi / length

            def equation(s):
                drag = mpf(damping)
                if mud:
                    drag += turning_inside(mu, rho, inner, s) + turning_outside(mu, rho, outer, hole, s)
                stiff = shear * moment * steel(s, mpf(factor))
                return (s * (drag + s * density * moment) + stiff * wave**2) / (stiff * wave**2)

            bare = wave * sqrt(shear / density)
            guess = mpc(-mpf("0.002") * bare - mpf("0.05"), bare)
            # The square of what is left is what the tolerance is of.
            root = findroot(equation, (guess, guess * mpf("1.0001")), solver="secant", tol=mpf(10) ** -32)
            rows.append([case, number, mp.nstr(root.imag / (2 * pi), 15), mp.nstr(-root.real, 15)])
    write("modes.csv", ["case", "mode", "frequency_hz", "decay_per_s"], rows)


if __name__ == "__main__":
    bessel()
    drag()
    modes()
