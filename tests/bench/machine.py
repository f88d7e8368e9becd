# SPDX-License-Identifier: GPL-3.0-or-later
"""What a figure depends on besides the program: the machine, the compiler, the revision, and what else the machine does meanwhile."""
import datetime
import os
import pathlib
import platform
import re
import subprocess


def output_of(*words, folder=None):
    try:
        return subprocess.run(words, cwd=folder, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def text_of(path):
    try:
        return pathlib.Path(path).read_text(encoding="utf-8")
    except OSError:
        return ""


def first(pattern, text, otherwise="unknown"):
    found = re.search(pattern, text, re.MULTILINE)
    return found.group(1).strip() if found else otherwise


def compiler_of(build):
    cache = text_of(build / "CMakeCache.txt")
    version = output_of(first(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, "c++"), "--version").partition("\n")[0]
    return f"{version or 'unknown'}, {first(r'^CMAKE_BUILD_TYPE:STRING=(.*)$', cache)}"


def describe_machine(build):
    return {"processor": first(r"^model name\s*:(.*)$", text_of("/proc/cpuinfo"), platform.machine()),
            "cores": len(os.sched_getaffinity(0)),
            "memory_bytes": os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES"),
            "system": first(r'^PRETTY_NAME="(.*)"$', text_of("/etc/os-release"), platform.system()),
            "compiler": compiler_of(build)}


def describe_revision(source):
    """The revision, and whether what is measured was changed since."""
    measured = ("app", "core", "plugins", "ui", "tests/bench/*.cpp", "tests/bench/*.h", "CMakeLists.txt", "CMakePresets.json")
    return {"revision": output_of("git", "rev-parse", "--short=10", "HEAD", folder=source) or "unknown",
            "changed": bool(output_of("git", "status", "--porcelain", "--untracked-files=no", "--", *measured, folder=source))}


def now():
    return datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC")


class Watch:
    """From its making to stop(): the seconds, and the share of the machine's time that others had."""

    def __init__(self):
        self.start = self.busy_and_whole()

    @staticmethod
    def busy_and_whole():
        """Seconds of all cores, in work and altogether; those of the programs that this one started and that have ended; the clock."""
        ticks = [int(word) for word in text_of("/proc/stat").partition("\n")[0].split()[1:9]] or [0] * 8
        second = os.sysconf("SC_CLK_TCK")
        times = os.times()
        busy = sum(ticks) - ticks[3] - ticks[4]
        return busy / second, sum(ticks) / second, times.children_user + times.children_system, times.elapsed

    def stop(self):
        busy, whole, own, seconds = (after - before for before, after in zip(self.start, self.busy_and_whole()))
        return {"seconds": round(seconds, 1), "others_share": round(max(0.0, busy - own) / whole, 3) if whole > 0 else 0.0}
