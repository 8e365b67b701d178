/* The C host as a reader program of the conformance kit: `rna-conform -- ./conform`.
 *
 *     conform levels
 *     conform evaluate PACKAGE TIER QUERIES RESULTS
 *     conform visibility PACKAGE HITS PICKS
 *     conform validate PACKAGE
 *
 * Files are little-endian, without headers; spec/conformance/README.md describes them. */
#include "rna.h"
#include "trace.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { QUERY_FLOATS = 13, RESULT_FLOATS = 6, HIT_BYTES = 32 };

static int fails(const char *what, const char *which) {
    fprintf(stderr, "conform: %s: %s\n", which, what);
    return 2;
}

/* The bytes of a file, for the caller to free; NULL where it cannot be read. */
static void *read_file(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    if (!file) return NULL;
    long end = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    rewind(file);
    *size = end > 0 ? (size_t)end : 0;
    void *data = end >= 0 ? malloc(*size + 1) : NULL;
    if (data && fread(data, 1, *size, file) != *size) {
        free(data);
        data = NULL;
    }
    fclose(file);
    return data;
}

static bool write_file(const char *path, const void *data, size_t size) {
    FILE *file = fopen(path, "wb");
    if (!file) return false;
    bool good = fwrite(data, 1, size, file) == size;
    return fclose(file) == 0 && good;
}

static RnaAsset *open_or_tell(const char *path) {
    RnaReport report;
    RnaAsset *asset = rna_open(path, &report);
    for (int i = 0; !asset && i < report.count; i++) {
        const RnaIssue *issue = &report.issues[i];
        fprintf(stderr, "conform: %s: %s at %s: found %s; expected %s\n", path, issue->code, issue->where,
                issue->found, issue->expected);
    }
    return asset;
}

/* rows: [n, 13]; results: [n, 6], written. */
static RnaStatus evaluate_rows(const RnaAsset *asset, int tier, size_t n, const float *rows, float *results) {
    float *arrays = malloc((n + 1) * 19 * sizeof *arrays);
    if (!arrays) return RNA_OUT_OF_MEMORY;
    float *positions = arrays, *axes = positions + 3 * n, *h = axes + 3 * n, *wo = h + n, *wi = wo + 3 * n;
    float *visible = wi + 3 * n, *shadowed = visible + 3 * n;
    for (size_t i = 0; i < n; i++, rows += QUERY_FLOATS) {
        memcpy(positions + 3 * i, rows, 3 * sizeof *rows);
        memcpy(axes + 3 * i, rows + 3, 3 * sizeof *rows);
        h[i] = rows[6];
        memcpy(wo + 3 * i, rows + 7, 3 * sizeof *rows);
        memcpy(wi + 3 * i, rows + 10, 3 * sizeof *rows);
    }
    RnaStatus status = rna_evaluate(asset, tier, 0, n, positions, axes, h, wo, wi, visible, shadowed);
    for (size_t i = 0; i < n; i++, results += RESULT_FLOATS) {
        memcpy(results, visible + 3 * i, 3 * sizeof *results);
        memcpy(results + 3, shadowed + 3 * i, 3 * sizeof *results);
    }
    free(arrays);
    return status;
}

static int evaluate(const RnaAsset *asset, const char *tier, const char *queries, const char *out) {
    int index = rna_tier_index(asset, tier);
    if (index < 0) return fails("no such tier", tier);
    size_t size;
    float *rows = read_file(queries, &size);
    if (!rows || size % (QUERY_FLOATS * sizeof *rows)) {
        free(rows);
        return fails("not float32 [n, 13]", queries);
    }
    size_t n = size / (QUERY_FLOATS * sizeof *rows);
    float *results = calloc(n + 1, RESULT_FLOATS * sizeof *results);
    RnaStatus status = results ? evaluate_rows(asset, index, n, rows, results) : RNA_OUT_OF_MEMORY;
    bool written = status == RNA_OK && write_file(out, results, n * RESULT_FLOATS * sizeof *results);
    free(results);
    free(rows);
    if (status != RNA_OK) return fails(rna_status_text(status), tier);
    return written ? 0 : fails("cannot be written", out);
}

static void load_vector(const unsigned char *bytes, double v[3]) {
    float values[3];
    memcpy(values, bytes, sizeof values);
    for (int k = 0; k < 3; k++) v[k] = values[k];
}

/* 0 visible, 1 shadowed, for a hit record. */
static unsigned char pick(const Tracer *tracer, bool is_fiber, uint32_t primitive,
                          const unsigned char *record) {
    double wi[3], position[3], v[3];
    if (is_fiber) {
        load_vector(record + 4, position);
        load_vector(record + 16, wi);
        trace_visible_on_fiber(tracer, 0, primitive, position, wi, v);
        return v[0] == 0;
    }
    float b[2];
    memcpy(b, record + 4, sizeof b);
    load_vector(record + 12, wi);
    trace_visible_on_mesh(tracer, 0, primitive, b[0], b[1], wi, v);
    return v[0] == 0;
}

static int visibility(const RnaAsset *asset, const char *hits, const char *out) {
    size_t size;
    unsigned char *records = read_file(hits, &size), *picks = records ? malloc(size / HIT_BYTES + 1) : NULL;
    Tracer *tracer = trace_new(asset);
    const char *problem = !records || size % HIT_BYTES ? "not records of 32 bytes" : NULL;
    if (!problem && (!tracer || !picks)) problem = "out of memory";
    for (size_t i = 0; !problem && i < size / HIT_BYTES; i++) {
        uint32_t primitive;
        memcpy(&primitive, records + HIT_BYTES * i, sizeof primitive);
        if (primitive >= trace_primitive_count(tracer, 0))
            problem = "a triangle or segment that is not there";
        else
            picks[i] = pick(tracer, rna_part(asset, 0)->kind == RNA_FIBER, primitive, records + HIT_BYTES * i);
    }
    if (!problem && !write_file(out, picks, size / HIT_BYTES)) problem = "the picks cannot be written";
    trace_free(tracer);
    free(records);
    free(picks);
    return problem ? fails(problem, hits) : 0;
}

static int validate(const char *path) {
    RnaReport report;
    rna_close(rna_open(path, &report));
    for (int i = 0; i < report.count; i++) printf("%s\n", report.issues[i].code);
    return report.errors > 0;
}

int main(int argc, char **argv) {
    const char *level = argc > 1 ? argv[1] : "";
    if (argc == 2 && strcmp(level, "levels") == 0) return puts("evaluate\nvisibility\nvalidate") < 0;
    if (argc == 3 && strcmp(level, "validate") == 0) return validate(argv[2]);
    bool evaluates = argc == 6 && strcmp(level, "evaluate") == 0;
    if (!evaluates && !(argc == 5 && strcmp(level, "visibility") == 0)) {
        fputs("usage: conform levels | evaluate PACKAGE TIER QUERIES RESULTS |\n"
              "       visibility PACKAGE HITS PICKS | validate PACKAGE\n", stderr);
        return 2;
    }
    RnaAsset *asset = open_or_tell(argv[2]);
    if (!asset) return 2;
    int status = evaluates ? evaluate(asset, argv[3], argv[4], argv[5]) : visibility(asset, argv[3], argv[4]);
    rna_close(asset);
    return status;
}
