"""Sockets of a shader as factors and textures of glTF."""

import numpy as np

from .images import as_png_or_jpeg, pixels_of, png
from .sockets import Channel, cut_off, follow

_ELSEWHERE = "is made of nodes that glTF does not have: its value is rendered instead"


class Textures:
    """Textures of one material.

    material: its name. glb: takes the textures. notes: takes what cannot be said.
    """

    def __init__(self, material, glb, notes):
        self.material, self._glb, self._notes = material, glb, notes

    def number(self, socket):
        """The value of a socket that glTF, as rna-run reads it, has no texture for."""
        source = follow(socket)
        if isinstance(source, float | int):
            return float(source)
        self._miss(socket)
        return float(socket.default_value)

    def base(self, colour, alpha):
        """`baseColorFactor` and `baseColorTexture`; alpha: a socket, or None for 1."""
        opacity = 1.0 if alpha is None else self._opacity(alpha)
        source = follow(colour)
        if isinstance(source, Channel):
            texture = {"baseColorTexture": self._texture(source)}
            return {**texture, "baseColorFactor": [1.0, 1.0, 1.0, opacity]}
        if source is None:
            self._miss(colour)
            source = list(colour.default_value)
        return {"baseColorFactor": [*(min(max(c, 0.0), 1.0) for c in source[:3]), opacity]}

    def _opacity(self, socket):
        return follow(socket) if isinstance(follow(socket), float) else 1.0

    def alpha_mode(self, socket):
        """`alphaMode`, of a value, or of the alpha of the base colour's image."""
        cut = cut_off(socket)
        if cut is not None:
            return {"alphaMode": "MASK", "alphaCutoff": cut[1]}
        source = follow(socket)
        if isinstance(source, Channel) and source.index == 3:
            return {"alphaMode": "BLEND"}
        if isinstance(source, float):
            return {"alphaMode": "BLEND"} if source < 1.0 else {}
        self._miss(socket)
        return {}

    def metallic_roughness(self, metallic, roughness):
        """Factors, or one texture with roughness in green and metal in blue.

        metallic: None for a metal.
        """
        names = ("metallicFactor", metallic, 1.0), ("roughnessFactor", roughness, None)
        sources, result = {}, {}
        for name, socket, usual in names:
            value = usual if socket is None else follow(socket)
            if value is None:
                self._miss(socket)
                value = socket.default_value
            result[name] = 1.0 if isinstance(value, Channel) else value
            if isinstance(value, Channel):
                sources[name] = value
        if sources:
            result["metallicRoughnessTexture"] = self._packed(sources)
        return result

    def _packed(self, channels):
        first = next(iter(channels.values()))
        if all(c.image == first.image and c.index == k for c, k in _places(channels)):
            return self._texture(first)
        width, height = first.image.size
        packed = np.ones((height, width, 3), np.float32)
        for channel, place in _places(channels):
            if tuple(channel.image.size) != (width, height):
                self._notes.add("roughness and metal have images of two sizes", self.material)
                continue
            packed[..., place] = pixels_of(channel.image)[..., channel.index or 0]
        return self._checked(first, self._glb.add_texture(png(packed), "image/png"))

    def relief(self, socket):
        """`normalTexture` of a Normal Map node in tangent space."""
        if not socket.is_linked:
            return {}
        node = socket.links[0].from_node
        source = follow(node.inputs["Color"]) if node.type == "NORMAL_MAP" else None
        if not isinstance(source, Channel) or node.space != "TANGENT":
            self._notes.add("relief of other nodes than normal maps is left out", self.material)
            return {}
        return {"normalTexture": {**self._texture(source), "scale": self.number(node.inputs[0])}}

    def emission(self, colour, strength):
        """`emissiveFactor`, its texture and strength; nothing where it is dark."""
        factor, source = self.number(strength), follow(colour)
        if factor <= 0.0:
            return {}
        if isinstance(source, Channel):
            texture = {"emissiveTexture": self._texture(source), "emissiveFactor": [1.0] * 3}
            return {**texture, **_strength(factor)}
        if source is None:
            self._miss(colour)
            source = list(colour.default_value)
        greatest = max(source[:3])
        if greatest <= 0.0:
            return {}
        factors = [c / greatest for c in source[:3]]
        return {"emissiveFactor": factors, **_strength(factor * greatest)}

    def _texture(self, channel):
        return self._checked(channel, self._glb.add_texture(*as_png_or_jpeg(channel.image)))

    def _checked(self, channel, index):
        """A reference to a texture, with a note where it lies otherwise than glTF has it."""
        if channel.node.inputs["Vector"].is_linked:
            node = channel.node.inputs["Vector"].links[0].from_node
            if node.type not in ("UVMAP", "TEX_COORD"):
                self._notes.add("how an image is mapped is left out", self.material)
        return {"index": index}

    def _miss(self, socket):
        self._notes.add(f"{socket.name} {_ELSEWHERE}", self.material)


def _places(channels):
    """Each channel with its place in glTF's texture: roughness in green, metal in blue."""
    order = {"roughnessFactor": 1, "metallicFactor": 2}
    return [(channel, order[name]) for name, channel in channels.items()]


def _strength(value):
    return {"extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": value}}}
