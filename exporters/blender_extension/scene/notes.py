"""Parts of a Blender scene that a scene file cannot express."""


class Notes:
    """Collects notes, each once, with the first things that it is about."""

    def __init__(self):
        self._names = {}

    def add(self, text, name=None):
        """text: the replacement that is rendered. name: name of the object, put before the text."""
        names = self._names.setdefault(text, [])
        if name is not None and name not in names:
            names.append(name)

    def lines(self):
        """One a note: `'Lamp', 'Lamp.001' and 3 more: ...`."""
        return [self._line(text, names) for text, names in self._names.items()]

    def _line(self, text, names):
        if not names:
            return text
        shown = ", ".join(repr(name) for name in names[:3])
        more = f" and {len(names) - 3} more" if len(names) > 3 else ""
        return f"{shown}{more}: {text}"
