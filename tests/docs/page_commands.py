# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands that README and docs show, and among them those that build what lies in examples/."""
import re

COMMAND = re.compile(r"^(\w+=\S+ )*(tan|tan-desktop|\./dev|\.ci/run|cmake|cp|echo|for|set|apt|sh|sudo|xvfb-run|perf|build/\S+)\b")


def commands_of(text):
    """The commands of a page: lines of blocks that are indented or marked sh, where the block begins with a command."""
    commands, block, fence = [], [], None

    def end_block():
        if block and COMMAND.match(block[0]):
            commands.extend(re.sub(r"\s{2,}#\s.*$", "", line) for line in block)
        block.clear()

    for line in text.splitlines():
        if line.startswith("```"):
            end_block()
            fence = line[3:].strip() if fence is None else None
        elif fence is not None:
            if fence in ("sh", "shell", "bash"):
                block.append(line)
        elif line.startswith("    ") and line.strip():
            block.append(line.strip())
        else:
            end_block()
    end_block()
    return [command for command in commands if command]


# Copying an example is the first of the commands that build it: its name, and the folder that it is built in.
COPYING = re.compile(r'cp -r "\$TAN_SOURCE/examples/(\w+)" (\S+)')


def examples_built(text):
    """name -> (folder, commands) of each example that a page builds."""
    commands, found = commands_of(text), {}
    for at, command in enumerate(commands):
        if copying := COPYING.fullmatch(command):
            name, folder = copying.groups()
            found[name] = (folder, commands[at:at + 3])
            configuring, building = commands[at + 1:at + 3]
            assert configuring.startswith(f"cmake -S {folder} -B {folder}/build "), configuring
            assert building.startswith(f"cmake --build {folder}/build"), building
    return found


def check_own_reading():
    page = "text\n\n    tan a   # why\n    tan b\n\n    key: value\n\n```sh\ncmake c\n```\n```cpp\nfor (;;);\n```\n"
    assert commands_of(page) == ["tan a", "tan b", "cmake c"], commands_of(page)


check_own_reading()
