"""Materials of the recipes, and images that they compute."""

import bpy
import numpy as np


def image(name, pixels, colour_space="sRGB"):
    """A packed 8-bit image of pixels (h, w, 3 or 4) in [0, 1], encoded; the first row is v = 0.

    Alpha is a channel of its own: colours go on below it, and filters find no dark rim.
    """
    height, width, channels = pixels.shape
    rgba = np.ones((height, width, 4), np.float32)
    rgba[..., :channels] = np.clip(pixels, 0.0, 1.0)
    made = bpy.data.images.new(name, width, height, alpha=channels == 4)
    made.colorspace_settings.name = colour_space
    made.alpha_mode = "CHANNEL_PACKED"
    made.pixels.foreach_set(rgba.reshape(-1))
    made.update()
    made.pack()
    return made


def principled(name, base=None, **values):
    """A Principled BSDF; `base` an image, or linear RGB; values by socket name, "_" for a space."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    if isinstance(base, bpy.types.Image):
        texture = add_image(material, base)
        material.node_tree.links.new(texture.outputs["Color"], shader.inputs["Base Color"])
    elif base is not None:
        shader.inputs["Base Color"].default_value = (*base, 1.0)
    for socket, value in values.items():
        shader.inputs[socket.replace("_", " ")].default_value = value
    return material


def add_image(material, pixels):
    """The image node of an image, added to a material."""
    node = material.node_tree.nodes.new("ShaderNodeTexImage")
    node.image = pixels
    return node


class Nodes:
    """The nodes of a material with a Principled BSDF."""

    def __init__(self, name, base=None, **values):
        self.material = principled(name, base, **values)
        self.tree = self.material.node_tree
        self.shader = self.tree.nodes["Principled BSDF"]

    def add(self, kind, label=None, **values):
        """A node ShaderNode`kind`; values by socket name, "_" for a space."""
        node = self.tree.nodes.new(f"ShaderNode{kind}")
        node.label = label or ""
        for name, value in values.items():
            node.inputs[name.replace("_", " ")].default_value = value
        return node

    def link(self, output, socket):
        """socket: of a node, or the name of one of the Principled BSDF."""
        named = isinstance(socket, str)
        self.tree.links.new(output, self.shader.inputs[socket] if named else socket)

    def coordinates(self, output, scale=None):
        """An output of Texture Coordinate, stretched."""
        source = self.add("TexCoord").outputs[output]
        if scale is None:
            return source
        mapping = self.add("Mapping", Scale=scale)
        self.link(source, mapping.inputs["Vector"])
        return mapping.outputs["Vector"]

    def placed(self, texture, output="Object", scale=None):
        """A texture node, with these coordinates."""
        self.link(self.coordinates(output, scale), texture.inputs["Vector"])
        return texture

    def ramp(self, value, *stops):
        """The colours of a ramp of (position, linear RGB)."""
        node = self.add("ValToRGB")
        while len(node.color_ramp.elements) < len(stops):
            node.color_ramp.elements.new(1.0)
        for element, (position, colour) in zip(node.color_ramp.elements, stops, strict=True):
            element.position, element.color = position, (*colour, 1.0)
        self.link(value, node.inputs[0])
        return node.outputs["Color"]

    def bump(self, height, **values):
        """A Bump node for the Principled BSDF; values: of its inputs."""
        node = self.add("Bump", **values)
        self.link(height, node.inputs["Height"])
        self.link(node.outputs["Normal"], "Normal")
        return node


def mix(material, factor, first, second):
    """A Mix Shader: `second` where the factor, a socket or a number, is 1. Returns its output."""
    tree = material.node_tree
    node = tree.nodes.new("ShaderNodeMixShader")
    if isinstance(factor, bpy.types.NodeSocket):
        tree.links.new(factor, node.inputs[0])
    else:
        node.inputs[0].default_value = factor
    tree.links.new(first, node.inputs[1])
    tree.links.new(second, node.inputs[2])
    return node.outputs[0]


def finish(material, shader):
    """Make a shader socket the material's surface."""
    tree = material.node_tree
    output = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    tree.links.new(shader, output.inputs["Surface"])
    return material


def add_shader(material, kind, colour=None, roughness=None):
    """The output of a new BSDF node, ShaderNodeBsdf`kind`; colour an image's socket, or RGB."""
    tree = material.node_tree
    node = tree.nodes.new(f"ShaderNodeBsdf{kind}")
    if isinstance(colour, bpy.types.NodeSocket):
        tree.links.new(colour, node.inputs["Color"])
    elif colour is not None:
        node.inputs["Color"].default_value = (*colour, 1.0)
    if roughness is not None:
        node.inputs["Roughness"].default_value = roughness
    return node.outputs[0]


def encoded(linear):
    """sRGB encoding of linear values."""
    linear = np.clip(linear, 0.0, 1.0)
    low = linear <= 0.0031308
    return np.where(low, 12.92 * linear, 1.055 * np.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)


def smooth_noise(shape, cells, rng):
    """Values in [0, 1] that change over `cells` (rows, columns) a side; repeats at the borders."""
    values = rng.random(cells)
    place = [np.arange(n) * c / n for n, c in zip(shape, cells, strict=True)]
    at = [p.astype(int) for p in place]
    t = [(p - a) ** 2 * (3.0 - 2.0 * (p - a)) for p, a in zip(place, at, strict=True)]
    (i, j), (a, b) = at, (t[0][:, None], t[1][None])
    up, over = (i + 1) % cells[0], (j + 1) % cells[1]
    top = values[np.ix_(i, j)] * (1 - b) + values[np.ix_(i, over)] * b
    bottom = values[np.ix_(up, j)] * (1 - b) + values[np.ix_(up, over)] * b
    return top * (1 - a) + bottom * a
