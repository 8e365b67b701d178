"""Read, write and validate `.rna` packages (format: spec/RNA.md).

Examples:
    >>> with Package.open("toy.rna") as package:
    ...     planes = package.planes("small")
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
