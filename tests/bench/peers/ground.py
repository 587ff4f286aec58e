"""The raster and the poses that all peers draw: made once in the work folder, always the same bits for the same source.

Frame: flat, metres, x east, y north, z up; the south-west post is the origin; posts every 30 m. The heights are those of the
source, its first 2049 columns and rows; its own spacing and place are not used. For our terrain database the same posts lie round
0 N 0 E, in steps of longitude and latitude that are 30 m there.
"""
import array
import math
import random
import subprocess
import sys

SIDE, SPACING_M = 2049, 30
SEED = 20261130
SEMI_MAJOR_M, MERIDIAN_RADIUS_M = 6378137.0, 6335439.327292  # WGS84, at the equator


def _run(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"`{' '.join(str(word) for word in command)}` failed: {done.stderr.strip()}")


def make_ground(folder, source, tedavis):
    """Writes ground.i16, ground.tif and ground.tdb. `source`: a raster of that many posts or more; None: generated."""
    mark = folder / "ground.source"
    if mark.exists() and mark.read_text(encoding="utf-8") == str(source) and (folder / "ground.tdb").exists():
        return
    raster = source
    if raster is None:
        raster = folder / "generated.tif"
        _run([tedavis, "terrain", "fractal", "--size", SIDE, "--seed", SEED, "-o", raster])
    cut = ["gdal_translate", "-q", "-srcwin", 0, 0, SIDE, SIDE, "-ot", "Int16"]
    _run(cut + ["-of", "ENVI", raster, folder / "ground.i16"])
    east, north = (math.degrees((SIDE * SPACING_M / 2) / radius) for radius in (SEMI_MAJOR_M, MERIDIAN_RADIUS_M))
    corners = ["-a_ullr", repr(-east), repr(north), repr(east), repr(-north)]
    _run(cut + ["-a_srs", "EPSG:4326", *corners, raster, folder / "ground.tif"])
    _run([tedavis, "terrain", "build", folder / "ground.tif", "-o", folder / "ground.tdb"])
    mark.write_text(str(source), encoding="utf-8")


def read_posts(folder):
    """The heights in metres, rows from the north."""
    posts = array.array("h", (folder / "ground.i16").read_bytes())
    if sys.byteorder == "big":
        posts.byteswap()
    return posts


def make_poses(posts, count):
    """Poses over the middle of the raster: 150 to 3000 m above the ground below, pitch -15 to 2 degrees, banked by up to 20
    degrees. A pose with ground within 300 m of it that rises to less than 100 m below it is not taken."""
    chance, poses = random.Random(SEED), []
    while len(poses) < count:
        x, y = (chance.uniform(0.15, 0.85) * (SIDE - 1) * SPACING_M for _ in range(2))
        above = 150 * 20 ** chance.random()
        heading, pitch, roll = chance.uniform(0, 360), chance.uniform(-15, 2), chance.uniform(-20, 20)
        column, row = round(x / SPACING_M), SIDE - 1 - round(y / SPACING_M)
        z = posts[row * SIDE + column] + above
        near = max(max(posts[r * SIDE + column - 10:r * SIDE + column + 11]) for r in range(row - 10, row + 11))
        if near < z - 100:
            poses.append(tuple(round(value, 3) for value in (x, y, z, heading, pitch, roll)))
    return poses


def write_poses(poses, file):
    lines = ["# x_m y_m z_m heading_deg pitch_deg roll_deg; vertical field of view 45 degrees"]
    lines += [" ".join(f"{value:.3f}" for value in pose) for pose in poses]
    file.write_text("\n".join(lines) + "\n", encoding="ascii")
