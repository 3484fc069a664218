static inline int bvh_any_below(const first_bvh *b, int i, ray r, int skip)
{
    const first_bvh_node *node = &b->node[i];
    real t_enter;
    hit h;
    if (!first_aabb_hit(node->box, r, &t_enter) || t_enter > r.tmax) return -1;
    if (node->left != 0) {
        int found = bvh_any_below(b, node->left, r, skip);
        return found >= 0 ? found : bvh_any_below(b, node->right, r, skip);
    }
    for (int k = node->first; k < node->first + node->n; k++)
        if (b->order[k] != skip && first_triangle_hit(b->m->tri[b->order[k]], r, &h))
            return b->order[k];
    return -1;
}

/* Does the ray hit any triangle in [r.tmin, r.tmax], other than number `skip` (a lamp that the
 * ray is aimed at, say)? Returns the number of the first that is found, or -1. It does not go on
 * when one is found. A node is left out if the ray misses its box (first_aabb_hit) or enters it
 * beyond tmax; its left child comes before its right one, whatever the direction; the triangles
 * of a leaf come in the order in which they stand. The tree has at least one triangle. */
static inline int bvh_any(const first_bvh *b, ray r, int skip)
{
    return bvh_any_below(b, 0, r, skip);
}
