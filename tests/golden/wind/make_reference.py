#!/usr/bin/env python3
"""Writes reference.txt: means of winds as astropy's circular statistics have them, weighted by speed.

Debian package python3-astropy (made with 5.2.1); not needed to build or test. Run it in this folder.
"""
import astropy
import numpy as np
from astropy.stats import circmean, circvar

SETS = [  # winds, mean direction (deg), spread of directions (deg), least and greatest speed (m/s)
    (1, 243, 0, 7, 7),
    (2, 0, 14, 3, 9),
    (7, 359, 20, 2, 25),
    (24, 120, 35, 0.5, 40),
    (51, 271, 60, 1, 12),
    (200, 45, 90, 4, 5),
    (400, 180, 200, 1, 30),
]


def main():
    random = np.random.default_rng(20)
    with open("reference.txt", "w", encoding="ascii") as out:
        out.write(f"# astropy {astropy.__version__}, circmean and 1 - circvar of directions weighted by speed; by make_reference.py\n")
        out.write("# a set each: winds, mean direction (deg), constancy, mean speed (m/s); then direction (deg) and speed of each\n")
        for count, direction, spread, least, greatest in SETS:
            degrees = np.round((direction + spread * random.standard_normal(count)) % 360, 3)
            speed = np.round(random.uniform(least, greatest, count), 3)
            mean = np.degrees(circmean(np.radians(degrees), weights=speed)) % 360
            constancy = 1 - circvar(np.radians(degrees), weights=speed)
            out.write(f"{count} {mean:.9f} {constancy:.12f} {speed.mean():.12f}\n")
            for d, s in zip(degrees, speed):
                out.write(f"{d:.3f} {s:.3f}\n")


main()
