/* Packages through the C host: nothing may go wrong, and answers stay finite.
 *
 *     c_host < MUTATIONS
 *
 * Reads packages, each behind its size in four bytes, and writes a line for each: the codes of all
 * its issues.  Built under AddressSanitizer and UBSan, which end the program at what they find. */
#include "png.h"
#include "rna.h"
#include "trace.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 50, RAYS = 8, MOST_BYTES = 1 << 18 };

static void stop(const char *what) {
    fprintf(stderr, "%s\n", what);
    abort();
}

/* Numbers of all kinds: inside the bounds and far outside, zero, NaN, infinite. */
static float odd_number(unsigned i) {
    static const float NUMBERS[] = {0.3f,  -0.7f, 1,     0,         -1,       0.6f,  -0.2f, 1e-3f,
                                    1e30f, 1e-40f, NAN, INFINITY, -3.4e38f, 0.99f, -0.4f, 2.5f};
    i = i * 2654435761u >> 16;
    return i % 5 ? NUMBERS[i % 8] : NUMBERS[i % 16];
}

/* Ends the program where one of n colours is not finite or below 0. */
static void check_colours(const float *colours, size_t n) {
    for (size_t i = 0; i < 3 * n; i++)
        if (!(isfinite(colours[i]) && colours[i] >= 0)) stop("a colour that is not finite and >= 0");
}

static void evaluate_part(const RnaAsset *asset, int tier, int part, unsigned seed) {
    float in[6][3 * POINTS], out[3][3 * POINTS];
    for (unsigned k = 0; k < 6; k++)
        for (unsigned i = 0; i < 3 * POINTS; i++) in[k][i] = odd_number(seed + 1000 * k + i);
    RnaStatus status = rna_evaluate(asset, tier, part, POINTS, in[0], in[1], in[2], in[3], in[4], in[5], out[0],
                                    out[1]);
    RnaStatus emitted = rna_emission(asset, tier, part, POINTS, in[0], in[1], in[2], in[3], out[2]);
    if (status != RNA_OK) stop(rna_status_text(status));
    if (emitted != RNA_OK) stop(rna_status_text(emitted));
    check_colours(out[0], 2 * POINTS);
    check_colours(out[2], POINTS);
}

/* Rays about a point of the part. */
static void trace_part(const RnaAsset *asset, const Tracer *tracer, int part, unsigned seed) {
    for (unsigned i = 0; i < RAYS; i++) {
        double wi[3] = {i % 3 - 1.0, i % 2 - 0.4, i / 7.0}, position[3] = {0.1, i / 9.0, -0.2}, v[3];
        float tau[3], normal[3], color[3], direction[3] = {odd_number(i), odd_number(i + 100), odd_number(i + 200)};
        uint32_t primitive = (seed + i) % trace_primitive_count(tracer, part);
        TraceHit hit, behind;
        if (rna_part(asset, part)->mesh)
            trace_visible_on_mesh(tracer, part, primitive, 0.3, 0.2, wi, v);
        else
            trace_visible_on_fiber(tracer, part, primitive, position, wi, v);
        rna_transmittance(asset, part, primitive, odd_number(i + 300), 0.2, direction, tau);
        rna_normal(asset, part, primitive, odd_number(i + 300), 0.2, normal);
        rna_base_color(asset, part, primitive, 0.3, 0.2, odd_number(i + 400), color);
        if (!(rna_texel_density(asset, part, primitive) >= 0)) stop("a density below 0");
        for (int k = 0; k < 3; k++)
            if (!(v[k] >= 0 && v[k] <= 1 && tau[k] >= 0 && tau[k] <= 1 && color[k] >= 0 && color[k] <= 1.0001f))
                stop("not from 0 to 1");
        if (trace_closest(tracer, position, wi, NULL, &hit) &&
            trace_closest(tracer, position, wi, &hit, &behind) && !(behind.t >= hit.t))
            stop("hits out of order");
    }
}

/* Gives images the pixels of their files, or grey ones where they cannot be decoded; few, for the time. */
static void set_images(RnaAsset *asset) {
    for (int part = 0; part < rna_part_count(asset); part++)
        for (int i = 0; i < rna_part(asset, part)->base_color_count; i++) {
            const RnaBaseColor *record = &rna_part(asset, part)->base_colors[i];
            const size_t size = 3 * (size_t)record->width * record->height;
            if (!record->file || size > MOST_BYTES) continue;
            uint8_t *rgb = png_pixels(record->file, record->file_size, record->width, record->height);
            if (!rgb && (rgb = malloc(size))) memset(rgb, 100, size);
            if (rgb && rna_set_image(asset, part, i, rgb) != RNA_OK) stop("an image that cannot be set");
            free(rgb);
        }
}

/* Asks everything of the asset. */
static void use(RnaAsset *asset, unsigned seed) {
    Tracer *tracer = trace_new(asset);
    if (!tracer) stop("no memory for the tracer");
    set_images(asset);
    for (int part = 0; part < rna_part_count(asset); part++) {
        for (int tier = 0; tier < rna_tier_count(asset); tier++) evaluate_part(asset, tier, part, seed);
        trace_part(asset, tracer, part, seed);
    }
    trace_free(tracer);
}

/* seed: of what the asset is asked. */
static void try_package(const unsigned char *bytes, size_t size, unsigned seed) {
    RnaReport report;
    RnaAsset *asset = rna_open_memory(bytes, size, &report);
    if ((asset == NULL) != (report.errors > 0)) stop("verdict and report differ");
    if (asset) use(asset, seed);
    for (int i = 0; i < report.count; i++) printf("%s ", report.issues[i].code);
    printf("\n");
    fflush(stdout);
    rna_close(asset);
}

int main(void) {
    unsigned char head[4];
    for (unsigned seed = 0; fread(head, 4, 1, stdin) == 1; seed++) {
        size_t size = head[0] | head[1] << 8 | head[2] << 16 | (size_t)head[3] << 24;
        size_t room = (size + 63) / 64 * 64 + 64;
        unsigned char *block = aligned_alloc(64, room); /* of its own, so that reads past its end are noticed */
        if (!block) stop("no memory");
        unsigned char *bytes = block + (room - size) / 64 * 64; /* as near to the end as 64 allows */
        if (fread(bytes, 1, size, stdin) != size) stop("a mutation that is cut");
        try_package(bytes, size, seed);
        free(block);
    }
    return 0;
}
