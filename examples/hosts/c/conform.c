/* The C host as a reader program of the conformance kit: `rna-conform -- ./conform`.
 *
 *     conform levels
 *     conform evaluate PACKAGE TIER PART QUERIES RESULTS
 *     conform emission PACKAGE TIER PART QUERIES RESULTS
 *     conform nearby PACKAGE TIER PART QUERIES RESULTS
 *     conform visibility PACKAGE HITS RESULTS
 *     conform normals PACKAGE HITS RESULTS
 *     conform base-color PACKAGE HITS RESULTS
 *     conform geometry PACKAGE PART RESULTS
 *     conform deformed PACKAGE PART SHAPE HITS RESULTS
 *     conform validate PACKAGE
 *
 * Files are little-endian, without headers; spec/conformance/README.md describes them. */
#include "png.h"
#include "rna.h"
#include "trace.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { HIT_BYTES = 32 };

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

/* Decoder forms: transport takes 16 numbers a row, with nearby light 19, and gives 6, emission takes 10 and gives 3. */
typedef struct Question {
    const RnaAsset *asset;
    int tier, part;
    bool emission, nearby;
    size_t columns, results;
} Question;

/* rows: [n, columns]; results: [n, results], written. */
static RnaStatus answer_rows(const Question *question, size_t n, const float *rows, float *results) {
    float *arrays = malloc((n + 1) * 25 * sizeof *arrays);
    if (!arrays) return RNA_OUT_OF_MEMORY;
    float *positions = arrays, *axes = positions + 3 * n, *h = axes + 3 * n, *wo = h + n, *wi = wo + 3 * n;
    float *base_colors = wi + 3 * n, *colours[2] = {wi + 6 * n, wi + 9 * n}, *nearby = wi + 12 * n;
    for (size_t i = 0; i < n; i++, rows += question->columns) {
        memcpy(positions + 3 * i, rows, 3 * sizeof *rows);
        memcpy(axes + 3 * i, rows + 3, 3 * sizeof *rows);
        h[i] = rows[6];
        memcpy(wo + 3 * i, rows + 7, 3 * sizeof *rows);
        if (question->emission) continue;
        memcpy(wi + 3 * i, rows + 10, 3 * sizeof *rows);
        memcpy(base_colors + 3 * i, rows + 13, 3 * sizeof *rows);
        if (question->nearby) memcpy(nearby + 3 * i, rows + 16, 3 * sizeof *rows);
    }
    const RnaAsset *asset = question->asset;
    const int tier = question->tier, part = question->part;
    RnaStatus status = question->emission
                           ? rna_emission(asset, tier, part, n, positions, axes, h, wo, colours[0])
                           : rna_evaluate_nearby(asset, tier, part, n, positions, axes, h, wo, wi, base_colors,
                                                 question->nearby ? nearby : NULL, colours[0], colours[1]);
    for (size_t i = 0; i < n * question->results; i++)
        results[i] = colours[i % question->results / 3][i / question->results * 3 + i % 3];
    free(arrays);
    return status;
}

static int answer(Question question, const char *tier, const char *part, const char *queries, const char *out) {
    char *end;
    question.tier = rna_tier_index(question.asset, tier);
    question.part = (int)strtol(part, &end, 10);
    if (question.tier < 0) return fails("no such tier", tier);
    if (*end || end == part || !rna_part(question.asset, question.part)) return fails("no such part", part);
    size_t size, row = question.columns * sizeof(float);
    float *rows = read_file(queries, &size);
    if (!rows || size % row) {
        free(rows);
        return fails("not whole rows of float32", queries);
    }
    size_t n = size / row;
    float *results = calloc(n + 1, question.results * sizeof *results);
    RnaStatus status = results ? answer_rows(&question, n, rows, results) : RNA_OUT_OF_MEMORY;
    bool written = status == RNA_OK && write_file(out, results, n * question.results * sizeof *results);
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

/* The three numbers of a hit record; false where there is no such triangle or segment. */
typedef bool Ask(const RnaAsset *asset, const Tracer *tracer, const unsigned char *record, float result[3]);

static uint32_t word_at(const unsigned char *bytes) {
    uint32_t word;
    memcpy(&word, bytes, sizeof word);
    return word;
}

/* The part of a record; NULL where it has no such triangle or segment. */
static const RnaPart *part_of(const RnaAsset *asset, const Tracer *tracer, const unsigned char *record) {
    const uint32_t number = word_at(record + 28);
    if (number >= RNA_MAX_PARTS || word_at(record) >= trace_primitive_count(tracer, (int)number)) return NULL;
    return rna_part(asset, (int)number);
}

/* The visibility v, RGB (section 7.1). */
static bool ask_visibility(const RnaAsset *asset, const Tracer *tracer, const unsigned char *record,
                           float result[3]) {
    const RnaPart *part = part_of(asset, tracer, record);
    const uint32_t primitive = word_at(record);
    const int number = (int)word_at(record + 28);
    double wi[3], place[3], v[3];
    if (!part) return false;
    load_vector(record + 4, place);
    load_vector(record + (part->mesh ? 12 : 16), wi);
    if (part->mesh)
        trace_visible_on_mesh(tracer, number, primitive, place[0], place[1], wi, v);
    else
        trace_visible_on_fiber(tracer, number, primitive, place, wi, v);
    for (int k = 0; k < 3; k++) result[k] = (float)v[k];
    return true;
}

/* The mapped normal (section 4.5). */
static bool ask_normal(const RnaAsset *asset, const Tracer *tracer, const unsigned char *record,
                       float result[3]) {
    const RnaPart *part = part_of(asset, tracer, record);
    double b[3];
    if (!part || !part->mesh) return false;
    load_vector(record + 4, b);
    rna_normal(asset, (int)word_at(record + 28), word_at(record), b[0], b[1], result);
    return true;
}

/* The base colour (section 4.6). */
static bool ask_base_color(const RnaAsset *asset, const Tracer *tracer, const unsigned char *record,
                           float result[3]) {
    const RnaPart *part = part_of(asset, tracer, record);
    double place[3]; /* b1, b2, level */
    if (!part || !part->mesh) return false;
    load_vector(record + 4, place);
    rna_base_color(asset, (int)word_at(record + 28), word_at(record), place[0], place[1], place[2], result);
    return true;
}

static int answer_hits(const RnaAsset *asset, Ask *ask, const char *hits, const char *out) {
    size_t size;
    unsigned char *records = read_file(hits, &size);
    const size_t n = records ? size / HIT_BYTES : 0;
    float *results = malloc((n + 1) * 3 * sizeof *results);
    Tracer *tracer = trace_new(asset);
    const char *problem = !records || size % HIT_BYTES ? "not records of 32 bytes" : NULL;
    if (!problem && (!tracer || !results)) problem = "out of memory";
    for (size_t i = 0; !problem && i < n; i++)
        if (!ask(asset, tracer, records + HIT_BYTES * i, results + 3 * i))
            problem = "a triangle or segment that is not there";
    if (!problem && !write_file(out, results, n * 3 * sizeof *results)) problem = "results cannot be written";
    trace_free(tracer);
    free(records);
    free(results);
    return problem ? fails(problem, hits) : 0;
}

/* A row for each vertex, of 8 numbers, or point, of 4. */
static int answer_geometry(const RnaPart *part, const char *out) {
    const RnaMesh *mesh = part->mesh;
    const size_t n = mesh ? mesh->vertex_count : part->curves->point_count, columns = mesh ? 8 : 4;
    float *rows = calloc(n + 1, columns * sizeof *rows);
    for (size_t i = 0; rows && i < n; i++) {
        float *row = rows + columns * i;
        memcpy(row, (mesh ? mesh->positions : part->curves->points) + 3 * i, 3 * sizeof *row);
        if (mesh) memcpy(row + 3, mesh->normals + 3 * i, 3 * sizeof *row);
        if (mesh && mesh->uvs) memcpy(row + 6, mesh->uvs + 2 * i, 2 * sizeof *row);
        if (!mesh) row[3] = part->curves->radii[i];
    }
    const bool good = rows && write_file(out, rows, n * columns * sizeof *rows);
    free(rows);
    return good ? 0 : fails("results cannot be written", out);
}

/* The rest points of the records of hits, n x 15. */
static const char *rest_points(const RnaShape *shape, bool is_mesh, size_t n, const unsigned char *records,
                               float *results) {
    for (size_t i = 0; i < n; i++, records += HIT_BYTES) {
        float place[2], normal[3];
        RnaRest rest;
        memcpy(place, records + 4, sizeof place);
        memcpy(normal, records + 8, sizeof normal);
        const double b[2] = {place[0], is_mesh ? place[1] : 0};
        if (!rna_rest_point(shape, word_at(records), b, normal, &rest))
            return "a triangle or segment that is not there";
        memcpy(results + 15 * i, rest.position, 3 * sizeof *results);
        memcpy(results + 15 * i + 3, rest.axis, 3 * sizeof *results);
        memcpy(results + 15 * i + 6, rest.rotation, 9 * sizeof *results);
    }
    return NULL;
}

static int answer_deformed(const RnaAsset *asset, int number, const char *positions, const char *hits,
                           const char *out) {
    const RnaPart *part = rna_part(asset, number);
    const size_t points = part->mesh ? part->mesh->vertex_count : part->curves->point_count;
    size_t size, hits_size;
    float *moved = read_file(positions, &size);
    unsigned char *records = read_file(hits, &hits_size);
    const size_t n = records ? hits_size / HIT_BYTES : 0;
    float *results = calloc(n + 1, 15 * sizeof *results);
    const bool right = moved && records && size == 12 * points && hits_size % HIT_BYTES == 0;
    RnaShape *shape = right ? rna_deform(asset, number, moved) : NULL;
    const char *problem = !right ? "not the points of the part, or not records of 32 bytes" : NULL;
    if (!problem && !(shape && results)) problem = "out of memory";
    if (!problem) problem = rest_points(shape, part->mesh, n, records, results);
    if (!problem && !write_file(out, results, n * 15 * sizeof *results)) problem = "results cannot be written";
    rna_free_shape(shape);
    free(moved);
    free(records);
    free(results);
    return problem ? fails(problem, hits) : 0;
}

/* geometry PACKAGE PART RESULTS, or deformed PACKAGE PART SHAPE HITS RESULTS */
static int answer_of_part(char **argv) {
    RnaAsset *asset = open_or_tell(argv[2]);
    char *end;
    const int number = (int)strtol(argv[3], &end, 10);
    const RnaPart *part = *end || end == argv[3] ? NULL : rna_part(asset, number);
    int status = 2;
    if (asset && !part) fails("no such part", argv[3]);
    if (part)
        status = argv[5] ? answer_deformed(asset, number, argv[4], argv[5], argv[6])
                         : answer_geometry(part, argv[4]);
    rna_close(asset);
    return status;
}

static int validate(const char *path) {
    RnaReport report;
    rna_close(rna_open(path, &report));
    for (int i = 0; i < report.count; i++) printf("%s\n", report.issues[i].code);
    return report.errors > 0;
}

int main(int argc, char **argv) {
    const char *level = argc > 1 ? argv[1] : "";
    if (argc == 2 && strcmp(level, "levels") == 0) return puts("evaluate\nnearby\nvisibility\nnormals\nbase-color\ngeometry\ndeformed\nvalidate") < 0;
    if (argc == 3 && strcmp(level, "validate") == 0) return validate(argv[2]);
    if ((argc == 5 && strcmp(level, "geometry") == 0) || (argc == 7 && strcmp(level, "deformed") == 0))
        return answer_of_part(argv);
    const bool evaluates = strcmp(level, "evaluate") == 0, emits = strcmp(level, "emission") == 0;
    const bool nearby = strcmp(level, "nearby") == 0;
    Ask *ask = argc != 5                          ? NULL
               : strcmp(level, "visibility") == 0 ? ask_visibility
               : strcmp(level, "normals") == 0    ? ask_normal
               : strcmp(level, "base-color") == 0 ? ask_base_color
                                                  : NULL;
    if (!ask && !(argc == 7 && (evaluates || emits || nearby))) {
        fputs("usage: conform levels | evaluate PACKAGE TIER PART QUERIES RESULTS |\n"
              "       emission PACKAGE TIER PART QUERIES RESULTS | nearby PACKAGE TIER PART QUERIES RESULTS |\n"
              "       visibility PACKAGE HITS RESULTS | normals PACKAGE HITS RESULTS |\n"
              "       base-color PACKAGE HITS RESULTS | geometry PACKAGE PART RESULTS |\n"
              "       deformed PACKAGE PART SHAPE HITS RESULTS | validate PACKAGE\n", stderr);
        return 2;
    }
    RnaAsset *asset = open_or_tell(argv[2]);
    if (!asset) return 2;
    if (ask == ask_base_color && !png_set_images(asset, "conform")) {
        rna_close(asset);
        return 2;
    }
    Question question = {asset, .emission = emits, .nearby = nearby, .results = emits ? 3 : 6};
    question.columns = emits ? 10 : nearby ? 19 : 16;
    int status = ask ? answer_hits(asset, ask, argv[3], argv[4])
                     : answer(question, argv[3], argv[4], argv[5], argv[6]);
    rna_close(asset);
    return status;
}
