/* flat.h: does all that reflects lie in one plane? Then nothing there can light anything else.
 *
 *   bool flat_studio(&s, look)       look[m]: appearance of material m
 *
 * A matte floor under a lamp gathers light that comes straight from the lamp, and sends it away; no
 * other surface can send it back, as long as they are black or in its own plane. The plane is x, y
 * or z = constant, exactly: then a ray that leaves it never meets it again. Lamps are taken for
 * what they reflect, not for what they emit. Nothing at all is flat.
 */
#ifndef FLAT_H
#define FLAT_H

#include "appearance.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { bool begun; vec3 at; bool same[3]; } flat_plane;

static inline bool flat_holds(flat_plane *q, vec3 p)
{
    if (!q->begun) *q = (flat_plane){true, p, {true, true, true}};
    q->same[0] &= p.x == q->at.x, q->same[1] &= p.y == q->at.y, q->same[2] &= p.z == q->at.z;
    return q->same[0] || q->same[1] || q->same[2];
}

/* Does mesh m, where triangles without usemtl are made of `bare`, reflect anything? O(runs) */
static inline bool flat_mesh_reflects(const studio *s, const appearance *look, uint32_t m,
                                      uint32_t bare)
{
    const mesh *x = &s->mesh[m];
    bool any = (!x->runs || x->run[0].first > 0) && !appearance_black(&look[bare]);
    for (size_t k = 0; !any && k < x->runs; k++) {
        uint32_t own = s->paint[m].run_material[k];
        any = !appearance_black(&look[own == name_none ? bare : own]);
    }
    return any;
}

/* Triangles of a place that stands. */
static inline bool flat_mesh(const studio *s, const appearance *look, uint32_t place, flat_plane *q)
{
    const mesh *m = &s->mesh[s->placed[place].mesh];
    for (uint32_t k = 0; k < m->triangles; k++) {
        if (appearance_black(&look[studio_material_of(s, place, k)])) continue;
        for (size_t c = 0; c < 3; c++)
            if (!flat_holds(q, m->v[m->index[3 * (size_t)k + c]])) return false;
    }
    return true;
}

/* Exactly: a plane that is askew, a mesh that was moved or stands there twice count as not flat. */
static inline bool flat_studio(const studio *s, const appearance *look)
{
    flat_plane q = {.begun = false};
    bool flat = true, *seen = allocate(s->meshes, sizeof *seen);
    for (size_t i = 0; flat && i < s->shapes; i++) {
        const shape *x = &s->shape[i];
        if (appearance_black(&look[s->shape_material[i]])) continue;
        flat = x->kind == SHAPE_POLYGON;  /* triangles are in meshes */
        for (uint32_t k = 0; flat && k < x->polygon.n; k++)
            flat = flat_holds(&q, x->polygon.v[k]);
    }
    for (uint32_t i = 0; flat && i < s->places; i++) {
        uint32_t m = s->placed[i].mesh;
        if (!flat_mesh_reflects(s, look, m, s->placing[i].material)) continue;
        flat = !seen[m] && studio_stands(s, i) && flat_mesh(s, look, i, &q);
        seen[m] = true;
    }
    free(seen);
    return flat;
}

#endif
