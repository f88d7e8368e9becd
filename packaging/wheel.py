#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""wheel.py BUILD FOLDER: packs the Python module of a build into a wheel, which needs nothing but Python, NumPy and the C++ runtime.

The wheel has the library, the renderers and the system's libraries that these need. Each of those gets a name of its own, by its content, as
another module of the process may bring the same one in another version. It has neither the program `tan` nor its readers. Needs patchelf, strip
(binutils) and the package wheel.
"""
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile

MOST_BYTES = 8_000_000
# What each Linux has that Python wheels are for (PEP 600); the rest is brought along.
EVERYWHERE = re.compile(r"(libc|libm|libdl|libresolv|librt|libpthread|libstdc\+\+|libgcc_s|ld-linux-x86-64|ld-linux-aarch64)\.so")


def run(*words):
    return subprocess.run(words, check=True, stdout=subprocess.PIPE, text=True).stdout


def needed_by(file):
    return [name for name in run("patchelf", "--print-needed", file).split() if not EVERYWHERE.match(name)]


def system_libraries():
    """Where the loader finds those of this machine, by their names."""
    kind = {"x86_64": "x86-64", "aarch64": "AArch64"}[os.uname().machine]
    found = re.findall(rf"^\s*(\S+) \([^)]*{kind}[^)]*\) => (\S+)$", run("/sbin/ldconfig", "-p"), re.M)
    return {name: pathlib.Path(place) for name, place in reversed(found)}


def copy_own(build, package):
    """The module with TAn's libraries and renderers; gives the compiled files."""
    shutil.copytree(build / "lib/python3/dist-packages/tan", package, ignore=shutil.ignore_patterns("__pycache__"))
    libraries, plugins = package / "lib", package / "lib/plugins"
    plugins.mkdir(parents=True)
    for library in ("libtan-core", "libtan-picture", "libtan-plugin-host"):
        found = next((build / "lib").glob(library + ".so.?.?"))  # its link of the name that others ask for
        shutil.copyfile(found, libraries / found.name)
    for renderer in sorted((build / "lib/tan/plugins").glob("libtan-renderer-*.so")):
        shutil.copyfile(renderer, plugins / renderer.name)
    compiled = [*package.glob("_tan*.so"), *libraries.glob("*.so*"), *plugins.glob("*.so")]
    for file in compiled:
        run("strip", "--strip-unneeded", file)
    return compiled


def add_needed(compiled, libraries):
    """Copies what the files need of the system, and what that needs; gives all of them and the names that the copies have."""
    everywhere, names, waiting = system_libraries(), {}, list(compiled)
    while waiting:
        for name in needed_by(waiting.pop()):
            if name in names or (libraries / name).exists():
                continue
            source = everywhere[name].resolve()
            stem, _, ending = name.partition(".so")
            names[name] = f"{stem}-{hashlib.sha256(source.read_bytes()).hexdigest()[:8]}.so{ending}"
            copy = libraries / names[name]
            shutil.copyfile(source, copy)
            compiled.append(copy)
            waiting.append(copy)
    return names


def link(compiled, names, libraries):
    """Lets the files find each other, wherever the package lies."""
    for file in compiled:
        for name in needed_by(file):
            if name in names:
                run("patchelf", "--replace-needed", name, names[name], file)
        if file.name in names.values():
            run("patchelf", "--set-soname", file.name, file)
        to_libraries = os.path.relpath(libraries, file.parent)
        run("patchelf", "--set-rpath", "$ORIGIN" if to_libraries == "." else f"$ORIGIN/{to_libraries}", file)


def add_licences(sources, folder):
    """The copyright of each package that a library comes from, and TAn's own licence."""
    folder.mkdir()
    shutil.copyfile(pathlib.Path(__file__).resolve().parents[1] / "LICENSE", folder / "TAn")
    for source in sources:
        # The packages of some systems know their files by paths from before /usr was merged.
        place = str(source)
        for known in (place, place.removeprefix("/usr")):
            owner = subprocess.run(["dpkg-query", "-S", known], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
            if owner:
                package = owner.split(":")[0]
                shutil.copyfile(f"/usr/share/doc/{package}/copyright", folder / package)
                break
        else:
            sys.exit(f"wheel.py: no package has '{source}', so its licence is not known")


def write_metadata(staged, build, names):
    metadata = pathlib.Path(__file__).resolve().parents[1] / "bindings/python/tan.dist-info"
    version = re.search(r"^Version: (.*)$", (metadata / "METADATA").read_text(), re.M)[1]
    info = staged / f"tan-{version}.dist-info"
    shutil.copytree(metadata, info)
    (info / "METADATA").write_text((metadata / "METADATA").read_text() + (
        "\nThe library of TAn for Python: models of arrays, their meshes, and pictures. Data files are read, models served and addresses opened by the "
        "program `tan`, which is not in this wheel: install TAn's packages for these.\n"))
    python = "cp" + sysconfig.get_config_var("py_version_nodot")
    libc = os.confstr("CS_GNU_LIBC_VERSION").split()[1].replace(".", "_")
    (info / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: tan\nRoot-Is-Purelib: false\n"
                                f"Tag: {python}-{python}-manylinux_{libc}_{os.uname().machine}\n")
    everywhere = system_libraries()
    add_licences([everywhere[name].resolve() for name in names], info / "licenses")


def main():
    build, target = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        staged = pathlib.Path(folder) / "wheel"
        compiled = copy_own(build, staged / "tan")
        names = add_needed(compiled, staged / "tan/lib")
        link(compiled, names, staged / "tan/lib")
        write_metadata(staged, build, names)
        target.mkdir(parents=True, exist_ok=True)
        run(sys.executable, "-m", "wheel", "pack", staged, "--dest-dir", target)
    wheel = max(target.glob("tan-*.whl"), key=lambda path: path.stat().st_mtime)
    size = wheel.stat().st_size
    print(f"{wheel.name}: {size / 1e6:.1f} MB, with {len(names)} libraries of the system")
    if size > MOST_BYTES:
        sys.exit(f"wheel.py: that is more than {MOST_BYTES / 1e6:g} MB")


main()
