/* leaky_walk.h: bvh8_find of walk.h, which believes what it has computed. Compiled once in each
 * dialect, by dialects.h: no guard.
 */
EIGHT_TARGET __attribute__((noinline))
static bool EIGHT(bvh8_find_leaky)(const bvh8 *w, const ray *r, hit *out)
{
    uint64_t stack[bvh8_stack], *top = stack;
    bvh8_ray q;
    hit best = hit_none;
    if (w->nodes == 0 || !w->block || !bvh8_ray_of(w, r, &bvh8_skip_none, &q)) return false;
    for (uint32_t at = 0;;) {
        eight_set mask = 0;
        if (at & bvh8_leaf) {
            const bvh8_block *b = &w->block[at & ~bvh8_leaf];
            EIGHT(bvh8_view) v;
            EIGHT(bvh8_look)(b, &q, &v);
            eight_whole in = EIGHT_LE(EIGHT_ALL(0), v.lo) | EIGHT_LE(v.hi, EIGHT_ALL(0));
            if (EIGHT_BITS(in) != 0) {
                eight scaled = 1 / (v.e[0] + v.e[1] + v.e[2]);
                eight sum = EIGHT_FMA(v.e[0], v.z[0], EIGHT_FMA(v.e[1], v.z[1], v.e[2] * v.z[2]));
                eight t = (sum * scaled - q.oz) * q.sz, U = v.e[1] * scaled, V = v.e[2] * scaled;
                in &= EIGHT_LE(t, EIGHT_ALL(q.limit)) & EIGHT_LE(EIGHT_ALL(q.tmin), t);
                eight_set left = EIGHT_BITS(in);
                if (left && !out) return true;
                for (; left; left &= left - 1) {
                    int k = EIGHT_FIRST(left);
                    if (t[k] > q.limit || b->index[k] == no_shape) continue;
                    q.limit = t[k];
                    best = (hit){(real)t[k], (real)U[k], (real)V[k], b->index[k]};
                }
            }
        } else {
            const bvh8_node *n = &w->node[at];
            eight enter;
            mask = EIGHT(bvh8_boxes)(n, &q, &enter);
            if (mask) at = n->child[EIGHT_FIRST(mask)];
            if (mask & (mask - 1)) at = EIGHT(bvh8_push)(n, mask, &enter, &top);
        }
        if (mask) continue;
        do if (top == stack) {
            if (best.shape == no_shape) return false;
            best.t = (real)(((double)best.t + q.shift) / q.scale);
            *out = best;
            return true;
        } while (*--top >> 32 > float_bits(q.limit));
        at = (uint32_t)*top;
    }
}
