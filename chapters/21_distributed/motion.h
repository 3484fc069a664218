/* motion.h: a shutter that is open for a while: each ray has a time, each shape a place at it.
 *
 *   time 0                     time 1      s(time) = time v                               (21.16)
 *     ( )- - - - -(o)- - - - -> ( )        what was modelled at p is at p + s when a ray of this
 *      |------------ v ----------|         time passes; v: the way while the shutter is open
 *                  ^
 *                  |  a pixel here sees it for the share chord / |v| of the time: that is the blur
 *
 *   o + t d meets what was moved by s where (o - s) + t d meets it as it was modelled      (21.17)
 *
 * So no shape is moved and no tree is built again: the ray is moved back, and the point of the hit
 * forward. t stays what it is, and so does the normal. (16 does this with any transform.)
 *
 *   moving m = {world, v};                            parts that go by v [scene units]
 *   bool met = motion_closest(&t, m, n, time, kind, r, &payload, &reach, &by);
 *        of all n, and of t's own world, for a kind that wants the closest; its program leaves t
 *        at reach; by: the s of what was met, 0 if it rests
 *   bool met = motion_any(&t, m, n, time, kind, r)    does anything hide what the ray asks for?
 *   surface s = motion_surface(s, by)                 put where it is at that time
 *
 * One time serves all rays of a sample: eye ray, shadow rays, reflections. With another time each,
 * a ball would stand in its own light, where it was or will be.
 *
 * The path is a line, passed at an even speed. n = 0: trace(), to the last bit; time is not read.
 *
 * Source: Cook et al., 1984.
 */
#ifndef DISTRIBUTED_MOTION_H
#define DISTRIBUTED_MOTION_H

#include "../18_shade/shade.h"

typedef struct { trace_world w; vec3 v; } moving;

/* ---------------------------------------------------------------------------------------------- */

/* Two roundings more: that of p + s, and that of the next ray's o - s; each is off by eps/2 in each
 * component, along n at most sqrt(3) eps/2 < eps. */
static inline surface motion_surface(surface s, vec3 by)
{
    if (vzero(by)) return s;
    real before = surface_reach(s.p);
    s.p = vadd(s.p, by);
    s.error += real_epsilon * (before + surface_reach(s.p));
    return s;
}

/* The ray, moved back by s, through what moves. */
static inline bool motion_trace(const tracer *t, const moving *m, vec3 s, ray_kind kind, ray r,
                                void *payload)
{
    tracer there = {.w = &m->w, .program = t->program, .user = t->user};
    r.o = vsub(r.o, s);
    return trace(&there, kind, r, payload);
}

/* *reach: where the program of `kind` leaves the hit's t. At equal t the last one wins. */
static inline bool motion_closest(tracer *t, const moving *m, int n, real time, ray_kind kind,
                                  ray r, void *payload, const real *reach, vec3 *by)
{
    bool met = trace(t, kind, r, payload), rests = met;
    *by = (vec3){0, 0, 0};
    for (int i = 0; i < n; i++) {
        vec3 s = vscale(m[i].v, time);
        if (met) r.tmax = *reach;
        if (motion_trace(t, &m[i], s, kind, r, payload)) met = true, *by = s;
    }
    t->counts.hits[kind] += met && !rests;
    return met;
}

static inline bool motion_any(tracer *t, const moving *m, int n, real time, ray_kind kind, ray r)
{
    shade_lit unread = {false};
    bool met = trace(t, kind, r, &unread), rests = met;
    for (int i = 0; i < n && !met; i++)
        met = motion_trace(t, &m[i], vscale(m[i].v, time), kind, r, &unread);
    t->counts.hits[kind] += met && !rests;
    return met;
}

#endif
