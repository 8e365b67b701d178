"""YAML as scene files are read: version 1.2's core schema, which has the numbers of JSON.

PyYAML's own loader is of YAML 1.1, where 1e3 is text, 010 is 8 and 1:30 is 90. ruamel.yaml, of YAML
1.2, still has dates, binary text and 1_000, and raises KeyError for `!!bool abc`.
"""

import re
from collections.abc import Callable
from typing import Any, ClassVar

import yaml
from yaml.constructor import ConstructorError, SafeConstructor
from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode
from yaml.resolver import BaseResolver

_TAG = "tag:yaml.org,2002:"
_NAMES: dict[type[Node], str] = {
    ScalarNode: "a scalar",
    SequenceNode: "a list",
    MappingNode: "a mapping",
}
_KINDS = {_TAG + "str": ScalarNode, _TAG + "seq": SequenceNode, _TAG + "map": MappingNode}

# YAML 1.2.2, section 10.3.2: what plain scalars are, the characters that they begin with, and what
# is made of them. Everything else is text.
_SCALARS: dict[str, tuple[str, str, Callable[[str], object]]] = {
    "null": (r"(?:~|null|Null|NULL|)", "~nN", lambda _: None),
    "bool": (r"(?:true|True|TRUE|false|False|FALSE)", "tTfF", lambda text: text[0] in "tT"),
    "int": (
        r"(?:[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+)",
        "-+0123456789",
        lambda text: int(text, 0 if text[:2] in ("0o", "0x") else 10),
    ),
    "float": (
        r"(?:[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?"
        r"|[-+]?\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN))",
        "-+.0123456789",
        lambda text: float(re.sub(r"\.(?=[iInN])", "", text)),
    ),
}


class CoreLoader(
    yaml.reader.Reader,
    yaml.scanner.Scanner,
    yaml.parser.Parser,
    yaml.composer.Composer,
    SafeConstructor,
    BaseResolver,
):
    """Text, numbers, booleans, null, lists and mappings; other tags are errors.

    Raises yaml.YAMLError, with the line where there is one, for whatever cannot be read.
    """

    yaml_constructors: ClassVar[dict[Any, Any]] = {}

    def __init__(self, text: str) -> None:
        yaml.reader.Reader.__init__(self, text)
        yaml.scanner.Scanner.__init__(self)
        yaml.parser.Parser.__init__(self)
        yaml.composer.Composer.__init__(self)
        SafeConstructor.__init__(self)
        BaseResolver.__init__(self)

    def construct_object(self, node: Node, deep: bool = False) -> Any:
        kind = _KINDS.get(node.tag, ScalarNode)
        if node.tag not in self.yaml_constructors:
            raise ConstructorError(None, None, f"unknown tag {node.tag!r}", node.start_mark)
        if not isinstance(node, kind):
            name = node.tag.removeprefix(_TAG)
            message = f"{_NAMES[type(node)]} is no {name}"
            raise ConstructorError(None, None, message, node.start_mark)
        return super().construct_object(node, deep)


def _scalar(name: str) -> Callable[[CoreLoader, ScalarNode], object]:
    pattern, _, make = _SCALARS[name]

    def construct(loader: CoreLoader, node: ScalarNode) -> object:
        if not re.fullmatch(pattern, node.value):
            message = f"{node.value!r} is no {name}"
            raise ConstructorError(None, None, message, node.start_mark)
        try:
            return make(node.value)
        except ValueError as error:
            raise ConstructorError(None, None, "too many digits", node.start_mark) from error

    return construct


for _name, (_pattern, _first, _) in _SCALARS.items():
    CoreLoader.yaml_constructors[_TAG + _name] = _scalar(_name)
    _starts = [*_first, ""] if _name == "null" else list(_first)
    CoreLoader.add_implicit_resolver(_TAG + _name, re.compile(rf"^{_pattern}$"), _starts)
for _name in ("str", "seq", "map"):
    CoreLoader.yaml_constructors[_TAG + _name] = getattr(SafeConstructor, f"construct_yaml_{_name}")


class _CoreDumper(yaml.SafeDumper):
    """Quotes text that this loader would read as another type."""

    yaml_implicit_resolvers = CoreLoader.yaml_implicit_resolvers


def dump_yaml(data: object) -> str:
    """A document that says `data`, with short lists and mappings on a line."""
    style: dict[str, Any] = {"sort_keys": False, "default_flow_style": None, "width": 100}
    return str(yaml.dump(data, Dumper=_CoreDumper, allow_unicode=True, **style))
