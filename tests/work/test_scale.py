"""The memory of a driver does not grow with the number of items."""

import tracemalloc

from rna_work.pool import Pool
from rna_work.threads import Threads
from tests.work.workers import Doubling


def test_memory_is_flat():
    with Pool(Threads(2), Doubling, ahead=4) as pool:
        list(pool.run(range(2000)))
        tracemalloc.start()
        used = []
        for outcome in pool.run(range(20_000)):
            if outcome.item % 5000 == 4999:
                used.append(tracemalloc.get_traced_memory()[0])
        tracemalloc.stop()
    assert max(used) - min(used) < 50_000
