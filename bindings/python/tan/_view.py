# SPDX-License-Identifier: GPL-3.0-or-later
"""How a model is looked at, as a value."""
from __future__ import annotations

import copy
import json
from typing import Any, Dict, FrozenSet, List, Mapping, Optional, Sequence, Tuple, Union

from ._errors import WrongUsage
from ._numbers import Vector, choice, listed, number, shown, text, truth, vector, whole
from ._regions import Box, Region, Sphere

Setting = Tuple[str, str, Union[None, bool, int, float, str], float, float, List[str]]  # as _tan.settings() has it
Colour = Union[Tuple[float, float, float], List[float]]
_UP = ("x", "-x", "y", "-y", "z", "-z")
_MOST_REGIONS = 16  # mostFocusRegions of the views


def _colour(value: Any, name: str) -> List[float]:
    channels = [number(part, name, least=0) for part in vector(value, name)]
    if max(channels) > 1:
        raise WrongUsage(f"{name} is red, green and blue from 0 to 1, not {tuple(channels)}.")
    return channels


def _setting(value: Any, name: str) -> Any:
    """As a view's text has settings: numbers say what they are."""
    if isinstance(value, (bool, str)):
        return value
    if isinstance(value, Mapping):
        return dict(value)
    if hasattr(value, "__index__"):
        return {"integer": whole(value, name, -(2**63))}
    return {"number": number(value, name)}


def _fitting(setting: Setting, value: Any) -> Any:
    """A setting's value as a view's text has it, if it is one."""
    name, kind, _, least, largest, choices = setting
    given = value if not isinstance(value, dict) else value.get("number", value.get("integer"))
    is_number = isinstance(value, dict) and set(value) <= {"number", "integer"}
    if kind in ("boolean", "text"):
        if type(given) is not (bool if kind == "boolean" else str):
            raise WrongUsage(f"The setting '{name}' is {'True or False' if kind == 'boolean' else 'a text'}.")
        if choices and given not in choices:
            raise WrongUsage(f"The setting '{name}' is one of {', '.join(choices)}, not {shown(given)}.")
    if kind in ("integer", "number"):
        if not is_number or (kind == "integer" and "integer" not in value):
            raise WrongUsage(f"The setting '{name}' is {'a whole number' if kind == 'integer' else 'a number'}.")
        if least < largest and not least <= given <= largest:
            raise WrongUsage(f"The setting '{name}' is from {least:g} to {largest:g}, not {given:g}.")
        return {kind: given if kind == "integer" else float(given)}
    return value


def _as_json(value: Dict[str, Any], name: str) -> Dict[str, Any]:
    """A copy of what can be written as JSON."""
    try:
        made: Dict[str, Any] = json.loads(json.dumps(value, allow_nan=False))
        return made
    except (TypeError, ValueError, RecursionError) as problem:
        raise WrongUsage(f"{name} has something that JSON does not have: {problem}.") from problem


def _is_list(value: Any) -> bool:
    """Whether it has parts, unlike a number or an array of NumPy without axes."""
    return hasattr(value, "__iter__") and getattr(value, "ndim", 1) > 0


def _middle(region: Union[Box, Sphere]) -> List[float]:
    if isinstance(region, Sphere):
        return list(region.centre)
    return [(low + high) / 2 for low, high in zip(region.least, region.largest)]


def _beside(region: Union[Box, Sphere]) -> Dict[str, Any]:
    """As a view's text has a region beside the first one."""
    if isinstance(region, Sphere):
        return {"centre": list(region.centre), "radius": region.radius}
    return {"least": list(region.least), "largest": list(region.largest)}


def _focus(regions: Sequence[Union[Box, Sphere]]) -> Dict[str, Any]:
    """As a view's text has all of them."""
    if not regions:
        return {"shape": "none"}
    first = regions[0]
    said: Dict[str, Any] = {"error": first.error, "falloff": first.falloff, "centre": _middle(first), "number": 0,
                            "others": [_beside(region) for region in regions[1:]]}
    if isinstance(first, Sphere):
        return {**said, "shape": "sphere", "radius": first.radius}
    return {**said, "shape": "box", "size": [high - low for low, high in zip(first.least, first.largest)]}


class View:
    """How a model is looked at: which mesh, how it is drawn, from where. What is not said is as the model is seen at first. A value:
    changed() gives another one.

    mode: "isosurface", "volume", "hybrid" (volume with isosurfaces), "focus", "slice", "projection" (maximum intensity); Model.modes()
        lists those of your installation.
    error: of the mesh, in % of the range of values; or budget: its number of tetrahedra.
    isovalues: of surfaces, in units of the values: numbers, or (value, (red, green, blue)), or (value, colour, opacity).
    transfer: the name of a colour map ("viridis", "cividis", "inferno", "cool-warm", "grey", "plasma", "turbo",
        "blue-orange", "categories"), or a transfer function as a dictionary in
        TAn's form (docs of the window: Transfer functions).
    azimuth, elevation, roll: of the camera, in degrees; up: "x", "-x", "y", "-y", "z", "-z"; perspective: False for a parallel view;
        zoom: 2 shows everything twice as large as if it filled the picture; target: (x, y, z) in the middle of the picture.
    background: (red, green, blue) from 0 to 1.
    focus: where the error is smaller, as in Model.mesh(): tan.sphere(...), tan.box(...), or a list of up to 16 of these with one error
        and one falloff; their middles lie in the bounds of the data. An empty list: none.
    window: the part of the domain that is shown, tan.box(...).
    settings: of the mode, by the ids that Model.settings() lists; numbers as they are.
    colour_bar, axes, scale_bar, title, accuracy, box_axes: whether these are written over the picture; box_axes are axes with numbers along
        the edges of the data's box, for which zoom=0.85 leaves room.
    text_size: of all that, from 6 to 48; 12 is usual.

    >>> view = View(mode="volume", azimuth=60, transfer="inferno")
    >>> view.changed(error=0.5).mode
    'volume'
    """

    def __init__(self, **look: Any) -> None:
        self._text: Dict[str, Any] = {}
        self._colours: Optional[str] = None
        self._fitted = True
        self._zoom = 1.0
        self._target: Optional[List[float]] = None
        self._middles: List[List[float]] = []
        self._asked: FrozenSet[str] = frozenset()
        self._change(look)

    @classmethod
    def from_text(cls, view: str) -> View:
        """The view of a JSON text, as `text` has it, or as sessions keep it."""
        made = cls()
        try:
            parsed = json.loads(text(view, "view"))
        except RecursionError as problem:
            raise WrongUsage("The view is nested too deep.") from problem
        except json.JSONDecodeError as problem:
            raise WrongUsage(f"The view is no JSON: {problem}.") from problem
        if not isinstance(parsed, dict):
            raise WrongUsage("The view is no JSON object.")
        made._text = parsed
        made._fitted = "distance" not in parsed.get("camera", {}) if isinstance(parsed.get("camera", {}), dict) else True
        return made

    @property
    def text(self) -> str:
        """What this view says, as JSON; what it leaves open is missing."""
        return json.dumps(self._text, sort_keys=True)

    @property
    def mode(self) -> Optional[str]:
        """The id of the mode, or None: the usual one."""
        mode = self._found("look").get("mode")
        return None if mode is None else str(mode)

    @property
    def transfer(self) -> Optional[Dict[str, Any]]:
        """The transfer function in TAn's form, or None: one that fits the values."""
        found = self._found("look").get("transfer")
        if found is not None and not isinstance(found, dict):
            raise WrongUsage("'transfer' of the view is no JSON object.")
        return copy.deepcopy(found)

    @property
    def bookmarks(self) -> Dict[str, View]:
        """Other views that were kept beside this one, by their names: those of a session (Model.kept_view())."""
        written = self._text.get("views", [])
        if not isinstance(written, list) or not all(isinstance(view, dict) and isinstance(view.get("name"), str) for view in written):
            raise WrongUsage("'views' of the view is no list of JSON objects with names.")
        return {view["name"]: View.from_text(json.dumps({key: value for key, value in view.items() if key != "name"})) for view in written}

    def changed(self, **look: Any) -> View:
        """The same view but for this."""
        other = copy.deepcopy(self)
        other._change(look)
        return other

    def _found(self, name: str) -> Dict[str, Any]:
        member = self._text.get(name, {})
        if not isinstance(member, dict):
            raise WrongUsage(f"'{name}' of the view is no JSON object.")
        return member

    def _member(self, name: str) -> Dict[str, Any]:
        member = self._text[name] = self._found(name)
        return member

    def _change(self, look: Dict[str, Any]) -> None:
        if look.get("mode") is not None:
            self._asked = frozenset()  # settings from before were those of the mode from before
        for name, value in look.items():
            change = getattr(self, f"_set_{name}", None)
            if change is None:
                known = sorted(member[5:] for member in dir(self) if member.startswith("_set_"))
                raise TypeError(f"a view has no '{name}'; it has {', '.join(known)}")
            if value is not None:
                change(value)

    def _set_mode(self, value: Any) -> None:
        self._member("look")["mode"] = text(value, "mode")

    def _set_error(self, value: Any) -> None:
        self._member("mesh").update(error=number(value, "error", least=0), byBudget=False)

    def _set_budget(self, value: Any) -> None:
        self._member("mesh").update(budget=whole(value, "budget", 1), byBudget=True)

    def _set_isovalues(self, value: Any) -> None:
        given = listed(value, "isovalues is numbers") if _is_list(value) else [value]
        self._text["isovalues"] = [self._isovalue(part, index) for index, part in enumerate(given)]

    @staticmethod
    def _isovalue(part: Any, index: int) -> Dict[str, Any]:
        palette = ((0.90, 0.62, 0.0), (0.34, 0.71, 0.91), (0.0, 0.62, 0.45), (0.84, 0.37, 0.0), (0.0, 0.45, 0.70), (0.80, 0.47, 0.65),
                   (0.94, 0.89, 0.26))  # of Okabe and Ito, for all kinds of sight
        parts = listed(part, "an isovalue is a number, (value, colour) or (value, colour, opacity)") if _is_list(part) else [part]
        if not 1 <= len(parts) <= 3:
            raise WrongUsage("An isovalue is a number, (value, colour) or (value, colour, opacity).")
        value, colour = parts[0], parts[1] if len(parts) > 1 else palette[index % len(palette)]
        opacity = number(parts[2], "opacity", least=0) if len(parts) > 2 else 1.0
        if not 0 < opacity <= 1:
            raise WrongUsage(f"opacity is above 0 and at most 1, not {opacity:g}.")
        return {"value": number(value, "isovalues"), "colour": _colour(colour, "the colour of an isovalue"), "opacity": opacity, "visible": True}

    def _isovalues_outside(self, values: Tuple[float, float]) -> List[float]:
        said = self._text.get("isovalues", [])
        asked = [part.get("value") for part in said if isinstance(part, dict)] if isinstance(said, list) else []
        return [value for value in asked if isinstance(value, (int, float)) and not values[0] <= value <= values[1]]

    def _set_transfer(self, value: Any) -> None:
        if isinstance(value, str):
            self._colours = text(value, "transfer")
        elif isinstance(value, Mapping):
            self._colours = None
            self._member("look")["transfer"] = _as_json({"format": "tan-transfer-function", "version": 2, **value}, "transfer")
        else:
            raise TypeError(f"transfer is the name of a colour map or a dictionary, not {shown(value)}")

    def _set_settings(self, value: Any) -> None:
        if not isinstance(value, Mapping):
            raise TypeError(f"settings is a dictionary, not {shown(value)}")
        said = _as_json({str(name): _setting(part, str(name)) for name, part in value.items()}, "settings")
        self._member("look").setdefault("settings", {}).update(said)
        self._asked |= frozenset(said)

    def _settled(self, mode: str, known: Sequence[Setting]) -> View:
        """With the settings that were asked for as a mode has them."""
        other = copy.deepcopy(self)
        settings = other._found("look").get("settings", {})
        for name in sorted(self._asked):
            found = [setting for setting in known if setting[0] == name]
            if not found:
                ids = ", ".join(setting[0] for setting in known if setting[2] is not None)
                raise WrongUsage(f"The mode '{mode}' has no setting '{name}'. It has: {ids}.")
            settings[name] = _fitting(found[0], settings[name])
        return other

    def _look_from(self, name: str, value: Any) -> None:
        self._member("camera")[name] = value

    def _set_azimuth(self, value: Any) -> None:
        self._look_from("azimuth", number(value, "azimuth"))

    def _set_elevation(self, value: Any) -> None:
        self._look_from("elevation", max(-90.0, min(90.0, number(value, "elevation"))))

    def _set_roll(self, value: Any) -> None:
        self._look_from("roll", number(value, "roll"))

    def _set_up(self, value: Any) -> None:
        self._look_from("up", choice(value, "up", _UP))

    def _set_perspective(self, value: Any) -> None:
        self._look_from("perspective", truth(value, "perspective"))

    def _set_zoom(self, value: Any) -> None:
        self._zoom = number(value, "zoom")
        if self._zoom <= 0:
            raise WrongUsage(f"zoom is {self._zoom:g}, but must be above 0.")

    def _set_target(self, value: Vector) -> None:
        self._target = list(vector(value, "target"))

    def _set_background(self, value: Any) -> None:
        self._text["background"] = _colour(value, "background")

    def _set_window(self, value: Any) -> None:
        if not isinstance(value, Box):
            raise TypeError(f"window is tan.box(...), not {shown(value)}")
        if any(least > largest for least, largest in zip(value.least, value.largest)):
            raise WrongUsage(f"window goes from {value.least} to {value.largest}, which is no box.")
        self._member("mesh")["window"] = {"on": True, "border": value.border, "least": list(value.least), "largest": list(value.largest)}

    def _set_focus(self, value: Any) -> None:
        kinds = "the focus of a picture is tan.sphere(...) or tan.box(...), or a list of these"
        regions = [value] if isinstance(value, Region) else listed(value, kinds)
        if not all(isinstance(region, (Box, Sphere)) for region in regions):
            raise TypeError(kinds)
        if any(region.error is None for region in regions):
            raise WrongUsage("A focus needs an error: tan.sphere(centre, radius, error=0.2).")
        if len({(region.error, region.falloff) for region in regions}) > 1:
            raise WrongUsage("The regions of a picture's focus have one error and one falloff. Draw them one by one, or make them alike.")
        if len(regions) > _MOST_REGIONS:
            raise WrongUsage(f"The focus of a picture has at most {_MOST_REGIONS} regions, not {len(regions)}.")
        for region in regions:
            if isinstance(region, Box) and any(least > largest for least, largest in zip(region.least, region.largest)):
                raise WrongUsage(f"focus goes from {region.least} to {region.largest}, which is no box.")
        self._middles = [_middle(region) for region in regions]
        self._member("mesh")["focus"] = _focus(regions)

    def _annotation(self, name: str, is_shown: bool) -> None:
        self._member("annotations").setdefault(name, {})["shown"] = is_shown

    def _set_colour_bar(self, value: Any) -> None:
        self._annotation("colourBar", truth(value, "colour_bar"))

    def _set_axes(self, value: Any) -> None:
        self._annotation("axes", truth(value, "axes"))

    def _set_scale_bar(self, value: Any) -> None:
        self._annotation("scaleBar", truth(value, "scale_bar"))

    def _set_title(self, value: Any) -> None:
        self._annotation("title", truth(value, "title"))

    def _set_accuracy(self, value: Any) -> None:
        self._annotation("accuracy", truth(value, "accuracy"))

    def _set_box_axes(self, value: Any) -> None:
        self._annotation("boxAxes", truth(value, "box_axes"))

    def _set_text_size(self, value: Any) -> None:
        size = number(value, "text_size", least=6)
        if size > 48:
            raise WrongUsage(f"text_size is {size:g}, but must be 48 at most.")
        self._member("annotations")["textSize"] = size

    def __eq__(self, other: object) -> bool:
        return isinstance(other, View) and vars(self) == vars(other)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<tan.View {self.text}>"


def view_of(view: Optional[View], look: Dict[str, Any]) -> View:
    """A view with these changes."""
    if view is not None and not isinstance(view, View):
        raise TypeError(f"a view is a tan.View, not {shown(view)}")
    return (view if view is not None else View()).changed(**look)

