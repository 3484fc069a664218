/* nff.h: reads scenes in NFF, the Neutral File Format of the Standard Procedural Databases.
 *
 *   v  from x y z  at x y z  up x y z  angle a  hither h  resolution w h       the view
 *   b  r g b                               background
 *   l  x y z [r g b]                       light; of L lights without colour each has sqrt(L) / 2L
 *   f  r g b Kd Ks Shine T ior             what comes next is made of this
 *   s  x y z r                             sphere; r < 0: seen from inside
 *   c  x y z r  x y z r                    cone or cylinder, open: base, then apex
 *   p  n  x y z ..                         polygon, n corners, concave ones too
 *   pp n  x y z nx ny nz ..                patch: the same with a normal at each corner
 *
 * Between the tokens there is white space, ends of lines too, as much as one likes; # begins a
 * comment. angle: full, in degrees (0, 180); hither and resolution may be missing. Triangles and
 * patches go into one mesh, placed as it stands, all else into the shapes.
 *
 *   if (!nff_read(&s, "balls.nff", affine, material, &f)) ...
 *
 *   affine     stands before everything of the file: all is moved, turned, scaled by it. Spheres
 *              and cones stay what they are only if it scales evenly: else an error
 *   material   for what comes before the first f
 *
 *   f becomes a studio_material: kd = Kd rgb, ks = Ks rgb, ns = Shine, tf = T T T, ni = ior.
 *   Equal f lines become one material. A file with a view sets s.view, if no file did before.
 *
 * Broken: "FILE:LINE: s: not a number: 'x', allowed: ..", exit code 2; cannot be read: 1. Memory:
 * up to some 30 times the size of the file. Patches: corner 0 sees all edges, or at most 256
 * corners.
 *
 * Source: E. Haines, Standard Procedural Databases, 1987 to 2004: NFF.TXT.
 */
#ifndef EFFECTS_NFF_H
#define EFFECTS_NFF_H

#include "nff_faces.h"

/* ---------------------------------------------------------------------------------------------- */

/* ---- view, lights, materials ---- */

static inline bool nff_view(nff_reader *r)
{
    static const char *const words[] = {"from", "at", "up", "angle", "hither", "resolution"};
    studio_view view = {.given = true, .said = nff_cite(r)};
    unsigned seen = 0;
    real w = 0, h = 0;
    while (word_more(&r->t)) {
        int k = 0;
        bool ok = true;
        while (k < 6 && !text_is(&r->t, words[k])) k++;
        if (k == 6) break;
        r->t.p += strlen(r->t.keyword = words[k]);
        seen |= 1u << k;
        switch (k) {
        case 0: ok = nff_place(r, &view.from); break;
        case 1: ok = nff_place(r, &view.at); break;
        case 2: ok = nff_point(r, &view.up); view.up = affine_vector(r->to_world, view.up); break;
        case 3: ok = nff_number(r, &view.angle, 1e-6, 179.999); break;
        case 4: ok = nff_number(r, &view.hither, 0, word_largest); view.hither *= r->size; break;
        case 5: ok = nff_number(r, &w, 1, 65536) && nff_number(r, &h, 1, 65536); break;
        }
        if (!ok) return false;
    }
    r->t.keyword = "v";
    if ((seen & 15) != 15)
        return text_bad(&r->t, r->t.p, "from, at, up or angle is missing before", "all four");
    view.width = (int)w, view.height = (int)h;
    if (!r->s->view.given || r->viewed) r->s->view = view, r->viewed = true;
    return true;
}

static inline bool nff_light(nff_reader *r)
{
    light l = {LIGHT_POINT, {0, 0, 0}, {0, 0, 0}};
    cite at = nff_cite(r);
    if (!nff_place(r, &l.at)) return false;
    bool own = word_more(&r->t) && word_is_number(&r->t);
    if (own && !nff_colour(r, &l.colour)) return false;
    if (!own) l.colour = (vec3){-1, -1, -1}, r->plain_lights++;  /* known when all are counted */
    studio_add_light(r->s, l, true, at);
    return true;
}

static inline bool nff_fill(nff_reader *r)
{
    vec3 c;
    real kd, ks, shine, t, ior;
    cite at = nff_cite(r);
    char numbers[400], name[32];
    if (!nff_colour(r, &c) || !nff_number(r, &kd, 0, 1e9) || !nff_number(r, &ks, 0, 1e9)
        || !nff_number(r, &shine, 0, 1e9) || !nff_number(r, &t, 0, 1)
        || !nff_number(r, &ior, 0, 10)) return false;
    snprintf(numbers, sizeof numbers, "%a %a %a %a %a %a %a %a", (double)c.x, (double)c.y,
             (double)c.z, (double)kd, (double)ks, (double)shine, (double)t, (double)ior);
    uint32_t known = name_find(&r->fills, numbers);
    if (known != name_none) return r->material = r->fill[known], true;
    name_add(&r->fills, numbers);
    snprintf(name, sizeof name, "f%zu", r->fills.n);
    r->material = studio_add_material(r->s, name, at);
    r->fill = grown(r->fill, r->fills.n - 1, &r->fill_room, sizeof *r->fill);
    r->fill[r->fills.n - 1] = r->material;
    studio_material *m = &r->s->material[r->material];
    m->kd = vscale(c, kd), m->ks = vscale(c, ks), m->tf = (vec3){t, t, t};
    m->ns = shine, m->ni = ior > 0 ? ior : 1, m->classic = true;
    for (int k = 0; k < material_keys; k++) m->said[k] = at;
    m->said[KEY_KE] = m->said[KEY_ABSORB] = m->said[KEY_D] = (cite){0, 0};
    return true;
}

/* ---- the file ---- */

static inline bool nff_sphere(nff_reader *r)
{
    sphere b;
    if (!nff_place(r, &b.c) || !nff_radius(r, &b.r)) return false;
    studio_add_shape(r->s, shape_of_sphere(b), r->material);
    return true;
}

static inline bool nff_cone(nff_reader *r)
{
    cone c;
    if (!nff_place(r, &c.a) || !nff_radius(r, &c.ra) || !nff_place(r, &c.b)
        || !nff_radius(r, &c.rb)) return false;
    studio_add_shape(r->s, shape_of_cone(c), r->material);
    return true;
}

static inline bool nff_background(nff_reader *r)
{
    r->s->background_said = nff_cite(r);
    return nff_colour(r, &r->s->sky.background);
}

static inline bool nff_statement(nff_reader *r)
{
    static const char *const words[] = {"v", "b", "l", "f", "s", "c", "p", "pp"};
    static bool (*const read[])(nff_reader *) = {nff_view, nff_background, nff_light, nff_fill,
                                                 nff_sphere, nff_cone, nff_polygon, nff_patch};
    int k = 0;
    while (k < 8 && !text_is(&r->t, words[k])) k++;
    if (k == 8) return text_bad(&r->t, r->t.p, "begins with", "v, b, l, f, s, c, p, pp or #");
    r->t.p += strlen(r->t.keyword = words[k]);
    return read[k](r);
}

static inline bool nff_read_stream(studio *s, FILE *in, const char *path, affine to_world,
                                   uint32_t made_of, failure *f)
{
    vec3 x = to_world.x, y = to_world.y, z = to_world.z;
    real a = vlength(x), b = vlength(y), c = vlength(z), off = 64 * real_epsilon;
    bool even = fabs(a - b) <= off * a && fabs(a - c) <= off * a && fabs(vdot(x, y)) <= off * a * a
        && fabs(vdot(x, z)) <= off * a * a && fabs(vdot(y, z)) <= off * a * a;
    nff_reader r = {.s = s, .file = name_add(&s->files, path), .material = made_of,
                    .to_world = to_world, .size = even ? a : 0};
    size_t before = s->lights;
    if (!text_begin(&r.t, in, path, f)) return false;
    bool ok = true;
    while (ok && (r.t.keyword = "line", word_more(&r.t))) ok = nff_statement(&r);
    ok = text_end(&r.t) && ok;
    real each = sqrt((real)r.plain_lights) / (2 * (real)r.plain_lights);
    for (; before < s->lights; before++)
        if (s->light[before].light.colour.x < 0)
            s->light[before].light.colour = (vec3){each, each, each};
    r.m.normals = r.smooth ? r.m.vertices : 0;
    if (!r.smooth) free(r.m.n), r.m.n = NULL;
    if (ok && r.m.triangles) {
        r.m.names = allocate(1, 1);
        uint32_t m = studio_add_mesh(s, r.m, r.run_material, r.file, r.smooth);
        studio_place(s, m, affine_scaling((vec3){1, 1, 1}), made_of, (cite){r.file, 0});
    } else mesh_free(&r.m), free(r.run_material);
    name_table_free(&r.fills);
    free(r.fill), free(r.v), free(r.n);
    return ok;
}

static inline bool nff_read(studio *s, const char *path, affine to_world, uint32_t made_of,
                            failure *f)
{
    if (s->files_read >= studio_most_files)
        return failed(f, 2, "%.300s: too many files, allowed: %d in all", path, studio_most_files);
    FILE *in = word_open(path, false, f);
    if (!in) return false;
    s->files_read++;
    bool ok = nff_read_stream(s, in, path, to_world, made_of, f);
    fclose(in);
    return ok;
}

#endif
