/* Renders an asset under one directional light: rays of its own, transport of the C host.
 *
 *     render ASSET.rna OUT.ppm [WIDTH HEIGHT [SAMPLES]]
 *
 * The camera and the light are those of examples/quickstart/scene.yaml for a surface, and of
 * examples/fibers/scene.yaml for fibers; without its other lights.  An asset is asked in batches: all
 * hits of a line of the picture at once. */
#include "rna.h"
#include "trace.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct View {
    double position[3], look_at[3], vertical_fov_deg; /* +Y is up */
    double wi[3], irradiance[3];                      /* of the light */
} View;

static const View QUICKSTART = {
    {1.42, 0.80, 0.78}, {0.38, 0.17, -0.16}, 26, {0.55, 0.75, 0.65}, {2.5, 2.35, 2.1}};
static const View FIBERS = {{0.75, 0.45, 1.1}, {0, 0, 0}, 32, {0.8, 0.55, 0.5}, {3.6, 3.4, 3.1}};

static void normalize(double v[3]) {
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int k = 0; k < 3; k++) v[k] /= length;
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* Directions through the picture: (x, y) from the top left corner, in pixels. */
typedef struct Camera {
    double origin[3], forward[3], right[3], up[3], scale, half_width, half_height;
} Camera;

static Camera place_camera(const View *view, int width, int height) {
    const double vertical[3] = {0, 1, 0};
    Camera camera = {.half_width = width / 2.0, .half_height = height / 2.0};
    memcpy(camera.origin, view->position, sizeof camera.origin);
    for (int k = 0; k < 3; k++) camera.forward[k] = view->look_at[k] - view->position[k];
    normalize(camera.forward);
    cross(camera.forward, vertical, camera.right);
    normalize(camera.right);
    cross(camera.right, camera.forward, camera.up);
    camera.scale = tan(view->vertical_fov_deg * 3.141592653589793 / 360) / camera.half_height;
    return camera;
}

static void ray_through(const Camera *camera, double x, double y, double direction[3]) {
    double right = (x - camera->half_width) * camera->scale, up = (camera->half_height - y) * camera->scale;
    for (int k = 0; k < 3; k++)
        direction[k] = camera->forward[k] + right * camera->right[k] + up * camera->up[k];
    normalize(direction);
}

/* Rows for rna_evaluate, one a hit. */
typedef struct Rows {
    size_t count;
    float *positions, *axes, *h, *wo, *wi, *visible, *shadowed;
    bool *seen;   /* whether the asset leaves the way to the light free */
    int *pixel;   /* column of the picture */
} Rows;

/* Notes a hit: what section 7 asks for, and the pick between the two colours. */
static void add_hit(const RnaAsset *asset, const Tracer *tracer, const View *view, const double direction[3],
                    const TraceHit *hit, int pixel, Rows *rows) {
    double x[3], axis[3], h = 0, across[3], wo[3];
    for (int k = 0; k < 3; k++) wo[k] = -direction[k];
    if (rna_kind(asset) == RNA_SURFACE) {
        trace_surface_point(rna_mesh(asset), hit->primitive, hit->b1, hit->b2, x, axis);
        rows->seen[rows->count] = trace_visible_on_mesh(tracer, hit->primitive, hit->b1, hit->b2, view->wi);
    } else {
        for (int k = 0; k < 3; k++) x[k] = view->position[k] + hit->t * direction[k];
        trace_tangent(tracer, hit->primitive, axis);
        cross(axis, wo, across);
        double width = sqrt(across[0] * across[0] + across[1] * across[1] + across[2] * across[2]);
        for (int k = 0; k < 3; k++) h += width > 1e-6 ? hit->n[k] * across[k] / width : 0;
        rows->seen[rows->count] = trace_visible_on_fiber(tracer, hit->primitive, x, view->wi);
    }
    for (size_t k = 0; k < 3; k++) {
        rows->positions[3 * rows->count + k] = (float)x[k];
        rows->axes[3 * rows->count + k] = (float)axis[k];
        rows->wo[3 * rows->count + k] = (float)wo[k];
        rows->wi[3 * rows->count + k] = (float)view->wi[k];
    }
    rows->h[rows->count] = (float)h;
    rows->pixel[rows->count++] = pixel;
}

/* One line of the picture: linear RGB, width x 3. */
static RnaStatus render_line(const RnaAsset *asset, const Tracer *tracer, const View *view,
                             const Camera *camera, int y, int width, int samples, Rows *rows,
                             float *line) {
    rows->count = 0;
    for (int x = 0; x < width; x++)
        for (int s = 0; s < samples * samples; s++) {
            double direction[3], dx = (s % samples + 0.5) / samples, dy = (s / samples + 0.5) / samples;
            TraceHit hit;
            ray_through(camera, x + dx, y + dy, direction);
            if (trace_closest(tracer, camera->origin, direction, &hit))
                add_hit(asset, tracer, view, direction, &hit, x, rows);
        }
    RnaStatus status = rna_evaluate(asset, 0, rows->count, rows->positions, rows->axes, rows->h, rows->wo,
                                    rows->wi, rows->visible, rows->shadowed);
    memset(line, 0, 3 * (size_t)width * sizeof *line);
    for (size_t i = 0; status == RNA_OK && i < rows->count; i++)
        for (size_t k = 0; k < 3; k++) {
            float transport = (rows->seen[i] ? rows->visible : rows->shadowed)[3 * i + k];
            line[3 * (size_t)rows->pixel[i] + k] +=
                (float)view->irradiance[k] * transport / (float)(samples * samples);
        }
    return status;
}

/* The sRGB transfer function (IEC 61966-2-1), in 8 bits. */
static unsigned char encoded(float linear) {
    double x = linear < 1 ? linear : 1;
    double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
    return (unsigned char)(srgb * 255 + 0.5);
}

static bool allocate(Rows *rows, size_t room) {
    float *block = calloc(room * 19 + 1, sizeof *block);
    rows->positions = block;
    if (!block) return false;
    rows->axes = block + 3 * room;
    rows->wo = block + 6 * room;
    rows->wi = block + 9 * room;
    rows->visible = block + 12 * room;
    rows->shadowed = block + 15 * room;
    rows->h = block + 18 * room;
    rows->seen = calloc(room + 1, sizeof *rows->seen);
    rows->pixel = calloc(room + 1, sizeof *rows->pixel);
    return rows->seen && rows->pixel;
}

static const char *render(const RnaAsset *asset, FILE *out, int width, int height, int samples) {
    View view = rna_kind(asset) == RNA_SURFACE ? QUICKSTART : FIBERS;
    Camera camera = place_camera(&view, width, height);
    Tracer *tracer = trace_new(asset);
    Rows rows = {0};
    float *line = malloc(3 * (size_t)width * sizeof *line);
    unsigned char *bytes = malloc(3 * (size_t)width);
    const char *problem = NULL;
    normalize(view.wi);
    if (!allocate(&rows, (size_t)(width * samples * samples)) || !tracer || !line || !bytes)
        problem = "out of memory";
    fprintf(out, "P6\n%d %d\n255\n", width, height);
    for (int y = 0; y < height && !problem; y++) {
        RnaStatus status = render_line(asset, tracer, &view, &camera, y, width, samples, &rows, line);
        if (status != RNA_OK) problem = rna_status_text(status);
        for (int i = 0; i < 3 * width; i++) bytes[i] = encoded(line[i]);
        fwrite(bytes, 3, (size_t)width, out);
    }
    trace_free(tracer);
    free(rows.positions);
    free(rows.seen);
    free(rows.pixel);
    free(line);
    free(bytes);
    return problem;
}

int main(int argc, char **argv) {
    int width = argc > 4 ? atoi(argv[3]) : 480, height = argc > 4 ? atoi(argv[4]) : 270;
    int samples = argc > 5 ? atoi(argv[5]) : 4; /* along each side of a pixel */
    if (argc < 3 || argc == 4 || width < 1 || width > 8192 || height < 1 || height > 8192 || samples < 1 ||
        samples > 64) {
        fputs("usage: render ASSET.rna OUT.ppm [WIDTH HEIGHT [SAMPLES]]\n", stderr);
        return 2;
    }
    RnaReport report;
    RnaAsset *asset = rna_open(argv[1], &report);
    for (int i = 0; !asset && i < report.count; i++) {
        const RnaIssue *issue = &report.issues[i];
        fprintf(stderr, "render: %s: %s at %s: found %s; expected %s\n", argv[1], issue->code, issue->where,
                issue->found, issue->expected);
    }
    if (!asset) return 1;
    FILE *out = fopen(argv[2], "wb");
    const char *problem = out ? render(asset, out, width, height, samples) : "cannot be written";
    if (out && (ferror(out) | fclose(out))) problem = "cannot be written";
    if (problem) fprintf(stderr, "render: %s: %s\n", argv[2], problem);
    rna_close(asset);
    return problem != NULL;
}
