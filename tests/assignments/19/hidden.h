/* Checks of assignment 19 that the student does not have: hard cases. Included after public.h. */
#ifndef HIDDEN_19_H
#define HIDDEN_19_H

/* Straight on; nearly grazing; equal media; near the critical angle. */
static question ask_directions_odd(random_stream *g, int i)
{
    question q = ask_directions(g, i);
    vec3 side = vunit(vsub(q.d, vscale(q.n, vdot(q.d, q.n))));
    real sine = 0;
    switch (i % 4) {
    case 0: sine = 0; break;
    case 1: sine = 1 - exam_between(g, 1e-7, 1e-4); break;
    case 2: q.n2 = q.n1, sine = exam_between(g, 0.1, 0.9); break;
    case 3:
        q.n2 = q.n1 / exam_between(g, 1.2, 2);
        sine = q.n2 / q.n1 * (1 + exam_between(g, -1e-3, 1e-3));
        break;
    }
    q.d = vsub(vscale(side, sine), vscale(q.n, sqrt(1 - sine * sine)));
    return q;
}

/* Straight on, grazing, and where one polarisation is not reflected (Brewster: tan i = n2 / n1). */
static question ask_fresnel_odd(random_stream *g, int i)
{
    question q = ask_fresnel(g, i);
    real ratio = q.n2 / q.n1;
    if (i % 3 == 0) q.ci = 1;
    if (i % 3 == 1) q.ci = 1 / sqrt(1 + ratio * ratio);
    if (i % 3 == 2) q.n1 = 1, q.n2 = exam_between(g, 1.1, 2.4), q.ci = exam_between(g, 0.001, 0.01);
    ratio = q.n1 / q.n2;
    q.ct = sqrt(1 - ratio * ratio * (1 - q.ci * q.ci));
    return q;
}

/* Coloured glass, black glass, straight on, grazing. */
static question ask_pane_dark(random_stream *g, int i)
{
    question q = ask_pane(g, i);
    q.T = i % 4 == 3 ? 0 : exam_between(g, 0.05, 0.95);
    if (i % 5 == 0) q.ci = 1;
    if (i % 5 == 1) q.ci = exam_between(g, 0.001, 0.01);
    return q;
}

/* An air bubble in glass, where some rays do not get in; through the middle; d of any length and an
 * interval that ends before the ball. */
static question ask_bubble(random_stream *g, int i)
{
    question q = ask_ball(g, i);
    if (i % 2) q.n1 = q.n2, q.n2 = 1;
    if (i % 5 == 0) q.r.o = vmadd(q.ball.c, q.r.d, -4 / vlength(q.r.d) * q.ball.r);
    if (i % 5 == 1) q.r.tmax = (vlength(vsub(q.ball.c, q.r.o)) - q.ball.r) / vlength(q.r.d) / 2;
    return q;
}

/* Many rays: small weights; a coloured mirror, so that the largest component decides. */
static question ask_scene_small(random_stream *g, int i)
{
    question q = ask_scene(g, i);
    q.least = i % 2 ? exam_between(g, 0.002, 0.02) : exam_between(g, 0.3, 0.95);
    for (int k = 0; k < q.s.things; k++)
        if (!vzero(q.s.thing[k].m.mirror))
            q.s.thing[k].m.mirror = vec(exam_between(g, 0.1, 0.9), exam_between(g, 0.1, 0.9), 0.05);
    if (i % 3 == 0) q.s.thing[0].m.mirror = vec(0.5, 0.1, exam_between(g, 0.1, 0.8));
    return q;
}

static const exam_check hidden_checks[] = {
    {1, "straight, grazing, critical", 7, true, 400, ask_directions_odd, mark_refract},
    {2, "straight, Brewster, grazing", 7, true, 300, ask_fresnel_odd, mark_fresnel},
    {3, "coloured, black, grazing", 12, true, 400, ask_pane_dark, mark_pane},
    {4, "bubbles, the middle, intervals", 8, true, 400, ask_bubble, mark_through},
    {5, "coloured mirrors, small weights", 12, true, 600, ask_scene_small, mark_weight},
};
#endif
