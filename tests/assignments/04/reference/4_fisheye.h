/* A fisheye lens (鱼眼), equidistant: what is seen at the angle theta from the middle of the view,
 * -w, lies at a distance from the middle of the picture that grows as theta does. The picture's
 * upper and lower edge, in the middle column, are at theta = `phi`/2, where tan(phi/2) = top / d
 * of the camera; pixels are square. The direction round the middle is the one in which
 * first_camera_window lies.
 *
 * Writes the ray from e, with d of length 1, tmin 0, tmax infinity; false, and out untouched,
 * where theta would be more than pi. In the very middle, d is -w. */
static inline bool fisheye_ray(first_camera c, real x, real y, ray *out)
{
    real half = atan(c.top / c.d);
    real across = (2 * x - c.nx) / c.ny, up = 1 - 2 * y / c.ny;
    real far = sqrt(across * across + up * up), theta = far * half;
    if (theta > pi) return false;
    vec3 d = vneg(c.w);
    if (far > 0) {
        vec3 side = vadd(vscale(c.u, across / far), vscale(c.v, up / far));
        d = vadd(vscale(c.w, -cos(theta)), vscale(side, sin(theta)));
    }
    *out = ray_from(c.e, d);
    return true;
}
