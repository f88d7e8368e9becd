#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""serve_load.py TAN FOLDER [--requests 10000] [--clients 16] [--minutes N] [--pause S] [--reconnect N] [--every S]: starts `TAN serve FOLDER`
and asks it at random, for the list, for ranges of the folder's models and for meshes of them, so many times or for so long, with so many
clients at once, of which each pauses S seconds after an answer and makes a new connection after N of them, so that other threads of the
server answer. Prints how many requests a second were answered, the times they took, by what was asked for, and the server's memory every S
seconds: at rest, for which all clients wait, so that it is what the server keeps and not what a mesh takes meanwhile. Fails if an answer is
wrong, or if memory without mapped files is at any time in the last third more than 8 MB above the most of the first third."""
import argparse
import http.client
import json
import pathlib
import random
import signal
import statistics
import subprocess
import sys
import threading
import time
import urllib.parse


def memory(pid):
    """MB without and with the pages of mapped files, which the system takes back when it needs them."""
    pages = pathlib.Path(f"/proc/{pid}/smaps_rollup").read_text(encoding="utf-8")
    return [int(pages.split(name)[1].split()[0]) / 1024 for name in ("Anonymous:", "Rss:")]


class Load:
    def __init__(self, folder, port, arguments):
        self.folder, self.port, self.left, self.end = folder, port, arguments.requests, time.time() + 60 * (arguments.minutes or 0)
        self.timed, self.lock, self.times, self.failures = bool(arguments.minutes), threading.Lock(), {}, []
        self.pause, self.reconnect = arguments.pause, arguments.reconnect
        self.resting, self.working, self.changed = False, 0, threading.Condition()
        connection = http.client.HTTPConnection("127.0.0.1", port)
        connection.request("GET", "/")
        self.models = json.load(connection.getresponse())["models"]
        self.done = 0

    def take(self):
        with self.lock:
            if self.failures:
                return False
            if self.timed:
                return time.time() < self.end
            self.left -= 1
            return self.left >= 0

    def begin(self):
        with self.changed:
            self.changed.wait_for(lambda: not self.resting)
            self.working += 1

    def finish(self):
        with self.changed:
            self.working -= 1
            self.changed.notify_all()

    def at_rest(self, look):
        with self.changed:
            self.resting = True
            self.changed.wait_for(lambda: self.working == 0)
        time.sleep(0.1)  # for the server to have put away what it sent last
        seen = look()
        with self.changed:
            self.resting = False
            self.changed.notify_all()
        return seen

    def question(self, rng):
        model = rng.choice(self.models)
        kind = rng.choice(["list", "range", "range", "range", "mesh", "window", "focus", "budget"])
        if kind == "list":
            return kind, "/", {}, None
        if kind == "range":
            first = rng.randrange(model["bytes"])
            last = min(model["bytes"] - 1, first + rng.randrange(1, 200_000))
            with open(self.folder / model["file"], "rb") as file:
                file.seek(first)
                return kind, model["url"], {"Range": f"bytes={first}-{last}"}, file.read(last - first + 1)
        numbers = [rng.uniform(0, 30) for _ in range(6)]
        box = ",".join(f"{min(numbers[i], numbers[i + 3]):.2f}" for i in range(3)) + "," + ",".join(
            f"{max(numbers[i], numbers[i + 3]):.2f}" for i in range(3))
        query = {"mesh": {"error": f"{rng.uniform(1, 10):.2f}"},
                 "window": {"error": f"{rng.uniform(1, 10):.2f}", "window": box},
                 "focus": {"error": "10", "focus": "sphere:" + ",".join(f"{n:.2f}" for n in numbers[:4]), "focus-error": "1"},
                 "budget": {"budget": str(rng.randrange(1000, 50_000))}}[kind]
        return kind, model["url"] + "?" + urllib.parse.urlencode(query), {}, None

    def client(self, seed):
        rng = random.Random(seed)
        connection, asked = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120), 0
        while self.take():
            self.begin()
            try:
                self.ask(rng, connection)
            finally:
                self.finish()
            asked += 1
            if asked % self.reconnect == 0:
                connection.close()
            time.sleep(self.pause)

    def ask(self, rng, connection):
        kind, target, headers, expected = self.question(rng)
        begun = time.time()
        try:
            connection.request("GET", target, headers=headers)
            answer = connection.getresponse()
            body = answer.read()
        except (OSError, http.client.HTTPException) as problem:
            connection.close()
            if not isinstance(problem, (http.client.RemoteDisconnected, ConnectionResetError)):  # it was open long enough
                self.failures.append(f"{target}: {problem}")
            return
        right = answer.status in (200, 206, 503) or (answer.status == 400 and b"No tetrahedron" in body)
        right = right or (answer.status == 400 and b"coarsest" in body)
        if answer.status == 200 and "?" in target:
            right = body.startswith(b"\x89TANM")
        if not right or (expected is not None and answer.status == 206 and body != expected):
            self.failures.append(f"{target}: {answer.status} {body[:200]}")
            return
        with self.lock:
            self.done += 1
            self.times.setdefault(kind if answer.status != 503 else "refused, busy", []).append(time.time() - begun)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tan")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--requests", type=int, default=10_000)
    parser.add_argument("--clients", type=int, default=16)
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--pause", type=float, default=0)
    parser.add_argument("--reconnect", type=int, default=1000)
    parser.add_argument("--every", type=float, default=10)
    arguments = parser.parse_args()
    server = subprocess.Popen([arguments.tan, "serve", str(arguments.folder), "--port", "0"], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL,
                              text=True)
    port = int(server.stderr.readline().rsplit(":", 1)[1].split("/")[0])
    threading.Thread(target=lambda: [None for _ in server.stderr], daemon=True).start()
    load = Load(arguments.folder, port, arguments)
    kept, begun = [memory(server.pid)], time.time()
    clients = [threading.Thread(target=load.client, args=(seed,)) for seed in range(arguments.clients)]
    for client in clients:
        client.start()
    while any(client.is_alive() for client in clients):
        time.sleep(0.2)
        if time.time() - begun >= arguments.every * len(kept):
            kept.append(load.at_rest(lambda: memory(server.pid)))
            print(f"{time.time() - begun:.0f} s: {kept[-1][0]:.1f} MB, {load.done} requests", file=sys.stderr, flush=True)
    kept.append(memory(server.pid))
    seconds = time.time() - begun
    server.send_signal(signal.SIGINT)
    stopping = time.time()
    code = server.wait()
    print(f"{load.done} requests, {arguments.clients} at once: {seconds:.1f} s, {load.done / seconds:.0f} a second; ended in "
          f"{time.time() - stopping:.2f} s")
    for kind, times in sorted(load.times.items()):
        times.sort()
        print(f"  {kind}: {len(times)}, median {1000 * statistics.median(times):.1f} ms, 99th percentile "
              f"{1000 * times[len(times) * 99 // 100]:.1f} ms, longest {1000 * times[-1]:.1f} ms")
    print("  memory without mapped files, MB: " + " ".join(f"{anonymous:.0f}" for anonymous, _ in kept) + f"; with them {kept[-1][1]:.0f}")
    third, own = max(1, (len(kept) - 1) // 3), [anonymous for anonymous, _ in kept[1:]]
    early, late = own[:third], own[-third:]
    print(f"  first third: median {statistics.median(early):.1f}, most {max(early):.1f}; last third: median {statistics.median(late):.1f}, most "
          f"{max(late):.1f}")
    for failure in load.failures:
        print("FAIL:", failure)
    mostGrowth = 8
    return 1 if load.failures or code != 0 or max(late) > max(early) + mostGrowth else 0


sys.exit(main())
