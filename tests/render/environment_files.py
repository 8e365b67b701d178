"""Environments as other programs write them: what `rna-run` and the viewer read and refuse.

`cases(folder)` writes them all; each is either a picture or a message.
"""

import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import OpenEXR

HEIGHT, WIDTH = 12, 24


@dataclass(frozen=True)
class Case:
    """A file with its texels, (h, w, 3) float32, or None and the message of its refusal."""

    path: Path
    texels: np.ndarray | None = None
    message: str = ""

    def check(self, actual: np.ndarray) -> None:
        """The texels; those of DWA, the lossy cosine transform, to a step of float16."""
        lossy = 1e-3 if "DWA" in self.path.name else 0
        np.testing.assert_allclose(actual, self.texels, rtol=lossy, err_msg=self.path.name)


def picture() -> np.ndarray:
    """A sky with a sun; all values are exact in float16 and in RGBE."""
    texels = np.zeros((HEIGHT, WIDTH, 3), np.float32)
    texels[: HEIGHT // 2], texels[HEIGHT // 2 :] = (0.25, 0.5, 1.0), (0.75, 0.5, 0.25)
    texels[3, 5] = 896, 640, 512
    return texels


def rgbe_of(texels: np.ndarray) -> np.ndarray:
    largest = texels.max(axis=2)
    exponent = np.where(largest > 0, np.floor(np.log2(np.maximum(largest, 1e-30))) + 1, -128)
    mantissas = texels * 256 / 2.0 ** exponent[..., None]
    return np.concatenate([mantissas, exponent[..., None] + 128], axis=2).astype(np.uint8)


def new_code(rgbe: np.ndarray) -> bytes:
    """Each component of a line as one dump."""
    length = rgbe.shape[1]
    start = struct.pack(">BBH", 2, 2, length)
    lines = (line.T for line in rgbe)
    return b"".join(
        start + b"".join(bytes([length]) + component.tobytes() for component in line)
        for line in lines
    )


def old_code(rgbe: np.ndarray) -> bytes:
    """Runs of equal pixels as one pixel and how often it is repeated."""
    out = b""
    for line in rgbe:
        x = 0
        while x < len(line):
            run = 1
            while x + run < len(line) and (line[x + run] == line[x]).all():
                run += 1
            out += line[x].tobytes() + (bytes([1, 1, 1, run - 1]) if run > 1 else b"")
            x += run
    return out


def cases(folder: Path) -> list[Case]:
    return [*_hdr_cases(folder), *_exr_cases(folder)]


def _hdr_cases(folder: Path) -> list[Case]:
    actual: list[Case] = []
    texels, rgbe = picture(), rgbe_of(picture())
    start, size = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", b"-Y 12 +X 24\n"

    def case(name: str, content: bytes, expected: np.ndarray | str) -> None:
        path = folder / f"{name}.hdr"
        path.write_bytes(content)
        text = isinstance(expected, str)
        actual.append(Case(path, message=expected) if text else Case(path, expected))

    case("plain", start + b"\n" + size + new_code(rgbe), texels)
    case("old code", start + b"\n" + size + old_code(rgbe), texels)
    case("flat", start + b"\n" + size + rgbe.tobytes(), texels)
    zero = start + b"# Made with FreeImage 3.13.1\nGAMMA=1\nEXPOSURE=0\n\n"
    case("exposure 0", zero + size + new_code(rgbe), texels)
    twice = start + b"EXPOSURE=4\nEXPOSURE= 5e-1\n\n"
    case("exposure 2", twice + size + new_code(rgbe), texels / 2)
    spaces = b"#?RGBE\nVIEW= -vtl\nFORMAT = 32-bit_rle_rgbe\nCOLORCORR=2 2 2\n\n"
    case("spaces", spaces + size + new_code(rgbe), texels)
    lines = (start + b"\n" + size).replace(b"\n", b"\r\n")
    case("carriage returns", lines + new_code(rgbe), texels)
    case("no format", b"#?RADIANCE\n\n" + size + new_code(rgbe), texels)
    case("bytes behind", start + b"\n" + size + new_code(rgbe) + b"xxxx", texels)
    for axes, stored in {
        "+Y 12 +X 24": rgbe[::-1],
        "-Y 12 -X 24": rgbe[:, ::-1],
        "+Y 12 -X 24": rgbe[::-1, ::-1],
        "+X 24 -Y 12": rgbe.transpose(1, 0, 2),
        "-X 24 -Y 12": rgbe[:, ::-1].transpose(1, 0, 2),
        "+X 24 +Y 12": rgbe[::-1].transpose(1, 0, 2),
        "-X 24 +Y 12": rgbe[::-1, ::-1].transpose(1, 0, 2),
    }.items():
        content = start + b"\n" + axes.encode() + b"\n" + new_code(np.ascontiguousarray(stored))
        case(axes, content, texels)
    first = rgbe.copy()
    first[0, 0] = 2, 2, 1, 100  # as the newer code of another width begins
    flat_texels = texels.copy()
    flat_texels[0, 0] = np.float32([2, 2, 1]) * np.float32(2.0**-36)
    case("flat first 2 2", start + b"\n" + size + first.tobytes(), flat_texels)
    bright = rgbe.copy()
    bright[2, 2] = 128, 128, 128, 255
    case("bright", start + b"\n" + size + new_code(bright), "has 1 texels that are not finite")
    case("xyze", start.replace(b"rgbe", b"xyze") + b"\n" + size + new_code(rgbe), "32-bit_rle_xyze")
    case("exposure nan", start + b"EXPOSURE=nan\n\n" + size + new_code(rgbe), "EXPOSURE is not")
    case("exposure -1", start + b"EXPOSURE=-1\n\n" + size + new_code(rgbe), "EXPOSURE is not")
    case("no blank line", start + size + new_code(rgbe), "it has no header")
    case("same axes", start + b"\n-Y 12 +Y 24\n" + new_code(rgbe), "expected such as '-Y height")
    case("cut", start + b"\n" + size + new_code(rgbe)[:-1], "line 11: the file ends there")
    case("zero wide", start + b"\n-Y 12 +X 0\n", "has 0 x 12 pixels")
    case("too large", start + b"\n-Y 32768 +X 32768\n", "2^27 in all")
    case("bomb", start + b"\n-Y 8192 +X 16384\n" + bytes(64), "is at most 1024 times its file")
    case("jpeg", b"\xff\xd8\xff\xe0", "is neither an EXR nor a Radiance HDR image")
    return actual


Values = dict[str, np.ndarray]


def _rgb(texels: np.ndarray) -> Values:
    return {name: np.ascontiguousarray(texels[..., k]) for k, name in enumerate("RGB")}


def _write(path: Path, channels: Values, **header: object) -> None:
    kind = {"type": OpenEXR.scanlineimage, "compression": OpenEXR.ZIP_COMPRESSION}
    OpenEXR.File({**kind, **header}, dict(channels)).write(str(path))


def _box(left: int, top: int, right: int, bottom: int) -> tuple[np.ndarray, np.ndarray]:
    return np.int32([left, top]), np.int32([right, bottom])


def _exr_cases(folder: Path) -> list[Case]:
    actual: list[Case] = []
    texels = picture()

    def case(name: str, write: Callable[[Path], None], expected: np.ndarray | str) -> None:
        path = folder / f"{name}.exr"
        write(path)
        text = isinstance(expected, str)
        actual.append(Case(path, message=expected) if text else Case(path, expected))

    def exr(name: str, channels: Values, expected: np.ndarray | str, **header: object) -> None:
        case(name, lambda path: _write(path, channels, **header), expected)

    plain, half = _rgb(texels), _rgb(texels.astype(np.float16))
    for kind in ("NO", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24"):
        compression = getattr(OpenEXR, f"{kind}_COMPRESSION")
        exr(f"half {kind}", half, texels, compression=compression)
        exr(f"float {kind}", plain, texels, compression=compression)
    whole = np.full((HEIGHT, WIDTH, 3), 0.5, np.float32)
    for kind in ("B44", "B44A", "DWAA", "DWAB"):  # lossy, if not for one colour
        compression = getattr(OpenEXR, f"{kind}_COMPRESSION")
        exr(f"half {kind}", _rgb(whole.astype(np.float16)), whole, compression=compression)
    negative = texels.copy()
    negative[2, 2] = -3, 1, -0.0
    exr("negative", _rgb(negative), np.maximum(negative, 0))
    exr("luminance", {"Y": plain["G"]}, np.repeat(texels[..., 1:2], 3, axis=2))
    more = {"A": plain["R"], "Z": plain["G"], "assetId": np.zeros((HEIGHT, WIDTH), np.uint32)}
    exr("other channels", plain | more | {"light.key.R": plain["B"]}, texels)
    exr("alpha of another type", half | {"A": plain["R"]}, texels)
    exr("colours and luminance", half | {"Y": half["R"], "RY": half["R"]}, texels)
    exr("whole numbers between", plain | {"Id": more["assetId"]}, texels)
    exr("decreasing", plain, texels, lineOrder=OpenEXR.DECREASING_Y)
    exr("latlong", plain, texels, envmap=OpenEXR.ENVMAP_LATLONG)

    upper = np.zeros_like(texels)
    upper[:6] = texels[:6]
    window = {"displayWindow": _box(0, 0, WIDTH - 1, HEIGHT - 1)}
    stored = _rgb(texels[:6])
    exr("upper half", stored, upper, dataWindow=_box(0, 0, WIDTH - 1, 5), **window)
    inner = np.zeros_like(texels)
    inner[2:9, 4:20] = texels[2:9, 4:20]
    exr("a region", _rgb(texels[2:9, 4:20]), inner, dataWindow=_box(4, 2, 19, 8), **window)
    overscan = {"dataWindow": _box(0, 0, WIDTH - 1, HEIGHT - 1), "displayWindow": _box(4, 2, 19, 8)}
    exr("overscan", plain, np.ascontiguousarray(texels[2:9, 4:20]), **overscan)
    moved = {"dataWindow": _box(-9, 7, WIDTH - 10, HEIGHT + 6)}
    exr("moved", plain, texels, **moved, displayWindow=moved["dataWindow"])
    across = np.zeros_like(texels)
    across[:, :20], across[:, 20:] = texels[:, 4:], 0
    left = {"dataWindow": _box(-4, 0, WIDTH - 5, HEIGHT - 1), **window}
    exr("across the edge", plain, across, **left)
    outside = {"dataWindow": _box(100, 0, WIDTH + 99, HEIGHT - 1), **window}
    exr("outside", plain, "its data window lies outside", **outside)
    wide = {"dataWindow": moved["dataWindow"], "displayWindow": _box(0, 0, 39999, 39999)}
    exr("vast display", plain, "has 40000 x 40000 pixels", **wide)

    chroma = {"Y": half["R"], "RY": half["G"], "BY": half["B"]}
    exr("luminance and chroma", chroma, "luminance and chroma")
    exr("cube", _rgb(np.ones((24, 4, 3), np.float32)), "a cube map", envmap=OpenEXR.ENVMAP_CUBE)
    exr("no colours", {"Z": plain["R"]}, "no channels R, G and B, nor Y; it has Z")
    layers = {f"View.Combined.{name}": plane for name, plane in plain.items()}
    exr("one layer", layers, "it has View.Combined.B")
    uint = {name: plane.astype(np.uint32) for name, plane in plain.items()}
    exr("whole numbers", uint, "colours of type uint32")
    exr("two types", half | {"G": plain["G"]}, "colours of type float16, float32")
    for name, value in {"nan": np.nan, "-inf": -np.inf, "1e20": 1e20}.items():
        bad = texels.copy()
        bad[3, 5, 1] = value
        exr(name, _rgb(bad), "has 1 texels that are not finite")
    sun = half["R"].copy()
    sun[3, 5] = np.inf  # as 1e5 becomes in float16
    cut = texels.copy()
    cut[3, 5, 0] = 65504
    exr("overflow of the sun", half | {"R": sun}, cut)

    case("deep", _write_deep, "is a deep image")
    case("several parts", lambda path: _write_parts(path, plain), texels)
    tiled = {"type": OpenEXR.tiledimage}
    for mode, size in {"one level": 8, "large tiles": 64}.items():
        exr(mode, plain, texels, **tiled, tiles=_tiles(size))
    parts = lambda path: _write_parts(path, plain, **tiled, tiles=_tiles(8))  # noqa: E731
    case("tiles in a part", parts, "tiles in one of several parts")
    case("mip levels", lambda path: path.write_bytes(_levels(plain, 1)), texels)
    case("rip levels", lambda path: path.write_bytes(_levels(plain, 2)), "tiles of several sizes")
    case("subsampled", lambda path: path.write_bytes(_subsampled(plain)), "of fewer texels")
    case("cut", lambda path: path.write_bytes(_exr_bytes(plain)[:-200]), "cannot read the image")
    latin = _exr_bytes(plain | {"Zq": plain["R"]}).replace(b"Zq\0", b"Z\xff\0")
    case("a name in latin-1", lambda path: path.write_bytes(latin), "cannot read the image")
    foreign = _exr_bytes(plain, envmap=OpenEXR.ENVMAP_CUBE)
    foreign = foreign.replace(b"envmap\0envmap\0", b"envmap\0envmaq\0")
    case("envmap of another type", lambda path: path.write_bytes(foreign), texels)
    case("cut header", lambda path: path.write_bytes(_exr_bytes(plain)[:60]), "")
    large = _header(WIDTH, HEIGHT, [("B", 1), ("G", 1), ("R", 1)])
    large = large.replace(struct.pack("<2i", WIDTH - 1, HEIGHT - 1), struct.pack("<2i", 8191, 8191))
    case("bomb", lambda path: path.write_bytes(large + bytes(64)), "is at most 1024 times its file")
    return actual


def _tiles(size: int) -> OpenEXR.TileDescription:
    tiles = OpenEXR.TileDescription()
    tiles.xSize = tiles.ySize = size
    tiles.mode = OpenEXR.ONE_LEVEL
    return tiles


def _write_deep(path: Path) -> None:
    planes = {}
    for name in "RGBA":
        planes[name] = np.empty((2, 4), object)
        for place in np.ndindex(2, 4):
            planes[name][place] = np.float32([1.0])
    _write(path, planes, type=OpenEXR.deepscanline, compression=OpenEXR.ZIPS_COMPRESSION)


def _write_parts(path: Path, plain: Values, **header: object) -> None:
    """As Blender writes them: a part for each pass."""
    depth = {"type": OpenEXR.scanlineimage, "compression": OpenEXR.ZIP_COMPRESSION}
    parts = [
        OpenEXR.Part(dict(depth), {"Z": plain["R"]}, name="depth"),
        OpenEXR.Part({**depth, **header}, dict(plain), name="combined"),
        OpenEXR.Part(dict(depth), {n: p * 2 for n, p in plain.items()}, name="other"),
    ]
    OpenEXR.File(parts).write(str(path))


def _exr_bytes(plain: Values, **header: object) -> bytes:
    import tempfile

    with tempfile.NamedTemporaryFile(suffix=".exr") as file:
        _write(Path(file.name), plain, **header)
        return Path(file.name).read_bytes()


def _attribute(name: str, kind: str, value: bytes) -> bytes:
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value


def _header(
    width: int, height: int, channels: list[tuple[str, int]], tiles: bytes | None = None
) -> bytes:
    """OpenEXR file layout: one part of float32 without compression. channels: name, sampling."""
    rows = [
        name.encode() + b"\0" + struct.pack("<i4x2i", 2, sampling, sampling)
        for name, sampling in channels
    ]
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    parts = [
        struct.pack("<2i", 20000630, 2 | (0x200 if tiles else 0)),
        _attribute("channels", "chlist", b"".join(rows) + b"\0"),
        _attribute("compression", "compression", b"\0"),
        _attribute("dataWindow", "box2i", window),
        _attribute("displayWindow", "box2i", window),
        _attribute("lineOrder", "lineOrder", b"\0"),
        _attribute("pixelAspectRatio", "float", struct.pack("<f", 1)),
        _attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
        _attribute("screenWindowWidth", "float", struct.pack("<f", 1)),
        _attribute("tiles", "tiledesc", tiles) if tiles else b"",
    ]
    return b"".join(parts) + b"\0"


def _with_offsets(header: bytes, chunks: list[bytes]) -> bytes:
    starts = np.cumsum([len(header) + 8 * len(chunks)] + [len(chunk) for chunk in chunks])[:-1]
    return header + starts.astype("<u8").tobytes() + b"".join(chunks)


def _levels(plain: Values, mode: int, size: int = 8) -> bytes:
    """Tiles of all levels: of halved sizes (mode 1), or of each width with each height (2)."""
    header = _header(
        WIDTH, HEIGHT, [(name, 1) for name in "BGR"], struct.pack("<2IB", size, size, mode)
    )
    count = int(np.log2(max(WIDTH, HEIGHT))) + 1
    levels = [(k, k) for k in range(count)]
    if mode == 2:
        rows = int(np.log2(HEIGHT)) + 1
        levels = [(x, y) for y in range(rows) for x in range(int(np.log2(WIDTH)) + 1)]
    chunks = []
    for x_level, y_level in levels:
        width, height = max(WIDTH >> x_level, 1), max(HEIGHT >> y_level, 1)
        for top in range(0, height, size):
            for left in range(0, width, size):
                rows_of_tile = range(top, min(top + size, height))
                data = b"".join(
                    plain[name][row, left : min(left + size, width)].astype("<f4").tobytes()
                    for row in rows_of_tile
                    for name in "BGR"
                )
                place = struct.pack("<5i", left // size, top // size, x_level, y_level, len(data))
                chunks.append(place + data)
    return _with_offsets(header, chunks)


def _subsampled(plain: Values) -> bytes:
    """A depth of half the size beside colours."""
    header = _header(WIDTH, HEIGHT, [("B", 1), ("G", 1), ("R", 1), ("Z", 2)])
    chunks = []
    for row in range(HEIGHT):
        data = b"".join(plain[name][row].astype("<f4").tobytes() for name in "BGR")
        data += plain["R"][row, ::2].astype("<f4").tobytes() if row % 2 == 0 else b""
        chunks.append(struct.pack("<2i", row, len(data)) + data)
    return _with_offsets(header, chunks)
