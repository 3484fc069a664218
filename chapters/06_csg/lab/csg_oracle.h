/* csg_oracle.h: whether a point is in a solid, and in a tree of them, without any ray.
 *
 *   double m = oracle_margin(&s, p)         how far p is from the surface: negative inside; exact
 *                                           but for 1e-30 of its size. Of a mesh only
 *                                           its sign means something, by solid angles
 *   bool in = oracle_contains(model, p, &least)   the Boolean of its parts, and the least |margin|:
 *                                           the answer is certain where that is well above 0
 *
 * Source of the solid angle: A. van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle",
 * IEEE Transactions on Biomedical Engineering 30(2), 1983.
 */
#ifndef CSG_ORACLE_H
#define CSG_ORACLE_H

#include "../../../common/random.h"
#include "../files/expression.h"

/* ---------------------------------------------------------------------------------------------- */

static inline wide3 oracle_on(ray r, double t)  /* o + t d, not rounded */
{
    return wide3_madd(wide3_of(r.o), wide3_of(r.d), wide_of(t));
}

static inline double oracle_plane(vec3 n, real h, wide3 p)
{
    wide3 w = wide3_of(n);
    wide above = wide_sub(wide3_dot(w, p), wide_of((double)h));
    return wide_value(wide_div(above, wide3_length(w)));
}

/* Full turns of the sphere of directions from p that the mesh covers, outwards counted 1. */
static inline double oracle_winding(csg_closed m, wide3 p)
{
    double sum = 0;
    for (size_t i = 0; i < m.n; i++) {
        wide3 a = wide3_sub(wide3_of(m.tri[i].a), p), b = wide3_sub(wide3_of(m.tri[i].b), p);
        wide3 c = wide3_sub(wide3_of(m.tri[i].c), p);
        double la = wide_value(wide3_length(a)), lb = wide_value(wide3_length(b));
        double lc = wide_value(wide3_length(c)), det = wide_value(wide3_dot(a, wide3_cross(b, c)));
        double ab = wide_value(wide3_dot(a, b)), bc = wide_value(wide3_dot(b, c));
        double ca = wide_value(wide3_dot(c, a));
        sum += 2 * atan2(det, la * lb * lc + la * bc + lb * ca + lc * ab);
    }
    return sum / (4 * 3.14159265358979323846);
}

static inline double oracle_margin(const csg_solid *s, wide3 p)
{
    double most = -HUGE_VAL;
    if (!csg_solid_is_some(s)) return HUGE_VAL;
    switch (s->kind) {
    case CSG_SPHERE: {
        wide3 f = wide3_sub(p, wide3_of(s->ball.c));
        return wide_value(wide_sub(wide3_length(f), wide_of(fabs((double)s->ball.r))));
    }
    case CSG_CYLINDER: {
        wide3 a = wide3_of(s->cylinder.a), f = wide3_sub(p, wide3_of(s->cylinder.p));
        wide away = wide_div(wide3_length(wide3_cross(f, a)), wide3_length(a));
        return wide_value(wide_sub(away, wide_of(fabs((double)s->cylinder.r))));
    }
    case CSG_HALF: return oracle_plane(s->box.n[0], s->box.hi[0], p);
    case CSG_BOX:
        for (int k = 0; k < 3; k++) {
            most = fmax(most, oracle_plane(s->box.n[k], s->box.hi[k], p));
            most = fmax(most, oracle_plane(vneg(s->box.n[k]), -s->box.lo[k], p));
        }
        return most;
    case CSG_MESH: {
        double turns = oracle_winding(s->mesh, p);
        return fabs(turns - round(turns)) > 0.01 ? 0 : turns > 0.5 ? -1 : 1;  /* 0: on it */
    }
    }
    return HUGE_VAL;
}

static inline bool oracle_contains(csg_model m, wide3 p, double *least)
{
    bool *waiting = allocate(m.steps + 1, 1);
    size_t n = 0;
    *least = HUGE_VAL;
    for (size_t i = 0; i < m.steps; i++) {
        csg_operation what = m.step[i].what;
        if (what == CSG_SOLID) {
            double margin = oracle_margin(&m.solid[m.step[i].solid], p);
            *least = fmin(*least, fabs(margin));
            waiting[n++] = margin < 0;
            continue;
        }
        bool b = waiting[--n], a = waiting[n - 1];
        waiting[n - 1] = what == CSG_UNION ? a | b : what == CSG_INTERSECTION ? a & b : a & !b;
    }
    bool in = n == 1 && waiting[0];
    free(waiting);
    return in;
}

static inline vec3 random_direction_of(random_stream *s)
{
    vec3 d = vunit(random_in_cube(s, 1));
    return vzero(d) ? vec(0, 0, 1) : d;
}

#endif
