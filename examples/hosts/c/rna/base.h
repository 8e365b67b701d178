/* Limits, and views of the package's bytes. */
#ifndef RNA_BASE_H
#define RNA_BASE_H

#include "../rna.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "packages are little-endian and used in place"
#endif
#ifdef __FAST_MATH__
#error "-ffast-math breaks rounding and the handling of NaN; leave it out for this file"
#endif

#if defined(__GNUC__)
#define PRINTF(text, first) __attribute__((format(printf, text, first)))
#define PREFETCH(address) __builtin_prefetch(address)
#else
#define PRINTF(text, first)
#define PREFETCH(address) ((void)(address))
#endif

/* Limits of section 11. */
enum {
    ALIGNMENT = 64,
    MAX_ENTRIES = 256,
    MAX_NAME = 200,
    MAX_MANIFEST = 1 << 20,
    MAX_DEPTH = 64,
    MAX_TIERS = 16,
    MAX_RECORDS = 64, /* of transmittance, of normal maps, and of base colour, a part */
    MAX_TEXTURE = 8192, /* texels along a side */
    MAX_CHANNELS = 64,
    MAX_HEADER = 1 << 16, /* JSON of a mesh, header of a tensor file */
    MAX_POINTS = 1 << 26,
    MAX_STRANDS = 1 << 25,
    MAX_DECODER = 1 << 26,
    MAX_NODES = 4096,
    MAX_WIDTH = 8192,           /* outputs of a layer */
    MAX_QUERY_VALUES = 1 << 16, /* outputs of all layers, and of the decoder */
    MAX_QUERY_WORK = 1 << 24,   /* multiply-adds */
    MAX_WIRE_FIELDS = 1 << 18   /* of a decoder's protobuf messages */
};

/* Some bytes of the package; where they are text, without an end mark. */
typedef struct Span {
    const uint8_t *at;
    size_t size;
} Span;

static Span text_span(const char *text) { return (Span){(const uint8_t *)text, strlen(text)}; }

static bool span_is(Span span, const char *text) {
    return span.size == strlen(text) && memcmp(span.at, text, span.size) == 0;
}

static bool same_span(Span a, Span b) {
    return a.size == b.size && (a.size == 0 || memcmp(a.at, b.at, a.size) == 0);
}

/* The order of their bytes, as qsort wants it. */
static int compare_spans(Span a, Span b) {
    size_t size = a.size < b.size ? a.size : b.size;
    int order = size ? memcmp(a.at, b.at, size) : 0;
    return order ? order : (a.size > b.size) - (a.size < b.size);
}

/* Whether the text is one of the words in `choices`, which have spaces between them. */
static bool is_choice(Span text, const char *choices) {
    for (const char *word = choices; *word; word += strspn(word, " ")) {
        size_t size = strcspn(word, " ");
        if (size == text.size && memcmp(word, text.at, size) == 0) return true;
        word += size;
    }
    return false;
}

static uint32_t u16_at(const uint8_t *at) { return at[0] | (uint32_t)at[1] << 8; }
static uint32_t u32_at(const uint8_t *at) { return u16_at(at) | u16_at(at + 2) << 16; }
static uint64_t u64_at(const uint8_t *at) { return u32_at(at) | (uint64_t)u32_at(at + 4) << 32; }

/* Memory that starts at a multiple of ALIGNMENT, for free_aligned.  Windows has no aligned_alloc. */
static void *aligned(size_t size) {
    const size_t more = ALIGNMENT + sizeof(void *);
    unsigned char *block = size < SIZE_MAX - more ? malloc(size + more) : NULL;
    if (!block) return NULL;
    uintptr_t first = (uintptr_t)block + sizeof(void *);
    unsigned char *result = block + sizeof(void *) + (ALIGNMENT - first % ALIGNMENT) % ALIGNMENT;
    memcpy(result - sizeof(void *), &block, sizeof(void *));
    return result;
}

static void free_aligned(void *memory) {
    void *block = NULL;
    if (memory) memcpy(&block, (unsigned char *)memory - sizeof(void *), sizeof(void *));
    free(block);
}

#endif
