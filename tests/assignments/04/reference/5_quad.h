/* A flat quadrangle whose corners a, b, c, d go round it, with no angle of 180 degrees or more. Its
 * points are those of the bilinear map
 *     p(u, v) = (1 - u)(1 - v) a + u (1 - v) b + u v c + (1 - u) v d,   u and v in [0, 1]
 * Writes t, u and v of the hit. False, and out untouched, on a miss and where the quadrangle has no
 * area. Parallelograms count as any other: there the equation for u or v is not quadratic. */
static inline bool quad_hit(vec3 a, vec3 b, vec3 c, vec3 d, ray r, hit *out)
{
    vec3 n = vcross(vsub(c, a), vsub(d, b));
    int k = vlongest(n), i = (k + 1) % 3, j = (k + 2) % 3;
    hit h;
    if (vzero(n) || !first_plane_hit((plane){a, n}, r, &h) || !isfinite(h.t)) return false;

    /* In the plane, seen along its longest axis: q = u e + v f + u v g. */
    vec3 p = ray_at(r, h.t), e = vsub(b, a), f = vsub(d, a), q = vsub(p, a);
    vec3 g = vadd(vsub(a, b), vsub(c, d));
    real ex = vaxis(e, i), ey = vaxis(e, j), fx = vaxis(f, i), fy = vaxis(f, j);
    real gx = vaxis(g, i), gy = vaxis(g, j), qx = vaxis(q, i), qy = vaxis(q, j);

    /* q - v f is parallel to e + v g: A v^2 + B v + C = 0. */
    real A = fx * gy - fy * gx, B = fx * ey - fy * ex - (qx * gy - qy * gx);
    real C = -(qx * ey - qy * ex);
    real disc = B * B - 4 * A * C;
    if (disc < 0) return false;
    /* The sign of the root by that of B: no two near numbers are subtracted, and A may be 0. */
    real s = -(B + copysign(sqrt(disc), B)) / 2;
    real root[2] = {s != 0 ? C / s : 0, A != 0 ? s / A : -1};
    for (int m = 0; m < 2; m++) {
        real v = root[m], x = ex + v * gx, y = ey + v * gy;
        real u = fabs(x) > fabs(y) ? (qx - v * fx) / x : (qy - v * fy) / y;
        if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) continue;
        *out = (hit){h.t, u, v, 0};
        return true;
    }
    return false;
}
