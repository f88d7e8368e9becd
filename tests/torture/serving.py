# SPDX-License-Identifier: GPL-3.0-or-later
"""`tan serve` for the torture bench, and clients that ask it at random and judge what they get."""
import atexit
import http.client
import json
import random
import re
import signal
import threading
import time

from bench import KINDS, Ran

MESH_MAGIC = b"\x89TANM"


class Server:
    """Has no port if it did not get as far as to listen."""

    def __init__(self, bench, models, limits=None):
        self.process = bench.start(bench.command(("serve", models.name, "--port", "0", "--json")), models.parent, limits=limits)
        self.began, self.log, self.port = time.monotonic(), [], None
        line = self.process.stderr.readline()
        self.log.append(line)
        if found := re.search(rb"http://127\.0\.0\.1:(\d+)/", line):
            self.port = int(found.group(1))
        # Who does not read its log makes it wait.
        self.readers = [threading.Thread(target=self.read, args=(stream, lines), daemon=True)
                        for stream, lines in ((self.process.stderr, self.log), (self.process.stdout, self.__dict__.setdefault("out", [])))]
        for reader in self.readers:
            reader.start()

    @staticmethod
    def read(stream, lines):
        for line in stream:
            lines.append(line)

    def finish(self, patience=120):
        hung = False
        try:
            self.process.wait(patience)
        except Exception:
            hung = True
            self.process.kill()
            self.process.wait()
        for reader in self.readers:
            reader.join()
        return Ran(self.process.returncode, time.monotonic() - self.began, b"".join(self.out), b"".join(self.log), hung)


def model_name(kind):
    """Meshes tell the last part of it."""
    return kind.name.replace(" ", "-") + "/model.tan"


def put_model(bench, kind, models):
    place = models / model_name(kind)
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_bytes(bench.model(kind)[0])


def address_of(bench, kind):
    """Of a whole model, at a server that all attempts share."""
    def make():
        models = bench.whole / "served"
        for one in KINDS:
            put_model(bench, one, models)
        server = Server(bench, models)
        assert server.port, b"".join(server.log)
        atexit.register(lambda: (server.process.send_signal(signal.SIGINT), server.finish()))
        return server.port
    return "http://127.0.0.1:%d/%s" % (bench.once("server", make), model_name(kind))


class Load:
    """Clients that go on until the server does not answer. Before `stopping` that is a failure, unless they are lenient."""
    CLIENTS = 4

    def __init__(self, models, port, seed, lenient):
        self.files = {str(path.relative_to(models)): path.read_bytes() for path in models.rglob("*.tan")}
        self.port, self.lenient, self.stopping, self.ended = port, lenient, False, False
        self.lock, self.meshes, self.answers, self.failures = threading.Lock(), {}, 0, []
        self.threads = [threading.Thread(target=self.client, args=(random.Random(seed + i),), daemon=True) for i in range(self.CLIENTS)]
        for thread in self.threads:
            thread.start()

    def end(self):
        self.ended = True
        for thread in self.threads:
            thread.join()
        return self.answers, self.failures

    def client(self, chance):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        while not self.ended:
            target, headers, right = self.question(chance)
            try:
                connection.request("GET", target, headers=headers)
                answer = connection.getresponse()
                body = answer.read()
            except (OSError, http.client.HTTPException) as problem:
                connection.close()
                if self.stopping:
                    return
                if not self.lenient:
                    with self.lock:
                        self.failures.append("%s: %s" % (target, problem))
                    return
                time.sleep(0.02)
                continue
            with self.lock:
                self.answers += 1
                if answer.status not in ((503, 500) if self.lenient else (503,)) and not right(answer.status, body):
                    self.failures.append("%s: %d, %r" % (target, answer.status, body[:80]))

    def question(self, chance):
        name = chance.choice(sorted(self.files))
        whole = self.files[name]
        kind = chance.randrange(5)
        if kind == 0:
            return "/", {}, lambda status, body: status == 200 and {one["file"] for one in json.loads(body)["models"]} == set(self.files)
        if kind == 1:
            return "/" + name, {}, lambda status, body: status == 200 and body == whole
        if kind == 2:
            first = chance.randrange(len(whole))
            last = min(len(whole) - 1, first + chance.randrange(60_000))
            return "/" + name, {"Range": "bytes=%d-%d" % (first, last)}, lambda status, body: status == 206 and body == whole[first:last + 1]
        if kind == 3:
            return "/../" + name, {}, lambda status, body: status in (400, 404)
        target = "/%s?error=%s" % (name, chance.choice(("1", "5", "20")))

        def is_mesh(status, body):
            """That of the first answer."""
            return status == 200 and body.startswith(MESH_MAGIC) and body == self.meshes.setdefault(target, body)
        return target, {}, is_mesh
