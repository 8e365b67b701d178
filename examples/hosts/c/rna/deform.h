/* Deformed shapes of parts, as rna.h offers them (section 8.3). */
#ifndef RNA_DEFORM_H
#define RNA_DEFORM_H

#include "normal_maps.h"
#include "strand_rest.h"

/* Copies the positions, and makes the normals or the rotations. */
static bool fill_shape(RnaShape *shape, const float *positions, size_t points) {
    const RnaCurves *curves = shape->curves;
    shape->positions = malloc((3 * points + 1) * sizeof *positions);
    if (!shape->positions) return false;
    memcpy(shape->positions, positions, 3 * points * sizeof *positions);
    if (!curves) {
        shape->normals = malloc((3 * points + 1) * sizeof *positions);
        return shape->normals && deform_normals(shape);
    }
    shape->segments = curves->point_count - curves->strand_count;
    shape->rotations = malloc(((size_t)shape->segments + 1) * sizeof *shape->rotations);
    shape->first = malloc(((size_t)shape->segments + 1) * sizeof *shape->first);
    return shape->rotations && shape->first && turn_strands(shape);
}

void rna_free_shape(RnaShape *shape) {
    if (!shape) return;
    free(shape->positions);
    free(shape->normals);
    free(shape->rotations);
    free(shape->first);
    free(shape);
}

RnaShape *rna_deform(const RnaAsset *asset, int part, const float *positions) {
    const RnaPart *of = rna_part(asset, part);
    RnaShape *shape = of && positions ? calloc(1, sizeof *shape) : NULL;
    if (!shape) return NULL;
    shape->mesh = of->mesh;
    shape->curves = of->curves;
    if (fill_shape(shape, positions, of->mesh ? of->mesh->vertex_count : of->curves->point_count)) return shape;
    rna_free_shape(shape);
    return NULL;
}

const float *rna_shape_normals(const RnaShape *shape) { return shape ? shape->normals : NULL; }

bool rna_rest_point(const RnaShape *shape, uint32_t primitive, const double place[2], const float normal[3],
                    RnaRest *rest) {
    if (!shape || !place || !rest || !(normal || shape->mesh)) return false;
    if (primitive >= (shape->mesh ? shape->mesh->triangle_count : shape->segments)) return false;
    const double b[3] = {1 - place[0] - place[1], place[0], place[1]};
    if (shape->mesh)
        rest_on_mesh(shape, primitive, b, rest);
    else
        rest_on_strand(shape, primitive, place[0], normal, rest);
    return true;
}

#endif
