# SPDX-License-Identifier: GPL-3.0-or-later
"""Servers that answer as none should: between `tan` and `tan serve` stands a proxy that changes some of the answers, their status, their
headers, their bytes and where they end."""
import contextlib
import http.client
import json
import re
import socket
import struct
import threading
import urllib.parse

import serving
from bench import BAD_INPUT, DONE, KINDS, OUT_OF_RESOURCE, USAGE
from mutants import MOST_MEMORY, checksum, legacy_mesh, measured, unusable

MESH_HEADER = "<8sIIQQIIQ"  # core/packed/PACKED_MESH.md
HUGE = "100000000000000000000000"
EVIL = "\x1b[31mEVIL\x1b]52;c;ZWNobyBoaQ==\x07\u009b\u202e\n\nx.vtu: proved"
# Of a text as the program shows it, none of these is left.
COMMANDS_OF_TERMINALS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


class Answer:
    """One of `tan serve`, which may be changed before it is sent."""

    def __init__(self, status, headers, body):
        self.status, self.headers, self.body = status, headers, bytearray(body)
        self.raw = None  # in place of all of it
        self.is_right_as_is = True

    def set(self, name, value):
        self.remove(name)
        self.headers.append((name, value))

    def remove(self, name):
        self.headers = [one for one in self.headers if one[0].lower() != name.lower()]

    def bytes(self):
        if self.raw is not None:
            return self.raw
        lines = ["HTTP/1.1 %s" % self.status] + ["%s: %s" % one for one in self.headers]
        return ("\r\n".join(lines) + "\r\n\r\n").encode("latin-1", "replace") + bytes(self.body)


# --- What is changed -----------------------------------------------------------------------------------------------------------------

def change_status(answer, chance):
    answer.status = chance.choice((100, 200, 204, 206, 301, 304, 401, 403, 404, 416, 418, 422, 429, 500, 503, 507, 999, "x", ""))
    answer.set("Retry-After", chance.choice(("0", "-1", "x")))
    if chance.random() < 0.5:
        change_words(answer, chance)


def change_words(answer, chance):
    """A refusal that would like to be obeyed, or to be long."""
    words = chance.choice((EVIL, "x" * 200_000, "", "%1 %2", "<b>" * 99, None, ["x"], {"error": {}}))
    answer.body = bytearray(json.dumps({"error": words}).encode())
    answer.set("Content-Type", chance.choice(("application/json", "text/html", "application/vnd.tan.mesh")))
    answer.set("Content-Length", len(answer.body))


def change_length(answer, chance):
    length = len(answer.body)
    answer.set("Content-Length", chance.choice((0, -1, HUGE, length + 1, max(length - 1, 0), "x", "%d, 3" % length, 2 ** 62)))
    if chance.random() < 0.2:
        answer.remove("Content-Length")
    if chance.random() < 0.2:
        answer.set("Transfer-Encoding", "chunked")
    if chance.random() < 0.1:
        answer.set("Content-Encoding", chance.choice(("gzip", "x")))


def change_range(answer, chance):
    """What of the file this is, and how long it is all in all."""
    numbers = [int(one) for one in re.findall(r"\d+", dict(answer.headers).get("Content-Range", ""))] or [0, len(answer.body), 99]
    at = chance.randrange(len(numbers))
    numbers[at] = chance.choice((0, 1, numbers[at] + 1, max(numbers[at] - 1, 0), 2 ** 60 - 1, 2 ** 63, int(HUGE)))
    text = "bytes %d-%d/%s" % (numbers[0], numbers[1], numbers[-1])
    answer.set("Content-Range", chance.choice((text, text, text, "bytes */0", "bytes", "", "furlongs 1-2/3", "bytes -5--1/-1")))


def change_headers(answer, chance):
    way = chance.randrange(6)
    if way == 0:
        answer.set("ETag", chance.choice(('""', "x", 'W/"1"', '"%s"' % ("e" * 5000), '"other"')))
    elif way == 1:
        answer.remove(chance.choice([name for name, _ in answer.headers] or ["ETag"]))
    elif way == 2:
        answer.set("Content-Type", chance.choice(("text/html", "", "application/json", "application/vnd.tan.mesh", "x" * 9000)))
    elif way == 3:
        answer.headers += [("X-%d" % i, "x") for i in range(chance.choice((3, 20_000)))]
    elif way == 4:
        answer.status = chance.choice((301, 302, 307, 308))
        answer.set("Location", chance.choice(("/", "file:///etc/passwd", "ftp://127.0.0.1/x", "http://127.0.0.1:1/x", "//", "?", EVIL[:9], "")))
    else:
        answer.set("Accept-Ranges", "none")


def change_bytes(answer, chance):
    """Another body of the same answer: flipped, cut, doubled, of zeros."""
    body, way = answer.body, chance.randrange(5)
    if not body:
        body += b"x"
    elif way == 0:
        for _ in range(chance.choice((1, 1, 5, 100))):
            body[chance.randrange(len(body))] ^= 1 << chance.randrange(8)
    elif way == 1:
        del body[chance.randrange(len(body)):]
    elif way == 2:
        body *= 2
    elif way == 3:
        at = chance.randrange(len(body))
        body[at:at + 4096] = bytes(len(body[at:at + 4096]))
    else:
        body[:] = chance.randbytes(len(body))
    if chance.random() < 0.8:
        answer.set("Content-Length", len(body))


def change_mesh(answer, chance):
    """A packed mesh with other numbers and a right checksum, which is what it then is."""
    size = struct.calcsize(MESH_HEADER)
    if not answer.body.startswith(serving.MESH_MAGIC) or len(answer.body) < size + 8:
        change_json(answer, chance)
        return
    answer.is_right_as_is = False
    body = answer.body[:-8]
    numbers = list(struct.unpack_from(MESH_HEADER, body))
    if chance.random() < 0.5:
        at = chance.randrange(1, len(numbers))
        most = 2 ** 32 if at in (1, 2, 5, 6) else 2 ** 64
        numbers[at] = chance.choice((0, 1, numbers[at] + 1, max(numbers[at] - 1, 0), 2 * numbers[at], 2 ** 30, most - 1)) % most
        struct.pack_into(MESH_HEADER, body, 0, *numbers)
        if at == 7 and chance.random() < 0.5:  # and bytes for the claim
            body += bytes(min(numbers[7], 2 << 20))
    else:
        for _ in range(chance.choice((1, 1, 10))):
            body[chance.randrange(size, len(body))] = chance.randrange(256)
        if chance.random() < 0.3:
            del body[chance.randrange(size, len(body)):]
    answer.body = body + struct.pack("<Q", checksum(body))
    answer.set("Content-Length", len(answer.body))


def change_json(answer, chance):
    """Facts and sizes with numbers and texts that nobody expects."""
    if not dict(answer.headers).get("Content-Type", "").startswith("application/json"):
        change_bytes(answer, chance)
        return
    answer.is_right_as_is = False
    text = answer.body.decode()
    numbers = list(re.finditer(r"-?\d[\d.e+-]*", text))
    if numbers and chance.random() < 0.7:
        one = chance.choice(numbers)
        text = text[:one.start()] + chance.choice(("-1", "0", "1e999", "1e308", HUGE, "null", "[]", '"x"', "true")) + text[one.end():]
    else:
        text = chance.choice(("[" * 100_000, "{}", "null", "", "[]", text[:len(text) // 2], text.replace('"', '"\\u001b[31m', 3), '{"error": 1}'))
    answer.body = bytearray(text.encode())
    answer.set("Content-Length", len(answer.body))


def change_all(answer, chance):
    """What is no HTTP."""
    whole = answer.bytes()
    answer.raw = chance.choice((b"", whole[:chance.randrange(len(whole))], chance.randbytes(5000), b"HTTP/1.1 ", b"HTTP/1.1 200 OK\r\n",
                                b"HTTP/1.1 100 Continue\r\n\r\n" * 5000 + whole, b"\r\n" * 5000 + whole, b"\x89TANM" * 99,
                                b"HTTP/1.1 200 OK\r\nX: " + b"x" * 2_000_000 + b"\r\n\r\n"))


CHANGES = (change_status, change_words, change_length, change_range, change_range, change_headers, change_bytes, change_bytes,
           change_mesh, change_mesh, change_json, change_all)


# --- The proxy -----------------------------------------------------------------------------------------------------------------------

class Proxy:
    """Gives what the server at `port` gives; from request `first` on one answer is changed, or all are."""

    def __init__(self, port, chance):
        self.port, self.chance = port, chance
        self.change, self.first, self.is_constant = chance.choice(CHANGES), chance.choice((0, 0, 0, 0, 1, 1, 2)), chance.random() < 0.6
        self.seen, self.changed, self.is_right_as_is, self.problem = 0, 0, True, None
        self.lock, self.open = threading.Lock(), set()
        self.socket = socket.create_server(("127.0.0.1", 0), backlog=64)
        self.own = self.socket.getsockname()[1]
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        while True:
            try:
                connection, _ = self.socket.accept()
            except OSError:
                return
            threading.Thread(target=self.serve, args=(connection,), daemon=True).start()

    def serve(self, connection):
        with connection, contextlib.suppress(OSError, ValueError, http.client.HTTPException):
            with self.lock:
                self.open.add(connection)
            file = connection.makefile("rb")
            while True:
                line, headers = file.readline(), {}
                while (one := file.readline()) not in (b"\r\n", b""):
                    name, _, value = one.decode("latin-1").partition(":")
                    headers[name] = value.strip()
                if not line:
                    return
                answer = self.answer(line.split()[1].decode("latin-1"), headers)
                connection.sendall(answer.bytes())
                if answer.raw is not None or dict(answer.headers).get("Content-Length") != str(len(answer.body)):
                    return  # what is promised and does not come would be waited for
        with self.lock:
            self.open.discard(connection)

    def answer(self, target, headers):
        upstream = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        try:
            upstream.request("GET", target, headers={name: value for name, value in headers.items() if name.lower() in ("range", "if-range")})
            got = upstream.getresponse()
            kept = [one for one in got.getheaders() if one[0].lower() not in ("connection", "date")]
            answer = Answer("%d %s" % (got.status, got.reason), kept, got.read())
        finally:
            upstream.close()
        with self.lock:
            number, self.seen = self.seen, self.seen + 1
            if number == self.first or (number > self.first and self.is_constant):
                try:
                    self.change(answer, self.chance)
                except Exception as problem:  # a mistake of the bench
                    self.problem = problem
                self.changed += 1
                self.is_right_as_is = self.is_right_as_is and answer.is_right_as_is
        return answer

    def close(self):
        self.socket.close()
        with self.lock:
            for one in self.open:
                with contextlib.suppress(OSError):
                    one.shutdown(socket.SHUT_RDWR)


# --- Attempts ------------------------------------------------------------------------------------------------------------------------

FETCHED = (("extract", "--error", "2"), ("extract", "--error", "0"), ("extract", "--budget", "700"), ("info", "--json"))
AT_SERVER = (("extract", "--error", "8"), ("extract", "--error", "0"), ("isosurface", "--error", "8", "--value", "VALUE"),
             ("render", "--error", "8", "--size", "64x48", "--backend", "cpu"))
WRITTEN = {"extract": "mesh.vtk", "isosurface": "surface.stl", "render": "picture.png"}


def command(bench, kind, words, address, is_at_server):
    target = WRITTEN.get(words[0])
    words = [words[0], address, *(bench.middle(kind) if one == "VALUE" else one for one in words[1:])]
    return words + (["--at-server"] if is_at_server else []) + (["-o", target] if target else []), target


def right_answer(bench, kind, words, is_at_server):
    """What it says or writes when nothing is changed."""
    def make():
        place = bench.whole / ("answers-%s-%s-%s" % (kind.name, is_at_server, "-".join(words)))
        place.mkdir(parents=True, exist_ok=True)
        arguments, target = command(bench, kind, words, serving.address_of(bench, kind), is_at_server)
        ran = bench.run(arguments, place)
        assert ran.code == DONE, ran.said()
        return (place / target).read_bytes() if target else facts(ran.out)
    return bench.once(("answer of a server", kind.name, words, is_at_server), make)


def facts(told):
    """What `tan info --json` tells, but for the address."""
    return {name: value for name, value in json.loads(told).items() if name != "file"}


def attempt(bench, folder, chance, number):
    """A model is fetched, or meshes of it are asked for at its server, of which some answers are not the server's."""
    kind, is_at_server = KINDS[number // 2 % len(KINDS)], number % 2 == 1
    words = chance.choice(AT_SERVER if is_at_server else FETCHED)
    right = right_answer(bench, kind, words, is_at_server)
    address = urllib.parse.urlsplit(serving.address_of(bench, kind))
    proxy = Proxy(address.port, chance)
    arguments, target = command(bench, kind, words, "http://127.0.0.1:%d%s" % (proxy.own, address.path), is_at_server)
    ran, memory = measured(bench, arguments, folder)
    proxy.close()
    if proxy.problem:
        raise proxy.problem
    failures = []
    if crash := ran.crash():
        failures.append(crash)
    elif ran.code not in (DONE, USAGE, BAD_INPUT, OUT_OF_RESOURCE):
        failures.append("exit code %d: %s" % (ran.code, ran.said()))
    elif ran.code != DONE and not ran.err.strip():
        failures.append("exit code %d without a word" % ran.code)
    if memory > MOST_MEMORY:
        failures.append("%d MB of memory" % (memory >> 20))
    if COMMANDS_OF_TERMINALS.search(ran.out.decode("utf-8", "replace")):
        failures.append("says what a terminal obeys")
    if ran.code == DONE:
        failures += wrong(folder, target, ran, right, proxy)
    left = {path.name for path in folder.iterdir()} - ({target} if ran.code == DONE else set())
    if left:
        failures.append("left behind: " + ", ".join(sorted(left)))
    told = "%s, %s of %s%s" % (" ".join(words), proxy.change.__name__, kind.name, " at its server" if is_at_server else "")
    outcome = "not changed" if not proxy.changed else "refused" if ran.code != DONE else "right"
    return outcome + (", at the server" if is_at_server else ", fetched"), ["%s: %s" % (told, one) for one in failures], \
        {"changed answers": proxy.changed}


def wrong(folder, target, ran, right, proxy):
    """What is written is what it is without the changes, unless the mesh or the facts that came are others with right checksums."""
    if target is None:
        return [] if not proxy.is_right_as_is or facts(ran.out) == right else ["other facts with exit code 0"]
    written = (folder / target).read_bytes()
    if proxy.is_right_as_is:
        return [] if written == right else ["a wrong answer with exit code 0"]
    problem = unusable(*legacy_mesh(folder / target)) if target.endswith(".vtk") else None
    return [problem] if problem else []
