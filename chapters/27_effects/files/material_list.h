/* material_list.h: materials that a scene file can use without describing them.
 *
 *   use chrome                       or at the end of a shape's line: sphere 0 1 0 1 chrome
 *
 *   matte     white grey black red green blue yellow         Kd
 *   metal     chrome gold copper mirror; brushed, which is glossy
 *   clear     glass water diamond; bottle, which is green inside; frosted, which is rough
 *   light     lamp                                           Ke 3
 *
 *   const char *keys = material_listed("gold")     lines as in MTL; NULL: not in the list
 *
 * A material of that name from the scene file or from a library comes first. Metals reflect at
 * normal incidence as measured, rounded to two digits (N. Hoffman, "Physics and Math of Shading",
 * SIGGRAPH 2012 courses); indices of refraction are those of the sodium line.
 */
#ifndef EFFECTS_MATERIAL_LIST_H
#define EFFECTS_MATERIAL_LIST_H

#include <stddef.h>
#include <string.h>

/* ---------------------------------------------------------------------------------------------- */

static const struct { const char *name, *keys; } material_list[] = {
    {"white", "Kd 0.73"}, {"grey", "Kd 0.4"}, {"black", "Kd 0"}, {"red", "Kd 0.65 0.05 0.05"},
    {"green", "Kd 0.12 0.45 0.15"}, {"blue", "Kd 0.1 0.2 0.6"}, {"yellow", "Kd 0.7 0.55 0.1"},
    {"chrome", "Kd 0\nKs 0.55 0.56 0.55\nillum 3"}, {"gold", "Kd 0\nKs 1 0.77 0.34\nillum 3"},
    {"copper", "Kd 0\nKs 0.95 0.64 0.54\nillum 3"}, {"mirror", "Kd 0\nKs 0.95\nillum 3"},
    {"brushed", "Kd 0\nKs 0.91 0.92 0.92\nNs 60\nillum 3"},
    {"glass", "Kd 0\nTf 1\nNi 1.5\nillum 7"}, {"water", "Kd 0\nTf 1\nNi 1.33\nillum 7"},
    {"diamond", "Kd 0\nTf 1\nNi 2.42\nillum 7"},
    {"bottle", "Kd 0\nTf 1\nNi 1.5\nabsorb 1.2 0.2 0.9\nillum 7"},
    {"frosted", "Kd 0\nTf 1\nNi 1.5\nroughness 0.4\nillum 7"}, {"lamp", "Ke 3"},
    {"panel", "Ke 1"}};

static inline const char *material_listed(const char *name)
{
    for (size_t i = 0; i < sizeof material_list / sizeof *material_list; i++)
        if (strcmp(material_list[i].name, name) == 0) return material_list[i].keys;
    return NULL;
}

#endif
