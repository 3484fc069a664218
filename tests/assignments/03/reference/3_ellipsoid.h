/* Where a ray meets the ellipsoid ((p.x - c.x) / radii.x)^2 + (same of y) + (same of z) = 1: its
 * entry, or, if that is not in [tmin, tmax], its exit. Writes t, and the unit normal there,
 * outward. d has any length; t belongs to d as it is. False, and t and n untouched, on a miss. */
static inline bool ellipsoid_hit(vec3 c, vec3 radii, ray r, real *t, vec3 *n)
{
    /* In coordinates in which it is the unit sphere the ray has the same t. */
    vec3 one = vec(1 / radii.x, 1 / radii.y, 1 / radii.z);
    ray small = {vmul(vsub(r.o, c), one), r.tmin, vmul(r.d, one), r.tmax};
    hit h;
    if (!first_sphere_hit((sphere){{0, 0, 0}, 1}, small, &h)) return false;
    *t = h.t, *n = vunit(vmul(ray_at(small, h.t), one));
    return true;
}
