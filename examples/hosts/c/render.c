/* Renders an asset under one sun: rays of its own, transport and emission of the C host.
 *
 *     render ASSET.rna OUT.ppm [OPTION VALUES]...
 *
 *     --size WIDTH HEIGHT      480 270
 *     --samples N              rays along each side of a pixel; 4
 *     --tier NAME              the first
 *     --camera X Y Z X Y Z FOV position, point looked at, vertical field of view in degrees; +Y is up
 *     --sun X Y Z R G B        direction to it and irradiance
 *     --glow FACTOR            of the asset's own light; 1
 *
 * The default camera has the whole asset in view.  Options have the meaning of the same words in
 * scenes of rna-run.  Parts are evaluated in batches: hits are kept until there are many. */
#include "png.h"
#include "rna.h"
#include "rna/vectors.h"
#include "trace.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 2048, MAX_LAYERS = 256 };

typedef struct View {
    int width, height, samples, tier;
    double camera[7], sun[6], glow;
} View;

/* -------------------------------------------------------------------- Camera */

/* A camera that has the bounds of all parts in view. */
static void look_at_asset(const RnaAsset *asset, double camera[7]) {
    static const double FROM[3] = {0.66, 0.37, 0.66}, FOV = 30;
    double low[3], high[3], square = 0;
    for (int i = 0; i < rna_part_count(asset); i++)
        for (int k = 0; k < 3; k++) {
            const RnaPart *part = rna_part(asset, i);
            low[k] = i ? fmin(low[k], part->low[k]) : part->low[k];
            high[k] = i ? fmax(high[k], part->high[k]) : part->high[k];
        }
    for (int k = 0; k < 3; k++) square += (high[k] - low[k]) * (high[k] - low[k]) / 4;
    double distance = sqrt(square) / sin(FOV * 3.141592653589793 / 360);
    for (int k = 0; k < 3; k++) {
        camera[3 + k] = (low[k] + high[k]) / 2;
        camera[k] = camera[3 + k] + distance * FROM[k];
    }
    camera[6] = FOV;
}

/* Directions through the picture: (x, y) from the top left corner, in pixels. */
typedef struct Camera {
    double forward[3], right[3], up[3], scale, half_width, half_height;
} Camera;

static Camera place_camera(const View *view) {
    const double vertical[3] = {0, 1, 0};
    Camera camera = {.half_width = view->width / 2.0, .half_height = view->height / 2.0};
    for (int k = 0; k < 3; k++) camera.forward[k] = view->camera[3 + k] - view->camera[k];
    normalize(camera.forward);
    cross(camera.forward, vertical, camera.right);
    normalize(camera.right);
    cross(camera.right, camera.forward, camera.up);
    camera.scale = tan(view->camera[6] * 3.141592653589793 / 360) / camera.half_height;
    return camera;
}

static void ray_through(const Camera *camera, double x, double y, double direction[3]) {
    double right = (x - camera->half_width) * camera->scale, up = (camera->half_height - y) * camera->scale;
    for (int k = 0; k < 3; k++)
        direction[k] = camera->forward[k] + right * camera->right[k] + up * camera->up[k];
    normalize(direction);
}

/* ---------------------------------------------------------------------- Hits */

/* Hits of a part, as rna_evaluate and rna_emission take them. */
typedef struct Rows {
    size_t count;
    float positions[3 * ROWS], axes[3 * ROWS], h[ROWS], wo[3 * ROWS], wi[3 * ROWS], base_colors[3 * ROWS];
    float visible[3 * ROWS], shadowed[3 * ROWS], emission[3 * ROWS]; /* results */
    float v[3 * ROWS];     /* visibility of the sun */
    float share[3 * ROWS]; /* of the hit in its pixel */
    float *pixel[ROWS];    /* three linear colours */
} Rows;

typedef struct Renderer {
    const RnaAsset *asset;
    const Tracer *tracer;
    const View *view;
    Camera camera;
    Rows *rows; /* one a part */
} Renderer;

/* Asks for the colours of the hits of a part, and adds them to their pixels. */
static RnaStatus shade(Renderer *renderer, int part) {
    const View *view = renderer->view;
    Rows *rows = &renderer->rows[part];
    RnaStatus status = rna_evaluate(renderer->asset, view->tier, part, rows->count, rows->positions, rows->axes,
                                    rows->h, rows->wo, rows->wi, rows->base_colors, rows->visible,
                                    rows->shadowed);
    if (status == RNA_OK)
        status = rna_emission(renderer->asset, view->tier, part, rows->count, rows->positions, rows->axes,
                              rows->h, rows->wo, rows->emission);
    for (size_t i = 0; status == RNA_OK && i < 3 * rows->count; i++) {
        double v = rows->v[i], transport = v * rows->visible[i] + (1 - v) * rows->shadowed[i];
        double light = view->sun[3 + i % 3] * transport + view->glow * rows->emission[i];
        rows->pixel[i / 3][i % 3] += (float)(rows->share[i] * light);
    }
    rows->count = 0;
    return status;
}

/* The rule of section 7 for a hit of the ray towards `direction`. */
static void describe_hit(const Renderer *renderer, const TraceHit *hit, const double direction[3],
                         double x[3], double axis[3], double *h, double v[3]) {
    const RnaMesh *mesh = rna_part(renderer->asset, hit->part)->mesh;
    const double *sun = renderer->view->sun;
    *h = 0;
    if (mesh) {
        float normal[3];
        trace_surface_point(mesh, hit->primitive, hit->b1, hit->b2, x, axis);
        rna_normal(renderer->asset, hit->part, hit->primitive, hit->b1, hit->b2, normal);
        for (int k = 0; k < 3; k++) axis[k] = normal[k];
        trace_visible_on_mesh(renderer->tracer, hit->part, hit->primitive, hit->b1, hit->b2, sun, v);
        return;
    }
    double wo[3], across[3];
    for (int k = 0; k < 3; k++) {
        wo[k] = -direction[k];
        x[k] = renderer->view->camera[k] + hit->t * direction[k];
    }
    trace_tangent(renderer->tracer, hit->part, hit->primitive, axis);
    cross(axis, wo, across);
    double width = sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
    for (int k = 0; k < 3; k++) *h += width > 1e-6 ? hit->n[k] * across[k] / width : 0;
    trace_visible_on_fiber(renderer->tracer, hit->part, hit->primitive, x, sun, v);
}

/* The base colour of a hit, over the part of the surface that a ray of this picture stands for. */
static void color_hit(const Renderer *renderer, const TraceHit *hit, float a[3]) {
    const double density = rna_texel_density(renderer->asset, hit->part, hit->primitive);
    const double width = hit->t * renderer->camera.scale / renderer->view->samples;
    rna_base_color(renderer->asset, hit->part, hit->primitive, hit->b1, hit->b2,
                   log2(fmax(width * density, 1)), a);
}

/* Notes a hit that has `share` of its pixel. */
static RnaStatus add_hit(Renderer *renderer, const TraceHit *hit, const double direction[3],
                         const double share[3], float *pixel) {
    Rows *rows = &renderer->rows[hit->part];
    double x[3], axis[3], h, v[3];
    describe_hit(renderer, hit, direction, x, axis, &h, v);
    color_hit(renderer, hit, rows->base_colors + 3 * rows->count);
    for (size_t k = 0; k < 3; k++) {
        size_t i = 3 * rows->count + k;
        rows->positions[i] = (float)x[k];
        rows->axes[i] = (float)axis[k];
        rows->wo[i] = (float)-direction[k];
        rows->wi[i] = (float)renderer->view->sun[k];
        rows->v[i] = (float)v[k];
        rows->share[i] = (float)share[k];
    }
    rows->h[rows->count] = (float)h;
    rows->pixel[rows->count++] = pixel;
    return rows->count == ROWS ? shade(renderer, hit->part) : RNA_OK;
}

/* All hits of a camera ray: through holes and glass it goes on behind them (section 4.4). */
static RnaStatus trace_ray(Renderer *renderer, const double direction[3], double weight, float *pixel) {
    const float d[3] = {(float)direction[0], (float)direction[1], (float)direction[2]};
    double through[3] = {weight, weight, weight}, share[3];
    RnaStatus status = RNA_OK;
    TraceHit hit, before;
    for (int layer = 0; layer < MAX_LAYERS && status == RNA_OK; layer++, before = hit) {
        float tau[3];
        if (!trace_closest(renderer->tracer, renderer->view->camera, direction, layer ? &before : NULL, &hit))
            break;
        rna_transmittance(renderer->asset, hit.part, hit.primitive, hit.b1, hit.b2, d, tau);
        for (int k = 0; k < 3; k++) {
            share[k] = through[k] * (1 - (double)tau[k]);
            through[k] *= tau[k];
        }
        if (share[0] + share[1] + share[2] > 0) status = add_hit(renderer, &hit, direction, share, pixel);
        if (through[0] + through[1] + through[2] == 0) break;
    }
    return status;
}

/* Adds the light of the whole picture to `pixels`. */
static RnaStatus trace_picture(Renderer *renderer, float *pixels) {
    const View *view = renderer->view;
    const int n = view->samples;
    RnaStatus status = RNA_OK;
    for (int y = 0; y < view->height; y++)
        for (int x = 0; x < view->width; x++)
            for (int s = 0; s < n * n && status == RNA_OK; s++) {
                double direction[3], dx = (s % n + 0.5) / n, dy = (s / n + 0.5) / n;
                ray_through(&renderer->camera, x + dx, y + dy, direction);
                status = trace_ray(renderer, direction, 1.0 / (n * n),
                                   &pixels[3 * ((size_t)y * (size_t)view->width + (size_t)x)]);
            }
    for (int part = 0; part < rna_part_count(renderer->asset) && status == RNA_OK; part++)
        status = shade(renderer, part);
    return status;
}

/* ------------------------------------------------------------------- Picture */

/* The sRGB transfer function (IEC 61966-2-1), in 8 bits. */
static unsigned char encoded(float linear) {
    double x = linear < 1 ? linear : 1;
    double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
    return (unsigned char)(srgb * 255 + 0.5);
}

static bool write_picture(const char *path, const View *view, const float *pixels) {
    FILE *out = fopen(path, "wb");
    if (!out) return false;
    fprintf(out, "P6\n%d %d\n255\n", view->width, view->height);
    for (size_t i = 0; i < 3 * (size_t)view->width * (size_t)view->height; i++) putc(encoded(pixels[i]), out);
    return (ferror(out) | fclose(out)) == 0;
}

static const char *render(const RnaAsset *asset, const View *view, const char *path) {
    Tracer *tracer = trace_new(asset);
    float *pixels = calloc((size_t)view->width * (size_t)view->height, 3 * sizeof *pixels);
    Rows *rows = calloc((size_t)rna_part_count(asset), sizeof *rows);
    Renderer renderer = {asset, tracer, view, place_camera(view), rows};
    RnaStatus status = tracer && pixels && rows ? trace_picture(&renderer, pixels) : RNA_OUT_OF_MEMORY;
    const char *problem = status == RNA_OK ? NULL : rna_status_text(status);
    if (!problem && !write_picture(path, view, pixels)) problem = "cannot be written";
    trace_free(tracer);
    free(pixels);
    free(rows);
    return problem;
}

/* ------------------------------------------------------------------ Arguments */

static int usage(void) {
    fputs("usage: render ASSET.rna OUT.ppm [--size WIDTH HEIGHT] [--samples N] [--tier NAME]\n"
          "       [--camera X Y Z X Y Z FOV] [--sun X Y Z R G B] [--glow FACTOR]\n", stderr);
    return 2;
}

/* `count` numbers from argv[*at] on; false where they are not there. */
static bool take_numbers(int argc, char **argv, int *at, int count, double *numbers) {
    for (int i = 0; i < count; i++, ++*at) {
        char *end = NULL;
        if (*at >= argc) return false;
        numbers[i] = strtod(argv[*at], &end);
        if (end == argv[*at] || *end || !isfinite(numbers[i])) return false;
    }
    return true;
}

static bool take_options(int argc, char **argv, const RnaAsset *asset, View *view) {
    double size[2] = {480, 270}, samples = 4;
    for (int at = 3; at < argc;) {
        const char *option = argv[at++];
        bool good = strcmp(option, "--size") == 0      ? take_numbers(argc, argv, &at, 2, size)
                    : strcmp(option, "--samples") == 0 ? take_numbers(argc, argv, &at, 1, &samples)
                    : strcmp(option, "--camera") == 0  ? take_numbers(argc, argv, &at, 7, view->camera)
                    : strcmp(option, "--sun") == 0     ? take_numbers(argc, argv, &at, 6, view->sun)
                    : strcmp(option, "--glow") == 0    ? take_numbers(argc, argv, &at, 1, &view->glow)
                    : strcmp(option, "--tier") == 0 && at < argc
                        ? (view->tier = rna_tier_index(asset, argv[at++]), true)
                        : false;
        if (!good) return false;
    }
    if (!(size[0] >= 1 && size[0] <= 8192 && size[1] >= 1 && size[1] <= 8192 && samples >= 1 && samples <= 64))
        return false;
    view->width = (int)size[0];
    view->height = (int)size[1];
    view->samples = (int)samples;
    normalize(view->sun);
    return true;
}

int main(int argc, char **argv) {
    if (argc < 3) return usage();
    RnaReport report;
    RnaAsset *asset = rna_open(argv[1], &report);
    for (int i = 0; !asset && i < report.count; i++) {
        const RnaIssue *issue = &report.issues[i];
        fprintf(stderr, "render: %s: %s at %s: found %s; expected %s\n", argv[1], issue->code, issue->where,
                issue->found, issue->expected);
    }
    if (!asset) return 1;
    png_set_images(asset, "render"); /* those that cannot be decoded stay white */
    View view = {.sun = {0.6, 0.75, 0.55, 2.5, 2.35, 2.1}, .glow = 1};
    look_at_asset(asset, view.camera);
    const bool understood = take_options(argc, argv, asset, &view);
    const char *problem = !understood      ? NULL
                          : view.tier < 0 ? "the asset has no such tier"
                                          : render(asset, &view, argv[2]);
    if (problem) fprintf(stderr, "render: %s: %s\n", argv[2], problem);
    rna_close(asset);
    return understood ? problem != NULL : usage();
}
