/* contact.h: what else lies where a ray has hit glass.
 *
 *       air        A ray leaves a surface past everything that is closer than rounding: 18. Where
 *    -----p-----   glass stands in water, or on a table, that is the other face. So ask: what lies
 *    -----|-----   between the two places where rays may begin, a hair before and a hair behind?
 *       water      All faces there are crossed as one: media.h.
 *
 *   more = contact_find(t, r, x, &s, &m, &room, &c)   adds faces to the crossing c. If one of them
 *                                     is opaque, s and m become its own: glass on a table shows it.
 *                                     more: by so much rays must begin farther away than by leave
 *
 * It sends a ray of kind RAY_SIGHT, whose any-hit program notes what it is asked about and lets it
 * pass. A contact ray is a few epsilon long and costs about half of a reflection ray; a scene whose
 * glass touches nothing says `apart` and is spared them.
 *
 * How near is touching? 2 (error + noise) of the face that was hit, to either side, and what
 * `touch` >= 0 adds. Faces that are the same in exact numbers are never farther apart, if their
 * sizes are comparable. A far larger face, a floor a million times the size of the glass on it, is
 * met up to some epsilon of its own size off (18.6), of which the glass knows nothing: say touch =
 * 32 epsilon times the larger size.
 */
#ifndef WHITTED_CONTACT_H
#define WHITTED_CONTACT_H

#include "../../common/file.h"
#include "whitted_scene.h"

typedef struct {
    media_crossing *c;
    trace_hit opaque;       /* a face that ends it; h.shape = no_shape: none */
    uint32_t shape, part;   /* the face that we know of */
    vec3 d;                 /* of the ray that met it */
    bool full;              /* more bodies are there than a crossing holds */
} contact_notes;

/* ---------------------------------------------------------------------------------------------- */

static inline any_hit_answer contact_any(const tracer *t, ray r, trace_hit x, void *payload)
{
    const whitted *w = t->user;
    contact_notes *notes = payload;
    whitted_look room;
    if (x.h.shape == notes->shape && x.part == notes->part) return ANY_HIT_IGNORE;
    surface s = surface_of_trace(t, r, x);
    uint32_t body = w->material_of(w->context, &x, &s, &room)->body;
    real along = vdot(s.n, notes->d);
    if (body) notes->full |= !media_crossing_add(notes->c, body, along < 0 ? 1 : -1);
    else if (notes->opaque.h.shape == no_shape || hit_before(x.h, notes->opaque.h))
        notes->opaque = x;
    return ANY_HIT_IGNORE;
}

static inline real contact_find(tracer *t, ray r, trace_hit x, surface *s,
                                const whitted_look **m, whitted_look *room, media_crossing *c)
{
    const whitted *w = t->user;
    real reach = 2 * (s->error + s->noise) + w->touch;
    vec3 n = vdot(s->n, r.d) < 0 ? vneg(s->n) : s->n;  /* onwards */
    ray across = {vmadd(s->p, n, -reach), 0, n, 2 * reach};
    contact_notes notes = {c, {hit_none, 0}, x.h.shape, x.part, r.d, false};
    trace(t, RAY_SIGHT, across, &notes);
    if (notes.full) die(2, "more than %d bodies of glass touch at one place", media_most_faces);
    if (notes.opaque.h.shape != no_shape) {
        surface on = surface_of_trace(t, across, notes.opaque);
        *s = on;
        *m = w->material_of(w->context, &notes.opaque, &on, room);
    }
    return reach;
}

#endif
