/* media.h: which medium (介质) a ray is in, when bodies are nested, touch or overlap.
 *
 *      air .-------.            A body is what a closed surface bounds; it is filled with a medium.
 *         / glass   \           A place may lie in several bodies: in the bubble it is in the glass
 *     ---|->-(bubble)>--        ball and in the bubble. Which of them fills it?
 *         \         /           The one of highest priority (优先级); of equals the one entered last,
 *          '-------'            the innermost. In none of them: body 0, what is around everything.
 *
 *   medium m[] = {{1, {0,0,0}, 0}, {1.5, ..}, ..};    m[k]: what body k is made of; m[0]: air
 *   media_set in = {0};                               the bodies that a ray is in: none
 *   uint32_t k = media_fills(m, &in)                  whose medium it is that fills the place
 *   if (!media_enter(&in, k)) ..                      at most media_most at once: one more is not
 *   media_leave(&in, k)                               noted, and false (the light would be wrong:
 *                                                     19 and 27 refuse such scenes)
 *
 * One place of the ray may lie on several faces: water touches its glass; the bubble touches the
 * ball. A crossing holds them all, and only what is before and behind them all counts, so it does
 * not matter which of them was found first:
 *
 *   media_crossing c = {0};
 *   media_crossing_add(&c, k, +1)                     a face of k, from outside to inside; -1: out
 *   before = media_before(in, &c)                     `in`, and what is left without having been
 *                                                     entered: the ray began in there
 *   after = before, media_cross(&after, &c)           what is behind it; false: no room
 *   media_begin(&in, &c)                              `in` becomes `before`, where it lies; same
 *   from = media_fills(m, &before), to = media_fills(m, &after);     from == to: no interface
 *
 * The same face of a body twice (on an edge of a mesh) counts once. In and out of a body: nothing.
 * Bodies entered at one place are taken by rising number: of equal priority, the higher fills.
 *
 * What coloured glass keeps (吸收), by the law of Beer and Lambert:
 *
 *   dL/ds = -sigma L     =>     L(s) = L(0) e^(-sigma s)                      (19.9)
 *
 *   vec3 k = absorbed(sigma, s)                       the part that is left after a way s
 *
 * The deeper, the darker and the more saturated: the colour of glass is no property of its surface.
 * After an infinite way nothing is left of what is absorbed, and all of what is not (sigma = 0: 0
 * times infinity would be a NaN). sigma = 0 costs no exponential.
 *
 * Sources: C. Schmidt, B. Budge, "Simple Nested Dielectrics in Ray Traced Images", journal of
 * graphics tools 7(2), 2002 (priorities); P. Bouguer 1729, J. Lambert 1760, A. Beer 1852.
 */
#ifndef WHITTED_MEDIA_H
#define WHITTED_MEDIA_H

#include "../18_shade/material.h"
#include <stdint.h>

enum { media_most = 7, media_most_faces = 8 };
typedef struct { uint32_t n, body[media_most]; } media_set;  /* in the order of entering */
/* Not three arrays: from -O2 on gcc 12.2 walks those of 4 and of 1 byte with one counter, writes an
 * address as 0 + .. (ivopts), takes that for an access through NULL (ipa-modref), concludes that
 * media_cross does not read body[], and drops what a caller has just written there. */
typedef struct { uint32_t body; bool in, out; } media_face;
typedef struct { int n; media_face face[media_most_faces]; } media_crossing;

/* ---------------------------------------------------------------------------------------------- */

static inline real absorbed_one(real a, real s) { return a == 0 ? 1 : exp(-a * s); }

static inline vec3 absorbed(vec3 a, real s)
{
    return (vec3){absorbed_one(a.x, s), absorbed_one(a.y, s), absorbed_one(a.z, s)};
}

static inline uint32_t media_fills(const medium *m, const media_set *s)
{
    if (s->n == 0) return 0;
    uint32_t best = s->body[0];
    for (uint32_t k = 1; k < s->n; k++)
        if (m[s->body[k]].priority >= m[best].priority) best = s->body[k];
    return best;
}

static inline bool media_has(const media_set *s, uint32_t body)
{
    for (uint32_t k = 0; k < s->n; k++)
        if (s->body[k] == body) return true;
    return false;
}

static inline bool media_enter(media_set *s, uint32_t body)
{
    if (media_has(s, body)) return true;
    if (s->n == media_most) return false;
    s->body[s->n++] = body;
    return true;
}

static inline void media_leave(media_set *s, uint32_t body)
{
    uint32_t n = 0;
    for (uint32_t k = 0; k < s->n; k++)
        if (s->body[k] != body) s->body[n++] = s->body[k];
    s->n = n;
}

/* Kept by rising number. False: the ninth body at one place, which is not noted. */
static inline bool media_crossing_add(media_crossing *c, uint32_t body, int sign)
{
    int k = 0;
    while (k < c->n && c->face[k].body < body) k++;
    if (k == c->n || c->face[k].body != body) {
        if (c->n == media_most_faces) return false;
        for (int j = c->n++; j > k; j--) c->face[j] = c->face[j - 1];
        c->face[k] = (media_face){.body = body};
    }
    if (sign > 0) c->face[k].in = true;
    else c->face[k].out = true;
    return true;
}

static inline bool media_begin(media_set *in, const media_crossing *c)
{
    for (const media_face *f = c->face; f < c->face + c->n; f++) {
        if (!f->out || f->in || media_has(in, f->body)) continue;
        if (in->n == media_most) return false;
        for (uint32_t j = in->n++; j > 0; j--) in->body[j] = in->body[j - 1];
        in->body[0] = f->body;  /* longest of all in there: the outermost */
    }
    return true;
}

static inline bool media_cross(media_set *in, const media_crossing *c)
{
    bool room = true;
    for (const media_face *f = c->face; f < c->face + c->n; f++)
        if (f->out && !f->in) media_leave(in, f->body);
    for (const media_face *f = c->face; f < c->face + c->n; f++)
        if (f->in && !f->out) room &= media_enter(in, f->body);
    return room;
}

static inline media_set media_before(media_set in, const media_crossing *c)
{
    return media_begin(&in, c), in;
}

#endif
