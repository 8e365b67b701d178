/* Damaged packages for fuzzing: the same seed gives the same bytes, everywhere. */
#ifndef MUTATE_H
#define MUTATE_H

#include <stddef.h>
#include <stdint.h>

/* Writes a mutation of a good package to `out` and returns its size, at most `room`, which must be
 * 1 MiB and more.  JSON, protobuf fields, tensor values and lengths change; sizes, CRC-32 and SHA-256
 * are made to fit again in most mutations, so that readers get past them. */
size_t rna_mutate(const uint8_t *package, size_t size, uint64_t seed, uint8_t *out, size_t room);

#endif
