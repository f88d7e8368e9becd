#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""serve_load.py TAN FOLDER [--requests 10000] [--clients 16] [--minutes N] [--pause S]: starts `TAN serve FOLDER` and asks it at random, for the
list, for ranges of the folder's models and for meshes of them, so many times or for so long, with so many clients at once, of which each
pauses S seconds after an answer. Prints how many requests a second were answered, the times they took, by what was asked for, and the
server's memory at the start, after a tenth, each minute if it goes on for minutes, and at the end. Fails if an answer is wrong, or if memory
has grown by more than a quarter since that tenth."""
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


def resident(pid):
    status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    return int(status.split("VmRSS:")[1].split()[0]) / 1024


def anonymous(pid):
    """Without the pages of mapped files, which the system takes back when it needs them."""
    status = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    return int(status.split("RssAnon:")[1].split()[0]) / 1024


class Load:
    def __init__(self, folder, port, arguments):
        self.folder, self.port, self.left, self.end = folder, port, arguments.requests, time.time() + 60 * (arguments.minutes or 0)
        self.timed, self.lock, self.times, self.failures = bool(arguments.minutes), threading.Lock(), {}, []
        self.pause = arguments.pause
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
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
        while self.take():
            kind, target, headers, expected = self.question(rng)
            begun = time.time()
            try:
                connection.request("GET", target, headers=headers)
                answer = connection.getresponse()
                body = answer.read()
            except (OSError, http.client.HTTPException) as problem:
                if isinstance(problem, (http.client.RemoteDisconnected, ConnectionResetError)):  # it was open long enough
                    connection.close()
                    continue
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
            time.sleep(self.pause)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tan")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--requests", type=int, default=10_000)
    parser.add_argument("--clients", type=int, default=16)
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--pause", type=float, default=0)
    arguments = parser.parse_args()
    server = subprocess.Popen([arguments.tan, "serve", str(arguments.folder), "--port", "0"], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL,
                              text=True)
    port = int(server.stderr.readline().rsplit(":", 1)[1].split("/")[0])
    threading.Thread(target=lambda: [None for _ in server.stderr], daemon=True).start()
    load = Load(arguments.folder, port, arguments)
    first, begun = anonymous(server.pid), time.time()
    clients = [threading.Thread(target=load.client, args=(seed,)) for seed in range(arguments.clients)]
    for client in clients:
        client.start()
    tenth, minutes = None, []
    while any(client.is_alive() for client in clients):
        time.sleep(0.2)
        far = (time.time() - begun) / (60 * arguments.minutes) if arguments.minutes else load.done / arguments.requests
        if tenth is None and far >= 0.1:
            tenth = anonymous(server.pid)
        if arguments.minutes and time.time() - begun >= 60 * (len(minutes) + 1):
            minutes.append(anonymous(server.pid))
            print(f"{len(minutes)} min: {minutes[-1]:.0f} MB, {load.done} requests", file=sys.stderr, flush=True)
    last, seconds, mapped = anonymous(server.pid), time.time() - begun, resident(server.pid)
    server.send_signal(signal.SIGINT)
    stopping = time.time()
    code = server.wait()
    print(f"{load.done} requests, {arguments.clients} at once: {seconds:.1f} s, {load.done / seconds:.0f} a second; ended in "
          f"{time.time() - stopping:.2f} s")
    for kind, times in sorted(load.times.items()):
        times.sort()
        print(f"  {kind}: {len(times)}, median {1000 * statistics.median(times):.1f} ms, 99th percentile "
              f"{1000 * times[len(times) * 99 // 100]:.1f} ms, longest {1000 * times[-1]:.1f} ms")
    print(f"  memory without mapped files: {first:.0f} MB at the start, {tenth or last:.0f} after a tenth, {last:.0f} at the end; with them "
          f"{mapped:.0f}")
    if minutes:
        print("  each minute: " + " ".join(f"{megabytes:.0f}" for megabytes in minutes))
    for failure in load.failures:
        print("FAIL:", failure)
    return 1 if load.failures or code != 0 or last > 1.25 * (tenth or last) + 20 else 0


sys.exit(main())
