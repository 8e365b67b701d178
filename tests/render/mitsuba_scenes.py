"""Scenes for Mitsuba 3, in its own terms, and the material of glTF for it.

Nothing here uses the renderer under test. Mitsuba's variant is scalar_rgb, which needs no LLVM.
"""

from pathlib import Path
from typing import Any

import mitsuba as mi
import numpy as np

mi.set_variant("scalar_rgb")
mi.set_log_level(mi.LogLevel.Error)

T = mi.ScalarTransform4f


class GltfBsdf(mi.BSDF):
    """Metallic-roughness as docs/scene.md and appendix B of the glTF 2.0 specification have it.

    GGX, height-correlated Smith, Schlick; what lies under the coat is weighted by
    (1 - E(wo)) (1 - E(wi)) / (1 - E_mean), with E by quadrature. Properties: base, a texture;
    metallic, roughness, f0. Directions are drawn by the cosine.
    """

    def __init__(self, props: mi.Properties) -> None:
        super().__init__(props)
        base = props["base"]  # a colour, or a texture
        self.base = base.eval if hasattr(base, "eval") else lambda _: mi.Color3f(base)
        self.metallic = float(props["metallic"])
        self.a2 = float(props["roughness"]) ** 4
        self.f0 = float(props["f0"])
        self.m_components = [mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide]
        self.m_flags = self.m_components[0]
        self.table = self._coat_albedo(np.linspace(0, 1, 257)) if self.f0 > 0 else np.zeros(257)
        mu = np.linspace(0, 1, 4001)
        self.mean = np.trapezoid(2 * mu * np.interp(mu, np.linspace(0, 1, 257), self.table), mu)

    def _specular(self, wo: np.ndarray, wi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """V D, and Schlick's (1 - wo.h)^5."""
        h = wo + wi
        h = h / np.maximum(np.linalg.norm(h, axis=-1, keepdims=True), 1e-12)
        n_h, o_h = h[..., 2], np.sum(wo * h, axis=-1)
        d = self.a2 / (np.pi * (n_h * n_h * (self.a2 - 1) + 1) ** 2)
        o, i = np.maximum(wo[..., 2], 1e-9), np.maximum(wi[..., 2], 1e-9)
        # Smith: G2 = 1 / (1 + Lambda(o) + Lambda(i)).
        lambdas = [(np.sqrt(1 + self.a2 * (1 / (x * x) - 1)) - 1) / 2 for x in (o, i)]
        v = 1 / (1 + lambdas[0] + lambdas[1]) / (4 * o * i)
        return v * d, np.clip(1 - o_h, 0, 1) ** 5

    def _coat_albedo(self, cosines: np.ndarray) -> np.ndarray:
        """The integral of the coat's lobe over wi, by half vectors: they follow the lobe."""
        n_h = (np.arange(400) + 0.5) / 400
        # n_h such that D n_h dh is uniform.
        n_h = np.sqrt((1 - n_h) / (1 + (self.a2 - 1) * n_h))
        phi = 2 * np.pi * (np.arange(128) + 0.5) / 128
        n_h, phi = (x.ravel() for x in np.meshgrid(n_h, phi))
        sine = np.sqrt(1 - n_h * n_h)
        h = np.stack([sine * np.cos(phi), sine * np.sin(phi), n_h], axis=-1)
        result = []
        for cosine in np.maximum(cosines, 1e-3):
            wo = np.array([np.sqrt(1 - cosine * cosine), 0, cosine])
            o_h = h @ wo
            wi = 2 * o_h[:, None] * h - wo
            vd, s = self._specular(np.broadcast_to(wo, wi.shape), wi)
            d = self.a2 / (np.pi * (n_h * n_h * (self.a2 - 1) + 1) ** 2)
            pdf = d * n_h / (4 * np.maximum(o_h, 1e-9))
            f = vd * (self.f0 + (1 - self.f0) * s) * wi[:, 2] / pdf
            result.append(np.mean(np.where((wi[:, 2] > 0) & (o_h > 0), f, 0)))
        return np.array(result)

    def _albedo(self, cosine: float) -> float:
        place = min(max(cosine, 0.0), 1.0) * 256
        k = min(int(place), 255)
        return self.table[k] + (place - k) * (self.table[k + 1] - self.table[k])

    def eval(self, ctx, si, wo, active=True):
        i, o = si.wi.z, wo.z  # Mitsuba's wi is towards the viewer
        if i <= 0 or o <= 0:
            return mi.Color3f(0)
        h = si.wi + wo
        h /= max((h.x * h.x + h.y * h.y + h.z * h.z) ** 0.5, 1e-12)
        n_h, o_h = h.z, si.wi.x * h.x + si.wi.y * h.y + si.wi.z * h.z
        d = self.a2 / (np.pi * (n_h * n_h * (self.a2 - 1) + 1) ** 2)
        g = 1.0
        for x in (i, o):
            g += ((1 + self.a2 * (1 / (x * x) - 1)) ** 0.5 - 1) / 2
        vd = d / (4 * i * o * g)
        s = min(max(1 - o_h, 0.0), 1.0) ** 5
        coat = self.f0 + (1 - self.f0) * s if self.f0 > 0 else 0.0
        below = (1 - self._albedo(i)) * (1 - self._albedo(o)) / (1 - self.mean) / np.pi
        base, metal = self.base(si), self.metallic
        mirror = metal * (base + (1 - base) * s) + (1 - metal) * coat
        return (mirror * vd + (1 - metal) * base * below) * o

    def pdf(self, ctx, si, wo, active=True):
        return wo.z / np.pi if si.wi.z > 0 and wo.z > 0 else 0.0

    def eval_pdf(self, ctx, si, wo, active=True):
        return self.eval(ctx, si, wo), self.pdf(ctx, si, wo)

    def sample(self, ctx, si, sample1, sample2, active=True):
        result = mi.BSDFSample3f()
        result.wo = mi.warp.square_to_cosine_hemisphere(sample2)
        result.pdf, result.eta = result.wo.z / np.pi, 1.0
        result.sampled_type, result.sampled_component = +mi.BSDFFlags.GlossyReflection, 0
        if si.wi.z <= 0 or result.pdf <= 0:
            return result, mi.Color3f(0)
        return result, self.eval(ctx, si, result.wo) / result.pdf

    def to_string(self):
        return "GltfBsdf"


mi.register_bsdf("gltf", GltfBsdf)


def rgb(value: Any) -> dict[str, Any]:
    return {"type": "rgb", "value": list(np.broadcast_to(value, 3).astype(float))}


def diffuse(color: Any) -> dict[str, Any]:
    return {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(color)}}


def gltf(base: Any, metallic: float, roughness: float, f0: float = 0.0) -> dict[str, Any]:
    base = base if isinstance(base, dict) else rgb(base)
    material = {"type": "gltf", "metallic": metallic, "roughness": roughness, "f0": f0}
    return {"type": "twosided", "bsdf": material | {"base": base}}


def mesh(path: Path, bsdf: dict[str, Any], to_world: Any = None, **more: Any) -> dict[str, Any]:
    """An OBJ file, flat-shaded."""
    shape = {"type": "obj", "filename": str(path), "face_normals": True, "bsdf": bsdf}
    return shape | ({} if to_world is None else {"to_world": to_world}) | more


def ground(size: float, height: float, bsdf: dict[str, Any]) -> dict[str, Any]:
    turned = T().translate([0, height, 0]).rotate([1, 0, 0], -90).scale(size / 2)
    return {"type": "rectangle", "to_world": turned, "bsdf": bsdf}


def emitter(radiance: Any) -> dict[str, Any]:
    return {"type": "area", "radiance": rgb(radiance)}


def facing(position: Any, look_at: Any, up: Any, scale: Any) -> Any:
    """Mitsuba's rectangles and disks face +z."""
    return T().look_at(list(position), list(look_at), list(up)).scale(list(scale))


def sampled_environment(function: Any) -> dict[str, Any]:
    """Radiance (..., 3) of directions (..., 3), at the points that Mitsuba's texels stand for.

    Its image wraps around within its width, from -z towards +x, column k at k + 1/2, and its first
    and last rows are the poles.
    """
    width, height = 1024, 512
    theta = np.pi * np.arange(height) / (height - 1)
    phi = 2 * np.pi * (np.arange(width) + 0.5) / width
    theta, phi = np.meshgrid(theta, phi, indexing="ij")
    d = np.stack(
        [np.sin(theta) * np.sin(phi), np.cos(theta), -np.sin(theta) * np.cos(phi)], axis=-1
    )
    return {"type": "envmap", "bitmap": mi.Bitmap(function(d).astype(np.float32))}


def render(
    shapes: dict[str, Any],
    camera: dict[str, Any],
    max_depth: int,
    batches: int,
    spp: int,
    size: Any,
) -> np.ndarray:
    """Independent images: (batches, height, width, 3) float64.

    camera, max_depth: as in our scene files; Mitsuba counts the light as one step more.
    """
    width, height = size
    film = {
        "type": "hdrfilm",
        "width": width,
        "height": height,
        "rfilter": {"type": "box"},
        "pixel_format": "rgb",
        "component_format": "float32",
    }
    up = camera.get("up", [0, 1, 0])
    sensor = {
        "type": "perspective",
        "fov": camera["vertical_fov_deg"],
        "fov_axis": "y",
        "near_clip": 1e-3,
        "to_world": T().look_at(list(camera["position"]), list(camera["look_at"]), list(up)),
        "film": film,
        "sampler": {"type": "multijitter"},
    }
    integrator = {"type": "path", "max_depth": max_depth + 1, "rr_depth": 1000}
    scene = mi.load_dict({"type": "scene", "integrator": integrator, "sensor": sensor, **shapes})
    images = [np.array(mi.render(scene, spp=spp, seed=seed)) for seed in range(batches)]
    return np.stack(images).astype(np.float64)
