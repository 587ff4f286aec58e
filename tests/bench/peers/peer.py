"""The peers, and the conversation with one of them (peer_loop.hpp): a program that answers poses."""
import json
import shutil
import subprocess

SYSTEM_PYTHON = "/usr/bin/python3"  # the one that Debian's VTK belongs to


class PeerError(Exception):
    """What a peer did wrong, as one sentence."""


class Peer:
    """One row of the table. `bound`: the peer's own, a pair of number and unit ("px" or "m"); "stated": its answers say it."""

    def __init__(self, name, command, depths, surface, bound=None, needs_display=False, max_poses=None):
        self.name, self.command, self.depths, self.surface, self.bound = name, command, depths, surface, bound
        self.needs_display, self.max_poses = needs_display, max_poses
        self.process, self.fault = None, None
        self.version, self.build_ms = "", None
        self.ms, self.triangles, self.found = [], [], []

    def start(self, folder, size, environment):
        """Leaves a fault where it cannot start."""
        program, *options = self.command
        words = [*program, folder, size[0], size[1], *options]
        words = (["xvfb-run", "-a"] if self.needs_display else []) + [str(word) for word in words]
        with open(folder / "peers.log", "a", encoding="utf-8") as log:
            self.process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log, text=True,
                                            env=environment)
        said = self._hear("ready")
        self.version, self.build_ms = said["version"], said.get("build_ms")

    def _hear(self, word):
        for line in self.process.stdout:  # libraries say other things in between
            if line.startswith(word + " "):
                return json.loads(line[len(word):])
        raise PeerError(f"{self.name} ended without an answer; see peers.log.")

    def draws(self, number):
        return self.process is not None and self.fault is None and (self.max_poses is None or number < self.max_poses)

    def draw(self, pose):
        """Returns the bound of this picture: a pair of number and unit, or None."""
        self.process.stdin.write(" ".join(str(value) for value in pose) + "\n")
        self.process.stdin.flush()
        said = self._hear("done")
        self.ms += said["ms"]
        if "triangles" in said:
            self.triangles.append(said["triangles"])
        return (said["bound_px"], "px") if self.bound == "stated" else self.bound

    def stop(self):
        if self.process is None:
            return
        self.process.stdin.close()
        try:
            self.process.wait(timeout=30)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()


def all_peers(bin_folder, povray_poses):
    """Ours first, then the others; those that are not installed have that fault."""
    rays, triangles, ogre = ([bin_folder / name] for name in ("peer_rays", "peer_triangles", "peer_ogre"))
    script = [SYSTEM_PYTHON, "-B", __file__.replace("peer.py", "peer_vtk.py")]
    povray = ["python3", "-B", __file__.replace("peer.py", "peer_povray.py")]
    peers = [
        Peer("ours: rays", [rays, "own"], "rays-own", "flat"),
        Peer("ours: triangles, 1 px, one colour", [triangles, "plain-1"], "triangles-plain-1", "earth", "stated"),
        Peer("ours: triangles, 1 px, shaded", [triangles, "shaded-1"], "triangles-shaded-1", "earth",
             "stated"),
        Peer("Embree: grid", [rays, "embree-grid"], "rays-embree-grid", "flat"),
        Peer("Embree: triangles", [rays, "embree-triangles"], "rays-embree-triangles", "flat"),
        Peer("OGRE Terrain: 1 px", [ogre, "1"], "ogre-1", "either", (1, "px"), True),
        Peer("OGRE Terrain: 8 px (its default)", [ogre, "8"], "ogre-8", "either", (8, "px"), True),
        Peer("VTK: whole mesh", [script, "whole"], "vtk-whole", "flat", None, True),
        Peer("VTK: decimated, 20 m", [script, "decimated-20"], "vtk-decimated-20", "either", (20, "m"), True),
        Peer("POV-Ray: height_field", [povray], "povray", "either", None, False, povray_poses),
        Peer("control: our rays, 10 m too high", [rays, "control"], "rays-control", "flat", (1, "px")),
    ]
    has_vtk = subprocess.run([SYSTEM_PYTHON, "-c", "import vtk, numpy"], capture_output=True, check=False).returncode == 0
    for peer in peers:
        program = peer.command[0]
        if program is script:
            is_there = has_vtk
        elif program is povray:
            is_there = shutil.which("povray") is not None
        else:
            is_there = program[0].exists()
        if not is_there or (peer.needs_display and shutil.which("xvfb-run") is None):
            peer.fault = "not installed"
    return peers
