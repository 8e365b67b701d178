/* Rotations: matrices of nine float64 by rows, and unit quaternions w, x, y, z. */
#ifndef RNA_ROTATIONS_H
#define RNA_ROTATIONS_H

#include "vectors.h"

#include <string.h>

static void turn(const double m[9], const double v[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = dot(m + 3 * i, v);
}

static void transpose(double m[9]) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < i; j++) {
            const double upper = m[3 * i + j];
            m[3 * i + j] = m[3 * j + i];
            m[3 * j + i] = upper;
        }
}

/* out = a b. */
static void composed(const double a[9], const double b[9], double out[9]) {
    for (int i = 0; i < 9; i++) {
        out[i] = 0;
        for (int k = 0; k < 3; k++) out[i] += a[i / 3 * 3 + k] * b[3 * k + i % 3];
    }
}

static void matrix_of(const double q[4], double m[9]) {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double values[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                              2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                              2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    memcpy(m, values, sizeof values);
}

/* The rotation by the smallest angle from a to b, unit vectors; none where one of them is 0, and about any axis across
 * them where they are opposite. */
static void smallest_rotation(const double a[3], const double b[3], double m[9]) {
    double q[4] = {1, 0, 0, 0};
    const double w = 1 + dot(a, b);
    if (dot(a, a) > 0 && dot(b, b) > 0) {
        const double x[3] = {1, 0, 0}, y[3] = {0, 1, 0};
        cross(a, w < 1e-9 ? (fabs(a[0]) < 0.7 ? x : y) : b, q + 1);
        q[0] = w < 1e-9 ? 0 : w;
        const double size = sqrt(q[0] * q[0] + dot(q + 1, q + 1));
        for (int k = 0; k < 4; k++) q[k] /= size;
    }
    matrix_of(q, m);
}

/* The unit eigenvector of the largest eigenvalue of a symmetric matrix, which is changed: by Jacobi's rotations. */
static void largest_eigenvector(double s[4][4], double result[4]) {
    double v[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    for (int step = 0; step < 12 * 6; step++) {
        static const int pairs[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
        const int i = pairs[step % 6][0], j = pairs[step % 6][1];
        if (s[i][j] == 0) continue;
        const double angle = 0.5 * atan2(2 * s[i][j], s[i][i] - s[j][j]), c = cos(angle), d = sin(angle);
        for (int k = 0; k < 4; k++) {
            const double p = s[k][i], q = s[k][j], x = v[k][i], y = v[k][j];
            s[k][i] = c * p + d * q, s[k][j] = c * q - d * p;
            v[k][i] = c * x + d * y, v[k][j] = c * y - d * x;
        }
        for (int k = 0; k < 4; k++) {
            const double p = s[i][k], q = s[j][k];
            s[i][k] = c * p + d * q, s[j][k] = c * q - d * p;
        }
    }
    int best = 0;
    for (int k = 1; k < 4; k++) best = s[k][k] > s[best][best] ? k : best;
    for (int k = 0; k < 4; k++) result[k] = v[k][best];
}

/* The rotation R for which the trace of R^T C is largest; of several the smallest.  Horn, "Closed-form solution of
 * absolute orientation using unit quaternions" (J. Opt. Soc. Am. A 4(4), 1987). */
static void fitted_rotation(const double c[9], double m[9]) {
    double size = 0, q[4], x[9];
    for (int i = 0; i < 9; i++) size += c[i] * c[i];
    for (int i = 0; i < 9; i++) x[i] = (size > 0 ? c[i] / sqrt(size) : 0) + (i % 4 == 0 ? 1e-9 : 0);
    double s[4][4] = {
        {x[0] + x[4] + x[8], x[7] - x[5], x[2] - x[6], x[3] - x[1]},
        {x[7] - x[5], x[0] - x[4] - x[8], x[1] + x[3], x[2] + x[6]},
        {x[2] - x[6], x[1] + x[3], x[4] - x[0] - x[8], x[5] + x[7]},
        {x[3] - x[1], x[2] + x[6], x[5] + x[7], x[8] - x[0] - x[4]},
    };
    largest_eigenvector(s, q);
    matrix_of(q, m);
}

#endif
