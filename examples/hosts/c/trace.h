/* Rays against the geometry of one asset, all parts of it: a small bounding volume hierarchy in float64,
 * for the programs of this folder.  An engine has its own; what it should copy is the rule of the visibility
 * ray. */
#ifndef TRACE_H
#define TRACE_H

#include "rna.h"

typedef struct Tracer Tracer;

typedef struct TraceHit {
    double t;
    int part;
    uint32_t primitive; /* number of the triangle, or of the segment (section 4.2), in its part */
    double b1, b2;      /* of a triangle: barycentric coordinates of its second and third corner */
    double n[3];        /* of a segment: outward unit normal of its round cone */
} TraceHit;

/* NULL where memory is out.  The asset must outlive it. */
Tracer *trace_new(const RnaAsset *asset);
void trace_free(Tracer *tracer);
uint32_t trace_primitive_count(const Tracer *tracer, int part);

/* The closest hit along origin + t direction, t >= 0; direction: unit.  Fibers are hit from outside.
 * after: a hit of the same ray, to go on behind it; NULL for the first one. */
bool trace_closest(const Tracer *tracer, const double origin[3], const double direction[3],
                   const TraceHit *after, TraceHit *hit);

/* The normal n of a surface hit, unit, not turned to the viewer; position: written (section 4.1).
 * Queries take the normal of rna_normal, which has the relief of normal maps. */
void trace_surface_point(const RnaMesh *mesh, uint32_t triangle, double b1, double b2,
                         double position[3], double n[3]);

/* The tangent t of a segment, unit. */
void trace_tangent(const Tracer *tracer, int part, uint32_t segment, double t[3]);

/* v: how much of the way from a point along wi the asset leaves free, RGB; the transport is
 * v visible + (1 - v) shadowed (section 7.1). */
void trace_visible_on_mesh(const Tracer *tracer, int part, uint32_t triangle, double b1, double b2,
                           const double wi[3], double v[3]);
void trace_visible_on_fiber(const Tracer *tracer, int part, uint32_t segment, const double position[3],
                            const double wi[3], double v[3]);

#endif
