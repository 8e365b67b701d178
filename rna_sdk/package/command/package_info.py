"""Facts of a package: size, parts, tiers, error, cost and origin, as data and as text."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from rna_sdk.commands.error_words import albedo_text, error_text
from rna_sdk.commands.size_note import size_note
from rna_sdk.package.geometry.curves import Curves
from rna_sdk.package.manifest.extensions import (
    Environment,
    Poster,
    Sampling,
    extension,
    of_part,
)
from rna_sdk.package.manifest.manifest_model import POSES, REST_FRAME, Manifest, Part
from rna_sdk.package.manifest.manifest_tiers import Tier, TierPart
from rna_sdk.package.package import Package

Info = dict[str, Any]


def package_info(path: Path) -> Info:
    """Facts of the package's files, with keys for programs; only JSON's types.

    Lengths are in metres. Raises PackageError for a broken package.
    """
    with Package.open(path) as package:
        manifest, carrier = package.manifest, package.carrier
        low, high = package.box()
        poster, lobes = extension(manifest, Poster), extension(manifest, Environment)
        origin = manifest.provenance
        return {
            "file": str(path),
            "bytes": package.file_bytes,
            "glb": carrier and {"bytes": path.stat().st_size, **carrier.facts()},
            "name": manifest.name,
            "format": manifest.version,
            "size": [float(f"{side:.6g}") for side in high - low],
            "size_note": size_note(low, high),
            "parts": [_part(package, k, has) for k, (_, has) in enumerate(contents(manifest))],
            "variants": list(package.variants()),
            "tiers": [_tier(tier) for tier in manifest.tiers],
            "lobes": lobes
            and [one.model_dump(mode="json", by_alias=False) for one in lobes.validation],
            "directions": manifest.domain.model_dump(mode="json"),
            "source": origin.source,
            "tool": origin.tool,
            "generator": manifest.generator,
            "capture": origin.capture,
            "training": origin.training,
            "license": manifest.license,
            "poster": poster and {"width": poster.width, "height": poster.height},
            "extensions": {
                name: "required" if name in manifest.extensions_required else "optional"
                for name in manifest.extensions_used
            },
        }


def _part(package: Package, index: int, has: list[str]) -> Info:
    record = package.manifest.parts[index]
    geometry = package.geometry(index)
    counts = (
        {"strands": len(geometry.offsets) - 1, "points": len(geometry.points)}
        if isinstance(geometry, Curves)
        else {"triangles": len(geometry.triangles), "vertices": len(geometry.positions)}
    )
    return {
        "name": record.name,
        "kind": record.kind,
        **counts,
        "has": has,
        "images": _images(package, index),
        "proxies": list(package.proxy_heights(index)),
    }


def _images(package: Package, part: int) -> list[Info]:
    """The images of base colour, each once."""
    images = {}
    records = package.manifest.parts[part].base_color
    for record, color in zip(records, package.base_color(part), strict=True):
        if record.image is not None and color.image is not None:
            height, width = color.image.shape[:2]
            images[record.image] = {
                "label": color.label,
                "entry": record.image,
                "width": width,
                "height": height,
                "bytes": package.manifest.entries[record.image].size,
            }
    return list(images.values())


def contents(manifest: Manifest) -> list[tuple[Part, list[str]]]:
    """Each part, and its contents beside geometry and transport: normal maps, emission, ...

    Decoders are those of the first tier.
    """
    result = []
    for k, (part, tier_part) in enumerate(
        zip(manifest.parts, manifest.tiers[0].parts, strict=True)
    ):
        named = {
            **{"transmittance": part.transmittance, "normal maps": part.normal_maps},
            "base colour": part.base_color,
        }
        has = [name for name, records in named.items() if records]
        has += [_DECODERS[decoder.form.name] for decoder in tier_part.decoders[1:]]
        if tier_part.nearby:
            has.append("nearby light")
        if lobes := of_part(manifest, Environment, k):
            has.append(f"{lobes.lobes} lobes")
        if mixtures := of_part(manifest, Sampling, k):
            has.append(f"rays in {len(mixtures)} mixtures of lobes")
        result.append((part, has))
    return result


_DECODERS = {"shadowed": "a decoder of shadowed light", "emission": "emission"}


def _tier(tier: Tier) -> Info:
    validation, cost = tier.validation, tier.cost
    return {
        "name": tier.name,
        "psnr": validation and validation.psnr,
        "flip": validation and validation.flip,
        "flip_p95": validation and validation.flip_p95,
        "images": validation and validation.images,
        "albedo": validation
        and validation.albedo
        and validation.albedo.model_dump(mode="json", by_alias=False),
        "ns_per_query": cost and cost.ns_per_query,
        "threads": cost and cost.threads,
        "machine": cost and cost.machine,
        "multiply_adds": cost and cost.multiply_adds,
        "parts": [_tier_part(part) for part in tier.parts],
    }


def _tier_part(part: TierPart) -> Info:
    return {
        "resolution": part.resolution,
        "channels": part.channels,
        "planes": part.plane_precision,
        "decoder": part.decoder_precision,
        "shadowed": part.shadowed and part.shadowed.decoder_precision,
        "uses_base_color": bool(part.uses_base_color),
    }


def info_lines(info: Info) -> Iterator[str]:
    """The report for a person; characters that a terminal would obey are shown as `?`."""
    for label, text in _rows(info):
        plain = "".join(c if c.isprintable() else "?" for c in text)
        yield f"{label:12}{plain}".rstrip()


def _rows(info: Info) -> Iterator[tuple[str, str]]:
    """Label and text of each line; the label is empty below the first line of a kind."""
    size = f"{info['bytes'] / 1e6:.2f} MB, format {info['format']}"
    yield "package", f"{info['name']}, {size}, {info['file']}"
    if info["glb"]:
        yield "carried by", _glb_text(info["glb"])
    yield "size", " x ".join(f"{side:.3g}" for side in info["size"]) + " m (x, y up, z)"
    if info["size_note"]:
        yield "note", info["size_note"]
    yield from _labelled("parts", map(_part_text, info["parts"]))
    images = [image for part in info["parts"] for image in part["images"]]
    yield from _labelled("images", map(_image_text, images))
    if info["variants"]:
        yield "variants", ", ".join(info["variants"])
    yield from _labelled("tiers", map(_tier_text, info["tiers"]))
    yield from _labelled("lobes", map(_lobes_text, info["lobes"] or ()))
    yield "directions", _directions_text(info["directions"])
    yield "made from", info["source"]
    yield "captured", _capture_text(info["capture"])
    yield from _labelled("trained", map(_training_text, info["training"].items()))
    yield "made with", f"{info['tool']}; {info['generator']}"
    yield "license", info["license"]
    poster = info["poster"]
    yield "poster", f"{poster['width']} x {poster['height']} pixels" if poster else "none"
    extensions = [
        name + " (required)" * (use == "required") for name, use in info["extensions"].items()
    ]
    yield "extensions", ", ".join(extensions) or "none"


def _glb_text(glb: Info) -> str:
    """The file about the package, and its look in viewers that do not know RNA."""
    size = f"a glTF of {glb['bytes'] / 1e6:.2f} MB, {_counted(glb['instances'], 'instance')}"
    meshes = _counted(glb["fallback_meshes"], "mesh", "es")
    skinned = ", skinned" if glb["fallback_skinned"] else ""
    flip = f", FLIP {glb['fallback_flip']:.3f}" if glb["fallback_flip"] is not None else ""
    return f"{size}; its fallback: {meshes}{skinned}{flip}"


def _counted(count: int, noun: str, plural: str = "s") -> str:
    return f"{count} {noun}{plural if count != 1 else ''}"


def _labelled(label: str, texts: Iterator[str]) -> Iterator[tuple[str, str]]:
    for text in texts:
        yield label, text
        label = ""


def _part_text(part: Info) -> str:
    counts = [f"{part[key]:,} {key}" for key in _COUNTS if key in part]
    proxies = [f"{len(part['proxies'])} proxies"] if part["proxies"] else []
    return f"{part['name']}: {part['kind']}, {', '.join([*counts, *part['has'], *proxies])}"


def _image_text(image: Info) -> str:
    size = f"{image['width']} x {image['height']} pixels, {image['bytes'] / 1e6:.3g} MB"
    return f"{image['label']}: {size}, {image['entry']}"


_COUNTS = ("triangles", "vertices", "strands", "points")


def _tier_text(tier: Info) -> str:
    error = "error not measured"
    if tier["flip_p95"] is not None:
        error = f"{error_text(tier['flip'], tier['flip_p95'])}, PSNR {tier['psnr']:.2f} dB"
    elif tier["psnr"] is not None:
        error = f"PSNR {tier['psnr']:.2f} dB"
    if tier["albedo"] is not None:
        error += f"; {albedo_text(tier['albedo']['ratio'], tier['albedo'].get('at80'))}"
    cost = "cost not measured"
    if tier["ns_per_query"] is not None:
        threads = "1 thread" if tier["threads"] == 1 else f"{tier['threads']} threads"
        cost = f"{tier['ns_per_query']:.0f} ns/query ({threads}, {tier['machine']})"
    first = tier["parts"][0]
    planes = f"{first['resolution']}^2 x {first['channels']} {first['planes']} planes"
    shadowed = f", {first['shadowed']} for shadowed light" if first["shadowed"] else ""
    return f"{tier['name']}: {error}; {cost}; {planes}, {first['decoder']} decoder{shadowed}"


def _lobes_text(error: Info) -> str:
    """Error under an environment: as viewers use lobes, its brightest directions apart; without."""
    score = f"PSNR {error['psnr_with_lights']:.2f} dB, FLIP {error['flip']:.4f}"
    return f"{score} under {error['environment']}; only lobes {error['psnr']:.2f} dB"


def _directions_text(domain: Info) -> str:
    """Light and view directions in words."""
    words = {"sphere": "all", "hemisphere": "those above the horizon"}
    view, light = (
        words.get(region, region)
        if isinstance(region, str)
        else f"{len(region)} cone{'s' * (len(region) > 1)}"
        for region in (domain["wo"], domain["wi"])
    )
    return f"seen from {view}, lit from {light}"


def _capture_text(capture: Info) -> str:
    words = {"lights": "lights", "rays": "rays a light", "samples": "samples a ray"}
    shown = [(words[key], capture.get(key)) for key in words]
    counts = [f"{value:,} {word}" for word, value in shown if isinstance(value, int)]
    if isinstance(frame := capture.get(REST_FRAME), int):
        counts.append(f"rest frame {frame}")
    if isinstance(poses := capture.get(POSES), list) and poses:
        counts.append(f"poses at frames {', '.join(map(str, poses))}")
    if isinstance(clamp := capture.get("clampDirect"), int | float) and clamp > 0.0:
        counts.append(f"direct light cut at a radiance of {clamp:g}")
    return ", ".join(counts) or "not recorded"


def _training_text(item: tuple[str, Any]) -> str:
    preset, record = item
    steps = record.get("steps") if isinstance(record, dict) else None
    return f"{preset}: {f'{steps:,} steps' if isinstance(steps, int) else 'not recorded'}"
