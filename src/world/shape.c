// SPDX-License-Identifier: Apache-2.0
#include "world/shape.h"

#define ROUND 1e-12  // 1   moments that differ by less, of their mean, are equal

// One turn of Jacobi's method: makes a[p][q] vanish, and turns the axes v (columns) along.
// Golub & Van Loan (2013), Matrix Computations, 8.5.
static void turn_away(double a[3][3], double v[3][3], int p, int q)
{
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
    double c = 1 / sqrt(t * t + 1), s = t * c;
    for (int k = 0; k < 3; k++) {
        double kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq, a[k][q] = s * kp + c * kq;
    }
    for (int k = 0; k < 3; k++) {
        double pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk, a[q][k] = s * pk + c * qk;
    }
    for (int k = 0; k < 3; k++) {
        double kp = v[k][p], kq = v[k][q];
        v[k][p] = c * kp - s * kq, v[k][q] = s * kp + c * kq;
    }
}

// Principal axes as the columns of v, right-handed; a is left diagonal. A product of inertia that is
// nothing but rounding turns nothing.
static void find_axes(double a[3][3], double v[3][3])
{
    double least = 1e-15 * (a[0][0] + a[1][1] + a[2][2]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) v[i][j] = i == j;
    for (int round = 0; round < 30; round++)
        for (int p = 0; p < 2; p++)
            for (int q = p + 1; q < 3; q++)
                if (fabs(a[p][q]) > least) turn_away(a, v, p, q);
}

// The quaternion of a rotation matrix. Shepperd (1978), J. Guid. Control 1, 223.
static qn_quat quat_of_matrix(double m[3][3])
{
    double trace = m[0][0] + m[1][1] + m[2][2];
    if (trace > 0)
        return qn_quat_unit(
            qn_quat_of(1 + trace, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]));
    if (m[0][0] >= m[1][1] && m[0][0] >= m[2][2])
        return qn_quat_unit(qn_quat_of(m[2][1] - m[1][2], 1 + m[0][0] - m[1][1] - m[2][2],
                                       m[0][1] + m[1][0], m[0][2] + m[2][0]));
    if (m[1][1] >= m[2][2])
        return qn_quat_unit(qn_quat_of(m[0][2] - m[2][0], m[0][1] + m[1][0],
                                       1 + m[1][1] - m[0][0] - m[2][2], m[1][2] + m[2][1]));
    return qn_quat_unit(qn_quat_of(m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1],
                                   1 + m[2][2] - m[0][0] - m[1][1]));
}

static qn_status check(const double *centres, const double *radii, int count)
{
    if (count < 1 || count > QN_SPHERES_MAX)
        return qn_fail(QN_INPUT, "a clump of %d spheres; allowed are 1 to %d", count,
                       QN_SPHERES_MAX);
    for (int i = 0; i < count; i++) {
        const double *x = &centres[3 * i];
        if (!(isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2])))
            return qn_fail(QN_INPUT, "sphere %d of the clump has a centre that is not finite",
                           i + 1);
        if (!(radii[i] > 0 && isfinite(radii[i])))
            return qn_fail(QN_INPUT,
                           "sphere %d of the clump has a radius of %g; it must be above 0", i + 1,
                           radii[i]);
    }
    return QN_OK;
}

// To 12 digits after the point, so that nothing hangs on the last bit of the C library's functions.
static double snapped(double x)
{
    return rint(x * 0x1p40) * 0x1p-40 + 0.0;  // no negative zero
}

// A ball, in closed form, so that it is the same to the bit as one without a shape.
static void one_sphere(qn_shape *s)
{
    s->radius[0] = s->bound = s->overlap = 1;
    s->moment = qn_v3(0.4, 0.4, 0.4);
    s->is_round = true;
}

// Principal moments and axes, and where the spheres stand in them.
static void lay_out(qn_shape *s, const double *centres, const double *radii, qn_solid *solid,
                    double unit)
{
    double v[3][3], spheres = 0, scale = 1 / (solid->volume * unit * unit);
    double(*j)[3] = solid->inertia;
    double mean = (j[0][0] + j[1][1] + j[2][2]) / 3, apart = 0;
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) apart = qn_max(apart, fabs(j[a][b] - (a == b) * mean));
    s->is_round = apart <= qn_max(ROUND, 4 * solid->error) * mean;
    s->moment = qn_scale(scale, qn_v3(mean, mean, mean));
    if (!s->is_round) {
        // Rounding must not turn axes that are free to turn, as those across a rod.
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) j[a][b] = snapped(j[a][b] / mean) * mean;
        find_axes(j, v);
        s->moment = qn_scale(scale, qn_v3(j[0][0], j[1][1], j[2][2]));
        qn_quat q = quat_of_matrix(v);
        s->axes = qn_quat_unit(qn_quat_of(snapped(q.w), snapped(q.x), snapped(q.y), snapped(q.z)));
    }
    s->moment = qn_v3(snapped(s->moment.x), snapped(s->moment.y), snapped(s->moment.z));
    for (int i = 0; i < s->count; i++) {
        qn_vec3 from = qn_v3(centres[3 * i], centres[3 * i + 1], centres[3 * i + 2]);
        qn_vec3 at = qn_turned_back(s->axes, qn_scale(1 / unit, qn_sub(from, solid->centre)));
        at = qn_v3(snapped(at.x), snapped(at.y), snapped(at.z));
        s->centre[3 * i] = at.x, s->centre[3 * i + 1] = at.y, s->centre[3 * i + 2] = at.z;
        s->radius[i] = snapped(radii[i] / unit);
        s->arm = qn_max(s->arm, qn_norm(at));
        s->bound = qn_max(s->bound, qn_norm(at) + s->radius[i]);
        spheres += s->radius[i] * s->radius[i] * s->radius[i];
    }
    s->overlap = 1 / spheres;
}

qn_status qn_shape_of(const double *centres, const double *radii, int count, qn_shape *shape,
                      double *radius)
{
    qn_solid solid;
    qn_shape s = {.count = count, .error = 0, .axes = {1, 0, 0, 0}};
    QN_TRY(check(centres, radii, count));
    *radius = radii[0];
    if (count == 1)
        one_sphere(&s);
    else {
        QN_TRY(qn_solid_of(centres, radii, count, &solid));
        *radius = cbrt(0.75 / QN_PI * solid.volume);
        s.error = solid.error + 1e-12;
        lay_out(&s, centres, radii, &solid, *radius);
    }
    *shape = s;
    return QN_OK;
}

void qn_shape_tetrahedron(double spacing, double *centres, double *radii)
{
    const double corner = spacing / sqrt(8.0);  // half the side of the cube around it
    for (int i = 0; i < 4; i++) {
        centres[3 * i] = corner * (i == 0 || i == 1 ? 1 : -1);
        centres[3 * i + 1] = corner * (i == 0 || i == 2 ? 1 : -1);
        centres[3 * i + 2] = corner * (i == 0 || i == 3 ? 1 : -1);
        radii[i] = 1;
    }
}
