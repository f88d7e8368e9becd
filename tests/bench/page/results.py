# SPDX-License-Identifier: GPL-3.0-or-later
"""What `./dev bench all` left in a folder, and single figures out of it."""
import json
import re
from dataclasses import dataclass

RUN_KEYS = ("date", "revision", "changed", "trial", "processor", "cores", "memory_bytes", "system", "compiler", "seconds", "others_share")


class Unusable(Exception):
    """The results do not make a page; the text says which and what to do."""


@dataclass(frozen=True)
class Source:
    """Where one number stands: in a case of a step, whose name may have sizes in braces, and '...' for what depends on the data."""
    step: str
    case: str
    key: str
    beside: str = ""  # the yardstick, where a case stands there once for each
    scale: float = 1
    needs: tuple = ()  # data or programs without which the step leaves the case out
    points: str = ""  # the size of the lattice by whose points it is divided


@dataclass(frozen=True)
class NotMeasured:
    why: str


def cases_of_reproduction(report):
    """The rows of the paper's tables in the form of the other reports."""
    cases = []
    for table in report["tables"]:
        for row in table["rows"]:
            size = " " + "x".join(str(number) for number in row["size"]) if "size" in row else ""
            variant = f", {row['variant']}" if row["variant"] else ""
            case = {"case": f"table {table['table']}, {row['dataset']}{size}{variant}, {row['error']:g} %"}
            for whose in ("paper", "ours"):
                case.update({f"{whose}_{key}": value for key, value in row[whose].items()})
            cases.append(case)
    return cases


def read_step(folder, step):
    path = folder / f"{step.name}.json"
    again = f"./dev bench all --only {step.name}"
    try:
        result = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError as error:
        raise Unusable(f"{path} is missing: this step was not run, or failed. Measure it: {again}") from error
    except (OSError, ValueError) as error:
        raise Unusable(f"{path} cannot be read ({error}). Measure it again: {again}") from error
    try:
        report = result["report"]
        cases = [] if report is None else report["cases"] if "cases" in report else cases_of_reproduction(report)
        names = [case["case"] for case in cases]
        run = {key: result["run"][key] for key in RUN_KEYS}
        available, sizes = dict(result["available"]), dict(result["sizes"])
    except (KeyError, TypeError, AttributeError, ValueError) as error:
        raise Unusable(f"{path} is not a result of this step (no {error}). Measure it again: {again}") from error
    if report is not None and not names and not step.data:
        raise Unusable(f"{path} has no case at all. Measure it again: {again}")
    return {"path": path, "cases": cases, "run": run, "available": available, "sizes": sizes, "skipped": report is None}


class Results:
    """`without`: names of steps that were not run, of which the page then says so."""

    def __init__(self, folder, steps, without=()):
        mistakes, self.steps, self.without = [], {}, without
        for step in steps:
            if step.name in without:
                continue
            try:
                self.steps[step.name] = read_step(folder, step)
            except Unusable as error:
                mistakes.append(str(error))
        if mistakes:
            raise Unusable("\n".join(mistakes))
        self.sizes = self.common("sizes")
        self.machine = {key: self.common("run", key) for key in ("processor", "cores", "memory_bytes", "system", "compiler", "trial")}

    def common(self, *keys):
        """What all steps must have alike: figures of two machines do not belong on one page."""
        found = {}
        for name, step in self.steps.items():
            value = step
            for key in keys:
                value = value[key]
            found.setdefault(json.dumps(value), (name, value))
        if len(found) > 1:
            told = "; ".join(f"{name}: {value}" for name, value in found.values())
            raise Unusable(f"The steps were not all measured alike ({keys[-1]}: {told}). Measure them again: ./dev bench all")
        return next(iter(found.values()))[1]

    def text(self, words):
        """A name or label with the sizes of this run."""
        return words.format(**self.sizes)

    def number(self, source):
        """The figure, or NotMeasured where there is a reason for that. Raises Unusable where there is none."""
        if source.step in self.without:
            return NotMeasured(f"step {source.step} was left out")
        step = self.steps[source.step]
        lacking = [what for what in source.needs if not step["available"].get(what, False)]
        if lacking:
            return NotMeasured("no VTK" if lacking[0] == "VTK" else f"no data ({lacking[0]})")
        if step["skipped"]:
            return NotMeasured("no data")
        name = self.text(source.case)
        matching = [case for case in step["cases"] if self.is_meant(case, name, source.beside)]
        if len(matching) != 1:
            beside = f" beside {source.beside}" if source.beside else ""
            raise Unusable(f"{step['path']} has {len(matching)} cases '{name}'{beside} where one is expected. "
                           f"Measure it again: ./dev bench all --only {source.step}")
        value = matching[0].get(source.key)
        if not isinstance(value, (int, float)) or isinstance(value, bool):
            raise Unusable(f"{step['path']}: the case '{name}' has no number '{source.key}'.")
        return value * source.scale / (self.sizes[source.points] ** 3 if source.points else 1)

    @staticmethod
    def is_meant(case, name, beside):
        pattern = ".*".join(re.escape(part) for part in name.split("..."))
        return re.fullmatch(pattern, case["case"]) is not None and (not beside or case.get("yardstick") == beside)
