"""Limits that a reader enforces before it uses declared sizes (spec, "Limits")."""

import numpy as np

ALIGNMENT = 64
"""Bytes; every entry's data, and the first tensor inside an entry, starts on a multiple."""

MAX_FILE_BYTES = 2**32 - 2
"""Largest file that 32-bit ZIP fields address; 0xFFFFFFFF would announce ZIP64."""

MAX_ENTRIES = 256
MAX_NAME_BYTES = 200
MAX_MANIFEST_BYTES = 2**20
MAX_JSON_DEPTH = 64
MAX_INTEGER = 2**53 - 1
"""Up to here every JSON parser has every integer (RFC 7493, section 2.2)."""

MAX_COORDINATE = 1e18
"""Metres, of the bounds; squares of distances stay finite in float32."""

MIN_EXTENT = 1e-18
"""Metres, of the bounds along an axis; squares of it stay normal in float32."""

MAX_DEFLATE_RATIO = 64
DEFLATE_ALLOWANCE = 2**20
"""A coded entry inflates to this many bytes and MAX_DEFLATE_RATIO times those stored, at most."""

MAX_PARTS = 16
MAX_TIERS = 16
MAX_CONES = 16
MAX_PROXIES = 8
MAX_LOBES = 32
MAX_VARIANTS = 64
MAX_NARROW_LOBES = 3
"""Mirror lobes, or cones, of a mixture of RNA_sampling."""

MAX_MIXTURES = 16
"""Mixtures of a part."""

MAX_VALIDATIONS = 64
"""Environments under which the error of lobes is recorded."""

MAX_RESOLUTION = 4096
MAX_CHANNELS = 64
MAX_TEXEL = np.float32(1e18)
"""Largest magnitude of a value of the planes; keeps sums and squares finite in float32."""

MAX_TEXTURE_RECORDS = 64
MAX_TEXTURE_SIDE = 8192

MAX_TENSORS_HEADER_BYTES = 2**16
MAX_GLTF_JSON_BYTES = 2**16
MAX_CARRIER_JSON_BYTES = 2**23
"""Bytes of a .glb that carries a package: it may be a whole scene."""

MAX_CURVE_POINTS = 2**26
MAX_STRANDS = 2**25

MAX_DECODER_BYTES = 2**26
MAX_DECODER_NODES = 4096
MAX_DECODER_WIDTH = 8192
"""Most outputs of a decoder's layer."""

MAX_QUERY_VALUES = 2**16
"""Outputs of all layers of a decoder together."""

MAX_QUERY_WORK = 2**24
"""Multiply-adds a query, and so the weights that a decoder holds in memory."""

IR_VERSIONS = range(7, 11)
OPSET_VERSIONS = range(13, 22)
