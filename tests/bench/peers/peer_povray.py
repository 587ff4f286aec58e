"""POV-Ray draws the common raster as a height field in one colour, without light. The conversation is that of peer_loop.hpp.

    peer_povray.py FOLDER WIDTH HEIGHT

Each picture is a run of the program; its time is what it states for tracing alone, that for reading the scene is `start_ms`.
The depths come from a second run whose colours are the depth. POV-Ray's frame is left-handed: x east, y up, z north."""
import array
import math
import pathlib
import re
import subprocess
import sys

SIDE, EXTENT_M, FIELD_DEG, HEIGHT_STEPS = 2049, 61440, 45.0, 65536
FAR_M, FINE_M = 131072.0, 8.0  # red: the depth; green: its remainder
PLAIN = "pigment { color rgb <0.4, 0.5, 0.3> }"


def vector(east_north_up, scale=1.0):
    east, north, up = (scale * value for value in east_north_up)
    return f"<{east!r}, {up!r}, {north!r}>"


def axes_of(heading_deg, pitch_deg, roll_deg):
    """Forward, right, down: east, north, up (peer_frame.hpp)."""
    h, p, r = (math.radians(angle) for angle in (heading_deg, pitch_deg, roll_deg))
    forward = (math.sin(h) * math.cos(p), math.cos(h) * math.cos(p), math.sin(p))
    level = (math.cos(h), -math.sin(h), 0.0)
    below = tuple(forward[i - 2] * level[i - 1] - forward[i - 1] * level[i - 2] for i in range(3))
    right = tuple(a * math.cos(r) + b * math.sin(r) for a, b in zip(level, below))
    return forward, right, tuple(b * math.cos(r) - a * math.sin(r) for a, b in zip(level, below))


def depth_pigment(place, forward):
    """Colours of the depth along the axis; each third of the average has one channel three times as bright."""
    depth = "+".join(f"({f!r})*({axis}-({e!r}))" for f, e, axis in zip(forward, place, "xzy"))
    return f"""pigment {{ average pigment_map {{
    [1 function {{ ({depth})/{FAR_M!r} }} color_map {{ [0 rgb 0] [1 rgb <3, 0, 0>] }}]
    [1 function {{ ({depth})/{FINE_M!r} - floor(({depth})/{FINE_M!r}) }} color_map {{ [0 rgb 0] [1 rgb <0, 3, 0>] }}]
    [1 color rgb 0] }} }}"""


def write_scene(folder, pose, size, pigment):
    forward, right, down = axes_of(*pose[3:])
    tall = 2 * math.tan(math.radians(FIELD_DEG / 2))
    text = f"""#version 3.7;
global_settings {{ assumed_gamma 1.0 }}
camera {{ perspective location {vector(pose[:3])} direction {vector(forward)}
  right {vector(right, tall * size[0] / size[1])} up {vector(down, -tall)} }}
height_field {{ pgm "{folder}/povray.pgm" gamma 1.0 scale <{EXTENT_M}, {HEIGHT_STEPS}, {EXTENT_M}> {pigment}
  finish {{ ambient 0 diffuse 0 emission 1 }} }}
"""
    (folder / "povray.pov").write_text(text, encoding="ascii")


def run_povray(folder, size):
    """Returns what the program says."""
    command = ["povray", f"+I{folder}/povray.pov", f"+O{folder}/povray.ppm", "+FP16", f"+W{size[0]}", f"+H{size[1]}", "+WT2",
               "-D", "-A", "-V", "File_Gamma=1.0"]
    done = subprocess.run(command, capture_output=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"povray failed: {done.stderr.decode(errors='replace')[-500:]}")
    return done.stderr.decode(errors="replace")


def stated_ms(text, name):
    return 1000 * float(re.search(rf"{name} Time:.*?\(([\d.]+) seconds\)", text)[1])


def read_depths(file):
    data = file.read_bytes()
    head = re.match(rb"P6\s(?:#[^\n]*\n|\s)*(\d+)\s+(\d+)\s+65535\s", data)
    samples = array.array("H", data[head.end():])
    if sys.byteorder == "little":
        samples.byteswap()
    depths = array.array("f")
    for red, green in zip(samples[0::3], samples[1::3]):
        fine = FINE_M * green / 65535
        depths.append(math.inf if red == 0 and green == 0 else fine + FINE_M * round((FAR_M * red / 65535 - fine) / FINE_M))
    return depths


def write_ground(folder):
    posts = array.array("h", (folder / "ground.i16").read_bytes())
    if sys.byteorder == "little":
        posts.byteswap()
    (folder / "povray.pgm").write_bytes(f"P5\n{SIDE} {SIDE}\n65535\n".encode("ascii") + posts.tobytes())


def main():
    folder, size = pathlib.Path(sys.argv[1]), tuple(map(int, sys.argv[2:4]))
    write_ground(folder)
    said = subprocess.run(["povray", "--version"], capture_output=True, text=True, check=False)
    version = re.search(r"POV-Ray \d+(?:\.\d+)*", said.stdout + said.stderr)[0]
    print(f'ready {{"version": "{version}"}}', flush=True)
    for line in sys.stdin:
        pose = [float(word) for word in line.split()]
        write_scene(folder, pose, size, PLAIN)
        text = run_povray(folder, size)
        write_scene(folder, pose, size, depth_pigment(pose[:3], axes_of(*pose[3:])[0]))
        run_povray(folder, size)
        with open(folder / "povray.depth", "wb") as out:
            read_depths(folder / "povray.ppm").tofile(out)
        print(f'done {{"ms": [{stated_ms(text, "Trace"):.1f}], "start_ms": {stated_ms(text, "Parse"):.1f}}}', flush=True)


if __name__ == "__main__":
    main()
