#include "png.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------- Deflate (RFC 1951) */

typedef struct Stream {
    const uint8_t *at, *end;
    uint32_t bits;
    int count; /* of bits */
    bool bad;
    uint8_t *out;
    size_t filled, room;
} Stream;

static uint32_t take_bits(Stream *stream, int count) {
    while (stream->count < count) {
        if (stream->at == stream->end) {
            stream->bad = true;
            return 0;
        }
        stream->bits |= (uint32_t)*stream->at++ << stream->count;
        stream->count += 8;
    }
    uint32_t value = stream->bits & ((1u << count) - 1);
    stream->bits >>= count;
    stream->count -= count;
    return value;
}

static void put_byte(Stream *stream, uint8_t byte) {
    if (stream->filled == stream->room)
        stream->bad = true;
    else
        stream->out[stream->filled++] = byte;
}

/* A canonical Huffman code: how many symbols there are of each length, and the symbols in order. */
typedef struct Code {
    uint16_t counts[16], symbols[288];
} Code;

static void make_code(Code *code, const uint8_t *lengths, int n) {
    uint16_t next[16] = {0};
    memset(code, 0, sizeof *code);
    for (int i = 0; i < n; i++) code->counts[lengths[i]]++;
    code->counts[0] = 0;
    for (int k = 1; k < 15; k++) next[k + 1] = (uint16_t)(next[k] + code->counts[k]);
    for (int i = 0; i < n; i++)
        if (lengths[i]) code->symbols[next[lengths[i]]++] = (uint16_t)i;
}

static int take_symbol(Stream *stream, const Code *code) {
    int value = 0, first = 0, index = 0;
    for (int length = 1; length < 16 && !stream->bad; length++) {
        value |= (int)take_bits(stream, 1);
        int count = code->counts[length];
        if (value - count < first) return code->symbols[index + value - first];
        index += count;
        first = (first + count) << 1;
        value <<= 1;
    }
    stream->bad = true;
    return 0;
}

static void stored_block(Stream *stream) {
    stream->bits = 0;
    stream->count = 0;
    uint32_t size = take_bits(stream, 16), check = take_bits(stream, 16);
    if ((size ^ check) != 0xffff) stream->bad = true;
    while (size-- && !stream->bad) put_byte(stream, (uint8_t)take_bits(stream, 8));
}

static void fixed_codes(Code *literals, Code *distances) {
    uint8_t lengths[288];
    for (int i = 0; i < 288; i++) lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
    make_code(literals, lengths, 288);
    memset(lengths, 5, 30);
    make_code(distances, lengths, 30);
}

static void take_codes(Stream *stream, Code *literals, Code *distances) {
    static const uint8_t ORDER[19] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    uint8_t lengths[320] = {0};
    const int n = (int)take_bits(stream, 5) + 257, m = (int)take_bits(stream, 5) + 1;
    const int k = (int)take_bits(stream, 4) + 4;
    for (int i = 0; i < k; i++) lengths[ORDER[i]] = (uint8_t)take_bits(stream, 3);
    make_code(literals, lengths, 19);
    memset(lengths, 0, sizeof lengths);
    for (int i = 0; i < n + m && !stream->bad;) {
        const int symbol = take_symbol(stream, literals);
        if (symbol < 16) {
            lengths[i++] = (uint8_t)symbol;
            continue;
        }
        const uint8_t again = symbol == 16 && i ? lengths[i - 1] : 0;
        int times = symbol == 16 ? 3 + (int)take_bits(stream, 2)
                    : symbol == 17 ? 3 + (int)take_bits(stream, 3)
                                   : 11 + (int)take_bits(stream, 7);
        if ((symbol == 16 && i == 0) || i + times > n + m) stream->bad = true;
        while (times-- && !stream->bad) lengths[i++] = again;
    }
    make_code(literals, lengths, n < 288 ? n : 288);
    make_code(distances, lengths + n, m);
}

static void copy_match(Stream *stream, int symbol, const Code *distances) {
    static const uint16_t BASE[29] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                      31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
    static const uint8_t EXTRA[29] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    if (symbol > 285) {
        stream->bad = true;
        return;
    }
    size_t length = BASE[symbol - 257] + take_bits(stream, EXTRA[symbol - 257]);
    const int code = take_symbol(stream, distances), extra = code < 4 ? 0 : code / 2 - 1;
    if (code > 29) stream->bad = true;
    size_t distance = code < 4 ? (size_t)code + 1 : 1 + ((size_t)(2 + (code & 1)) << extra) + take_bits(stream, extra);
    if (distance > stream->filled) stream->bad = true;
    while (length-- && !stream->bad) put_byte(stream, stream->out[stream->filled - distance]);
}

/* Fills `room` bytes of out; false where the stream gives other than so many. */
static bool inflate(const uint8_t *data, size_t size, uint8_t *out, size_t room) {
    Stream stream = {.at = data, .end = data + size, .out = out, .room = room};
    Code literals, distances;
    for (bool last = false; !last && !stream.bad;) {
        last = take_bits(&stream, 1);
        const uint32_t kind = take_bits(&stream, 2);
        if (kind == 0) {
            stored_block(&stream);
            continue;
        }
        if (kind == 1) fixed_codes(&literals, &distances);
        if (kind == 2) take_codes(&stream, &literals, &distances);
        if (kind == 3) stream.bad = true;
        for (int symbol = 0; symbol != 256 && !stream.bad;) {
            symbol = take_symbol(&stream, &literals);
            if (symbol < 256) put_byte(&stream, (uint8_t)symbol);
            if (symbol > 256) copy_match(&stream, symbol, &distances);
        }
    }
    return !stream.bad && stream.filled == room;
}

/* -------------------------------------------------------- PNG (ISO/IEC 15948) */

typedef struct Header {
    uint32_t width, height;
    int bits, channels;
    bool has_palette, interlaced;
} Header;

/* Pixels of an image that are stored together: from column x and row y on, each dx-th and dy-th. */
typedef struct Pass {
    uint32_t x, y, dx, dy;
} Pass;

static const Pass WHOLE[1] = {{0, 0, 1, 1}};
static const Pass ADAM7[7] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};

static uint32_t count_of(uint32_t size, uint32_t first, uint32_t step) {
    return size > first ? (size - first + step - 1) / step : 0;
}

/* Of a row of a pass, without the one that names its filter. */
static size_t row_bytes(const Header *header, const Pass *pass) {
    return ((size_t)count_of(header->width, pass->x, pass->dx) * (size_t)(header->bits * header->channels) + 7) / 8;
}

static size_t pass_bytes(const Header *header, const Pass *pass) {
    const size_t row = row_bytes(header, pass);
    return row ? (row + 1) * count_of(header->height, pass->y, pass->dy) : 0;
}

static uint32_t big_u32(const uint8_t *at) {
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

static bool take_header(const uint8_t *data, Header *header) {
    static const int CHANNELS[7] = {1, 0, 3, 1, 2, 0, 4};
    const uint8_t bits = data[8], type = data[9];
    *header = (Header){big_u32(data), big_u32(data + 4), bits, type < 7 ? CHANNELS[type] : 0, type == 3, data[12] == 1};
    const bool narrow = bits == 1 || bits == 2 || bits == 4;
    return header->channels && (bits == 8 || (bits == 16 && type != 3) || (narrow && header->channels == 1)) &&
           data[12] < 2;
}

static uint8_t paeth(int a, int b, int c) {
    const int p = a + b - c, x = abs(p - a), y = abs(p - b), z = abs(p - c);
    return (uint8_t)(x <= y && x <= z ? a : y <= z ? b : c);
}

/* Undoes the filters of rows of `width` bytes, each behind a byte that says which. */
static bool unfilter(uint8_t *rows, size_t width, uint32_t height, size_t step) {
    for (uint32_t j = 0; j < height; j++) {
        uint8_t *row = rows + j * (width + 1) + 1, *above = j ? row - (width + 1) : NULL;
        const uint8_t filter = row[-1];
        if (filter > 4) return false;
        for (size_t i = 0; i < width; i++) {
            const int a = i >= step ? row[i - step] : 0, b = above ? above[i] : 0;
            const int c = above && i >= step ? above[i - step] : 0;
            const int of[5] = {0, a, b, (a + b) / 2, paeth(a, b, c)};
            row[i] = (uint8_t)(row[i] + of[filter]);
        }
    }
    return true;
}

/* A sample of a row, in 8 bits; of a palette its number. */
static uint8_t sample(const uint8_t *row, const Header *header, size_t i) {
    if (header->bits == 16) return row[2 * i];
    if (header->bits == 8) return row[i];
    const size_t bit = i * (size_t)header->bits;
    const int most = (1 << header->bits) - 1, value = row[bit / 8] >> (8 - header->bits - (int)(bit % 8)) & most;
    return (uint8_t)(header->has_palette ? value : value * 255 / most);
}

/* Puts the colours of a pass, whose filters are undone, into the image. */
static void put_colours(const uint8_t *rows, const Pass *pass, const Header *header, const uint8_t palette[768], uint8_t *rgb) {
    const size_t width = row_bytes(header, pass);
    for (uint32_t y = pass->y; y < header->height; y += pass->dy, rows += width + 1)
        for (uint32_t x = pass->x, i = 0; x < header->width; x += pass->dx, i++)
            for (size_t c = 0; c < 3; c++) {
                const size_t channel = header->channels > 2 ? c : 0;
                const uint8_t value = sample(rows + 1, header, i * (size_t)header->channels + channel);
                rgb[3 * ((size_t)y * header->width + x) + c] = header->has_palette ? palette[3 * value + c] : value;
            }
}

static bool put_passes(uint8_t *rows, const Pass *passes, int count, const Header *header, const uint8_t palette[768],
                       uint8_t *rgb) {
    const size_t pixel = (size_t)(header->bits * header->channels);
    for (int k = 0; k < count; k++) {
        const size_t size = pass_bytes(header, &passes[k]), row = row_bytes(header, &passes[k]);
        if (!size) continue;
        if (!unfilter(rows, row, (uint32_t)(size / (row + 1)), pixel < 8 ? 1 : pixel / 8)) return false;
        put_colours(rows, &passes[k], header, palette, rgb);
        rows += size;
    }
    return true;
}

/* Gathers the data of all IDAT chunks in `data`, of the file's size; returns how much it is, 0 for a bad file. */
static size_t take_chunks(const uint8_t *file, size_t size, Header *header, uint8_t palette[768], uint8_t *data) {
    size_t filled = 0;
    bool known = false;
    for (size_t at = 8; at + 12 <= size;) {
        const size_t length = big_u32(file + at);
        const uint8_t *name = file + at + 4, *chunk = file + at + 8;
        if (length > size - at - 12) return 0;
        if (memcmp(name, "IHDR", 4) == 0 && !(known = length == 13 && take_header(chunk, header))) return 0;
        if (memcmp(name, "PLTE", 4) == 0) memcpy(palette, chunk, length < 768 ? length : 768);
        if (memcmp(name, "IDAT", 4) == 0) {
            memcpy(data + filled, chunk, length);
            filled += length;
        }
        at += 12 + length;
    }
    return known && filled > 2 ? filled : 0;
}

uint8_t *png_pixels(const uint8_t *file, size_t size, uint32_t width, uint32_t height) {
    uint8_t palette[768] = {0}, *rgb = NULL, *rows = NULL;
    Header header = {0};
    if (size < 8 || memcmp(file, "\x89PNG\r\n\x1a\n", 8)) return NULL;
    uint8_t *data = malloc(size);
    const size_t filled = data ? take_chunks(file, size, &header, palette, data) : 0;
    if (filled && header.width == width && header.height == height) {
        const Pass *passes = header.interlaced ? ADAM7 : WHOLE;
        const int count = header.interlaced ? 7 : 1;
        size_t total = 0;
        for (int k = 0; k < count; k++) total += pass_bytes(&header, &passes[k]);
        rows = malloc(total);
        rgb = malloc(3 * (size_t)width * height);
        if (!rows || !rgb || !inflate(data + 2, filled - 2, rows, total) ||
            !put_passes(rows, passes, count, &header, palette, rgb)) {
            free(rgb);
            rgb = NULL;
        }
    }
    free(data);
    free(rows);
    return rgb;
}

bool png_set_images(RnaAsset *asset, const char *program) {
    bool good = true;
    for (int part = 0; part < rna_part_count(asset); part++)
        for (int i = 0; i < rna_part(asset, part)->base_color_count; i++) {
            const RnaBaseColor *record = &rna_part(asset, part)->base_colors[i];
            if (!record->file) continue;
            uint8_t *rgb = png_pixels(record->file, record->file_size, record->width, record->height);
            const RnaStatus status = rgb ? rna_set_image(asset, part, i, rgb) : RNA_BAD_ARGUMENT;
            if (status != RNA_OK)
                fprintf(stderr, "%s: image %d of part %d cannot be decoded; this program knows PNG alone\n", program, i,
                        part);
            good &= status == RNA_OK;
            free(rgb);
        }
    return good;
}
