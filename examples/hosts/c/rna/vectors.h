/* Vectors of three float64. */
#ifndef RNA_VECTORS_H
#define RNA_VECTORS_H

#include <math.h>

static inline double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void subtract(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) out[k] = a[k] - b[k];
}

static inline void cross(const double a[3], const double b[3], double out[3]) {
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        out[k] = a[i] * b[j] - a[j] * b[i];
    }
}

/* Brings v to unit length; leaves a vector without length. */
static inline void normalize(double v[3]) {
    double length = sqrt(dot(v, v));
    for (int k = 0; k < 3 && length > 0; k++) v[k] /= length;
}

static inline void load(const float *from, double to[3]) {
    for (int k = 0; k < 3; k++) to[k] = from[k];
}

#endif
