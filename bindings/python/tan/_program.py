# SPDX-License-Identifier: GPL-3.0-or-later
"""The program `tan`, which has the readers of all formats, in a process of its own: for data that are files, and for the server."""
from __future__ import annotations

import json
import os
import pathlib
import re
import selectors
import shutil
import signal
import subprocess
import time
from typing import Any, Dict, List, Optional, Sequence, Tuple

from . import _tan
from ._errors import KINDS, BadInput, Error
from ._progress import Report

_GLANCE = 0.05
_PROGRESS = re.compile(r"^(.*): (\d+) %")


def program() -> str:
    """Where it is: TAN_PROGRAM names it; else it belongs to the library that is loaded, or lies on the PATH."""
    named = os.environ.get("TAN_PROGRAM")
    if named:
        return named
    library = pathlib.Path(_tan.library()).resolve()
    for folder in library.parents[:4]:
        if (folder / "bin" / "tan").is_file():
            return str(folder / "bin" / "tan")
    found = shutil.which("tan")
    if found is None:
        raise BadInput("The program 'tan', which reads data files, is not found. Install it, or let TAN_PROGRAM name it.")
    return found


def _start(words: Sequence[str]) -> subprocess.Popen[bytes]:
    # A session of its own: Ctrl-C of the terminal reaches this process alone, which passes it on once. It ends with this process.
    return subprocess.Popen([program(), *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            start_new_session=True, env={**os.environ, "LC_ALL": "C.UTF-8", "TAN_STOP_WITH": str(os.getpid())})


def stop(running: subprocess.Popen[bytes]) -> None:
    """As Ctrl-C does it: within a second, and nothing unfinished is left behind."""
    if running.poll() is None:
        running.send_signal(signal.SIGINT)
        try:
            running.wait(10)
        except subprocess.TimeoutExpired:
            running.kill()
            running.wait()


def _tell(line: str, report: Optional[Report]) -> None:
    told = _PROGRESS.match(line)
    if told and report is not None:
        report(int(told[2]) / 100, told[1])


def _gather(running: subprocess.Popen[bytes], report: Optional[Report]) -> Tuple[bytes, List[str]]:
    """What it writes until it ends, and what it says meanwhile."""
    assert running.stdout is not None and running.stderr is not None
    written, said = bytearray(), bytearray()
    lines: List[str] = []
    with selectors.DefaultSelector() as selector:
        selector.register(running.stdout, selectors.EVENT_READ, written)
        selector.register(running.stderr, selectors.EVENT_READ, said)
        while selector.get_map():
            for key, _ in selector.select(_GLANCE):
                part = os.read(key.fd, 1 << 16)
                if not part:
                    selector.unregister(key.fileobj)
                key.data.extend(part)
            while b"\n" in said:
                line, _, rest = bytes(said).partition(b"\n")
                said[:] = rest
                lines.append(line.decode(errors="replace"))
                _tell(lines[-1], report)
    running.wait()
    return bytes(written), lines + ([said.decode(errors="replace")] if said else [])


def run(words: Sequence[str], report: Optional[Report], accepted: Sequence[int] = (0,)) -> Dict[str, Any]:
    """What the program says as JSON. Its errors are exceptions. It is stopped by whatever is raised here meanwhile."""
    running = _start([*words, "--json"])
    try:
        written, lines = _gather(running, report)
    finally:
        stop(running)
        for stream in (running.stdout, running.stderr):
            if stream is not None:
                stream.close()
    try:
        answer: Dict[str, Any] = json.loads(written)
    except ValueError:
        answer = {}
    if running.returncode in accepted and answer:
        return answer
    sentence = answer.get("error") or " ".join(lines[-3:]) or f"The program 'tan' ended with the code {running.returncode}."
    raise KINDS.get(str(answer.get("kind")), Error)(str(sentence))


class Server:
    """`tan serve` in a process of its own: the models of a folder over HTTP. A context manager, which stops it at its end.

    address: "http://127.0.0.1:PORT/"; append a model's name and open it: tan.open(server.address + "engine.tan").
    """

    def __init__(self, words: Sequence[str]) -> None:
        self._running = _start(words)
        self.address = self._await_address()

    def _await_address(self) -> str:
        assert self._running.stderr is not None
        end, said = time.monotonic() + 60, ""
        while time.monotonic() < end:
            line = self._running.stderr.readline().decode(errors="replace")
            found = re.search(r" at (http://\S+) until", line)
            if found:
                return found[1]
            said += line
            if not line:
                break
        stop(self._running)
        raise Error(said.strip() or "The server does not answer.")

    def stop(self) -> None:
        """Ends the server. It may be called again."""
        stop(self._running)
        for stream in (self._running.stdout, self._running.stderr):
            if stream is not None:
                stream.close()

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *problem: object) -> None:
        self.stop()

    def __del__(self) -> None:
        if hasattr(self, "_running"):
            self.stop()

    def __repr__(self) -> str:
        return f"<tan.Server {self.address}>"
