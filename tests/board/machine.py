#!/usr/bin/env python3
"""Boots an emulated machine with a real Linux kernel and drives it: commands, CAN frames, GPIO lines, pictures of its screen.

The machine is what tests/board/fetch_guest and make_initramfs made. All traffic goes over unix sockets and 9p shares; it has no
network. Every wait has a limit, and no emulator outlives this program. Standard library only.

    machine.py --arch x86_64 [--vkms] [--size 640x480] [--share NAME=FOLDER[:rw]] [--screenshot OUT.ppm] [--limit S] COMMAND...

boots, runs the command in the guest, prints what it prints, and ends with its exit status. The shares lie at /NAME; /build (this
checkout's build folder), /source (the checkout) and /work (build/board/ARCH, writable) are always there.
"""
import argparse
import ctypes
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

TOP = pathlib.Path(__file__).resolve().parents[2]
ARCHITECTURES = ("aarch64", "x86_64")
# The emulated vector units of newer processors are slower than these (-cpu max draws at half the rate).
EMULATORS = {
    "aarch64": ["qemu-system-aarch64", "-M", "virt,gic-version=3", "-cpu", "cortex-a57"],
    "x86_64": ["qemu-system-x86_64", "-M", "q35", "-cpu", "Nehalem", "-vga", "none"],
}
# Page-table isolation empties the emulator's cache of pages at every system call; with random addresses it translates code
# anew for every process.
KERNEL_LINES = {
    "aarch64": "console=ttyAMA0 quiet panic=-1 mitigations=off kpti=off nokaslr norandmaps",
    "x86_64": "console=ttyS0 quiet panic=-1 norandmaps mitigations=off random.trust_cpu=on tsc=reliable",
}
BOOT_LIMIT_S, SYSTEM_LIMIT_S = 90, 240
DISK_MODULES = ("virtio_blk", "crc32c_generic", "ext4")
PR_SET_PDEATHSIG = 1


class MachineError(Exception):
    """One sentence about what went wrong."""


def end_with_parent():
    """Called in the emulator's process before it starts: it is killed when this program ends in any way."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


class Channel:
    """A console of the guest: a unix socket that is read up to a pattern, within a limit."""

    def __init__(self, path, is_alive, limit_s=20, keeps_returns=False):
        self._is_alive, self._keeps_returns = is_alive, keeps_returns
        self._bytes = b""
        self._socket = socket.socket(socket.AF_UNIX)
        end = time.monotonic() + limit_s
        while True:
            try:
                return self._socket.connect(str(path))
            except OSError:
                if not is_alive() or time.monotonic() > end:
                    raise MachineError("the emulator opens no console.") from None
                time.sleep(0.02)

    def write(self, data):
        self._socket.settimeout(20)
        self._socket.sendall(data)

    def read_until(self, pattern, limit_s):
        """Returns the match and what came before it."""
        end = time.monotonic() + limit_s
        while True:
            match = re.search(pattern, self._bytes)
            if match:
                before, self._bytes = self._bytes[:match.start()], self._bytes[match.end():]
                return match, before.decode(errors="replace")
            left = end - time.monotonic()
            if left <= 0:
                raise MachineError(f"the guest does not answer within {limit_s} s; it said: {self._tail()}")
            self._receive(min(left, 1))

    def take(self, limit_s):
        """Returns what has come, which is empty after the limit."""
        self._receive(limit_s)
        taken, self._bytes = self._bytes, b""
        return taken

    def close(self):
        self._socket.close()

    def _receive(self, limit_s):
        self._socket.settimeout(limit_s)
        try:
            data = self._socket.recv(65536)
        except socket.timeout:
            return
        except ConnectionError:
            data = b""
        if not data or not self._is_alive():
            raise MachineError(f"the machine ended unexpectedly; it said: {self._tail()}")
        self._bytes += data if self._keeps_returns else data.replace(b"\r", b"")

    def _tail(self):
        return self._bytes[-500:].decode(errors="replace") or "nothing"


class Monitor:
    """QEMU's own protocol (QMP): pictures of the screen, and the end of the machine."""

    def __init__(self, path, is_alive):
        self._channel = Channel(path, is_alive)
        self._channel.read_until(rb"\n", 20)
        self.ask("qmp_capabilities")

    def ask(self, command, **arguments):
        self._channel.write(json.dumps({"execute": command, "arguments": arguments}).encode() + b"\n")
        while True:  # events come between
            _, line = self._channel.read_until(rb"\n", 20)
            answer = json.loads(line)
            if "error" in answer:
                raise MachineError(f"{command}: {answer['error'].get('desc', answer)}")
            if "return" in answer:
                return answer["return"]

    def close(self):
        self._channel.close()


class Machine:
    """A guest from boot to end; use it in a `with` statement.

    arch      "aarch64" or "x86_64"
    shares    names and folders of further 9p shares, at /name in the guest; ":rw" behind the folder: writable
    modules   modules beyond those that init always loads, for example "vkms"
    size      width and height of the screen of virtio-gpu
    boot_s    seconds from the start of the emulator to a shell that answers
    sent_can  CAN frames that the guest has sent, once count_sent_can() was called
    panel_folder   of the guest's lines in /sys, after make_panel()
    work      this machine's folder that is /work in the guest
    can_cards   CAN controllers (Kvaser PCIcanX with an SJA1000 each) on one bus, which are can0, can1, ... of the guest; x86_64
    disk      a disk of tests/board/make_image; its system is booted, and what it changes is forgotten at the end
    keeps_disk   the disk is only there (/dev/vda), and keeps what is written
    instruction_ns   the guest's clocks count this for each instruction (a power of two), and leap where the guest has nothing to do;
              so programs within it are as fast by its clocks on a busy machine as on a free one. None: they run with this
              machine's clock
    """

    def __init__(self, arch, shares=None, modules=(), size=(640, 480), memory_mib=1024, disk=None, keeps_disk=False,
                 instruction_ns=None, can_cards=0):
        self.instruction_ns, self.can_cards = instruction_ns, can_cards
        self.arch, self.modules, self.size, self.memory_mib = arch, tuple(modules), size, memory_mib
        self.disk, self.keeps_disk = disk, keeps_disk
        self.work = TOP / "build" / "board" / arch
        self.shares = {"build": str(TOP / "build"), "source": str(TOP), "work": f"{self.work}:rw", **(shares or {})}
        self.boot_s = 0.0
        self.sent_can = 0
        self.panel_folder = None
        self._process = self._shell = self._can = self._monitor = None
        self._asked = 0

    def __enter__(self):
        try:
            self._boot()
        except BaseException:
            self.close()
            raise
        return self

    def __exit__(self, *_):
        self.close()

    # The command console

    def run(self, command, limit_s=60):
        """Runs a shell command in the guest; returns its exit status and what it printed."""
        self._asked += 1
        self._shell.write(f"{command}\necho '@@'{self._asked}:$status:\n".encode())
        match, output = self._shell.read_until(rb"@@%d:(\d+):\n" % self._asked, limit_s)
        return int(match[1]), output

    def must(self, command, limit_s=60):
        """Like run(), for a command that has to succeed; returns what it printed."""
        status, output = self.run(command, limit_s)
        if status != 0:
            raise MachineError(f"the guest's command `{command}` ended with {status}: {output.strip() or 'no output'}")
        return output

    def start(self, name, command):
        """Starts a command in the background, with its output in work/NAME.out and work/NAME.err; returns its process number."""
        for ending in ("out", "err"):
            (self.work / f"{name}.{ending}").unlink(missing_ok=True)  # of an earlier run
        return int(self.must(f"{command} >/work/{name}.out 2>/work/{name}.err & echo $!").split()[-1])

    def is_running(self, pid):
        """Tells an ended process, which the shell keeps until it is waited for, from a running one."""
        return self.run(f"grep -qs '^State:.[^Z]' /proc/{pid}/status")[0] == 0

    def stop(self, pid, limit_s=30):
        """Ends a started command by SIGTERM; returns its exit status."""
        self.run(f"kill -TERM {pid}")
        end = time.monotonic() + limit_s
        while self.is_running(pid):
            if time.monotonic() > end:
                self.run(f"kill -KILL {pid}")
                raise MachineError(f"process {pid} of the guest does not end within {limit_s} s of SIGTERM.")
            time.sleep(0.05)
        return self.run(f"wait {pid}", 10)[0]

    def reboot(self):
        """Ends the system of the disk and boots it again; returns the seconds. CAN and GPIO must be made anew."""
        begin = time.monotonic()
        self._shell.write(b"systemctl reboot\n")
        self._shell.read_until(rb"SHELLUP\n", SYSTEM_LIMIT_S)
        return time.monotonic() - begin

    def said(self, name):
        """What a started command has printed into work/NAME so far; empty before it began."""
        path = self.work / name
        return path.read_text(errors="replace") if path.exists() else ""

    # Files. The guest reads its shares fast in large pieces only, not page by page as a program that starts does.

    def uptime_offset_s(self):
        """What time.monotonic() is ahead of the guest's monotonic clock, and its tolerance: half the time that asking took."""
        asked = []
        for _ in range(5):
            begin = time.monotonic()
            uptime = float(self.must("cut -d' ' -f1 /proc/uptime"))
            end = time.monotonic()
            asked.append(((end - begin) / 2, (begin + end) / 2 - uptime))
        return min(asked)[1], min(asked)[0]

    def processor_s(self):
        """Seconds of this machine's processors that the emulator has used."""
        words = pathlib.Path(f"/proc/{self._process.pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
        return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")

    def load(self, path, name):
        """Copies a file of this machine, below the build folder or elsewhere, into the guest's memory, executable."""
        shutil.copy(path, self.work / "loaded")
        self.must(f"dd bs=512k if=/work/loaded of={name} 2>/dev/null && chmod 755 {name}")

    def load_drivers(self):
        """Reads Mesa's libraries into the guest's page cache, and takes the shaders that earlier runs compiled (keep_shaders)."""
        folder = f"/usr/lib/{self.arch}-linux-gnu"
        libraries = f"{folder}/libLLVM-*.so.1 {folder}/dri/swrast_dri.so"
        self.must(f"for f in {libraries}; do dd bs=512k if=$f of=/dev/null 2>/dev/null; done")
        if self._shaders().exists():
            shutil.copy(self._shaders(), self.work / "shaders.tar")
            self.run("tar xf /work/shaders.tar -C /tmp")
        self.must("export MESA_SHADER_CACHE_DIR=/tmp/shaders; mkdir -p /tmp/shaders")

    def keep_shaders(self):
        """Keeps what Mesa has compiled beside the guest's kernel: compiling takes most of a program's start."""
        self.must("tar cf /work/shaders.tar -C /tmp shaders")
        part = self._shaders().with_suffix(f".{os.getpid()}")
        shutil.copy(self.work / "shaders.tar", part)
        part.replace(self._shaders())

    def _shaders(self):
        return TOP / "build" / "guests" / self.arch / "shaders.tar"

    # CAN: the serial line interface (slcan) of the guest's kernel, whose serial line is a console

    def open_can(self):
        """Makes the guest's interface slcan0, fed by send_can()."""
        self.plug_can("slcan0")
        self.must("ip link set slcan0 up")

    def plug_can(self, name):
        """Makes an interface of the guest that is down, fed by send_can()."""
        self.must(f"slcand -o -s8 /dev/hvc1 {name}")
        self.must(f"for i in $(seq 50); do [ -d /sys/class/net/{name} ] && break; sleep 0.1; done; ip link show {name}", 20)

    def send_can(self, frames):
        """Sends frames (11-bit identifier, data) to the guest with one write."""
        lines = (f"t{frame.identifier:03X}{len(frame.data)}{frame.data.hex().upper()}\r" for frame in frames)
        self._can.write("".join(lines).encode())

    def count_sent_can(self):
        """Takes from now on what the guest itself sends on slcan0, which would wait otherwise, and counts the frames in sent_can."""
        threading.Thread(target=self._take_can, daemon=True).start()

    def _take_can(self):
        while self._can is not None:
            try:
                self.sent_can += self._can.take(1).count(b"\r")
            except (MachineError, OSError):
                return

    # GPIO: gpio-sim of the guest's kernel

    def make_panel(self, label, names):
        """Makes a GPIO chip with a label and a line for each name, all pulled down."""
        bank = "/sys/kernel/config/gpio-sim/panel/bank"
        lines = "; ".join(f"mkdir {bank}/line{i}; echo {shlex.quote(name)} >{bank}/line{i}/name" for i, name in enumerate(names))
        self.must(f"mkdir -p {bank}; echo {len(names)} >{bank}/num_lines; echo {shlex.quote(label)} >{bank}/label; {lines}")
        self.must("echo 1 >/sys/kernel/config/gpio-sim/panel/live")
        device = self.must("cat /sys/kernel/config/gpio-sim/panel/dev_name").strip()
        chip = self.must(f"cat {bank}/chip_name").strip()
        self.panel_folder = f"/sys/devices/platform/{device}/{chip}"
        self._pulls = {name: f"{self.panel_folder}/sim_gpio{i}/pull" for i, name in enumerate(names)}

    def throw_lines(self, **levels):
        """Pulls the named lines up (True) or down (False), one right after the other."""
        self.must("; ".join(f"echo pull-{'up' if level else 'down'} >{self._pulls[name]}" for name, level in levels.items()))

    # Pictures

    def screenshot(self, path):
        """Writes what the screen of virtio-gpu shows to a PPM file."""
        self._monitor.ask("screendump", filename=str(path))

    # Start and end

    def close(self):
        """Ends the machine; may be called more than once. A further Ctrl-C does not disturb it: this takes 10 s at most."""
        if self._process is None:
            return
        before = signal.signal(signal.SIGINT, signal.SIG_IGN)
        try:
            self._end_emulator()
        finally:
            signal.signal(signal.SIGINT, before)

    def _end_emulator(self):
        try:
            if self._monitor is not None and self._process.poll() is None:
                self._monitor.ask("quit")
                self._process.wait(5)
        except (MachineError, OSError, subprocess.TimeoutExpired):
            pass
        self._process.kill()
        self._process.wait()
        self._process = None
        for channel in (self._monitor, self._shell, self._can):
            if channel is not None:
                channel.close()
        shutil.rmtree(self._sockets, ignore_errors=True)

    def console_log(self):
        """What kernel and init said."""
        return self.said("console.log")

    def _boot(self):
        prepare_guest(self.arch)
        self.work.mkdir(parents=True, exist_ok=True)
        self._sockets = tempfile.mkdtemp(prefix="tedavis-board-")  # names of sockets must be short
        begin = time.monotonic()
        with open(self.work / "qemu.log", "w", encoding="utf-8") as log:
            self._process = subprocess.Popen(self._command(), stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                                             preexec_fn=end_with_parent, start_new_session=True)
        try:
            self._monitor = Monitor(f"{self._sockets}/qmp", self._is_alive)
            self._shell = Channel(f"{self._sockets}/shell", self._is_alive)
            self._can = Channel(f"{self._sockets}/can", self._is_alive, keeps_returns=True)
            self._shell.read_until(rb"SHELLUP\n", BOOT_LIMIT_S if self.disk is None else SYSTEM_LIMIT_S)
        except MachineError as error:
            emulator = (self.work / "qemu.log").read_text(errors="replace")
            raise MachineError(f"the guest does not come up: {error}\n{emulator}{self.console_log()[-2000:]}") from None
        self.boot_s = time.monotonic() - begin

    def _is_alive(self):
        return self._process.poll() is None

    def _command(self):
        guest = TOP / "build" / "guests" / self.arch
        modules = self.modules if self.disk is None else (*self.modules, *DISK_MODULES)
        if self.can_cards > 0:
            modules = (*modules, "kvaser_pci")
        tags = ",".join(f"{name}:rw" if folder.endswith(":rw") else name for name, folder in self.shares.items())
        line = f"{KERNEL_LINES[self.arch]} shares={tags} modules={','.join(modules)}"
        if self.disk is not None and not self.keeps_disk:
            line += " system=disk"
        # KVM is no choice: a nested one boots no stock kernel, although /dev/kvm opens.
        command = [*EMULATORS[self.arch], "-accel", "tcg", "-smp", "1", "-m", str(self.memory_mib)]
        if self.instruction_ns is not None:
            command += ["-icount", f"shift={self.instruction_ns.bit_length() - 1},sleep=off"]
        command += ["-nodefaults", "-no-user-config", "-display", "none"]
        if self.disk is None or self.keeps_disk:
            command += ["-no-reboot"]
        command += ["-kernel", str(guest / "vmlinuz"), "-initrd", str(self.work / "initramfs.img"), "-append", line]
        command += ["-serial", f"file:{self.work / 'console.log'}", "-qmp", f"unix:{self._sockets}/qmp,server=on,wait=off"]
        command += ["-device", "virtio-serial-pci"]
        for name in ("shell", "can"):
            command += ["-chardev", f"socket,id={name},path={self._sockets}/{name},server=on,wait=off"]
            command += ["-device", f"virtconsole,chardev={name}"]
        command += ["-device", f"virtio-gpu-pci,xres={self.size[0]},yres={self.size[1]}"]
        if self.can_cards > 0:
            command += ["-object", "can-bus,id=bus"] + ["-device", "kvaser_pci,canbus=bus"] * self.can_cards
        if self.disk is not None:
            path = os.path.realpath(self.disk).replace(",", ",,")
            changes = "off" if self.keeps_disk else "on"
            command += ["-drive", f"if=none,id=disk,file={path},format=raw,cache=unsafe,snapshot={changes}"]
            command += ["-device", "virtio-blk-pci,drive=disk"]
        root = "/" if self.arch == "x86_64" else str(TOP / "build" / "sysroots" / self.arch)
        for name, folder in {"root": root, **self.shares}.items():
            mode = "security_model=none" if folder.endswith(":rw") else "security_model=none,readonly=on"
            path = os.path.realpath(folder.removesuffix(":rw")).replace(",", ",,")
            command += ["-virtfs", f"local,path={path},mount_tag={name},{mode},multidevs=remap"]
        return command


def prepare_guest(arch):
    """Fetches the guest, and the libraries that it reads, where they are missing, and packs its initramfs anew."""
    if shutil.which(EMULATORS[arch][0]) is None:
        raise MachineError(f"{EMULATORS[arch][0]} is missing; run toolchains/install_packages guest.")
    scripts = TOP / "tests" / "board"
    folder = TOP / "build" / "board" / arch
    folder.mkdir(parents=True, exist_ok=True)
    sysroot = [] if arch == "x86_64" else [[TOP / "toolchains" / "make_sysroot", arch]]
    for command in (*sysroot, [scripts / "fetch_guest", arch], [scripts / "make_initramfs", arch, folder / "initramfs.img"]):
        done = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False)
        if done.returncode != 0:
            raise MachineError(done.stderr.strip().splitlines()[-1])


def end_on_sigterm():
    """SIGTERM ends the program as Ctrl-C does, so that `with` statements end their machines."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))


def parse_size(text):
    match = re.fullmatch(r"(\d+)x(\d+)", text)
    if match is None:
        raise argparse.ArgumentTypeError("is no size like 640x480")
    return int(match[1]), int(match[2])


def parse_share(text):
    name, equals, folder = text.partition("=")
    if not equals or re.fullmatch(r"\w+", name) is None or not os.path.isdir(folder.removesuffix(":rw")):
        raise argparse.ArgumentTypeError("is no NAME=FOLDER of a folder that is there")
    return name, folder


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--arch", choices=ARCHITECTURES, default="x86_64")
    parser.add_argument("--vkms", action="store_true", help="also load vkms, whose flips come with vertical blanks")
    parser.add_argument("--size", type=parse_size, default=(640, 480), help="the screen of virtio-gpu")
    parser.add_argument("--share", type=parse_share, action="append", default=[], metavar="NAME=FOLDER[:rw]")
    parser.add_argument("--screenshot", metavar="OUT.ppm", help="written when the command has ended")
    parser.add_argument("--limit", type=float, default=120, metavar="S", help="seconds that the command may take (120)")
    parser.add_argument("command", nargs="+", help="a shell command for the guest")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    end_on_sigterm()
    modules = ("vkms",) if arguments.vkms else ()
    try:
        with Machine(arguments.arch, dict(arguments.share), modules, arguments.size) as machine:
            print(f"machine: booted in {machine.boot_s:.1f} s", file=sys.stderr)
            status, output = machine.run(" ".join(arguments.command), arguments.limit)
            print(output, end="")
            if arguments.screenshot:
                machine.screenshot(os.path.abspath(arguments.screenshot))
            return status
    except MachineError as error:
        print(f"machine: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
