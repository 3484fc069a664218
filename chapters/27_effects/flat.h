/* flat.h: does all that reflects lie in one plane? Then nothing there can light anything else.
 *
 *   bool flat_studio(&s, look)       look[m]: appearance of material m
 *
 * A matte floor under a lamp gathers light that comes straight from the lamp, and sends it away; no
 * other surface can send it back, as long as they are black or in its own plane. The plane is x, y
 * or z = constant, exactly: then a ray that leaves it never meets it again. Lamps are taken for
 * what they reflect, not for what they emit. Nothing at all is flat.
 */
#ifndef EFFECTS_FLAT_H
#define EFFECTS_FLAT_H

#include "appearance.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { bool begun; vec3 at; bool same[3]; } flat_plane;

static inline bool flat_holds(flat_plane *q, vec3 p)
{
    if (!q->begun) *q = (flat_plane){true, p, {true, true, true}};
    q->same[0] &= p.x == q->at.x, q->same[1] &= p.y == q->at.y, q->same[2] &= p.z == q->at.z;
    return q->same[0] || q->same[1] || q->same[2];
}

/* Of one mesh: has it triangles that reflect by their own material, others that take that of the
 * place, and was one of its places met? Asked once, not for each place: there may be many. */
typedef struct { bool own, bare, seen; } flat_paint;

static inline flat_paint flat_paint_of(const studio *s, const appearance *look, size_t number)
{
    const mesh *m = &s->mesh[number];
    flat_paint q = {.bare = !m->runs || m->run[0].first > 0};
    for (size_t k = 0; k < m->runs; k++) {
        uint32_t own = s->paint[number].run_material[k];
        if (own == name_none) q.bare = true;
        else q.own = q.own || !appearance_black(&look[own]);
    }
    return q;
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
    bool flat = true;
    flat_paint *paint = allocate(s->meshes, sizeof *paint);
    for (size_t m = 0; m < s->meshes; m++) paint[m] = flat_paint_of(s, look, m);
    for (size_t i = 0; flat && i < s->shapes; i++) {
        const shape *x = &s->shape[i];
        if (appearance_black(&look[s->shape_material[i]])) continue;
        flat = x->kind == SHAPE_POLYGON;  /* triangles are in meshes */
        for (uint32_t k = 0; flat && k < x->polygon.n; k++)
            flat = flat_holds(&q, x->polygon.v[k]);
    }
    for (size_t k = 0; flat && k < s->solids; k++)
        flat = appearance_black(&look[s->solid[k].material]);
    for (uint32_t i = 0; flat && i < s->places; i++) {
        flat_paint *m = &paint[s->placed[i].mesh];
        if (!m->own && !(m->bare && !appearance_black(&look[s->placing[i].material]))) continue;
        flat = !m->seen && studio_stands(s, i) && flat_mesh(s, look, i, &q);
        m->seen = true;
    }
    free(paint);
    return flat;
}

#endif
