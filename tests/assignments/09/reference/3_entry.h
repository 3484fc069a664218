/* Where a ray first is in a closed box: the smallest t in [r.tmin, r.tmax] with o + t d in the
 * box, and the face that it comes in through: 0 for x = lo.x, 1 for x = hi.x, 2 and 3 for y, 4
 * and 5 for z. If it is in the box at tmin already, t is tmin and the face -1. At an edge or a
 * corner several faces are entered at once: the one with the lowest number counts. A ray that
 * runs in a face is in the box; boxes may be flat; components of d may be 0 or -0 (but not all).
 * False, and t and face untouched, on a miss. */
static inline bool aabb_entry(aabb b, ray r, real *t, int *face)
{
    real enter = r.tmin, leave = r.tmax;
    int in = -1;
    for (int k = 0; k < 3; k++) {
        real o = vaxis(r.o, k), d = vaxis(r.d, k), lo = vaxis(b.lo, k), hi = vaxis(b.hi, k);
        if (d == 0) {
            if (o < lo || o > hi) return false;
            continue;
        }
        real near = ((d > 0 ? lo : hi) - o) / d, far = ((d > 0 ? hi : lo) - o) / d;
        if (near > enter) enter = near, in = 2 * k + (d > 0 ? 0 : 1);
        if (far < leave) leave = far;
    }
    if (!(enter <= leave)) return false;
    *t = enter, *face = in;
    return true;
}
