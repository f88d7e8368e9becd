# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of the torture bench. Each is a function of one attempt: it gets a folder of its own and a source of chance, and gives
what came of it in two or three words, what went wrong, in sentences, and, where it counts something, numbers by name."""
import json
import os
import re
import resource
import shutil
import signal
import time
import zlib
from dataclasses import dataclass
from typing import Callable

import answers
import bombs
import mutants
import repeated
import serving
from bench import BAD_INPUT, CANCELLED, DONE, FORMS, KINDS, OUT_OF_RESOURCE, QUERIES, USAGE, content


@dataclass(frozen=True)
class Part:
    name: str
    purpose: str
    attempt: Callable
    count: int
    short: int
    in_parallel: bool = True
    counted: Callable = None  # how many attempts there are at most, where that is a number

    def most(self, bench):
        return self.counted(bench) if self.counted else 10 ** 9

    def numbers(self, bench, count):
        """Of all attempts, or of so many."""
        return range(min(self.count if count is None else count, self.most(bench)))

    def some_numbers(self, bench):
        """Far from each other: neighbours do similar things."""
        if self.counted:
            return [self.most(bench) * i // self.short for i in range(self.short)]
        return range(0, 11 * self.short, 11)


def unexpected(ran, allowed):
    """Failures of the way in which a program ended."""
    if crash := ran.crash():
        return [crash]
    if ran.code not in allowed:
        return ["exit code %d: %s" % (ran.code, ran.said())]
    if ran.code != DONE and not ran.err.strip():
        return ["exit code %d without a word" % ran.code]
    return []


PACKED = [kind for kind in KINDS if kind.is_packed]


def written_commands():
    """The kinds of models that are built (query None), and what writes a file: the queries, of packed models those that unpack all or
    the beginning into the cache, and the ways from one form into the other."""
    for kind in KINDS:
        yield kind, None
    for name, query in QUERIES.items():
        if query[-1].startswith("OUT."):
            yield KINDS[0], name
    for kind in PACKED:
        yield from ((kind, name) for name in ("unpack", "extract", "finest"))
    for name in ("lattice", "blocks", "decimated"):
        yield next(kind for kind in KINDS if kind.name == name), "pack"


WRITTEN = tuple(written_commands())


# --- Kills ---------------------------------------------------------------------------------------------------------------------

def kill(bench, folder, chance, number):
    """kill -9 at a random moment: the old file or the new one is there, and the same command works again and leaves nothing."""
    case = number % (len(WRITTEN) + 1)
    if case == len(WRITTEN):
        return kill_session_writes(bench, folder, chance)
    kind, query = WRITTEN[case]
    arguments, target, whole, seconds = bench.prepare(kind, query, folder)
    # Another model, so that old and new can be told apart. Only models are overwritten by models.
    of_model = query is None or query in FORMS
    old = bench.model(KINDS[(KINDS.index(kind) + 1) % len(KINDS)])[0] if of_model else b"what was there before"
    before = set(content(folder))
    overwrites = chance.random() < 0.7
    if overwrites:
        (folder / target).write_bytes(old)
    resumes = query is None and chance.random() < 0.5
    words = [*arguments, "--resume"] if resumes else arguments
    process = bench.start(bench.command(words), folder)
    time.sleep(chance.random() * seconds)
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    found = (folder / target).read_bytes() if (folder / target).exists() else None
    failures = []
    if found not in ((old, whole) if overwrites else (None, whole)):
        failures.append("after the kill %s holds neither the old nor the new" % target)
    again = bench.run(words, folder)
    failures += unexpected(again, (DONE,))
    if not failures and (folder / target).read_bytes() != whole:
        failures.append("%s after the kill is not what it is without one" % target)
    left = set(content(folder)) - before - {target}
    if left:
        failures.append("left behind: " + ", ".join(sorted(left)))
    return "killed %s" % ("before it was written" if found in (None, old) else "afterwards"), failures


def kill_session_writes(bench, folder, chance):
    """A program writes sessions and settings again and again: what is there when it dies can be read and is one of them."""
    writer = bench.build / "tests/tan-torture-writes"
    process = bench.start([str(writer), "write", str(folder)], folder)
    time.sleep(0.1 + 0.4 * chance.random())
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    checked = bench.finish(bench.start([str(writer), "check", str(folder)], folder))
    return "killed while writing sessions", unexpected(checked, (DONE,))


# --- Damage --------------------------------------------------------------------------------------------------------------------

PAGE = 4096


def damage(data, chance):
    """Flipped bits, a page of zeros, two pages exchanged, or the end cut off; and what was done."""
    data = bytearray(data)
    way = chance.choice(("bits", "bits", "byte", "zeros", "exchanged", "cut"))
    pages = len(data) // PAGE
    if way == "bits":
        for _ in range(chance.randint(1, 3)):
            data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    elif way == "byte":
        data[chance.randrange(len(data))] = chance.randrange(256)
    elif way == "zeros":
        page = chance.randrange(pages)
        data[page * PAGE:(page + 1) * PAGE] = bytes(PAGE)
    elif way == "exchanged":
        one, other = (chance.randrange(pages) * PAGE for _ in range(2))
        data[one:one + PAGE], data[other:other + PAGE] = data[other:other + PAGE], data[one:one + PAGE]
    else:
        del data[chance.randrange(len(data)):]
    return bytes(data)


def damaged_model(bench, folder, chance, number):
    """Three queries of a damaged model: each gives the right answer, or none and exit code 3."""
    kind = KINDS[number % len(KINDS)]
    (folder / "model.tan").write_bytes(damage(bench.model(kind)[0], chance))
    failures, refused = [], 0
    for name in chance.sample(sorted(QUERIES), 3):
        ran, told = bench.ask(kind, name, folder)
        wrong = unexpected(ran, (DONE, BAD_INPUT))
        if ran.code == DONE and told != bench.answer(kind, name)[0]:
            wrong.append("a wrong answer with exit code 0")
        if ran.code == BAD_INPUT:
            refused += 1
            if told is not None:
                wrong.append("an answer is left although the command failed")
        failures += ["%s of %s: %s" % (name, kind.name, one) for one in wrong]
    extra = {path for path in content(folder) if path.endswith(".partial")}
    if extra:
        failures.append("left behind: " + ", ".join(sorted(extra)))
    return "refused by %d of 3 queries" % refused, failures


# --- Cut and mutated files -------------------------------------------------------------------------------------------------------

def answer_of_input(bench, one, folder):
    """What a dataset says, in the folder: how building and extracting ended, and the mesh of it all."""
    built = bench.run(("build", one.opened, *one.options, "-o", "model.tan"), folder)
    if built.code != DONE:
        return built, None
    mesh = bench.run(("extract", "model.tan", "--error", "0", "-o", "mesh.vtu"), folder)
    return mesh, (folder / "mesh.vtu").read_bytes() if mesh.code == DONE else None


def whole_answer(bench, one):
    def make():
        place = bench.whole / "answers" / one.name
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        one.copy_to(place)
        return answer_of_input(bench, one, place)[1]
    return bench.once(("input", one.name), make)


def last_token(data):
    """Where the last word of a text begins; the end of what is no text. A number that is cut within is a number, too."""
    if b"\0" in data:
        return len(data)
    return len(data.rstrip()) - len(re.search(rb"\S*$", data.rstrip()).group())


def cut_file(bench, folder, chance, number):
    """A dataset that was cut anywhere, to nothing even: refused, or the same mesh as that of the whole."""
    known = bench.inputs()
    one = known[number % len(known)]
    one.copy_to(folder)
    victim = folder / chance.choice(one.files())
    data = victim.read_bytes()
    most = max(last_token(data), 1)
    kept = chance.choice((0, chance.randrange(most), chance.randrange(most), chance.randrange(most * 9 // 10, most + 1)))
    if kept >= most:
        kept = most - 1
    victim.write_bytes(data[:kept])
    ran, mesh = answer_of_input(bench, one, folder)
    failures = unexpected(ran, (DONE, BAD_INPUT, USAGE))
    may_differ = one.open_ended and kept > 0 and victim == folder / one.opened
    if mesh is not None and mesh != whole_answer(bench, one) and not may_differ:
        failures.append("%s cut after %d of %d bytes is read as something else" % (victim.name, kept, len(data)))
    left = {path for path in content(folder) if ".partial" in path or path.endswith(".work")}
    if left:
        failures.append("left behind: " + ", ".join(sorted(left)))
    return "accepted" if mesh is not None else "refused", ["%s: %s" % (one.name, failure) for failure in failures]


def mutate(data, chance):
    data = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 5, 20))):
        if not data:
            break
        at = chance.randrange(min(len(data), chance.choice((200, 2000, 10 ** 9))))
        way = chance.randrange(6)
        if way == 0:
            data[at] ^= 1 << chance.randrange(8)
        elif way == 1:
            data[at:at + 1] = bytes([chance.randrange(256)])
        elif way == 2:
            del data[at:at + chance.choice((1, 2, 8, 64))]
        elif way == 3:
            data[at:at] = data[at:at + chance.choice((1, 4, 16, 256))]
        elif way == 4:
            data[at:at + 4] = chance.choice((b"\xff\xff\xff\xff", b"\0\0\0\0", b"\x7f\xff\xff\xff", b"\0\0\0\x80"))
        else:
            number = re.search(rb"\d+", data[at:])
            if number:
                new = chance.choice((b"0", b"-1", b"4294967297", b"99999999999999999999", b"1e309", b"nan", b"2147483647", b"65536"))
                data[at + number.start():at + number.end()] = new
    return bytes(data)


def mutated_file(bench, folder, chance, number):
    """A dataset with random changes: read or refused; what is built of it is what `tan verify` says it is."""
    known = bench.inputs()
    one = known[number % len(known)]
    one.copy_to(folder)
    victim = folder / chance.choice(one.files())
    victim.write_bytes(mutate(victim.read_bytes(), chance))
    limits = {resource.RLIMIT_AS: 8 << 30}
    told = bench.run(("info", one.opened, *one.options, "--json"), folder, limits=limits)
    failures = unexpected(told, (DONE, USAGE, BAD_INPUT, OUT_OF_RESOURCE))
    outcome = "refused"
    if told.code == DONE:
        outcome = "read"
        if chance.random() < 0.5:
            built = bench.run(("build", one.opened, *one.options, "-o", "model.tan"), folder, limits=limits)
            failures += unexpected(built, (DONE, BAD_INPUT, OUT_OF_RESOURCE))
            if built.code == DONE:
                proved = bench.run(("verify", "model.tan", "--against", one.opened, "--lod", "5,1,0"), folder, limits=limits)
                failures += ["verify: " + failure for failure in unexpected(proved, (DONE,))]
                outcome = "read and proved"
    return outcome, ["%s: %s" % (one.name, failure) for failure in failures]


# --- Writes, allocations, limits -------------------------------------------------------------------------------------------------

def write_failures(bench):
    """Each call that writes, of each command: (command, number of the call)."""
    def make():
        found = []
        for which, (kind, query) in enumerate(WRITTEN):
            place = bench.whole / ("writes-%d" % which)
            shutil.rmtree(place, ignore_errors=True)
            place.mkdir(parents=True)
            ran, *_ = run_with_failure(bench, place, kind, query, 0)
            assert ran.code == DONE, ran.said()
            calls = int((place / "calls").read_text())
            found += [(which, call) for call in range(1, calls + 1)]
        return found
    return bench.once("write failures", make)


def run_with_failure(bench, place, kind, query, call):
    """A command of which one call that writes fails as on a full disk; call 0: none does, and their number is in the file `calls`."""
    arguments, target, whole, _ = bench.prepare(kind, query, place)
    before = content(place)
    library = bench.build / "tests/libtan-failing-writes.so"
    ran = bench.run(arguments, place, environment={"LD_PRELOAD": str(library), "TAN_FAILING_CALL": str(call),
                                                   "TAN_FAILING_FOLDER": str(place), "TAN_FAILING_COUNT": str(place / "calls")})
    return ran, before, target, whole


def failed_write(bench, folder, chance, number):
    """One call that writes fails as on a full disk: said with exit code 4, and nothing is left; or it did not matter."""
    which, call = write_failures(bench)[number]
    kind, query = WRITTEN[which]
    ran, before, target, whole = run_with_failure(bench, folder, kind, query, call)
    failures = unexpected(ran, (DONE, OUT_OF_RESOURCE))
    (folder / "calls").unlink(missing_ok=True)
    after = content(folder)
    if ran.code == DONE and after.get(target) != whole:
        failures.append("exit code 0, but %s is not what it is without the failure" % target)
    # Where the folder cannot be synced after the renaming, the whole file is there and not certain to survive a power failure.
    expected = dict(before, **({target: whole} if ran.code == DONE or after.get(target) == whole else {}))
    if left := set(after) - set(expected):
        failures.append("left behind: " + ", ".join(sorted(left)))
    if changed := [name for name in before if after.get(name) != expected[name]]:
        failures.append("changed: " + ", ".join(changed))
    return "told" if ran.code else "did not matter", ["%s, call %d: %s" % (query or "build " + kind.name, call, one) for one in failures]


def allocations(bench):
    """Each allocation of each of the program's cases: (case, number of the allocation)."""
    def make():
        place = bench.whole / "allocations"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        ran = run_allocations(bench, place, "count")
        assert ran.code == DONE, ran.said()
        counts = [[int(number) for number in line.split()] for line in ran.out.decode().splitlines()]
        return [(case, call) for case, calls in counts for call in range(calls)]
    return bench.once("allocations", make)


def run_allocations(bench, folder, *words):
    """The program of small builds, beside files of others: how many allocations it makes depends on these, too."""
    for name in ("a dataset of somebody else.nrrd", "notes on datasets of somebody else.txt"):
        (folder / name).write_text("not to be touched")
    return bench.finish(bench.start([str(bench.build / "tests/tan-failing-allocations"), *map(str, words)], folder))


def failed_allocation(bench, folder, chance, number):
    """One allocation of a small build fails: told as lack of memory, and nothing leaks or is left."""
    case, call = allocations(bench)[number]
    ran = run_allocations(bench, folder, "fail", case, call)
    failures = unexpected(ran, (DONE,))
    if left := {name for name in content(folder) if not name.endswith((".nrrd", ".txt"))}:
        failures.append("left behind: " + ", ".join(sorted(left)))
    return "went wrong" if failures else "told, and nothing leaked", ["case %d, allocation %d: %s" % (case, call, one) for one in failures]


def tight_limit(bench, folder, chance, number):
    """A limit of memory, file size or descriptors: the right answer, or exit code 4, and nothing left."""
    kind, query = WRITTEN[number % len(WRITTEN)]
    arguments, target, whole, _ = bench.prepare(kind, query, folder)
    before = content(folder)
    which = chance.choice(("memory", "size", "descriptors"))
    limits = {"memory": {resource.RLIMIT_AS: chance.randrange(64 << 20, 128 << 20)},
              "size": {resource.RLIMIT_FSIZE: chance.randrange(0, 2 * len(whole))},
              "descriptors": {resource.RLIMIT_NOFILE: chance.randint(4, 40)}}[which]
    ran = bench.run(arguments, folder, limits=limits)
    if ran.code == 127 and b"shared librar" in ran.err:
        return "not loaded for lack of " + which, []
    failures = unexpected(ran, (DONE, OUT_OF_RESOURCE))
    after = content(folder)
    if ran.code == DONE and after.get(target) != whole:
        failures.append("exit code 0 and a wrong answer")
    if left := set(after) - set(before) - ({target} if ran.code == DONE else set()):
        failures.append("left behind: " + ", ".join(sorted(left)))
    told = " ".join("%s=%d" % (which, most) for most in limits.values())
    return ("done" if ran.code == DONE else "told") + " with little " + which, ["%s, %s: %s" % (arguments[0], told, one) for one in failures]


def interrupt(bench, folder, chance, number):
    """SIGINT, SIGTERM or SIGHUP at a random moment: done, or cancelled within a second, and nothing left."""
    kind, query = WRITTEN[number % len(WRITTEN)]
    arguments, target, whole, seconds = bench.prepare(kind, query, folder)
    before = content(folder)
    which = chance.choice((signal.SIGINT, signal.SIGTERM, signal.SIGHUP))
    process = bench.start(bench.command(arguments), folder)
    time.sleep(chance.random() * seconds)
    sent = time.monotonic()
    os.kill(process.pid, which)
    ran = bench.finish(process, sent)
    # Before it can look after signals it dies of them, and has written nothing.
    allowed = (DONE, CANCELLED, -which)
    failures = [] if ran.code in allowed else unexpected(ran, (DONE, CANCELLED))
    if ran.seconds > 1 + 2 * seconds:
        failures.append("went on for %.1f s" % ran.seconds)
    after = content(folder)
    if ran.code == DONE and after.get(target) != whole:
        failures.append("exit code 0 and a wrong answer")
    if left := set(after) - set(before) - ({target} if ran.code == DONE else set()):
        failures.append("left behind: " + ", ".join(sorted(left)))
    return {DONE: "done", CANCELLED: "cancelled"}.get(ran.code, "ended by it at once"), failures


# --- More than one program -------------------------------------------------------------------------------------------------------

def race(bench, folder, chance, number):
    """Two programs write one file at once: it is whole, and what is said about losing is exit code 4."""
    kind, query = WRITTEN[number % len(WRITTEN)]
    arguments, target, whole, seconds = bench.prepare(kind, query, folder)
    before = set(content(folder))
    first = bench.start(bench.command(arguments), folder)
    time.sleep(chance.random() * seconds)
    second = bench.start(bench.command(arguments), folder)
    ends = [bench.finish(first), bench.finish(second)]
    failures = [one for end in ends for one in unexpected(end, (DONE, OUT_OF_RESOURCE))]
    after = content(folder)
    if all(end.code != DONE for end in ends):
        failures.append("neither was done: " + ends[0].said())
    elif after.get(target) != whole:
        failures.append("%s is not whole" % target)
    if left := set(after) - before - {target}:
        failures.append("left behind: " + ", ".join(sorted(left)))
    return "%d of 2 done" % sum(end.code == DONE for end in ends), failures


def change_in_use(bench, folder, chance, number):
    """A model is cut, overwritten, patched, replaced or removed while it is looked at: the right answer, or none."""
    kind = KINDS[number % len(KINDS)]
    name = chance.choice(sorted(QUERIES))
    whole, seconds = bench.answer(kind, name)
    model = folder / "model.tan"
    model.write_bytes(bench.model(kind)[0])
    arguments, target = bench.query(kind, name)
    process = bench.start(bench.command(arguments), folder)
    time.sleep(chance.random() * seconds)
    way = chance.choice(("cut", "overwritten", "patched", "replaced", "removed"))
    size = model.stat().st_size
    if way == "cut":
        os.truncate(model, chance.randrange(size))
    elif way == "overwritten":
        with open(model, "r+b") as file:
            file.write(chance.randbytes(size))
    elif way == "patched":
        with open(model, "r+b") as file:
            file.seek(chance.randrange(size - 64))
            file.write(chance.randbytes(64))
    elif way == "replaced":
        (folder / "other").write_bytes(bench.model(KINDS[(number + 1) % len(KINDS)])[0])
        os.replace(folder / "other", model)
    else:
        model.unlink()
    ran = bench.finish(process)
    failures = unexpected(ran, (DONE, BAD_INPUT) + ((USAGE, OUT_OF_RESOURCE) if way in ("removed", "replaced") else ()))
    told = ran.out if target is None else (folder / target).read_bytes() if (folder / target).exists() else None
    if ran.code == DONE and told != whole and way != "replaced":
        failures.append("a wrong answer with exit code 0")
    if ran.code != DONE and target is not None and told is not None:
        failures.append("an answer is left although the command failed")
    return ("answered" if ran.code == DONE else "refused") + ", " + way, ["%s of %s, %s: %s" % (name, kind.name, way, one) for one in failures]


# --- Packed models -----------------------------------------------------------------------------------------------------------------

DAMAGED_AT_ONCE = 50


def damaged_packed(bench, folder, chance, number):
    """Packed files damaged in many ways, with checksums that are wrong, and with right ones as somebody may make them: refused, or the
    same model. With right ones it may be another model that says so."""
    files = []
    for kind in PACKED:
        files.append(folder / (kind.name.replace(" ", "-") + ".tan"))
        files[-1].write_bytes(bench.model(kind)[0])
    program = bench.build / "tests/tan-damaged-packed"
    ran = bench.finish(bench.start([str(one) for one in (program, chance.randrange(2 ** 31), 0, DAMAGED_AT_ONCE, *files)], folder))
    counts = json.loads(ran.out) if ran.out else {}
    failures = unexpected(ran, (DONE,))
    if sum(counts.values()) != DAMAGED_AT_ONCE:
        failures.append("%d of %d files were judged" % (sum(counts.values()), DAMAGED_AT_ONCE))
    return "judged" if not failures else "went wrong", failures, counts


# --- The cache, and servers --------------------------------------------------------------------------------------------------------

def cache_entries(bench, folder):
    place = bench.cache(folder) / "tan"
    return {path.name: path for path in place.iterdir()} if place.is_dir() else {}


def unfinished(bench, folder):
    left = [name for name in cache_entries(bench, folder) if name.endswith((".making", ".lock"))]
    return ["left in the cache: " + ", ".join(left)] if left else []


class CacheUser:
    """One attempt's model, here or at a server, of which queries go through a cache."""

    def __init__(self, bench, folder, kind, address):
        self.bench, self.folder, self.kind = bench, folder, kind
        self.place = address or "model.tan"
        if not address:
            (folder / "model.tan").write_bytes(bench.model(kind)[0])

    def start(self, query, tag, **how):
        arguments, _ = self.bench.query(self.kind, query)
        target = "%s-%s.vtu" % (query, tag)
        arguments = [self.place if one == "model.tan" else target if one.endswith(".vtu") else one for one in arguments]
        return target, self.bench.start(self.bench.command(arguments), self.folder, **how)

    def judge(self, query, target, ran, allowed=(DONE,)):
        failures = unexpected(ran, allowed)
        found = (self.folder / target).read_bytes() if (self.folder / target).exists() else None
        if ran.code == DONE and found != self.bench.answer(self.kind, query)[0]:
            failures.append("a wrong answer with exit code 0")
        if ran.code != DONE and found is not None:
            failures.append("an answer is left although the command failed")
        return ["%s: %s" % (query, one) for one in failures]

    def ask(self, query, tag, allowed=(DONE,), **how):
        target, process = self.start(query, tag, **how)
        ran = self.bench.finish(process)
        return ran, self.judge(query, target, ran, allowed)


# No focus: of a lattice here it may insert points, of one at a server it chooses among those that have come.
CACHED_QUERIES = ("extract", "finest", "budget", "range")


def cache_kill(user, chance):
    query = chance.choice(CACHED_QUERIES)
    seconds = user.bench.answer(user.kind, query)[1]
    target, process = user.start(query, "killed")
    time.sleep(chance.random() * seconds)
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    (user.folder / target).unlink(missing_ok=True)
    for partial in user.folder.glob(target + ".*"):
        partial.unlink()
    return "killed, then asked again", user.ask(query, "again")[1]


def cache_interrupt(user, chance):
    query = chance.choice(CACHED_QUERIES)
    target, process = user.start(query, "stopped")
    time.sleep(chance.random() * user.bench.answer(user.kind, query)[1])
    which = chance.choice((signal.SIGINT, signal.SIGTERM, signal.SIGHUP))
    os.kill(process.pid, which)
    ran = user.bench.finish(process)
    failures = [] if ran.code == -which else user.judge(query, target, ran, (DONE, CANCELLED))
    failures += unfinished(user.bench, user.folder) if ran.code != -which else []
    return "interrupted, then asked again", failures + user.ask(query, "again")[1]


def cache_together(user, chance):
    """Three programs at once, of which one may be killed."""
    running = []
    for tag in range(3):
        query = chance.choice(CACHED_QUERIES)
        running.append((query, *user.start(query, tag)))
        time.sleep(chance.random() * 0.05)
    failures = []
    if chance.random() < 0.3:
        _, target, process = running.pop(chance.randrange(3))
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        (user.folder / target).unlink(missing_ok=True)
        for partial in user.folder.glob(target + ".*"):
            partial.unlink()
    for query, target, process in running:
        failures += user.judge(query, target, user.bench.finish(process))
    # What a killed one was making goes when the same is asked for again.
    return "at once", failures + (unfinished(user.bench, user.folder) if len(running) == 3 else [])


def cache_damage(user, chance):
    """What a disk damaged in the cache is made or fetched again, at the latest by the program after the one that finds it."""
    query = chance.choice(CACHED_QUERIES)
    failures = user.ask(query, "before")[1]
    entries = [path for path in cache_entries(user.bench, user.folder).values() if path.stat().st_size >= PAGE]
    if not entries:
        return "damaged", failures + ["nothing is in the cache"]
    victim = chance.choice(sorted(entries))
    victim.write_bytes(damage(victim.read_bytes(), chance))
    ran, wrong = user.ask(query, "damaged", (DONE, BAD_INPUT))
    failures += wrong
    if ran.code == BAD_INPUT:
        failures += user.ask(query, "afterwards")[1]
    return "damaged, " + ("told once" if ran.code == BAD_INPUT else "not noticed or made again"), failures


def cache_limit(user, chance):
    """The cache keeps its limit, whatever is asked for; what does not fit lies among the temporary files meanwhile, or is told."""
    limit = chance.choice((0, 1, 1, 2))
    failures, told = [], 0
    for tag, query in enumerate(chance.sample(CACHED_QUERIES, 3)):
        ran, wrong = user.ask(query, tag, (DONE, OUT_OF_RESOURCE), environment={"TAN_CACHE_MB": str(limit)})
        told += ran.code == OUT_OF_RESOURCE
        failures += wrong
        taken = sum(path.stat().st_blocks * 512 for path in cache_entries(user.bench, user.folder).values())
        if taken > limit * 10 ** 6:
            failures.append("the cache takes %d bytes, and its limit is %d MB" % (taken, limit))
    return "with little room, " + ("told" if told else "done"), failures + unfinished(user.bench, user.folder)


def cache_full_disk(user, chance):
    query = chance.choice(CACHED_QUERIES)
    size = chance.randrange(len(user.bench.model(user.kind)[0]))
    ran, failures = user.ask(query, "full", (DONE, OUT_OF_RESOURCE), limits={resource.RLIMIT_FSIZE: size})
    failures += unfinished(user.bench, user.folder)
    return "small files, " + ("told" if ran.code else "done"), failures + user.ask(query, "afterwards")[1]


CACHE_WAYS = (cache_kill, cache_interrupt, cache_together, cache_damage, cache_limit, cache_full_disk)
CACHE_PLACES = tuple((kind, False) for kind in PACKED) + tuple((kind, True) for kind in (KINDS[0], KINDS[1], KINDS[2], *PACKED))


def cached(bench, folder, chance, number):
    """Queries through the cache of unpacked models and of what came from servers."""
    kind, is_remote = CACHE_PLACES[number % len(CACHE_PLACES)]
    way = CACHE_WAYS[number // len(CACHE_PLACES) % len(CACHE_WAYS)]
    for query in CACHED_QUERIES:
        bench.answer(kind, query)
    address = serving.address_of(bench, kind) if is_remote else None
    outcome, failures = way(CacheUser(bench, folder, kind, address), chance)
    return outcome, ["%s of %s%s: %s" % (way.__name__, kind.name, " at a server" if is_remote else "", one) for one in failures]


def served(bench, folder, chance, number):
    """A server under load is stopped, killed, or has little memory or few descriptors: what it answers is right until then, and it ends
    within seconds; programs that were asking it say so."""
    how = ("stopped", "killed", "with little", "twice")[number % 4]
    models = folder / "models"
    for kind in (KINDS[0], KINDS[2], *PACKED):
        serving.put_model(bench, kind, models)
    before = content(folder)
    limits = {}
    if how == "with little":
        limits = chance.choice(({resource.RLIMIT_AS: chance.randrange(150 << 20, 500 << 20)}, {resource.RLIMIT_NOFILE: chance.randint(8, 40)}))
    server = serving.Server(bench, models, limits)
    if not server.port:
        ran = server.finish()
        return "not started", unexpected(ran, (OUT_OF_RESOURCE, USAGE, 127) if how == "with little" else ())
    failures = []
    load = serving.Load(models, server.port, chance.randrange(2 ** 31), lenient=how == "with little")
    asking = bench.start(bench.command(("extract", "http://127.0.0.1:%d/%s" % (server.port, serving.model_name(KINDS[0])), "--error", "0", "-o", "mesh.vtu")), folder)
    if how == "twice":
        other = bench.run(("serve", "models", "--port", str(server.port)), folder)
        failures += unexpected(other, (USAGE,))
    time.sleep(0.1 + 0.6 * chance.random())
    which = signal.SIGKILL if how == "killed" else chance.choice((signal.SIGINT, signal.SIGTERM))
    load.stopping = True
    sent = time.monotonic()
    os.kill(server.process.pid, which)
    ran = server.finish()
    seconds = time.monotonic() - sent
    answers, wrong = load.end()
    failures += wrong
    if which != signal.SIGKILL:
        failures += unexpected(ran, (DONE,))
        if seconds > 5:
            failures.append("went on for %.1f s" % seconds)
        if ran.code == DONE and json.loads(ran.out)["requests"] < answers:
            failures.append("counted %d requests and gave %d answers" % (json.loads(ran.out)["requests"], answers))
    if answers == 0 and how != "with little":
        failures.append("gave no answer")
    client = bench.finish(asking)
    failures += unexpected(client, (DONE, BAD_INPUT, OUT_OF_RESOURCE))
    mesh = (folder / "mesh.vtu").read_bytes() if (folder / "mesh.vtu").exists() else None
    if (mesh == bench.answer(KINDS[0], "finest")[0]) != (client.code == DONE) or (mesh is not None) != (client.code == DONE):
        failures.append("a program that asked it has a wrong answer")
    if content(folder) != (before if mesh is None else {**before, "mesh.vtu": mesh}):
        failures.append("the folder is not as it was")
    return how, ["%s: %s" % (how, one) for one in failures], {"right answers": answers}


# --- Hard shapes -----------------------------------------------------------------------------------------------------------------

EIGHT = "100,30,10,4,2,1,.2,0"


def shows_something(picture):
    """Whether a PNG has more than its background."""
    data, at, packed = picture.read_bytes(), 8, b""
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    return len(set(zlib.decompress(packed))) > 16


def proved_models(bench, folder, opened, ways):
    """A model of each way to build it, proved at eight accuracies and drawn coarse and fine. What verify says of the last, and failures."""
    told, failures = None, []
    for way in ways:
        def failed(sentences):
            failures.extend("%s: %s" % (" ".join(way) or "default", one) for one in sentences)
        built = bench.run(("build", opened, *way, "-o", "model.tan"), folder)
        failed(unexpected(built, (DONE,)))
        if built.code != DONE:
            continue
        proved = bench.run(("verify", "model.tan", "--against", opened, "--lod", EIGHT, "--json"), folder)
        failed(unexpected(proved, (DONE,)))
        if proved.code == DONE:
            told = json.loads(proved.out)
            if any(level["inverted"] > level["inverted_in_data"] for level in told["levels"]):
                failed(["inverted where the data are not"])
        for mode, error in (("isosurface", "10"), ("volume", "0")):
            drawn = bench.run(("render", "model.tan", "--mode", mode, "--error", error, "--size", "64x48", "--backend", "cpu",
                               "-o", "picture.png"), folder)
            failed(unexpected(drawn, (DONE,)))
            if drawn.code == DONE and not shows_something(folder / "picture.png"):
                failed(["nothing is seen in the %s at %s %%" % (mode, error)])
    return told, failures


def make_shape(bench, folder, chance, kind):
    made = bench.finish(bench.start([str(bench.build / "tests/tan-torture-shapes"), kind, str(chance.randrange(2 ** 31))], folder))
    assert made.code == DONE, made.said()
    return made.out.decode().strip()


def hard_grid(bench, folder, chance, number):
    """A curvilinear grid by default, whole and in blocks, by refinement and by decimation; one with holes has become a mesh that only
    this keeps."""
    what = make_shape(bench, folder, chance, "grid")
    ways = [("--builder", "decimation")]
    opened = bench.run(("info", "grid.xyz"), folder)
    if what == "holes" and opened.code == BAD_INPUT:  # cells so bent that no tetrahedra fill them
        return "with holes, refused", unexpected(opened, (BAD_INPUT,))
    if what == "whole":
        refine = ("--builder", "refinement")
        ways = [(), ("--builder", "decimation", "--space", "computational"), refine + ("--block", str(chance.randint(1, 6))),
                refine + ("--error-in", "grid")]
    told, failures = proved_models(bench, folder, "grid.xyz", ways)
    finest = told["levels"][-1] if told else {}
    counts = {"folded cells": told["folded_cells"] if told else 0, "tetrahedra inverted by the data": finest.get("inverted_in_data", 0),
              "models": len(ways)}
    folded = ", folded" if counts["folded cells"] else ""
    return what.replace("holes", "with holes") + folded, failures, counts


def hard_mesh(bench, folder, chance, number):
    """Tetrahedra of which up to a thousandth are damaged, and of which some only touch."""
    make_shape(bench, folder, chance, "mesh")
    told, failures = proved_models(bench, folder, "mesh.vtu", [()])
    return "proved" if not failures else "went wrong", failures, {"cells taken out": told["faulty_cell_count"] if told else 0}


# As many as fit into 90 minutes of two quiet cores by the time that each part takes by itself. Each run has chances of its own, so that
# what runs try adds up.
PARTS = (
    Part("latency", "tests that judge how soon something is seen, with the machine to themselves", repeated.latency, 10 ** 9, 0,
         in_parallel=False, counted=lambda bench: len(repeated.tests_of(bench, "latency"))),
    Part("tests", "tests that do more than in ./dev test, with other chances, and those that are too long for it",
         repeated.repeated, 10 ** 9, 0, counted=lambda bench: len(repeated.repetitions(bench))),
    Part("kills", "kill -9 of builds, of other commands that write, and of what writes sessions and settings", kill, 300, 8),
    Part("damage", "a model with flipped bits, zeroed or exchanged pages, or a part of it; three queries each", damaged_model, 1000, 14),
    Part("cuts", "a dataset cut anywhere, in every format that can be written here", cut_file, 300, 20),
    Part("mutations", "a dataset with random changes; a model built of it is proved", mutated_file, 400, 20),
    Part("writes", "each call that writes fails once, as on a full disk", failed_write, 10 ** 9, 12, counted=lambda bench: len(write_failures(bench))),
    Part("allocations", "each allocation of small builds fails once", failed_allocation, 10 ** 9, 24,
         counted=lambda bench: len(allocations(bench))),
    Part("limits", "little memory, small files, few descriptors", tight_limit, 200, 9),
    Part("signals", "SIGINT, SIGTERM, SIGHUP at random moments", interrupt, 150, 6),
    Part("races", "two programs write one file", race, 100, 6),
    Part("changes", "a model is changed while it is in use", change_in_use, 100, 10),
    Part("packed", "packed models damaged in 50 ways: bits, ends, chunks exchanged, doubled or left out, also with right checksums",
         damaged_packed, 200, 1),
    Part("mutants", "models of intent, with right checksums: impossible numbers, histories that go round, sections of others; "
         "shown, extracted, proved, drawn, packed and unpacked", mutants.attempt_explicit, 250, 2),
    Part("packed-mutants", "the same of packed models: chunks flipped, doubled, exchanged, spliced; facts, levels, texts",
         mutants.attempt_packed, 250, 2),
    Part("cache", "queries through the cache of unpacked models and of files from servers: killed, interrupted, three at once, a damaged "
         "or full cache, a limit", cached, 210, 12),
    Part("servers", "`tan serve` under load, stopped, killed, short of memory or descriptors", served, 60, 4),
    Part("answers", "a server of which some answers are not its own: status, headers, lengths, ranges, bytes, meshes with right checksums, "
         "no HTTP at all; fetched, and at the server", answers.attempt, 250, 2),
    Part("bombs", "files that ask for more than there is, lead out of their folder, wait for ever or go round; shown and built, with 4 GB of "
         "address space and 90 s of the processor", bombs.attempt, 10 ** 9, 10, counted=lambda bench: bombs.COUNT),
    Part("grids", "a curvilinear grid, even, folded, wrapped or collapsed, some with holes: built by both builders and in blocks, proved at "
         "eight accuracies, drawn", hard_grid, 40, 2),
    Part("meshes", "a mesh with overlaps, flips, slivers, doubles, parts that only touch, NaN: built, proved at eight accuracies, drawn",
         hard_mesh, 60, 1),
)
