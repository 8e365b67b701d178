/* The ZIP shape (section 2). */
#ifndef RNA_CONTAINER_H
#define RNA_CONTAINER_H

#include "hashes.h"
#include "rules.h"

typedef struct Entry {
    char name[MAX_NAME + 1];
    size_t header, data, size; /* offsets in the file; bytes */
    uint32_t crc;
    bool intact; /* as the manifest declares it */
#ifdef RNA_EXACT_ENTRIES
    uint8_t *copy; /* of the data alone */
#endif
} Entry;

typedef struct Container {
    Span file;
    Entry entries[MAX_ENTRIES];
    int count;
} Container;

enum { LOCAL_SIZE = 30, CENTRAL_SIZE = 46, END_SIZE = 22, PADDING_ID = 0x4E52 };

#ifdef RNA_EXACT_ENTRIES
/* For sanitizers: each entry in a block of just its size, so that a read past its end, which would be
 * inside the file, is outside of memory.  The caller frees the copies after all that uses the data. */
static Span entry_data(const Container *zip, const Entry *entry) {
    Entry *writable = (Entry *)(uintptr_t)entry;
    void *block;
    if (!writable->copy) {
        if (posix_memalign(&block, ALIGNMENT, entry->size ? entry->size : 1)) abort();
        writable->copy = memcpy(block, zip->file.at + entry->data, entry->size);
    }
    return (Span){writable->copy, entry->size};
}
#else
static Span entry_data(const Container *zip, const Entry *entry) {
    return (Span){zip->file.at + entry->data, entry->size};
}
#endif

static Entry *find_entry(Container *zip, Span name) {
    for (int i = 0; i < zip->count; i++)
        if (span_is(name, zip->entries[i].name)) return &zip->entries[i];
    return NULL;
}

static bool same_name(const char *a, const char *b) {
    for (; *a && *b; a++, b++) {
        int x = *a >= 'A' && *a <= 'Z' ? *a + 32 : *a, y = *b >= 'A' && *b <= 'Z' ? *b + 32 : *b;
        if (x != y) return false;
    }
    return *a == *b;
}

/* The central header at *offset, and *offset behind it; `end`: of the directory. */
static bool read_central(Container *zip, size_t *offset, size_t end, RnaReport *report) {
    const uint8_t *at = zip->file.at + *offset;
    Place where = byte_place(*offset);
    if (end - *offset < CENTRAL_SIZE)
        return refuse(report, "ZIP_DIRECTORY", where.text, "a central header", "one cut short");
    size_t name_size = u16_at(at + 28);
    if (u32_at(at) != 0x02014B50 || u16_at(at + 30) || u16_at(at + 32))
        return refuse(report, "ZIP_DIRECTORY", where.text, "a central header, nothing behind its name",
                      "signature %08x", (unsigned)u32_at(at));
    if (u32_at(at + 20) == UINT32_MAX || u32_at(at + 24) == UINT32_MAX || u32_at(at + 42) == UINT32_MAX)
        return refuse(report, "ZIP_ZIP64", where.text, "sizes and offsets below 4 GiB", "more");
    if (u16_at(at + 8) & 1)
        return refuse(report, "ZIP_ENCRYPTED", where.text, "flags 0", "flags %u", (unsigned)u16_at(at + 8));
    bool fixed = u16_at(at + 4) == 20 && u16_at(at + 6) == 20 && u16_at(at + 8) == 0 &&
                 u16_at(at + 12) == 0 && u16_at(at + 14) == 0x0021 && u16_at(at + 34) == 0 &&
                 u16_at(at + 36) == 0 && u32_at(at + 38) == 0;
    if (!fixed)
        return refuse(report, "ZIP_HEADER", where.text, "the fixed versions, flags, times, attributes",
                      "others");
    if (u16_at(at + 10))
        return refuse(report, "ZIP_COMPRESSED", where.text, "method 0 (stored)", "method %u",
                      (unsigned)u16_at(at + 10));
    if (u32_at(at + 20) != u32_at(at + 24))
        return refuse(report, "ZIP_SIZE", where.text, "equal sizes", "%u and %u",
                      (unsigned)u32_at(at + 20), (unsigned)u32_at(at + 24));
    if (end - *offset - CENTRAL_SIZE < name_size)
        return refuse(report, "ZIP_DIRECTORY", where.text, "a name inside the directory", "%zu bytes",
                      name_size);
    Span name = {at + CENTRAL_SIZE, name_size};
    if (!is_path(name))
        return refuse(report, "ZIP_NAME", where.text, "a relative path, at most 200 bytes", "%.*s",
                      (int)name_size, (const char *)name.at);
    Entry *entry = &zip->entries[zip->count];
    *entry = (Entry){.header = u32_at(at + 42), .size = u32_at(at + 24), .crc = u32_at(at + 16)};
    memcpy(entry->name, name.at, name.size);
    entry->data = *offset; /* of the central header, until the local one was read */
    for (int i = 0; i < zip->count; i++)
        if (same_name(entry->name, zip->entries[i].name))
            return refuse(report, "ZIP_DUPLICATE", where.text, "each name once", "%s", entry->name);
    zip->count++;
    *offset += CENTRAL_SIZE + name_size;
    return true;
}

/* Finds the entry's data, once the local header agrees with the central one. */
static bool read_local(const Container *zip, Entry *entry, size_t directory, RnaReport *report) {
    const uint8_t *central = zip->file.at + entry->data, *at = zip->file.at + entry->header;
    Place where = byte_place(entry->header);
    if (entry->header + LOCAL_SIZE > directory)
        return refuse(report, "ZIP_TRUNCATED", where.text, "a local header", "one cut short");
    size_t extra_size = u16_at(at + 28), extra_offset = entry->header + LOCAL_SIZE + u16_at(at + 26);
    const uint8_t *extra = zip->file.at + extra_offset;
    entry->data = extra_offset + extra_size;
    if (entry->data + entry->size > directory)
        return refuse(report, "ZIP_TRUNCATED", where.text, "data that ends before the directory",
                      "%zu bytes at %zu", entry->size, entry->data);
    bool same = u32_at(at) == 0x04034B50 && memcmp(at + 4, central + 6, 24) == 0 &&
                memcmp(at + LOCAL_SIZE, entry->name, u16_at(at + 26)) == 0;
    if (!same)
        return refuse(report, "ZIP_LOCAL_HEADER", where.text, "the central header's values", "others");
    bool zero = extra_size == 0 || (extra_size >= 4 && u16_at(extra) == PADDING_ID &&
                                    u16_at(extra + 2) == extra_size - 4);
    for (size_t i = 4; i < extra_size; i++) zero &= extra[i] == 0;
    if (!zero)
        return refuse(report, "ZIP_EXTRA", byte_place(extra_offset).text, "the padding field, zeros",
                      "%zu other bytes", extra_size);
    if (entry->data % ALIGNMENT)
        return refuse(report, "ZIP_ALIGNMENT", byte_place(entry->data).text, "a multiple of 64", "%s",
                      entry->name);
    if (strcmp(entry->name, "manifest.json") == 0 && entry->size > MAX_MANIFEST)
        return refuse(report, "MANIFEST_TOO_LARGE", where.text, "at most 1 MiB", "%zu bytes",
                      entry->size);
    return true;
}

static int compare_headers(const void *a, const void *b) {
    size_t x = ((const Entry *)a)->header, y = ((const Entry *)b)->header;
    return (x > y) - (x < y);
}

/* Entries follow each other with no overlap and no gap, the manifest first. */
static bool check_layout(Container *zip, size_t directory, RnaReport *report) {
    qsort(zip->entries, (size_t)zip->count, sizeof *zip->entries, compare_headers);
    size_t behind = 0;
    for (int i = 0; i <= zip->count; i++) {
        const Entry *entry = &zip->entries[i];
        size_t start = i < zip->count ? entry->header : directory;
        const char *name = i < zip->count ? entry->name : "the directory";
        if (start < behind)
            return refuse(report, "ZIP_OVERLAP", byte_place(start).text, "no shared bytes", "%s", name);
        if (start > behind)
            return refuse(report, "ZIP_GAP", byte_place(behind).text, "no bytes left over",
                          "%zu before %s", start - behind, name);
        if (i < zip->count) behind = entry->data + entry->size;
    }
    if (zip->count == 0 || strcmp(zip->entries[0].name, "manifest.json"))
        return refuse(report, "ZIP_ORDER", "byte 0", "manifest.json", "%s",
                      zip->count ? zip->entries[0].name : "no entry");
    return true;
}

static bool read_container(Container *zip, RnaReport *report) {
    Span file = zip->file;
    if (file.size == 0) return refuse(report, "FILE_EMPTY", "byte 0", "a ZIP archive", "0 bytes");
    if (file.size > UINT32_MAX - 1)
        return refuse(report, "FILE_TOO_LARGE", "byte 0", "at most 2^32 - 2 bytes", "%zu", file.size);
    size_t end_offset = file.size < END_SIZE ? 0 : file.size - END_SIZE;
    const uint8_t *end = file.at + end_offset;
    Place where = byte_place(end_offset);
    if (file.size < END_SIZE || u32_at(end) != 0x06054B50) {
        bool starts_well = file.size >= 4 && u32_at(file.at) == 0x04034B50;
        return refuse(report, starts_well ? "ZIP_TRUNCATED" : "ZIP_NOT_ZIP", where.text,
                      "an end record as the last 22 bytes", "none");
    }
    uint32_t count = u16_at(end + 10), size = u32_at(end + 12), offset = u32_at(end + 16);
    if (count == 0xFFFF || u16_at(end + 4) || u16_at(end + 6))
        return refuse(report, "ZIP_ZIP64", where.text, "one disk, no ZIP64", "more");
    if (count > MAX_ENTRIES)
        return refuse(report, "ZIP_TOO_MANY", where.text, "at most 256", "%u", (unsigned)count);
    if ((uint64_t)offset + size != end_offset || u16_at(end + 20) || u16_at(end + 8) != count)
        return refuse(report, "ZIP_DIRECTORY", where.text, "a directory that ends here",
                      "%u bytes at %u", (unsigned)size, (unsigned)offset);
    size_t at = offset;
    for (uint32_t i = 0; i < count; i++)
        if (!read_central(zip, &at, end_offset, report)) return false;
    if (at != end_offset)
        return refuse(report, "ZIP_DIRECTORY", byte_place(at).text, "the end record", "%zu bytes more",
                      end_offset - at);
    for (int i = 0; i < zip->count; i++)
        if (!read_local(zip, &zip->entries[i], offset, report)) return false;
    return check_layout(zip, offset, report);
}

static bool check_crc(const Container *zip, const Entry *entry, RnaReport *report) {
    uint32_t crc = crc32(entry_data(zip, entry));
    return crc == entry->crc || refuse(report, "ZIP_CRC", byte_place(entry->data).text,
                                       "the CRC-32 of the header", "%s: %08x", entry->name, crc);
}

#endif
