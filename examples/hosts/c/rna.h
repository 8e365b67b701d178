/* RNA 2.0 packages in C: open, check, evaluate.  C11, the C library alone; rna.c is all to compile.
 *
 *     RnaReport report;
 *     RnaAsset *asset = rna_open("toy.rna", &report);
 *     if (!asset) { fprintf(stderr, "%s\n", report.issues[0].code); return 1; }
 *     rna_evaluate(asset, 0, 0, n, positions, normals, NULL, wo, wi, colors, visible, shadowed);
 *     rna_close(asset);
 *
 * An asset has one part or several, each a mesh or curves with planes and decoders of its own, and
 * tiers, choices of speed and accuracy; both are named by their numbers, from 0 on.
 *
 * Everything is in the asset's object space: right-handed, +Y up, metres.  Vectors are three floats
 * after each other.  Section numbers refer to spec/RNA.md.
 */
#ifndef RNA_H
#define RNA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One finding.  The codes are those of spec/ISSUES.md and never change their meaning. */
typedef struct RnaIssue {
    const char *code;
    bool is_error; /* a warning does not keep a package from being used */
    char where[128];
    char found[96];
    char expected[96];
} RnaIssue;

enum { RNA_MAX_ISSUES = 32, RNA_MAX_PARTS = 16 };

typedef struct RnaReport {
    int count;  /* of the issues below; what comes beyond RNA_MAX_ISSUES is left out */
    int errors; /* how many of them are errors */
    RnaIssue issues[RNA_MAX_ISSUES];
} RnaReport;

typedef enum RnaKind { RNA_SURFACE, RNA_FIBER } RnaKind;

typedef enum RnaStatus {
    RNA_OK,
    RNA_BAD_ARGUMENT, /* a NULL array, or no such tier, part or image */
    RNA_OUT_OF_MEMORY
} RnaStatus;

typedef struct RnaTier {
    const char *name;
    bool is_int8;         /* the arithmetic of the decoders, where all parts have the same */
    double multiply_adds; /* a query; int8 ones count half when tiers are compared.  Below 0: unknown */
    double flip;          /* mean error on images the training never saw.  Below 0: unknown */
    double psnr;          /* of the same images, dB.  NaN: unknown */
} RnaTier;

/* A mesh: `normals` are corner normals; interpolate them over the hit triangle and normalise. */
typedef struct RnaMesh {
    uint32_t vertex_count, triangle_count;
    const float *positions;    /* vertex_count x 3 */
    const float *normals;      /* vertex_count x 3, unit */
    const float *uvs;          /* vertex_count x 2, or NULL */
    const uint32_t *triangles; /* triangle_count x 3 */
} RnaMesh;

/* Strands of round cones: strand s has the points offsets[s] to offsets[s + 1] - 1. */
typedef struct RnaCurves {
    uint32_t point_count, strand_count;
    const float *points;     /* point_count x 3 */
    const float *radii;      /* point_count */
    const uint32_t *offsets; /* strand_count + 1 */
} RnaCurves;

/* Texels [height][width][channels]; row 0 at v = 0, linear. */
typedef struct RnaTexture {
    uint32_t width, height, channels;
    const uint8_t *texels;
} RnaTexture;

/* The light that goes straight through a range of triangles (section 4.4); rna_transmittance looks it up. */
typedef struct RnaTransmittance {
    uint32_t first, count; /* triangles */
    RnaTexture texture;    /* of 1 or 3 channels, over 255 */
    double cutoff;         /* above it 1, else 0; 0 where there is no cutoff */
    double ior[2];         /* Fresnel reflection, front and back; 0 where there is none */
} RnaTransmittance;

/* Relief of a range of triangles (section 4.5); rna_normal looks it up. */
typedef struct RnaNormalMap {
    uint32_t first, count; /* triangles */
    RnaTexture texture;    /* of 2 channels, 127 + 127 times x and y */
} RnaNormalMap;

/* The texels beyond the edges of an image. */
typedef enum RnaWrap { RNA_REPEAT, RNA_CLAMP, RNA_MIRROR } RnaWrap;

/* Base colour of a range of triangles (section 4.6); rna_base_color looks it up. */
typedef struct RnaBaseColor {
    uint32_t first, count;   /* triangles */
    const uint8_t *file;     /* the image as it is in the package, PNG, JPEG or WebP; NULL: white */
    size_t file_size;
    uint32_t width, height;  /* of the image */
    bool is_srgb;            /* its values, else linear */
    double factor[3];        /* linear RGB */
    RnaWrap wrap[2];         /* along u, along v */
    double transform[6];     /* a to f: the image is looked up at (a u + b v + c, d u + e v + f) */
} RnaBaseColor;

/* A geometry with planes and decoders of its own. */
typedef struct RnaPart {
    const char *name;
    RnaKind kind;
    float low[3], high[3];   /* the bounds: the box that the planes span */
    const RnaMesh *mesh;     /* of a surface, else NULL */
    const RnaCurves *curves; /* of fibers, else NULL */
    bool emits;              /* whether rna_emission gives more than 0 */
    int record_count;        /* of transmittance; 0: every hit is opaque */
    const RnaTransmittance *records; /* in the order of their triangles */
    int normal_map_count;            /* 0: the normals are those of the mesh */
    const RnaNormalMap *normal_maps; /* in the order of their triangles */
    int base_color_count;            /* 0: white */
    const RnaBaseColor *base_colors; /* in the order of their triangles */
} RnaPart;

typedef struct RnaAsset RnaAsset;

/* The asset in a file, which is read, and checked by section 10; NULL where an issue is an error.
 * `report` is filled in either case, and may be NULL. */
RnaAsset *rna_open(const char *path, RnaReport *report);

/* As rna_open, of bytes that the host loaded.  They are not copied: they must start at a multiple
 * of 64 and stay as they are until rna_close. */
RnaAsset *rna_open_memory(const void *data, size_t size, RnaReport *report);

/* Frees the asset, and with it all that its functions returned.  NULL is fine. */
void rna_close(RnaAsset *asset);

/* Of an asset that is NULL there are no parts and no tiers. */
int rna_part_count(const RnaAsset *asset);                   /* 1 to RNA_MAX_PARTS */
const RnaPart *rna_part(const RnaAsset *asset, int part);    /* NULL where there is none */
int rna_tier_count(const RnaAsset *asset);
int rna_tier_index(const RnaAsset *asset, const char *name); /* -1 where there is none */
const RnaTier *rna_tier(const RnaAsset *asset, int tier);    /* NULL where there is none */

/* The tier's flip where the sphere about the bounds of all parts is `pixels` high in the image (section 3,
 * "Error by size"), its largest where that is not above 0; below 0: unknown. */
double rna_flip_at(const RnaAsset *asset, int tier, double pixels);

/* Whether the asset was trained for wi, or else for wo, in this direction (section 7.1, "Domain"); outside of it
 * results are extrapolated. */
bool rna_in_domain(const RnaAsset *asset, bool is_wi, const float direction[3]);

/* Transport at n points of a part: radiance towards wo under irradiance 1 from wi, linear RGB
 * (section 7.1).
 *
 * positions, axes, wo, wi: n x 3.  axes: normals of a surface (rna_normal), tangents of fibers.  h: n offsets
 * across the fiber; not read for surfaces.  base_colors: n x 3, linear RGB, of rna_base_color or others; not
 * read where rna_uses_base_color is false.  visible, shadowed: n x 3, written: for the case that the
 * asset itself, with all its parts, does not, or does, block the ray from the position along wi.
 *
 * Results are finite and never negative whatever comes in (section 8), the same to the bit in
 * whatever batch a row comes, and contain the cosine.  Rows are computed 48 at a time: a call for
 * one costs as much as a call for 48.  Any number of threads may call this for one asset at once. */
RnaStatus rna_evaluate(const RnaAsset *asset, int tier, int part, size_t n, const float *positions,
                       const float *axes, const float *h, const float *wo, const float *wi,
                       const float *base_colors, float *visible, float *shadowed);

/* The same with nearby light (section 7.3), n x 3, traced by the host or estimated by one ray for each row; NULL, as in
 * rna_evaluate, for the means of the package: no glow at the edges of shadows, the mean of it everywhere. */
RnaStatus rna_evaluate_nearby(const RnaAsset *asset, int tier, int part, size_t n, const float *positions,
                              const float *axes, const float *h, const float *wo, const float *wi,
                              const float *base_colors, const float *nearby, float *visible, float *shadowed);

/* The three lengths of the nearby light that this tier and part count, metres; NULL where they count none. */
const double *rna_nearby_lengths(const RnaAsset *asset, int tier, int part);

/* Whether rna_evaluate of this tier and part needs base colours. */
bool rna_uses_base_color(const RnaAsset *asset, int tier, int part);

/* Emission at n points of a part: radiance towards wo where nothing lights the asset (section 7.2).
 * emission: n x 3, written: 0 where the part does not emit.  All else as for rna_evaluate. */
RnaStatus rna_emission(const RnaAsset *asset, int tier, int part, size_t n, const float *positions,
                       const float *axes, const float *h, const float *wo, float *emission);

/* tau, linear RGB: the part of the light that goes straight on where a ray of this direction hits the
 * triangle at barycentric coordinates b1, b2 of its second and third corner (section 4.4).  0 for an
 * opaque one, and for a part or triangle that is not there; where it is 1, there is no hit. */
void rna_transmittance(const RnaAsset *asset, int part, uint32_t triangle, double b1, double b2,
                       const float direction[3], float tau[3]);

/* The normal of a surface's query at a hit, unit, not turned to the viewer: that of the corners,
 * interpolated, with the relief of the part's normal maps (sections 4.1 and 4.5).  The visibility ray and
 * rna_transmittance go by the one without.  0 for a part or triangle that is not there, and for coordinates
 * that are not finite. */
void rna_normal(const RnaAsset *asset, int part, uint32_t triangle, double b1, double b2, float normal[3]);

/* Gives a record of base colour the pixels of its image, which the host decoded: height x width x 3 of 8 bits,
 * the top row first, without alpha.  They are copied, and smaller levels made of them (about 4/3 of their size).
 * This library has no decoder of images; records without pixels are as if their image was white.  No other thread
 * may use the asset at the same time. */
RnaStatus rna_set_image(RnaAsset *asset, int part, int record, const uint8_t *rgb);

/* a, linear RGB: the base colour of a hit (section 4.6), 1 for a part or triangle that is not there.  level: 0 for
 * the image itself, so that print does not alias max(0, log2(w d)), w the width of a pixel at the hit and d of
 * rna_texel_density. */
void rna_base_color(const RnaAsset *asset, int part, uint32_t triangle, double b1, double b2, double level,
                    float a[3]);

/* Texels of its image a unit of length on the triangle; 0 where it has no image, or no area. */
double rna_texel_density(const RnaAsset *asset, int part, uint32_t triangle);

/* A part with other positions: bent, stretched (section 8.3).  Rays are traced against these positions; what they hit
 * asks the decoder at its rest point, with directions turned to rest. */
typedef struct RnaShape RnaShape;

typedef struct RnaRest {
    float position[3]; /* at rest, for rna_evaluate */
    float axis[3];     /* the normal, without normal maps, or the tangent there */
    float rotation[9]; /* by rows: takes directions of the shape to rest */
} RnaRest;

/* positions: of the mesh's vertices or the curves' points, deformed, as many and in their order; copied.  NULL where there
 * is no such part, or not enough memory. */
RnaShape *rna_deform(const RnaAsset *asset, int part, const float *positions);

/* Corner normals of the deformed mesh, vertex_count x 3, unit, for its visibility rays; NULL of fibers. */
const float *rna_shape_normals(const RnaShape *shape);

/* The rest point of a hit on the shape.  Of a surface place holds b1 and b2 of the triangle, and normal is not read; of
 * fibers it holds the place in the segment, 0 to 1, and normal is the outward one of the hit.  Segments count strand after
 * strand.  False where there is no such triangle or segment. */
bool rna_rest_point(const RnaShape *shape, uint32_t primitive, const double place[2], const float normal[3],
                    RnaRest *rest);

/* Frees the shape, which must be before rna_close of its asset.  NULL is fine. */
void rna_free_shape(RnaShape *shape);

/* An extension of a package (section 9): the JSON text of its data, without a zero byte behind it.  NULL
 * where the manifest has none. */
const char *rna_extension(const RnaAsset *asset, const char *name, size_t *size);

/* The bytes of an entry, such as "extensions/NAME/..."; NULL where there is none. */
const void *rna_entry(const RnaAsset *asset, const char *name, size_t *size);

/* A sentence for a status. */
const char *rna_status_text(RnaStatus status);

#ifdef __cplusplus
}
#endif
#endif
