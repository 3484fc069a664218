/* polygon_irradiance.h: how much light a flat polygon of radiance 1 sends onto a surface.
 *
 *        v1 ________ v0            E / L = -1/2 sum over the edges of theta_i n . g_i       (22.15)
 *          /_______/               theta_i: the angle under which p sees edge i,
 *        v2      v3 front below    g_i: unit (v_i - p) x (v_i+1 - p)
 *
 *   _______|n__________            Johann Heinrich Lambert, 1760. Of the part above the horizon:
 *          p                       edges that cross the horizon (地平线) of p are cut there.
 *
 *   polygon_irradiance(v, count, p, n)         E / L [sr]: times L [W/(m^2 sr)] it is the
 *                                              irradiance [W/m^2]; count <= polygon_most, else NaN
 *   rectangle_irradiance(r, p, n)              of its front, where r.s x r.t points
 *
 * The corners v lie in a plane and run around a convex polygon, counterclockwise as seen from its
 * front. It shines to the front alone: from behind, and in its plane beside it, E is 0. p in the
 * polygon itself: pi/2 (1 - n.m), m its normal, as of one closer and closer.
 *
 *   case                                       naive                               so here
 *   part of the light below the horizon        counts it as negative               cut
 *   small or far light, size/distance = s      sum of terms of size s leaves s^2   integrated
 *   seen nearly edge-on                        the same                            integrated
 *   corner straight ahead of another: acos     loses half of the digits            atan2
 *
 * Where the terms of (22.15) cancel, what they stand for is integrated as it is, positive, in
 * pieces that are small compared with their distance:
 *     E / L = integral of (n.w)(m.w) / |w|^2 dA, w = unit (x - p), = h integral of n.x / |x|^4 dA,
 * h being the distance of p from the plane, right to the last bits.                        (22.16)
 * Error: below 16 epsilon for nearly all polygons in general position, at most some hundred; that
 * times size / distance where p is close to the border, times size / height where the part above
 * the horizon is low: edges are differences of corners.
 * Distances: 1e-9 to 1e9 in float, 1e-75 to 1e75 in double: their fourth powers are numbers.
 *
 * Sources: J. H. Lambert, "Photometria", 1760; D. Baum, H. Rushmeier, J. Winget, "Improving
 * Radiosity Solutions through the Use of Analytically Determined Form-Factors", SIGGRAPH 1989.
 */
#ifndef RADIOMETRY_POLYGON_IRRADIANCE_H
#define RADIOMETRY_POLYGON_IRRADIANCE_H

#include "../../../common/numbers/gauss.h"
#include "../solid_angle.h"

enum { polygon_most = 16 };

/* As seen from p: corners, and edges e[i] = v[i+1] - v[i]. The edges are kept apart, since of a
 * small polygon far away the corners know little about them. Room for one that is not convex. */
typedef struct { vec3 v[2 * polygon_most], e[2 * polygon_most]; int count; } seen_polygon;

/* A triangle of it with corner a and edges s, t, and six times the volume of the pyramid over it:
 * positive if p is in front. */
typedef struct { vec3 a, s, t; real volume; } seen_triangle;

/* ---------------------------------------------------------------------------------------------- */

static inline seen_polygon polygon_seen(const vec3 *v, int count, vec3 p)
{
    seen_polygon s = {.count = count};
    for (int i = 0; i < count; i++)
        s.v[i] = vsub(v[i], p), s.e[i] = vsub(v[(i + 1) % count], v[i]);
    return s;
}

static inline seen_polygon rectangle_seen(rectangle r, vec3 p)
{
    vec3 a = vsub(r.o, p), b = vadd(a, r.s);
    return (seen_polygon){{a, b, vadd(b, r.t), vadd(a, r.t)},
                          {r.s, r.t, vneg(r.s), vneg(r.t)}, 4};
}

/* The part above the plane n.x = 0 (Sutherland, Hodgman). Where an edge is cut, the shares are
 * quotients of heights of different signs: no difference that could cancel. Unlike raster_clip (08)
 * it cuts the edges, too, which the corners of what is small and far away do not tell. */
static inline seen_polygon polygon_cut(const seen_polygon *s, vec3 n)
{
    seen_polygon c = {.count = 0};
    int away = -1;  /* where the border goes below: an edge along the horizon follows */
    for (int i = 0; i < s->count; i++) {
        vec3 a = s->v[i], e = s->e[i];
        real za = vdot(n, a), zb = vdot(n, s->v[(i + 1) % s->count]);
        real share = za / (za - zb), rest = -zb / (za - zb);
        if (!(za > 0) && !(zb > 0)) continue;
        c.v[c.count] = za > 0 ? a : vmadd(a, e, share);
        c.e[c.count++] = za <= 0 ? vscale(e, rest) : zb > 0 ? e : vscale(e, share);
        if (za > 0 && !(zb > 0)) away = c.count, c.v[c.count++] = vmadd(a, e, share);
    }
    vec3 sum = {0, 0, 0};  /* all edges together are 0 */
    for (int i = 0; i < c.count; i++)
        if (i != away) sum = vadd(sum, c.e[i]);
    if (away >= 0) c.e[away] = vneg(sum);
    return c;
}

/* theta g of the edge from a to a + e; a x e = a x (a + e) has the smaller rounding error. */
static inline vec3 edge_vector(vec3 a, vec3 e)
{
    vec3 cross = vcross(a, e);
    real sine = vlength(cross), cosine = vdot(a, vadd(a, e));
    return sine > 0 ? vscale(cross, atan2(sine, cosine) / sine) : (vec3){0, 0, 0};
}

/* (22.15) of some corners, and the sum of the sizes of its terms. */
static inline real lambert_sum(const seen_polygon *c, vec3 n, real *size)
{
    real sum = 0;
    *size = 0;
    for (int i = 0; i < c->count; i++) {
        real term = vdot(n, edge_vector(c->v[i], c->e[i]));
        sum -= term, *size += fabs(term);
    }
    return sum / 2;
}

/* ---- (22.16) ---- */

/* A square of points bent into the triangle, the side at a drawn together. */
static inline real triangle_by_points(seen_triangle k, vec3 n)
{
    real sum = 0;
    for (int i = 0; i < gauss_8.n; i++)
        for (int j = 0; j < gauss_8.n; j++) {
            real x = gauss_point(gauss_8, i), y = gauss_point(gauss_8, j) * x;
            vec3 q = vmadd(vmadd(k.a, k.s, x - y), k.t, y);
            real qq = vdot(q, q), w = gauss_weight(gauss_8, i) * gauss_weight(gauss_8, j) * x;
            sum += w * real_max(vdot(n, q), 0) / qq / qq;
        }
    return sum * k.volume;
}

/* Halves the longest edge until it is a third of the distance. `depth` bounds the work: then the
 * piece goes right up to p, and (22.15) has to do. */
static inline real triangle_in_pieces(seen_triangle k, vec3 n, int depth)
{
    vec3 a = k.a, s = k.s, t = k.t, u = vsub(t, s), mid = vmadd(a, vadd(s, t), (real)1 / 3);
    real ss = vdot(s, s), tt = vdot(t, t), uu = vdot(u, u), size;
    real longest = real_max(ss, real_max(tt, uu));
    if (9 * longest <= vdot(mid, mid)) return triangle_by_points(k, n);
    if (depth == 0) {
        seen_polygon c = {{a, vadd(a, s), vadd(a, t)}, {s, u, vneg(t)}, 3};
        return real_max(lambert_sum(&c, n, &size), 0);
    }
    if (longest == ss) a = vadd(a, t), s = vneg(t), t = vneg(u);  /* c, a, b become a, b, c */
    else if (longest == tt) a = vadd(a, s), t = vneg(s), s = u;   /* b, c, a become a, b, c */
    vec3 half = vscale(vadd(s, t), 0.5);  /* of the edge opposite a, now the longest */
    return triangle_in_pieces((seen_triangle){a, s, half, k.volume / 2}, n, depth - 1)
         + triangle_in_pieces((seen_triangle){a, half, t, k.volume / 2}, n, depth - 1);
}

/* The part above the horizon: b is the corner that is alone on its side, c and a the others, turned
 * so. Shares of the volume are products of shares of edges. */
static inline real triangle_integrated(seen_triangle k, vec3 n)
{
    enum { depth = 16 };
    vec3 v[3] = {k.a, vadd(k.a, k.s), vadd(k.a, k.t)};
    vec3 e[3] = {k.s, vsub(k.t, k.s), vneg(k.t)};
    real z[3] = {vdot(n, v[0]), vdot(n, v[1]), vdot(n, v[2])};
    int above = (z[0] > 0) + (z[1] > 0) + (z[2] > 0), i = 0;
    if (above == 0) return 0;
    if (above == 3) return triangle_in_pieces(k, n, depth);
    while ((z[i] > 0) != (above == 1)) i++;  /* the one that is alone */
    int j = (i + 1) % 3, h = (i + 2) % 3;
    real f = z[i] / (z[i] - z[j]), g = z[i] / (z[i] - z[h]);  /* of its edges, its own side */
    vec3 s = vscale(e[i], f), t = vscale(e[h], -g);
    if (above == 1)
        return triangle_in_pieces((seen_triangle){v[i], s, t, k.volume * f * g}, n, depth);
    real f1 = -z[j] / (z[i] - z[j]), g1 = -z[h] / (z[i] - z[h]);
    seen_triangle one = {v[j], e[j], vscale(e[i], -f1), k.volume * f1};
    seen_triangle two = {v[h], vscale(e[h], g1), vsub(one.t, e[j]), k.volume * f * g1};
    return triangle_in_pieces(one, n, depth) + triangle_in_pieces(two, n, depth);
}

/* ---- all of it ---- */

/* p lies in the plane: in the polygon, its border included? */
static inline bool polygon_around(const seen_polygon *c, vec3 m)
{
    for (int i = 0; i < c->count; i++)
        if (!(vdot(vcross(c->v[i], c->e[i]), m) >= 0)) return false;
    return !vzero(m);
}

/* The triangles of a fan from corner 0, whose volumes are given. */
static inline real seen_irradiance(const seen_polygon *s, const real *volume, vec3 n)
{
    real whole = 0, size, e = 0;
    vec3 area = {0, 0, 0}, t = s->e[0];
    for (int i = 0; i + 2 < s->count; i++) {
        whole += volume[i];
        area = vadd(area, vcross(t, s->e[i + 1])), t = vadd(t, s->e[i + 1]);
    }
    if (whole == 0 && polygon_around(s, area))
        return pi / 2 * real_clamp(1 - vdot(n, vunit(area)), 0, 2);
    if (!(whole > 0)) return 0;
    seen_polygon c = polygon_cut(s, n);
    real sum = lambert_sum(&c, n, &size);
    if (32 * sum >= size) return sum;
    t = s->e[0];
    for (int i = 0; i + 2 < s->count; i++) {
        seen_triangle k = {s->v[0], t, vadd(t, s->e[i + 1]), volume[i]};
        e += triangle_integrated(k, n), t = k.t;
    }
    return e;
}

static inline real polygon_irradiance(const vec3 *v, int count, vec3 p, vec3 n)
{
    if (count < 3 || count > polygon_most) return count < 3 ? 0 : (real)NAN;
    seen_polygon s = polygon_seen(v, count, p);
    real volume[polygon_most];
    for (int i = 0; i + 2 < count; i++)
        volume[i] = -triangle_volume((triangle){v[0], v[i + 1], v[i + 2]}, p);
    return seen_irradiance(&s, volume, n);
}

static inline real rectangle_irradiance(rectangle r, vec3 p, vec3 n)
{
    seen_polygon s = rectangle_seen(r, p);
    real half = -rectangle_volume(r, p), volume[2] = {half, half};
    return seen_irradiance(&s, volume, n);
}

#endif
