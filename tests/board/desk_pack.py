"""What the desk does for a board in the emulated machine: it makes the signed pack that both start from."""
import os
import pathlib
import re
import subprocess

from machine import TOP, MachineError

SMALL_TRIANGLES = 10000
# What an integrator makes on the desk: a configuration and a design of its own, which go into the pack with all that they name.
DESIGN_FILE = """name = "made on the desk"
based_on = "default"
[terrain]
unknown_color = "#50402a"
[terrain.shade]
ambient = 0.45
[phases]
takeoff = "takeoff"
cruise = "cruise"
approach = "approach"
"go_around.abort" = "approach"
"go_around.replanning" = "replanning"
"""
CONFIG_FILE = """title = "board in an emulated machine"
device = "device.toml"
design = "design.toml"
designs = "{top}/configs/designs"
palettes = "{top}/configs/palettes"
bus = "{top}/configs/buses/canaerospace.toml"
[terrain]
database = "{top}/target/self_test_data/terrain.tdb"
[can]
interface = "slcan0"
[switches]
config = "{top}/configs/switches/one_hot.toml"
[surface]
backend = "kms"
width_px = {width}
height_px = {height}
[screen]
driver = "virtio_gpu"
[memory]
touch = false
"""


def run_program(arguments, environment=None):
    """Runs a program of this machine."""
    try:
        done = subprocess.run(arguments, env={**os.environ, **(environment or {})}, capture_output=True, text=True, check=False)
    except FileNotFoundError as error:
        raise MachineError(f"`{arguments[0]}` is missing; `toolchains/install_packages core desk tests` and a build make "
                           "it.") from error
    if done.returncode != 0:
        raise MachineError(f"`{pathlib.Path(arguments[0]).name}` ended with {done.returncode}: {done.stderr.strip()[-500:]}")


def write_device(small, path):
    """The shipped device; where the picture is small with fewer triangles, which take most of a frame's time."""
    text = (TOP / "configs/devices/es2-small.toml").read_text(encoding="utf-8")
    if small:
        text = re.sub(r"(?m)^triangle_budget = \d+", f"triangle_budget = {SMALL_TRIANGLES}", text)
    path.write_text(text, encoding="utf-8")


def make_pack(small, size, folder):
    """Makes the pack that desk and board start from, and the key that it is signed with; returns the pack."""
    write_device(small, folder / "device.toml")
    (folder / "design.toml").write_text(DESIGN_FILE, encoding="ascii")
    config = CONFIG_FILE.format(top=TOP, width=size[0], height=size[1])
    (folder / "config.toml").write_text(config, encoding="utf-8")
    run_program(["minisign", "-G", "-W", "-f", "-p", folder / "pack.pub", "-s", folder / "pack.key"])
    pack = folder / "pack"
    tedavis = TOP / "build/host/bin/tedavis"
    run_program([tedavis, "pack", folder / "config.toml", "-o", pack, "--replace", "--sign", folder / "pack.key"])
    return pack
