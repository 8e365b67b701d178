"""Materials of Blender as materials of glTF 2.0, as far as possible."""

from .textures import Textures

_GREY = {"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.8, 0.8, 1.0], "metallicFactor": 0.0}}
_LEFT_OUT = {  # inputs of the Principled BSDF that glTF, as rna-run reads it, has nothing for
    "Subsurface Weight": "subsurface scattering is left out",
    "Anisotropic": "anisotropy is left out",
    "Sheen Weight": "sheen is left out",
    "Thin Film Thickness": "thin films are left out",
}


def describe_material(material, glb, notes):
    """A glTF material; its textures go to `glb`. None, for objects without one, is grey."""
    if material is None:
        return _lambert(_GREY["pbrMetallicRoughness"])
    tree = material.node_tree if getattr(material, "use_nodes", True) else None
    if tree is None:
        return _plain(material)
    output = tree.get_output_node("CYCLES") or tree.get_output_node("ALL")
    surface = output.inputs["Surface"] if output is not None else None
    if surface is None or not surface.is_linked:
        notes.add("no surface: rendered as grey", material.name)
        return _lambert(_GREY["pbrMetallicRoughness"])
    for name in ("Displacement", "Volume"):
        if output.inputs[name].is_linked:
            notes.add(f"the material's {name.lower()} is left out", material.name)
    node = surface.links[0].from_node
    if node.type not in _SHADERS:
        notes.add(f"shader {node.type} is rendered as grey", material.name)
        return _lambert(_GREY["pbrMetallicRoughness"])
    result = _SHADERS[node.type](node, Textures(material.name, glb, notes), notes)
    return {"name": material.name, "doubleSided": True, **result}


def _plain(material):
    """Without nodes: the viewport's."""
    factor = [*material.diffuse_color[:3], 1.0]
    roughness, metallic = material.roughness, material.metallic
    values = {"roughnessFactor": roughness, "metallicFactor": metallic}
    return {"name": material.name, "pbrMetallicRoughness": {"baseColorFactor": factor, **values}}


def _lambert(base):
    """Without a coat, as Diffuse BSDF."""
    specular = {"KHR_materials_specular": {"specularFactor": 0.0}}
    return {"pbrMetallicRoughness": {"roughnessFactor": 1.0, **base}, "extensions": specular}


def _diffuse(node, textures, notes):
    if node.inputs["Roughness"].is_linked or node.inputs["Roughness"].default_value > 0.0:
        notes.add("Oren and Nayar's roughness is left out", textures.material)
    base = {"metallicFactor": 0.0, **textures.base(node.inputs["Color"], None)}
    return {**_lambert(base), **textures.relief(node.inputs["Normal"])}


def _glossy(node, textures, notes):
    colour = node.inputs.get("Color") or node.inputs["Base Color"]
    base = textures.base(colour, None)
    base |= textures.metallic_roughness(None, node.inputs["Roughness"])
    return {"pbrMetallicRoughness": base, **textures.relief(node.inputs["Normal"])}


def _emission(node, textures, notes):
    base = {"baseColorFactor": [0.0, 0.0, 0.0, 1.0], "metallicFactor": 0.0}
    result = _lambert(base)
    shine = textures.emission(node.inputs["Color"], node.inputs["Strength"])
    extensions = {**result["extensions"], **shine.pop("extensions", {})}
    return {**result, **shine, "extensions": extensions}


def _principled(node, textures, notes):
    inputs = node.inputs
    for name, text in _LEFT_OUT.items():
        socket = inputs.get(name)
        if socket is not None and (socket.is_linked or socket.default_value > 0.0):
            notes.add(text, textures.material)
    base = textures.base(inputs["Base Color"], inputs["Alpha"])
    base |= textures.metallic_roughness(inputs["Metallic"], inputs["Roughness"])
    result = {"pbrMetallicRoughness": base, **textures.relief(inputs["Normal"])}
    result |= textures.alpha_mode(inputs["Alpha"])
    extensions = {"KHR_materials_ior": {"ior": textures.number(inputs["IOR"])}}
    level = 2.0 * textures.number(inputs["Specular IOR Level"])
    if level != 1.0:
        extensions["KHR_materials_specular"] = {"specularFactor": min(level, 1.0)}
    shine = textures.emission(inputs["Emission Color"], inputs["Emission Strength"])
    extensions |= shine.pop("extensions", {})
    extensions |= _coat(inputs, textures) | _transmission(inputs, textures, notes)
    return {**result, **shine, "extensions": extensions}


def _coat(inputs, textures):
    weight = textures.number(inputs["Coat Weight"])
    if weight <= 0.0:
        return {}
    roughness = textures.number(inputs["Coat Roughness"])
    factors = {"clearcoatFactor": weight, "clearcoatRoughnessFactor": roughness}
    return {"KHR_materials_clearcoat": factors}


def _transmission(inputs, textures, notes):
    weight = textures.number(inputs["Transmission Weight"])
    if weight <= 0.0:
        return {}
    notes.add("glass is rendered as thin walls, which do not refract", textures.material)
    return {"KHR_materials_transmission": {"transmissionFactor": weight}}


_SHADERS = {
    "BSDF_PRINCIPLED": _principled,
    "BSDF_DIFFUSE": _diffuse,
    "BSDF_GLOSSY": _glossy,
    "BSDF_METALLIC": _glossy,
    "EMISSION": _emission,
}
