/* Images of base colour as files: their format and their size.  Their pixels are the host's matter. */
#ifndef RNA_IMAGES_H
#define RNA_IMAGES_H

#include "manifest_rules.h"
#include "report.h"

typedef struct ImageSize {
    uint32_t width, height; /* 0: not known */
} ImageSize;

static uint32_t big_u16_at(const uint8_t *at) { return (uint32_t)at[0] << 8 | at[1]; }
static uint32_t big_u32_at(const uint8_t *at) { return big_u16_at(at) << 16 | big_u16_at(at + 2); }

static ImageSize png_size(Span file) {
    static const char START[] = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR";
    if (file.size < 26 || memcmp(file.at, START, 16)) return (ImageSize){0};
    return (ImageSize){big_u32_at(file.at + 16), big_u32_at(file.at + 20)};
}

/* Of the first frame header, of one or three components.  Bytes before a marker are passed over, as
   decoders do. */
static ImageSize jpeg_size(Span file) {
    size_t at = 2;
    if (file.size < 4 || file.at[0] != 0xff || file.at[1] != 0xd8) return (ImageSize){0};
    while (at + 10 <= file.size) {
        const uint8_t marker = file.at[at + 1];
        if (file.at[at] != 0xff || marker == 0xff || marker == 0) {
            at++;
        } else if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) {
            const uint8_t components = file.at[at + 9];
            if (components != 1 && components != 3) return (ImageSize){0};
            return (ImageSize){big_u16_at(file.at + at + 7), big_u16_at(file.at + at + 5)};
        } else {
            at += 2 + (size_t)big_u16_at(file.at + at + 2);
        }
    }
    return (ImageSize){0};
}

/* Of the first chunk: lossy, lossless, or extended. */
static ImageSize webp_size(Span file) {
    if (file.size < 30 || memcmp(file.at, "RIFF", 4) || memcmp(file.at + 8, "WEBP", 4)) return (ImageSize){0};
    const uint8_t *chunk = file.at + 12, *data = file.at + 20;
    if (memcmp(chunk, "VP8 ", 4) == 0 && memcmp(data + 3, "\x9d\x01\x2a", 3) == 0)
        return (ImageSize){u16_at(data + 6) & 0x3fff, u16_at(data + 8) & 0x3fff};
    if (memcmp(chunk, "VP8L", 4) == 0 && data[0] == 0x2f) {
        const uint32_t bits = u32_at(data + 1);
        return (ImageSize){(bits & 0x3fff) + 1, (bits >> 14 & 0x3fff) + 1};
    }
    if (memcmp(chunk, "VP8X", 4) == 0)
        return (ImageSize){(u16_at(data + 4) | (uint32_t)data[6] << 16) + 1,
                           (u16_at(data + 7) | (uint32_t)data[9] << 16) + 1};
    return (ImageSize){0};
}

/* Reads the size of an image; false where its format is not known, or it is too large. */
static bool read_image_size(Span file, const char *entry, ImageSize *size, RnaReport *report) {
    ImageSize (*const formats[])(Span) = {png_size, jpeg_size, webp_size};
    *size = (ImageSize){0};
    for (int i = 0; i < 3 && !size->width; i++) *size = formats[i](file);
    return (size->width >= 1 && size->height >= 1 && size->width <= MAX_TEXTURE && size->height <= MAX_TEXTURE) ||
           refuse(report, "BASE_COLOR_IMAGE", entry, "a PNG, JPEG or WebP of 1 to 8192 pixels a side", "%u x %u",
                  (unsigned)size->width, (unsigned)size->height);
}

#endif
