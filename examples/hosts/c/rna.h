/* RNA 1.0 packages in C: open, check, evaluate.  One source file, C11, the C library alone.
 *
 *     RnaReport report;
 *     RnaAsset *asset = rna_open("toy.rna", &report);
 *     if (!asset) { fprintf(stderr, "%s\n", report.issues[0].code); return 1; }
 *     rna_evaluate(asset, 0, n, positions, normals, NULL, wo, wi, visible, shadowed);
 *     rna_close(asset);
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

enum { RNA_MAX_ISSUES = 32 };

typedef struct RnaReport {
    int count;  /* of the issues below; what comes beyond RNA_MAX_ISSUES is left out */
    int errors; /* how many of them are errors */
    RnaIssue issues[RNA_MAX_ISSUES];
} RnaReport;

typedef enum RnaKind { RNA_SURFACE, RNA_FIBER } RnaKind;

typedef enum RnaStatus {
    RNA_OK,
    RNA_BAD_ARGUMENT,        /* a NULL array, or no such tier */
    RNA_UNSUPPORTED_DECODER, /* legal, but no chain of the profile's operators: needs an ONNX engine */
    RNA_OUT_OF_MEMORY
} RnaStatus;

typedef struct RnaTier {
    const char *name;
    bool runs;            /* whether rna_evaluate can run its decoder */
    bool is_int8;         /* the decoder's arithmetic */
    double multiply_adds; /* a query; int8 ones count half when tiers are compared.  Below 0: unknown */
    double flip;          /* mean error on images the training never saw.  Below 0: unknown */
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

typedef struct RnaAsset RnaAsset;

/* The asset in a file, which is mapped, checked as section 10 asks, and not written to; NULL where
 * an issue is an error.  `report` is filled in either case. */
RnaAsset *rna_open(const char *path, RnaReport *report);

/* The same for bytes that the host loaded.  They are not copied: they must start at a multiple of
 * 64 and stay as they are until rna_close. */
RnaAsset *rna_open_memory(const void *data, size_t size, RnaReport *report);

/* Frees the asset, and with it all that its functions returned.  NULL is fine. */
void rna_close(RnaAsset *asset);

RnaKind rna_kind(const RnaAsset *asset);
void rna_bounds(const RnaAsset *asset, float low[3], float high[3]);
const RnaMesh *rna_mesh(const RnaAsset *asset);     /* NULL for fibers */
const RnaCurves *rna_curves(const RnaAsset *asset); /* NULL for surfaces */

int rna_tier_count(const RnaAsset *asset);
int rna_tier_index(const RnaAsset *asset, const char *name); /* -1 where there is none */
const RnaTier *rna_tier(const RnaAsset *asset, int tier);    /* NULL where there is none */

/* Transport at n points: radiance towards wo under irradiance 1 from wi, linear RGB (section 7).
 *
 * positions, axes, wo, wi: n x 3.  axes: normals of a surface, tangents of fibers.  h: n offsets
 * across the fiber; not read for surfaces.  visible, shadowed: n x 3, written: for the case that the
 * asset itself does not, or does, block the ray from the position along wi.
 *
 * Results are finite and never negative whatever comes in (section 8), the same to the bit in
 * whatever batch a row comes, and contain the cosine.  Rows are computed 48 at a time: a call for
 * one costs as much as a call for 48.  Any number of threads may call this for one asset at once. */
RnaStatus rna_evaluate(const RnaAsset *asset, int tier, size_t n, const float *positions,
                       const float *axes, const float *h, const float *wo, const float *wi,
                       float *visible, float *shadowed);

/* A sentence for a status. */
const char *rna_status_text(RnaStatus status);

#ifdef __cplusplus
}
#endif
#endif
