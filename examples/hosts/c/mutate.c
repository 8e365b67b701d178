/* Damaged packages for fuzzing; mutate.h says what it offers. */
#include "mutate.h"
#include "rna.c" /* for its CRC-32, its SHA-256 and its wire format */

enum { MAX_ITEM = 1 << 18, MAX_ITEMS = 24 };

/* An entry of the package. */
typedef struct Item {
    char name[MAX_NAME + 1];
    uint8_t *data;
    size_t size;
    char digest[65]; /* of the data as it was */
} Item;

typedef struct Mutator {
    uint64_t state; /* of the random numbers */
    Item items[MAX_ITEMS];
    int count;
} Mutator;

/* splitmix64 (Steele, Lea and Flood 2014). */
static uint64_t next_random(Mutator *m) {
    uint64_t z = m->state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

static size_t below(Mutator *m, size_t n) { return n ? (size_t)(next_random(m) % n) : 0; }

static uint32_t odd_word(Mutator *m) {
    static const uint32_t WORDS[] = {0, 1, 2, 3, 0x7f, 0x80, 0xff, 0x100, 0xffff, 0x10000, 0x7fffffff,
                                     0x80000000, 0xffffffff, 0xfffffffe, 0x3f800000, 0xbf800000,
                                     0x7f800000, 0xff800000, 0x7fc00000, 0x7f7fffff, 0xff7fffff,
                                     0x00800000, 0x00000001, 0x3f7fffff, 0x41000000, 5125, 5126};
    size_t i = below(m, sizeof WORDS / sizeof *WORDS + 8);
    return i < sizeof WORDS / sizeof *WORDS ? WORDS[i] : (uint32_t)next_random(m);
}

/* Replaces `gone` bytes at `at` by others; does nothing where they do not fit. */
static void splice(Item *item, size_t at, size_t gone, const void *bytes, size_t count) {
    if (at > item->size) return;
    if (gone > item->size - at) gone = item->size - at;
    if (item->size - gone + count > MAX_ITEM) return;
    uint8_t *copy = malloc(count + 1);
    if (!copy) return;
    if (count) memcpy(copy, bytes, count); /* they may be of the item itself */
    memmove(item->data + at + count, item->data + at + gone, item->size - at - gone);
    memcpy(item->data + at, copy, count);
    item->size = item->size - gone + count;
    free(copy);
}

static void mutate_bytes(Mutator *m, Item *item, size_t from, size_t to) {
    if (to <= from) return;
    size_t at = from + below(m, to - from), count = 1 + below(m, 16);
    uint32_t word = odd_word(m);
    switch (below(m, 8)) {
    case 0: item->data[at] ^= (uint8_t)(1u << below(m, 8)); break;
    case 1: item->data[at] = (uint8_t)word; break;
    case 2: splice(item, at, count, NULL, 0); break;
    case 3: splice(item, at, 0, item->data + at, count < to - at ? count : to - at); break;
    default:
        at = from + (at - from) / 4 * 4;
        if (to - at >= 4) memcpy(item->data + at, &word, 4);
    }
}

/* ----------------------------------------------------------------- JSON text */

/* A token from a random place on, before `to`: a number or word, or a string; its size. */
static size_t find_token(Mutator *m, const Item *item, size_t from, size_t to, size_t *at) {
    if (to <= from) return 0;
    *at = from + below(m, to - from);
    while (*at < to && !memchr("\"0123456789-", item->data[*at], 12)) ++*at;
    if (*at >= to) return 0;
    size_t end = *at + 1;
    if (item->data[*at] == '"') {
        while (end < to && item->data[end] != '"') end++;
        return end < to ? end + 1 - *at : 0;
    }
    while (end < to && memchr("0123456789.eE+-", item->data[end], 15)) end++;
    return end - *at;
}

/* Replaces the token, if it is a number, by one near it or a small multiple: sizes that nearly fit. */
static void mutate_number(Mutator *m, Item *item, size_t at, size_t size) {
    char text[24] = {0};
    if (size == 0 || size > 12 || item->data[at] < '0' || item->data[at] > '9') return;
    memcpy(text, item->data + at, size);
    unsigned long long value = strtoull(text, NULL, 10);
    const unsigned long long others[] = {value + 1, value - (value > 0), 2 * value, 3 * value, 4 * value,
                                         value / 2, value + 3, value + 4, value + 12, value + 64};
    snprintf(text, sizeof text, "%llu", others[below(m, sizeof others / sizeof *others)]);
    splice(item, at, size, text, strlen(text));
}

static void mutate_text(Mutator *m, Item *item, size_t from, size_t to) {
    static const char *const VALUES[] = {
        "0", "-0", "1", "-1", "2", "3", "8.0", "1e0", "8e-1", "1e400", "-1e400", "1e-400", "64", "65", "4096",
        "4097", "4294967295", "4294967296", "9007199254740991", "9007199254740993",
        "18446744073709551616", "0.5", "1e18", "1.1e18", "3.5e38", "1e-40", "NaN", "-Infinity", "01", "1.",
        ".5", "1e", "true", "false", "null", "[]", "{}", "[0]", "{\"a\":1}", "\"\"", "\"8\"", "\"\\ud800\"",
        "\"\\ud83d\\ude00\"", "\"\\u0000\"", "\"\\q\"", "\"../x\"", "\"float16\"", "\"int8\"", "\"float32\"",
        "\"fiber\"", "\"surface\"", "\"1.0\"", "\"1.1\"", "\"01.0\"", "\"1.0\\n\"", "\"F32\"", "\"U32\"",
        "\"VEC3\"", "\"SCALAR\"", "\"U8\"", "\"U16\"", "\"I16\"", "\"I32\"", "5122", "5123", "[1.5,1.5]", "[0,3]",
        "[1,1,3]", "\"KHR_mesh_quantization\"", "\"hemisphere\"", "\"features\"", "\"h\"", "\"learned_normal\"",
        "[{\"axis\":[0,1,0],\"halfAngle\":0.5}]", "\"\xc3\x28\"", "\"\xed\xa0\x80\"", "\"\xf4\x90\x80\x80\"",
        "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["};
    static const char MARKS[] = "{}[]\",:0123456789eE+-. \\ntrufalsx/\t\n";
    size_t at, size = find_token(m, item, from, to, &at), other, other_size;
    const char *value = VALUES[below(m, sizeof VALUES / sizeof *VALUES)];
    switch (below(m, 14)) {
    case 0:
    case 1:
    case 2: /* another token of the text */
        other_size = find_token(m, item, from, to, &other);
        if (size && other_size) splice(item, at, size, item->data + other, other_size);
        break;
    case 3:
    case 4: /* a whole line again, or gone */
        at = from + below(m, to - from);
        for (size = 0; at + size < to && item->data[at + size] != ','; size++) {}
        if (below(m, 2))
            splice(item, at, size, NULL, 0);
        else
            splice(item, at, 0, item->data + at, size + (at + size < to));
        break;
    case 5: item->data[from + below(m, to - from)] = (uint8_t)MARKS[below(m, sizeof MARKS - 1)]; break;
    case 6:
    case 7: mutate_bytes(m, item, from, to); break;
    case 8:
    case 9: mutate_number(m, item, at, size); break;
    default: splice(item, at, size, value, size ? strlen(value) : 0);
    }
}

/* ------------------------------------------------------------------ Protobuf */

typedef struct Output {
    uint8_t *at;
    size_t size, room;
} Output;

static void put_bytes(Output *out, const void *bytes, size_t size) {
    if (size == 0 || size > out->room - out->size) return;
    memcpy(out->at + out->size, bytes, size);
    out->size += size;
}

static void put_varint(Output *out, uint64_t value) {
    do {
        uint8_t byte = (uint8_t)((value & 0x7f) | (value > 0x7f ? 0x80 : 0));
        put_bytes(out, &byte, 1);
    } while (value >>= 7);
}

static uint64_t odd_varint(Mutator *m, uint64_t value) {
    static const uint64_t VALUES[] = {0, 1, 2, 3, 6, 7, 10, 11, 13, 21, 22, 127, 128, 8192, 8193, 0x7fffffff,
                                      0x80000000, 0xffffffff, 0x7fffffffffffffff, 0xffffffffffffffff};
    size_t i = below(m, sizeof VALUES / sizeof *VALUES + 6);
    return i < sizeof VALUES / sizeof *VALUES ? VALUES[i] : value + (i & 1 ? 1 : UINT64_MAX);
}

static void put_odd_bytes(Mutator *m, Output *out, Span bytes) {
    static const char *const TEXTS[] = {
        "Relu", "Gemm", "Clip", "Exp", "Sub", "Mul", "MatMul", "Concat", "Add", "QuantizeLinear",
        "DequantizeLinear", "Identity", "Loop", "queries", "transport", "emission", "ai.onnx", "axis", "c0", "c1",
        "c2", "v0", "v1", "v2", ""};
    uint8_t *copy = malloc(bytes.size + 16);
    Item item = {.data = copy, .size = bytes.size};
    if (!copy) return;
    memcpy(copy, bytes.at, bytes.size);
    const char *text = TEXTS[below(m, sizeof TEXTS / sizeof *TEXTS)];
    switch (below(m, 5)) {
    case 0:
        put_varint(out, strlen(text));
        put_bytes(out, text, strlen(text));
        free(copy);
        return;
    case 1: item.size = below(m, bytes.size + 1); break;
    default:
        for (size_t k = 1 + below(m, 4); k && bytes.size; k--) {
            uint32_t word = odd_word(m);
            size_t at = below(m, bytes.size);
            if (bytes.size % 4 == 0)
                memcpy(copy + at / 4 * 4, &word, 4);
            else
                copy[at] = (uint8_t)word;
        }
    }
    put_varint(out, item.size);
    put_bytes(out, item.data, item.size);
    free(copy);
}

static size_t count_fields(Span message) {
    Wire wire = {0};
    Field field;
    size_t count = 0;
    while (next_field(&wire, &message, &field)) count++;
    return wire.broken ? 0 : count;
}

/* Writes the message with one field, of it or of a message in it, changed. */
static void mutate_message(Mutator *m, Span message, Output *out, int depth) {
    size_t target = below(m, count_fields(message)), index = 0;
    Wire wire = {0};
    Field field;
    for (const uint8_t *start = message.at; next_field(&wire, &message, &field); start = message.at) {
        uint64_t tag = field.number << 3 | (field.is_integer ? VARINT : BYTES);
        bool is_bytes = !field.is_integer && (start[0] & 7) == BYTES;
        if (index++ != target || (!field.is_integer && !is_bytes)) {
            put_bytes(out, start, (size_t)(message.at - start));
            continue;
        }
        size_t action = below(m, 16);
        if (is_bytes && depth < 6 && count_fields(field.bytes) && action > 2) {
            Output inner = {malloc(MAX_ITEM), 0, MAX_ITEM};
            if (!inner.at) return;
            mutate_message(m, field.bytes, &inner, depth + 1);
            put_varint(out, tag);
            put_varint(out, inner.size);
            put_bytes(out, inner.at, inner.size);
            free(inner.at);
        } else if (action == 0) {
            continue; /* gone */
        } else if (action == 1) {
            put_bytes(out, start, (size_t)(message.at - start));
            put_bytes(out, start, (size_t)(message.at - start));
        } else if (action == 2) {
            put_varint(out, tag ^ 1u << below(m, 7));
            put_bytes(out, start + 1, (size_t)(message.at - start) - 1);
        } else {
            put_varint(out, tag);
            if (is_bytes)
                put_odd_bytes(m, out, field.bytes);
            else
                put_varint(out, odd_varint(m, field.integer));
        }
    }
}

/* ------------------------------------------------------------------- Entries */

static void mutate_glb(Mutator *m, Item *item) {
    bool whole = item->size >= 28 && u32_at(item->data + 12) <= item->size - 28; /* as yet */
    if (!whole || below(m, 16) == 0) {
        mutate_bytes(m, item, 0, item->size < 64 ? item->size : 64);
        return;
    }
    uint32_t text = u32_at(item->data + 12), before = (uint32_t)item->size;
    if (below(m, 2)) {
        mutate_bytes(m, item, 20 + text, item->size);
    } else {
        mutate_text(m, item, 20, 20 + text);
        while (item->size % 4) splice(item, 20, 0, " ", 1);
        text += (uint32_t)item->size - before;
    }
    uint32_t size = (uint32_t)item->size, blob = size - text - 28;
    if (below(m, 16) == 0 || (size_t)text + 28 > item->size) return;
    memcpy(item->data + 8, &size, 4);
    memcpy(item->data + 12, &text, 4);
    memcpy(item->data + 20 + text, &blob, 4);
}

static void mutate_tensors(Mutator *m, Item *item) {
    bool whole = item->size >= 8 && u64_at(item->data) <= item->size - 8; /* as yet */
    if (!whole || below(m, 16) == 0) {
        mutate_bytes(m, item, 0, item->size < 64 ? item->size : 64);
        return;
    }
    size_t header = (size_t)u64_at(item->data), before = item->size;
    if (below(m, 2)) {
        for (size_t k = 1 + below(m, 3); k; k--) mutate_bytes(m, item, 8 + header, item->size);
        return;
    }
    mutate_text(m, item, 8, 8 + header);
    header += item->size - before;
    while (header > 0 && item->data[8 + header - 1] == ' ') splice(item, 8 + --header, 1, NULL, 0);
    while ((8 + header) % 64 && item->size < MAX_ITEM) splice(item, 8 + header++, 0, " ", 1);
    uint64_t size = header;
    if (below(m, 16)) memcpy(item->data, &size, 8);
}

static void mutate_decoder(Mutator *m, Item *item) {
    Output out = {malloc(MAX_ITEM), 0, MAX_ITEM};
    if (!out.at) return;
    mutate_message(m, (Span){item->data, item->size}, &out, 0);
    if (below(m, 32) == 0) out.size = below(m, out.size);
    memcpy(item->data, out.at, out.size);
    item->size = out.size;
    free(out.at);
}

static void mutate_item(Mutator *m, Item *item) {
    const char *dot = strrchr(item->name, '.');
    if (strcmp(dot, ".json") == 0)
        mutate_text(m, item, 0, item->size);
    else if (strcmp(dot, ".glb") == 0)
        mutate_glb(m, item);
    else if (strcmp(dot, ".onnx") == 0)
        mutate_decoder(m, item);
    else
        mutate_tensors(m, item);
}

/* ------------------------------------------------------------------- Package */

static bool take_apart(Mutator *m, Span package) {
    const uint8_t *end = package.at + package.size - END_SIZE;
    m->count = (int)u16_at(end + 10);
    if (m->count > MAX_ITEMS) return false;
    size_t at = u32_at(end + 16);
    for (int i = 0; i < m->count; i++) {
        const uint8_t *central = package.at + at;
        size_t name = u16_at(central + 28), header = u32_at(central + 42);
        const uint8_t *local = package.at + header;
        Item *item = &m->items[i];
        memcpy(item->name, central + CENTRAL_SIZE, name);
        item->size = u32_at(central + 24);
        item->data = malloc(MAX_ITEM);
        if (!item->data || item->size > MAX_ITEM) return false;
        memcpy(item->data, local + LOCAL_SIZE + name + u16_at(local + 28), item->size);
        sha256((Span){item->data, item->size}, item->digest);
        at += CENTRAL_SIZE + name;
    }
    return true;
}

/* Makes the manifest's size and SHA-256 of the item fit it again. */
static void declare(Item *manifest, const Item *item) {
    char digest[65], size[24];
    sha256((Span){item->data, item->size}, digest);
    for (size_t i = 64; i + 64 < manifest->size; i++) {
        if (memcmp(manifest->data + i, item->digest, 64)) continue;
        memcpy(manifest->data + i, digest, 64);
        while (i > 8 && memcmp(manifest->data + i, "\"size\": ", 8)) i--;
        size_t start = i + 8, digits = 0;
        while (start + digits < manifest->size && manifest->data[start + digits] >= '0' &&
               manifest->data[start + digits] <= '9')
            digits++;
        snprintf(size, sizeof size, "%zu", item->size);
        splice(manifest, start, digits, size, strlen(size));
        return;
    }
}

static void put_u16(Output *out, unsigned value) {
    uint8_t bytes[2] = {(uint8_t)value, (uint8_t)(value >> 8)};
    put_bytes(out, bytes, 2);
}

static void put_u32(Output *out, size_t value) {
    put_u16(out, (unsigned)value & 0xffff);
    put_u16(out, (unsigned)(value >> 16) & 0xffff);
}

/* What local and central header have in common, from the version on. */
static void put_header(Output *out, const Item *item, uint32_t crc, unsigned extra) {
    put_u16(out, 20);
    put_u32(out, 0);
    put_u16(out, 0);
    put_u16(out, 0x0021);
    put_u32(out, crc);
    put_u32(out, item->size);
    put_u32(out, item->size);
    put_u16(out, (unsigned)strlen(item->name));
    put_u16(out, extra);
}

static void assemble(Mutator *m, Output *out, bool wrong_crc) {
    size_t offsets[MAX_ITEMS];
    uint32_t crcs[MAX_ITEMS];
    for (int i = 0; i < m->count; i++) {
        const Item *item = &m->items[i];
        unsigned extra = (unsigned)(-(out->size + LOCAL_SIZE + strlen(item->name)) % ALIGNMENT);
        extra += extra && extra < 4 ? ALIGNMENT : 0;
        crcs[i] = crc32((Span){item->data, item->size}) ^ (wrong_crc && i == m->count - 1);
        offsets[i] = out->size;
        put_u32(out, 0x04034B50);
        put_header(out, item, crcs[i], extra);
        put_bytes(out, item->name, strlen(item->name));
        if (extra) {
            uint8_t padding[2 * ALIGNMENT] = {0};
            put_u16(out, PADDING_ID);
            put_u16(out, extra - 4);
            put_bytes(out, padding, extra - 4);
        }
        put_bytes(out, item->data, item->size);
    }
    size_t directory = out->size;
    for (int i = 0; i < m->count; i++) {
        uint8_t zeros[12] = {0};
        put_u32(out, 0x02014B50);
        put_u16(out, 20);
        put_header(out, &m->items[i], crcs[i], 0);
        put_bytes(out, zeros, 10);
        put_u32(out, offsets[i]);
        put_bytes(out, m->items[i].name, strlen(m->items[i].name));
    }
    size_t size = out->size - directory;
    put_u32(out, 0x06054B50);
    put_u32(out, 0);
    put_u16(out, (unsigned)m->count);
    put_u16(out, (unsigned)m->count);
    put_u32(out, size);
    put_u32(out, directory);
    put_u16(out, 0);
}

/* Changes a header, the directory, or any bytes of the whole. */
static void mutate_container(Mutator *m, Item *whole) {
    size_t directory = u32_at(whole->data + whole->size - 6);
    switch (below(m, 4)) {
    case 0: mutate_bytes(m, whole, 0, 64); break;
    case 1: mutate_bytes(m, whole, directory, whole->size); break;
    case 2: mutate_bytes(m, whole, whole->size - END_SIZE, whole->size); break;
    default: mutate_bytes(m, whole, 0, whole->size);
    }
    if (below(m, 16) == 0) whole->size = below(m, whole->size);
}

size_t rna_mutate(const uint8_t *package, size_t size, uint64_t seed, uint8_t *out, size_t room) {
    Mutator m = {.state = seed * 0x2545f4914f6cdd1du + 1};
    Output whole = {out, 0, room};
    size_t repair = 0;
    if (take_apart(&m, (Span){package, size}) && m.count > 1) {
        repair = below(&m, 24);
        if (repair > 3 || below(&m, 2)) {
            Item *item = &m.items[below(&m, 3) ? 1 + below(&m, (size_t)m.count - 1) : 0];
            for (size_t k = below(&m, 4) ? 1 : 1 + below(&m, 4); k; k--) mutate_item(&m, item);
            if (item != m.items && repair != 0) declare(&m.items[0], item);
        }
        assemble(&m, &whole, repair == 1);
    }
    if (repair == 2 || repair == 3) {
        Item bytes = {.data = out, .size = whole.size};
        if (room >= MAX_ITEM) mutate_container(&m, &bytes);
        whole.size = bytes.size;
    }
    for (int i = 0; i < m.count && i < MAX_ITEMS; i++) free(m.items[i].data);
    return whole.size;
}
