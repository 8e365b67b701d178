/* Damaged packages through the C host: nothing may go wrong, and answers stay finite.
 *
 *     fuzz FIRST COUNT PACKAGE... [--verdicts FILE]
 *
 * Mutation FIRST, FIRST + 1, ... of PACKAGE number (seed mod packages).  Prints JSON: how many were
 * accepted, and the first error of the others.  FILE: a line "SEED CODE..." for each, all its codes.
 * Build it under AddressSanitizer and UBSan (make fuzz), which end the program at what they find. */
#include "mutate.h"
#include "rna.h"
#include "trace.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM = 1 << 21, MAX_PACKAGES = 64, MAX_CODES = 128, POINTS = 50, RAYS = 8 };

typedef struct Package {
    unsigned char *data;
    size_t size;
} Package;

typedef struct Tally {
    unsigned long accepted, evaluated;
    const char *codes[MAX_CODES];
    unsigned long refused[MAX_CODES];
} Tally;

static void stop(const char *what, unsigned long long seed) {
    fprintf(stderr, "fuzz: seed %llu: %s\n", seed, what);
    abort();
}

static Package read_package(const char *path) {
    Package package = {NULL, 0};
    FILE *file = fopen(path, "rb");
    package.data = file ? malloc(ROOM) : NULL;
    package.size = package.data ? fread(package.data, 1, ROOM, file) : 0;
    if (file) fclose(file);
    if (package.size == 0) {
        fprintf(stderr, "fuzz: %s cannot be read\n", path);
        exit(2);
    }
    return package;
}

/* Numbers of all kinds: inside the bounds and far outside, zero, NaN, infinite. */
static float odd_number(unsigned i) {
    static const float NUMBERS[] = {0.3f,  -0.7f, 1,     0,         -1,       0.6f,  -0.2f, 1e-3f,
                                    1e30f, 1e-40f, NAN, INFINITY, -3.4e38f, 0.99f, -0.4f, 2.5f};
    i = i * 2654435761u >> 16;
    return i % 5 ? NUMBERS[i % 8] : NUMBERS[i % 16];
}

/* Ends the program where one of n colours is not finite or below 0. */
static void check_colours(const float *colours, size_t n, unsigned long long seed) {
    for (size_t i = 0; i < 3 * n; i++)
        if (!(isfinite(colours[i]) && colours[i] >= 0)) stop("a colour that is not finite and >= 0", seed);
}

static void evaluate_part(const RnaAsset *asset, int tier, int part, Tally *tally, unsigned long long seed) {
    float in[5][3 * POINTS], out[3][3 * POINTS];
    for (unsigned k = 0; k < 5; k++)
        for (unsigned i = 0; i < 3 * POINTS; i++) in[k][i] = odd_number((unsigned)seed + 1000 * k + i);
    RnaStatus status = rna_evaluate(asset, tier, part, POINTS, in[0], in[1], in[2], in[3], in[4], out[0],
                                    out[1]);
    RnaStatus emitted = rna_emission(asset, tier, part, POINTS, in[0], in[1], in[2], in[3], out[2]);
    tally->evaluated += status == RNA_OK;
    if (status != RNA_OK) stop(rna_status_text(status), seed);
    if (emitted != RNA_OK) stop(rna_status_text(emitted), seed);
    check_colours(out[0], 2 * POINTS, seed);
    check_colours(out[2], POINTS, seed);
}

/* Rays about a point of the part. */
static void trace_part(const RnaAsset *asset, const Tracer *tracer, int part, unsigned long long seed) {
    for (unsigned i = 0; i < RAYS; i++) {
        double wi[3] = {i % 3 - 1.0, i % 2 - 0.4, i / 7.0}, position[3] = {0.1, i / 9.0, -0.2}, v[3];
        float tau[3], normal[3], direction[3] = {odd_number(i), odd_number(i + 100), odd_number(i + 200)};
        uint32_t primitive = (uint32_t)(seed + i) % trace_primitive_count(tracer, part);
        TraceHit hit, behind;
        if (rna_part(asset, part)->mesh)
            trace_visible_on_mesh(tracer, part, primitive, 0.3, 0.2, wi, v);
        else
            trace_visible_on_fiber(tracer, part, primitive, position, wi, v);
        rna_transmittance(asset, part, primitive, odd_number(i + 300), 0.2, direction, tau);
        rna_normal(asset, part, primitive, odd_number(i + 300), 0.2, normal);
        for (int k = 0; k < 3; k++)
            if (!(v[k] >= 0 && v[k] <= 1 && tau[k] >= 0 && tau[k] <= 1)) stop("not from 0 to 1", seed);
        if (trace_closest(tracer, position, wi, NULL, &hit) &&
            trace_closest(tracer, position, wi, &hit, &behind) && !(behind.t >= hit.t))
            stop("hits out of order", seed);
    }
}

/* Asks everything of the asset. */
static void use(const RnaAsset *asset, Tally *tally, unsigned long long seed) {
    Tracer *tracer = trace_new(asset);
    if (!tracer) stop("no memory for the tracer", seed);
    for (int part = 0; part < rna_part_count(asset); part++) {
        for (int tier = 0; tier < rna_tier_count(asset); tier++) evaluate_part(asset, tier, part, tally, seed);
        trace_part(asset, tracer, part, seed);
    }
    trace_free(tracer);
}

static void count_refusal(Tally *tally, const RnaReport *report) {
    const char *code = "none";
    for (int i = report->count; i-- > 0;)
        if (report->issues[i].is_error) code = report->issues[i].code;
    int k = 0;
    while (tally->codes[k] && strcmp(tally->codes[k], code)) k++;
    tally->codes[k] = code;
    tally->refused[k]++;
}

static void try_mutation(const Package *package, unsigned long long seed, unsigned char *buffer, Tally *tally,
                         FILE *verdicts) {
    size_t size = rna_mutate(package->data, package->size, seed, buffer, ROOM);
    /* A block of its own, of just this size, so that reads past its end are noticed. */
    unsigned char *data = aligned_alloc(64, (size + 63) / 64 * 64 + 64);
    if (!data) stop("no memory", seed);
    data += ((size + 63) / 64 * 64 + 64 - size) / 64 * 64; /* as near to the end as 64 allows */
    memcpy(data, buffer, size);
    RnaReport report;
    RnaAsset *asset = rna_open_memory(data, size, &report);
    if ((asset == NULL) != (report.errors > 0)) stop("verdict and report differ", seed);
    if (asset) {
        tally->accepted++;
        use(asset, tally, seed);
    } else {
        count_refusal(tally, &report);
    }
    if (verdicts) {
        fprintf(verdicts, "%llu", seed);
        for (int i = 0; i < report.count; i++) fprintf(verdicts, " %s", report.issues[i].code);
        fprintf(verdicts, "\n");
    }
    rna_close(asset);
    free(data - ((size + 63) / 64 * 64 + 64 - size) / 64 * 64);
}

int main(int argc, char **argv) {
    Package packages[MAX_PACKAGES];
    int count = 0;
    FILE *verdicts = NULL;
    if (argc > 3 && strcmp(argv[argc - 2], "--verdicts") == 0) {
        verdicts = fopen(argv[argc - 1], "w");
        argc -= 2;
    }
    for (int i = 3; i < argc && count < MAX_PACKAGES; i++) packages[count++] = read_package(argv[i]);
    if (count == 0) {
        fputs("usage: fuzz FIRST COUNT PACKAGE... [--verdicts FILE]\n", stderr);
        return 2;
    }
    unsigned long long first = strtoull(argv[1], NULL, 10), last = first + strtoull(argv[2], NULL, 10);
    unsigned char *buffer = malloc(ROOM);
    Tally tally = {0};
    for (unsigned long long seed = first; buffer && seed < last; seed++)
        try_mutation(&packages[seed % (unsigned)count], seed, buffer, &tally, verdicts);
    printf("{\"mutations\": %llu, \"accepted\": %lu, \"evaluated\": %lu, \"refused\": {",
           last - first, tally.accepted, tally.evaluated);
    for (int k = 0; tally.codes[k]; k++)
        printf("%s\"%s\": %lu", k ? ", " : "", tally.codes[k], tally.refused[k]);
    printf("}}\n");
    if (verdicts) fclose(verdicts);
    free(buffer);
    for (int i = 0; i < count; i++) free(packages[i].data);
    return 0;
}
